"""Struck: what a body will bounce off, a little ahead of it: a floor, a wall, an edge or a stop on which nothing lies."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rotsolve.core.faults import Unsolvable
from rotsolve.draw.paper.figure import Point, ray, shifted_by, unit_of
from rotsolve.draw.plane.facts import SceneFacts
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.language.bodies import PointRef, Surface

AHEAD, PEG, WIDER = 36.0, 18.0, 12.0  # points: how far off it is, how wide an edge is, and a surface beyond the body


def draw_struck(stage: PlaneStage, sheet: ScenePaper) -> None:
    """Each surface, edge or stop once."""
    drawn = {*stage.surfaces}
    for ref, surface, now in bounces_to_come(stage):
        if ref.owner not in stage.bodies or (surface is not None and surface.name in drawn):
            continue
        out = against_the_blow(ref, stage) if surface is None and now else None
        out = ray(stage.value(surface.normal.formula())) if surface is not None else out
        if out is not None:
            at, half = edge_towards(ref, out, stage, sheet)
            sheet.patch(shifted_by(at, out, -AHEAD), out, PEG if surface is None else 2 * (half + WIDER))
        drawn |= {surface.name} if surface is not None else set()


def bounces_to_come(stage: PlaneStage) -> Iterator[tuple[PointRef, Surface | None, bool]]:
    """The bounces from the state on: what strikes what, and whether it does so from this state."""
    names = [state.name for state in stage.model.problem.states]
    now = names.index(stage.state) if stage.state in names else 0
    for event in stage.model.problem.events:
        struck = event.bounced_off()
        if struck is not None and event.from_ in names[now:]:
            yield *struck, event.from_ == stage.state


def against_the_blow(ref: PointRef, stage: PlaneStage) -> Point | None:
    """Where a point comes from that strikes something fixed; None where it stands, or nothing tells that."""
    known = SceneFacts(stage)
    try:
        x, y = known.arrow(known.instant.velocity(ref))
    except Unsolvable:
        return None
    return unit_of((-x, -y)) if math.hypot(x, y) > 0.0 else None


def edge_towards(ref: PointRef, out: Point, stage: PlaneStage, sheet: ScenePaper) -> tuple[Point, float]:
    """Where a body is nearest to what it will strike, on paper, and half its width there."""
    body, back, along = stage.bodies[ref.owner], (-out[0], -out[1]), (-out[1], out[0])
    if ref.point is not None:
        return sheet.at(body.spot(stage.model.drawn(ref))), PEG / 2
    half = max(body.reach(along), body.reach((-along[0], -along[1])))
    return sheet.at(shifted_by(body.place, back, body.reach(back))), half * sheet.scale
