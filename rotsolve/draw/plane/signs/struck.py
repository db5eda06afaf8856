"""Struck: what a body will bounce off, a little ahead of it: a floor, a wall, an edge or a stop on which nothing lies."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rotsolve.core.faults import Unsolvable
from rotsolve.draw.paper.figure import Point, ray, shifted_by, unit_of
from rotsolve.draw.plane.facts import SceneFacts
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.elements.collisions import Bounces

AHEAD, PEG, WIDER = 36.0, 18.0, 12.0  # points: how far off it is, how wide an edge is, and a surface beyond the body


def draw_struck(stage: PlaneStage, sheet: ScenePaper) -> None:
    """Each surface, edge or stop once."""
    drawn: set[str] = set()
    for event in events_to_come(stage):
        surface = event.surface
        if event.struck.owner not in stage.bodies or (
            surface is not None and surface.name in {*drawn, *stage.surfaces}
        ):
            continue
        out = against_the_blow(event, stage) if surface is None else ray(stage.value(surface.normal.formula()))
        if out is None:
            continue
        at, half = edge_towards(event, out, stage, sheet)
        wide = PEG if surface is None else 2 * (half + WIDER)
        sheet.patch(shifted_by(at, out, -AHEAD), out, wide)
        drawn |= {surface.name} if surface is not None else set()


def events_to_come(stage: PlaneStage) -> Iterator[Bounces]:
    """The bounces from the state on."""
    names = [state.name for state in stage.model.problem.states]
    now = names.index(stage.state) if stage.state in names else 0
    for event in stage.model.problem.events:
        if isinstance(event, Bounces) and event.from_ in names[now:]:
            yield event


def against_the_blow(event: Bounces, stage: PlaneStage) -> Point | None:
    """Where the body comes from, at the state from which it strikes something fixed; None of another state, or where it stands."""
    if event.from_ != stage.state:
        return None
    known = SceneFacts(stage)
    try:
        x, y = known.arrow(known.instant.velocity(event.struck))
    except Unsolvable:
        return None
    return (-x / math.hypot(x, y), -y / math.hypot(x, y)) if math.hypot(x, y) > 0.0 else None


def edge_towards(event: Bounces, out: Point, stage: PlaneStage, sheet: ScenePaper) -> tuple[Point, float]:
    """Where a body is nearest to what it will strike, on paper, and half its width there."""
    body, ref, back = stage.bodies[event.struck.owner], event.struck, (-out[0], -out[1])
    along = unit_of((-out[1], out[0]))
    if ref.point is not None:
        return sheet.at(body.spot(stage.model.drawn(ref))), PEG / 2
    half = max(body.reach(along), body.reach((-along[0], -along[1])))
    return sheet.at(shifted_by(body.place, back, body.reach(back))), half * sheet.scale
