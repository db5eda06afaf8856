"""Limits of a scene: what its keys, shapes, holes, places and connections ask of its letters, beyond that each is positive.

What numbers are refused by, letters are held to: it is what they may be, and it is told with the answers.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, call, negate, sqrt, total
from rotsolve.core.limits import Limit
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.vectors.tensor import ONE_AXIS, InertiaTensor, displaced
from rotsolve.core.vectors.triple import Z
from rotsolve.core.vectors.triple import rotated as rotated_in_space
from rotsolve.elements.shapes import Shape
from rotsolve.elements.shapes.material import bored
from rotsolve.language.bodies import Part
from rotsolve.language.keys import HIGHEST
from rotsolve.language.limited import limited_values
from rotsolve.language.problem import Body, Problem, references
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rigid import materials, part_rows, part_spot

LOWEST = {  # by what a key says of its values
    "positive": "must be positive",
    "nonnegative": "can't be negative",
    "fraction": "must lie from 0 to 1",
    "acute": "must lie from 0 to 90°",
}


def limits_of_scene(configuration: Configuration) -> Iterator[Limit]:
    """All limits of a scene, those that hold of themselves among them."""
    problem = configuration.problem
    yield from key_limits(problem)
    yield from place_limits(problem)
    for body in problem.bodies:
        yield from body_limits(body)
    for item in problem.connections:
        yield from item.rooms(configuration)
    yield from state_limits(configuration)


def key_limits(problem: Problem) -> Iterator[Limit]:
    """What stands under keys that take only some values."""
    for owner, value, limits in limited_values(problem):
        words = f"in `{owner}` it {LOWEST[limits]}"
        yield Limit(value, words, strict=limits == "positive")
        if limits in HIGHEST:
            yield Limit(HIGHEST[limits] - value, words)


def place_limits(problem: Problem) -> Iterator[Limit]:
    """Places that are named on rods lie between their ends."""
    shapes = {body.name: body.shape for body in problem.bodies if body.shape is not None and body.shape.slender}
    for ref in references((problem.connections, problem.actions, problem.states, problem.events, problem.finds)):
        shape = shapes.get(ref.owner) if ref.point == "at" else None
        whole = shape.reach() if shape is not None else None
        if ref.argument is not None and whole is not None:
            words = f"it is a place on `{ref.owner}`, which ends before"
            yield Limit(ref.argument, words)
            yield Limit(whole - ref.argument, words)


def body_limits(body: Body) -> Iterator[Limit]:
    """What its shape asks of its sizes, and those of its parts, and that its holes lie within it beside each other."""
    for part in (body, *(part.body for part in (*body.parts, *body.holes))):
        yield from part.shape.rooms() if part.shape is not None else ()
        rims = dict(part.radii)
        if {"inner", "outer"} <= rims.keys():
            yield Limit(rims["outer"] - rims["inner"], "`inner` must be smaller than `outer`", strict=True)
    yield from tensor_limits(body)
    for hole in body.holes:
        for gap in hole_margins(hole, body.shape):
            yield Limit(gap, f"the hole `{hole.body.name}` sticks out of `{body.name}`")
    for one, other in combinations(body.holes, 2):
        radii = [round_rim(hole.body.shape) for hole in (one, other)]
        if radii[0] is not None and radii[1] is not None:
            names = f"the holes `{one.body.name}` and `{other.body.name}` of `{body.name}`"
            gap = far_out([a - b for a, b in zip(hole_centre(one), hole_centre(other), strict=True)])
            if not (one.turned or other.turned):
                yield Limit(gap - radii[0] - radii[1], f"{names} overlap")
        if one.turned or other.turned:  # told apart by the balls around them alone
            spots = zip(part_spot(one), part_spot(other), strict=True)
            rooms = [ball_around(bored(hole, body.shape)) for hole in (one, other)]
            gap = far_out([a - b for a, b in spots])
            yield Limit(
                gap - rooms[0] - rooms[1],
                f"whether the holes of `{body.name}` overlap is not solved: they are turned and near",
            )
    sizes = sizes_told(body) if body.holes else ()
    if sizes:
        left = total([sizes[0], *map(negate, sizes[1:])])
        yield Limit(left, f"the holes leave nothing of `{body.name}`", strict=True)


def tensor_limits(body: Body) -> Iterator[Limit]:
    """Of the moments of inertia about the centre of mass none is larger than the other two together: each Σ m x² is positive."""
    tensor, mass = body.tensor, body.mass
    if tensor is None:
        return
    away = dict(body.points).get(body.inertia_about or "", (ZERO, ZERO, ZERO))
    x, y, z = (*away, ZERO)[:3]
    off = displaced(mass or ZERO, (x, y, z))
    own = [simplify(tensor.entry(word) - off.entry(word)) for word in ONE_AXIS]
    words = f"no body has the moments of inertia of `{body.name}`: about its centre of mass one would be larger than the other two together"
    about = (
        f"those about `{body.inertia_about}` are larger by M d²: check its mass, and how far away its centre of mass is"
    )
    for number in range(3):
        rest = [moment for place, moment in enumerate(own) if place != number]
        yield Limit(simplify(rest[0] + rest[1] - own[number]), words, help=about if off != InertiaTensor() else "")


def hole_margins(hole: Part, whole: Shape | None) -> Iterator[Formula]:
    """How far a round or rectangular hole lies within a round or rectangular shape."""
    if hole.turned:
        yield from depth_margins(hole, whole)
        return
    x, y = hole_centre(hole)
    radius, box = round_rim(hole.body.shape), hole.body.shape.box() if hole.body.shape is not None else ()
    edge, sides = round_rim(whole), whole.box() if whole is not None else ()
    spots = [(x, y)] if radius is not None else [(x + u, y + v) for u, v in box_corners(box, hole.angle)] if box else []
    room = radius or ZERO
    for spot in dict.fromkeys(spots):
        if edge is not None:
            yield edge - far_out(spot) - room
        for reach, side in zip(spot, sides[:2], strict=False):
            yield from (simplify(side / 2 - room - way) for way in dict.fromkeys((reach, negate(reach))))
    inner = dict(getattr(whole, "radii", ())).get("inner")
    if inner is not None and radius is not None:
        yield far_out((x, y)) - inner - radius
    yield from depth_margins(hole, whole)


def depth_margins(hole: Part, whole: Shape | None) -> Iterator[Formula]:
    """How far a hole lies within a solid along its z axis, and a ball within a ball in all directions."""
    hole = bored(hole, whole)
    own = hole.body.shape
    if own is None or whole is None:
        return
    z = (*(hole.at or ()), ZERO, ZERO, ZERO)[2]
    deep, deeper = own.depth(), whole.depth()
    if own.spherical and whole.spherical:
        yield simplify((whole.outer or ZERO) - far_out([*hole_centre(hole), z]) - (own.outer or ZERO))
        return
    if hole.turned and cylinder_in_box(hole, whole):
        yield from box_margins(hole, whole)
        return
    if own.spherical and deeper is not None:
        deep = 2 * (own.outer or ZERO)
    if deep is not None and deeper is not None:
        yield from (simplify((deeper - deep) / 2 - way) for way in dict.fromkeys((z, negate(z))))


def ball_around(hole: Part) -> Formula:
    """The radius of a ball that holds a hole."""
    shape = hole.body.shape
    sides = [] if shape is None else [*shape.box(), *([shape.depth()] if shape.depth() is not None else [])]
    radius = round_rim(shape)
    return far_out([*([radius] if radius is not None else []), *(side / 2 for side in sides if side is not None)])


def cylinder_in_box(hole: Part, whole: Shape) -> bool:
    """Whether a hole is a cylinder in a box."""
    own = hole.body.shape
    return own is not None and own.round and own.depth() is not None and bool(whole.box()) and whole.depth() is not None


def box_margins(hole: Part, whole: Shape) -> Iterator[Formula]:
    """How far a turned cylinder lies within a box: along each axis it reaches (L/2)|n| + R √(1 − n²) from its centre, n its axis's part."""
    own, rows, spot = hole.body.shape, part_rows(hole), part_spot(hole)
    assert own is not None
    length, radius = own.depth() or ZERO, own.outer or ZERO
    axis = Z if rows is None else rotated_in_space(rows, Z)
    for side, at, part in zip((*whole.box(), whole.depth() or ZERO), spot, axis, strict=True):
        reach = length / 2 * call("abs", part) + radius * sqrt(ONE - part**2)
        yield from (simplify(side / 2 - reach - way) for way in dict.fromkeys((at, negate(at))))


