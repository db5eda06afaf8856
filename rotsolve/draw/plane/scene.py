"""The scene: its first picture, all bodies with what holds, ties and pushes them, their letters and senses, and another state dashed."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.core.faults import Unsolvable
from rotsolve.draw.paper.figure import FORCE, Figure, Point, moved
from rotsolve.draw.plane.facts import SceneFacts
from rotsolve.draw.plane.freebody import couple_arrow
from rotsolve.draw.plane.ghosts import draw_ghosts
from rotsolve.draw.plane.ground import draw_surfaces, told
from rotsolve.draw.plane.marks import draw_angles, draw_lengths, draw_names, draw_senses
from rotsolve.draw.plane.sheet import Sheet
from rotsolve.draw.plane.stage import Stage
from rotsolve.draw.plane.ties import draw_connections
from rotsolve.core.facts import Couple, Force

WIDE, TALL, LARGEST = 330.0, 230.0, 165.0  # points of paper for all bodies, and for one
PULL = 40.0  # length of the arrow of a force


def scale_for(stage: Stage) -> float:
    """Points of paper for a metre: all bodies fit, and one alone is no larger than it need be."""
    points = [point for body in stage.bodies.values() for point in body.bound()]
    wide, tall = spans(points)
    single = max((max(spans(body.bound())) for body in stage.bodies.values() if body.bound()), default=0.0)
    limits = [(WIDE, wide), (TALL, tall), (LARGEST, single)]
    return min((room / size for room, size in limits if size > 0.0), default=100.0 / (stage.sizes.whole or 1.0))


def spans(points: Sequence[Point]) -> tuple[float, float]:
    if not points:
        return 0.0, 0.0
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return max(xs) - min(xs), max(ys) - min(ys)


def draw_scene(stage: Stage, title: str = "", description: str = "") -> Figure:
    """The picture of a scene in the plane at the state of a stage."""
    sheet = Sheet(scale_for(stage), title, description)
    draw_surfaces(stage, sheet)
    draw_connections(stage, sheet)
    draw_ghosts(stage, sheet)
    for body in stage.bodies.values():
        if body.seen:
            for outline in body.shown():
                sheet.outline(outline)
    draw_actions(stage, sheet)
    draw_angles(stage, sheet)
    draw_lengths(stage, sheet)
    draw_senses(stage, sheet)
    draw_names(stage, sheet)
    return sheet.finished()


def draw_actions(stage: Stage, sheet: Sheet) -> None:
    """The forces and couples of the actions, as their facts say."""
    if not stage.model.acting.actions:
        return
    known = SceneFacts(stage)
    for action in stage.model.acting.actions:
        try:
            facts = list(action.facts(known.instant))
        except Unsolvable:
            continue
        words = told(stage, action.strength())
        for fact in facts:
            if isinstance(fact, Force) and not fact.role.rubs:
                x, y = known.arrow(fact.direction)
                at = sheet.at(known.applied(fact))
                if fact.role.presses:
                    sheet.arrow(moved(at, (x, y), -PULL), (x, y), PULL, FORCE)
                    if words is not None:
                        sheet.letters.name(words, moved(at, (x, y), -PULL), (-x, -y), 3.0, FORCE.ink)
                else:
                    sheet.arrow(at, (x, y), PULL, FORCE, words)
            elif isinstance(fact, Couple):
                couple_arrow(fact, stage, known, sheet, words, 0)
