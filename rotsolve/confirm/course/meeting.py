"""Meeting: who has bounced off whom, and how far apart they are from then on: along the line of both, or across a rod that turns."""

from __future__ import annotations

import math
from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import on_rim
from rotsolve.confirm.course.node import Node
from rotsolve.confirm.instant import Met
from rotsolve.confirm.lines import bent, circle_of
from rotsolve.confirm.model import Model
from rotsolve.confirm.pose import Pose, Way, along
from rotsolve.confirm.signs import GROUND, normal
from rotsolve.elements.collisions import Bounces, Collides
from rotsolve.elements.events import Leaves
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Event

THROUGH = 1e-9  # share of the speed of approach above which two go on to approach each other
ROD = ("start", "end")


def met_through(before: Node, event: Event, model: Model, after: Pose) -> tuple[Met, ...]:
    """Who has met up to an event and may not go through each other; a later blow of theirs counts anew."""
    known = before.placed.met
    for item in event.each():
        known = met_in(item, known, before, model, after)
    return known


def met_in(event: Event, known: tuple[Met, ...], before: Node, model: Model, after: Pose) -> tuple[Met, ...]:
    """Those who had met, and who meet in one event."""
    if isinstance(event, Leaves):
        return (*known, *left_hollows(before, event, model))
    if not isinstance(event, Collides):
        return known
    pair = event.collides[0], event.collides[1]
    fixed = event if isinstance(event, Bounces) else None
    found = met_fixed(before, fixed, model) if fixed else met_on_line(before, pair, model, after)
    anew = ({ref.owner for ref in pair}, set(found.pair) if found is not None else set())
    kept = tuple(met for met in known if set(met.pair) not in anew)
    return kept if found is None else (*kept, found)


def left_hollows(before: Node, event: Leaves, model: Model) -> Iterator[Met]:
    """What leaves the inside of a bowl or loop, which is still there: its centre stays within the circle on which it went."""
    for item in before.model.acting.connections:
        found = bent(item.lying(), before.model) if item.name in event.removes else None
        if found is not None and not found[1].outside:
            pair = item.lying(), found[1].name
            yield Met(pair, (0.0, 0.0), 0.0, hollow=circle_of(found, before.model))


def met_fixed(before: Node, event: Bounces, model: Model) -> Met | None:
    """What has bounced off something fixed, its centre in front of that from then on; None of what may touch it with another point."""
    name, body = event.struck.owner, model.body(event.struck.owner)
    if event.surface is not None and event.against.owner not in GROUND:
        out = normal(event.surface, model)
    elif event.surface is not None:
        out = (0.0, -1.0)
    else:
        way, place = model.way(name), before.pose.place(name, model.seats[name].rigid.centre)
        coming = 0.0 if way is None else along(place, way).rate
        if way is None or not coming:
            return None
        out = (-way[0], -way[1]) if coming > 0.0 else way
    plain = event.struck.point is None and (on_rim(body, None) or shape_of(body).pointlike)
    if not plain and model.turns(name):
        return None
    met = Met((name, event.against.owner), (-out[0], -out[1]), 0.0)
    return replace(met, apart=gap_of(met, before.pose)[0])


def met_on_line(before: Node, pair: tuple[PointRef, PointRef], model: Model, after: Pose) -> Met | None:
    """Two that stay on one line, or a rod and what flies against it; None of others.

    By the speeds afterwards one may have gone through the other, as a bullet does, if not both lie on something.
    """
    one, other = (ref.owner for ref in pair)
    ways = [model.way(name) if name in model.seats else None for name in (one, other)]
    if ways[0] is None or ways[1] is None or abs(ways[0][0] * ways[1][1] - ways[0][1] * ways[1][0]) > 1e-9:
        rods = [(ref, rod) for ref in pair if (rod := rod_of(ref, model))]
        return met_rod(pair, rods[0], model, (before.pose, after)) if len(rods) == 1 else None
    way, lying = ways[0], {item.lying() for item in before.model.acting.connections}
    met = Met((one, other), way, 0.0)
    closing, parting = (-gap_of(met, pose)[1] for pose in (before.pose, after))
    if closing == 0.0:
        return None
    through = parting * closing > THROUGH * closing**2 and not lying.issuperset({one, other})
    met = replace(met, way=way if (closing > 0.0) != through else (-way[0], -way[1]))
    return replace(met, apart=gap_of(met, before.pose)[0])


