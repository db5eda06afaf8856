"""Rigid bodies: mass, centre of mass and moment of inertia of shapes, composites, holes and joined bodies.

I_P = Σ (I_own + m d²), the parallel-axes theorem over all pieces. Places are in the body's own axes.
"""

from __future__ import annotations

from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import (
    HALF,
    ONE,
    ZERO,
    Formula,
    Number,
    Quotient,
    Sum,
    add,
    call,
    multiply,
    negate,
    sqrt,
    total,
)
from rotsolve.core.derivation import Words
from rotsolve.core.facts import Sweep, Whirl, square
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Heading, Vector, cartesian, heading, vector
from rotsolve.core.vectors.tensor import InertiaTensor, about_z
from rotsolve.core.vectors.tensor import Place as Spot
from rotsolve.core.vectors.triple import (
    Rows,
    X,
    after,
    aligning,
    in_turn,
    scaled_by,
    square_of,
    tidied,
    unit_along,
    vector_sum,
    way_between,
)
from rotsolve.core.vectors.triple import rotated as rotated_in_space
from rotsolve.core.writing import is_negative
from rotsolve.elements.shapes import Shape, rim_radius, rims, rolling_part, shape_of
from rotsolve.language.problem import Body, Part, PointRef

MINUS = Number(Fraction(-1))


class RigidPiece(Struct, frozen=True):
    """A piece of a rigid body: mass, own moment of inertia about its centre of mass, and where that is.

    `tensor` are all its second moments, None where only the moment about its axis is known; `height` is the third coordinate.
    `measure` is the area (length, volume) by which its mass is the share that it has of the material, where that is so;
    `whole` says that the piece is a body's own shape, whose axes are the body's.
    """

    name: str
    mass: Formula
    moment: Formula
    at: Vector
    shape: Shape
    height: Formula = ZERO
    tensor: InertiaTensor | None = None
    measure: Formula | None = None
    heading: Heading = RIGHT
    whole: bool = False
    rows: Rows | None = None  # how it is turned in space

    def place(self) -> Spot:
        """Where its centre of mass is, in the axes of the body."""
        x, y = (simplify(part) if isinstance(part, Sum) else part for part in (self.at.along(RIGHT), self.at.along(UP)))
        return (x, y, self.height)

    def weighing(self, mass: Formula) -> RigidPiece:
        """The piece with another mass, all its moments in terms of that."""
        tensor = turned_by(self.shape.tensor(mass), self.heading) if self.tensor is not None else None
        if self.rows is not None and tensor is not None:
            tensor = tensor.turned(self.rows)
            return replace(self, mass=mass, moment=tensor.zz, tensor=tensor)
        return replace(self, mass=mass, moment=self.shape.moment(mass), tensor=tensor)

    def tensor_along(self, orientation: Heading) -> InertiaTensor | None:
        """Its second moments about its centre of mass, x to the right and y up, in a body that is turned; None where these are not told."""
        tensor = self.tensor
        if tensor is None and self.measure is not None:  # a hole whose depth nobody says
            tensor = turned_by(self.shape.tensor(self.mass), self.heading)
        if tensor is None:
            return InertiaTensor() if self.moment == ZERO else None
        return turned_by(tensor, orientation)

    def turned_in_space(self, rows: Rows, origin: Spot, sign: Formula) -> RigidPiece:
        """The piece turned about the centre of its body, and that moved; with a minus sign it is cut out."""
        x, y, z = (add(start, along) for start, along in zip(origin, rotated_in_space(rows, self.place()), strict=True))
        tensor = None if self.tensor is None else self.tensor.turned(rows).times(sign)
        return replace(
            self,
            mass=multiply(sign, self.mass),
            moment=multiply(sign, self.moment) if tensor is None else tensor.zz,
            at=cartesian(x, y),
            height=z,
            tensor=tensor,
            measure=None if self.measure is None else multiply(sign, self.measure),
            whole=False,
            rows=rows,
        )

    def moved(self, direction: Heading, origin: Vector, height: Formula, sign: Formula) -> RigidPiece:
        """The piece turned in the plane and moved; with a minus sign it is cut out."""
        turned = None if self.tensor is None else turned_by(self.tensor, direction)
        return replace(
            self,
            mass=sign * self.mass,
            moment=sign * self.moment,
            at=self.at.rotated(direction) + origin,
            height=add(self.height, height),
            tensor=None if turned is None else turned.times(sign),
            measure=None if self.measure is None else sign * self.measure,
            heading=self.heading + direction,
            whole=False,
        )


def turned_by(tensor: InertiaTensor, direction: Heading) -> InertiaTensor:
    """The tensor of what is turned in the plane."""
    return tensor if direction == RIGHT else tensor.turned(about_z(direction.cos(), direction.sin()))