def seen_to_fit(hole: Part, whole: Shape | None) -> bool:
    """Whether the margins of a hole in space tell that it lies within a shape: not of one that is turned, nor in a cone and its like."""
    hole = bored(hole, whole)
    own = hole.body.shape
    if own is None or whole is None or own.flat or whole.flat or not (own.spherical or own.depth() is not None):
        return True  # what lacks for its mass is said elsewhere
    if own.spherical and whole.spherical:
        return True
    return cylinder_in_box(hole, whole) or (not hole.turned and whole.depth() is not None)


def box_corners(box: tuple[Formula, ...], angle: Formula | None) -> Iterator[tuple[Formula, Formula]]:
    """The corners of a rectangle from its centre."""
    cos, sin = (ONE, ZERO) if angle is None else (call("cos", angle), call("sin", angle))
    for right, up in product((ONE, negate(ONE)), repeat=2):
        x, y = right * box[0] / 2, up * box[1] / 2
        yield simplify(x * cos - y * sin), simplify(x * sin + y * cos)


def hole_centre(part: Part) -> tuple[Formula, Formula]:
    """Where the centre of a part or a hole is, in the picture."""
    x, y, *_ = part.at or (ZERO, ZERO)
    return x, y


def far_out(way: tuple[Formula, ...] | list[Formula]) -> Formula:
    return simplify(sqrt(total([part**2 for part in way])))


def round_rim(shape: Shape | None) -> Formula | None:
    """The outer radius of a round shape."""
    return shape.outer if shape is not None and shape.round else None


def sizes_told(body: Body) -> tuple[Formula, ...]:
    """The length, area or volume of a body and of what is cut out of it; none where a size is not told."""
    try:
        return () if body.shape is None else materials(body)
    except (NotImplementedError, TypeError, IndexError):
        return ()  # a size is left out


def state_limits(configuration: Configuration) -> Iterator[Limit]:
    """What states tell of quantities that are never negative, and that nothing leaves a body whose mass changes on the way."""
    for state in configuration.timeline.states:
        before = configuration.timeline.before(state.name)
        for line in state.conditions:
            if line.path is None or line.value is None:
                continue
            name, word = line.path.owner, line.path.quantity
            if QUANTITIES[word].nonnegative:
                yield Limit(line.value, f"at `{state.name}` it can't be negative")
            if word == "mass" and before is not None and name in configuration.bodies:
                earlier = configuration.body(name, before.start).mass
                if earlier is not None:
                    yield Limit(
                        line.value - earlier, f"what leaves `{name}` takes momentum along, which is not solved yet"
                    )
