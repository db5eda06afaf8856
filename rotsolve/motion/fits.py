"""Fits: whether a body can lie or roll on a curved surface: its shape, its size, and the friction that is worked out there."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.faults import Unsolvable
from rotsolve.elements.connections.contacts import Touch
from rotsolve.elements.events import Fixes, Grips, Joins
from rotsolve.elements.rims import rim_radius, shape_of
from rotsolve.elements.surfaces import Curved, Surface
from rotsolve.scene.model import Problem


def check_surfaces(problem: Problem) -> None:
    """A fault for the first contact with curved surfaces that is not worked out, or can not be."""
    surfaces = {surface.name: surface for surface in problem.surfaces}
    for item in problem.connections:
        if isinstance(item, Touch):
            places = [surfaces[ref.owner] for ref in item.places() if ref.owner in surfaces]
            check_joined(item, places)
            for place in places:
                if isinstance(place, Curved):
                    check_curved(item, place, problem)


def check_holding(problem: Problem) -> None:
    """A fault for an event that grips what is no contact, or fixes a point of a body that is held already."""
    contacts = {item.name for item in problem.connections if isinstance(item, Touch)}
    round_ones = [item for item in problem.surfaces if isinstance(item, Curved) and item.height() is None]
    held = {ref.owner: item.name for item in problem.connections for ref in item.fixed_points()}
    for event in problem.events:
        if isinstance(event, Grips) and event.grips not in contacts:
            help = f"contacts: {', '.join(sorted(contacts))}" if contacts else "the scene has no contact"
            raise Unsolvable(f"`{event.name}` can only grip a contact, and `{event.grips}` is none", help=help)
        item = next(
            (item for item in problem.connections if isinstance(event, Grips) and item.name == event.grips), None
        )
        if isinstance(item, Touch) and any(
            surface.name == ref.owner for ref in item.places() for surface in round_ones
        ):
            help = "solved are flat surfaces and corners"
            raise Unsolvable(
                f"`{event.name}` on a curved surface is not solved yet", span=item.pair()[1].span, help=help
            )
        if isinstance(event, Fixes) and event.fixes is not None and event.fixes.owner in held:
            message = f"`{event.fixes.owner}` is held by `{held[event.fixes.owner]}` already"
            raise Unsolvable(message, span=event.fixes.span, help="fix a point of a body that moves freely")


def check_joined(item: Touch, places: list[Surface]) -> None:
    """Surfaces that join: a track of unknown profile that leads into a curved one."""
    unknown = [isinstance(place, Curved) and place.radius() is None for place in places]
    curved = all(isinstance(place, Curved) for place in places)
    if len(places) > 1 and not (curved and len(places) == 2 and unknown == [True, False]):
        help = "solved is a track of `profile unknown` that leads into a `hollow` or `dome`"
        raise Unsolvable(
            f"these surfaces of `{item.name}` together are not solved yet", span=item.pair()[1].span, help=help
        )


def check_curved(item: Touch, surface: Curved, problem: Problem) -> None:
    """Round bodies and particles, rolling or without friction, that fit the surface and that nothing else holds."""
    ref = item.pair()[0]
    body = next((body for body in problem.bodies if body.name == ref.owner), None)
    if body is None:
        return
    if item.grip().kind == "coefficient":
        help = "write `friction: none`, or `any` where it is rough enough"
        raise Unsolvable("a coefficient of friction on a curved surface is not solved yet", span=ref.span, help=help)
    rim = rim_radius(body, ref.point)
    particle = rim is None and shape_of(body).word == "particle" and surface.word != "corner"
    if not (rim is not None or particle) or body.parts or body.holes:
        help = "solved are uniform round bodies" + ("" if surface.word == "corner" else ", and particles")
        raise Unsolvable(f"`{body.name}` on `{surface.name}` is not solved yet", span=ref.span, help=help)
    for other in held_besides(body.name, item, problem):
        message = f"`{other}` on a body that is on `{surface.name}` is not solved yet"
        raise Unsolvable(message, span=ref.span, help="solved are forces and couples on it")
    for room, words in too_large(surface, rim or ZERO):
        if negative(room, problem):
            message = f"`{body.name}` {words} `{surface.name}`"
            raise Unsolvable(message, span=ref.span, help="check the radii and heights")


def held_besides(name: str, contact: Touch, problem: Problem) -> Iterator[str]:
    """Strings, springs and the like on a body on a curved surface, and bodies that join it there; not while it is on the floor."""
    surfaces = {surface.name: surface for surface in problem.surfaces}
    touches = [item for item in problem.connections if isinstance(item, Touch) and item.pair()[0].owner == name]
    flat = any(not isinstance(surfaces.get(ref.owner), Curved) for item in touches for ref in item.places())
    gripped = any(isinstance(event, Grips) and event.grips == contact.name for event in problem.events)
    if flat and not gripped:
        return
    for item in problem.connections:
        if item not in touches and any(ref.owner == name for ref in item.touches()):
            yield item.name
    for event in problem.events:
        if isinstance(event, Joins) and any(ref.owner == name for ref in event.joins):
            yield event.name


def too_large(surface: Curved, rim: Formula) -> Iterator[tuple[Formula, str]]:
    """Lengths that must be positive, and what is the matter where one is not."""
    circle = surface.circle(rim)
    if circle is not None and not surface.outside:
        yield circle, "does not fit into"
    if surface.met(rim) is not None:
        yield rim - (surface.height() or ZERO), "is too small to climb"


def negative(room: Formula, problem: Problem) -> bool:
    """Whether a length is not positive with the numbers of the scene; letters without a number are left open."""
    values = {given.name: given.value for given in problem.givens if given.value is not None}
    try:
        return (evaluate(room, values, digits=6).sign or 0) <= 0
    except (Undefined, ValueError):
        return False