def mass_of(body: Body) -> Formula:
    """Total mass, with that of its parts, identical copies counted."""
    if body.mass is None:
        return simplify(total([piece.mass for piece in pieces(body)]))
    mass = body.mass
    if body.parts:
        mass = simplify(total([mass, *(mass_of(part.body) for part in body.parts)]))
    return Number(Fraction(body.count)) * mass if body.count > 1 else mass


def pieces(body: Body) -> tuple[RigidPiece, ...]:
    """The pieces of a body: itself, its parts, and its holes with negative mass; all of it for each copy of `count`."""
    try:
        found: tuple[RigidPiece, ...] = body.__dict__["pieces"]
    except KeyError:
        found = body.__dict__["pieces"] = _all_pieces(body)
    return found


def _all_pieces(body: Body) -> tuple[RigidPiece, ...]:
    own = _own_piece(body)
    parts = tuple(piece for part in body.parts for piece in _placed(part, ONE))
    holes = tuple(piece for hole in body.holes for piece in _cut(hole, body))
    single = (*((own,) if own else ()), *parts, *holes)
    return single if body.count == 1 else tuple(_repeated(piece, body.count) for piece in single)


def _repeated(piece: RigidPiece, count: int) -> RigidPiece:
    """Identical pieces placed symmetrically about the body's centre: their common centre of mass lies there.

    Nobody says how each of them is turned, so that only their moment about the axis is known.
    """
    number, arm = Number(Fraction(count)), tidy(piece.at)
    moment = piece.moment + piece.mass * arm.dot(arm) if arm.parts else piece.moment
    moment = number * moment if moment != ZERO else ZERO
    return RigidPiece(piece.name, number * piece.mass, moment, NOWHERE, piece.shape, piece.height)


def _own_piece(body: Body) -> RigidPiece | None:
    if body.parts and body.shape is None and body.mass is None:
        return None
    shape = shape_of(body)
    mass = body.mass if body.mass is not None else ZERO
    measure = None
    if body.holes and body.shape is not None:
        measure, *cut = materials(body)
        mass = mass / (measure - total(cut)) * measure
    at, height = place(shape.centroid()), shape.rise()
    if body.tensor is not None:  # about its own point; who needs it about another asks `space/inertia`
        return RigidPiece(body.name, mass, body.tensor.zz, at, shape, height, body.tensor)
    if body.inertia is not None or body.gyration is not None:
        moment = body.inertia if body.inertia is not None else mass * (body.gyration or ZERO) ** 2
        return RigidPiece(body.name, mass, moment, at, shape, height)
    return RigidPiece(body.name, mass, shape.moment(mass), at, shape, height, shape.tensor(mass), measure, whole=True)


def materials(body: Body) -> tuple[Formula, ...]:
    """Length, area or volume of a body without its holes, and of each of them; what tells them is loaded for bodies with holes alone."""
    from rotsolve.elements.shapes.material import amounts

    return amounts(body)


def _cut(hole: Part, body: Body) -> tuple[RigidPiece, ...]:
    """The pieces of a hole, with the mass of the material that it would hold, for a body of uniform thickness."""
    if hole.body.mass is not None or body.mass is None:
        return _placed(hole, MINUS)
    shape, cut = shape_of(body), shape_of(hole.body)
    whole, *sizes = materials(body)
    size = sizes[body.holes.index(hole)]
    filled = replace(hole, body=Body(hole.body.name, cut, mass=body.mass / (whole - total(sizes)) * size))
    pieces = tuple(replace(piece, measure=MINUS * size) for piece in _placed(filled, MINUS))
    if cut.flat and not shape.flat:  # how deep it is nobody says
        return tuple(replace(piece, tensor=None) for piece in pieces)
    return pieces


def _placed(part: Part, sign: Formula) -> tuple[RigidPiece, ...]:
    """The pieces of a part, turned and moved to its place."""
    rows = part_rows(part)
    if rows is not None:
        return tuple(piece.turned_in_space(rows, part_spot(part), sign) for piece in pieces(part.body))
    direction, origin = part_frame(part)
    height = part_spot(part)[2]
    return tuple(piece.moved(direction, origin, height, sign) for piece in pieces(part.body))


def part_rows(part: Part) -> Rows | None:
    """How a part is turned in space: by its `turned`, and from its start to its end where they differ in height; None within the plane."""
    turned = in_turn((item.about, item.by) for item in part.turned)
    if part.start is not None and part.end is not None:
        start, end = with_height(part.start), with_height(part.end)
        if part.turned or start[2] != end[2]:
            return after(turned, aligning(X, unit_along(tidied(way_between(start, end)))))
    return turned if part.turned else None


