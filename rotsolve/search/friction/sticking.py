"""Sticking: one contact at rest tried as sticking, the friction that it takes against μₛ N, and the point of slipping."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.formula import Formula, call, negate
from rotsolve.core.equation import NEWTON, POINT_OF_SLIPPING, Equation
from rotsolve.elements.connections.touch import Touch
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rubs import BACK, FORWARD, STICKS
from rotsolve.questions.question import Asked
from rotsolve.search.answers import Answered, NoAnswer
from rotsolve.search.search import Search


class Trial(Struct, frozen=True):
    """A contact tried as sticking: the search with friction and normal force worked out."""

    contact: Touch
    search: Search
    friction: Answered
    normal: Answered


def tried(
    configuration: Configuration, contact: Touch, state: str, modes: dict[str, str]
) -> tuple[str, Trial | None] | None:
    """Stick or slip of one contact at rest; None where the numbers do not tell."""
    scene = SceneEquations(configuration, modes)
    search = Search(scene, (NEWTON,))
    facts = scene.facts(state)
    name = scene.instant(state).host(contact.pair()[0].owner)
    body = facts.body(name)
    forces = {force.role: force for force in body.forces if force.owner == contact.name} if body else {}
    if "friction" not in forces:
        return None
    try:
        friction = search.answer(question(forces["friction"].size, f"f_{contact.name}"))
        normal = search.answer(question(forces["normal"].size, f"N_{contact.name}"))
    except NoAnswer:
        return None
    needed, limit = friction.found.formula, allowed(contact, normal)
    if needed is None or limit is None:
        return None
    side = search.numbers.side(needed)
    beyond = search.numbers.side(call("abs", needed) - limit)
    if side is None or beyond is None:
        return None
    if beyond <= 0:
        return STICKS, None
    return (FORWARD if side > 0 else BACK), Trial(contact, search, friction, normal)


def allowed(contact: Touch, normal: Answered) -> Formula | None:
    """The greatest friction that the contact can give, μₛ N."""
    static = contact.grip().static
    if static is None or normal.found.formula is None:
        return None
    return static * normal.found.formula


def limiting(scene: SceneEquations, contact: str, state: str) -> list[tuple[Equation, Formula]]:
    """|f| = μₛ N of a contact on the point of slipping, for either direction, each with the normal force that must not be negative."""
    found = []
    facts = scene.facts(state)
    item = next((item for item in scene.configuration.connections(state) if item.name == contact), None)
    if not isinstance(item, Touch) or item.grip().static is None:
        return []
    static = item.grip().static
    assert static is not None
    forces = {force.role: force.size for body in facts.bodies for force in body.forces if force.owner == contact}
    if "friction" not in forces or "normal" not in forces:
        return []
    most = static * forces["normal"]
    for side in (most, negate(most)):
        limit = POINT_OF_SLIPPING.equation(forces["friction"], side, scene.section(state))
        found.append((limit, forces["normal"]))
    return found


def question(size: Formula, name: str) -> Asked:
    """A force as a question, to be answered aside."""
    letter = next(iter(size.symbols())) if size.symbols() else name
    return Asked(Find(name, size, ()), size, letter, None)
