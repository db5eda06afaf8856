"""Works that have a letter of their own: W = F s, W = τ θ or ∫ of them, s the way of the point on which the force acts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import HALF, ZERO, Formula, Integral, Sum, Symbol, negate, total
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.equation import WAY_OF_SLIP, WORK, Equation
from rotsolve.core.facts import Rule
from rotsolve.core.symbols import CONSTANT, is_key, key_of, of_kinds
from rotsolve.core.writing import is_negative, spoken
from rotsolve.laws.table import OverPhase


class ByItsPoint(Struct, frozen=True):
    """Work as force · (along + turned): the way of the point on which it acts is that of its body, and what the body turns meanwhile."""

    force: Formula
    along: Symbol
    turned: Formula

    @property
    def way(self) -> Formula:
        """How far the point goes."""
        return total([self.along, self.turned])


def works_spelled(over: OverPhase) -> Iterator[Equation]:
    """W = F s, W = τ θ or ∫ of them, for each work that has a letter of its own; s by how the slip of a touching point changes evenly."""
    for work in over.passage.works:
        if work.spelled is None or work.spelled == work.amount:
            continue
        where, owner = (over.section, work.bodies), spoken(work.owner)
        apart = by_way_of_its_point(work.spelled)
        slid = None if apart is None else slid_evenly(apart, over)
        if apart is None:
            yield WORK.equation(work.amount, work.spelled, *where, owner=owner)
        elif slid is None or work.slide is None:
            way, words = gone(apart)
            yield WORK.equation(work.amount, apart.force * way, *where, words, owner=owner)
        else:
            counts = (
                f"What counts for the work of {owner} is the way ",
                work.slide,
                " by which the touching point slides, ",
            )
            words = (
                *counts,
                "not the way ",
                apart.along,
                " of the centre, as the body turns meanwhile.",
                NEXT,
                *slid[1],
            )
            yield WORK.equation(work.amount, apart.force * work.slide, *where, words, owner=owner)
            yield WAY_OF_SLIP.equation(work.slide, slid[0], *where, ("mean speed × time",), owner="the touching point")


def by_way_of_its_point(work: Formula) -> ByItsPoint | None:
    """F s + F r θ as F (s + r θ): the force times the way of the point on which it acts, which is not that of the body."""
    terms = work.terms if isinstance(work, Sum) else ()
    ways = [name for name in work.symbols() if is_key(name) and key_of(name).kind == "displacement"]
    if len(ways) != 1 or len(terms) != 2 or work.holds(Integral):
        return None
    along = Symbol(ways[0])
    one, other = sorted(terms, key=lambda term: ways[0] not in term.symbols())
    force = simplify(one / along)
    turned = simplify(other / force)
    if of_kinds(turned.symbols(), ("tension",)):  # of two forces that differ, as on both sides of a post
        return None
    return None if ways[0] in (force.symbols() | turned.symbols()) else ByItsPoint(force, along, turned)


def gone(apart: ByItsPoint) -> tuple[Formula, Words]:
    """s + r θ, by which the point goes."""
    turns, way = "back" if is_negative(apart.turned) else "on", apart.way
    return way, (f"The rim on which it acts turns {turns} meanwhile: its point goes ", way, ", not ", apart.along, ".")


def slid_evenly(apart: ByItsPoint, over: OverPhase) -> tuple[Formula, Words] | None:
    """½ u t, by which the point slides where its slip falls evenly from u to nothing, or grows so from nothing to u."""
    passage, rates = over.passage, dict[str, tuple[Formula, Formula]]()
    for travel in passage.travels:
        if travel.change.symbols() & apart.way.symbols():
            if travel.pace != CONSTANT or not isinstance(travel.change, Symbol):
                return None
            rates[travel.change.name] = (travel.before, travel.after)
    before = slip_of_point(apart, {name: pair[0] for name, pair in rates.items()}, passage.start.rules)
    after = slip_of_point(apart, {name: pair[1] for name, pair in rates.items()}, (*passage.end.rules, *over.held))
    if (before == ZERO) == (after == ZERO):
        return None
    change = ("falls from ", before, " to 0") if after == ZERO else ("grows from 0 to ", after)
    keys = [name for name in apart.turned.symbols() if is_key(name)]
    radius = simplify(apart.turned / Symbol(keys[0])) if len(keys) == 1 else ZERO
    sign, arm = ("less", simplify(negate(radius))) if is_negative(apart.turned) else ("and", radius)
    speed = ("The speed of that point, that of the centre ", sign, " ", arm, " times the angular velocity, ")
    return HALF * (before + after) * passage.duration, (
        *speed,
        *change,
        " at a constant rate, since friction is constant.",
    )


def slip_of_point(apart: ByItsPoint, rates: Mapping[str, Formula], rules: Sequence[Rule]) -> Formula:
    """How fast the point goes at a moment; 0 where a rule of that moment says so."""
    rate = simplify(apart.way.substitute(rates))
    gaps = [rule.velocity[0] - rule.velocity[1] for rule in rules]
    return ZERO if any(is_zero(rate - gap) or is_zero(rate + gap) for gap in gaps) else rate
