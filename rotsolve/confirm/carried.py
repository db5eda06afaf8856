"""Carried: what rides on a body that turns, hangs as a heavy rope, or is whirled round with an upright shaft."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, Formula
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import frame, radius_of, spread
from rotsolve.confirm.jet import Jet, Slope, cosine, sine
from rotsolve.confirm.pose import Pose
from rotsolve.confirm.rows import Grip, Row, held, unknown
from rotsolve.elements.connections.supports import Rides, Shaft
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body, Part

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known
    from rotsolve.elements.connections.drapes import Drapes

Held = Iterator[Row | Grip]


def riding(item: Rides, pose: Pose, model: Known) -> Held:
    """A rider turns with what carries it: held at its distance from the axis, or free to slide along."""
    rider, carrier = item.rides
    axis = pose.place(carrier.owner, model.axis(carrier.owner))
    if item.ride().free:
        x, y = pose.place(rider.owner, model.seats[rider.owner].rigid.centre)
        turn = pose.turn(carrier.owner)
        yield held(item.name, "across", (y - axis[1]) * cosine(turn) - (x - axis[0]) * sine(turn), pose, hard=True)
    else:
        x, y = pose.place(rider.owner, (0.0, 0.0))
        most = most_that_holds(item, model)
        yield replace(held(item.name, "x", x - axis[0], pose), most=most)
        yield replace(held(item.name, "y", y - axis[1], pose), most=most)
    yield held(item.name, "torque", pose.turn(rider.owner) - pose.turn(carrier.owner), pose, hard=True)
    if model.body(rider.owner).count > 1 and item.ride().free:  # what several press on the axis cancels
        first = model.seats[carrier.owner].first
        yield unknown(item.name, "press_x", {first: 1.0})
        yield unknown(item.name, "press_y", {first + 1: 1.0})


def most_that_holds(item: Rides, model: Known) -> float | None:
    """The largest friction of what lies on a body seen from above, μ m g; None where nothing limits it."""
    rough, gravity = item.friction, model.problem.gravity
    if rough is None or rough.static is None or gravity is None:
        return None
    return model.value(rough.static) * model.seats[item.rides[0].owner].rigid.mass * model.value(gravity)


def forward(item: Drapes, model: Known) -> float:
    """+1 where a rope runs down on the right."""
    return -1.0 if model.body(item.drapes[0].owner).moves == "left" else 1.0


def draping(item: Drapes, pose: Pose, model: Known) -> Held:
    """All of a rope has one speed, that of the rim, and of what is tied to its end."""
    rope, over = item.drapes[0].owner, item.drapes[1]
    x, y = pose.place(rope, (0.0, 0.0))
    yield held(item.name, "line", y, pose)
    yield held(item.name, "turn", pose.turn(rope), pose)
    if over.owner in model.seats:
        radius = radius_of(model.body(over.owner), over.point, model.value) or 0.0
        yield held(item.name, "force", x + pose.turn(over.owner) * radius, pose)
        first = model.seats[over.owner].first
        yield unknown(item.name, "press_x", {first: 1.0})
        yield unknown(item.name, "press_y", {first + 1: 1.0})
    for load in item.drapes[2:]:
        _, down = pose.place(load.owner, model.seats[load.owner].rigid.centre)
        yield held(item.name, "tension", down + x * forward(item, model), pose, push=True)


def hanging(item: Drapes, pose: Pose, model: Known) -> Jet:
    """The length that hangs down on the side of its travel, but for a constant."""
    return pose.place(item.drapes[0].owner, (0.0, 0.0))[0] * forward(item, model)


def rope_weight(item: Drapes, pose: Pose, model: Known) -> Iterator[tuple[str, Slope]]:
    """λ g (b − a) along the rope, b and a what hangs on either side."""
    rope, over = model.body(item.drapes[0].owner), item.drapes[1]
    whole: Formula | None = getattr(shape_of(rope), "length", None)
    start = pose.offsets.get(item.name)
    if whole is None or start is None:
        raise NotConfirmed(f"nothing tells how much of `{rope.name}` hangs down")
    length = model.value(whole)
    down = hanging(item, pose, model).value + start
    other = 0.0
    if not item.wound and over.owner in model.seats:
        other = length - down - math.pi * (radius_of(model.body(over.owner), over.point, model.value) or 0.0)
    elif not item.wound and over.owner == "ground":
        other = length - down
    pull = model.seats[rope.name].rigid.mass * model.gravity * (down - other) / length
    yield item.name, {model.seats[rope.name].first: pull * forward(item, model)}


def whirling(item: Shaft, pose: Pose, model: Known) -> Held:
    """A point stays at its distance from the axis, in the plane that turns."""
    x, y = pose.place(item.shaft[0].owner, model.drawn(item.shaft[0]))
    distance = model.value(item.distance) if item.distance is not None else 0.0
    yield held(item.name, "x", x - distance, pose, hard=True)
    yield held(item.name, "y", y, pose, hard=True)


def whirled(model: Known) -> dict[str, float]:
    """By body that goes round with a shaft: the angular velocity of that."""
    found = {
        item.shaft[0].owner: model.value(item.turning)
        for item in model.acting.connections
        if isinstance(item, Shaft) and item.turning is not None
    }
    pairs = [*model.unions]
    pairs += [(refs[0].owner, refs[1].owner) for item in model.acting.connections if len(refs := item.joint()) == 2]
    for _ in pairs if found else ():
        for one, two in pairs:
            for here, there in ((one, two), (two, one)):
                if here in found and there not in found:
                    found[there] = found[here]
    return found


def centrifugal(item: Shaft, pose: Pose, model: Known) -> Iterator[tuple[str, Slope]]:
    """ω² x on every piece at x from the axis: m ω² x of the centre of mass, and the couple −ω² ∫ x y dm about it."""
    for name, rate in whirled(model).items():
        if item.turning is None or rate != model.value(item.turning):
            continue
        rigid, first = model.seats[name].rigid, model.seats[name].first
        a, b, product = second_moments(rigid.body, rigid.centre, model)
        angle = pose.q[first + 2]
        c, s = math.cos(angle), math.sin(angle)
        twist = c * s * (a - b) + (c * c - s * s) * product
        yield f"whirl of {name}", {first: rigid.mass * rate**2 * pose.q[first], first + 2: -(rate**2) * twist}


def about_shaft(name: str, model: Known, pose: Pose) -> float:
    """∫ (x² + z²) dm of a body, x from the axis of the shaft and z out of the picture."""
    rigid = model.seats[name].rigid
    if rigid.body.parts or rigid.body.mass is None:
        raise NotConfirmed(f"how the mass of `{name}` lies about the shaft is not told")
    a, b, product = second_moments(rigid.body, rigid.centre, model)
    angle, x = pose.q[model.seats[name].first + 2], pose.q[model.seats[name].first]
    c, s = math.cos(angle), math.sin(angle)
    tensor, mass = shape_of(rigid.body).tensor(ONE), model.value(rigid.body.mass)
    deep = mass * model.value(tensor.entry("xx") + tensor.entry("yy") - tensor.entry("zz")) / 2
    return c * c * a + s * s * b - 2 * c * s * product + deep + rigid.mass * x**2


def second_moments(body: Body, centre: tuple[float, float], model: Known) -> tuple[float, float, float]:
    """∫ u², ∫ w², ∫ u w over the mass of a body about its centre of mass, along its own axes."""
    total = own_moments(body, model)
    x, y = centre
    mass = model.seats[body.name].rigid.mass
    return total[0] - mass * x * x, total[1] - mass * y * y, total[2] - mass * x * y


def own_moments(body: Body, model: Known) -> tuple[float, float, float]:
    """The same about the origin of a body's axes."""
    if body.holes or body.inertia is not None or body.gyration is not None or body.count > 1:
        raise NotConfirmed(f"how the mass of `{body.name}` lies in the plane of the shaft is not told")
    totals = (0.0, 0.0, 0.0)
    if body.mass is not None:
        shape, mass = shape_of(body), model.value(body.mass)
        tensor = shape.tensor(ONE)
        xx, yy, zz, xy = (mass * model.value(tensor.entry(entry)) for entry in ("xx", "yy", "zz", "xy"))
        x, y = (model.value(part) for part in shape.centroid())
        totals = (yy + zz - xx) / 2 + mass * x * x, (xx + zz - yy) / 2 + mass * y * y, -xy + mass * x * y
    for part in body.parts:
        totals = added(totals, moved(part, own_moments(part.body, model), model))
    return totals


def added(one: tuple[float, float, float], two: tuple[float, float, float]) -> tuple[float, float, float]:
    return one[0] + two[0], one[1] + two[1], one[2] + two[2]


def moved(part: Part, own: tuple[float, float, float], model: Known) -> tuple[float, float, float]:
    """A part's second moments in the axes of the whole: turned, then shifted."""
    (u, w), turn = frame(part, model.value)
    mass = spread(part.body, model.value)
    a, b, p = own
    c, s = math.cos(turn), math.sin(turn)
    x, y = c * mass.x - s * mass.y, s * mass.x + c * mass.y
    return (
        c * c * a + s * s * b - 2 * c * s * p + 2 * u * x + mass.whole * u * u,
        s * s * a + c * c * b + 2 * c * s * p + 2 * w * y + mass.whole * w * w,
        c * s * (a - b) + (c * c - s * s) * p + u * y + w * x + mass.whole * u * w,
    )
