"""Summit: the highest place of a body on a hinge, which it may have to pass on its way from one angle to another.

h = h_c + R cos δ of its centre of mass above the hinge, δ from the highest place, R sin δ = −h′.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import HALF, ONE, PI, ZERO, Formula, Number, add, call, multiply, negate, sqrt
from rotsolve.core.facts import square
from rotsolve.core.vectors.triple import NOTHING, cross_product, dot_product
from rotsolve.language.bodies import PointRef
from rotsolve.space.energies import kinetic_energies
from rotsolve.space.inertia import CM
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.passing import left_alone

Side = Callable[[Formula], "int | None"]


class Summit(Struct, frozen=True):
    """How many turns a body is from its highest place at both ends of its way, the kinetic energy that it would have there, and the rate
    at which it sets out."""

    start: Formula
    end: Formula
    left: Formula
    rate: Formula


def summit_of(name: str, before: SpaceLaws, after: SpaceLaws, side: Side) -> Summit | None:
    """The highest place of a body that swings on a hinge of the ground, with what tells signs; None where it is not told how it stands."""
    moment, gravity = before.moment, before.pushes.gravity
    joint = moment.held.main(name)
    if (
        joint is None
        or not joint.turning
        or gravity is None
        or not before.fixed(name)
        or not swings_alone(name, before)
    ):
        return None
    angles = [laws.moment.stood(name, "angle") for laws in (before, after)]
    if angles[0] is None or angles[1] is None:
        return None
    arm, way, up = moment.arm(PointRef(name, CM)), moment.direction(name, joint), moment.up(name)
    height = simplify(add(dot_product(up, arm), negate(multiply(dot_product(up, way), dot_product(way, arm)))))
    rise = simplify(dot_product(up, cross_product(way, arm)))
    if moment.held.vanishes(height) and moment.held.vanishes(rise):
        return None  # it lies as high all round
    most = moment.tidy(sqrt(add(square(height), square(rise))))
    first = turns_from_top(height, rise, side)
    last = first + (angles[1] - angles[0]) / (2 * PI)
    weight = multiply(moment.held.mass(name), gravity)
    left = add(add(*kinetic_energies(before, name)), multiply(weight, add(height, negate(most))))
    return Summit(first, last, left, moment.driven(name, joint, "angular_velocity")[0])


def swings_alone(name: str, before: SpaceLaws) -> bool:
    """Whether nothing but its weight turns a body about its hinge: couples across its axis do not."""
    moment, joint = before.moment, before.moment.held.main(name)
    if joint is None or not left_alone(before, name, pushed=True):
        return False
    way, acting = moment.direction(name, joint), {action.name for action in before.pushes.actions}
    own = [push for push in before.pushes.on(name) if push.owner in acting]
    couples = (push.axes.to(push.own, push.couple) for push in own)
    return all(push.force == NOTHING for push in own) and all(
        moment.held.vanishes(dot_product(way, one)) for one in couples
    )


def stays_put(name: str, before: SpaceLaws, side: Side) -> bool:
    """Whether a body on a hinge of the ground is at rest in its highest or lowest place, or has no weight, and nothing else acts on it."""
    moment = before.moment
    joint = moment.held.main(name)
    if joint is None or not joint.turning or not (before.fixed(name) and left_alone(before, name)):
        return False
    if moment.stood(name, "angle") is None:
        return False
    arm, way, up = moment.arm(PointRef(name, CM)), moment.direction(name, joint), moment.up(name)
    push = ZERO if before.pushes.gravity is None else simplify(dot_product(up, cross_product(way, arm)))
    rate = moment.driven(name, joint, "angular_velocity")[0]
    return all(part == ZERO or side(part) == 0 for part in (rate, push))


def stays_upright(name: str, before: SpaceLaws, side: Side) -> bool:
    """Whether a body held at a fixed point is upright, with its axis at rest, and nothing but its weight acts on it, above or below."""
    moment = before.moment
    tilt, rate = moment.told(name, "tilt"), moment.told(name, "nutation")
    if tilt is None or rate is None or not (before.fixed(name) and left_alone(before, name)):
        return False
    across = cross_product(moment.up(name), moment.arm(PointRef(name, CM)))
    return all(part == ZERO or side(part) == 0 for part in (call("sin", tilt), rate, *map(simplify, across)))


def turns_from_top(height: Formula, rise: Formula, side: Side) -> Formula:
    """δ in turns, as plainly as the signs of R cos δ and h′ allow."""
    across, along = (0 if value == ZERO else side(value) for value in (height, rise))
    if along == 0 and across:
        return ZERO if across > 0 else HALF
    if across == 0 and along:
        return Number(Fraction(-along, 4))
    slope = ONE if ZERO in (height, rise) else simplify(rise / height)
    if across and not slope.symbols():
        return call("atan", negate(slope)) / (2 * PI) + (ZERO if across > 0 else HALF)
    return call("atan2", negate(rise), height) / (2 * PI)
