"""Holding: what friction holds where a phase begins, and no longer once forces have grown in time: when it begins to slip, and how;
and when what such forces slow down comes to rest.

Something begins to slip where it would speed up against as much friction as there can be.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cmp_to_key
from itertools import pairwise

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.calculus.integral import antiderivative
from rotsolve.algebra.certified.rootfind import real_roots
from rotsolve.algebra.exact.normal import degree, simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import Formula, Number
from rotsolve.core.facts import signed
from rotsolve.core.symbols import TIME
from rotsolve.core.writing import spoken
from rotsolve.motion.rubs import Rub, against_most
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.functions_of_time import Beside, is_linear_in_time
from rotsolve.search.friction import Trials
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search


class Slipping(Struct, frozen=True):
    """What begins to slip, by the sense of each, and the time on the clock when it does."""

    senses: Mapping[Rub, int]
    at: Formula


class InTime(Struct, frozen=True):
    """A phase whose forces vary in time: its ends on the clock, the later one None where the laws do not tell it yet."""

    search: Search
    beside: Beside
    start: Formula
    end: Formula | None

    def slipping(self, held: Sequence[Rub]) -> Slipping | None:
        """What is the first of all that is held to slip before the phase ends."""
        trials = Trials(self.search.scene.configuration)
        trials.scene, trials.modes = self.search.scene, dict(self.search.scene.modes)
        first: Slipping | None = None
        for group in trials.moving_together(list(held)):
            own = self.of_group(group, trials)
            if own is not None and (first is None or self.beside.side(own.at - first.at) == -1):
                first = own
        return first

    def of_group(self, group: list[Rub], trials: Trials) -> Slipping | None:
        """What of a group slips first: several at once only where one of them can't alone, since others go with it."""
        first: Slipping | None = None
        alone = True
        for senses in trials.ways(group):
            if alone and slips(senses) > 1 and trials.stacked(group):
                break
            gains = self.gains(senses, trials)
            alone = alone and bool(gains)
            at = self.first_positive(gains)
            if at is not None and (first is None or self.beside.side(at - first.at) == -1):
                first = Slipping(senses, at)
        return first

    def gains(self, senses: Mapping[Rub, int], trials: Trials) -> list[Formula]:
        """How fast each would speed up along its sense against all the friction that there can be, as functions of time; none of what
        the laws do not tell."""
        modes = {rub.key: rub.mode(sense) for rub, sense in senses.items()}
        trial = {key: against_most(mode) for key, mode in modes.items()}
        search, found = trials.search({**trials.modes, **trial}), []
        for rub, sense in senses.items():
            value = self.speeding_up(rub, search) if sense else None
            found += [signed(value, sense)] if value is not None else []
        return found if len(found) == slips(senses) else []

    def speeding_up(self, rub: Rub, search: Search) -> Formula | None:
        """The rate of a slip or turn's speed as a function of time."""
        rate = rub.rate(search.scene.instant(rub.state, generic=True), acceleration=True)
        value = search.settled(rate) if rate is not None else None
        known = value is not None and not value.symbols() - self.beside.values.keys() - {TIME}
        return simplify(value, order=search.ground.order) if known and value is not None and search.ground else None

    def first_positive(self, functions: Sequence[Formula]) -> Formula | None:
        """The first time in the phase from which on all of some functions of time are positive, which they are not at its start."""
        if not any(TIME in function.symbols() for function in functions):
            return None
        if len(functions) == 1 and is_linear_in_time(functions[0]):
            return self.passed_upwards(functions[0])
        zeros = [zero for function in functions for zero in self.zeros(function)]
        marks = [self.start, *sorted(zeros, key=cmp_to_key(self.order))]
        for mark, after in pairwise([*marks, self.end or marks[-1] + 2]):
            middle = (mark + after) / 2
            if all(self.beside.side(function.substitute({TIME: middle})) == 1 for function in functions):
                return mark
        return None

    def order(self, one: Formula, other: Formula) -> int:
        return self.beside.side(one - other)

    def passed_upwards(self, function: Formula) -> Formula | None:
        """Where a linear function of time becomes positive."""
        if self.beside.side(differentiate(function, TIME)) != 1:
            return None
        (root,) = solve_polynomial(function, TIME)
        early = self.beside.side(root - self.start) == -1
        late = self.end is not None and self.beside.side(self.end - root) != 1
        return None if early or late else root

    def comes_back(self, rub: Rub, sense: int, speed: Formula | None) -> bool:
        """Whether what slips or turns along a sense at first would go backwards somewhere in the phase: at its end, or where it goes
        over from slowing down to speeding up."""
        later, gain = self.speed_later(rub, speed)
        if later is None or gain is None or self.end is None:
            return False
        if self.beside.side(later.substitute({TIME: self.end})) == -sense:
            return True
        return any(self.beside.side(later.substitute({TIME: mark})) == -sense for mark in self.marks(gain, self.start))

    def stops_ever(self, rub: Rub, sense: int, speed: Formula | None) -> bool:
        """Whether what slips or turns along a sense comes to rest at some time, where nothing tells how long the phase lasts.

        Told of a speed v₀ + a₀ t + ½ j t²: where j is against it, or a₀ is and j does not make up for that. NotYet of any other.
        """
        later, gain = self.speed_later(rub, speed)
        if later is None or gain is None or degree(gain, TIME) not in (0, 1):
            raise NotYet(f"when {spoken(rub.body)} comes to rest has no closed form")
        begun, first, second = (
            part.substitute({TIME: self.start}) for part in (later, gain, differentiate(gain, TIME))
        )
        sides = [sense * self.beside.side(part) for part in (begun, first, second)]
        if sides[2] == -1:
            return sides[:2] in ([1, 1], [1, 0], [1, -1], [0, 1])
        if sides[:2] != [1, -1]:
            return False
        return sides[2] == 0 or self.beside.side(first * first - 2 * second * begun) == 1

    def rests_at(self, rub: Rub, speed: Formula | None) -> Formula | None:
        """When on the clock it comes to rest first, as a number where that has no closed form."""
        later, gain = self.speed_later(rub, speed)
        if later is None or gain is None:
            return None
        slowing = self.marks(gain, self.start) if self.beside.side(later.substitute({TIME: self.start})) == 0 else []
        return next(iter(self.marks(later, slowing[0] if slowing else self.start)), None)

    def has_closed_form(self, rub: Rub, speed: Formula | None) -> bool:
        """Whether the time at which it comes to rest has a closed form, as far as the laws tell its speed as a function of time."""
        later, _ = self.speed_later(rub, speed)
        return later is None or bool(solve_polynomial(later, TIME) or solve_trig(later, TIME))

    def speed_later(self, rub: Rub, speed: Formula | None) -> tuple[Formula | None, Formula | None]:
        """Its speed as a function of time, v + ∫ a dt, and the rate of that."""
        gain = self.speeding_up(rub, self.search.beside_by(families_for(None)))
        grown = antiderivative(gain, TIME) if gain is not None else None
        if gain is None or grown is None or speed is None:
            return None, None
        return simplify(speed + grown - grown.substitute({TIME: self.start})), gain

    def marks(self, function: Formula, start: Formula) -> list[Formula]:
        """The times after a start at which a function of time changes its sign, to a few figures where they have no closed form."""
        try:
            return self.zeros(function, start)
        except NotYet:
            return self.about(function, start)

    def about(self, function: Formula, start: Formula) -> list[Formula]:
        """About when a function of time changes its sign, where that has no closed form."""
        if self.end is None or self.beside.signs.lacking(function - start - self.end):
            raise NotYet("how often its speed changes sign depends on the givens: give them numbers")
        found = real_roots(function, TIME, self.beside.values, start, self.end)
        if not found.complete:
            raise NotYet("where its speed changes sign can not be told for certain")
        ends = [self.beside.number(end) for end in (start, self.end)]
        return [Number(Fraction(root.float)) for root in found.roots if ends[0] < root.float < ends[1]]

    def zeros(self, function: Formula, start: Formula | None = None) -> list[Formula]:
        """The times in the phase, or in the rest of it, at which a function of time changes its sign."""
        if self.end is not None or TIME not in function.symbols() or is_linear_in_time(function):
            return self.beside.zeros(function, start or self.start, self.end or self.start)
        raise NotYet("when it changes its sign is not told while nothing tells how long the phase lasts")


def slips(senses: Mapping[Rub, int]) -> int:
    """How many of those that may slip do."""
    return sum(map(abs, senses.values()))