def part_spot(part: Part) -> Spot:
    """Where the centre of a part is, in the axes of the whole body."""
    rows = part_rows(part)
    if part.start is not None and part.end is not None:
        return tidied(scaled_by(HALF, vector_sum(with_height(part.start), with_height(part.end))))
    reach = part.body.shape.reach() if part.start is not None and part.body.shape is not None else None
    if part.start is not None and reach is not None and rows is not None:
        return vector_sum(with_height(part.start), rotated_in_space(rows, (reach / 2, ZERO, ZERO)))
    if rows is not None or part.start is None:
        return (ZERO, ZERO, ZERO) if part.at is None else with_height(part.at)
    x, y = part_frame(part)[1].along(RIGHT), part_frame(part)[1].along(UP)
    return (x, y, with_height(part.start)[2])


def with_height(at: tuple[Formula, ...]) -> Spot:
    """A place with its height, 0 where it has none."""
    return (at[0], at[1], at[2] if len(at) > 2 else ZERO)


def between_ends(
    start: tuple[Formula, ...], end: tuple[Formula, ...], positive: frozenset[str] = frozenset()
) -> Formula:
    """√(Δx² + Δy² + Δz²) of two places."""
    gap = tidied(way_between(with_height(start), with_height(end)))
    return simplify(sqrt(square_of(gap)), positive=positive)


def part_frame(part: Part) -> tuple[Heading, Vector]:
    """Direction of a part's own x axis and place of its centre, in the axes of the whole body."""
    if part.start is not None and part.end is not None:
        middle = place(part.start) + place(part.end)
        along = place(part.end) - place(part.start)
        return direction_of(along), tidy(middle.times(HALF))
    angle = heading(part.angle) if part.angle is not None else RIGHT
    length = part.body.shape.reach() if part.start is not None and part.body.shape is not None else None
    if part.start is not None and length is not None:
        return angle, place(part.start) + Vector(((length / 2, angle),))
    return angle, place(part.at) if part.at is not None else NOWHERE


def place(at: tuple[Formula, ...]) -> Vector:
    """A place in the plane; a height is left out."""
    return cartesian(*at[:2])


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
    """A slanted vector as one size along one direction, where that holds no letters: d at 45°, not s/2 right and s/2 up."""
    if len(arm.parts) < 2:
        return arm
    direction = direction_of(arm)
    if any(angle.symbols() for angle, _ in direction.terms):
        return arm
    x, y = arm.along(RIGHT), arm.along(UP)
    size = simplify(sqrt(x**2 + y**2), positive=(x + y).symbols())
    return arm if size.holds("abs") else Vector(((size, direction),))  # which way it points hangs on numbers


def direction_of(arm: Vector) -> Heading:
    """The heading of a vector: that of its only part, or atan2 of its components."""
    arm = tidy(arm)
    if len(arm.parts) == 1:
        size, direction = arm.parts[0]
        return direction.turned(180) if is_negative(size) else direction
    if not arm.parts:
        return RIGHT
    x, y = arm.along(RIGHT), arm.along(UP)
    if isinstance(x, Quotient) and isinstance(y, Quotient) and x.denominator == y.denominator:
        x, y = x.numerator, y.numerator  # of a centre of mass the common mass, which is positive
    slope = simplify(y / x) if x != ZERO else None
    if isinstance(slope, Number):  # sizes are positive, so the signs as written tell the quadrant
        x = Number(Fraction(-1 if is_negative(x) else 1))
        y = slope * x
    return heading(simplify(call("atan2", y, x)))


def centre_of_mass(items: tuple[RigidPiece, ...]) -> Vector:
    """Σ m r / Σ m; the only place where all pieces agree needs no masses."""
    places = {tidy(piece.at) for piece in items}
    if len(places) == 1:
        return places.pop()
    whole = simplify(total([piece.mass for piece in items]))
    x = simplify(total([piece.mass * piece.at.along(RIGHT) for piece in items]) / whole)
    y = simplify(total([piece.mass * piece.at.along(UP) for piece in items]) / whole)
    return cartesian(x, y)


