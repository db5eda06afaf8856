"""Taylor: a motion step by step, each step a polynomial in time whose order and length follow from the accuracy that is wanted.

Coefficients come from the tape: xₖ₊₁ = (rate of x)ₖ/(k + 1). The last two tell how long a step may be (à la Jorba and Zou). What a step
adds is summed up with what rounding left out before, so that long runs do not lose it.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence

from msgspec import Struct, field

from rotsolve.core.registry import TIME
from rotsolve.simulation.course import Course
from rotsolve.simulation.series import Arithmetic, Expansion, Scalar
from rotsolve.simulation.tape import ONE, ZERO

LEAST_ORDER, MOST_ORDER = 4, 150
SHORTEST = 1e-13  # of the time gone by: steps that short lead nowhere
SPLIT = 2.0**2 + 1  # the factor that rounds a float to two bits less (Veltkamp)
MOST = 1e100  # what a number of the state may grow to


class Unbounded(ValueError):
    """The motion can not be followed beyond a time: its steps become too short, or it leaves all bounds."""

    def __init__(self, time: float) -> None:
        super().__init__(f"the motion can not be followed beyond t = {time:g} s")
        self.time = time


class Piece(Struct, frozen=True):
    """One step: from a time on, for a while, each number of the state as a polynomial of the time since then."""

    start: Scalar
    length: Scalar
    polynomials: tuple[list[Scalar], ...]

    def at(self, time: Scalar) -> list[Scalar]:
        """The state at a time."""
        since = time - self.start
        return [value(polynomial, since) for polynomial in self.polynomials]


def value(polynomial: Sequence[Scalar], x: Scalar) -> Scalar:
    """Σ cₖ xᵏ by Horner's rule."""
    total = polynomial[-1]
    for coefficient in polynomial[-2::-1]:
        total = total * x + coefficient
    return total


def order_for(tolerance: float) -> int:
    """The order at which a tolerance costs least, by measurement."""
    return min(MOST_ORDER, max(LEAST_ORDER, math.ceil(-0.5 * math.log(tolerance)) + 6))


class Stepper:
    """Takes steps of a course from a time and state on, in floats or balls, to a tolerance per step."""

    def __init__(self, course: Course, arithmetic: Arithmetic, tolerance: float, order: int) -> None:
        self.course, self.tolerance, self.order = course, tolerance, order
        tape = course.tape
        self.variables = course.variables
        self.expansion = Expansion(tape, [item.rate for item in self.variables], arithmetic)
        lists = self.expansion.lists
        self.letters = [course.letters[item.letter] for item in self.variables]
        self.own: list[list[Scalar]] = [lists.get(place, []) for place in self.letters]
        self.rates = [lists[item.rate] for item in self.variables]
        self.clock = lists.get(course.letters[TIME])
        self.one, self.zero = arithmetic.number(ONE), arithmetic.number(ZERO)

    def moment(self, time: float) -> Scalar:
        return self.one * time

    def expand(self, time: Scalar, state: Sequence[Scalar]) -> list[list[Scalar]]:
        """The polynomials of the state from a moment on."""
        polynomials = list(zip(self.own, self.rates, strict=True))
        self.expansion.begin({**dict(zip(self.letters, state, strict=True)), self.course.letters[TIME]: time})
        for own, start in zip(self.own, state, strict=True):
            if not own:
                own.append(start)
        for order in range(1, self.order + 1):
            for own, rate in polynomials:
                own.append(rate[order - 1] / order if order <= len(rate) else self.zero)
            if order == self.order:
                break
            if self.clock is not None:
                self.clock.append(self.one if order == 1 else self.zero)
            self.expansion.extend(order)
        found = [own[:] for own in self.own]
        for place, own in zip(self.letters, self.own, strict=True):
            if place not in self.expansion.lists:
                own.clear()
        return found

    def length(self, polynomials: Sequence[Sequence[Scalar]], before: float) -> float:
        """How long a step these polynomials carry: what they leave out stays below the tolerance, as a part of each number's size.

        The size is that within a step as long as the one `before`.
        """
        longest = math.inf
        for polynomial in polynomials:
            last = len(polynomial) - 1
            ends = [(k, abs(float(polynomial[k]))) for k in (last, last - 1)]
            if not any(end for _, end in ends):
                continue
            sizes = (abs(float(polynomial[k])) * before**k for k in range(3))
            size = max(sizes) or max(abs(float(c)) * before**k for k, c in enumerate(polynomial))
            for k, end in ends:
                if end:
                    longest = min(longest, (self.tolerance * size / end) ** (1 / k))
        return longest


def finite(polynomials: Sequence[Sequence[Scalar]]) -> bool:
    return all(math.isfinite(float(coefficient)) for polynomial in polynomials for coefficient in polynomial[:3])


class Motion(Struct):
    """A motion in one piece after the other, from the first moment on."""

    pieces: list[Piece] = field(default_factory=list)
    starts: list[float] = field(default_factory=list)

    def add(self, piece: Piece) -> None:
        self.pieces.append(piece)
        self.starts.append(float(piece.start))

    def piece_at(self, time: float) -> Piece:
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

    def piece(self, until: float) -> Piece:
        """The polynomials from here on and how long they hold, not beyond `until`."""
        polynomials = self.stepper.expand(self.stepper.moment(self.time), self.state)
        length = self.stepper.length(polynomials, self.before or until - self.time)
        if not self.before:
            for _ in range(3):
                length = self.stepper.length(polynomials, min(length, until - self.time))
        if length < SHORTEST * max(self.time, 1e-3) or not finite(polynomials):
            raise Unbounded(self.time)
        self.before = min(length, until - self.time)
        end = min(until, self.time + length)
        return Piece(self.time, end - self.time, tuple(polynomials))

    def walk(self, piece: Piece, length: float) -> None:
        """Go on along a piece."""
        for number, polynomial in enumerate(piece.polynomials):
            added = value(polynomial[1:], length) * length + self.left[number]
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
