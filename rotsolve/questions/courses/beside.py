"""Beside: what a search works out beside its derivation: closed forms in time, and where they vanish."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from msgspec import Struct

from rotsolve.algebra.calculus.periodic import period_of
from rotsolve.algebra.certified.ball import Certified, evaluate
from rotsolve.algebra.certified.balls import Ball, Undefined
from rotsolve.algebra.certified.rootfind import real_roots
from rotsolve.algebra.certified.witness import decided_by_size
from rotsolve.algebra.exact.normal import degree, simplify
from rotsolve.algebra.exact.solving.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import Formula
from rotsolve.core.registry import TIME
from rotsolve.paths import NotYet

FIGURES = 30  # to which a zero is known before it is told from the end of a phase


class Beside(Struct, frozen=True):
    """Settles formulas of the laws without a trace, and looks at them as functions of time."""

    settle: Callable[[Formula], Formula | None]
    values: Mapping[str, Formula]

    def settled(self, value: Formula, what: str) -> Formula:
        """A formula with every letter of the laws worked out; refused where the laws do not tell it as a function of time."""
        found = self.settle(value)
        if found is None or found.symbols() - set(self.values) - {TIME}:
            raise NotYet(
                f"`{what}` is not known as a function of time with numbers for all its letters",
                help="name the turning point as a state, such as `{wheel.angular_velocity: 0}`",
            )
        return found

    def number(self, value: Formula, time: Formula | None = None) -> float:
        """A rough value, at a time where it depends on it."""
        decided_by_size()
        known = self.values if time is None else {**self.values, TIME: time}
        try:
            return evaluate(value, known, digits=12).float
        except (Undefined, ZeroDivisionError):
            raise NotYet("a value on the way is not defined") from None

    def side(self, value: Formula) -> int:
        """The sign of a value that does not depend on time; 0 where no precision tells it from 0."""
        return evaluate(value, self.values, digits=8).sign or 0

    def zeros(self, function: Formula, start: Formula, end: Formula) -> list[Formula]:
        """The times between the ends at which a function of time changes its sign, in order and in closed form."""
        if TIME not in function.symbols():
            return []
        found = real_roots(function, TIME, self.values, start, end)
        if not found.complete:
            raise NotYet("where it changes its sign can not be told for certain")
        first, last = self.ball(start), self.ball(end)
        inside = [root for root in found.roots if first < root.refine(FIGURES) < last]
        exact = solve_polynomial(function, TIME) or [item.formula for item in solve_trig(function, TIME)]
        return [self._closed(root, exact, period_of(function, TIME)) for root in inside]

    def ball(self, value: Formula) -> Ball:
        """A value that does not depend on time, to many figures."""
        return evaluate(value, self.values, digits=FIGURES).ball

    def _closed(self, root: Certified, exact: list[Formula], period: Formula | None) -> Formula:
        """The closed form of a zero, whole periods later where the motion swings."""
        for form in exact:
            periods = 0 if period is None else round((root.float - self.number(form)) / self.number(period))
            whole = form if period is None else form + periods * period
            if self.ball(whole).overlaps(root.refine(FIGURES)):
                return simplify(whole)
        raise NotYet("the moment at which it changes its sign has no closed form")


def straight(function: Formula) -> bool:
    """Whether a function of time is linear, so that its zero needs no choice."""
    return degree(function, TIME) == 1
