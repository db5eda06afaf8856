"""Here: whether two formulas are one for the signs that the scene's numbers have, if not for others: u − v and |u − v| where u > v."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import equal, simplify
from rotsolve.algebra.formula import PI, Call, Formula, Integral, Number
from rotsolve.grading.comparing.equality import SampledRegion, close_everywhere, same_everywhere, value_at
from rotsolve.grading.comparing.forms import term_count

NOTHING = Fraction(1, 10**20)  # a share by which equal formulas may differ in balls
ARCS = ("asin", "acos", "atan")
MOST_ARCS = 6  # different ones in two formulas
MULTIPLES = tuple(Fraction(sign * size, part) for size, part in ((1, 1), (2, 1), (1, 2)) for sign in (1, -1))
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
    ways = (same_powers, same_raised, same_slopes, same_arcs)
    return any(way(left, right, own) for way in ways) or None


def same_powers(left: Formula, right: Formula, domain: SampledRegion) -> bool:
    """Whether two formulas that have one sign are equal, or their squares, or these squared."""
    return any(domain.reference(right**power).is_exactly(left**power) for power in (1, 2, 4))


def same_raised(left: Formula, right: Formula, domain: SampledRegion) -> bool:
    """Whether both formulas are equal with letters for powers whose exponents hold letters, as x^(n + 1) and x xⁿ."""
    from rotsolve.grading.comparing.raised import in_letters_for_powers  # few answers have such powers

    told, positive = domain.region.told, domain.region.positive
    left, right = left.substitute(told), right.substitute(told)
    if max(map(term_count, (left, right))) > SHORT:
        return False
    try:
        plain = in_letters_for_powers(left, right)
        return plain is not None and equal(plain[0], plain[1], positive | plain[2])
    except (ValueError, ArithmeticError):
        return False


def same_slopes(left: Formula, right: Formula, domain: SampledRegion, depth: int = 2) -> bool:
    """Whether both formulas change alike with each of their letters, as arctan x + arccos(1/√(1 + x²)) and 2 arctan x; of what does not yet
    show in the slopes, it may in theirs."""
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
        or (
            close_everywhere(one, other, domain, NOTHING)
            and (same_powers(one, other, domain) or (depth > 1 and same_slopes(one, other, domain, depth - 1)))
        )
        for one, other in slopes
    )


def same_arcs(left: Formula, right: Formula, domain: SampledRegion) -> bool:
    """Whether both formulas are equal with one arc put for others: √x arccos(1 − x/2) and 2 √x arcsin(√x/2), whose slopes hold arcs too."""
    arcs = dict.fromkeys(node for side in (right, left) for node in side.walk(*ARCS))
    if not 1 < len(arcs) <= MOST_ARCS:
        return False
    kept: list[Formula] = []
    put: dict[Formula, Formula] = {}
    for arc in arcs:
        told = next((other for other in multiples_of(arc, kept) if close_everywhere(other, arc, domain, NOTHING)), None)
        if told is not None and same_slopes(told, arc, domain):
            put[arc] = told
        else:
            kept.append(arc)
    sides = [side.transform(lambda node: put.get(node, node), *ARCS) for side in (left, right)]
    return bool(put) and same_powers(sides[0], sides[1], domain)


def multiples_of(arc: Formula, others: list[Formula]) -> Iterator[Formula]:
    """What an arc may be in terms of others: k times one of them, and right angles."""
    for other in others:
        for times in MULTIPLES:
            yield from (Number(times) * other + Number(Fraction(turns, 2)) * PI for turns in range(-2, 3))


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
