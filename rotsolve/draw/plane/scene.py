"""The scene: its first picture, all bodies with what holds, ties and pushes them, their letters and senses, and another state dashed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from rotsolve.algebra.formula import ZERO, Negative
from rotsolve.core.facts import Couple, Force
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import has_quantities
from rotsolve.draw.paper.figure import FORCE, Figure, Point, arc_points, shifted_by
from rotsolve.draw.paper.lettering import Words
from rotsolve.draw.plane.facts import SceneFacts
from rotsolve.draw.plane.freebody import couple_arrow, free_start
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.contacts import normal_sign
from rotsolve.draw.plane.places.kinds import curve_radius
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.angles import draw_angles
from rotsolve.draw.plane.signs.ghosts import draw_ghosts
from rotsolve.draw.plane.signs.ground import draw_surfaces, told_words
from rotsolve.draw.plane.signs.lengths import draw_lengths
from rotsolve.draw.plane.signs.names import draw_names
from rotsolve.draw.plane.signs.senses import draw_senses
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.strings import edge_along
from rotsolve.draw.plane.signs.struck import draw_struck
from rotsolve.draw.plane.signs.ties import draw_connections
from rotsolve.language.bodies import Surface
from rotsolve.language.elements import Action

BLOCKS = 56.0  # points of paper for a block
WIDE, TALL, LARGEST, ROUND = 330.0, 230.0, 165.0, 96.0  # points of paper for all bodies, for one, and for a round one
PULL = 40.0  # length of the arrow of a force


def plane_scale(stage: PlaneStage) -> float:
    """Points of paper for a metre: all bodies fit, and one alone is no larger than it need be."""
    points = [point for body in stage.bodies.values() for point in body.bound()]
    points += [point for surface, where in stage.surfaces.values() for point in round_surface(surface, where, stage)]
    wide, tall = spans(points)
    extents = [(body, max(spans(body.bound()))) for body in stage.bodies.values() if body.bound()]
    single = max((size for _, size in extents), default=0.0)
    circle = max((size for body, size in extents if body.outlines and body.outlines[0].radius), default=0.0)
    alone = len(stage.bodies) == 1 and not stage.surfaces and not stage.model.acting.connections
    blocks = max((size for body, size in extents if body.block), default=0.0)
    limits = [
        (WIDE, wide),
        (BLOCKS if blocks <= 1.01 * stage.sizes.block else 3 * BLOCKS, blocks),
        (TALL, tall),
        (LARGEST, single),
        (LARGEST if alone else ROUND, circle),
    ]
    return min((room / size for room, size in limits if size > 0.0), default=100.0 / (stage.sizes.whole or 1.0))


def round_surface(surface: Surface, where: Any, stage: PlaneStage) -> list[Point]:
    """Points of a bowl or a dome."""
    size = curve_radius(surface)
    if size is None:
        return []
    centre, radius = stage.middle(where), stage.value(size)
    return arc_points(centre, radius, *((0.0, math.pi) if normal_sign(surface) > 0 else (math.pi, 2 * math.pi)))


def spans(points: Sequence[Point]) -> tuple[float, float]:
    if not points:
        return 0.0, 0.0
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return max(xs) - min(xs), max(ys) - min(ys)


def draw_scene(stage: PlaneStage, title: str = "", description: str = "") -> Figure:
    """The picture of a scene in the plane at the state of a stage."""
    sheet = ScenePaper(plane_scale(stage), title, description)
    draw_surfaces(stage, sheet)
    draw_connections(stage, sheet)
    draw_ghosts(stage, sheet)
    for body in largest_first(stage):
        for outline in body.shown():
            sheet.outline(outline)
    draw_plane_actions(stage, sheet)
    draw_blows(stage, sheet)
    draw_struck(stage, sheet)
    draw_angles(stage, sheet)
    if any(item.side is not None for item in stage.kinds.contacts):
        from rotsolve.draw.plane.signs.marked_sides import mark_sides

        mark_sides(stage, sheet)
    draw_lengths(stage, sheet)
    draw_senses(stage, sheet)
    draw_names(stage, sheet)
    return sheet.finished()


def largest_first(stage: PlaneStage) -> list[Figured]:
    """The bodies that are seen, so that none is hidden by one in which, or on which, it lies."""
    return sorted((body for body in stage.bodies.values() if body.seen), key=lambda body: -max(spans(body.bound())))


def draw_plane_actions(stage: PlaneStage, sheet: ScenePaper) -> None:
    """The forces and couples of the actions, as their facts say."""
    if not stage.model.acting.actions:
        return
    known, taken = SceneFacts(stage), list[tuple[Point, Point]]()
    couples: dict[str, int] = {}
    for action in stage.model.acting.actions:
        try:
            facts = list(action.facts(known.instant))
        except Unsolvable:
            continue
        words = strength_words(action, stage)
        for fact in facts:
            if isinstance(fact, Force) and not fact.role.rubs:
                draw_pull(fact, words, known, sheet, taken, told_backwards(fact, action))
            elif isinstance(fact, Couple):
                turn = turn_shown(fact, action, known)
                couple_arrow(fact.body, turn, known, sheet, words, couples.get(fact.body, 0))
                couples[fact.body] = couples.get(fact.body, 0) + 1


def strength_words(action: Action, stage: PlaneStage) -> Words | None:
    """How strong an action is: −k x one way is k x the other way, in which it is drawn."""
    told = action.strength()
    return told_words(stage, told.operand if isinstance(told, Negative) else told)


def told_backwards(fact: Force, action: Action) -> bool:
    """Whether the direction of a force is still that of −k x, and not yet that of k x the other way."""
    return isinstance(action.strength(), Negative) and (fact.size == ZERO or isinstance(fact.size, Negative))


def turn_shown(fact: Couple, action: Action, known: SceneFacts) -> int:
    """The turn of a couple, +1 counterclockwise; of one that is nothing at the state, such as a drag, that which it will have."""
    if abs(known.number(fact.torque)) == 0.0:
        later = known.scene.instant(known.stage.state, generic=True)
        fact = next((one for one in action.facts(later) if isinstance(one, Couple) and one.body == fact.body), fact)
    return 1 if known.number(fact.torque) >= 0.0 else -1


def draw_pull(
    fact: Force,
    words: Words | None,
    known: SceneFacts,
    sheet: ScenePaper,
    taken: list[tuple[Point, Point]],
    turned: bool,
) -> None:
    """The force of an action: up to its point where it presses, else away from it, beside what lies there already."""
    way, at = known.arrow(fact.direction), sheet.at(known.applied(fact))
    way = (-way[0], -way[1]) if turned else way
    if fact.role.presses:
        draw_push(at, way, words, sheet)
        return
    body = known.stage.bodies[fact.body]
    if body.block:
        at = shifted_by(at, way, sheet.scale * edge_along(body, way))
    at = free_start(at, way, taken)
    taken.append((at, shifted_by(at, way, PULL)))
    sheet.arrow(at, way, PULL, FORCE, words)


def draw_blows(stage: PlaneStage, sheet: ScenePaper) -> None:
    """The impulses of events that begin at the state and that the scene tells, as arrows up to the points that they strike."""
    known = SceneFacts(stage)
    for event in (event for event in stage.model.problem.events if event.from_ == stage.state):
        for ref in event.points(stage.model.problem.connections):
            try:
                body = known.facts.body(known.instant.host(ref.owner))
                blows = list(event.blows(ref, body, known.instant)) if body is not None else []
            except Unsolvable:
                continue
            for blow in (blow for blow in blows if ref.owner in stage.bodies and not has_quantities(blow.size)):
                at, way = sheet.at(known.applied(blow)), known.arrow(blow.direction)
                draw_push(at, way, told_words(stage, blow.size), sheet)


def draw_push(at: Point, way: Point, words: Words | None, sheet: ScenePaper) -> None:
    """What pushes on a point, as an arrow up to it with its letter behind."""
    x, y = way
    start = shifted_by(at, way, -PULL)
    sheet.arrow(start, way, PULL, FORCE)
    if words is not None:
        sheet.letters.name(words, start, (-x, -y), 3.0, FORCE.ink)
