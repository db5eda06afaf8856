"""Curve of a quantity over a letter, the range of the letter, and where its derivative vanishes there.

Roots without a closed form are certified numbers where all other letters have numbers: then they are letters `#0`, `#1`, … of their own.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import period_of, same_a_turn_on
from rotsolve.algebra.certified.ball import Certified, ends, evaluate
from rotsolve.algebra.certified.balls import Undefined, with_values
from rotsolve.algebra.exact.normal import Fractions, coefficients, is_zero, simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import ONE, PI, ZERO, Call, Formula, Symbol, call, formula
from rotsolve.algebra.units.dimension import ANGULAR_VELOCITY, INERTIA, MASS
from rotsolve.language.keys import HIGHEST
from rotsolve.language.problem import references
from rotsolve.motion.limits import limits_of_scene
from rotsolve.motion.positive import is_angle
from rotsolve.paths.meaning import NotYet
from rotsolve.search.search import Search

FIRST = formula(-3)  # rad: where the turn begins in which numbers are looked for, at no place of a tidy problem
TURN = 2 * PI
MARGIN = formula(1) / 7  # beyond the ends of a range, so that a root at an end is not missed
PRECISE = 400  # bits in which two places are compared: what is the same in 90 digits is as good


class Domain(Struct, frozen=True):
    """From `low` to `high`, each included unless it is `open` (−1 and +1 name the sides); None where there is no end on that side."""

    low: Formula | None
    high: Formula | None
    open: frozenset[int] = frozenset()

    @property
    def ends(self) -> list[Formula]:
        """The ends that belong to it."""
        return [end for side in (-1, 1) if (end := self.end(side)) is not None and side not in self.open]

    def end(self, side: int) -> Formula | None:
        """The end on one side."""
        return self.low if side < 0 else self.high

    @property
    def endless(self) -> bool:
        """Whether it has no end on either side."""
        return self.low is None and self.high is None


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
            return evaluate(value, self.search.signs.values, roots=self.numbered, max_precision=PRECISE)
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
        if gap.symbols() & self.numbered.keys():
            return not self.sign(gap)
        return is_zero(gap) or (self.search.number(gap) is not None and self.sign(gap) == 0)

    def at(self, place: Formula) -> Extremum | None:
        """The quantity at a place, None where it has no value there, or none that is real, as the root of a negative square."""
        numbered = bool(place.symbols() & self.numbered.keys())
        curve = with_values(self.curve, self.search.signs.values) if numbered else self.curve
        try:
            value = self.search.solver.simplify(curve.substitute({self.letter: place}))
        except (ZeroDivisionError, ValueError):
            return None
        number = self.number(place) if numbered else None
        return Extremum(place, value, number) if self.is_real(value) else None


def domain_of(letter: str, search: Search) -> Domain:
    """What a letter can be by itself, where all that the scene asks of formulas with it holds: 0 < S − m₁ for a mass S − m₁."""
    domain = domain_alone(letter, search)
    for limit in limits_of_scene(search.scene.configuration):
        if letter not in limit.gap.symbols() or limit.gap == Symbol(letter):
            continue
        parts = coefficients(simplify(limit.gap), letter)
        if parts is None or len(parts) != 2:
            message = f"over what range `{letter}` runs is not solved: {limit.words}"
            raise NotYet(message, help="give what stands there a letter of its own")
        side, end = search.signs.taken(parts[1]), search.solver.simplify(-(parts[0] / parts[1]))
        domain = narrowed(domain, -(side or 0), end, search, strict=limit.strict) if side else domain
    return domain


def narrowed(domain: Domain, side: int, end: Formula, search: Search, *, strict: bool) -> Domain:
    """A range that ends no farther on one side than where a limit says, if that lies within it."""
    own = domain.end(side)
    ahead = None if own is None else search.signs.taken((own - end) * side)
    if own is not None and (ahead is None or ahead < 0):
        return domain
    open_ = (domain.open - {side} if ahead else domain.open) | ({side} if strict else set())
    return replace(domain, open=open_, **{"low" if side < 0 else "high": end})


def domain_alone(letter: str, search: Search) -> Domain:
    """A place along a rod lies between its ends; what stands under a key that limits it keeps to that; another angle may be any, and a rate
    in space; everything else with a dimension is positive."""
    configuration, limits = search.scene.configuration, search.signs.limits().get(letter)
    if limits in HIGHEST:
        return Domain(ZERO, HIGHEST[limits])
    for ref in references(configuration.problem):
        body = configuration.bodies.get(ref.owner)
        length = body.shape.reach() if body is not None and body.shape is not None else None
        if ref.argument == Symbol(letter) and length is not None:
            return Domain(ZERO, length)
    given, space = search.givens[letter], configuration.problem.space
    if space:
        from rotsolve.space.steady import tilts_with

        if Symbol(letter) in tilts_with(letter, search.scene):
            return Domain(ZERO, PI)
    signed = given.dimension is None or is_angle(given) or (space and given.dimension.matches(ANGULAR_VELOCITY))
    bodily = given.dimension in (MASS, INERTIA) or limits == "positive"  # without a mass or a size there is no body
    signed = signed and limits is None
    return Domain(None if signed else ZERO, None, frozenset({-1} if bodily and not signed else ()))


def amid(domain: Domain) -> Formula:
    """A place in a range."""
    if domain.low is not None and domain.high is not None:
        return (domain.low + domain.high) / 2
    return domain.high - ONE if domain.high is not None else ONE if domain.low is None else domain.low + ONE


# roots of the derivative


def roots_of(course: Curve, domain: Domain) -> tuple[list[Formula], bool]:
    """The roots of the derivative, and whether they are those of an angle of any size that comes round, over one turn."""
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
    if angles:
        round_ = domain.endless or recurrence(course, domain) is not None
        return as_often_as_they_come(angles, course, domain), round_
    if set(search.signs.lacking(course.slope)) - {course.letter}:
        raise NotYet(
            f"where the derivative by `{course.letter}` vanishes has no closed form: give all other letters numbers"
        )
    return numbered_roots(course, parts, domain)


def as_often_as_they_come(roots: list[Formula], course: Curve, domain: Domain) -> list[Formula]:
    """The roots of what comes round, in the whole range: of an angle of any size over one turn, from −π to π, the positive ones first."""
    search, period = course.search, period_of(course.slope, course.letter) or TURN
    again_after = recurrence(course, domain)
    low, high = (-PI, PI) if domain.endless else (domain.low, domain.high)
    if again_after is not None and low is not None:
        high = low + again_after
    if low is None or high is None or (domain.endless and not same_a_turn_on(course.curve, course.letter)):
        raise NotYet(f"it comes to the same over and over, and not after one turn of `{course.letter}`")
    times = search.number((high - low) / period)
    if times is None:
        raise NotYet(f"how often it comes to the same over the range of `{course.letter}` is not known: give numbers")
    count = ceil(times - 1e-9) + 1
    found: list[Formula] = []
    for root in filter(course.is_real, roots):
        again = [search.solver.simplify(root + period * number) for number in range(-count, count + 1)]
        if search.number(root) is None:  # in letters they are told from one of them on
            again = again[count : 2 * count - 1]
        elif domain.endless:
            again = [place for place in again if course.sign(place + PI) == 1 and course.sign(place - PI) != 1]
        elif again_after is not None:
            again = [place for place in again if course.sign(place - low) != -1 and course.sign(place - high) == -1]
        found += [place for place in again if not any(is_zero(place - other) for other in found)]
    return sorted(found, key=lambda place: (search.signs.taken(place) or 0) < 0)


def recurrence(course: Curve, domain: Domain) -> Formula | None:
    """After how much more of its letter, which has no upper end, as a time, a quantity comes to the same again; None of others."""
    endless = domain.low is not None and domain.high is None
    found = period_of(course.smooth, course.letter) if endless else None
    return None if found is None else course.search.solver.simplify(found)


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
    """All roots without a closed form, certified: over a range, of what comes round once round, of polynomials up to Cauchy's bound."""
    from rotsolve.algebra.certified.rootfind import real_roots

    letter, values = course.letter, course.search.signs.values
    round_ = domain.endless and same_a_turn_on(course.curve, letter)
    found: list[Certified] = []
    for part in parts:
        told = course.search.solver.simplify(with_values(part, values))  # of many terms a few remain
        roots = real_roots(told, letter, values, *search_range(part, course, domain, round_))
        if not roots.complete:
            raise NotYet(f"not all places were found at which the derivative by `{letter}` vanishes")
        found += roots.roots
    names = [f"#{number}" for number in range(len(found))]
    course.numbered |= dict(zip(names, found, strict=True))
    places: list[Formula] = [Symbol(name) for name in names]
    if round_:  # angles between −π and π
        places = [place - TURN if course.sign(place - PI) == 1 else place for place in places]
    return places, round_


