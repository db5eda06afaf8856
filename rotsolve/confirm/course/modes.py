"""Modes: the frequencies of bodies that swing in several ways, from steps of all coordinates about an equilibrium that is found by itself.

M is that of the motions in which one free coordinate alone has a rate, K by how the accelerations change with each of them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from msgspec import Struct

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.following import Course
from rotsolve.confirm.course.node import Node
from rotsolve.confirm.course.reading import Reckoned, number
from rotsolve.confirm.course.swings import STEP, Neighbourhood, weighed
from rotsolve.confirm.linear import solved
from rotsolve.language.problem import MODE, Term

ROUGH, SAME = 1e-4, 1e-6  # shares of the largest ω²: by which two steps may differ, below which a mode does not swing
GRADUAL, TRIES, STILL = 40, 60, 1e-9
Square = list[list[float]]


class OwnMotion(Struct, frozen=True):
    """ω of a mode, and the rates of all coordinates of the model in it."""

    rate: float
    shape: list[float]


class Modes(Neighbourhood):
    """All that is free about the equilibrium that is told, or that is found downhill from where things are drawn."""

    def __init__(self, first: Node, owner: str, *, told: bool) -> None:
        super().__init__(first)
        self.indices = self.free(owner)
        self.told = told
        if not self.indices:
            raise NotConfirmed("nothing of it can swing")

    def pushes_at(self, values: Sequence[float]) -> list[float]:
        """The second rates of the free coordinates."""
        found = self.moment_at(self.at_all(dict(zip(self.indices, values, strict=True)))).rates
        return [found[index] for index in self.indices]

    def equilibrium(self) -> list[float]:
        """Where nothing pushes: as told, else downhill and then by Newton's way."""
        values = [self.first.placed.q[index] for index in self.indices]
        if self.told:
            if max(map(abs, self.pushes_at(values))) > 1e-7 * max(self.model.gravity, 1.0):
                raise NotConfirmed("what is said to be an equilibrium is none")
            return values
        step = 0.5
        values = [value + 0.1 * (k + 1) for k, value in enumerate(values)]
        before = self.pushes_at(values)
        for _ in range(GRADUAL):
            size = math.sqrt(sum(push * push for push in before))
            if size < 1e-2:
                break
            further = [value + step * push / size for value, push in zip(values, before, strict=True)]
            after = self.pushes_at(further)
            if sum(a * b for a, b in zip(before, after, strict=True)) < 0.0:
                step *= 0.5
            values, before = further, after
        return self.newton(values)

    def newton(self, values: list[float]) -> list[float]:
        """Where nothing pushes, near some values; ways in which nothing ever pushes stay."""
        for _ in range(TRIES):
            push = self.pushes_at(values)
            if max(map(abs, push)) < STILL * max(self.model.gravity, 1.0):
                return values
            slope = self.slopes(values, STEP)
            rows = [dict(enumerate(row)) for row in slope]
            change = solved(rows, [-part for part in push], len(values)).values
            values = [value + max(-0.2, min(0.2, part)) for value, part in zip(values, change, strict=True)]
        raise NotConfirmed("no equilibrium was found")

    def slopes(self, values: Sequence[float], step: float) -> Square:
        """How the second rates change with the coordinates."""
        columns = []
        for place in range(len(values)):
            beside = [[*values[:place], values[place] + side, *values[place + 1 :]] for side in (step, -step)]
            up, down = (self.pushes_at(one) for one in beside)
            columns.append([(high - low) / (2.0 * step) for high, low in zip(up, down, strict=True)])
        return [list(row) for row in zip(*columns, strict=True)]

    def motions(self, values: Sequence[float]) -> Square:
        """The rates of all coordinates where one of the free ones has the rate 1 and the others none."""
        rows = [slope for slope, _ in self.rows(self.at_all(dict(zip(self.indices, values, strict=True))))]
        fixed = [*rows, *({index: 1.0} for index in self.indices)]
        right = [0.0] * len(rows)
        unit = [[1.0 if one == other else 0.0 for other in self.indices] for one in self.indices]
        return [solved(fixed, [*right, *one], self.model.size).values for one in unit]

    def modes(self) -> list[OwnMotion]:
        """All modes that swing, the slowest first; a slope of the wrong sign is no stable equilibrium."""
        values = self.equilibrium()
        wide, near = self.slopes(values, 2.0 * STEP), self.slopes(values, STEP)
        most = max(abs(part) for row in near for part in row)
        rough = max(abs(a - b) for r, s in zip(wide, near, strict=True) for a, b in zip(r, s, strict=True))
        if most == 0.0 or rough > ROUGH * most:
            raise NotConfirmed("swings beside which a push bends sharply")
        ways = self.motions(values)
        inertia = [[weighed(self.model.masses, one, other) for other in ways] for one in ways]
        slope = [
            [(4.0 * b - a) / 3.0 for a, b in zip(far, close, strict=True)]
            for far, close in zip(wide, near, strict=True)
        ]
        size = range(len(ways))
        stiffness = [[-sum(inertia[i][k] * slope[k][j] for k in size) for j in size] for i in size]
        stiffness = [[(stiffness[i][j] + stiffness[j][i]) / 2.0 for j in size] for i in size]
        found = []
        squares = general_eigen(stiffness, inertia)
        largest = max(abs(square) for square, _ in squares)
        for square, shape in squares:
            if square < -SAME * largest:
                raise NotConfirmed("the equilibrium is unstable")
            if square > SAME * largest:
                rates = [
                    sum(part * way[k] for part, way in zip(shape, ways, strict=True)) for k in range(self.model.size)
                ]
                found.append(OwnMotion(math.sqrt(square), rates))
        return found


