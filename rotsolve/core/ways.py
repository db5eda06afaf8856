"""WayOnJoint: the way of a body along one place of its own, by what it has left of its energy at each."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Integral, add

PLACE = "#place"  # the letter of a place on the way


class WayEnd(Struct, frozen=True):
    """A place beyond which what carries a body does not go, with what happens there."""

    place: Formula
    words: str


class WayOnJoint(Struct, frozen=True):
    """The way of a body on a joint in a phase: its place and rate at the start, its place at the end and the rate there, where it is told.

    By any place it has what is left for ½ M q̇²: the `gap` of the energy without forces that have no potential, and the `effort` of those.
    At its `ends`, the lower and the upper one, it runs off.
    """

    body: str
    turning: bool
    start: Formula
    end: Formula
    rate: Formula
    gap: Formula
    effort: Formula = ZERO
    ends: tuple[WayEnd | None, WayEnd | None] = (None, None)
    last: Formula | None = None

    def left_at(self, place: Formula) -> Formula:
        """E + ∫ Q dq − W at a place."""
        given: Formula | None = ZERO
        if self.effort != ZERO:
            from rotsolve.algebra.calculus.integral import integrate_by_hand

            given = integrate_by_hand(self.effort, PLACE, self.start, place)
        there = self.gap.substitute({PLACE: place})
        return add(there, Integral(self.effort, PLACE, self.start, place) if given is None else given)

    @property
    def pull(self) -> Formula:
        """What drives it along its way where it is at rest: Q − dW/dq."""
        return simplify(add(differentiate(self.gap, PLACE), self.effort))
