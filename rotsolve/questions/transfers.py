"""Transfers: impulse and work in a phase or event."""

from __future__ import annotations

from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, add, negate, sqrt, total
from rotsolve.core.facts import BodyFacts, signed
from rotsolve.core.passage import Meeting, Passage
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.varying import running
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, Vector
from rotsolve.core.writing import is_negative
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Path
from rotsolve.laws.energy import potential
from rotsolve.laws.momentum import over_time
from rotsolve.motion.encounters import participants
from rotsolve.paths import NotYet


def impulse(path: Path, interval: str, state: str, scene: SceneEquations) -> Formula:
    """The impulse of a support or blow in an event, or of an action or connection over a phase."""
    encounter = scene.encounters.get(interval)
    if encounter is None and interval in scene.passages:
        return impulse_over(path, scene.passages[interval])
    if encounter is None:
        raise NotYet("an impulse is asked of an event or a phase")
    blows = [blow for meeting in encounter.meetings for blow in meeting.blows if blow.owner == path.owner]
    wanted = [blow for blow in blows if path.component is None or _axis(blow.size) == path.component]
    if path.quantity == "angular_impulse":
        return twist_of(path.owner, interval, scene)
    sizes = list({blow.size: None for blow in wanted})
    if not sizes:
        raise NotYet(f"`{path.owner}` gives no impulse in `{interval}`")
    if len(sizes) == 1:
        return sizes[0]
    squares: Formula = ZERO
    for size in sizes:
        squares = add(squares, size**2)
    return sqrt(squares)


def blow(path: Path, interval: str, scene: SceneEquations) -> Vector | None:
    """The blow of an event or support on its last-named body, where it has two components; else none is needed."""
    parts = blows_on_last(path, interval, scene)
    return Vector(tuple(parts)) if len(parts) > 1 else None


def ways_of_blow(path: Path, interval: str, scene: SceneEquations) -> tuple[str, str]:
    """Words for a blow on its last-named body that has one component: along it, and against it."""
    parts = blows_on_last(path, interval, scene)
    if path.quantity != "impulse" or len(parts) != 1:
        return "", ""
    size, heading = parts[0]
    negative = is_negative(size)
    for direction, words in ((RIGHT, ("right", "left")), (UP, ("up", "down"))):
        if (heading - direction).cos() in (ONE, negate(ONE)):
            return words if ((heading - direction).cos() == ONE) != negative else (words[1], words[0])
    return "", ""


def blows_on_last(path: Path, interval: str, scene: SceneEquations) -> list[tuple[Formula, Heading]]:
    """The components of the blow of an event or support on its last-named body."""
    encounter = scene.encounters.get(interval)
    if encounter is None or path.component is not None:
        return []
    chosen = meeting_of_last(path.owner, interval, scene)
    blows = chosen.blows if chosen is not None else ()
    return [part for item in blows if item.owner == path.owner for part in item.vector.parts]


def meeting_of_last(owner: str, interval: str, scene: SceneEquations) -> Meeting | None:
    """What a blow does to its last-named body."""
    last = last_named(owner, interval, scene)
    hit = [item for item in scene.encounters[interval].meetings if any(found.owner == owner for found in item.blows)]
    return next((item for item in hit if item.body.name == last), hit[-1] if hit else None)


def last_named(owner: str, interval: str, scene: SceneEquations) -> str:
    """The body that an event or connection names last."""
    found = scene.configuration.timeline.interval(interval)
    assert found is not None and found.event is not None
    instant = scene.instant(found.start)
    items = [item for item in scene.configuration.connections(found.start) if item.name == owner]
    refs = (
        participants(found, scene.configuration) if found.event.name == owner else items[0].touches() if items else ()
    )
    bodies = [ref.owner for ref in refs if ref.owner in scene.configuration.bodies]
    return instant.host(bodies[-1]) if bodies else ""


def impulse_over(path: Path, passage: Passage) -> Formula:
    """F t or τ t of what stays the same in a phase, ∫ F dt or ∫ τ dt of what varies in time."""
    result: Formula = ZERO
    for first, body in zip(passage.start.bodies, passage.midst.bodies, strict=True):
        for one, effort in zip(efforts(path, first), efforts(path, body), strict=True):
            if running(effort.symbols()):
                raise NotYet(
                    f"the {path.quantity.replace('_', ' ')} of `{path.owner}`, which varies with the motion, is not solved yet"
                )
            result = add(result, over_time(one, effort, passage))
    if result == ZERO:
        raise NotYet(f"`{path.owner}` gives no impulse in this phase")
    return result


def efforts(path: Path, body: BodyFacts) -> list[Formula]:
    """What an action or connection does to a body: its torques along the body's positive turn, or the sizes of its forces."""
    if path.quantity == "angular_impulse":
        return [signed(item.torque, body.motion.sense) for item in body.acting if item.owner == path.owner]
    return [force.size for force in body.forces if force.owner == path.owner]


def twist_of(owner: str, interval: str, scene: SceneEquations) -> Formula:
    """Angular impulse of a blow on its last-named body, about that body's axis or centre of mass, along its positive turn."""
    hit = meeting_of_last(owner, interval, scene)
    if hit is None:
        raise NotYet(f"`{owner}` gives no angular impulse there")
    torques = [item.torque for item in hit.blows if item.owner == owner]
    return total([signed(torque, hit.body.motion.sense) for torque in (*torques, *hit.twists)])


def _axis(size: Formula) -> str:
    return size.name.split(SEPARATOR)[2] if isinstance(size, Symbol) and SEPARATOR in size.name else ""


def work_of_weight(name: str, passage: Passage) -> Formula:
    """m g times the height lost."""
    heights = passage.heights.get(name)
    if heights is None:
        raise NotYet(f"how far `{name}` sinks is not told by the scene")
    result: Formula = ZERO
    for facts, height, sign in ((passage.start, heights[0], 1), (passage.end, heights[1], -1)):
        body = facts.body(name)
        for force in body.forces if body is not None else ():
            if force.role == "weight":
                level = force.size * (height + force.arm.along(UP))
                result = add(result, level if sign > 0 else negate(level))
    return result


def work(path: Path, interval: str, scene: SceneEquations) -> Formula:
    """Work of an action or connection in a phase, or of all forces on a body."""
    passage = scene.passages.get(interval)
    if passage is None:
        return ZERO
    works = [work for work in passage.works if path.owner in (work.owner, *work.bodies)]
    if path.component == "gravity":
        return work_of_weight(path.owner, passage)
    if not works:
        raise NotYet(f"the work of `{path.owner}` alone can not be told in `{interval}`")
    result: Formula = ZERO
    for item in works:
        result = add(result, item.amount)
    return result


def potential_change(owner: str, passage: Passage) -> Formula:
    """U₂ − U₁ of a body's weight, of a spring, or of everything."""
    groups = [group for group in passage.groups if not owner or owner in group] or list(passage.groups)
    if any(passage.heights.get(name) is None for group in groups for name in group if not owner or name == owner):
        raise NotYet("how high it is at both states is not told by the scene")
    result: Formula = ZERO
    if owner and owner in {body.name for body in passage.start.bodies}:
        return negate(work_of_weight(owner, passage))
    for group in groups:
        for end, sign in ((1, 1), (0, -1)):
            for term in potential(passage, group, end):
                result = add(result, term if sign > 0 else negate(term))
    return result
