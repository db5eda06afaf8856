"""Friction: whether each contact sticks or slips, and which way, phase by phase.

A contact that moves at the start slips. Of one at rest stick is tried first: the friction that it takes is worked out and held
against μₛ N; if that is too much, the contact slips the way the friction was to hold.
"""

from __future__ import annotations

from dataclasses import dataclass

from rotsolve.algebra.formula import ONE, Formula, Symbol, call, negate
from rotsolve.core.derivation import Equality, Move, Section, Words
from rotsolve.core.equation import NEWTON, Equation
from rotsolve.core.registry import SEPARATOR
from rotsolve.elements.connections.contacts import Touch
from rotsolve.elements.connections.supports import Driven
from rotsolve.inquiry.answering import Answered, NoAnswer, Session, families_for
from rotsolve.inquiry.compose import Composer, spoken
from rotsolve.inquiry.finds import Asked
from rotsolve.inquiry.history import History
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.instant import Instant
from rotsolve.principles.energy import one_motion
from rotsolve.scene.model import Find

Contacts = dict[str, tuple[Touch, str]]
RATES = ("velocity|", "angular_velocity|")
ROUNDS = 6
FORWARD, BACK = "slips", "slips back"
TURNS_BACK, HOLDS = "turns back", "holds"


@dataclass(frozen=True)
class Decision:
    """How the contacts behave, with the sections that show why."""

    modes: dict[str, str]
    sections: tuple[Section, ...]
    numbered: int = 0  # equations numbered so far


@dataclass(frozen=True)
class Trial:
    """A contact tried as sticking in one phase: the session with friction and normal force worked out."""

    key: str
    contact: Touch
    session: Session
    friction: Answered
    normal: Answered


def decide(arrangement: Arrangement) -> Decision:
    """The modes of all contacts with a coefficient of friction."""
    modes: dict[str, str] = {}
    sections: list[Section] = []
    number = 1
    pending = open_contacts(arrangement)
    for key, (contact, state) in pending.items():
        moving = slip_at_start(arrangement, contact, state, modes)
        if moving:
            modes[key] = FORWARD if moving > 0 else BACK
    for key, (wheel, state) in rubbing_wheels(arrangement).items():
        mode = turning(arrangement, wheel, state, modes, key)
        if mode:
            modes[key] = mode
    for _ in range(ROUNDS):
        changed = False
        for key, (contact, state) in pending.items():
            if key in modes:
                continue
            verdict = tried(arrangement, contact, state, modes, key)
            if verdict is not None:
                modes[key], trial = verdict
                changed = True
                if trial is not None:
                    section, number = shown(trial, number)
                    sections.append(section)
        if not changed:
            break
    unsettled = {key: entry for key, entry in pending.items() if key not in modes}
    for group in together(arrangement, unsettled):
        modes.update(by_motion(arrangement, group, modes))
    return Decision({key: mode for key, mode in modes.items() if mode != "sticks"}, tuple(sections), number - 1)


def together(arrangement: Arrangement, contacts: Contacts) -> list[Contacts]:
    """Contacts of bodies that move together in the same phase, group by group."""
    groups: dict[tuple[str, frozenset[str]], Contacts] = {}
    for key, (contact, state) in contacts.items():
        component = arrangement.component(contact.pair()[0].owner, state)
        groups.setdefault((state, component), {})[key] = (contact, state)
    return list(groups.values())


def open_contacts(arrangement: Arrangement) -> dict[str, tuple[Touch, str]]:
    """Contacts with a coefficient of friction, by contact and the state at which their phase starts."""
    found = {}
    for state in arrangement.timeline.states:
        start = arrangement.phase_start(state.name)
        for item in arrangement.connections(start):
            if isinstance(item, Touch) and item.grip().kind == "coefficient":
                found[mode_key(item.name, start)] = (item, start)
    return found


def rubbing_wheels(arrangement: Arrangement) -> dict[str, tuple[str, str]]:
    """Wheels on axles and hinges with a friction torque: mode key -> (wheel, state at which its phase starts)."""
    found = {}
    for state in arrangement.timeline.states:
        if arrangement.timeline.phase_of(state.name) is None and len(arrangement.timeline.states) > 1:
            continue  # in an event alone a finite torque does nothing
        start = arrangement.phase_start(state.name)
        for item in arrangement.connections(start):
            if isinstance(item, Driven) and item.friction_torque is not None:
                for ref in item.held():
                    name = arrangement.host(ref.owner, start)
                    found[mode_key(f"{item.name}.{name}", start)] = (name, start)
    return found


