"""Ways on joints: whether what turns on a hinge or goes along a slide, alone or carried, comes to where a later state has it.

It sets out as it moves, else as it is driven; where it is at rest and nothing drives it, it stays. Towards a place it gets where what is
left of its energy is positive all the way; away from one it has to turn back first, where nothing is left. Angles count on beyond whole
turns. By numbers this is looked at between the places where nothing drives it; in letters where these have closed forms, as conditions.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction
from typing import TYPE_CHECKING, cast

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.rootfind import real_roots
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import PI, ZERO, Formula, Integral, Number, call
from rotsolve.core.faults import NeverReached
from rotsolve.core.symbols import has_quantities
from rotsolve.core.ways import PLACE, WayEnd, WayOnJoint
from rotsolve.motion.timeline import Interval
from rotsolve.search.endings import never_reached
from rotsolve.search.search import Search

if TYPE_CHECKING:
    from rotsolve.space.scene import SpaceEquations

TURN = 2 * PI
FAR = 1000  # times the way told: what has not turned back there on a slide does not
MOST_POWER = 8  # of a place up to which energies are polynomials
SHARE = 1e-12  # of the energies on the way: less than this is nothing
LOOKS = 64  # places on a way at which it is looked besides
AWAY = "`{}` sets out the other way, and never turns back"
BARRED = "`{}` turns back before"
BALANCED = "`{}` is at rest in balance, and stays so"


def barred_ways(interval: Interval, search: Search) -> Iterator[NeverReached]:
    """The places of bodies on joints in space to which they do not come in a phase."""
    from rotsolve.space.ways import ways_on_joints

    for way in ways_on_joints(cast("SpaceEquations", search.scene), interval):
        yield from barred_way(way, interval, search)


def barred_way(way: WayOnJoint, interval: Interval, search: Search) -> Iterator[NeverReached]:
    """That a body does not come to the end of its way, if it does not."""
    configuration = search.scene.configuration
    looked = way_looked_at(way, search)
    why = "" if looked is None else looked.objection()
    if why:
        yield never_reached(interval, configuration, why.format(way.body), sure=True)


def way_looked_at(way: WayOnJoint, search: Search) -> LookedAt | None:
    """A way of which all is known but its place, if it leads elsewhere."""
    aside = search.apart()
    known = [aside.settled(value) for value in (way.start, way.end, way.rate, way.gap, way.effort)]
    start, end, rate, gap, effort = known
    if start is None or end is None or rate is None or gap is None or effort is None or any(map(open_, known)):
        return None
    found = WayOnJoint(way.body, way.turning, start, end, rate, gap, effort, way.ends)
    letters = {name for value in known if value is not None for name in value.symbols()} - {PLACE}
    ahead = search.numbers.side(simplify(end - start)) or (
        way.ends != (None, None) and -(search.numbers.side(rate) or 0)
    )
    return LookedAt(found, search, ahead, letters <= search.values.keys()) if ahead else None


def open_(value: Formula | None) -> bool:
    return value is None or has_quantities(value)


class LookedAt(Struct, frozen=True):
    """A way that leads `ahead`, looked at by numbers, else in letters."""

    way: WayOnJoint
    search: Search
    ahead: int
    numeric: bool

    def objection(self) -> str:
        """Why it does not come to its end; nothing where it does, or the letters do not tell."""
        side = self.search.numbers.side
        sets_out = side(self.way.rate)
        at_rest = sets_out == 0
        if at_rest:
            sets_out = side(simplify(self.way.pull.substitute({PLACE: self.way.start})))
        if sets_out == 0:
            return BALANCED
        if sets_out == -self.ahead and (at_rest or self.turns_back() is False):
            return AWAY if self.off is None else self.off.words
        return BARRED if sets_out and self.least(self.way.end) in (0, -1) else ""

    @property
    def off(self) -> WayEnd | None:
        """Where it runs off that sets out away from its end."""
        return self.way.ends[self.ahead < 0]

    def turns_back(self) -> bool | None:
        """Whether what sets out away from its end comes back: on a hinge within a turn, or since each turn takes of its energy."""
        way, start = self.way, self.way.start
        if not way.turning:
            far = self.far_off()
            return None if far is None else far == -1
        turned = start - self.ahead * TURN
        lost = self.side(way.left_at(turned) - way.left_at(start))
        least = self.least(turned)
        return None if lost is None or least is None else lost == -1 or least == -1

    def far_off(self) -> int | None:
        """The sign of what is least on a slide however far it goes away from its end."""
        if self.off is not None:
            last = self.side(self.way.left_at(self.off.place))
            return -1 if last == -1 or self.least(self.off.place) == -1 else None if last is None else 0
        far = self.way.start - self.ahead * FAR * call("abs", self.way.end - self.way.start)
        if self.numeric:
            return self.least(far)
        power, lead = 0, self.way.gap
        while PLACE in lead.symbols() and power < MOST_POWER:
            power, lead = power + 1, simplify(differentiate(lead, PLACE))
        if PLACE in lead.symbols() or self.way.effort != ZERO:
            return None
        return -1 if self.side(lead) == -((-self.ahead) ** power) else self.least(None)

    def least(self, stop: Formula | None) -> int | None:
        """The sign of what is left where it is least between the start and a place, or beyond the start; None where that is not told."""
        places = self.looks(stop) if self.numeric and stop is not None else self.slowest()
        if places is None:
            return None
        forward = self.ahead if stop is self.way.end else -self.ahead
        signs = [
            self.side(self.way.left_at(place)) for place in places if self.numeric or self.between(place, stop, forward)
        ]
        return None if None in signs else min((sign for sign in signs if sign is not None), default=1)

    def between(self, place: Formula, stop: Formula | None, forward: int) -> bool:
        """Whether it is slowest at a place beyond the start, and before another one, in letters."""
        side = self.search.numbers.side
        if side(simplify(differentiate(self.way.pull, PLACE).substitute({PLACE: place}))) == -1:
            return False  # it is fastest there
        gone = side(simplify((place - self.way.start) * forward)) == 1
        return gone and (stop is None or side(simplify((stop - place) * forward)) == 1)

    def slowest(self) -> list[Formula] | None:
        """Where nothing drives it and it is slowest, as far as that has a closed form; of angles once round each way too."""
        pull, solver = self.way.pull, self.search.solver
        if PLACE not in pull.symbols():
            return []
        roots = solve_polynomial(pull, PLACE, order=solver.order, positive=solver.positive)
        if not roots:
            angles = solve_trig(pull, PLACE, order=solver.order, positive=solver.positive)
            roots = [root + turn for root in angles for turn in (-TURN, ZERO, TURN)]
        return roots or None

    def looks(self, stop: Formula) -> list[Formula]:
        """Places up to another one at which it is looked, by numbers: those at which nothing drives it among them."""
        ends = [self.search.numbers.of(end) or 0.0 for end in (self.way.start, stop)]
        shares = [(k / LOOKS) ** (1 if self.way.turning or stop is self.way.end else 4) for k in range(1, LOOKS)]
        places = [ends[0] + share * (ends[1] - ends[0]) for share in shares]
        low, high = sorted((self.way.start, stop), key=lambda end: self.search.numbers.of(end) or 0.0)
        with suppress(Undefined, ZeroDivisionError):
            places += [root.float for root in real_roots(self.way.pull, PLACE, self.search.values, low, high).roots]
        return [Number(Fraction(place)) for place in places]

    def side(self, value: Formula) -> int | None:
        """The sign of what is left; by numbers one that is nothing but for rounding is 0."""
        if not self.numeric:
            return None if value.holds(Integral) else self.search.numbers.side(simplify(value))
        number = self.search.numbers.of(value)
        return None if number is None else 0 if abs(number) <= SHARE * self.size() else 1 if number > 0 else -1

    def size(self) -> float:
        """How large energies are on the way, by numbers."""
        ends = (
            self.search.numbers.of(self.way.left_at(self.way.start)),
            self.search.numbers.of(self.way.pull.substitute({PLACE: self.way.start}) * (self.way.end - self.way.start)),
        )
        return sum(abs(end or 0.0) for end in ends)
