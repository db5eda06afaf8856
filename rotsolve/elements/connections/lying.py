"""Lying: what a body that lies on something may be said to do there: to move along it, and to rub only where it presses."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from rotsolve.core.faults import Unsolvable
from rotsolve.elements.shapes import rim_radius

if TYPE_CHECKING:
    from rotsolve.language.bodies import Body, PointRef, Surface
    from rotsolve.language.elements import Connection, Surroundings


def check_laid_on(item: Connection, scene: Surroundings) -> None:
    """What it lies on can bear it there, and bears it in the picture."""
    check_from_above(item, scene)
    check_off_post(item, scene)


def check_from_above(item: Connection, scene: Surroundings) -> None:
    """Seen from above nothing presses on a level surface, which lies below the whole picture: friction on it is none of its edge."""
    under = item.touches()[1]
    surface = scene.surfaces.get(under.owner)
    if scene.problem.plane == "horizontal" and surface is not None and surface.level and item.grips():
        message = f"friction on `{under.owner}`, which lies below a scene that is seen from above, is not solved"
        help = (
            "leave out `plane: horizontal` where it slides along a line; a torque of friction may be told as a `couple`"
        )
        raise Unsolvable(message, span=under.span, help=help)


def check_led_along(item: Connection, rests: Callable[[Body], bool], scene: Surroundings) -> None:
    """What lies on a surface all the time, and on nothing else, moves along it."""
    ref, body = item.touches()[0], scene.bodies.get(item.lying())
    states = scene.throughout(item.name)
    if any(other.lying() == item.lying() and other is not item for other in scene.problem.connections):
        return
    if body is None or body.moves is None or not rests(body) or not states:
        return
    surface = item.surface(scene, states[0])
    if surface is None or body.moves in surface.ways():
        return
    words = " or ".join(surface.ways())
    message = f"`{body.name}` lies on `{surface.name}`, along which it can not move {body.moves}"
    help = f"it moves {words} there; what is lifted off lies on nothing: leave `{item.name}` out"
    raise Unsolvable(message, span=ref.span, help=help)


def check_off_post(item: Connection, scene: Surroundings) -> None:
    """On a post nothing lies."""
    posts = (ref for ref in item.places() if ref.owner in scene.surfaces and scene.surfaces[ref.owner].post)
    for post in posts:
        message = f"`{item.lying()}` on `{post.owner}`, a post: nothing tells how it lies on that"
        help = "a rope runs round a post; what lies on something round lies on a `dome`"
        raise Unsolvable(message, span=post.span, help=help)


def check_on_one_track(item: Connection, scene: Surroundings) -> None:
    """What is on a track of unknown profile lies on nothing else in the same phase: of two nothing tells which it is on."""
    timeline = [state.name for state in scene.problem.states] or [""]
    for state in timeline[:-1] or timeline:
        here = scene.connections(state)
        other = next((one for one in here if one is not item and one.lying() == item.lying()), None)
        if other is None or not any(one.name == item.name for one in here):
            continue
        mine, its = (one.touches()[1] for one in (item, other))
        at = f" from `{state}` on" if state else ""
        message = (
            f"`{item.lying()}` is on `{mine.owner}` and on `{its.owner}` at once{at}: nothing tells which it is on"
        )
        help = f"say it of each phase: `phases: {{down: {{from: …, to: …, without: {other.name}}}, …}}`"
        raise Unsolvable(message, span=mine.span, help=help)


def check_side_by_side(item: Connection, pressed: bool, round_ones: bool, scene: Surroundings) -> None:
    """Two that are held rub on each other as wheels do; `round_ones`: whether a contact of the kind may be that of two."""
    ref, under = item.touches()[:2]
    if not (pressed or any(rim_radius(scene.bodies[one.owner], None) for one in (ref, under))):
        message = f"`{ref.owner}`, which a hinge holds, on `{under.owner}` is not solved yet"
        raise Unsolvable(message, span=ref.span, help="solved is a rod that leans with its side on a corner")
    for wheel in item.touches():
        check_wheel(wheel, "a contact with a wheel on an axle is solved for two of them only", scene)
    if not round_ones:
        help = f"write `contact: [{ref.owner}, {under.owner}]`"
        raise Unsolvable("two wheels on fixed axles do not roll on each other", span=under.span, help=help)


def check_wheel(ref: PointRef, message: str, scene: Surroundings) -> None:
    """A round body on an axle or hinge of its own."""
    if ref.owner not in scene.held or rim_radius(scene.bodies[ref.owner], ref.point) is None:
        lacks = "turns on no axle" if ref.owner not in scene.held else "has no radius"
        raise Unsolvable(message, span=ref.span, help=f"`{ref.owner}` {lacks}")


def is_level(name: str, scene: Surroundings) -> bool:
    """Whether a name is that of a level surface, or of the ground."""
    return name == "ground" or (name in scene.surfaces and scene.surfaces[name].level)


def supporting(name: str, configuration: Surroundings, state: str) -> Surface | None:
    """The flat surface along which a body travels."""
    for item in configuration.connections(state):
        if item.lying() and item.track(configuration.bodies[name], configuration, state) is not None:
            return item.surface(configuration, state)
    return None
