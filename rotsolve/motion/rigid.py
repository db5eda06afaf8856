"""Rigid bodies: mass, centre of mass and moment of inertia of shapes, composites, holes and joined bodies.

I_P = Σ (I_own + m d²), the parallel-axes theorem over all pieces. Places are in the body's own axes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Number, Sum, call, negate, sqrt, total
from rotsolve.core.derivation import Words
from rotsolve.core.heading import NOWHERE, RIGHT, UP, Heading, Vector, cartesian, heading
from rotsolve.core.writing import is_negative
from rotsolve.elements.rims import shape_of
from rotsolve.elements.shapes import Place, Rod, Shape
from rotsolve.scene.model import Body, Part


@dataclass(frozen=True)
class Piece:
    """A piece of a rigid body: mass, own moment of inertia about its centre of mass, and where that is."""

    name: str
    mass: Formula
    moment: Formula
    at: Vector
    slender: Formula | None = (
        None  # ∫ (x² − y²) dm about its centre of mass, x along `axis`; None where that is not told
    )
    axis: Heading = RIGHT


def mass_of(body: Body) -> Formula:
    """Total mass, identical copies counted."""
    mass = body.mass if body.mass is not None else simplify(total([piece.mass for piece in pieces(body)]))
    return Number(Fraction(body.count)) * mass if body.count > 1 else mass


def pieces(body: Body) -> tuple[Piece, ...]:
    """The pieces of a body: itself, its parts, and its holes with negative mass; all of it for each copy of `count`."""
    own = _own_piece(body)
    parts = tuple(piece for part in body.parts for piece in _placed(part, ONE))
    holes = tuple(piece for hole in body.holes for piece in _placed(_filled(hole, body), Number(Fraction(-1))))
    single = (*((own,) if own else ()), *parts, *holes)
    return single if body.count == 1 else tuple(_repeated(piece, body.count) for piece in single)


def _repeated(piece: Piece, count: int) -> Piece:
    """Identical pieces placed symmetrically about the body's centre: their common centre of mass lies there."""
    number, arm = Number(Fraction(count)), tidy(piece.at)
    moment = piece.moment + piece.mass * arm.dot(arm) if arm.parts else piece.moment
    return Piece(piece.name, number * piece.mass, number * moment if moment != ZERO else ZERO, NOWHERE)


def _own_piece(body: Body) -> Piece | None:
    if body.parts and body.shape is None and body.mass is None:
        return None
    shape = shape_of(body)
    mass = body.mass if body.mass is not None else ZERO
    if body.holes and isinstance(body.shape, Shape):
        mass = (
            mass / (shape.measure() - total([shape_of(hole.body).measure() for hole in body.holes])) * shape.measure()
        )
    moment = (
        body.inertia
        if body.inertia is not None
        else mass * body.gyration**2
        if body.gyration is not None
        else shape.moment(mass)
    )
    told = body.inertia is None and body.gyration is None and body.shape is not None
    alike = moment == ZERO or told
    return Piece(body.name, mass, moment, place(shape.centroid()), shape.slender(mass) if alike else None)


def _filled(hole: Part, body: Body) -> Part:
    """A hole with the mass of the material that it would hold, for a body of uniform thickness."""
    if hole.body.mass is not None or body.mass is None:
        return hole
    shape, cut = shape_of(body), shape_of(hole.body)
    rest = shape.measure() - total([shape_of(other.body).measure() for other in body.holes])
    filled = Body(hole.body.name, hole.body.shape, mass=body.mass / rest * cut.measure())
    return Part(filled, hole.at, hole.start, hole.end, hole.angle)


def _placed(part: Part, sign: Formula) -> tuple[Piece, ...]:
    """The pieces of a part, turned and moved to its place."""
    direction, origin = part_frame(part)
    return tuple(
        replace(
            piece,
            name=part.body.name,
            mass=sign * piece.mass,
            moment=sign * piece.moment,
            at=piece.at.rotated(direction) + origin,
            slender=None if piece.slender is None else sign * piece.slender,
            axis=piece.axis + direction,
        )
        for piece in pieces(part.body)
    )


def part_frame(part: Part) -> tuple[Heading, Vector]:
    """Direction of a part's own x axis and place of its centre, in the axes of the whole body."""
    if part.start is not None and part.end is not None:
        middle = place(part.start) + place(part.end)
        along = place(part.end) - place(part.start)
        return direction_of(along), tidy(middle.times(Number(Fraction(1, 2))))
    angle = heading(part.angle) if part.angle is not None else RIGHT
    if part.start is not None and isinstance(part.body.shape, Rod) and part.body.shape.length is not None:
        return angle, place(part.start) + Vector(((part.body.shape.length / 2, angle),))
    return angle, place(part.at) if part.at is not None else NOWHERE


