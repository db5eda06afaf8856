"""Fits: whether a body can lie or roll on a curved surface: its shape, its size, and the friction that is worked out there."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.faults import Unsolvable
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.elements.events import Fixes, Grips, Joins
from rotsolve.elements.rims import rim_radius, shape_of
from rotsolve.elements.surfaces import Curved, Surface
from rotsolve.language.problem import Problem


def check_surfaces(problem: Problem) -> None:
    """A fault for the first contact with curved surfaces that is not worked out, or can not be."""
    surfaces = {surface.name: surface for surface in problem.surfaces}
    for item in problem.connections if surfaces else ():
        if isinstance(item, Touch):
            places = [surfaces[ref.owner] for ref in item.places() if ref.owner in surfaces]
            check_joined(item, places)
            for place in places:
                if isinstance(place, Curved):
                    check_curved(item, place, problem)


def check_holding(problem: Problem) -> None:
    """A fault for an event that grips what is no contact with a flat surface or corner, or fixes what is held already."""
    if not problem.events:
        return
    held = {ref.owner: item.name for item in problem.connections for ref in item.fixed_points()}
    for event in problem.events:
        if isinstance(event, Grips):
            check_grip(event, problem)
        elif isinstance(event, Fixes) and event.fixes is not None and event.fixes.owner in held:
            message = f"`{event.fixes.owner}` is held by `{held[event.fixes.owner]}` already"
            raise Unsolvable(message, span=event.fixes.span, help="fix a point of a body that moves freely")


def check_grip(event: Grips, problem: Problem) -> None:
    contacts = {item.name: item for item in problem.connections if isinstance(item, Touch)}
    item = contacts.get(event.grips or "")
    if item is None:
        help = f"contacts: {', '.join(sorted(contacts))}" if contacts else "the scene has no contact"
        raise Unsolvable(f"`{event.name}` can only grip a contact, and `{event.grips}` is none", help=help)
    bent = {surface.name for surface in problem.surfaces if isinstance(surface, Curved) and surface.height() is None}
    if bent & {ref.owner for ref in item.places()}:
        message = f"`{event.name}` on a curved surface is not solved yet"
        raise Unsolvable(message, span=item.pair()[1].span, help="solved are flat surfaces and corners")


def check_joined(item: Touch, places: list[Surface]) -> None:
    """Surfaces that join: a track of unknown profile that leads into a curved one."""
    unknown = [isinstance(place, Curved) and place.radius() is None for place in places]
    curved = all(isinstance(place, Curved) for place in places)
    if len(places) > 1 and not (curved and len(places) == 2 and unknown == [True, False]):
        message = f"these surfaces of `{item.name}` together are not solved yet"
        help = "solved is a track of `profile unknown` that leads into a `hollow` or `dome`"
        raise Unsolvable(message, span=item.pair()[1].span, help=help)


def check_curved(item: Touch, surface: Curved, problem: Problem) -> None:
    """Round bodies and particles, rolling or without friction, that fit the surface and that nothing else holds."""
    ref = item.pair()[0]
    body = next((body for body in problem.bodies if body.name == ref.owner), None)
    if body is None:
        return
    if item.grip().kind == "coefficient":
        help = "write `friction: none`, or `any` where it is rough enough"
        raise Unsolvable("a coefficient of friction on a curved surface is not solved yet", span=ref.span, help=help)
    if body.moved:
        help = "solved are forces and couples on it"
        raise Unsolvable(
            f"a given motion of `{body.name}` on `{surface.name}` is not solved yet", span=ref.span, help=help
        )
    rim = rim_radius(body, ref.point)
    edge = surface.height() is not None
    fits = rim is not None or (shape_of(body).word == "particle" and not edge)
    if not fits or body.parts or body.holes:
        help = "solved are uniform round bodies" + ("" if edge else ", and particles")
        raise Unsolvable(f"`{body.name}` on `{surface.name}` is not solved yet", span=ref.span, help=help)
    for other in held_besides(body.name, item, problem):
        message = f"`{other}` on a body that is on `{surface.name}` is not solved yet"
        raise Unsolvable(message, span=ref.span, help="solved are forces and couples on it")
    for room, words in too_large(surface, rim or ZERO, on_flat(body.name, problem)):
        if negative(room, problem):
            message = f"`{body.name}` {words} `{surface.name}`"
            raise Unsolvable(message, span=ref.span, help="check the radii and heights")


def held_besides(name: str, contact: Touch, problem: Problem) -> Iterator[str]:
    """Strings, springs and the like on a body on a curved surface, and bodies that join it there; not while it is on the floor."""
    gripped = any(isinstance(event, Grips) and event.grips == contact.name for event in problem.events)
    if on_flat(name, problem) and not gripped:
        return
    for item in problem.connections:
        if not isinstance(item, Touch) and any(ref.owner == name for ref in item.touches()):
            yield item.name
    for event in problem.events:
        if isinstance(event, Joins) and any(ref.owner == name for ref in event.joins):
            yield event.name


def on_flat(name: str, problem: Problem) -> bool:
    """Whether a body touches a floor, slope or wall too."""
    curved = {surface.name for surface in problem.surfaces if isinstance(surface, Curved)}
    touches = (item for item in problem.connections if isinstance(item, Touch) and item.pair()[0].owner == name)
    return any(ref.owner not in curved for item in touches for ref in item.places())


def too_large(surface: Curved, rim: Formula, flat: bool) -> Iterator[tuple[Formula, str]]:
    """Lengths that must be positive, and what is the matter where one is not; a corner is as high as it may be above no floor."""
    circle = surface.circle(rim)
    if circle is not None and not surface.outside:
        yield circle, "does not fit into"
    if flat and surface.height() is not None:
        yield rim - (surface.height() or ZERO), "is too small to climb"


def negative(room: Formula, problem: Problem) -> bool:
    """Whether a length is not positive with the numbers of the scene; letters without a number are left open."""
    values = {given.name: given.value for given in problem.givens if given.value is not None}
    try:
        return (evaluate(room, values, digits=6).sign or 0) <= 0
    except (Undefined, ValueError):
        return False
