"""Equations of a layout: where things go, by what must be and by what is wished, solved by least squares.

What must be weighs so much more than what is wished that it holds as exactly as paper shows; what nothing tells stays near its place.
"""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct, field

MUST, WISH, NEAR = 300.0, 1.0, 0.01


class Affine(Struct, frozen=True):
    """A number that depends linearly on unknowns."""

    slope: Mapping[int, float]
    value: float = 0.0

    def plus(self, other: Affine, times: float = 1.0) -> Affine:
        slope = dict(self.slope)
        for index, part in other.slope.items():
            slope[index] = slope.get(index, 0.0) + times * part
        return Affine(slope, self.value + times * other.value)

    def at(self, unknowns: list[float]) -> float:
        return self.value + sum(part * unknowns[index] for index, part in self.slope.items())


Place = tuple[Affine, Affine]


def told_place(x: float, y: float) -> Place:
    """A place that is told."""
    return Affine({}, x), Affine({}, y)


def place_off(place: Place, by: tuple[float, float]) -> Place:
    """A place beside another."""
    return Affine(place[0].slope, place[0].value + by[0]), Affine(place[1].slope, place[1].value + by[1])


def gap_between_places(first: Place, second: Place) -> Place:
    """The way from one place to another."""
    return second[0].plus(first[0], -1.0), second[1].plus(first[1], -1.0)


def part_along(way: Place, direction: tuple[float, float]) -> Affine:
    """How much of a way lies along a direction."""
    return Affine({}).plus(way[0], direction[0]).plus(way[1], direction[1])


class Layout(Struct):
    """Gathers the equations of unknowns, and solves them."""

    count: int
    rows: list[tuple[Affine, float, float]] = field(default_factory=list)

    def unknown(self, near: float = 0.0) -> Affine:
        """One more unknown, near a number where nothing else tells it."""
        index, self.count = self.count, self.count + 1
        self.equal(Affine({index: 1.0}), near, NEAR)
        return Affine({index: 1.0})

    def equal(self, left: Affine, right: float = 0.0, weight: float = MUST) -> None:
        """Wants something to be a number."""
        if left.slope:
            self.rows.append((left, right, weight))

    def meet(self, first: Place, second: Place, weight: float = MUST) -> None:
        """Wants two places to be one."""
        for part in gap_between_places(first, second):
            self.equal(part, 0.0, weight)

    def solved(self) -> list[float]:
        """The unknowns by which the weighted squares of all that is missed are least."""
        n = self.count
        matrix = [[0.0] * (n + 1) for _ in range(n)]
        for left, right, weight in self.rows:
            gap, square = right - left.value, weight * weight
            for i, own in left.slope.items():
                row, factor = matrix[i], square * own
                row[n] += factor * gap
                for j, other in left.slope.items():
                    row[j] += factor * other
        return least_squares(matrix)

    def groups(self, weight: float = WISH) -> list[int]:
        """For each unknown the number of its group: unknowns that equations of so much weight tie together."""
        group = list(range(self.count))
        for left, _, own in self.rows:
            if own >= weight and len(left.slope) > 1:
                names = {group[index] for index in left.slope}
                group = [min(names) if name in names else name for name in group]
        return group


def least_squares(matrix: list[list[float]]) -> list[float]:
    """The solution of a positive definite system, by elimination; the last column is its right side."""
    n = len(matrix)
    for k in range(n):
        pivot = matrix[k]
        head = pivot[k]
        for row in matrix[k + 1 :]:
            factor = row[k] / head if row[k] else 0.0
            if factor:
                for j in range(k, n + 1):
                    row[j] -= factor * pivot[j]
    found = [0.0] * n
    for k in reversed(range(n)):
        row = matrix[k]
        found[k] = (row[n] - sum(row[j] * found[j] for j in range(k + 1, n))) / row[k]
    return found
