"""Mounts: which axles are carried along: those with a body that something else than the axle leads; all others are fixed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from msgspec.structs import replace

from rotsolve.core.faults import Unsolvable
from rotsolve.elements.shapes import rim_radius
from rotsolve.language.elements import Connection
from rotsolve.language.problem import Body, PointRef, Problem
from rotsolve.motion.named_alone import at_its_points

Bodies = Mapping[str, Body]
Others = Sequence[Connection]


def on_mounts(problem: Problem) -> Problem:
    """The problem with its connections as they stand among each other: an axle on a body that moves is no fixed one."""
    bodies = {body.name: body for body in problem.bodies}
    level = {"ground", *(surface.name for surface in problem.surfaces if surface.level)}
    seen = (item.seen(problem, level) for item in problem.connections)
    items = [at_its_points(item, bodies) if on_one_axle(item) else item for item in seen]
    while carried := next(
        ((item, moving) for item in filter(on_one_axle, items) if (moving := moving_on(item, items, bodies))), None
    ):
        item, moving = carried  # what an axle carries may carry the next one
        items[items.index(item)] = item.among(moving)
    for item in filter(on_one_axle, items):
        check_fixed(item, [other for other in items if other is not item], bodies)
    return replace(problem, connections=tuple(items))


def on_one_axle(item: Connection) -> bool:
    """Whether several are on one axle, so that one of them may carry the others."""
    return item.axial and len(item.touches()) > 1


def seats(item: Connection, bodies: Bodies) -> list[PointRef]:
    """The bodies on an axle that may carry it."""
    return [ref for ref in item.touches() if ref.owner in bodies] if on_one_axle(item) else []


def moving_on(item: Connection, items: Others, bodies: Bodies) -> set[str]:
    """The bodies on an axle that move by themselves; also what stands on an axle of its own and holds this one aside of that."""
    others = [other for other in items if other is not item]
    firm = [other for other in others if not on_one_axle(other)]  # of the rest is not known yet whether it is fixed
    moving = {ref.owner for ref in seats(item, bodies) if moves(ref.owner, ref, firm, bodies)}
    owned = {ref.owner for other in others for ref in seats(other, bodies) if at_centre(ref)}
    return moving or {ref.owner for ref in seats(item, bodies) if ref.owner in owned and not at_centre(ref)}


def at_centre(ref: PointRef) -> bool:
    """Whether an axle through this point is that about which the body turns by itself."""
    return ref.point in (None, "center", "cm")


def moves(name: str, at: PointRef | None, others: Others, bodies: Bodies) -> bool:
    """Whether its `moves` or other connections lead a body (so that its point `at` moves): what two hold at one point stands still.

    A joint leads the body that it carries where something leads the carrier; what a body carries does not lead that body.
    """
    body = bodies[name]
    if body.moves is not None or any(component for _, component, _ in body.moved):
        return True
    for item in others:
        if lays(item, body, bodies) or (item.hangs(body) and rim_radius(body, None) is None):
            return True
        if any(own.owner == name and not (at and one_spot(own, at)) for own in item.fixed_points()):
            return True
        rest = [other for other in others if other is not item]
        for own, carrier in leads(item, name):
            there = carrier if at and one_spot(own, at) else None
            if carrier.owner in bodies and moves(carrier.owner, there, rest, bodies):
                return True
    return False


def lays(item: Connection, body: Body, bodies: Bodies) -> bool:
    """Whether a body lies on something, and not on a wheel."""
    under = bodies.get(item.places()[0].owner) if item.lying() == body.name else None
    return item.lying() == body.name and (under is None or rim_radius(under, None) is None)


def leads(item: Connection, name: str) -> Iterator[tuple[PointRef, PointRef]]:
    """The point of a body by which it is carried, or welded to another, and that of the other."""
    carrier, *carried = item.joint() or (PointRef(""),)
    yield from ((own, carrier) for own in carried if own.owner == name)
    if item.joined():
        first, second = item.joined()
        yield from ((own, other) for own, other in ((first, second), (second, first)) if own.owner == name)


def one_spot(one: PointRef, two: PointRef) -> bool:
    """Whether two points of a body are one."""
    return (one.point or "center", one.argument) == (two.point or "center", two.argument)


def check_fixed(item: Connection, others: Others, bodies: Bodies) -> None:
    """A fixed axle: refused where the scene may as well mean that a body carries it along."""
    for ref in seats(item, bodies):
        name = ref.owner
        apart = f"write `axle: {written(ref)}` and an axle of its own for each of the others"
        for other in others:
            own, *carried = other.joint() or (PointRef(""),)
            rest = [third for third in others if third is not other]
            for held in carried if own.owner == name and not one_spot(own, ref) else ():
                if held.owner in bodies and moves(held.owner, None, rest, bodies):
                    why = f"`{name}` carries `{held.owner}`, which does not hang from it alone"
                    message = f"{why}: whether `{item.name}` is fixed is not told"
                    swapped = f"`{other.word}: [{written(held)}, {written(own)}]`"
                    help = f"if it is, {apart}; if `{held.owner}` carries `{name}`, write {swapped}"
                    raise Unsolvable(message, span=ref.span, help=help)
            if any(two.owner == name and not one_spot(two, ref) for two in seats(other, bodies)):
                message = f"which of `{item.name}` and `{other.name}` is fixed, and which one `{name}` carries along, is not told"
                raise Unsolvable(message, span=ref.span, help=f"if `{item.name}` is fixed, {apart}")


def written(ref: PointRef) -> str:
    """A point as a scene names it, short."""
    return ref.owner if ref.point is None else f"{ref.owner}.{ref.point}" + ("(x)" if ref.argument is not None else "")
