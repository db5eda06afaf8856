"""Steps: a motion q̈ = f(t, q, q̇) followed in time by collocation: q̈ is a polynomial through Radau's places of each step.

The ends of a step of width h are right to the order h¹¹; while q̈ stays as it is, one step is as long as it is asked to be, and exact.
A law may tell more behind q̈ (how far what holds is from giving way): a step is as short as this takes to be a polynomial too.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache

from msgspec import Struct

from rotsolve.confirm import NotConfirmed

Numbers = list[float]
Law = Callable[[float, Numbers, Numbers], Numbers]  # q̈ by time, q and q̇, and what else it tells

PLACES = (0.0, 0.09853508579882625, 0.30453572664636386, 0.5620251897526138, 0.8019865821263917, 0.9601901429485313)
ROUNDS = 14  # of the iteration for q̈ at the places
SETTLED = 1e-10  # relative change of q̈ at which it has come to rest
BEND = 1e-2  # share of the last power in q̈ that a step may have: the ends are then right to some 1e-10
SAME = 1e-9  # relative change of q̈ within which it counts as constant


class RadauRule(Struct, frozen=True):
    """Integrals of Lagrange's polynomials of the places: up to each place, up to the end, once and twice; and their coefficients."""

    powers: list[Numbers]
    once: list[Numbers]
    twice: list[Numbers]
    weights: Numbers
    double: Numbers


@cache
def rule() -> RadauRule:
    """The rule for the places, worked out where the first step needs it."""
    powers = []
    for own in PLACES:
        row, scale = [1.0], 1.0
        for other in PLACES:
            if other != own:
                row = [a - other * b for a, b in zip([0.0, *row], [*row, 0.0], strict=True)]
                scale *= own - other
        powers.append([part / scale for part in row])
    once = [[row_integral(row, end) for row in powers] for end in PLACES]
    twice = [[second(row, end) for row in powers] for end in PLACES]
    return RadauRule(
        powers, once, twice, [row_integral(row, 1.0) for row in powers], [second(row, 1.0) for row in powers]
    )


def row_integral(row: Sequence[float], end: float) -> float:
    return sum(part * end ** (n + 1) / (n + 1) for n, part in enumerate(row))


def second(row: Sequence[float], end: float) -> float:
    return sum(part * end ** (n + 2) / ((n + 1) * (n + 2)) for n, part in enumerate(row))


class TimeStep(Struct, frozen=True):
    """A stretch of the motion: from `time` on for `width`, with q̈ at the places (at the first alone where it is constant)."""

    time: float
    width: float
    place: Numbers
    speed: Numbers
    pushes: list[Numbers]

    def at(self, part: float) -> tuple[Numbers, Numbers]:
        """q and q̇ after a part of the width, between 0 and 1."""
        if len(self.pushes) == 1:
            once, twice = [part], [part * part / 2.0]
        elif part == 1.0:
            once, twice = rule().weights, rule().double
        else:
            once = [row_integral(row, part) for row in rule().powers]
            twice = [second(row, part) for row in rule().powers]
        return collocated(self.place, self.speed, self.pushes, self.width, part, once, twice)

    def push(self, part: float) -> Numbers:
        """q̈ after a part of the width, and what else the law tells."""
        if len(self.pushes) == 1:
            return self.pushes[0]
        shares = [sum(c * part**n for n, c in enumerate(row)) for row in rule().powers]
        return [sum(s * p for s, p in zip(shares, column, strict=True)) for column in zip(*self.pushes, strict=True)]


def collocated(
    place: Numbers, speed: Numbers, pushes: list[Numbers], width: float, part: float, once: Numbers, twice: Numbers
) -> tuple[Numbers, Numbers]:
    """q + h s q̇ + h² Σ B a and q̇ + h Σ A a."""
    square, along = width * width, width * part
    numbers = range(len(place))
    columns = [[push[i] for push in pushes] for i in numbers]
    places = [
        place[i] + along * speed[i] + square * sum([b * a for b, a in zip(twice, columns[i], strict=True)])
        for i in numbers
    ]
    speeds = [speed[i] + width * sum([b * a for b, a in zip(once, columns[i], strict=True)]) for i in numbers]
    return places, speeds


