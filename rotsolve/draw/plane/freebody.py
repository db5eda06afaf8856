"""Free-body diagrams: each body alone, its forces as arrows where they act, its couples as round arrows, with their letters."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from rotsolve.algebra.formula import call, negate
from rotsolve.core.facts import BodyFacts, Couple, Force
from rotsolve.core.vectors.heading import opposite
from rotsolve.core.writing import spoken
from rotsolve.derivation.headings import moment_title
from rotsolve.draw.paper.figure import (
    BODY,
    FORCE,
    SOLID,
    UNSURE,
    Figure,
    InkRole,
    Label,
    Line,
    Point,
    around,
    box_of,
    quarter,
    shifted_by,
)
from rotsolve.draw.paper.labels import HIGH, box_at
from rotsolve.draw.paper.lettering import SIZE, Words, prose, width_of, words_with_letters
from rotsolve.draw.plane.facts import SceneFacts
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.signs.sheet import ScenePaper

ACROSS, SMALL = 84.0, 46.0  # points of paper for a rod or a group, and for another body
LONG, APART = 42.0, 5.5  # of an arrow; between two on one line
ROUND, WIDER = 13.0, 7.0  # radius of the arrow of a couple, and how much larger the next one is
START, SWEEP = -0.6, 3.9  # radians of a couple's arrow
LONGEST = 16  # letters of a size; a longer one is called by its noun
ACROSS_ALL, GAP = 470.0, 26.0  # width of a row of diagrams, and what is between two
UNTOLD = ("dashed: nothing tells which way it acts;", "drawn the way its letter counts")


def free_body_figures(known: SceneFacts) -> list[tuple[str, Figure]]:
    """A diagram for each body on which something acts, by its name."""
    acting = [body for body in known.facts.bodies if body.name in known.stage.bodies and acts(body, known)]
    return [(body.name, free_body_figure(body, known)) for body in acting]


def acts(body: BodyFacts, known: SceneFacts) -> bool:
    """Whether anything acts on a body."""
    return any(known.way_of(item.size, item.owner) != 0 for item in body.acting)


def free_body_figure(body: BodyFacts, known: SceneFacts) -> Figure:
    """One body, and all that acts on it."""
    stage = known.stage
    members = [
        stage.bodies[name] for name in stage.configuration.carried(body.name, stage.state) if name in stage.bodies
    ]
    called = f"{spoken(body.name)}{state_said(known)}"
    sheet = ScenePaper(scale_of(members), f"Forces on {called}", description(body, known))
    for member in members:
        for outline in member.shown():
            sheet.outline(outline)
    if all(not member.outlines for member in members):
        sheet.figure.line(rope_piece(sheet.at(members[0].place)), BODY, closed=True)
    taken: list[tuple[Point, Point]] = []
    for number, force, place, way, told in known.acting(body):
        start = free_start(sheet.at(place), way, taken)
        taken.append((start, shifted_by(start, way, LONG)))
        role = UNSURE if told is None else FORCE
        sheet.arrow(start, way, LONG, role, size_words(force, told, known), tag=f"{body.name} {number}")
        if force.role.weighs:
            sheet.figure.circle(sheet.at(place), 1.5, SOLID)
    draw_couples(body, known, sheet)
    sheet.finished()
    sheet.letters.name(prose(called.removeprefix("the ")), under(sheet), (0.0, -1.0), 3.0, "faint")
    return sheet.finished()


def draw_couples(body: BodyFacts, known: SceneFacts, sheet: ScenePaper) -> None:
    """Round arrows, one round the other, the way in which each couple turns."""
    drawn = 0
    for number, couple in enumerate(body.couples):
        told = known.way_of(couple.torque, couple.owner)
        if told != 0:
            turn = told or turn_counted(couple)
            words = size_words(couple, turn * turn_counted(couple), known)
            role, tag = (UNSURE if told is None else FORCE), f"{body.name} couple {number}"
            couple_arrow(couple.body, turn, known, sheet, words, drawn, role, tag)
            drawn += 1


def turn_counted(couple: Couple) -> int:
    """The sense in which a couple turns where its letter is positive, +1 counterclockwise."""
    return -1 if couple.torque == negate(couple.size) else 1


def state_said(known: SceneFacts) -> str:
    """At which state a diagram is, as a derivation calls it; nothing of the only moment of a scene that does not name it."""
    state = known.stage.state
    if not state:
        return ""
    title = moment_title(state, known.stage.configuration.timeline)
    return f", {title[0].lower()}{title[1:]}"


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


def description(body: BodyFacts, known: SceneFacts) -> str:
    """All that acts, in words, the way in which it acts."""
    said = []
    for item in body.acting:
        told = known.way_of(item.size, item.owner)
        if told != 0:
            way = opposite(item.way) if told == -1 else item.way
            said.append(", ".join(filter(None, (item.noun, way, "or the other way" if told is None else ""))))
    return "; ".join(said) or "nothing acts on it"


def size_words(item: Force | Couple, way: int | None, known: SceneFacts) -> Words:
    """The size of a force, which is never negative, in the letters that a derivation prints; what it is called where that is long."""
    words = words_with_letters(item.size, known.letters)
    if way == -1:
        words = words_with_letters(negate(item.size), known.letters)
        if words.text.startswith("−"):
            words = words_with_letters(call("abs", item.size), known.letters)
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
    name: str,
    turn: int,
    known: SceneFacts,
    sheet: ScenePaper,
    words: Words | None,
    number: int,
    role: InkRole = FORCE,
    tag: str = "",
) -> None:
    """A round arrow about the reference of a body, +1 counterclockwise, outside of `number` others."""
    body = known.stage.bodies[name]
    centre = sheet.at(known.reference(name))
    room = 0.5 * sheet.scale * body.reach((1.0, 0.0)) if len(body.outlines) and not body.dot else 0.0
    radius = max(ROUND, min(room, 24.0)) + WIDER * number
    start = math.pi / 2 - turn * SWEEP / 2
    sheet.round_arrow(centre, radius, start, turn * SWEEP, role, words, tag=tag)


def look_of(figure: Figure) -> tuple[object, ...]:
    """What is seen of a diagram, wherever it lies and whatever it is called: two that look alike say the same."""
    left, low, _, _ = around([box_of(mark) for mark in figure.marks])
    marks = [mark for mark in figure.shifted((-left, -low)).marks if isinstance(mark, Line)]
    lines = [(mark.role.name, tuple((round(x), round(y)) for x, y in mark.points)) for mark in marks]
    return *lines, *(label.text for label in figure.labels if label.ink == FORCE.ink)


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
    if any(mark.role is UNSURE for mark in whole.marks):
        whole.labels += caption(UNTOLD, deepest - GAP / 2)
    return whole


def caption(lines: Sequence[str], top: float) -> Iterator[Label]:
    """Lines of words below a picture, from the left."""
    wide, high = max(width_of(line, SIZE, True) for line in lines), HIGH * SIZE
    for number, line in enumerate(lines):
        at = wide / 2, top - (number + 0.5) * high
        yield Label(line, prose(line).latex, at, box_at(at, wide, high), "faint")
