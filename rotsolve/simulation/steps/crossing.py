"""Crossing: the first moment in a step at which a watched value passes zero."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from msgspec import Struct

from rotsolve.simulation.moving.watches import REACHED, Watch
from rotsolve.simulation.steps.taylor import Piece, value
from rotsolve.simulation.tape.tape import Scalar

SAMPLES = 8  # moments of a step at which the watched values are looked at
HALVINGS = 200
CLEAR = 1e-9  # a value smaller than this part of what it comes to in the step has no sign of its own at the start


class Hit(Struct, frozen=True):
    """A watched value passes zero."""

    watch: Watch
    time: float
    also: tuple[Watch, ...] = ()  # states of the scene that are reached at once


class Lookout:
    """Looks at the watched values along the pieces of a motion; a piece is so short that they hardly bend in it."""

    def __init__(self, watched: Sequence[Watch], sides: Mapping[Watch, int]) -> None:
        self.watched = watched
        self.sides = [sides.get(watch, 0) for watch in watched]  # the last sign that each had

    def told(self) -> dict[Watch, int]:
        """The last signs, for what goes on from here with the same equations."""
        return dict(zip(self.watched, self.sides, strict=True))

    def first(self, piece: Piece) -> Hit | None:
        """The first moment in a piece at which one of the values passes zero."""
        if not self.watched:
            return None
        times = [piece.length * k / SAMPLES for k in range(SAMPLES + 1)]
        found = (self._passage(number, times, polynomial) for number, polynomial in enumerate(piece.watched))
        hits = [
            Hit(watch, piece.start + time) for watch, time in zip(self.watched, found, strict=True) if time is not None
        ]
        if not hits:
            return None
        first = min(hits, key=lambda hit: hit.time)
        near = first.time + CLEAR * piece.length
        also = (hit.watch for hit in hits if hit.time <= near and hit.watch.kind == REACHED != first.watch.kind)
        return Hit(first.watch, first.time, tuple(also))

    def _passage(self, number: int, times: Sequence[float], polynomial: Sequence[Scalar]) -> float | None:
        """When one value passes zero, seen by its signs at some times since the start of the piece."""
        row = [value(polynomial, time) for time in times]
        side, low = self.sides[number], times[0]
        if not side and abs(row[0]) > CLEAR * max(abs(item) for item in row):
            side = sign(row[0])
        for time, now in zip(times[1:], row[1:], strict=True):
            if side and sign(now) == -side:
                return passage(polynomial, low, time, side)
            side, low = sign(now) or side, time
        self.sides[number] = side
        return None


def passage(polynomial: Sequence[Scalar], low: float, high: float, side: int) -> float:
    """Where a polynomial passes zero between two times: by chords, halving the weight of an end that stays (Illinois)."""
    below, above = value(polynomial, low), value(polynomial, high)
    if sign(below) != side:
        return low
    for _ in range(HALVINGS):
        middle = high - float(above * (high - low) / (above - below))
        if not low < middle < high:
            break
        found = value(polynomial, middle)
        if sign(found) == side:
            low, below, above = middle, found, above / 2
        else:
            high, above, below = middle, found, below / 2
        if not found:
            break
    return min(low, high, key=lambda time: abs(value(polynomial, time)))


def sign(number: Scalar) -> int:
    return 1 if number > 0 else -1 if number < 0 else 0