def stretch(
    law: Law, time: float, place: Numbers, speed: Numbers, width: float, push: Numbers, known_of: TimeStep | None
) -> TimeStep | None:
    """One step of this width from where q̈ is `push`, which a step before or about it foretells; None where it is too long."""
    known = rule()
    pushes = [push] * len(PLACES)
    if known_of is not None and len(known_of.pushes) > 1 and len(known_of.pushes[0]) == len(push):
        since = time - known_of.time
        pushes[1:] = [known_of.push((since + part * width) / known_of.width) for part in PLACES[1:]]
    for _ in range(ROUNDS):
        change, size = 0.0, 1e-300
        for number in range(1, len(PLACES)):
            q, v = collocated(place, speed, pushes, width, PLACES[number], known.once[number], known.twice[number])
            found = law(time + PLACES[number] * width, q, v)
            if not math.isfinite(sum(found)):  # what has no number is not larger than anything
                return None
            moved = [(abs(found[i] - pushes[number][i]), abs(found[i])) for i in range(len(place))]
            change = max(change, max([by for by, _ in moved], default=0.0))
            size = max(size, max([large for _, large in moved], default=0.0))
            pushes[number] = found
        if change <= SETTLED * size:
            return TimeStep(time, width, place, speed, pushes)
        if change > 1e6 * size:
            break
    return None


def apart_from_rates(values: Sequence[float], step: Sequence[float]) -> tuple[Sequence[float], Sequence[float]]:
    """q̈, and what else a law tells, which is of another size."""
    return values[: len(step)], values[len(step) :]


def most_of(values: Sequence[float]) -> float:
    return max(map(abs, values), default=0.0)


def roughness(step: TimeStep) -> float:
    """The share of the highest power in q̈ over the step, or in what else its law tells."""
    last = [
        sum(row[-1] * a for row, a in zip(rule().powers, own, strict=True)) for own in zip(*step.pushes, strict=True)
    ]
    sizes = [most_of(own) for own in zip(*step.pushes, strict=True)]
    shares = zip(apart_from_rates(last, step.place), apart_from_rates(sizes, step.place), strict=True)
    return max(most_of(own) / most_of(size) if most_of(size) else 0.0 for own, size in shares)


def is_constant(law: Law, time: float, place: Numbers, speed: Numbers, width: float, push: Numbers) -> bool:
    """Whether q̈ is the same in the midst and at the end of a stretch, and what else the law tells."""
    bare = TimeStep(time, width, place, speed, [push])
    for part in (1.0, 0.4):
        found = law(time + part * width, *bare.at(part))
        if len(found) != len(push):
            return False
        for now, then in zip(apart_from_rates(found, place), apart_from_rates(push, place), strict=True):
            change = most_of([a - b for a, b in zip(now, then, strict=True)])
            if change > SAME * max(1e-300, most_of(now), most_of(then)):
                return False
    return True


def adapted(
    law: Law,
    time: float,
    place: Numbers,
    speed: Numbers,
    width: float,
    push: Numbers,
    known_of: TimeStep | None = None,
) -> tuple[TimeStep, float]:
    """A step that is as long as it may be, and the width to try next."""
    for _ in range(60):
        try:
            step = stretch(law, time, place, speed, width, push, known_of)
        except ArithmeticError:
            step = None
        if step is not None:
            rough = roughness(step)
            if rough <= BEND:
                return step, width * min(4.0, 0.8 * (BEND / max(rough, 1e-12)) ** 0.2)
            width *= max(0.1, 0.8 * (BEND / rough) ** 0.2)
        else:
            width *= 0.3
    raise NotConfirmed("the motion is too rough to follow")
