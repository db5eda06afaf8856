"""Gripping: what a contact that sticks takes of friction, and the most that it can give."""

from __future__ import annotations

from collections.abc import Iterable

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.formula import Formula, negate
from rotsolve.core.equation import POINT_OF_SLIPPING, VERGE, Equation
from rotsolve.core.facts import Force, Requirement
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.elements import Connection, Event
from rotsolve.language.problem import Find
from rotsolve.motion.rubs import Rub
from rotsolve.questions.find import Asked
from rotsolve.search.answers import Answered, NoAnswer
from rotsolve.search.search import Search


def sticking(search: Search, rub: Rub, contact: Connection) -> tuple[Answered, Answered] | None:
    """The friction and the normal force of a contact that is taken to stick; None where Newton's laws do not tell them."""
    scene = search.scene
    body = scene.facts(rub.state).body(scene.instant(rub.state).host(contact.lying()))
    rubbing, pressing = contact_forces(contact.name, body.forces if body else ())
    if rubbing is None or pressing is None:
        return None
    try:
        friction = search.answer(question(rubbing.size, f"f_{contact.name}"))
        return friction, search.answer(question(pressing.size, f"N_{contact.name}"))
    except NoAnswer:
        return None


def greatest_friction(contact: Connection | Event, normal: Answered) -> Formula | None:
    """The greatest friction that the contact can give, μₛ N."""
    static = contact.static()
    return None if static is None or normal.found.formula is None else static * normal.found.formula


def smooth(rub: Rub, signs: SignOracle) -> bool:
    """Whether a contact's coefficient is 0, so that it gives no friction even at rest."""
    static = rub.contact.static() if rub.contact is not None else None
    return static is not None and signs.by_numbers(static) == 0


def limiting(scene: SceneEquations, contact: str, state: str) -> list[tuple[Equation, Formula]]:
    """|f| = μₛ N of a contact on the point of slipping, for either direction, each with the normal force that must not be negative."""
    item, bodies = scene.configuration.connection(contact, state), scene.facts(state).bodies
    verge = item.verge(scene.instant(state)) if item is not None else ()
    if verge:
        section = scene.section(state)
        return [(VERGE.equation(left, right, section), push) for left, right, push in verge]
    static = item.static() if item is not None else None
    rubbing, pressing = contact_forces(contact, [force for body in bodies for force in body.forces])
    if static is None or rubbing is None or pressing is None:
        return []
    most, section = static * pressing.size, scene.section(state)
    limits = [POINT_OF_SLIPPING.equation(rubbing.size, side, section) for side in (most, negate(most))]
    return [(limit, pressing.size) for limit in limits]


def contact_forces(contact: str, forces: Iterable[Force]) -> tuple[Force | None, Force | None]:
    """Friction and normal force of a contact, the last of each."""
    own = [force for force in forces if force.owner == contact]
    rubbing, pressing = [item for item in own if item.role.rubs], [item for item in own if item.role.presses]
    return rubbing[-1] if rubbing else None, pressing[-1] if pressing else None


def question(size: Formula, name: str) -> Asked:
    """A force as a question, to be answered aside."""
    letter = next(iter(size.symbols())) if size.symbols() else name
    return Asked(Find(name, size, ()), size, letter, None)


def own_needs(rub: Rub, scene: SceneEquations) -> list[Requirement]:
    """What friction of a contact that sticks has to suffice for."""
    needs = scene.facts(rub.state).requirements if rub.contact is not None else ()
    return [need for need in needs if need.owner == rub.owner and need.kind.grips]
