"""Places: of the roots of the derivative and the ends of the domain, the one where a quantity is largest or smallest."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.exact.normal import Problem
from rotsolve.algebra.exact.signs import Signs
from rotsolve.algebra.exact.solving.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import ONE, ZERO, Call, Formula, Number, Symbol
from rotsolve.core.derivation import Words
from rotsolve.paths.meaning import NotYet
from rotsolve.search.search import Search
from rotsolve.search.where.domain import Domain, domain_of, sign_of

TWO = Number(ONE.value * 2)


class Course(Struct, frozen=True):
    """How a quantity runs over a letter: its own letter, its closed form and the derivative of that."""

    letter: str
    quantity: Formula
    curve: Formula
    slope: Formula

    def value(self, at: Formula, search: Search) -> Formula | None:
        """The quantity at a place, None where it has no value there."""
        try:
            return search.solver.simplify(self.curve.substitute({self.letter: at}))
        except (ZeroDivisionError, ValueError):
            return None


def best_place(course: Course, word: str, search: Search) -> tuple[Formula, Words]:
    """The place of the extremum, and why it is this one: all places where it can be, with the value there."""
    domain = domain_of(course.letter, search)
    check_smooth(course, domain, search)
    roots = roots_of(course, search)
    turning = [] if roots else angles(course, search)
    found = [root for root in roots if is_inside(root, domain, course, search)]
    inside = [root for root in found if course.value(root, search) is not None] or turning
    ends = [end for end in (domain.low, domain.high) if end is not None and end not in inside]
    valued = [(at, value) for at in (*inside, *ends) if (value := course.value(at, search)) is not None]
    side = 1 if word == "largest" else -1
    if not turning:
        check_open_ends(course, domain, inside, [at for at, _ in valued], side, search)
    best = valued[0]
    for other in valued[1:]:
        ahead = sign_of(other[1] - best[1], search)
        if ahead is None:
            raise NotYet(f"where `{course.letter}` makes it {word} depends on the givens: give them numbers")
        best = other if ahead * side > 0 else best
    at_end: Words = ("an end of the range; ",) if best[0] in ends else ()
    return best[0], (*at_end, *told(course, valued, best, word))


def roots_of(course: Course, search: Search) -> list[Formula]:
    """The roots of the derivative, factor by factor; none where one of the factors is of a higher degree."""
    order, positive = search.solver.order, search.solver.positive
    roots: dict[Formula, None] = {}
    for part in factors_of(course.slope, course.letter, search):
        found = solve_polynomial(part, course.letter, order=order, positive=positive)
        if not found:
            return []
        roots |= dict.fromkeys(found)
    return list(roots)


def factors_of(value: Formula, letter: str, search: Search) -> Iterator[Formula]:
    """The factors in a letter that make a value vanish; a root vanishes with what stands under it."""
    problem = Problem([value], search.solver.order, search.solver.positive, extra=(letter,))
    _, factors = problem.field.factor(problem.numerator())
    for factor, _ in factors:
        part = problem.shaper.poly(factor)
        if isinstance(part, Call) and part.function == "sqrt":
            yield from factors_of(part.arguments[0], letter, search)
        elif letter in part.symbols():
            yield part


def angles(course: Course, search: Search) -> list[Formula]:
    """Roots of a derivative in the sine and cosine of the letter, over a full turn; the positive ones first."""
    found = solve_trig(course.slope, course.letter, order=search.solver.order, positive=search.solver.positive)
    roots = [candidate.formula for candidate in found]
    return sorted(roots, key=lambda root: (sign_of(root, search) or 0) < 0)


def is_inside(root: Formula, domain: Domain, course: Course, search: Search) -> bool:
    """Whether a root lies in the domain, ends included; one that is not real does not."""
    if not root.symbols() - set(search.values) and search.number(root) is None:
        return False
    gaps = [root - domain.low] if domain.low is not None else []
    gaps += [domain.high - root] if domain.high is not None else []
    signs = [sign_of(gap, search) for gap in gaps]
    if None in signs and -1 not in signs:
        raise NotYet(f"whether a root for `{course.letter}` lies in its range depends on the givens: give them numbers")
    return -1 not in signs


def check_smooth(course: Course, domain: Domain, search: Search) -> None:
    """An extremum at a kink or a pole is not seen by the derivative."""
    positive = search.solver.positive | ({course.letter} if domain.low == ZERO else frozenset())
    problem = Problem([course.curve], positive=positive)
    _, bottom = problem.field.cancel(problem.ratio())
    signs = Signs(problem.field, positive)
    kinked = any(
        isinstance(node, Call) and node.function == "abs" and course.letter in node.symbols()
        for node in course.curve.walk("abs")
    )
    if kinked or not (signs.nonnegative(bottom) or signs.nonnegative(-bottom)):
        raise NotYet(f"an extremum of what jumps or bends sharply as `{course.letter}` changes is not solved yet")


def check_open_ends(
    course: Course, domain: Domain, inside: list[Formula], valued: list[Formula], side: int, search: Search
) -> None:
    """Where the domain has no end, the quantity must fall (or rise, for a smallest) beyond the last root."""
    open_low = domain.low is None or domain.low not in valued
    open_high = domain.high is None or domain.high not in valued
    for open_, towards in ((open_low, -1), (open_high, 1)):
        if not open_:
            continue
        beyond = [probe(root, towards, domain) for root in inside]
        signs = [sign_of(course.slope.substitute({course.letter: at}), search) for at in beyond]
        if len(inside) != 1 or signs[0] is None or signs[0] * towards * side >= 0:
            raise NotYet(f"no {'largest' if side > 0 else 'smallest'} value was found: `{course.letter}` has no bounds")


def probe(root: Formula, towards: int, domain: Domain) -> Formula:
    """A place beyond the only root, on its lower or upper side."""
    if domain.low == ZERO:
        return root * TWO if towards > 0 else root / TWO
    return root + Number(ONE.value * towards)


def told(course: Course, valued: list[tuple[Formula, Formula]], best: tuple[Formula, Formula], word: str) -> Words:
    """All places with the values there: "M = 0 at x = 0, M = 0 at x = L: largest at x = L/3"."""
    words: list[str | Formula] = []
    others = [entry for entry in valued if entry is not best]
    for at, value in others:
        words += [", " if words else "", course.quantity, " = ", value, " at ", Symbol(course.letter), " = ", at]
    here: list[str | Formula] = [course.quantity, " = ", best[1], ", the ", word]
    return (*here, "; ", *words) if words else (*here, ": the only place where the derivative changes its sign")
