"""Friction: whether each contact sticks or slips, whether each rubbing wheel turns, and which way, phase by phase."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import product

from msgspec import Struct

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, call, negate
from rotsolve.core.equation import NEWTON, POINT_OF_SLIPPING, Equation
from rotsolve.core.facts import Force
from rotsolve.core.faults import Unsolvable
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.writing import flat, is_negative
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.elements import Connection
from rotsolve.language.problem import Find
from rotsolve.laws.groups import one_motion
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.instant import Instant
from rotsolve.motion.rubs import AT_MOST, BACK, FORWARD, STICKS, Rub, rubs
from rotsolve.questions.find import Asked
from rotsolve.search.answers import Answered, NoAnswer, unsolvable
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search


class Trial(Struct, frozen=True):
    """A contact tried as sticking: the search with friction and normal force worked out."""

    contact: Connection
    search: Search
    friction: Answered
    normal: Answered


def tried(
    configuration: Configuration, contact: Connection, state: str, modes: dict[str, str]
) -> tuple[str, Trial | None] | None:
    """Stick or slip of one contact at rest; None where the numbers do not tell."""
    scene = SceneEquations(configuration, modes)
    search = Search(scene, (NEWTON,))
    facts = scene.facts(state)
    name = scene.instant(state).host(contact.lying())
    body = facts.body(name)
    rubbing, pressing = contact_forces(contact.name, body.forces if body else ())
    if rubbing is None or pressing is None:
        return None
    try:
        friction = search.answer(question(rubbing.size, f"f_{contact.name}"))
        normal = search.answer(question(pressing.size, f"N_{contact.name}"))
    except NoAnswer:
        return None
    needed, limit = friction.found.formula, greatest_friction(contact, normal)
    if needed is None or limit is None:
        return None
    side = search.numbers.side(needed)
    beyond = search.numbers.side(call("abs", needed) - limit)
    if side is None or beyond is None:
        return None
    if beyond <= 0:
        return STICKS, None
    return (FORWARD if side > 0 else BACK), Trial(contact, search, friction, normal)


def greatest_friction(contact: Connection, normal: Answered) -> Formula | None:
    """The greatest friction that the contact can give, μₛ N."""
    static = contact.static()
    if static is None or normal.found.formula is None:
        return None
    return static * normal.found.formula


def limiting(scene: SceneEquations, contact: str, state: str) -> list[tuple[Equation, Formula]]:
    """|f| = μₛ N of a contact on the point of slipping, for either direction, each with the normal force that must not be negative."""
    found = []
    facts = scene.facts(state)
    item = next((item for item in scene.configuration.connections(state) if item.name == contact), None)
    static = item.static() if item is not None else None
    if static is None:
        return []
    rubbing, pressing = contact_forces(contact, [force for body in facts.bodies for force in body.forces])
    if rubbing is None or pressing is None:
        return []
    most = static * pressing.size
    for side in (most, negate(most)):
        limit = POINT_OF_SLIPPING.equation(rubbing.size, side, scene.section(state))
        found.append((limit, pressing.size))
    return found


def contact_forces(contact: str, forces: Iterable[Force]) -> tuple[Force | None, Force | None]:
    """Friction and normal force of a contact, the last of each."""
    own = [force for force in forces if force.owner == contact]
    rubbing, pressing = [item for item in own if item.role.rubs], [item for item in own if item.role.presses]
    return rubbing[-1] if rubbing else None, pressing[-1] if pressing else None


def question(size: Formula, name: str) -> Asked:
    """A force as a question, to be answered aside."""
    letter = next(iter(size.symbols())) if size.symbols() else name
    return Asked(Find(name, size, ()), size, letter, None)


RATES = ("velocity|", "angular_velocity|")
TRIALS = 27  # ways in which contacts may stick and slip that are tried


class Decision(Struct, frozen=True):
    """How all that rubs behaves, with the trials that show why contacts can not stick."""

    modes: dict[str, str]
    trials: tuple[Trial, ...] = ()


def decide(configuration: Configuration, at_rest: Collection[str] = ()) -> Decision:
    """The modes of all contacts with a coefficient of friction and of all wheels on rubbing axles.

    `at_rest` are the names of those that are known not to slip at the start, where their speeds are numbers that have been rounded.
    """
    modes: dict[str, str] = {}
    trials: list[Trial] = []
    rubbing = rubs(configuration)
    if not rubbing:
        return Decision({})
    for rub in rubbing:
        moving = 0 if rub.name in at_rest else sense_at_start(configuration, rub, modes)
        if moving:
            modes[rub.key] = rub.mode(moving)
    for group in moving_together(configuration, [rub for rub in rubbing if rub.key not in modes]):
        contact = group[0].contact
        verdict = (
            tried(configuration, contact, group[0].state, modes) if len(group) == 1 and contact is not None else None
        )
        if verdict is None:
            stacked = len(group) > 1 and any(rub.contact and rub.contact.carrier(configuration) for rub in group)
            modes.update((by_trial if stacked else by_motion)(configuration, group, modes))
            continue
        modes[group[0].key], trial = verdict
        if trial is not None:
            trials.append(trial)
    return Decision({key: mode for key, mode in modes.items() if mode not in ("", STICKS)}, tuple(trials))


def moving_together(configuration: Configuration, open_: list[Rub]) -> list[list[Rub]]:
    """What rubs on bodies that move together in the same phase, group by group."""
    groups: dict[tuple[str, frozenset[str]], list[Rub]] = {}
    for rub in open_:
        groups.setdefault((rub.state, configuration.component(rub.body, rub.state)), []).append(rub)
    return list(groups.values())


def sense_at_start(configuration: Configuration, rub: Rub, modes: dict[str, str]) -> int:
    """The sense in which it slides or turns at the start of its phase; 0 where it is not known to move."""
    scene = SceneEquations(configuration, modes)
    speed = rub.rate(scene.instant(rub.state))
    if speed is None:
        return 0
    if is_known(speed):
        return sense_of(speed, configuration)
    first = rub.state == configuration.timeline.states[0].name
    return 0 if rub.contact is not None and first else sense_left(configuration, rub, modes)


def sense_left(configuration: Configuration, rub: Rub, modes: dict[str, str]) -> int:
    """The sense in which an event or an earlier phase leaves it moving: taken to slip, so that no rule of sticking settles it."""
    for sense in (1, -1):
        scene = SceneEquations(configuration, {**modes, rub.key: rub.mode(sense)})
        search = Search(scene, families_for(None))
        speed = search.settled(rub.rate(scene.instant(rub.state)) or ZERO)
        if speed is not None and is_known(speed) and sense_of(speed, configuration) == sense:
            return sense
    return 0


def is_known(speed: Formula) -> bool:
    """Whether a speed holds givens alone."""
    return not any(SEPARATOR in name for name in speed.symbols())


def sense_of(speed: Formula, configuration: Configuration) -> int:
    """The sign of a speed; without numbers that of its terms, where they agree: letters stand for positive sizes."""
    number = configuration.signs.number(speed)
    if number is not None:
        return number.sign or 0
    signs = {-1 if is_negative(term) else 1 for term in flat([simplify(speed)])}
    return signs.pop() if len(signs) == 1 else 0


def by_motion(configuration: Configuration, group: list[Rub], modes: dict[str, str]) -> dict[str, str]:
    """The modes of a group that moves together: the way round in which it speeds up, or rest; nothing where numbers do not tell."""
    told = False
    for way in (1, -1):
        senses = senses_of(configuration, group, modes, way)
        moving = {rub.key: rub.mode(senses[rub.key]) for rub in group}
        trial = {key: mode + AT_MOST if mode in (FORWARD, BACK) else mode for key, mode in moving.items()}
        gains = [
            speeding_up(configuration, rub, {**modes, **trial}, senses[rub.key]) for rub in group if senses[rub.key]
        ]
        if all(number is not None and number > 0 for number in gains):
            return moving
        told = told or all(number is not None for number in gains)
    return {rub.key: rub.mode(0) for rub in group} if told else {}


def by_trial(configuration: Configuration, group: list[Rub], modes: dict[str, str]) -> dict[str, str]:
    """The modes of contacts of which one may slip while another sticks (a block on a block): as few slip as can be; nothing where
    numbers do not tell."""
    ways = sorted(product((0, 1, -1), repeat=len(group)), key=lambda way: sum(map(abs, way)))
    for way in ways[:TRIALS]:
        trial = {rub.key: rub.mode(sense) for rub, sense in zip(group, way, strict=True)}
        if all(holds(configuration, rub, {**modes, **trial}, sense) for rub, sense in zip(group, way, strict=True)):
            return trial
    return {}


def holds(configuration: Configuration, rub: Rub, modes: dict[str, str], sense: int) -> bool:
    """Whether what rubs does as it is taken to: sticks with no more friction than there can be, or speeds up the way in which it slips."""
    if sense or rub.contact is None:
        number = speeding_up(configuration, rub, modes, sense) if sense else None
        return number is not None and number > 0
    scene = SceneEquations(configuration, modes)
    search = Search(scene, (NEWTON,))
    needs = [item for item in scene.facts(rub.state).requirements if item.owner == rub.contact.name and item.kind.grips]
    room = [search.settled(item.left - item.right) for item in needs]
    numbers = [search.number(value) if value is not None else None for value in room]
    return all(number is not None and number >= 0 for number in numbers)


def senses_of(configuration: Configuration, group: list[Rub], modes: dict[str, str], way: int) -> dict[str, int]:
    """The senses in which all of a group move when the first goes one way, as the rules make the others go with it."""
    scene = SceneEquations(configuration, {**modes, **{rub.key: rub.mode(1) for rub in group}})
    facts = scene.facts(group[0].state, virtual=True)
    instant = scene.instant(group[0].state, virtual=True)
    speeds = {rub.key: moving_rate(rub, instant) for rub in group}
    sides = [side for rule in facts.rules for side in rule.velocity] + [
        speed for speed in speeds.values() if speed is not None
    ]
    rates = sorted({name for side in sides for name in side.symbols() if name.startswith(RATES)})
    allowed = one_motion(rates, list(facts.rules)) or {}
    senses = {}
    for rub in group:
        slip, speed = rub.rate(instant), speeds[rub.key]
        if slip is not None and simplify(slip.substitute(allowed)) == ZERO and not smooth(rub, configuration.signs):
            senses[rub.key] = 0  # the rules keep it at rest whichever way the rest moves: how much it grips stays open
            continue
        value = speed.substitute(allowed) if speed is not None else ONE
        rate = value.substitute({name: ONE for name in value.symbols() if name.startswith(RATES)})
        senses[rub.key] = -1 if configuration.signs.by_numbers(rate) == -1 else 1
    first = next((sense for sense in senses.values() if sense), 1)
    return {key: sense * first * way for key, sense in senses.items()}


def smooth(rub: Rub, signs: SignOracle) -> bool:
    """Whether a contact's coefficient is 0, so that it gives no friction even at rest."""
    static = rub.contact.static() if rub.contact is not None else None
    return static is not None and signs.by_numbers(static) == 0


