"""Scan: where a function of one number vanishes beside a root that is known, looked for at places over its range.

The function is divided by its distance from the known root, which is none of the quotient's. It may have no value somewhere, and may jump
where what rubs begins to slip: the places beside each such edge are looked at as well, and its least sizes, where it may touch zero.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterator, Sequence
from itertools import pairwise

from msgspec import Struct

from rotsolve.algebra.units.dimension import ANGLE, Dimension

STEPS, DECADES = 3, 2  # places in each decade, and decades to either side of the known root
FAR = (4.0, -4.0)  # decades at which it is looked once more
NEIGHBOURS = 10.0  # how much larger one of two places may be between which an edge is looked for
WIDE = 9  # angles in their range
CORNER = 1e-3  # share of the range of an angle beside its ends, at which it is looked at too
EDGE, END = (
    12,
    4,
)  # halvings towards where something begins to slip, and towards where the function ceases to have a value
WAYS = 2  # changes of the way between two places
CLOSE, SECTIONS = 30, 8  # steps to a root, sections towards a least size
SMOOTH = 0.01  # share by which it changes where it does not jump
DROP = 0.9  # how much less than beside it a least size is that is looked at
BESIDE = 1e-6  # share of the known root within which nothing is looked at
EXACT = 1e-10  # share of a number within which a root is known
GOLDEN = (math.sqrt(5) - 1) / 2
RIGHT_ANGLE = math.pi / 2

Reach = Callable[[float], "tuple[float, Hashable] | None"]  # a value, and which way all moves; None where it has none


class Look(Struct, frozen=True):
    """A place with what the quotient is there, and the way in which all moves; None of where there is nothing."""

    at: float
    value: float | None
    way: Hashable = None


class Scan:
    """The roots of a function beside a known one."""

    def __init__(self, function: Reach, root: float) -> None:
        self.function, self.root = function, root

    def look(self, at: float) -> Look:
        if abs(at - self.root) <= BESIDE * abs(self.root):
            at = self.root * (1.0 + BESIDE) or BESIDE
        found = self.function(at)
        if found is None:
            return Look(at, None)
        return Look(at, found[0] / (at - self.root), found[1])

    def roots(self, places: Sequence[float]) -> Iterator[float]:
        """The roots between neighbouring places, from the place that is nearest to the known one outwards."""
        looks = sorted(map(self.look, places), key=lambda look: look.at)
        looks = self.with_edges(looks)
        looks = self.with_least(looks)
        for low, high in pairwise(looks):
            if low.way == high.way and low.value is not None and high.value is not None:
                if low.value == 0.0:
                    yield low.at
                elif low.value * high.value < 0.0:
                    yield self.between(low, high)

    def with_edges(self, looks: Sequence[Look]) -> list[Look]:
        """The places, and those on both sides of where it begins to have a value or where something begins to slip."""
        found = list(looks[:1])
        for low, high in pairwise(looks):
            near = 1.0 / NEIGHBOURS < (high.at / low.at if low.at else 0.0) < NEIGHBOURS
            for _ in range(WAYS if near else 0):  # from one way through rest to the other
                if found[-1].way != high.way:
                    found += self.edge(found[-1], high)
            found.append(high)
        return found

    def edge(self, low: Look, high: Look) -> list[Look]:
        """The places nearest to each other, of all looked at between two, between which the way changes."""
        for _ in range(EDGE if low.value is not None and high.value is not None else END):
            middle = self.look(midst(low.at, high.at))
            low, high = (middle, high) if middle.way == low.way else (low, middle)
            if low.value and high.value and abs(low.value / high.value - 1.0) < SMOOTH:
                break
        return [low, high]

    def with_least(self, looks: Sequence[Look]) -> list[Look]:
        """The places, and between them such as are nearer to zero than both beside them, where the function comes to zero or beyond."""
        found = list(looks)
        for low, middle, high in zip(looks, looks[1:], looks[2:], strict=False):
            sides = [look.value for look in (low, middle, high)]
            if low.way == middle.way == high.way and None not in sides:
                a, b, c = (float(side or 0.0) for side in sides)
                if a * b > 0.0 and b * c > 0.0 and abs(b) <= min(abs(a), abs(c), DROP * max(abs(a), abs(c))):
                    found += self.least(low, high, b)
        return sorted(found, key=lambda look: look.at)

    def least(self, low: Look, high: Look, value: float) -> list[Look]:
        """The first place between two at which it has another sign than at them, by golden sections; none where it keeps its sign."""
        a, b = low.at, high.at
        places = [b - GOLDEN * (b - a), a + GOLDEN * (b - a)]
        looks = [self.look(place) for place in places]
        for _ in range(SECTIONS):
            for look in looks:
                if look.value is not None and look.value * value <= 0.0:
                    return [look]
            if away(looks[0]) <= away(looks[1]):
                b, looks = looks[1].at, [self.look(looks[1].at - GOLDEN * (looks[1].at - a)), looks[0]]
            else:
                a, looks = looks[0].at, [looks[1], self.look(looks[0].at + GOLDEN * (b - looks[0].at))]
        return []

    def between(self, low: Look, high: Look) -> float:
        """The root between two places with different signs, by the rule of Illinois."""
        (x, a), (y, b), kept = (low.at, low.value or 0.0), (high.at, high.value or 0.0), 0
        at = x
        for _ in range(CLOSE):
            at = y - b * (y - x) / (b - a)
            value = self.look(at).value
            if not value or abs(y - x) <= EXACT * abs(at):
                break
            if (value > 0.0) == (b > 0.0):
                y, b, a, kept = at, value, a / 2 if kept == -1 else a, -1
            else:
                x, a, b, kept = at, value, b / 2 if kept == 1 else b, 1
        return at


def away(look: Look) -> float:
    return math.inf if look.value is None else abs(look.value)


def midst(low: float, high: float) -> float:
    """Between two numbers, of one sign by their sizes."""
    return math.copysign(math.sqrt(low * high), low) if low * high > 0.0 else (low + high) / 2


def places_beside(root: float, unit: float, dimension: Dimension | None, wide: int = WIDE) -> list[float]:
    """Places over the range of a letter: sizes are positive, of both signs where the root is negative; angles those of the known one."""
    if dimension == ANGLE:
        low, high = (0.0, RIGHT_ANGLE) if 0.0 < root < RIGHT_ANGLE else (-math.pi, math.pi)
        shares = (CORNER, *((number + 0.5) / wide for number in range(wide)), 1.0 - CORNER)
        return [low + (high - low) * share for share in shares]
    powers = [(number + 0.5) / STEPS for number in range(-STEPS * DECADES, STEPS * DECADES)]
    sizes = [(abs(root) or unit) * 10.0**power for power in (*powers, *FAR)]
    return [*sizes, *(-size for size in sizes)] if root < 0.0 else sizes
