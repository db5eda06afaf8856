"""Couplings: what few scenes have: prescribed motions, belts, gears, clutches, rims, riders, ropes, shafts; springs hold nothing."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Number
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.carried import draping, riding, whirling
from rotsolve.confirm.constraints import Held, place_of, prescribed
from rotsolve.confirm.faces import laid, plates
from rotsolve.confirm.jet import Jet, arctangent, cosine, distance, sine
from rotsolve.confirm.leaning import leaning_rows
from rotsolve.confirm.pose import Pose, Way, along, load, turned
from rotsolve.confirm.rows import Grip, Row, held, unknown
from rotsolve.confirm.signs import RIGHT, UP, pointing
from rotsolve.core.drive import TRAVELLING, TURNING
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known
    from rotsolve.elements.connections.drives import Belt, Gear, Guide, MutualDrive
    from rotsolve.elements.connections.rubbing import Clutch, Rims
    from rotsolve.elements.connections.slots import PinSlot


def nothing(item: Connection, pose: Pose, model: Known) -> Held:
    """Of what only pushes or pulls."""
    return iter(())


def guide(item: Guide, pose: Pose, model: Known) -> Held:
    """The keys of a body that prescribe its own motion: of its centre of mass, and its turn."""
    name = item.guided[0].owner
    centre = pose.place(name, model.seats[name].rigid.centre)
    mass = Number(Fraction(model.seats[name].rigid.mass))
    motions = [
        ("velocity", axis, told / mass) if word == "momentum" else (word, axis, told)
        for word, axis, told in item.motions
    ]
    ordered = sorted(motions, key=lambda motion: (*TURNING, *TRAVELLING).index(motion[0]))
    last = {
        component: word for word, component, _ in ordered
    }  # of several words the highest rate tells the acceleration
    for word, component, value in ordered:
        if word in TURNING:
            sign, coordinate, order = 1 if word == "angle" else model.sense(name), pose.turn(name), TURNING.index(word)
        else:
            sign, coordinate, order = 1, centre["xy".index(component or "x")], TRAVELLING.index(word)
        row = prescribed(item.name, component or "torque", coordinate, order, sign, value, pose, model)
        yield row if last[component] == word else replace(row, kind=f"{word}{component}", bend=None)


def led_by_inertia(owner: str, name: str, word: str, value: Formula, pose: Pose, model: Known) -> Row:
    """A rate that a given L or K of all that turns about an axis tells: L = ω Σ (I + m d²), K = ½ ω² Σ (I + m d²)."""
    target, turn, sense = model.running(value, pose), pose.turn(name), model.sense(name)
    told = target if isinstance(target, Jet) else Jet(target)
    inertia = sum(about_axis_of(name, other, pose, model) for other in model.joined_to(name))
    if word == "angular_momentum":
        rate, faster = told.value / inertia, told.rate / inertia
    else:
        if told.value < 0.0:
            raise NotConfirmed(f"`{name}` would have less than no kinetic energy")
        rate = math.sqrt(2.0 * told.value / inertia)
        if rate == 0.0 and told.rate != 0.0:
            raise NotConfirmed(f"the torque on `{name}` has no bounds where it starts")
        faster = (
            told.rate / (inertia * rate) if rate else math.sqrt(max(told.bend / inertia, 0.0))
        )  # K = ½ K̈ t² from rest on
    return Row(owner, f"torque_{name}", turn.slope, sense * rate, sense * faster - turn.bend, turn.slope)


def about_axis_of(name: str, other: str, pose: Pose, model: Known) -> float:
    """I + m d² of a body about the axis of another one with which it is joined."""
    rigid = model.seats[other].rigid
    (x, y), (u, w) = pose.place(name, model.axis(name)), pose.place(other, rigid.centre)
    return rigid.inertia + rigid.mass * ((x.value - u.value) ** 2 + (y.value - w.value) ** 2)


def belt(item: Belt, pose: Pose, model: Known) -> Held:
    for number, pair in enumerate(pairwise(item.belt), 1):
        kind = "force" if len(item.belt) == 2 else f"force{number}"
        yield from meshed(item.name, kind, pair, -1 if item.crossed else 1, None, pose, model)


def gear(item: Gear, pose: Pose, model: Known) -> Held:
    yield from meshed(item.name, "force", item.gear, 1 if item.inside else -1, item.inside, pose, model)


def meshed(
    owner: str, kind: str, pair: tuple[PointRef, ...], way: int, inside: bool | None, pose: Pose, model: Known
) -> Held:
    """Rims run equally fast as seen from the line of centres: R₂ (ω₂ − φ̇) = ± R₁ (ω₁ − φ̇), φ the angle of that line."""
    radii = [radius_of(model.body(ref.owner), ref.point, model.value) or 0.0 for ref in pair]
    turns = [pose.turn(ref.owner) for ref in pair]
    (x, y), (u, w) = (pose.place(ref.owner, model.spot(ref)) for ref in pair)
    gap = u - x, w - y
    if all(ref.owner in model.held for ref in pair):
        turning = turns[1] * radii[1] - turns[0] * (way * radii[0])
        if inside is None:  # where the axles of a belt are to each other the scene does not say
            for axis, direction in (("x", RIGHT), ("y", UP)):
                yield unknown(owner, f"press_{axis}{kind}", load(gap, direction))
            yield held(owner, kind, turning, pose)
        else:  # of wheels in gear the second stands on the right
            side = 1.0 if inside else -1.0
            yield held(owner, kind, turning + gap[1] * side, pose)
        return
    if inside is not None:
        apart = abs(radii[0] - radii[1]) if inside else radii[0] + radii[1]
        apart_row = held(owner, f"apart{kind}", distance(*gap) - apart, pose, hard=True)
        yield replace(apart_row, loose=True)
    line = arctangent(gap[1], gap[0])
    yield held(owner, kind, (turns[1] - line) * radii[1] - (turns[0] - line) * (way * radii[0]), pose)


def mutual(item: MutualDrive, pose: Pose, model: Known) -> Held:
    """A torque that nobody tells is as large as it likes."""
    if item.couple is None:
        first, second = (model.seats[ref.owner].turn for ref in item.drives)
        yield unknown(item.name, "torque", {second: 1.0, first: -1.0})


def clutch(item: Clutch, pose: Pose, model: Known) -> Held:
    first, second = (pose.turn(ref.owner) for ref in item.clutch)
    if item.friction_torque is not None:
        size = model.value(item.friction_torque)
    else:
        if item.press is None or item.friction is None:
            raise NotConfirmed(f"nothing tells the torque of `{item.name}`")
        size = plates(item, model)
    yield Grip(item.name, held(item.name, "torque", second - first, pose), size, size)


def rims(item: Rims, pose: Pose, model: Known) -> Held:
    """The rims of two wheels side by side, the second on the right of the first."""
    first, second = item.wheels
    radii = [radius_of(model.body(ref.owner), ref.point, model.value) or 0.0 for ref in item.wheels]
    (_, y), (_, w) = (pose.place(ref.owner, (0.0, 0.0)) for ref in item.wheels)
    slip = (w - pose.turn(second.owner) * radii[1]) - (y + pose.turn(first.owner) * radii[0])
    row, press, rough = held(item.name, "friction", slip, pose), model.value(item.press), item.friction
    if rough.kind == "any":
        yield Grip(item.name, row, None, None)
    elif rough.kind == "coefficient":
        static, kinetic = (
            press * model.value(size) if size is not None else 0.0 for size in (rough.static, rough.kinetic)
        )
        yield Grip(item.name, row, static, kinetic)


def slotted(item: PinSlot, pose: Pose, model: Known) -> Held:
    """A pin stays on the line of its slot, which goes with the body that has it; in a slot that turns it is where that says at first."""
    x, y = place_of(item.pin, pose, model)
    name = item.within.owner
    if name not in model.seats:
        yield held(item.name, "across", along((x, y), turned(slot_way(item, model))), pose)
        return
    u, w = place_of(item.within, pose, model)
    x, y = x - u, y - w
    if item.along is not None:
        yield held(item.name, "across", along((x, y), turned(slot_way(item, model))), pose)
        return
    turn = pose.turn(name) + model.lean(name)
    c, s = cosine(turn), sine(turn)
    yield held(item.name, "across", y * c - x * s, pose, hard=True)
    yield replace(held(item.name, "along", x * c + y * s, pose, hard=True), loose=True)


def slot_way(item: PinSlot, model: Known) -> Way:
    """The direction of a slot that does not turn."""
    if item.along is None:
        raise NotConfirmed(f"nothing tells how the slot of `{item.name}` runs")
    return pointing(item.along, model)


COUPLINGS: dict[str, Callable[[Any, Pose, Known], Held]] = {
    "connections.drives.Guide": guide,
    "connections.springs.Spring": nothing,
    "connections.springs.Torsion": nothing,
    "connections.drives.Belt": belt,
    "connections.drives.Gear": gear,
    "connections.drives.MutualDrive": mutual,
    "connections.rubbing.Clutch": clutch,
    "connections.flat.Laid": laid,
    "connections.rubbing.Rims": rims,
    "connections.supports.Rides": riding,
    "connections.drapes.Drapes": draping,
    "connections.supports.Shaft": whirling,
    "connections.slots.PinSlot": slotted,
    "connections.leaning.Leans": leaning_rows,
}
