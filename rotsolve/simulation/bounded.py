"""Bounded: a motion followed twice, so that the difference tells how far each number may be from the true one.

The second run takes longer steps, and all constants from the other side of their true values: what is left out by
the steps, by rounding, and by the data as floats, differs between the two, and grows in both as the motion makes it grow.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

from msgspec import Struct, field

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import arb
from rotsolve.simulation.course import Course
from rotsolve.simulation.series import BALLS, FLOATS, OTHER_FLOATS, Expansion, Scalar
from rotsolve.simulation.taylor import Motion, Stepper, Walker, order_for

SAFETY = 3.0  # what the difference of the two runs is multiplied by
COARSER = 5.0  # how much larger the tolerance of the second run is
FINEST = 2e-17  # tolerance of a step in floats below which nothing is gained
ROUNDING = 2.0**-51  # of a number: what dense output may add
FLOAT_BITS = 53


class Stretch(Struct):
    """A part of a motion along which the equations stay the same: the two runs, and the bounds of the state so far at each step."""

    course: Course
    bits: int
    start: float
    end: float
    runs: tuple[Motion, Motion] = field(default_factory=lambda: (Motion(), Motion()))
    bounds: list[list[float]] = field(default_factory=list)

    def state(self, time: float) -> list[Scalar]:
        """The numbers of the state as balls that hold the true ones."""
        main = self.runs[0]
        piece = main.piece_at(time)
        number = min(bisect_right(main.starts, time), len(self.bounds)) - 1
        found = []
        for middle, bound in zip(piece.at(time), self.bounds[number], strict=True):
            found.append(arb(middle, bound + ROUNDING * abs(float(middle)) if self.bits == FLOAT_BITS else bound))
        return found


class Tolerances(Struct, frozen=True):
    """What the steps of the two runs may leave out, and the bits of their numbers."""

    main: float
    bits: int = FLOAT_BITS

    @property
    def steppers(self) -> tuple[float, float]:
        return self.main, COARSER * self.main


def start_of(course: Course) -> tuple[list[float], list[float]]:
    """The first state of both runs in floats."""
    first, second = (
        [arithmetic.number(item.start) for item in course.variables] for arithmetic in (FLOATS, OTHER_FLOATS)
    )
    return first, second


def stretch(
    course: Course, time: float, states: Sequence[Sequence[Scalar]], until: float, tolerances: Tolerances
) -> Stretch:
    """Follow a course from a time on by both runs, as long as nothing happens."""
    found = Stretch(course, tolerances.bits, time, until)
    order = order_for(tolerances.main)
    kinds = (FLOATS, OTHER_FLOATS) if tolerances.bits == FLOAT_BITS else (BALLS, BALLS)
    with Precision(tolerances.bits):
        for motion, state, kind, tolerance in zip(found.runs, states, kinds, tolerances.steppers, strict=True):
            walker = Walker(Stepper(course, kind, tolerance, order), time, state)
            while walker.time < until:
                piece = walker.piece(until)
                motion.add(piece)
                walker.walk(piece, piece.length)
        measure(found)
    return found


def measure(found: Stretch, before: Sequence[float] | None = None) -> None:
    """The bounds at the end of each step of the main run: the largest difference so far, times `SAFETY`."""
    main, other = found.runs
    largest = list(before) if before is not None else [0.0] * len(found.course.variables)
    for piece in main.pieces:
        for time in (piece.start + piece.length / 2, piece.start + piece.length):
            for number, (one, two) in enumerate(zip(piece.at(time), other.piece_at(time).at(time), strict=True)):
                largest[number] = max(largest[number], SAFETY * abs(float(one - two)))
        found.bounds.append(list(largest))


class Reading:
    """Reads all that can be told at a moment from the numbers of the state there, in balls."""

    def __init__(self, course: Course, names: Sequence[str]) -> None:
        self.course = course
        self.places = {name: course.outputs[name] for name in names}
        self.expansion = Expansion(course.tape, list(self.places.values()), BALLS)

    def read(self, time: float, state: Sequence[Scalar]) -> dict[str, Scalar]:
        letters = {
            self.course.letters[item.letter]: number for item, number in zip(self.course.variables, state, strict=True)
        }
        self.expansion.begin({**letters, self.course.letters["time"]: arb(time)})
        lists = self.expansion.lists
        return {name: lists[place][0] if lists[place] else letters[place] for name, place in self.places.items()}
