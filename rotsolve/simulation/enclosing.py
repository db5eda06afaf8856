"""Enclosing: a motion in balls that surely hold the true one: every step proves where the state stays, and what its series leaves out.

The state stays in a box B if x + [0, h] f(B) lies within B (Picard, Lindelöf). Then x(t) = Σ xₖ tᵏ + xₙ(B) tⁿ, with the last
coefficient taken over the whole box (Lagrange's remainder). Balls grow by wrapping the box anew at each step; bits make up for that.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import arb
from rotsolve.simulation.bounded import Regime, Tolerances, Unsettled
from rotsolve.simulation.series import BALLS, Expansion
from rotsolve.simulation.system import System
from rotsolve.simulation.tape import Scalar
from rotsolve.simulation.taylor import Stepper, TaylorStep, Trajectory, Unbounded, horner
from rotsolve.simulation.watches import REACHED, Watch

BITS_AN_ORDER = 3.5  # by measurement
ROOM = 1.25  # how much larger than it should be the box is tried
SHORTER, TRIES, WIDENINGS = 0.7, 40, 4
NEAR = 1e-3  # of the whole time: how close what happens may come
WIDE = 1e-2  # a ball that is wider than this part of its number tells nothing any more


class Encloser:
    """Takes steps of a system that are proved."""

    def __init__(self, system: System, bits: int, watched: Sequence[Watch]) -> None:
        order = int(bits / BITS_AN_ORDER)
        tolerance = 2.0 ** -min(bits, 1000)
        self.system, self.order = system, order
        self.points, self.boxes = (Stepper(system, BALLS, tolerance, order) for _ in range(2))
        self.watched = [watch.place for watch in watched if watch.kind != REACHED]
        places = [*(item.rate for item in system.variables), *self.watched]
        self.rates = Expansion(system.tape, places, BALLS)

    def piece(self, time: float, state: Sequence[Scalar], until: float, before: float) -> tuple[TaylorStep, bool]:
        """A step with its remainder as last coefficient, and whether what is watched keeps its sign in it."""
        series = self.points.expand(time, state).polynomials
        length = self.points.length(series, before or until - time)
        length = min(self.points.length(series, min(length, until - time)), until - time)
        for _ in range(TRIES):
            end = time + length
            length = end - time
            clock = arb(time + length / 2, length / 2)
            box = self._box(state, series, clock, length)
            if box is not None:
                keeps = all(not self.rates.lists[place][0].contains(0) for place in self.watched)
                rest = self.boxes.expand(clock, box).polynomials
                held = tuple([*terms[:-1], last[-1]] for terms, last in zip(series, rest, strict=True))
                return TaylorStep(time, length, held), keeps
            length *= SHORTER
        raise Unbounded(time)

    def _box(
        self, state: Sequence[Scalar], series: Sequence[Sequence[Scalar]], clock: Scalar, length: float
    ) -> list[Scalar] | None:
        """A box B with x + [0, h] f(B) within it: what the series says with some room, then what f makes of that."""
        spreads = (reach(terms, length) for terms in series)
        box = [arb(start.mid(), arb(start.rad()) + more) for start, more in zip(state, spreads, strict=True)]
        period = arb(length / 2, length / 2)
        for _ in range(WIDENINGS):
            letters = dict(zip(self.points.letters, box, strict=True))
            try:
                self.rates.begin({**letters, self.points.time: clock})
            except ZeroDivisionError:
                return None
            rates = (self.rates.lists[item.rate][0] for item in self.system.variables)
            ways = [start + period * rate for start, rate in zip(state, rates, strict=True)]
            if all(around.contains(way) for around, way in zip(box, ways, strict=True)):
                return box
            box = [arb(way.mid(), ROOM * arb(way.rad())) for way in ways]
        return None


def reach(terms: Sequence[Scalar], length: float) -> Scalar:
    """How far a series takes a number from its start, with some room."""
    sizes = [abs(term) for term in terms[1:]]
    return (ROOM * horner([arb(0), *sizes], length)).upper() + arb(2) ** -400


def enclosed(
    system: System, until: float, bits: int, watched: Sequence[Watch], tell: Callable[[float], None]
) -> tuple[Regime, str]:
    """A system in proved steps, and why it was not followed to the end; it ends where something may happen."""
    motion, time, before, why = Trajectory(), 0.0, 0.0, ""
    with Precision(bits):
        state = [arb(item.start) for item in system.variables]
        encloser = Encloser(system, bits, watched)
        while time < until:
            tell(time / until)
            piece, keeps = encloser.piece(time, state, until, before)
            while not keeps and piece.length > NEAR * until:
                piece, keeps = encloser.piece(time, state, time + piece.length / 2, before)
            if not keeps:
                why = "what happens then can not be certified"
                if not motion.pieces:
                    raise Unsettled(time)
                break
            motion.add(piece)
            state = [horner(terms, piece.length) for terms in piece.polynomials]
            time, before = piece.start + piece.length, piece.length
            if any(float(number.rad()) > WIDE * max(1.0, abs(float(number.mid()))) for number in state):
                raise Unbounded(time)
    twice = ((0.0, 0.0), (motion, motion), (time, time), (state, state))  # as if of two runs
    zeros = [[0.0] * len(state) for _ in motion.pieces]
    return Regime(system, Tolerances(0.0, bits), *twice, bounds=zeros, proved=True), why
