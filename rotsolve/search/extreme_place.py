"""Extreme place: where a quantity over a letter is largest or smallest: where its derivative vanishes, or at an end of the letter's range.

Roots without a closed form are certified numbers where all other letters have numbers: then they are letters `#0`, `#1`, … of their own.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct, field

from rotsolve.algebra.calculus.derivative import differentiate, same_a_turn_on
from rotsolve.algebra.certified.ball import Certified, ends, evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.field import PolynomialSigns
from rotsolve.algebra.exact.normal import Fractions, coefficients, degree, is_zero
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import ONE, PI, ZERO, Call, Formula, Symbol, call, formula
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import ANGULAR_VELOCITY, INERTIA, MASS
from rotsolve.core.derivation import Words
from rotsolve.language.problem import references
from rotsolve.motion.positive import is_angle
from rotsolve.paths.meaning import NotYet
from rotsolve.search.search import Search

FIRST = formula(
    -3
)  # rad: where the turn begins in which roots without a closed form are looked for, at no place of a tidy problem
NUMERICALLY = "solved numerically, with certified digits; "


class Domain(Struct, frozen=True):
    """From `low` to `high`, both ends included but for a low one that is `open`; None where there is no end on that side."""

    low: Formula | None
    high: Formula | None
    open: bool = False

    @property
    def ends(self) -> list[Formula]:
        """The ends that belong to it."""
        return [end for end in (None if self.open else self.low, self.high) if end is not None]


class Extremum(Struct, frozen=True):
    """A place where the extremum may be, with the quantity there; `number` is that of a place without a closed form."""

    at: Formula
    value: Formula
    number: Certified | None = None


class Curve(Struct):
    """How a quantity runs over a letter: its own letter, its closed form and the derivative of that."""

    letter: str
    quantity: Formula
    curve: Formula
    slope: Formula  # of the curve, or of its square where only that is smooth
    smooth: Formula  # the curve or its square
    search: Search
    numbered: dict[str, Certified] = field(default_factory=dict)  # the places without a closed form

    def sign(self, value: Formula) -> int | None:
        """The sign of what holds such places too; None where nothing tells it."""
        if not value.symbols() & self.numbered.keys():
            return self.search.signs.taken(value)
        number = self.number(value)
        return None if number is None else number.sign

    def number(self, value: Formula) -> Certified | None:
        """The number of what holds such places; None where it is not real."""
        try:
            return evaluate(value, self.search.signs.values, roots=self.numbered)
        except (Undefined, ValueError, ZeroDivisionError):
            return None

    def is_real(self, value: Formula) -> bool:
        """Whether a formula has a number, as far as letters without one do not leave that open."""
        if value.symbols() & self.numbered.keys():
            return self.number(value) is not None
        signs = self.search.signs
        return self.search.number(value) is not None or not signs.trials.keys() >= set(signs.lacking(value))

    def is_level(self, one: Extremum, other: Extremum) -> bool:
        """Whether a quantity is the same at two places, as far as it can be told apart there."""
        gap = one.value - other.value
        return not self.sign(gap) if gap.symbols() & self.numbered.keys() else is_zero(gap)

    def at(self, place: Formula) -> Extremum | None:
        """The quantity at a place, None where it has no value there, or none that is real, as the root of a negative square."""
        try:
            value = self.search.solver.simplify(self.curve.substitute({self.letter: place}))
        except (ZeroDivisionError, ValueError):
            return None
        number = self.number(place) if place.symbols() & self.numbered.keys() else None
        return Extremum(place, value, number) if self.is_real(value) else None


def domain_of(letter: str, search: Search) -> Domain:
    """A place along a rod lies between its ends, an angle may be any, and a rate in space; everything else with a dimension is positive."""
    configuration = search.scene.configuration
    for ref in references(configuration.problem):
        body = configuration.bodies.get(ref.owner)
        length = body.shape.reach() if body is not None and body.shape is not None else None
        if ref.argument == Symbol(letter) and length is not None:
            return Domain(ZERO, length)
    given, space = search.givens[letter], configuration.problem.space
    signed = given.dimension is None or is_angle(given) or (space and given.dimension.matches(ANGULAR_VELOCITY))
    bodily = given.dimension in (MASS, INERTIA)  # without a mass there is no body
    return Domain(None if signed else ZERO, None, open=bodily)


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
    gaps = [root - domain.low] if domain.low is not None else []
    gaps += [domain.high - root] if domain.high is not None else []
    signs = [course.sign(gap) for gap in gaps]
    if None in signs and -1 not in signs:
        raise NotYet(f"whether a root for `{course.letter}` lies in its range depends on the givens: give them numbers")
    return -1 not in signs


# roots of the derivative


def roots_of(course: Curve, domain: Domain) -> tuple[list[Formula], bool]:
    """The roots of the derivative, and whether they are those of an angle that comes round, over one turn."""
    search = course.search
    order, positive = search.solver.order, search.solver.positive
    parts, roots = list(factors_of(course.slope, course)), dict[Formula, None]()
    for part in parts:
        found = solve_polynomial(part, course.letter, order=order, positive=positive)
        if not found:
            break
        roots |= dict.fromkeys(found)
    else:
        return list(roots), False
    angles = solve_trig(course.slope, course.letter, order=order, positive=positive)
    if angles:  # the positive ones first
        return sorted(angles, key=lambda root: (search.signs.taken(root) or 0) < 0), True
    if set(search.signs.lacking(course.slope)) - {course.letter}:
        raise NotYet(
            f"where the derivative by `{course.letter}` vanishes has no closed form: give all other letters numbers"
        )
    return numbered_roots(course, parts, domain)


def factors_of(value: Formula, course: Curve) -> Iterator[Formula]:
    """The factors in the letter that make a value vanish; a root vanishes with what stands under it."""
    problem = Fractions([value], course.search.solver.order, course.search.solver.positive, extra=(course.letter,))
    _, factors = problem.field.factor(problem.numerator())
    for factor, _ in factors:
        part = problem.shaper.poly(factor)
        if isinstance(part, Call) and part.function == "sqrt":
            yield from factors_of(part.arguments[0], course)
        elif course.letter in part.symbols():
            yield part


def numbered_roots(course: Curve, parts: list[Formula], domain: Domain) -> tuple[list[Formula], bool]:
    """All roots without a closed form, certified: of what comes round once round, of polynomials up to Cauchy's bound."""
    from rotsolve.algebra.certified.rootfind import real_roots

    letter, values = course.letter, course.search.signs.values
    round_ = domain.low is None and same_a_turn_on(course.curve, letter)
    found: list[Certified] = []
    for part in parts:
        bound = 0 if round_ else cauchy_bound(part, course)
        low = FIRST if round_ else 0 if domain.low == ZERO else -bound
        roots = real_roots(part, letter, values, low, low + turn_of_curve(course) if round_ else bound)
        if not roots.complete:
            raise NotYet(f"not all places were found at which the derivative by `{letter}` vanishes")
        found += roots.roots
    names = [f"#{number}" for number in range(len(found))]
    course.numbered |= dict(zip(names, found, strict=True))
    places: list[Formula] = [Symbol(name) for name in names]
    if round_:  # angles between −π and π, or −π/2 and π/2
        turn = turn_of_curve(course)
        places = [place - turn if course.sign(place - turn / 2) == 1 else place for place in places]
    return places, round_


