"""Bars: numbers by labels, each as long as it is large: a picture where a format has pictures, else a table with bars of letters."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.page.blocks import PageBlock, Phrase, Table

if TYPE_CHECKING:
    from rotsolve.draw.paper.figure import Figure, Label

LETTERS = 40  # of the longest bar
WIDE, TALL, GAP = 260.0, 11.0, 6.0  # points of the longest bar, of each bar's height, and between two
SIZE = 10.0  # of the letters
SPACE = 7.0  # points between a label and its bar


class LabelledBar(Struct, frozen=True):
    """A label, a number that is not negative, and how the number is printed."""

    label: str
    value: Fraction
    said: str


class Bars(PageBlock, frozen=True):
    """Bars below each other; what they show in a sentence; the heads of labels and numbers; what a bar of full length is worth."""

    title: str
    heads: tuple[str, str]
    rows: tuple[LabelledBar, ...]
    most: Fraction

    def part(self, row: LabelledBar) -> Fraction:
        """How long a bar is, as a part of the longest that there can be."""
        return row.value / self.most if self.most else Fraction(0)

    def simpler(self) -> Iterator[PageBlock]:
        rows: list[tuple[Phrase, ...]] = []
        for row in self.rows:
            letters = int(LETTERS * self.part(row))
            rows.append(((row.label,), (row.said,), ("█" * (max(1, letters) if row.value else 0),)))
        yield Table((*self.heads, ""), tuple(rows))

    def figure(self) -> Figure:
        """The picture: labels on the left of a line, numbers behind the ends of the bars."""
        from rotsolve.draw.paper.figure import BODY, THIN, Figure

        said = "; ".join(f"{row.label}: {row.said}" for row in self.rows)
        figure = Figure(self.title, f"{self.heads[0]}, {self.heads[1]}: {said}")
        for place, row in enumerate(self.rows):
            high, end = -place * (TALL + GAP), WIDE * float(self.part(row))
            if row.value:
                figure.line([(0, high), (end, high), (end, high - TALL), (0, high - TALL)], BODY, closed=True)
            figure.labels.append(bar_label(row.label, -SPACE, high - TALL / 2, left=True))
            figure.labels.append(bar_label(row.said, end + SPACE, high - TALL / 2, left=False))
        figure.line([(0, GAP / 2), (0, -len(self.rows) * (TALL + GAP) + GAP / 2)], THIN)
        return figure


def bar_label(text: str, edge: float, middle: float, *, left: bool) -> Label:
    """Words that end on the left of an edge, or begin there."""
    from rotsolve.draw.paper.figure import Label
    from rotsolve.draw.paper.lettering import width_of
    from rotsolve.page.tex import latex_prose

    wide = width_of(text, SIZE, plain=True)
    low = edge - wide if left else edge
    box = (low, middle - SIZE / 2, low + wide, middle + SIZE / 2)
    return Label(text, latex_prose(text), (low + wide / 2, middle), box, size=SIZE)