def place(at: Place) -> Vector:
    return cartesian(*at)


def tidy(arm: Vector) -> Vector:
    """The vector with its rightward and upward parts simplified, so that what cancels is gone."""
    if len({Heading(direction.degrees % 180, direction.terms) for _, direction in arm.parts}) == len(arm.parts):
        tidied = ((simplify(size) if isinstance(size, Sum) else size, direction) for size, direction in arm.parts)
        return Vector(tuple(positive_part(size, direction) for size, direction in tidied if size != ZERO))
    collected: dict[Heading, Formula] = {}
    for size, direction in arm.parts:
        opposite = direction.turned(180)
        opposite = Heading(opposite.degrees % 360, opposite.terms)
        if opposite in collected:
            collected[opposite] = collected[opposite] - size
        else:
            key = Heading(direction.degrees % 360, direction.terms)
            collected[key] = collected.get(key, ZERO) + size
    parts = ((simplify(size), direction) for direction, size in collected.items())
    return Vector(tuple(positive_part(size, direction) for size, direction in parts if size != ZERO))


def positive_part(size: Formula, direction: Heading) -> tuple[Formula, Heading]:
    """A part of a vector with its minus sign turned into the opposite heading."""
    return (negate(size), direction.turned(180)) if is_negative(size) else (size, direction)


def polar(arm: Vector) -> Vector:
    """A slanted vector as one size along one direction, where the direction is a plain angle: d at 45°, not s/2 right and s/2 up."""
    if len(arm.parts) < 2:
        return arm
    direction = direction_of(arm)
    if direction.terms:
        return arm
    x, y = arm.along(RIGHT), arm.along(UP)
    return Vector(((simplify(sqrt(x**2 + y**2), positive=(x + y).symbols()), direction),))


def direction_of(arm: Vector) -> Heading:
    """The heading of a vector: that of its only part, or atan2 of its components."""
    arm = tidy(arm)
    if len(arm.parts) == 1:
        size, direction = arm.parts[0]
        return direction.turned(180) if is_negative(size) else direction
    if not arm.parts:
        return RIGHT
    x, y = arm.along(RIGHT), arm.along(UP)
    slope = simplify(y / x) if x != ZERO else None
    if isinstance(slope, Number):  # sizes are positive, so the signs as written tell the quadrant
        x = Number(Fraction(-1 if is_negative(x) else 1))
        y = slope * x
    return heading(simplify(call("atan2", y, x)))


def centre_of_mass(items: tuple[Piece, ...]) -> Vector:
    """Σ m r / Σ m; the only place where all pieces agree needs no masses."""
    places = {tidy(piece.at) for piece in items}
    if len(places) == 1:
        return places.pop()
    whole = simplify(total([piece.mass for piece in items]))
    x = simplify(total([piece.mass * piece.at.along(RIGHT) for piece in items]) / whole)
    y = simplify(total([piece.mass * piece.at.along(UP) for piece in items]) / whole)
    return cartesian(x, y)


def moment_about(items: tuple[Piece, ...], point: Vector, order: tuple[str, ...] = ()) -> tuple[Formula, Words]:
    """Moment of inertia about a point: as a simplified formula, and the parallel-axes sum that it comes from."""
    terms: list[Formula] = []
    shifted = False
    for piece in items:
        arm = tidy(piece.at - point)
        distance = simplify(arm.dot(arm)) if len(arm.parts) > 1 else arm.parts[0][0] ** 2 if arm.parts else ZERO
        if piece.moment != ZERO:
            terms.append(piece.moment)
        if distance != ZERO and piece.mass != ZERO:
            terms.append(piece.mass * distance)
            shifted = shifted or piece.moment != ZERO
    whole = total(terms)
    return simplify(whole, order=order), (("parallel axes: ", whole) if shifted else ())


def product_about(items: tuple[Piece, ...], point: Vector, orientation: Heading, offset: Formula) -> Formula | None:
    """∫ (offset + x) y dm, x to the right and y up from a point, of a body turned by `orientation`; None where a shape does not tell."""
    terms: list[Formula] = []
    for piece in items:
        if piece.slender is None:
            return None
        arm, axis = (piece.at - point).rotated(orientation), piece.axis + orientation
        terms.append(piece.mass * (offset + arm.along(RIGHT)) * arm.along(UP))
        terms.append(piece.slender * axis.cos() * axis.sin())
    return simplify(total(terms))