def turning(arrangement: Arrangement, name: str, state: str, modes: dict[str, str], key: str) -> str:
    """Which way a wheel on a rubbing axle turns: as it does at the start, else as it is driven; "holds" where friction is too strong."""
    session = Session(History(arrangement, modes), families_for(None))
    moving = session.settled(session.history.instant(state).rate("angular_velocity", name))
    start = session.number(moving) if moving is not None else None
    if start:
        return "" if start > 0 else TURNS_BACK
    for mode, sign in (("", 1), (TURNS_BACK, -1)):
        trial = Session(History(arrangement, {**modes, key: mode}), (NEWTON,))
        value = trial.settled(trial.history.instant(state).rate("angular_acceleration", name))
        number = trial.number(value) if value is not None else None
        if number is None:
            return ""
        if number * sign > 0:
            return mode
    return HOLDS


def mode_key(contact: str, state: str) -> str:
    return f"{contact}@{state}"


def slip_at_start(arrangement: Arrangement, contact: Touch, state: str, modes: dict[str, str]) -> int:
    """The sign of the velocity with which the touching point slides at the start of a phase; 0 where it is not known to slide."""
    history = History(arrangement, modes)
    session = Session(history, (NEWTON,))
    speed = sliding_speed(history.instant(state), contact)
    if speed is None or any(SEPARATOR in name for name in speed.symbols()):
        return 0
    number = session.number(speed)
    return 0 if number is None or abs(number) < 1e-12 else 1 if number > 0 else -1


def sliding_speed(instant: Instant, contact: Touch) -> Formula | None:
    """Velocity of the touching point along the body's positive travel."""
    ref = contact.pair()[0]
    motion = instant.motion(ref.owner)
    if motion.heading is None:
        return None
    return contact.touching_velocity(instant).along(motion.heading)


def tried(
    arrangement: Arrangement, contact: Touch, state: str, modes: dict[str, str], key: str
) -> tuple[str, Trial | None] | None:
    """Stick or slip of one contact at rest; None where the numbers do not tell."""
    history = History(arrangement, modes)
    session = Session(history, (NEWTON,))
    facts = history.facts(state)
    name = history.instant(state).host(contact.pair()[0].owner)
    body = facts.body(name)
    forces = {force.role: force for force in body.forces if force.owner == contact.name} if body else {}
    if "friction" not in forces:
        return None
    try:
        friction = session.answer(question(forces["friction"].size, f"f_{contact.name}"))
        normal = session.answer(question(forces["normal"].size, f"N_{contact.name}"))
    except NoAnswer:
        return None
    needed = session.number(friction.found.formula) if friction.found.formula is not None else None
    limit = allowed(session, contact, normal)
    if needed is None or limit is None:
        return None
    trial = Trial(key, contact, session, friction, normal)
    if abs(needed) <= limit:
        return "sticks", None
    return (FORWARD if needed > 0 else BACK), trial


def allowed(session: Session, contact: Touch, normal: Answered) -> float | None:
    """The greatest friction that the contact can give, μₛ N."""
    static = contact.grip().static
    if static is None or normal.found.formula is None:
        return None
    return session.number(static * normal.found.formula)


def limiting(history: History, contact: str, state: str) -> list[tuple[Equation, Formula]]:
    """|f| = μₛ N of a contact on the point of slipping, for either direction, each with the normal force that must not be negative."""
    found = []
    facts = history.facts(state)
    item = next((item for item in history.arrangement.connections(state) if item.name == contact), None)
    if not isinstance(item, Touch) or item.grip().static is None:
        return []
    static = item.grip().static
    assert static is not None
    forces = {force.role: force.size for body in facts.bodies for force in body.forces if force.owner == contact}
    if "friction" not in forces or "normal" not in forces:
        return []
    most = static * forces["normal"]
    for side in (most, negate(most)):
        words = "on the point of slipping, f = μₛ N"
        found.append((Equation(forces["friction"], side, words, history.section(state), NEWTON, 2), forces["normal"]))
    return found


def question(size: Formula, name: str) -> Asked:
    """A force as a question, to be answered aside."""
    letter = next(iter(size.symbols())) if size.symbols() else name
    return Asked(Find(name, size, ()), size, letter, None)


