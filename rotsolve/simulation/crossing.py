"""Crossing: the first moment in a step at which a watched value passes zero."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from rotsolve.core.registry import TIME
from rotsolve.simulation.course import Course
from rotsolve.simulation.series import Arithmetic, Expansion, Scalar
from rotsolve.simulation.tape import ONE
from rotsolve.simulation.taylor import Piece
from rotsolve.simulation.watches import Watch

SAMPLES = 4  # moments of a step at which the watched values are looked at
HALVINGS = 200
CLEAR = 1e-9  # a value smaller than this part of what it comes to in the step has no sign of its own at the start


class Hit(Struct, frozen=True):
    """A watched value passes zero."""

    watch: Watch
    number: int
    time: float


class Lookout:
    """Looks at the watched values of a course along the pieces of its motion."""

    def __init__(self, watched: Sequence[Watch], course: Course, arithmetic: Arithmetic) -> None:
        self.watched, self.course = watched, course
        self.expansion = Expansion(course.tape, [watch.place for watch in watched], arithmetic)
        self.letters = [course.letters[item.letter] for item in course.variables]
        self.clock, self.one = course.letters[TIME], arithmetic.number(ONE)
        self.sides = [0] * len(watched)  # the last sign that each had

    def values(self, piece: Piece, time: float) -> list[Scalar]:
        """The watched values at a time."""
        state = dict(zip(self.letters, piece.at(time), strict=True))
        self.expansion.begin({**state, self.clock: self.one * time})
        lists = self.expansion.lists
        return [lists[watch.place][0] for watch in self.watched]

    def first(self, piece: Piece) -> Hit | None:
        """The first moment in a piece at which one of the values passes zero."""
        if not self.watched:
            return None
        times = [piece.start + piece.length * k / SAMPLES for k in range(SAMPLES + 1)]
        rows = list(zip(*(self.values(piece, time) for time in times), strict=True))
        hits = [hit for number, row in enumerate(rows) if (hit := self._in_row(number, row, times, piece)) is not None]
        return min(hits, key=lambda hit: hit.time, default=None)

    def _in_row(self, number: int, row: Sequence[Scalar], times: Sequence[float], piece: Piece) -> Hit | None:
        """The first passage of one value, seen by its signs at some moments."""
        side, low = self.sides[number], times[0]
        if not side and abs(row[0]) > CLEAR * max(abs(value) for value in row):
            side = sign(row[0])
        for time, value in zip(times[1:], row[1:], strict=True):
            if side and sign(value) == -side:
                return Hit(self.watched[number], number, self._passage(number, piece, low, time, side))
            side, low = sign(value) or side, time
        self.sides[number] = side
        return None

    def _passage(self, number: int, piece: Piece, low: float, high: float, side: int) -> float:
        """Where the value passes zero between two moments: by chords, halving the weight of an end that stays (Illinois)."""
        below, above = self.values(piece, low)[number], self.values(piece, high)[number]
        if sign(below) != side:
            return low
        for _ in range(HALVINGS):
            middle = high - float(above * (high - low) / (above - below))
            if not low < middle < high:
                break
            found = self.values(piece, middle)[number]
            if sign(found) == side:
                low, below, above = middle, found, above / 2
            else:
                high, above, below = middle, found, below / 2
            if not found:
                break
        return high


def sign(value: Scalar) -> int:
    return 1 if value > 0 else -1 if value < 0 else 0
