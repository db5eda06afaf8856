"""Labels: where the words of a picture go: next to what they name, on no line and on no other words, the same for the same picture."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

from msgspec import Struct, field

from rotsolve.draw.paper.figure import (
    Box,
    Circle,
    Figure,
    Label,
    Line,
    Mark,
    Point,
    boxes_apart,
    ray,
    shifted_by,
    unit_of,
)
from rotsolve.draw.paper.lettering import SIZE, Words, width_of

RINGS = (0.0, 5.0, 11.0, 18.0, 27.0, 38.0, 52.0, 70.0, 95.0, 130.0)  # further and further from what is named
TURNS = (0, 30, -30, 60, -60, 90, -90, 120, -120, 150, -150, 180)  # from the side that is asked for
HIGH, GAP = 1.14, 1.2  # of a line of text beside its size; between two labels
ROUGH = 10.0  # degrees between points of a circle that is taken as a polygon
COVERED, FAR = 12.0, 0.25  # what a label costs that lies on a line, and each point of its distance
SHY = 30.0  # degrees of turn that cost as much as a point


class Wish(Struct, frozen=True):
    """Words that belong to a place, on the side `way` of it, where `reach` is how far what is named goes that way."""

    words: Words
    at: Point
    way: Point = (0.0, 1.0)
    reach: float = 4.0
    ink: str = "ink"
    size: float = SIZE
    inside: bool = False  # whether the place itself is the best, as within a block
    tag: str = ""  # of what these are the words, where somebody asks


Segment = tuple[Point, Point]


class Lettering(Struct):
    """Gathers the labels of a picture, and places them when all of its lines are drawn."""

    wishes: list[Wish] = field(default_factory=list)

    def name(
        self,
        words: Words,
        at: Point,
        way: Point = (0.0, 1.0),
        reach: float = 4.0,
        ink: str = "ink",
        size: float = SIZE,
        inside: bool = False,
        tag: str = "",
    ) -> None:
        """Asks for words at a place."""
        if words.text:
            self.wishes.append(Wish(words, at, unit_of(way), reach, ink, size, inside, tag))

    def place(self, figure: Figure) -> None:
        """Puts all labels into a picture, those with the least room first."""
        lines = [
            piece
            for mark in figure.marks
            if mark.role.ink and mark.role.name != "hatch"
            for piece in straight_pieces(mark)
        ]
        for wish in sorted(self.wishes, key=lambda wish: not wish.inside):
            figure.labels.append(best_label(wish, lines, figure.labels))
        self.wishes.clear()


def straight_pieces(mark: Mark) -> Iterator[Segment]:
    """The straight pieces of a mark."""
    if isinstance(mark, Circle):
        count = round(360 / ROUGH)
        points = [shifted_by(mark.centre, ray(2 * math.pi * k / count, mark.radius)) for k in range(count + 1)]
        yield from itertools.pairwise(points)
    elif isinstance(mark, Line):
        yield from zip(mark.points, mark.points[1:], strict=False)
        if mark.closed:
            yield mark.points[-1], mark.points[0]


def best_label(wish: Wish, lines: Sequence[Segment], others: Sequence[Label]) -> Label:
    """A label at the best of the places round what it names."""
    wide, high = width_of(wish.words.text, wish.size, wish.words.prose), HIGH * wish.size
    furthest = wish.reach + RINGS[-1] + wide
    near = [piece for piece in lines if may_touch(piece, wish.at, furthest)]
    boxes = [label.box for label in others if close_box(label.box, wish.at, furthest + wide)]
    best: tuple[float, Point] | None = None
    for cost, middle in candidates(wish, wide, high):
        if best is not None and cost >= best[0]:
            break
        box = box_at(middle, wide, high)
        if not all(boxes_apart(box, other, GAP) for other in boxes):
            continue
        cost += COVERED * sum(crosses(piece, box) for piece in near)
        if best is None or cost < best[0]:
            best = cost, middle
    middle = best[1] if best is not None else below_all(wish, wide, high, others)
    return Label(wish.words.text, wish.words.latex, middle, box_at(middle, wide, high), wish.ink, wish.size, wish.tag)


def candidates(wish: Wish, wide: float, high: float) -> list[tuple[float, Point]]:
    """Places for the middle of a label, with what each costs, the cheapest first."""
    start = math.atan2(wish.way[1], wish.way[0])
    found = [(0.0, wish.at)] if wish.inside else []
    for ring in RINGS:
        for turn in TURNS:
            x, y = ray(start + math.radians(turn))
            off = wish.reach + ring + abs(x) * wide / 2 + abs(y) * high / 2
            found.append((FAR * ring + abs(turn) / SHY + wish.inside * 2.0, shifted_by(wish.at, (x, y), off)))
    return sorted(found, key=lambda item: item[0])


def below_all(wish: Wish, wide: float, high: float, others: Sequence[Label]) -> Point:
    """Where no place round it is free: under all other labels."""
    return wish.at[0], min((label.box[1] for label in others), default=wish.at[1]) - high


def box_at(middle: Point, wide: float, high: float) -> Box:
    x, y = middle
    return x - wide / 2, y - high / 2, x + wide / 2, y + high / 2


def may_touch(piece: Segment, at: Point, reach: float) -> bool:
    """Whether a piece may come within reach of a place."""
    (ax, ay), (bx, by) = piece
    return min(ax, bx) - reach <= at[0] <= max(ax, bx) + reach and min(ay, by) - reach <= at[1] <= max(ay, by) + reach


def close_box(box: Box, at: Point, reach: float) -> bool:
    return box[0] - reach <= at[0] <= box[2] + reach and box[1] - reach <= at[1] <= box[3] + reach


def crosses(piece: Segment, box: Box) -> bool:
    """Whether a straight piece touches a box: by what is left of it within the box's four sides."""
    (ax, ay), (bx, by) = piece
    dx, dy = bx - ax, by - ay
    first, last = 0.0, 1.0
    for step, room in ((-dx, ax - box[0]), (dx, box[2] - ax), (-dy, ay - box[1]), (dy, box[3] - ay)):
        if step == 0.0:
            if room < 0.0:
                return False
            continue
        share = room / step
        if step < 0.0:
            first = max(first, share)
        else:
            last = min(last, share)
        if first > last:
            return False
    return True