def moving_rate(rub: Rub, instant: Instant) -> Formula | None:
    """Speed of the body along its line (a wheel's contact slides with it), of one body on another, or of the wheel's turn."""
    item = rub.contact or rub.pair
    return instant.rate("angular_velocity", rub.body) if item is None else item.drift(instant)


def speeding_up(configuration: Configuration, rub: Rub, modes: dict[str, str], sense: int) -> float | None:
    """Acceleration along the sense in which it is taken to move; None where the numbers do not tell."""
    scene = SceneEquations(configuration, modes)
    rate = rub.rate(scene.instant(rub.state), acceleration=True)
    search = Search(scene, (NEWTON,))
    value = search.settled(rate) if rate is not None else None
    number = search.number(value) if value is not None else None
    return None if number is None else number * sense


def said_otherwise(configuration: Configuration, modes: Mapping[str, str]) -> Iterator[Unsolvable]:
    """Contacts that a state says to stick where friction is too weak for it, or to slip where it is strong enough."""
    problem = configuration.problem
    numbered = {given.name for given in problem.givens if given.value is not None}
    for state in configuration.timeline.states:
        contacts = {item.name: item for item in configuration.connections(state.name)}
        for line in state.conditions if configuration.phase_start(state.name) == state.name else ():
            contact = contacts.get(line.path.owner) if line.path is not None else None
            if contact is None or not contact.rubs() or not is_numbered(contact.static(), numbered):
                continue
            slips = modes.get(f"{contact.name}@{state.name}", "sticks").startswith("slips")
            if line.word in ("sticks", "rolls") and slips:
                yield unsolvable(
                    problem, f"`{contact.name}` slips at `{state.name}`: friction is too weak to hold it", line.span
                )
            elif line.word == "slips" and not slips:
                yield unsolvable(
                    problem, f"`{contact.name}` does not slip at `{state.name}`: friction is strong enough", line.span
                )


def is_numbered(value: Formula | None, numbered: Collection[str]) -> bool:
    """Whether a value is there, with all its letters."""
    return value is not None and value.symbols() <= set(numbered)
