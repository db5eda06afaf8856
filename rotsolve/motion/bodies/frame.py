"""Frame: a rigid body in its own axes, with all that is joined to it: its pieces, its centre of mass, and where its points are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, total
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Vector, vector
from rotsolve.elements.rims import rim_radius, shape_of
from rotsolve.language.problem import Body, PointRef
from rotsolve.motion.bodies.rigid import Piece, centre_of_mass, part_frame, pieces, place, polar, tidy

if TYPE_CHECKING:
    from rotsolve.motion.configuration import Configuration

ON_RIM = {"top": UP, "bottom": UP.turned(180), "rim": RIGHT}  # directions in space, save for a point that is held


class Frame(Struct, frozen=True):
    """A rigid body (with all that is joined to it) in its own axes: pieces, centre of mass and reference point."""

    pieces: tuple[Piece, ...]
    reference: Vector
    cm: Vector  # from the reference


def frame(configuration: Configuration, name: str, state: str) -> Frame:
    """The rigid body `name` at a state; its reference is the fixed pivot, else the centre of mass."""
    body = configuration.body(name, state)
    items = list(pieces(body))
    for member in configuration.cluster(name, state):
        if member.host == name:
            base = locate(body, member.at)
            offset = locate(configuration.body(member.name, state), member.own)
            own = frame(configuration, member.name, state).pieces
            items.extend(replace(item, at=tidy(base + item.at - offset)) for item in own)
    pivot = configuration.pivot(name, state)
    centre = centre_of_mass(tuple(items))
    reference = locate(body, pivot) if pivot is not None else centre
    return Frame(tuple(items), reference, polar(tidy(centre - reference)))


def locate(body: Body, ref: PointRef | None) -> Vector:
    """Place of a point in a body's own axes; of a rim, the place that it has while the body stands as drawn."""
    if ref is None or ref.point in (None, "center"):
        return NOWHERE
    radius = rim_radius(body, ref.point)
    if ref.point in ON_RIM and radius is not None:
        return vector(radius, ON_RIM[ref.point])
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
