"""Leaned: a rod on an edge, on the corner of a body or on something round, which is drawn where the rod touches it."""

from __future__ import annotations

import math
from typing import cast

from rotsolve.confirm.leaning import middle_of, pushed_side
from rotsolve.confirm.pose import Pose
from rotsolve.draw.paper.figure import Point
from rotsolve.draw.plane.places.contacts import level_of, middle_unknown
from rotsolve.draw.plane.places.equations import place_off
from rotsolve.draw.plane.places.kinds import edge_height
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.elements.connections.leaning import Leans
from rotsolve.elements.connections.touch import Touch
from rotsolve.language.bodies import PointRef


def lay_leaned(item: Touch, stage: PlaneStage) -> None:
    """What a rod leans on is where its side is: a corner there, the middle of what is round so far across."""
    own, under = item.pair()[:2]
    model, turn = stage.model, stage.bodies[own.owner].turn
    pose = Pose(model.seats, stage.q, [0.0] * len(stage.q))
    leaned = cast("Leans", item)
    c, s = math.cos(turn), math.sin(turn)
    side = pushed_side(leaned, c, s, pose, model)
    out = (-s * side, c * side)
    (x, y), radius = middle_of(leaned, out, pose, model)
    there = stage.place_of(own.owner, touching_spot(own, (x.value, y.value), (c, s), pose, stage))
    middle = place_off(there, (-radius * out[0], -radius * out[1]))
    if under.owner in stage.bodies:
        cornered = under.point is not None and not radius
        spot = model.drawn(under) if cornered else model.spot(PointRef(under.owner))
        stage.layout.meet(middle, stage.place_of(under.owner, spot))
        return
    surface = model.surfaces[under.owner]
    edge, height = middle_unknown(surface, stage), edge_height(surface)
    stage.layout.meet(edge, middle)
    floors = [
        model.surfaces[other.places()[0].owner]
        for other in stage.kinds.contacts
        if standing_on(other, own.owner, stage)
    ]
    if height is not None and floors:
        stage.layout.equal(edge[1].plus(level_of(floors[0], stage), -1.0), stage.value(height))


def standing_on(item: Touch, name: str, stage: PlaneStage) -> bool:
    """Whether a contact lays a body on a level floor."""
    floor = stage.model.surfaces.get(item.places()[0].owner)
    return item.lying() == name and floor is not None and floor.level


def touching_spot(own: PointRef, middle: Point, way: Point, pose: Pose, stage: PlaneStage) -> Point:
    """Where along the rod, in its own axes: as told, else where the line across from the middle of what it leans on meets it."""
    if own.point is not None:
        return stage.model.drawn(own)
    centre = stage.model.seats[own.owner].rigid.centre
    x, y = pose.place(own.owner, centre)
    reach = (middle[0] - x.value) * way[0] + (middle[1] - y.value) * way[1]
    return centre[0] + reach, centre[1]
