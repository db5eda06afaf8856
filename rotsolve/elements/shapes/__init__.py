"""Shapes of bodies: how mass is spread, the shape of a body, and the radius at which strings, belts and surfaces touch a round one."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.elements.shapes.thin import Particle as Particle
from rotsolve.language.bodies import Body, Part, PointRef
from rotsolve.language.shape import WHEEL as WHEEL
from rotsolve.language.shape import Bow as Bow
from rotsolve.language.shape import Place as Place
from rotsolve.language.shape import Shape as Shape

if TYPE_CHECKING:
    from rotsolve.language.elements import Surroundings

PARTICLE = Particle()


def shape_of(body: Body) -> Shape:
    """The shape of a body; one without a shape is a particle."""
    return body.shape or PARTICLE


def ends_at(body: Body, ref: PointRef) -> bool:
    """Whether a point of a slender body is one of its ends."""
    whole = shape_of(body).reach()
    return whole is not None and ZERO in (
        simplify(whole / 2 - abscissa_of(body, ref)),
        simplify(whole / 2 + abscissa_of(body, ref)),
    )


def room_from(body: Body, ref: PointRef) -> Formula | None:
    """How far a body goes on from an axis through one of its points: to the end of what is slender, to the rim of what is round."""
    shape = shape_of(body)
    whole = shape.reach()
    return simplify(whole / 2 - abscissa_of(body, ref)) if whole is not None else shape.outer if shape.round else None


def abscissa_of(body: Body, ref: PointRef) -> Formula:
    """The x of a point in the body's axes."""
    named = dict(body.points).get(ref.point or "")
    return (named or shape_of(body).locate(ref.point or "center", ref.argument))[0]


def rims(body: Body) -> dict[str, Formula]:
    """The named rims of a body with their radii: those of `radii`, its own or its shape's, about its centre."""
    return {**dict(getattr(shape_of(body), "radii", ())), **dict(body.radii)}


def fixed_in(ref: PointRef, body: Body) -> PointRef:
    """A point that turns with a body: for a place on its rim, whose names are directions in space, its centre."""
    on_rim = rim_radius(body, ref.point) is not None and (ref.point in WHEEL or ref.point in rims(body))
    return PointRef(ref.owner, "center") if on_rim else ref


def taken_round(refs: Iterable[PointRef], scene: Surroundings, state: str) -> tuple[str, ...]:
    """The bodies that take some points with them round those about which they turn at a state."""
    places = (fixed_in(ref, scene.bodies[ref.owner]) for ref in refs if ref.owner in scene.bodies)
    return tuple(scene.host(ref.owner, state) for ref in places if scene.swings_round(ref, state))


def round_part(body: Body, point: str | None) -> Part | None:
    """The part of a body that a point names, where it has a rim of its own."""
    part = next((part for part in body.parts if part.body.name == point), None)
    return part if part is not None and rim_radius(part.body, None) is not None else None


def bow_of(body: Body, point: str | None) -> Bow | None:
    """The bow with which a body, or the part of it that a point names, rocks on what it lies on, in its own axes; None of a whole rim."""
    part = rolling_part(body, point)
    own = shape_of(body if part is None else part.body).bow() if part is not None or point is None else None
    turn = ZERO if part is None or part.angle is None else part.angle
    return None if own is None else Bow(own.radius, own.first + turn, own.last + turn)


def rolling_part(body: Body, point: str | None) -> Part | None:
    """The part of a body that a point names, where it has a rim or a bow of its own."""
    part = next((part for part in body.parts if part.body.name == point), None)
    return part if part is not None and touching_radius(part.body, None) is not None else None


def touching_radius(body: Body, point: str | None) -> Formula | None:
    """The radius with which a body touches a floor: that of a rim, or of a bow."""
    bow = bow_of(body, point)
    return rim_radius(body, point) if bow is None else bow.radius


def rolling_shape(body: Body, point: str | None) -> Shape | None:
    """The shape with which a body rolls: of a part that a point names, else its own; a body without one that has an `axis` is a wheel.

    None where nothing tells: what has only a `radius`, or a sphere among its parts, may be a wheel or a ball.
    """
    part = round_part(body, point)
    shape = shape_of(body if part is None else part.body)
    untold = not body.axis or any(shape_of(one.body).spherical for one in body.parts)
    return None if shape == PARTICLE and part is None and untold else shape


def rivals(body: Body, point: str | None) -> tuple[str, ...]:
    """The named rims between which a point leaves the choice: of a body with several and no radius of its own, where it names none."""
    part = next((part for part in body.parts if part.body.name == point), None)
    if part is not None:
        return rivals(part.body, None)
    told = shape_of(body).outer is not None or body.radius is not None or point in rims(body)
    return () if told or point not in (None, "rim", "top", "bottom") or len(body.radii) < 2 else tuple(rims(body))


def rim_radius(body: Body, point: str | None) -> Formula | None:
    """Radius of the rim that a point names: a name of `radii` or a round part, else the shape's, else that of a drum (see `rivals`)."""
    if point is not None:
        named, part = rims(body), round_part(body, point)
        if point in named:
            return named[point]
        if part is not None:
            return rim_radius(part.body, None)
    shape = shape_of(body)
    if shape.outer is not None:
        return shape.outer
    if body.radius is not None:
        return body.radius
    return body.radii[-1][1] if body.radii else None
