"""Sticking: one contact at rest tried as sticking, the friction that it takes against μₛ N, and the point of slipping."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol, call, negate
from rotsolve.core.derivation import Equality, Move, Section, Words
from rotsolve.core.equation import NEWTON, Equation
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.inquiry.answers import Answered, NoAnswer
from rotsolve.inquiry.compose import Composer
from rotsolve.inquiry.history import History
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.inquiry.questions import Asked
from rotsolve.language.problem import Find
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rubs import BACK, FORWARD, STICKS


class Trial(Struct, frozen=True):
    """A contact tried as sticking: the inquiry with friction and normal force worked out."""

    contact: Touch
    inquiry: Inquiry
    friction: Answered
    normal: Answered


def tried(
    configuration: Configuration, contact: Touch, state: str, modes: dict[str, str]
) -> tuple[str, Trial | None] | None:
    """Stick or slip of one contact at rest; None where the numbers do not tell."""
    history = History(configuration, modes)
    inquiry = Inquiry(history, (NEWTON,))
    facts = history.facts(state)
    name = history.instant(state).host(contact.pair()[0].owner)
    body = facts.body(name)
    forces = {force.role: force for force in body.forces if force.owner == contact.name} if body else {}
    if "friction" not in forces:
        return None
    try:
        friction = inquiry.answer(question(forces["friction"].size, f"f_{contact.name}"))
        normal = inquiry.answer(question(forces["normal"].size, f"N_{contact.name}"))
    except NoAnswer:
        return None
    needed, limit = friction.found.formula, allowed(contact, normal)
    if needed is None or limit is None:
        return None
    side = inquiry.numbers.side(needed)
    beyond = inquiry.numbers.side(call("abs", needed) - limit)
    if side is None or beyond is None:
        return None
    if beyond <= 0:
        return STICKS, None
    return (FORWARD if side > 0 else BACK), Trial(contact, inquiry, friction, normal)


def allowed(contact: Touch, normal: Answered) -> Formula | None:
    """The greatest friction that the contact can give, μₛ N."""
    static = contact.grip().static
    if static is None or normal.found.formula is None:
        return None
    return static * normal.found.formula


def limiting(history: History, contact: str, state: str) -> list[tuple[Equation, Formula]]:
    """|f| = μₛ N of a contact on the point of slipping, for either direction, each with the normal force that must not be negative."""
    found = []
    facts = history.facts(state)
    item = next((item for item in history.configuration.connections(state) if item.name == contact), None)
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


def shown(trial: Trial, first: int) -> tuple[Section, int]:
    """The section that shows why a contact can not stick, and the number of the next equation."""
    composer = Composer(trial.inquiry, first)
    body = spoken(trial.contact.pair()[0].owner)
    derivation = composer.derivation(())
    laws = tuple(law for section in derivation.sections for law in section.laws)
    moves = tuple(move for section in derivation.sections for move in section.moves)
    static = trial.contact.grip().static
    needed, normal = trial.friction.found.formula, trial.normal.found.formula
    assert static is not None and needed is not None and normal is not None
    limit = trial.inquiry.solver.simplify(static * normal)
    sizes = [
        certified.text(4).lstrip("−")
        for value in (needed, limit)
        if (certified := composer.results.value(value)) is not None
    ]
    letter = Symbol(composer.letters.names[trial.friction.asked.letter])
    words: Words = (f"{' N > '.join(sizes)} N: more than the contact can give, so {body} slips",)
    move = Move(
        "",
        (Equality(call("abs", letter), static * Symbol(composer.letters.names[trial.normal.asked.letter]), ">"),),
        None,
        words,
    )
    return Section(f"Does {body} slip? Suppose it does not", (), (), laws, (*moves, move)), first + len(
        composer.numbers
    )
