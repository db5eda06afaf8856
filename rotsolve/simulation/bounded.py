"""Bounded: a motion followed more than once, so that the difference tells how far each number may be from the true one.

As long as the steps leave out more than the roundings, the second run takes steps so fine that it may pass for the truth. Where floats
are at their end, nothing finer is to be had; then two others take coarser steps, so that they are surely farther from the truth. Data
and states are always rounded more coarsely there than in the main run, so that roundings show in the difference as well; what all leave
out grows in all as the motion makes it grow.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Mapping, Sequence

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import arb
from rotsolve.simulation.series import BALLS, COARSE_FLOATS, FLOATS, MIXED_FLOATS, Arithmetic
from rotsolve.simulation.system import Readout, System
from rotsolve.simulation.tape import Scalar
from rotsolve.simulation.taylor import Stepper, Trajectory, Walker, horner, order_for
from rotsolve.simulation.watches import Hit, Lookout, Watch

ROUNDING = 2.0**-49  # of the terms of a polynomial: what working it out may add
LOOKS = 64  # moments at which quantities that are no numbers of the state are compared, where all so far count
BESIDE = 2  # moments before and after a step, two a step, whose differences count
FLOAT_BITS = 53
SAFETY = 6.0  # what the difference of the two runs is multiplied by: roundings may happen to go the same way in both
ROUNDED = 2e-14  # tolerance of a step below which roundings of floats matter as much
ALONE = 2e-13  # from which on one finer run tells the error: what it rounds on purpose may be all that the steps leave out below it
COARSER, FINER = (3.0, 1.7), 1000.0  # how much larger or smaller the tolerances of the other runs are
FINER_BITS = 32  # that a finer run of balls has more: what nearly cancels is all rounding, in which two alike may agree
ROUNDED_TIMES = 2  # floats by which the other runs take what happens later than it does
States = tuple[list[Scalar], ...]  # of all runs
Times = tuple[float, ...]


class RunOptions(Struct, frozen=True):
    """How one run goes: the tolerance of its steps, its numbers, whether it rounds coarsely on purpose, and its bits."""

    tolerance: float
    numbers: Arithmetic
    coarse: bool = False
    bits: int = FLOAT_BITS


class Tolerances(Struct, frozen=True):
    """What a step of the main run may leave out, and the bits of the numbers."""

    main: float
    bits: int = FLOAT_BITS

    @property
    def rounded(self) -> bool:
        """Whether the roundings of floats leave out as much as the steps."""
        return self.bits == FLOAT_BITS and self.main < ROUNDED

    @property
    def ways(self) -> tuple[RunOptions, ...]:
        """The main run, and those with which it is compared: two where roundings count, since one may happen to come out the same."""
        if self.bits != FLOAT_BITS:
            finer = RunOptions(self.main / FINER, BALLS, bits=self.bits + FINER_BITS)
            return RunOptions(self.main, BALLS, bits=self.bits), finer
        times = COARSER if self.rounded else (1 / FINER, 1 / FINER)
        others = [
            RunOptions(one * self.main, numbers, True)
            for one, numbers in zip(times, (COARSE_FLOATS, MIXED_FLOATS), strict=True)
        ]
        return RunOptions(self.main, FLOATS), *(others if self.main < ALONE else others[:1])


class Regime(Struct):
    """A part of a motion along which the equations stay the same: its runs, when each ends, and the bounds of the state so far."""

    system: System
    tolerances: Tolerances
    times: Times
    runs: tuple[Trajectory, ...]
    ends: Times
    last: States
    hit: Hit | None = None
    sides: tuple[dict[Watch, int], ...] = ()  # the last signs of what is watched
    bounds: list[list[float]] = field(default_factory=list)
    spread: dict[float, dict[str, float]] = field(default_factory=dict)  # by moments, of what is no number of the state
    proved: bool = False  # whether the polynomials themselves are balls that hold the true motion

    @property
    def bits(self) -> int:
        """The bits of its numbers."""
        return self.tolerances.bits

    @property
    def rounding(self) -> float:
        """What roundings may add to a number, as a part of it."""
        return ROUNDING * 2.0 ** (FLOAT_BITS - self.bits)

    def middle(self, time: float) -> list[Scalar]:
        """The numbers of the state by the main run."""
        return self.runs[0].piece_at(time).at(time)

    def state(self, time: float) -> list[Scalar]:
        """The numbers of the state as balls that hold the true ones."""
        if self.proved:
            return self.middle(time)
        main = self.runs[0]
        number = min(max(0, bisect_right(main.starts, time) - 1), len(self.bounds) - 1)
        others, found = [run.piece_at(time).at(time) for run in self.runs[1:]], []
        for k, ball in enumerate(self.rounded(time)):
            bound = max(self.bounds[number][k], SAFETY * farthest(ball.mid(), [other[k] for other in others]))
            found.append(arb(ball.mid(), ball.rad() + bound))
        return found

    def rounded(self, time: float) -> list[Scalar]:
        """The numbers of the state by the main run, with what roundings of its polynomials and of its first state add to them."""
        piece = self.runs[0].piece_at(time)
        since = abs(time - piece.start)
        sizes = (float(horner([abs(term) for term in terms], since)) for terms in piece.polynomials)
        return [arb(middle, self.rounding * size) for middle, size in zip(piece.at(time), sizes, strict=True)]

    def derived(self, time: float, names: Sequence[str]) -> list[float]:
        """The bounds of quantities that are no numbers of the state, likewise by the difference of the runs near a time."""
        marks = self.marks()
        around = list(self.around(marks, time))
        fresh = [mark for mark in around if not self.spread.get(mark, {}).keys() >= set(names)]
        reading = Readout(self.system, {name: self.system.outputs[name] for name in names})
        for mark in fresh:
            self.spread.setdefault(mark, {}).update(self._gaps(reading, mark))
        rows = [self._gaps(reading, time), *(self.spread[mark] for mark in around)]
        return [max(row[name] for row in rows) for name in names]

    def marks(self) -> list[float]:
        """The moments at which the runs are compared: the start, then the middle and the end of each step of the main run."""
        halves = ((piece.start + piece.length / 2, piece.start + piece.length) for piece in self.runs[0].pieces)
        return [self.times[0], *(mark for both in halves for mark in both)]

    def around(self, marks: Sequence[float], time: float) -> Sequence[float]:
        """The moments whose differences tell the bound at a time.

        A run that is truly finer differs by the error itself, which may become small again (a rod that comes to rest near upright):
        a step before and a step after tell it. Runs that are all as good as floats can be may meet by chance: all so far count.
        """
        number = bisect_left(marks, time)
        if self.tolerances.rounded:
            return marks[: number + 2 : 1 + number // LOOKS]
        return marks[max(0, number - BESIDE) : number + BESIDE]

    def _gaps(self, reading: Readout, time: float) -> dict[str, float]:
        """How far quantities differ between the main run and the others at a moment, and some more for safety.

        Where one has no value then, nothing bounds it so.
        """
        first, *others = (reading.read(time, run.piece_at(time).at(time)) for run in self.runs)
        gaps = {
            name: [abs(float(number.mid() - other[name].mid())) for other in others] for name, number in first.items()
        }
        return {name: math.inf if any(map(math.isnan, row)) else SAFETY * max(row) for name, row in gaps.items()}


class Unsettled(ValueError):
    """The two runs do not agree on what happens, or the bounds grow beyond use; tells from when on."""

    def __init__(self, time: float) -> None:
        super().__init__(f"what happens after t = {time:.4g} s is not settled by the accuracy of the calculation")
        self.time = time


def start_of(system: System, tolerances: Tolerances) -> States:
    """The first state of all runs."""
    states = []
    for way in tolerances.ways:
        with Precision(way.bits):
            states.append([way.numbers.number(item.start) for item in system.variables])
    return tuple(states)


def follow_regime(
    system: System,
    times: Times,
    states: States,
    until: float,
    tolerances: Tolerances,
    watched: Sequence[Watch],
    sides: Sequence[Mapping[Watch, int]],
    tell: Callable[[float], None],
) -> Regime:
    """Follow a system from a time on by all runs until something happens."""
    runs, ends, last, hits, told = [], [], [], [], []
    places = [watch.place for watch in watched]
    for number, (way, time, state, signs) in enumerate(zip(tolerances.ways, times, states, sides, strict=True)):
        with Precision(way.bits):
            stepper = Stepper(system, way.numbers, way.tolerance, order_for(way.tolerance), places)
            walker = Walker(stepper, time, state, way.coarse)
            lookout = Lookout(watched, signs)
            motion, hit = followed_until(walker, until, lookout, tell, ROUNDED_TIMES if number else 0)
            runs.append(motion)
            ends.append(walker.time)
            last.append(walker.state)
            hits.append(hit)
            told.append(lookout.told())
    if len({hit and hit.watch for hit in hits}) > 1:
        raise Unsettled(min(ends))
    return Regime(system, tolerances, times, tuple(runs), tuple(ends), tuple(last), hits[0], tuple(told))


def followed_until(
    walker: Walker, until: float, lookout: Lookout, tell: Callable[[float], None], beside: int = 0
) -> tuple[Trajectory, Hit | None]:
    """The pieces of a motion until something happens, or to a time.

    Times are floats: where something happens is rounded, in all runs alike. One that takes it some floats `beside` shows by how much
    that matters.
    """
    motion = Trajectory()
    while True:
        piece = walker.piece(until)
        motion.add(piece)
        tell(walker.time / until)
        hit = lookout.first(piece)
        if hit is not None and beside:
            hit = replace(hit, time=hit.time + beside * math.ulp(hit.time))
        if hit is not None:
            motion.pieces[-1] = replace(piece, length=hit.time - piece.start)
            walker.walk(piece, hit.time - piece.start)
            return motion, hit
        walker.walk(piece, piece.length)
        if walker.time >= until:
            return motion, None


def measure_bounds(found: Regime, before: Sequence[float]) -> None:
    """The bounds at each step of the main run by its differences from the others, and some more for safety; see `around`."""
    main, *others = found.runs
    rows = [list(before)]
    for mark in found.marks()[1:]:
        states = [other.piece_at(mark).at(mark) for other in others]
        gaps = (farthest(one, [state[k] for state in states]) for k, one in enumerate(main.piece_at(mark).at(mark)))
        rows.append([SAFETY * gap for gap in gaps])
    for number in range(len(main.pieces)):
        near = rows[max(0, 2 * number - BESIDE) : 2 * number + 3 + BESIDE]
        if found.tolerances.rounded:
            near = [*found.bounds[-1:], *rows[2 * number : 2 * number + 3]]
        found.bounds.append([max(column) for column in zip(*near, strict=True)])


def farthest(number: Scalar, others: Sequence[Scalar]) -> float:
    """The largest difference of a number from others."""
    return max((abs(float(number - other)) for other in others), default=0.0)
