"""Free-body diagrams: each body alone, its forces as arrows where they act, its couples as round arrows, with their letters."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rotsolve.algebra.formula import ZERO
from rotsolve.core.facts import BodyFacts, Couple, Force
from rotsolve.core.writing import spoken
from rotsolve.draw.paper.figure import BODY, FORCE, SOLID, Figure, Point, quarter, shifted_by
from rotsolve.draw.paper.lettering import Words, prose, words_with_letters
from rotsolve.draw.plane.facts import SceneFacts
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.sheet import ScenePaper

ACROSS, SMALL = 84.0, 46.0  # points of paper for a rod or a group, and for another body
LONG, APART = 42.0, 5.5  # of an arrow; between two on one line
ROUND, WIDER = 13.0, 7.0  # radius of the arrow of a couple, and how much larger the next one is
START, SWEEP = -0.6, 3.9  # radians of a couple's arrow
LONGEST = 16  # letters of a size; a longer one is called by its noun
ACROSS_ALL, GAP = 470.0, 26.0  # width of a row of diagrams, and what is between two


def free_body_figures(known: SceneFacts) -> list[tuple[str, Figure]]:
    """A diagram for each body on which something acts, by its name."""
    acting = [body for body in known.facts.bodies if body.name in known.stage.bodies and acts(body)]
    return [(body.name, free_body_figure(body, known)) for body in acting]


def acts(body: BodyFacts) -> bool:
    """Whether anything acts on a body."""
    return any(force.size != ZERO for force in body.forces) or any(couple.torque != ZERO for couple in body.couples)


def free_body_figure(body: BodyFacts, known: SceneFacts) -> Figure:
    """One body, and all that acts on it."""
    stage = known.stage
    members = [
        stage.bodies[name] for name in stage.configuration.carried(body.name, stage.state) if name in stage.bodies
    ]
    sheet = ScenePaper(scale_of(members), f"Forces on {spoken(body.name)}", description(body))
    for member in members:
        for outline in member.shown():
            sheet.outline(outline)
    if all(not member.outlines for member in members):
        sheet.figure.line(rope_piece(sheet.at(members[0].place)), BODY, closed=True)
    taken: list[tuple[Point, Point]] = []
    for number, (force, place, way) in enumerate(known.acting(body)):
        start = free_start(sheet.at(place), way, taken)
        taken.append((start, shifted_by(start, way, LONG)))
        words = size_words(force, known)
        sheet.arrow(start, way, LONG, FORCE, words, tag=f"{body.name} {number}")
        if force.role.weighs:
            sheet.figure.circle(sheet.at(place), 1.5, SOLID)
    couples = [couple for couple in body.couples if couple.torque != ZERO]
    for number, couple in enumerate(couples):
        couple_arrow(couple, stage, known, sheet, size_words(couple, known), number)
    sheet.finished()
    sheet.letters.name(prose(spoken(body.name).removeprefix("the ")), under(sheet), (0.0, -1.0), 3.0, "faint")
    return sheet.finished()


def rope_piece(at: Point) -> list[Point]:
    """A short piece of what has no form of its own."""
    x, y = at
    return [(x - 2, y - 20), (x + 2, y - 20), (x + 2, y + 20), (x - 2, y + 20)]


def under(sheet: ScenePaper) -> Point:
    """The middle below all that is drawn."""
    left, low, right, _ = sheet.figure.box(0.0)
    return (left + right) / 2, low


def scale_of(members: Sequence[Figured]) -> float:
    """Points of paper for a metre, so that the bodies fill a diagram."""
    points = [point for member in members for point in member.bound()]
    xs, ys = [x for x, _ in points] or [0.0], [y for _, y in points] or [0.0]
    size = max(max(xs) - min(xs), max(ys) - min(ys))
    slender = len(members) > 1 or any(outline.slender for member in members for outline in member.outlines)
    return (ACROSS if slender else SMALL) / size if size > 0.0 else 1.0


def description(body: BodyFacts) -> str:
    """All that acts, in words."""
    acting = [f"{item.noun}{', ' + item.way if item.way else ''}" for item in body.acting if item.size != ZERO]
    return "; ".join(acting) or "nothing acts on it"


def size_words(item: Force | Couple, known: SceneFacts) -> Words:
    """The size of a force in the letters that a derivation prints, or what it is called where that is long."""
    words = words_with_letters(item.size, known.letters)
    return words if len(words.text) <= LONGEST else prose(item.noun)


def free_start(at: Point, way: Point, taken: Sequence[tuple[Point, Point]]) -> Point:
    """Where an arrow begins: at its point, or beside it where another lies on the same line."""
    side, best = quarter(way), at
    for shift in (0.0, APART, -APART, 2 * APART, -2 * APART, 3 * APART, -3 * APART):
        best = shifted_by(at, side, shift)
        if not any(same_line(best, way, arrow) for arrow in taken):
            break
    return best


def same_line(start: Point, way: Point, arrow: tuple[Point, Point]) -> bool:
    """Whether an arrow would lie on another one."""
    (ax, ay), (bx, by) = arrow
    along = [(x - start[0]) * way[0] + (y - start[1]) * way[1] for x, y in arrow]
    across = [abs((x - start[0]) * way[1] - (y - start[1]) * way[0]) for x, y in ((ax, ay), (bx, by))]
    return max(across) < 3.0 and max(along) > 1.0 and min(along) < LONG - 1.0


def couple_arrow(
    couple: Couple, stage: PlaneStage, known: SceneFacts, sheet: ScenePaper, words: Words | None, number: int
) -> None:
    """A round arrow about the reference of a body, along the turn of a couple."""
    turn = 1.0 if known.number(couple.torque) >= 0.0 else -1.0
    body = stage.bodies[couple.body]
    centre = sheet.at(known.reference(couple.body))
    room = 0.5 * sheet.scale * body.reach((1.0, 0.0)) if len(body.outlines) and not body.dot else 0.0
    radius = max(ROUND, min(room, 24.0)) + WIDER * number
    start = math.pi / 2 - turn * SWEEP / 2
    sheet.round_arrow(centre, radius, start, turn * SWEEP, FORCE, words, tag=f"{couple.body} couple {number}")


def diagrams_in_rows(figures: Sequence[Figure], title: str, description: str) -> Figure:
    """Several pictures in rows, as one."""
    whole = Figure(title, description)
    x, top, deepest = 0.0, 0.0, 0.0
    for figure in figures:
        left, low, right, high = figure.box(0.0)
        if x > 0.0 and x + right - left > ACROSS_ALL:
            x, top, deepest = 0.0, deepest - GAP, deepest - GAP
        placed = figure.shifted((x - left, top - high))
        whole.marks += placed.marks
        whole.labels += placed.labels
        x, deepest = x + right - left + GAP, min(deepest, top - (high - low))
    return whole
