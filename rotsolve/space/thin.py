"""Thin bodies: a rod has no inertia about its own axis. How it spins about that has no energy and no meaning: its ω is across it.

n with I n = 0 is such an axis: where I has no products one of its own, else square to two rows of I. No body has more than one of them
unless it is a point, since no principal moment is larger than the other two together.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from rotsolve.algebra.formula import ZERO
from rotsolve.core.equation import RULE, Equation
from rotsolve.core.vectors.tensor import displaced
from rotsolve.core.vectors.triple import (
    Rows,
    Triple,
    X,
    Y,
    Z,
    cross_product,
    dot_product,
    minus,
    rotated,
    scaled_by,
    tidied,
    unit_along,
    vector_sum,
    way_between,
)
from rotsolve.core.writing import spoken
from rotsolve.space.arrangement import JointedBodies
from rotsolve.space.inertia import product
from rotsolve.space.moment import SpaceMoment

WORDS = "{} is thin: it does not spin about its own axis"


def thin_axis(held: JointedBodies, name: str) -> Triple | None:
    """The direction, in a body's own axes, through the point about which it turns, about which it has no inertia; None where there is
    none, or nothing tells."""
    tensor = held.whole_tensor(name)
    if tensor is None or held.pointlike(name):
        return None
    tensor = tensor.plus(displaced(held.mass(name), way_between(held.centre(name), held.reference(name))))
    rows: Rows = (
        (tensor.xx, tensor.xy, tensor.zx),
        (tensor.xy, tensor.yy, tensor.yz),
        (tensor.zx, tensor.yz, tensor.zz),
    )
    own = next((way for row, way in zip(rows, (X, Y, Z), strict=True) if all(map(held.vanishes, row))), None)
    if own is not None or not held.vanishes(dot_product(rows[0], cross_product(rows[1], rows[2]))):
        return own
    for one, other in combinations(rows, 2):
        normal = tidied(cross_product(one, other))
        if not all(map(held.vanishes, normal)):
            return tidied(unit_along(normal, held.signs.positive))
    return None


def unspun(moment: SpaceMoment, name: str) -> Iterator[Equation]:
    """n · ω = 0 and n · ω̇ = 0 of a thin body, where no line of the state tells how it spins."""
    joint, held = moment.held.main(name), moment.held
    if (joint is not None and not joint.free) or len(held.of_body(name)) > len(held.supports(name)):
        return
    open_rates = moment.left_open(name)
    if not any(open_rates):
        return
    way = thin_axis(moment.held, name)
    if way is None:
        return
    own = moment.attitude(name)
    along = rotated(own.own, way)
    if turns_others(moment, name, along):
        return
    for rates, is_open in zip((own.omega, own.rates), open_rates, strict=True):
        part = dot_product(along, rates)
        if is_open and part.symbols():
            yield RULE.equation(part, ZERO, moment.when, (name,), words=WORDS.format(spoken(name)))


def turns_others(moment: SpaceMoment, name: str, way: Triple) -> bool:
    """Whether a body that turns about a direction through the point about which it turns takes along what it carries: what is off that
    line, or is turned with it and has inertia about that."""
    held, axes = moment.held, moment.axes(name)
    for joint in (joint for joint in held.joints if joint.carrier.owner == name and not (joint.rolls or joint.flat)):
        other = joint.body.owner
        if not all(map(held.vanishes, cross_product(way, moment.carried_at(joint)))):
            return True
        if joint.free or held.pointlike(other):
            continue
        own, turned = moment.own_axes(other), way
        if joint.turning:
            axis = moment.direction(other, joint)
            axis = moment.own_axes(name).to(axes, axis) if joint.aligned and held.wheel(other) else own.to(axes, axis)
            turned = vector_sum(way, minus(scaled_by(dot_product(way, axis), axis)))
        tensor, arm = held.whole_tensor(other), way_between(held.centre(other), held.spot(joint.body))
        whole = None if tensor is None else tensor.plus(displaced(held.mass(other), arm))
        turned = axes.to(own, turned)
        if not all(map(held.vanishes, turned)) and (
            whole is None or not all(map(held.vanishes, product(whole, turned)))
        ):
            return True
    return False
