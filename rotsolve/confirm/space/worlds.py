"""Worlds: how a rig moves at a state, and what forces that takes: all ways in which the equations let it.

The ties on velocities leave some rates open; a steady state then asks that the equations of motion leave nothing over, which is quadratic
in these rates: each root is a way of its own. What stays open even so gets numbers that mean nothing, several of them: what hangs on
those is not told.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from msgspec import Struct

from rotsolve.confirm.linear import General, solved_generally
from rotsolve.confirm.space.arrows import arrow_length, inner_product, times_arrow
from rotsolve.confirm.space.efforts import Efforts
from rotsolve.confirm.space.quadratics import quadratic, shared_roots
from rotsolve.confirm.space.rig import Lines, Rig, Told
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.ties import SPEED, Key, Rates, Tie, Ties, dotted, of_turning
from rotsolve.language.problem import State

RIGHT = 1e-8  # of the largest number: what is left of an equation that holds
ANY = (
    (0.0, 0.0),
    (0.618, -0.414),
    (-1.27, 0.732),
)  # how far along what is open: of the rates, of accelerations and reactions
ROUNDED = 1e-6  # of the largest I ω²: beside less than that nothing counts as left over


class World(Struct, frozen=True, dict=True):
    """One way in which all moves at a state: velocities, and accelerations with the unknown parts of forces."""

    stance: Stance
    efforts: Efforts
    now: Rates
    found: Rates


class Manner(Struct, frozen=True):
    """Worlds that differ only in what nothing tells, and how well the equations hold in them: 0 where they do."""

    worlds: tuple[World, ...]
    clash: float


class Equations:
    """Linear equations with keys for unknowns."""

    def __init__(self) -> None:
        self.places: dict[Key, int] = {}
        self.rows: list[dict[int, float]] = []

    def add(self, tie: Tie) -> None:
        row: dict[int, float] = {}
        for part, key in tie.terms:
            if part:
                place = self.places.setdefault(key, len(self.places))
                row[place] = row.get(place, 0.0) + part
        self.rows.append(row)

    def solve(self, right: Sequence[float], idle: Sequence[Tie] = ()) -> General:
        """All solutions; of those that are left open the ones in which what is `idle` is nothing, as far as that can be."""
        found = solved_generally(self.rows, right, len(self.places))
        if not (found.free and idle):
            return found
        right = list(right)
        if not self.take(idle, right):  # what is told may turn a massless body about some of its ways
            for tie in idle:
                self.take([tie], right)
        return solved_generally(self.rows, right, len(self.places))

    def take(self, ties: Sequence[Tie], right: list[float]) -> bool:
        """Whether ties with nothing on their right side go with all that is there; else they are left out again."""
        told, places = list(self.rows), dict(self.places)
        for tie in ties:
            self.add(tie)
        found = solved_generally(self.rows, [*right, *(0.0 for _ in ties)], len(self.places))
        fits = max(map(abs, found.left), default=0.0) <= RIGHT * found.size
        if fits:
            right += [0.0 for _ in ties]
        else:
            self.rows, self.places = told, places
        return fits

    def named(self, values: Sequence[float]) -> Rates:
        return Rates({key: values[place] for key, place in self.places.items()})


class Moving:
    """All that can be said of a stance: its velocities, and for each choice of the open ones its accelerations and forces."""

    def __init__(self, stance: Stance, more: Iterable[Tie] = ()) -> None:
        self.stance, self.efforts = stance, Efforts(stance)
        ties = [tie for tie in (*Ties(stance).all(), *more) if tie.speed is not None]
        speeds = Equations()
        for tie in ties:
            speeds.add(tie)
        for name in stance.rig.bodies:
            for kind in (SPEED, "turning"):
                for k in range(3):
                    speeds.places.setdefault((kind, name, k), len(speeds.places))
        self.speeds = speeds
        self.idle = [
            Tie(dotted(of_turning(name), times_arrow(stance.turned(name), way)))
            for name in stance.rig.bodies
            if not any(stance.lines.told(name, word) is not None for word in ("spin", "axial_rate"))
            for way in stance.rig.idle(name)
        ]
        self.moving = speeds.solve([tie.speed or 0.0 for tie in ties], self.idle)
        self.apart = stance.apart()
        off = max(map(abs, self.moving.left), default=0.0) / self.moving.size
        self.broken = max([off, *map(abs, self.apart)])

    def rates(self, openly: Sequence[float]) -> Rates:
        """The velocities, with so much of each that is open."""
        values = list(self.moving.values)
        for part, way in zip(openly, self.moving.free, strict=True):
            if part:
                values = [value + part * step for value, step in zip(values, way, strict=True)]
        return self.speeds.named(values)

    def forced(self, now: Rates, idle: Sequence[Tie] = ()) -> tuple[Equations, General]:
        """Accelerations and forces that go with velocities; what is `idle` does not turn any faster where nothing tells."""
        equations, right = Equations(), []
        for tie in (*Ties(self.stance, now).all(), *self.efforts.laws(now)):
            if tie.gain is not None:
                equations.add(tie)
                right.append(tie.gain)
        return equations, equations.solve(right, idle)

    def over(self, openly: Sequence[float]) -> list[float]:
        """What is left of the equations of motion, by the side of the largest number in them."""
        _, found = self.forced(self.rates(openly))
        return found.left

    def hangs_on_rates(self) -> bool:
        """Whether something is left of the equations of motion, and it is another with other rates of those that are open."""
        count = len(self.moving.free)
        still = self.over([0.0] * count) if count else []
        if not any(still):
            return False
        _, found = self.forced(self.rates([natural_rate(self) * part for part in anyhow(count, 1)]))
        return any(abs(a - b) > RIGHT * found.size for a, b in zip(found.left, still, strict=True))

    def whirl(self, now: Rates) -> float:
        """The largest I ω²: ω × (I ω) is rounded to a small part of it, though nothing of it may be left."""
        sizes = [0.0]
        for name in self.stance.rig.bodies:
            omega, rows = now.arrow("turning", name), self.stance.rig.solid(name).tensor
            sizes.append(inner_product(omega, omega) * max(map(arrow_length, rows)))
        return max(sizes)

    def way(self, choices: Iterable[Sequence[float]]) -> Manner:
        """The worlds of some choices of what is open, which differ in nothing that is told."""
        worlds, clash = [], self.broken
        for number, openly in enumerate(choices, 1):
            now = self.rates(openly)
            equations, found = self.forced(now, self.idle)
            size = max(found.size, ROUNDED * self.whirl(now))
            clash = max(clash, max(map(abs, found.left), default=0.0) / size)
            for several in range(2 if found.free else 1):
                values = list(found.values)
                for place, step in enumerate(found.free):
                    share = ANY[number % len(ANY)][place % 2] * (1.0 + 0.3 * place) * several * found.size
                    values = [value + share * part for value, part in zip(values, step, strict=True)]
                worlds.append(World(self.stance, self.efforts, now, equations.named(values)))
        return Manner(tuple(worlds), clash)


def manners_of(rig: Rig, state: State | None, told: Told) -> list[Manner]:
    """All ways in which a rig may move at a state."""
    stance = Stance(rig, Lines(rig, state, told))
    standing = Moving(stance)
    count = len(standing.moving.free)
    if stance.open:
        others = [Moving(Stance(rig, Lines(rig, state, told), guess)) for guess in (1.1, 1.9)]
        ways = [one.way([anyhow(count, number)]) for number, one in enumerate([standing, *others], 1)]
        return [Manner(tuple(world for way in ways for world in way.worlds), max(way.clash for way in ways))]
    choices = [anyhow(count, number) for number in range(3 if count else 1)]
    tested = rates_tested(standing, count) if count and standing.stance.lines.steady else []
    roots = steady_roots(standing, tested, count) if tested else None
    if roots is None:
        return [standing.way(choices)]
    untested = len(tested) < count  # what is still open, in each of them
    return [standing.way([with_rates(one, tested, root) for one in choices[: 3 if untested else 1]]) for root in roots]


def with_rates(openly: Sequence[float], places: Sequence[int], rates: Sequence[float]) -> list[float]:
    """Some of what is open put to other numbers."""
    found = list(openly)
    for place, rate in zip(places, rates, strict=True):
        found[place] = rate
    return found


def anyhow(count: int, number: int) -> list[float]:
    """Numbers for what is open: they mean nothing."""
    first, second = ANY[number % len(ANY)]
    return [(first if place % 2 else second) * (1.0 + 0.37 * place) + 0.2 * number for place in range(count)]


# steady motions


def rates_tested(standing: Moving, count: int) -> list[int]:
    """Which of the open rates change what the equations of motion leave over; the velocity of a free body does not."""
    if count == 1:
        return [0]
    scale, found = natural_rate(standing), []
    start = [scale * part for part in anyhow(count, 1)]
    here = standing.over(start)
    most = max(map(abs, here), default=0.0)
    for place in range(count):
        beside = (standing.over(with_rates(start, [place], [start[place] + step * scale])) for step in (1.0, -1.0))
        if any(abs(a - b) > RIGHT * max(most, abs(a)) for left in beside for a, b in zip(left, here, strict=True)):
            found.append(place)
    return found


def steady_roots(standing: Moving, tested: Sequence[int], count: int) -> list[list[float]] | None:
    """The rates with which nothing is left over; None where all are as good."""
    scale = natural_rate(standing)
    model = quadratic(lambda rates: standing.over(with_rates([0.0] * count, tested, rates)), len(tested), scale)
    if model is None:
        return None
    return [[part * scale for part in root] for root in shared_roots(model)]


def natural_rate(standing: Moving) -> float:
    """A rate such as the scene has: the largest that is told, or √(g/l)."""
    sizes = [abs(value) for value in standing.moving.values]
    return max([*sizes, math.sqrt(standing.stance.rig.gravity), 1.0])
