"""Taylor: a motion step by step, each step a polynomial in time whose order and length follow from the accuracy that is wanted.

Coefficients come from the tape: xₖ₊₁ = (rate of x)ₖ/(k + 1). The last ones tell how long a step may be (à la Jorba and Zou). What a step
adds is summed up with what rounding left out before, so that long runs do not lose it.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from itertools import accumulate, repeat
from operator import mul

from msgspec import Struct, field

from rotsolve.algebra.tape import ONE, ZERO
from rotsolve.core.symbols import TIME
from rotsolve.simulation.series import Arithmetic, Expansion
from rotsolve.simulation.system import System
from rotsolve.simulation.tape import Scalar

LEAST_ORDER, MOST_ORDER = 10, 150
WINDOW = 6  # last coefficients that tell how fast all of them fall; of a symmetric motion most vanish
SHORTEST = 1e-13  # of the time gone by: steps that short lead nowhere
SPLIT = 2.0**2 + 1  # the factor that rounds a float to two bits less (Veltkamp)
MOST = 1e100  # what a number of the state may grow to


class Unbounded(ValueError):
    """The motion can not be followed beyond a time: its steps become too short, or it leaves all bounds."""

    def __init__(self, time: float) -> None:
        super().__init__(f"the motion can not be followed beyond t = {time:g} s")
        self.time = time


class TaylorStep(Struct, frozen=True):
    """One step: from a time on, for a while, each number of the state as a polynomial of the time since then."""

    start: float
    length: float
    polynomials: tuple[list[Scalar], ...]
    watched: tuple[list[Scalar], ...] = ()  # of the values that are watched

    def at(self, time: Scalar) -> list[Scalar]:
        """The state at a time."""
        since = time - self.start
        return [horner(polynomial, since) for polynomial in self.polynomials]


def horner(polynomial: Sequence[Scalar], x: Scalar) -> Scalar:
    """Σ cₖ xᵏ by Horner's rule."""
    total = polynomial[-1]
    for coefficient in polynomial[-2::-1]:
        total = total * x + coefficient
    return total


def powers_of(x: Scalar, count: int) -> list[Scalar]:
    """xⁿ … x² x, the highest first."""
    return list(accumulate(repeat(x, count), mul))[::-1]


def order_for(tolerance: float) -> int:
    """The order at which a tolerance costs least, by measurement."""
    return min(MOST_ORDER, max(LEAST_ORDER, math.ceil(-0.65 * math.log(tolerance)) + 5))


class Stepper:
    """Expands the motion of a system, and the values that are `watched`, from a moment on, in floats or balls."""

    def __init__(
        self, system: System, arithmetic: Arithmetic, tolerance: float, order: int, watched: Sequence[int] = ()
    ) -> None:
        self.order, self.shortening = order, tolerance ** (1 / order)
        self.roots = {size: [1 / k for k in range(size - WINDOW, size)] for size in (order, order + 1)}
        self.expansion = Expansion(system.tape, [*(item.rate for item in system.variables), *watched], arithmetic)
        lists = self.expansion.lists
        self.letters = [system.letters[item.letter] for item in system.variables]
        self.own: list[list[Scalar]] = [lists.get(place, []) for place in self.letters]
        self.apart = [own for place, own in zip(self.letters, self.own, strict=True) if place not in lists]
        pairs = [(own, item.rate) for own, item in zip(self.own, system.variables, strict=True)]
        self.changing = [(own.append, lists[rate]) for own, rate in pairs if system.tape.constant(rate) is None]
        self.watched = [lists[place] for place in watched]
        self.time = system.letters[TIME]
        self.one, self.zero = arithmetic.number(ONE), arithmetic.number(ZERO)
        # what changes at a steady rate, with that: what no law changes, and time
        self.even = [(own.append, lists[rate]) for own, rate in pairs if system.tape.constant(rate) is not None]
        self.even += [(lists[self.time].append, [self.one])] if self.time in lists else []

    def expand(self, time: float, state: Sequence[Scalar]) -> TaylorStep:
        """The polynomials of the state and of what is watched from a moment on, as yet without an end."""
        for own in self.apart:  # letters on which no rate depends
            own.clear()
        self.expansion.begin({**dict(zip(self.letters, state, strict=True)), self.time: self.one * time})
        for own, start in zip(self.own, state, strict=True):
            if not own:
                own.append(start)
        changing, even, steps = self.changing, self.even, self.expansion.steps
        for order in range(1, self.order):
            for append, rate in changing:
                append(rate[order - 1] / order)
            for append, rate in even:
                append(rate[0] if order == 1 else self.zero)
            for step in steps:
                step(order)
        for append, rate in changing:
            append(rate[self.order - 1] / self.order)
        for append, _ in even:
            append(self.zero)
        found = tuple(own[:] for own in self.own)
        return TaylorStep(time, math.inf, found, tuple(series[: self.order] for series in self.watched))

    def length(self, polynomials: Sequence[Sequence[Scalar]], before: float) -> float:
        """How long a step these polynomials carry: what they leave out stays below the tolerance, as a part of each number's size.

        The size is that within a step as long as the one `before`.
        """
        longest = math.inf
        for polynomial in polynomials:
            ends = [*map(abs, map(float, polynomial[-WINDOW:]))]
            if not any(ends):
                continue
            zeroth, first, second = map(abs, map(float, polynomial[:3]))
            size = max(zeroth, first * before, second * before * before)
            size = size or max(abs(float(c)) * before**k for k, c in enumerate(polynomial))
            lengths = map(pow, [size / end if end else math.inf for end in ends], self.roots[len(polynomial)])
            longest = min(longest, *lengths)
        return float(longest * self.shortening)