def rod_of(ref: PointRef, model: Model) -> str:
    """The rod that is hit at a point, its own or that of a body that it is welded to; "" where it is none."""
    names = (ref.owner, *model.joined_to(ref.owner)) if ref.owner in model.seats else ()
    return next((name for name in names if shape_of(model.body(name)).slender), "")


def met_rod(
    pair: tuple[PointRef, PointRef], hit: tuple[PointRef, str], model: Model, poses: tuple[Pose, Pose]
) -> Met | None:
    """A rod that is hit at a point, and what has hit it: that stays on its side of it as long as it is beside it."""
    spot, rod = hit
    ball = pair[0] if spot is pair[1] else pair[1]
    if ball.owner not in model.seats:
        return None
    try:
        ends = tuple(model.drawn(PointRef(rod, end)) for end in ROD)
    except NotConfirmed:
        return None
    met = Met((ball.owner, rod), (0.0, 1.0), 0.0, (ends[0], ends[1]), brought_to(spot, ball, model, poses[1]))
    closing, parting = (-gap_of(met, pose)[1] for pose in poses)
    if closing == 0.0:
        return None
    through = parting * closing > THROUGH * closing**2
    met = replace(met, way=(0.0, 1.0 if (closing > 0.0) != through else -1.0))
    return replace(met, apart=gap_of(met, poses[1])[0])


def brought_to(spot: PointRef, ball: PointRef, model: Model, pose: Pose) -> Way:
    """From the point with which a body hits a rod to the point that it hits."""
    (x, y), (u, w) = (
        pose.place(ref.owner, model.meeting(ref, pose.q[model.seats[ref.owner].turn])) for ref in (ball, spot)
    )
    return u.value - x.value, w.value - y.value


def gap_of(met: Met, pose: Pose) -> tuple[float, float]:
    """How far the second of two is ahead of the first, and how fast that grows, whatever they were apart as they met."""
    if met.rod is not None:
        return beside_rod(met, pose)[1:]
    if met.hollow is not None:
        x, y = pose.place(met.pair[0], pose.seats[met.pair[0]].rigid.centre)
        far = math.hypot(x.value, y.value)
        return met.hollow - far, -(x.value * x.rate + y.value * y.rate) / (far or 1.0)
    if met.pair[1] not in pose.seats:
        gap = -along(pose.place(met.pair[0], pose.seats[met.pair[0]].rigid.centre), met.way)
        return gap.value, gap.rate
    (x, y), (ahead, above) = (pose.place(name, (0.0, 0.0)) for name in met.pair)
    gap = (ahead - x) * met.way[0] + (above - y) * met.way[1]
    return gap.value, gap.rate


def beside_rod(met: Met, pose: Pose) -> tuple[float, float, float]:
    """How far a body is beyond the nearer end of a rod, along it; how far the rod is ahead of it across that, and how fast that grows."""
    assert met.rod is not None
    name, rod = met.pair
    start, end = (pose.place(rod, spot) for spot in met.rod)
    x, y = (place + by for place, by in zip(pose.place(name, pose.seats[name].rigid.centre), met.shift, strict=True))
    length = math.dist(*met.rod)
    way: tuple[float, float] = ((end[0].value - start[0].value) / length, (end[1].value - start[1].value) / length)
    across = ((end[0] - start[0]) * (y - start[1]) - (end[1] - start[1]) * (x - start[0])) * (-met.way[1] / length)
    along = (x.value - start[0].value) * way[0] + (y.value - start[1].value) * way[1]
    return max(-along, along - length), across.value, across.rate


def clearance(met: Met, pose: Pose) -> float:
    """How far two are apart that have bounced off each other; negative where they have gone through each other."""
    gap = gap_of(met, pose)[0] - met.apart
    beyond = 0.0 if met.rod is None else beside_rod(met, pose)[0]
    return gap if beyond <= 0.0 else math.hypot(gap, beyond)