def turn_of_curve(course: Curve) -> Formula:
    """The angle after which all is the same again: half a turn, or a whole one."""
    on = course.curve.substitute({course.letter: Symbol(course.letter) + PI})
    return PI if is_zero(on - course.curve) else 2 * PI


def cauchy_bound(part: Formula, course: Curve) -> int:
    """A whole number beyond which a polynomial in the letter has no root: 1 + max |aᵢ/aₙ|."""
    powers = coefficients(part, course.letter)
    if powers is None:
        raise NotYet(f"where the derivative by `{course.letter}` vanishes has no closed form")
    top = powers[-1]
    sizes = [evaluate(call("abs", power / top), course.search.signs.values) for power in powers[:-1]]
    return 2 + int(max(ends(size.ball)[1] for size in sizes))


# what else may be an extremum


def check_smooth(course: Curve, domain: Domain) -> None:
    """An extremum at a kink or a pole is not seen by the derivative."""
    positive = course.search.solver.positive | ({course.letter} if domain.low == ZERO else frozenset())
    problem = Fractions([course.smooth], positive=positive)
    _, bottom = problem.field.cancel(problem.ratio())
    signs = PolynomialSigns(problem.field, positive)
    parts = [part for part, _ in problem.field.factor(bottom)[1]]
    if may_bend(course.smooth, course.letter) or not all(
        signs.nonnegative(part) or signs.nonnegative(-part) or rootless(problem.shaper.poly(part), course)
        for part in parts
    ):
        raise NotYet(f"an extremum of what jumps or bends sharply as `{course.letter}` changes is not solved yet")


def may_bend(curve: Formula, letter: str) -> bool:
    """Whether a curve is a size, which may bend sharply where its letter changes."""
    return any(letter in node.symbols() for node in curve.walk("abs"))


def rootless(part: Formula, course: Curve) -> bool:
    """Whether a factor of the second degree in the letter vanishes nowhere: b² < 4 a c."""
    letter = course.letter
    if degree(part, letter) != 2:
        return letter not in part.symbols()
    bend, zero = differentiate(differentiate(part, letter), letter), {letter: ZERO}
    slope, rest = differentiate(part, letter).substitute(zero), part.substitute(zero)
    return course.search.signs.sign(slope**2 - bend * rest * 2) == -1


def check_open_ends(course: Curve, domain: Domain, inside: list[Extremum], best: Extremum | None, word: str) -> None:
    """Where the domain has no end, the quantity must get worse beyond the last root, or come near nothing better, or not be real."""
    for towards, end in ((-1, domain.low), (1, domain.high)):
        outermost = outermost_of(inside, towards, course)
        if end in domain.ends and course.at(end) is not None:
            continue
        if outermost is not None and ceases(course, outermost, end):
            continue
        beyond = probe(course, outermost.at, towards, domain) if outermost is not None else ONE
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
        more = "grows" if side > 0 else "falls"
        raise NotYet(
            f"it has no {word} value: it {more} all the way as `{letter}` {'grows' if towards > 0 else 'falls'}"
        )


def value_far_out(course: Curve, domain: Domain, towards: int) -> Formula | None:
    """What a quotient of polynomials, or its square, comes to far out: by its highest powers; None where it has no bounds, or is none.

    At an open end it is what the quantity is there.
    """
    if domain.open and towards < 0:
        there = course.at(ZERO)
        return None if there is None else there.value if course.smooth == course.curve else there.value**2
    if domain.low == ZERO and towards < 0:
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