def moment_about(items: tuple[RigidPiece, ...], point: Vector, order: tuple[str, ...] = ()) -> tuple[Formula, Words]:
    """Moment of inertia about a point: as a simplified formula for each mass, and the sum, by parallel axes, that it comes from."""
    terms: list[Formula] = []
    by_mass: dict[Formula, list[Formula]] = {}
    shifted = False
    for piece in items:
        arm = tidy(piece.at - point)
        distance = simplify(arm.dot(arm)) if len(arm.parts) > 1 else arm.parts[0][0] ** 2 if arm.parts else ZERO
        moved = distance != ZERO and piece.mass != ZERO
        own = [term for term in (piece.moment, piece.mass * distance if moved else ZERO) if term != ZERO]
        shifted = shifted or len(own) == 2
        by_mass.setdefault(piece.mass, []).extend(own)
        terms += own
    whole = total(terms)
    shown = simplify(whole, order=order)
    apart = total([simplify(total(own), order=order) for own in by_mass.values() if own])
    if not isinstance(shown, Sum) and 2 * length(apart) <= 3 * length(shown):  # ½ M R² + m R² rather than R² (½ M + m)
        shown = apart
    parts = [simplify(term, order=order) for term in terms]
    alike = len(parts) > 1 and not isinstance(shown, Sum)  # 4 I, of 3 I and I
    return shown, (("parallel axes: ", whole) if shifted else ("sum: ", total(parts)) if alike else ())


def carried_round(
    items: tuple[RigidPiece, ...], point: Vector, orientation: Heading, offset: Formula
) -> tuple[Formula, Formula] | None:
    """∫ x y dm and ∫ (x² + z²) dm of a turned body, x from an upright axis and y up from a point at `offset` on its right.

    None where a shape does not tell how its mass is spread.
    """
    products: list[Formula] = []
    moments: list[Formula] = []
    for piece in items:
        own = piece.tensor_along(orientation)
        if own is None:
            return None
        arm = (piece.at - point).rotated(orientation)
        away = offset + arm.along(RIGHT)
        products += [piece.mass * away * arm.along(UP), negate(own.xy)]
        moments += [piece.mass * away**2, own.yy]
    return simplify(total(products)), simplify(total(moments))


def sweep(
    body: Body,
    items: tuple[RigidPiece, ...],
    point: Vector,
    orientation: Heading,
    whirl: Whirl | None,
    order: tuple[str, ...],
) -> Sweep | None:
    """What a turning shaft asks of pieces that it carries round, about a point that is at the whirl's distance: Ω² ∫ x y dm."""
    if whirl is None:
        return None
    spread = carried_round(items, point, orientation, whirl.distance)
    if spread is None:
        raise Unsolvable(f"how the mass of `{body.name}` is spread along and across it is not told", span=body.span)
    product, inertia = (simplify(value, order=order) for value in spread)
    return Sweep(whirl.rate, simplify(square(whirl.rate) * product, order=order), inertia)


ON_RIM = {"top": UP, "bottom": UP.turned(180), "rim": RIGHT}  # directions in space, save for a point that is held


def rim_ways(body: Body) -> dict[str, Heading]:
    """The names of points on the rims of a body, with the directions from its centre in which they are."""
    return {**ON_RIM, **dict.fromkeys(rims(body), RIGHT)}


def rim_centre(body: Body, point: str | None) -> Vector:
    """Place of the centre of the rim that a point names: that of the part of this name, else of the body."""
    part = rolling_part(body, point)
    return NOWHERE if part is None else part_frame(part)[1]


class Frame(Struct, frozen=True):
    """A rigid body (with all that is joined to it) in its own axes: pieces, centre of mass and reference point."""

    pieces: tuple[RigidPiece, ...]
    reference: Vector
    cm: Vector  # from the reference


def locate(body: Body, ref: PointRef | None) -> Vector:
    """Place of a point in a body's own axes; of a rim, the place that it has while the body stands as drawn."""
    if ref is None or ref.point in (None, "center"):
        return NOWHERE
    if ref.point in (ways := rim_ways(body)):
        radius = rim_radius(body, ref.point)
        if radius is not None:
            return vector(radius, ways[ref.point])
    if ref.point == "cm":
        return centre_of_mass(pieces(body))
    for name, at in body.points:
        if name == ref.point:
            return place(at)
    for part in body.parts:
        if part.body.name == ref.point:
            return part_frame(part)[1]
    return place(shape_of(body).locate(ref.point or "", ref.argument))


def rise(body: Body, ref: PointRef) -> Formula:
    """Height of a point above the picture, in the body's axes."""
    if ref.point == "cm":
        items = pieces(body)
        if all(piece.height == ZERO for piece in items):
            return ZERO
        whole = total([piece.mass for piece in items])
        return simplify(total([piece.mass * piece.height for piece in items]) / whole)
    for name, at in body.points:
        if name == ref.point:
            return at[2] if len(at) > 2 else ZERO
    for part in body.parts:
        if part.body.name == ref.point:
            return part.at[2] if part.at is not None and len(part.at) > 2 else ZERO
    return shape_of(body).rise(ref.point or "center")