def search_range(part: Formula, course: Curve, domain: Domain, round_: bool) -> tuple[Formula, Formula]:
    """From where to where the roots of a factor are looked for."""
    if round_:
        return FIRST, FIRST + TURN
    if domain.low is not None and domain.high is not None:
        return domain.low - MARGIN, domain.high + MARGIN
    bound = formula(cauchy_bound(part, course))
    return ZERO if domain.low == ZERO else -bound, bound


def cauchy_bound(part: Formula, course: Curve) -> int:
    """A whole number beyond which a polynomial in the letter has no root: 1 + max |aᵢ/aₙ|."""
    powers = coefficients(part, course.letter)
    if powers is None:
        raise NotYet(f"where that vanishes as `{course.letter}` changes has no closed form, and the range has no end")
    top = powers[-1]
    sizes = [evaluate(call("abs", power / top), course.search.signs.values) for power in powers[:-1]]
    return 2 + int(max(ends(size.ball)[1] for size in sizes))


def certified_roots(gap: Formula, letter: str, domain: Domain, search: Search) -> list[Certified]:
    """All numbers of a letter in its range at which something vanishes: of an angle once round, of polynomials up to Cauchy's bound."""
    from rotsolve.algebra.certified.rootfind import real_roots

    values = search.signs.values
    course = Curve(letter, gap, gap, gap, gap, search)
    round_ = domain.endless and same_a_turn_on(gap, letter)
    parts = list(factors_of(gap, course))
    found: list[Certified] = []
    for part in parts:
        told = search.solver.simplify(with_values(part, values))
        roots = real_roots(told, letter, values, *search_range(part, course, domain, round_))
        if not roots.complete:
            raise NotYet(f"not all values of `{letter}` were found at which the condition holds")
        found += roots.roots
    course.numbered |= {f"#{number}": root for number, root in enumerate(found)}
    places = {f"#{number}": Symbol(f"#{number}") for number in range(len(found))}
    kept: list[Certified] = []
    for place in places.values():
        at = place - TURN if round_ and course.sign(place - PI) == 1 else place
        number = course.number(at)
        beyond = any(
            (end := domain.end(side)) is not None
            and course.sign((at - end) * side) in (1, *([0] if side in domain.open else []))
            for side in (-1, 1)
        )
        if number is not None and not beyond and course.is_real(gap.substitute({letter: at})):
            kept.append(number)
    return sorted(kept, key=lambda number: number.float)
