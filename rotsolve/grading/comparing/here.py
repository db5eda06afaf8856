"""Here: whether two formulas are one for the signs that the scene's numbers have, if not for others: u − v and |u − v| where u > v."""

from __future__ import annotations

from fractions import Fraction
from functools import partial

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Call, Formula, Integral
from rotsolve.grading.comparing.equality import SampledRegion, close_everywhere, same_everywhere, value_at
from rotsolve.grading.comparing.forms import term_count

NOTHING = Fraction(1, 10**20)  # a share by which equal formulas may differ in balls
SHORT = 500  # terms of a formula of which slopes are worked out


def same_in(domain: SampledRegion, left: Formula, right: Formula) -> bool | None:
    """Whether two formulas are equal in a domain, or for the signs of its numbers; the right one is the reference.

    None where that is not proved though they agree there, and where one has no value.
    """
    try:
        everywhere = same_everywhere(left, right, domain)
        here = everywhere or same_here(left, right, domain)
        return everywhere if here is False else here
    except (Undefined, ZeroDivisionError):
        return None


def same_here(left: Formula, right: Formula, domain: SampledRegion) -> bool | None:
    """Whether both formulas are equal for the signs that the scene's numbers have, as sin(θ/2) and √(1 − cos θ)/√2 for θ > 0.

    At every point they are, and it is proved of them with what is between bars by its sign there: of themselves, of their squares, of
    these squared, or of all their slopes. None where they agree without that.
    """
    own = domain.own
    if left.holds(Integral) or right.holds(Integral) or not close_everywhere(left, right, own, NOTHING):
        return False
    left, right = without_bars(left, own), without_bars(right, own)
    return same_powers(left, right, own) or same_slopes(left, right, own) or None


def same_powers(left: Formula, right: Formula, domain: SampledRegion) -> bool:
    """Whether two formulas that have one sign are equal, or their squares, or these squared."""
    return any(domain.reference(right**power).is_exactly(left**power) for power in (1, 2, 4))


def same_slopes(left: Formula, right: Formula, domain: SampledRegion) -> bool:
    """Whether both formulas change alike with each of their letters, as arctan x + arccos(1/√(1 + x²)) and 2 arctan x."""
    told, positive = domain.region.told, domain.region.positive
    left, right = left.substitute(told), right.substitute(told)
    if max(map(term_count, (left, right))) > SHORT:
        return False
    try:
        slopes = [
            [simplify(differentiate(one, name), positive=positive) for one in (left, right)]
            for name in sorted(left.symbols() | right.symbols())
        ]
    except (ValueError, ArithmeticError):
        return False
    return all(
        domain.reference(other).is_exactly(one)
        or (close_everywhere(one, other, domain, NOTHING) and same_powers(one, other, domain))
        for one, other in slopes
    )


def without_bars(formula: Formula, domain: SampledRegion) -> Formula:
    """A formula with x or −x for |x| where x has one sign at all points of a domain."""
    return formula.transform(partial(unbarred_by_sign, domain), Call) if formula.holds(Call) else formula


def unbarred_by_sign(domain: SampledRegion, node: Formula) -> Formula:
    if not isinstance(node, Call) or node.function != "abs":
        return node
    inner = node.arguments[0]
    signs = set[int]()
    for point in domain.points:
        try:
            value = value_at(inner, point) if inner.symbols() <= point.keys() else None
        except Undefined:
            value = None
        signs.add(0 if value is None else bool(value > 0) - bool(value < 0))
    return inner if signs == {1} else -inner if signs == {-1} else node