def by_motion(arrangement: Arrangement, open_: Contacts, modes: dict[str, str]) -> dict[str, str]:
    """Contacts whose friction can not be told one by one: they slip the way in which the bodies then move, or all stick.

    All of them are tried slipping, one way round and the other, with the senses that the strings and joints allow; a way is right
    where it accelerates the bodies along itself.
    """
    for way in (1, -1):
        trial = {**modes, **slipping(arrangement, open_, modes, way)}
        speeds = [accelerating(arrangement, contact, state, trial, key) for key, (contact, state) in open_.items()]
        if speeds and all(speed is not None and speed > 0 for speed in speeds):
            return {key: trial[key] for key in open_}
    known = all(
        accelerating(arrangement, contact, state, {**modes, **slipping(arrangement, open_, modes, 1)}, key) is not None
        for key, (contact, state) in open_.items()
    )
    return dict.fromkeys(open_, "sticks") if known else {}


def slipping(arrangement: Arrangement, open_: Contacts, modes: dict[str, str], way: int) -> dict[str, str]:
    """The modes of contacts that slip together, the first of them forward or back, the others as the rules make them go with it."""
    result = dict.fromkeys(open_, FORWARD)
    state = next(iter(open_.values()))[1]
    history = History(arrangement, {**modes, **result})
    facts, session = history.facts(state, virtual=True), Session(history, (NEWTON,))
    letters = {key: travel_letter(history.instant(state, virtual=True), contact) for key, (contact, _) in open_.items()}
    rates = sorted(
        {name for rule in facts.rules for side in rule.velocity for name in side.symbols() if name.startswith(RATES)}
    )
    allowed = one_motion(sorted({*rates, *(name for name in letters.values() if name)}), list(facts.rules)) or {}
    senses = {}
    for key, name in letters.items():
        value = allowed.get(name or "", Symbol(name or ""))
        number = session.number(value.substitute({free: ONE for free in value.symbols() if free.startswith(RATES)}))
        senses[key] = 1 if number is None or number >= 0 else -1
    first = next(iter(senses.values()))
    return {key: FORWARD if sense * first * way > 0 else BACK for key, sense in senses.items()}


def travel_letter(instant: Instant, contact: Touch) -> str | None:
    """The letter of a body's velocity along its line."""
    motion = instant.motion(contact.pair()[0].owner)
    return next((name for size, _ in motion.velocity.parts for name in size.symbols()), None)


def accelerating(arrangement: Arrangement, contact: Touch, state: str, modes: dict[str, str], key: str) -> float | None:
    """Acceleration of a slipping body along the way in which it is taken to slip; None where the numbers do not tell."""
    history = History(arrangement, modes)
    motion = history.instant(state).motion(contact.pair()[0].owner)
    if motion.heading is None:
        return None
    session = Session(history, (NEWTON,))
    value = session.settled(motion.acceleration.along(motion.heading))
    number = session.number(value) if value is not None else None
    return None if number is None else number * (1 if modes[key] == FORWARD else -1)


def shown(trial: Trial, first: int) -> tuple[Section, int]:
    """The section that shows why a contact can not stick, and the number of the next equation."""
    composer = Composer(trial.session, first)
    body = spoken(trial.contact.pair()[0].owner)
    derivation = composer.derivation(())
    laws = tuple(law for section in derivation.sections for law in section.laws)
    moves = tuple(move for section in derivation.sections for move in section.moves)
    static = trial.contact.grip().static
    needed, normal = trial.friction.found.formula, trial.normal.found.formula
    assert static is not None and needed is not None and normal is not None
    limit = trial.session.solver.simplify(static * normal)
    sizes = [
        certified.text(4).lstrip("−") for value in (needed, limit) if (certified := composer.value(value)) is not None
    ]
    letter = Symbol(composer.names[trial.friction.asked.letter])
    words: Words = (f"{' N > '.join(sizes)} N: more than the contact can give, so {body} slips",)
    move = Move(
        "",
        (Equality(call("abs", letter), static * Symbol(composer.names[trial.normal.asked.letter]), ">"),),
        None,
        words,
    )
    return Section(f"Does {body} slip? Suppose it does not", (), (), laws, (*moves, move)), first + len(
        composer.numbers
    )