def general_eigen(stiffness: Square, inertia: Square) -> list[tuple[float, list[float]]]:
    """ω² and shapes of K v = ω² M v, the smallest first: by M = L Lᵀ and Jacobi's rotations of L⁻¹ K L⁻ᵀ."""
    size = range(len(inertia))
    lower: Square = [[0.0 for _ in size] for _ in size]
    for i in size:
        for j in range(i + 1):
            rest = inertia[i][j] - sum(lower[i][k] * lower[j][k] for k in range(j))
            if i == j and rest <= 0.0:
                raise NotConfirmed("something without a mass moves by itself")
            lower[i][j] = math.sqrt(rest) if i == j else rest / lower[j][j]
    half = [forward_substituted(lower, column) for column in zip(*stiffness, strict=True)]
    squared = [forward_substituted(lower, row) for row in zip(*half, strict=True)]
    values, vectors = by_rotations(squared)
    found = [(values[k], back_substituted(lower, [vectors[i][k] for i in size])) for k in size]
    return sorted(found, key=lambda pair: pair[0])


def forward_substituted(lower: Square, right: Sequence[float]) -> list[float]:
    """x of L x = b."""
    found: list[float] = []
    for i, row in enumerate(lower):
        found.append((right[i] - sum(row[k] * found[k] for k in range(i))) / row[i])
    return found


def back_substituted(lower: Square, right: Sequence[float]) -> list[float]:
    """x of Lᵀ x = b."""
    size, found = len(lower), [0.0] * len(lower)
    for i in reversed(range(size)):
        found[i] = (right[i] - sum(lower[k][i] * found[k] for k in range(i + 1, size))) / lower[i][i]
    return found


def by_rotations(matrix: Square) -> tuple[list[float], Square]:
    """The eigenvalues of a symmetric matrix, and its eigenvectors as columns."""
    size = range(len(matrix))
    a, v = [list(row) for row in matrix], [[float(i == j) for j in size] for i in size]
    for _ in range(TRIES):
        off = [(abs(a[i][j]), i, j) for i in size for j in range(i)]
        if not off or max(off)[0] < 1e-14 * max(abs(a[i][i]) for i in size):
            break
        for _, i, j in off:
            turn = 0.5 * math.atan2(2.0 * a[i][j], a[i][i] - a[j][j])
            c, s = math.cos(turn), math.sin(turn)
            for row in (*a, *v):
                row[i], row[j] = c * row[i] + s * row[j], c * row[j] - s * row[i]
            a[i], a[j] = (
                [c * x + s * y for x, y in zip(a[i], a[j], strict=True)],
                [c * y - s * x for x, y in zip(a[i], a[j], strict=True)],
            )
    return [a[i][i] for i in size], v


def in_mode(course: Course, term: Term) -> Reckoned:
    """The period or frequency of a mode, or the ratio of two displacements in it."""
    from rotsolve.confirm.course.swings import period_as_asked

    name = term.at or course.names[0]
    state = course.states[course.names.index(name)]
    about = term.at is not None or state.balance
    modes = Modes(course.node(name), term.path.owner, told=about and state.balance).modes()
    place = int(term.modifier.removeprefix(MODE)) if term.modifier.startswith(MODE) else 1
    if place > len(modes) or (not term.modifier.startswith(MODE) and len(modes) > 1):
        raise NotConfirmed(f"{len(modes)} modes were found")
    mode = modes[place - 1]
    if term.other is None:
        return period_as_asked(2.0 * math.pi / mode.rate, term.path.quantity)
    beside = [other.rate for other in modes if other is not mode]
    if any(abs(other - mode.rate) < 1e-5 * mode.rate for other in beside):
        raise NotConfirmed("two modes of one frequency")
    top, bottom = (
        displacement_in(mode, course.node(name), other.path.owner, str(other.path.component))
        for other in (term, term.other)
    )
    if abs(bottom) < 1e-9 * max(map(abs, mode.shape)):
        raise NotConfirmed("a ratio to what stays at rest")
    return number(top / bottom)


def displacement_in(mode: OwnMotion, node: Node, owner: str, way: str) -> float:
    """How far a body is displaced, or turned, in a mode, along its positive sense."""
    model = node.model
    seat, (word, _, axis) = model.seats[owner], way.partition(" ")
    x, y, turn = mode.shape[seat.first : seat.first + 3]
    if word == "rotation":
        return turn * model.sense(owner)
    if turn and seat.rigid.centre != (0.0, 0.0):
        raise NotConfirmed("a displacement of what is not uniform")
    if axis:
        return x if axis == "x" else y
    line = model.line(owner)
    if line is None:
        raise NotConfirmed("a displacement along no line")
    return x * line[0] + y * line[1]