def finite(polynomials: Sequence[Sequence[Scalar]]) -> bool:
    return all(math.isfinite(sum(map(float, polynomial[:3]))) for polynomial in polynomials)


class Trajectory(Struct):
    """A motion in one piece after the other, from the first moment on."""

    pieces: list[TaylorStep] = field(default_factory=list)
    starts: list[float] = field(default_factory=list)

    def add(self, piece: TaylorStep) -> None:
        self.pieces.append(piece)
        self.starts.append(float(piece.start))

    def piece_at(self, time: float) -> TaylorStep:
        return self.pieces[max(0, bisect_right(self.starts, time) - 1)]


class Walker:
    """Walks along a motion; what rounding leaves out of a state of floats is kept and added to the next step.

    A state of balls is taken at its middle after each step: the balls only carry the precision, the bounds come from a second run,
    which is `coarse`: it rounds its state of floats to fewer bits, and keeps nothing.
    """

    def __init__(self, stepper: Stepper, time: float, state: Sequence[Scalar], coarse: bool = False) -> None:
        self.stepper, self.time, self.state, self.coarse = stepper, time, list(state), coarse
        self.left: list[Scalar] = [0.0] * len(self.state)
        self.before = 0.0

    def piece(self, until: float) -> TaylorStep:
        """The polynomials from here on, for as long as they hold, not beyond `until`."""
        piece = self.stepper.expand(self.time, self.state)
        carried = (*piece.polynomials, *piece.watched)
        length = self.stepper.length(carried, self.before or until - self.time)
        if not self.before:
            for _ in range(3):
                length = self.stepper.length(carried, min(length, until - self.time))
        if length < SHORTEST * max(self.time, 1e-3) or not finite(carried):
            raise Unbounded(self.time)
        self.before = min(length, until - self.time)
        end = min(until, self.time + length)
        return TaylorStep(self.time, end - self.time, piece.polynomials, piece.watched)

    def walk(self, piece: TaylorStep, length: float) -> None:
        """Go on along a piece."""
        powers = powers_of(self.stepper.one * length, self.stepper.order)
        for number, polynomial in enumerate(piece.polynomials):
            added = sum(map(mul, polynomial[:0:-1], powers)) + self.left[number]
            before = self.state[number]
            after = before + added
            if isinstance(after, float):
                split = SPLIT * after
                self.left[number] = 0.0 if self.coarse else added - (after - before)
                after = split - (split - after) if self.coarse else after
            else:
                after = after.mid()
            self.state[number] = after
            if not abs(after) < MOST:
                raise Unbounded(self.time)
        self.time = piece.start + length
