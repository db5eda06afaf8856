"""Extreme place: where a quantity over a letter is largest or smallest: where its derivative vanishes, or at an end of the range."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.field import PolynomialSigns
from rotsolve.algebra.exact.normal import Fractions, coefficients, degree
from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Words
from rotsolve.paths.meaning import NotYet
from rotsolve.search.extreme_curve import (
    Curve,
    Domain,
    Extremum,
    amid,
    certified_roots,
    domain_of,
    recurrence,
    roots_of,
)
from rotsolve.search.search import Search

NUMERICALLY = "solved numerically, with certified digits; "


def best_place(course: Curve, word: str, choice: str, *, only: bool) -> tuple[Extremum, Words]:
    """The place of the extremum, the `only` one where that is asked, or by `choice` the largest or smallest of several, and why."""
    search = course.search
    domain = domain_of(course.letter, search)
    check_smooth(course, domain)
    roots, round_ = roots_of(course, domain)
    inside = [place for root in roots if (place := extremum_at(root, domain, course, round_)) is not None]
    outer = [end for end in domain.ends if end not in [place.at for place in inside]]
    places = [*inside, *(place for end in outer if (place := course.at(end)) is not None)]
    found = best_of(places, course, word) if places else None
    if not round_:
        check_open_ends(course, domain, inside, found, word)
    if found is None:
        raise NotYet(f"no {word} value was found: the derivative by `{course.letter}` vanishes nowhere")
    best = found
    if only and choice != "smallest" and (period := recurrence(course, domain)) is not None:
        help = f"ask for `smallest {course.letter} where …`, the first of them"
        raise NotYet(f"it is {word} over and over, each time {to_text(period)} later", help=help)
    if any(ceases(course, best, end) for end in (domain.low, domain.high)):
        raise NotYet(f"it is {word} where it vanishes and ceases to be real: what is asked does not come about there")
    level = [place for place in places if place is not best and course.is_level(place, best)]
    if level and choice:
        best = best_of([best, *level], course, choice, by_place=True)
    elif level and only:
        raise NotYet(*more_than_one(course, [best, *level], word))
    at_end: Words = ("an end of the range; ",) if best.at in outer else ()
    return best, (*at_end, *why_best(course, places, best, word))


def best_of(places: list[Extremum], course: Curve, word: str, *, by_place: bool = False) -> Extremum:
    """The first of the places at which the quantity, or the letter itself, is largest or smallest."""
    side, best = 1 if word == "largest" else -1, places[0]
    for other in places[1:]:
        gap = other.at - best.at if by_place else other.value - best.value
        ahead = course.sign(gap)
        if ahead is None and not gap.symbols() & course.numbered.keys():
            raise NotYet(f"where `{course.letter}` makes it {word} depends on the givens: give them numbers")
        best = other if (ahead or 0) * side > 0 else best
    return best


def more_than_one(course: Curve, places: list[Extremum], word: str) -> tuple[str, None, str]:
    """That several places are as good, and how to ask for one."""
    letter = course.letter
    told = [to_text(place.at) for place in places if place.number is None]
    where = f": at {' and '.join(told)}" if len(told) == len(places) else ""
    help = f"ask for `smallest {letter} where …` or `largest {letter} where …`"
    return f"it is {word} at more than one `{letter}`{where}", None, help


def extremum_at(root: Formula, domain: Domain, course: Curve, round_: bool) -> Extremum | None:
    """The place of a root of the derivative where it lies in the domain, ends included, and the quantity has a value."""
    fits = course.is_real(root) if round_ else is_inside(root, domain, course)
    return course.at(root) if fits else None


def is_inside(root: Formula, domain: Domain, course: Curve) -> bool:
    """Whether a root lies in the domain, ends included; one that is not real does not."""
    if not course.is_real(root):
        return False
    gaps = {side: (root - end) * -side for side in (-1, 1) if (end := domain.end(side)) is not None}
    told = {side: course.sign(gap) for side, gap in gaps.items()}
    signs = list(told.values())
    if any(told.get(side) == 0 for side in domain.open):
        return False
    if None in signs and course.numbered:  # as near as that it is the end, which is a place of its own
        return False
    if None in signs and -1 not in signs:
        raise NotYet(f"whether a root for `{course.letter}` lies in its range depends on the givens: give them numbers")
    return -1 not in signs


# what else may be an extremum


def check_smooth(course: Curve, domain: Domain) -> None:
    """An extremum at a kink or a pole is not seen by the derivative."""
    positive = course.search.solver.positive | ({course.letter} if domain.low == ZERO else frozenset())
    problem = Fractions([course.smooth], positive=positive)
    _, bottom = problem.field.cancel(problem.ratio())
    signs = PolynomialSigns(problem.field, positive)
    parts = [part for part, _ in problem.field.factor(bottom)[1]]
    if may_bend(course.smooth, course.letter) or not all(
        signs.nonnegative(part) or signs.nonnegative(-part) or rootless(problem.shaper.poly(part), course, domain)
        for part in parts
    ):
        raise NotYet(f"an extremum of what jumps or bends sharply as `{course.letter}` changes is not solved yet")


def may_bend(curve: Formula, letter: str) -> bool:
    """Whether a curve is a size, which may bend sharply where its letter changes."""
    return any(letter in node.symbols() for node in curve.walk("abs"))


def rootless(part: Formula, course: Curve, domain: Domain) -> bool:
    """Whether a factor of the second degree in the letter vanishes nowhere, b² < 4 a c, or one in numbers nowhere within the range."""
    letter = course.letter
    if letter not in part.symbols():
        return True
    if degree(part, letter) != 2:
        return vanishes_nowhere(part, course, domain)
    bend, zero = differentiate(differentiate(part, letter), letter), {letter: ZERO}
    slope, rest = differentiate(part, letter).substitute(zero), part.substitute(zero)
    return course.search.signs.sign(slope**2 - bend * rest * 2) == -1


def vanishes_nowhere(part: Formula, course: Curve, domain: Domain) -> bool:
    """Whether numbers tell that something vanishes nowhere within a range, its ends left out."""
    if set(course.search.signs.lacking(part)) - {course.letter}:
        return False
    try:
        return not certified_roots(part, course.letter, replace(domain, open=frozenset((-1, 1))), course.search)
    except NotYet:
        return False


def check_open_ends(course: Curve, domain: Domain, inside: list[Extremum], best: Extremum | None, word: str) -> None:
    """Where the domain has no end, the quantity must get worse beyond the last root, or come near nothing better, or not be real."""
    for towards in (-1, 1):
        outermost, end = outermost_of(inside, towards, course), domain.end(towards)
        if end is not None and towards not in domain.open and course.at(end) is not None:
            continue
        if outermost is not None and ceases(course, outermost, end):
            continue
        beyond = probe(course, outermost.at, towards, domain) if outermost is not None else amid(domain)
        check_beyond(course, domain, beyond, best, towards, word)


def outermost_of(inside: list[Extremum], towards: int, course: Curve) -> Extremum | None:
    """The last root on one side; None where there is none."""
    found = inside[0] if inside else None
    for place in inside[1:]:
        assert found is not None
        ahead = course.sign(place.at - found.at)
        if ahead is None:
            raise NotYet(f"the order of the places for `{course.letter}` depends on the givens: give them numbers")
        found = place if ahead * towards > 0 else found
    return found


def check_beyond(
    course: Curve, domain: Domain, beyond: Formula, best: Extremum | None, towards: int, word: str
) -> None:
    """Refuse where, from a place `beyond` the last root on, the quantity comes to better values than the best one."""
    letter, side = course.letter, 1 if word == "largest" else -1
    heading = course.sign(course.slope.substitute({letter: beyond}))
    if not heading:
        raise NotYet(f"whether it is {word} at a place inside depends on the givens: give them numbers")
    if heading * towards * side <= 0:
        return
    at_infinity = value_far_out(course, domain, towards) if best is not None else None
    goal = ZERO if best is None else best.value if course.smooth == course.curve else best.value**2
    if at_infinity is None or course.sign(at_infinity - goal) in (side, None):
        more, end = "grows" if side > 0 else "falls", domain.end(towards)
        where = "" if end is None else f" towards {to_text(end)}"
        way = "grows" if towards > 0 else "falls"
        raise NotYet(f"it has no {word} value: it {more} all the way as `{letter}` {way}{where}")


def value_far_out(course: Curve, domain: Domain, towards: int) -> Formula | None:
    """What a quotient of polynomials, or its square, comes to far out: by its highest powers; None where it has no bounds, or is none.

    At an open end it is what the quantity is there.
    """
    end = domain.end(towards)
    if end is not None and towards in domain.open:
        there = course.at(end)
        return None if there is None else there.value if course.smooth == course.curve else there.value**2
    if end is not None:
        return None
    problem = Fractions([course.smooth], extra=(course.letter,))
    top, bottom = (problem.shaper.poly(part) for part in problem.field.cancel(problem.ratio()))
    upper, lower = coefficients(top, course.letter), coefficients(bottom, course.letter)
    if upper is None or lower is None or len(upper) > len(lower):
        return None
    return ZERO if len(upper) < len(lower) else upper[-1] / lower[-1]


def ceases(course: Curve, root: Extremum, end: Formula | None) -> bool:
    """Whether a quantity vanishes at the last root and is not real at the end beyond it: there it ceases."""
    return end is not None and root.value == ZERO and course.at(end) is None


def probe(course: Curve, root: Formula, towards: int, domain: Domain) -> Formula:
    """A place beyond the last root, on its lower or upper side."""
    end = domain.end(towards)
    if end is not None and end != ZERO:
        return (root + end) / 2
    if domain.low == ZERO and course.sign(root) == 0:
        return ONE
    if domain.low == ZERO:
        return root * 2 if towards > 0 else root / 2
    return root + towards


def why_best(course: Curve, places: list[Extremum], best: Extremum, word: str) -> Words:
    """All places with the values there: "M = 0 at x = 0, M = 0 at x = L: largest at x = L/3"."""
    if course.numbered:
        count = len(places)
        return (NUMERICALLY, f"there it is {word}" + (f", of {count} places where it vanishes" if count > 1 else ""))
    words: list[str | Formula] = []
    for other in (place for place in places if place is not best):
        words += [", " if words else "", course.quantity, " = ", other.value, " at ", Symbol(course.letter), " = "]
        words.append(other.at)
    here: list[str | Formula] = [course.quantity, " = ", best.value, ", the ", word]
    return (*here, "; ", *words) if words else (*here, ": the only place where the derivative changes its sign")


def flatness(name: str, curve: Formula, letter: str, slope: Formula, search: Search) -> tuple[str, Formula]:
    """What vanishes at an extremum, in words and as a formula: the derivative, of a root or a size that of its square."""
    from rotsolve.algebra.calculus.separable import has_root

    square = search.solver.simplify(curve**2)
    if (has_root(curve, letter) and not has_root(square, letter)) or may_bend(curve, letter):
        return f"d({name}²)/d{name_to_text(letter)} = 0", search.solver.simplify(differentiate(square, letter))
    return f"d{name}/d{name_to_text(letter)} = 0", slope
