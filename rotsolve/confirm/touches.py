"""Touches: what a contact holds: a body stays on a surface, flat or round, which can only push; friction along it.

A rolling contact is one whose friction sticks without end.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import on_rim, part_of, radius_of
from rotsolve.confirm.constraints import Held, Rows, tied_at
from rotsolve.confirm.jet import Jet, arctangent, distance
from rotsolve.confirm.pose import Pair, Pose, along, turned
from rotsolve.confirm.rows import Grip, held
from rotsolve.confirm.sides import from_middle
from rotsolve.confirm.signs import normal, rests, surface_of
from rotsolve.elements.connections.contact import Contact, Rolls
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.shapes import shape_of
from rotsolve.elements.surfaces import Curved
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known


def touch(item: Touch, pose: Pose, model: Known) -> Held:
    """The body stays on the surface, which can only push; friction along it sticks, slips, or is none."""
    surface = surface_of(item, model)
    if isinstance(surface, Curved):
        yield from round_touch(item, surface, pose, model)
        return
    if surface is None:
        raise NotConfirmed(f"`{item.name}` touches nothing that is known")
    ref, under = item.pair()[:2]
    body, out = model.body(ref.owner), normal(surface, model)
    ahead, radius = turned(out, -1), 0.0
    rocks = model.rocking(ref.owner, item)
    wheel = (
        on_rim(body, ref.point)
        or rocks is not None
        or (ref.point in ("bottom", "center") and radius_of(body, None, model.value) is not None)
    )
    if wheel:
        radius = rocks.radius if rocks is not None else radius_of(body, ref.point, model.value) or 0.0
        place = pose.place(ref.owner, model.spot(PointRef(ref.owner, ref.point if part_of(body, ref.point) else None)))
    else:
        place = tied_at(ref, pose, model)
    slip = pose.turn(ref.owner) * radius if radius else Jet(0.0)
    if under.owner in model.seats:
        (x, y), below = back_of(item, under, pose, model)
        place, slip = (place[0] - x, place[1] - y), slip + below
    pushing = held(item.name, "normal", along(place, out), pose, push=True)
    if rocks is not None:
        down = math.atan2(-out[1], -out[0]) - pose.turn(ref.owner).value
        pushing = replace(pushing, edge=rocks.spare(down))
    yield pushing
    if not wheel and rests(item, model):
        yield held(item.name, "torque", pose.turn(ref.owner), pose)
    yield from friction(item, slip + along(place, ahead), pose, model)


def back_of(item: Touch, under: PointRef, pose: Pose, model: Known) -> tuple[Pair, Jet]:
    """Where the body is on which something lies flat, and how far its rim has turned back under that: a roller's goes at R ω besides."""
    body = model.body(under.owner)
    radius = radius_of(body, under.point, model.value) if item.side is None else None
    if radius is not None:
        return pose.place(under.owner, model.spot(PointRef(under.owner))), pose.turn(under.owner) * radius
    if not rests(item, model) or (item.side is None and shape_of(body).points[:1] == ("corner1",)):
        raise NotConfirmed(f"`{item.name}`: the back of `{under.owner}` has a shape of its own")
    return pose.place(under.owner, model.seats[under.owner].rigid.centre), Jet(0.0)


def friction(item: Touch, slip: Jet, pose: Pose, model: Known) -> Held:
    """Along the surface, with that on the right."""
    grip, row = item.grip(), held(item.name, "friction", slip, pose)
    if grip.kind == "any" or isinstance(item, Rolls):
        yield Grip(item.name, row, None, None, (item.name, "normal"))
        if isinstance(item, Rolls) and item.rolling_friction is not None:  # a couple b N, against the turn
            name, ahead = item.rolls[0].owner, model.value(item.rolling_friction)
            couple = held(item.name, "resistance", pose.turn(name), pose)
            yield Grip(f"{item.name}.{name}", couple, ahead, ahead, (item.name, "normal"))
    elif grip.kind == "coefficient":
        sizes = (model.value(size) if size is not None else 0.0 for size in (grip.static, grip.kinetic))
        static, kinetic = sizes
        yield Grip(item.name, row, static, kinetic, (item.name, "normal"))


def round_touch(item: Touch, surface: Curved, pose: Pose, model: Known) -> Held:
    """The centre of a body stays on a circle round that of a curved surface, which is taken as the origin, or of a round body."""
    size = surface.radius()
    if size is None:
        raise NotConfirmed(f"`{surface.name}` is a track whose form is not known")
    ref = item.pair()[0]
    body, outside = model.body(ref.owner), surface.outside
    rim = (
        (radius_of(body, ref.point, model.value) or 0.0)
        if on_rim(body, ref.point) or ref.point in ("center", "bottom")
        else 0.0
    )
    circle = model.value(size) + (rim if outside else -rim)
    x, y = from_middle(item, pose, model)
    away = distance(x, y) - circle
    yield held(item.name, "normal", away if outside else -away, pose, hard=True, push=not surface.two_sided)
    slip = pose.turn(ref.owner) * rim + arctangent(y, x) * (-circle if outside else circle)
    if item.pair()[1].owner in model.seats:  # the rim goes along
        slip = slip + pose.turn(item.pair()[1].owner) * (model.value(size) if outside else -model.value(size))
    yield from friction(item, slip, pose, model)


TOUCHES: dict[type[Connection], Rows] = {Contact: touch, Rolls: touch}
