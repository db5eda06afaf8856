"""Reel: pictures of one scene at many moments, on one paper: what is drawn at each, and how its labels go along."""

from __future__ import annotations

import math
from collections.abc import Iterable

from msgspec import Struct

from rotsolve.draw.paper.figure import MARGIN, Box, Figure, Label, Line, Mark, Point, around, box_of

MEASURING = ("dimension",)  # roles of what says how the first picture stood, which is wrong in the others


class Reel(Struct):
    """Pictures of a motion: the marks of each, from the lowest to the highest, and the labels with how far each has gone by then."""

    title: str
    description: str
    pictures: list[list[Mark]]
    labels: list[Label]
    shifts: list[list[Point]]
    largest: float = math.inf  # points of the largest body that has a size

    def box(self) -> Box:
        """The paper that all pictures need together."""
        boxes = [box_of(mark) for picture in self.pictures for mark in picture]
        for moment in self.shifts:
            for label, (x, y) in zip(self.labels, moment, strict=True):
                left, low, right, high = label.box
                boxes.append((left + x, low + y, right + x, high + y))
        left, low, right, high = around(boxes) if boxes else (0.0, 0.0, 10.0, 10.0)
        return left - MARGIN, low - MARGIN, right + MARGIN, high + MARGIN


def moving_marks(figure: Figure) -> list[Mark]:
    """The marks of a picture that are true at any moment: none that measures how it stood at first."""
    return [mark for mark in figure.marks if not (isinstance(mark, Line) and mark.role.name in MEASURING)]


def largest_of(sizes: Iterable[float]) -> float:
    """The largest of some sizes; of points alone it is not told."""
    return max((size for size in sizes if size > 0.0), default=math.inf)
