"""Extrema: `x where Q is largest` and `largest Q`: where the derivative by a letter vanishes, or the letter is at an end of its domain."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.calculus.separable import has_root
from rotsolve.algebra.exact.field import PolynomialSigns
from rotsolve.algebra.exact.normal import Fractions, degree, is_zero
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import ZERO, Call, Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Equality, Words
from rotsolve.core.equation import FOUND
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.symbols import asked_symbol
from rotsolve.language.problem import Condition, Find, references
from rotsolve.motion.positive import is_angle
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.find import Asked, question_for
from rotsolve.search.answers import Answered
from rotsolve.search.search import Search
from rotsolve.solver.steps import Found, Ref, Step


class Conclusion(Struct, frozen=True):
    """The line of a condition: "dB/dx = 0", what that comes to as an equation, and why it is this root."""

    said: str
    equation: Equality
    reason: Words


def by_condition(
    search: Search, question: Asked, value: Formula, line: Conclusion, quantity: Answered, *, aside: bool
) -> Answered:
    """An answer that solves what an answer before it, as a function of a letter, has to fulfil."""
    chain = (line.equation, Equality(Symbol(question.letter), value))
    steps = add_step(search, question, ("words", line.said), (ref_of(quantity, search),), chain, line.reason)
    return remember_answer(search, Answered(question, Found(question.letter, value), (), steps, aside=aside))


def add_step(
    search: Search, asked: Asked, target: Ref, sources: Sequence[Ref], chain: Sequence[Equality], reason: Words
) -> tuple[int, int]:
    """The line of algebra, and where it stands among the steps."""
    steps = search.solver.steps
    steps.append(Step(len(steps) + 1, target, tuple(sources), tuple(chain), asked.letter, asked.section, reason))
    return len(steps) - 1, len(steps)


def remember_answer(search: Search, answered: Answered) -> Answered:
    """Remember an answer for the next question."""
    search.solver.solved[answered.asked.letter] = answered.found
    search.known.add(answered.asked.letter)
    search.answered.append(answered)
    return answered


def ref_of(answered: Answered, search: Search) -> Ref:
    """The step that gave an answer, or its one law where it needed none."""
    steps = search.solver.steps[slice(*answered.steps)]
    return ("step", steps[-1].number) if steps else ("law", answered.used[0])


def forget(answered: Answered, search: Search) -> None:
    """Let a quantity be settled anew from its closed form, since a letter in that has got a value."""
    letter, formula = answered.asked.letter, answered.found.formula
    search.solver.solved.pop(letter, None)
    search.known.discard(letter)
    if formula is not None:
        result = FOUND.equation(Symbol(letter), formula, answered.asked.section, cost=1)
        search.solver.derived.append((result, ref_of(answered, search)))
        search.remember()


class Domain(Struct, frozen=True):
    """From `low` to `high`, both ends included; None where there is no end on that side."""

    low: Formula | None
    high: Formula | None


def domain_of(letter: str, search: Search) -> Domain:
    """A place along a rod lies between its ends, an angle may be any, everything else with a dimension is positive."""
    configuration = search.scene.configuration
    for ref in references(configuration.problem):
        body = configuration.bodies.get(ref.owner)
        length = body.shape.reach() if body is not None and body.shape is not None else None
        if ref.argument == Symbol(letter) and length is not None:
            return Domain(ZERO, length)
    given = search.givens[letter]
    return Domain(None if given.dimension is None or is_angle(given) else ZERO, None)


class Curve(Struct, frozen=True):
    """How a quantity runs over a letter: its own letter, its closed form and the derivative of that."""

    letter: str
    quantity: Formula
    curve: Formula
    slope: Formula  # of the curve, or of its square where only that is smooth
    smooth: Formula  # the curve or its square

    def value(self, at: Formula, search: Search) -> Formula | None:
        """The quantity at a place, None where it has no value there, or none that is real, as the root of a negative square."""
        try:
            value = search.solver.simplify(self.curve.substitute({self.letter: at}))
        except (ZeroDivisionError, ValueError):
            return None
        return value if is_real(value, search) else None


def best_place(course: Curve, word: str, search: Search, *, only: bool) -> tuple[Formula, Words]:
    """The place of the extremum, the `only` one where that is asked, and why: all places where it can be, with the value there."""
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
        ahead = search.signs.taken(other[1] - best[1])
        if ahead is None:
            raise NotYet(f"where `{course.letter}` makes it {word} depends on the givens: give them numbers")
        best = other if ahead * side > 0 else best
    if any(ceases(course, best[0], end, search) for end in (domain.low, domain.high)):
        raise NotYet(f"it is {word} where it vanishes and ceases to be real: what is asked does not come about there")
    level = [at for at, value in valued if only and at != best[0] and not turning and is_zero(value - best[1])]
    if level:
        places = " and ".join(to_text(at) for at in (best[0], *level))
        raise NotYet(f"it is {word} at more than one `{course.letter}`: at {places}")
    at_end: Words = ("an end of the range; ",) if best[0] in ends else ()
    return best[0], (*at_end, *why_best(course, valued, best, word))


def roots_of(course: Curve, search: Search) -> list[Formula]:
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
    problem = Fractions([value], search.solver.order, search.solver.positive, extra=(letter,))
    _, factors = problem.field.factor(problem.numerator())
    for factor, _ in factors:
        part = problem.shaper.poly(factor)
        if isinstance(part, Call) and part.function == "sqrt":
            yield from factors_of(part.arguments[0], letter, search)
        elif letter in part.symbols():
            yield part


def angles(course: Curve, search: Search) -> list[Formula]:
    """Roots of a derivative in the sine and cosine of the letter, over a full turn; the positive ones first."""
    roots = solve_trig(course.slope, course.letter, order=search.solver.order, positive=search.solver.positive)
    return sorted(roots, key=lambda root: (search.signs.taken(root) or 0) < 0)


def is_inside(root: Formula, domain: Domain, course: Curve, search: Search) -> bool:
    """Whether a root lies in the domain, ends included; one that is not real does not."""
    if not is_real(root, search):
        return False
    gaps = [root - domain.low] if domain.low is not None else []
    gaps += [domain.high - root] if domain.high is not None else []
    signs = [search.signs.taken(gap) for gap in gaps]
    if None in signs and -1 not in signs:
        raise NotYet(f"whether a root for `{course.letter}` lies in its range depends on the givens: give them numbers")
    return -1 not in signs


def is_real(value: Formula, search: Search) -> bool:
    """Whether a formula has a number, as far as letters without one do not leave that open."""
    return search.number(value) is not None or not search.signs.trials.keys() >= set(search.signs.lacking(value))


def check_smooth(course: Curve, domain: Domain, search: Search) -> None:
    """An extremum at a kink or a pole is not seen by the derivative."""
    positive = search.solver.positive | ({course.letter} if domain.low == ZERO else frozenset())
    problem = Fractions([course.smooth], positive=positive)
    _, bottom = problem.field.cancel(problem.ratio())
    signs = PolynomialSigns(problem.field, positive)
    parts = [part for part, _ in problem.field.factor(bottom)[1]]
    if may_bend(course.smooth, course.letter) or not all(
        signs.nonnegative(part)
        or signs.nonnegative(-part)
        or rootless(problem.shaper.poly(part), course.letter, search)
        for part in parts
    ):
        raise NotYet(f"an extremum of what jumps or bends sharply as `{course.letter}` changes is not solved yet")


def rootless(part: Formula, letter: str, search: Search) -> bool:
    """Whether a factor of the second degree in a letter vanishes nowhere: b² < 4 a c."""
    if degree(part, letter) != 2:
        return letter not in part.symbols()
    bend, zero = differentiate(differentiate(part, letter), letter), {letter: ZERO}
    slope, rest = differentiate(part, letter).substitute(zero), part.substitute(zero)
    return search.signs.sign(slope**2 - bend * rest * 2) == -1


def check_open_ends(
    course: Curve, domain: Domain, inside: list[Formula], valued: list[Formula], side: int, search: Search
) -> None:
    """Where the domain has no end, the quantity must fall (or rise, for a smallest) beyond the last root, or not be real beyond it."""
    sizes = {at: size for at in inside if (size := search.number(at)) is not None}
    lowest, highest = (pick(sizes, key=sizes.__getitem__, default=None) for pick in (min, max))
    open_low = (domain.low is None or domain.low not in valued) and not ceases(course, lowest, domain.low, search)
    open_high = (domain.high is None or domain.high not in valued) and not ceases(course, highest, domain.high, search)
    for open_, towards in ((open_low, -1), (open_high, 1)):
        if not open_:
            continue
        beyond = [probe(root, towards, domain) for root in inside]
        signs = [search.signs.taken(course.slope.substitute({course.letter: at})) for at in beyond]
        if len(inside) != 1 or signs[0] is None or signs[0] * towards * side >= 0:
            raise NotYet(f"no {'largest' if side > 0 else 'smallest'} value was found: `{course.letter}` has no bounds")


def ceases(course: Curve, root: Formula | None, end: Formula | None, search: Search) -> bool:
    """Whether a quantity vanishes at the last root and is not real at the end beyond it: there it ceases."""
    if root is None or end is None or course.value(root, search) != ZERO:
        return False
    return course.value(end, search) is None


def probe(root: Formula, towards: int, domain: Domain) -> Formula:
    """A place beyond the only root, on its lower or upper side."""
    if domain.low == ZERO:
        return root * 2 if towards > 0 else root / 2
    return root + towards


def why_best(course: Curve, valued: list[tuple[Formula, Formula]], best: tuple[Formula, Formula], word: str) -> Words:
    """All places with the values there: "M = 0 at x = 0, M = 0 at x = L: largest at x = L/3"."""
    words: list[str | Formula] = []
    others = [entry for entry in valued if entry is not best]
    for at, value in others:
        words += [", " if words else "", course.quantity, " = ", value, " at ", Symbol(course.letter), " = ", at]
    here: list[str | Formula] = [course.quantity, " = ", best[1], ", the ", word]
    return (*here, "; ", *words) if words else (*here, ": the only place where the derivative changes its sign")


def over_a_letter(find: Find, search: Search) -> bool:
    """Whether a question is for the largest or smallest value of a quantity at a place that has no value."""
    return bool(find.extreme) and bool(free_letters(find, search))


def free_letters(find: Find, search: Search) -> list[str]:
    """Letters without a value that say at which place of a rod a quantity is asked, or on which an earlier answer depends."""
    formulas = [point.argument for point in references(find.terms) if point.argument is not None]
    earlier = next((item for item in search.answered if Symbol(item.asked.find.name) == find.formula), None)
    if earlier is not None:
        sought = [letter for formula, letter, _ in search.extrema if formula == earlier.asked.formula]
        formulas += [Symbol(letter) for letter in sought] or [earlier.found.formula or ZERO]
    names = {name for formula in formulas for name in formula.symbols()}
    return sorted(name for name in names if name in search.givens and name not in search.values)


def extreme_value(search: Search, find: Find) -> None:
    """`largest Q` over the one free letter of Q: its value at the place of the extremum."""
    letters, word = free_letters(find, search), find.extreme
    if len(letters) != 1:
        raise NotYet(f"`{find.text.strip()}` is open over several letters: {', '.join(letters)}")
    terms = tuple(replace(term, modifier="") for term in find.terms)
    phrase = replace(find, modifier="", terms=terms)
    if letters[0] in search.solver.solved:
        at_settled_place(search, phrase, letters[0], word)
        return
    quantity = answer_over(search, phrase, letters[0])
    place = search.extrema.get((quantity.asked.formula, letters[0], word))
    if place is None:
        name = fresh(f"{letters[0]}_{'max' if word == 'largest' else 'min'}", search)
        condition = Condition(None, word=word, span=find.span, phrase=phrase)
        own = Find(name, Symbol(letters[0]), (), where=condition, text=letters[0], span=find.span)
        place = place_of_extremum(search, own, aside=True)
    at, curve = place.found.formula, quantity.found.formula
    assert at is not None and curve is not None
    letter = Symbol(asked_symbol(find.name))
    value = search.solver.simplify(curve.substitute({letters[0]: at}))
    question = Asked(find, letter, letter.name, quantity.asked.dimension, section=quantity.asked.section)
    line = (Equality(letter, curve.substitute({letters[0]: at})), Equality(letter, value))
    steps = add_step(search, question, ref_of(quantity, search), (ref_of(place, search),), line, ())
    remember_answer(search, Answered(question, Found(letter.name, value), (), steps))


def at_settled_place(search: Search, phrase: Find, letter: str, word: str) -> None:
    """The extreme value once the letter has the value that makes it so."""
    question = question_for(phrase, search.scene, search.letters())
    if (question.formula, letter, word) not in search.extrema:
        raise NotYet(f"`{letter}` has been settled by another condition: this quantity has one value only")
    search.answer(question)


def place_of_extremum(search: Search, find: Find, *, aside: bool = False) -> Answered:
    """`x where Q is largest`: where dQ/dx = 0 or at an end, whichever gives most."""
    condition = find.where
    assert condition is not None and condition.phrase is not None and condition.word is not None
    letter = find.formula.name if isinstance(find.formula, Symbol) else ""
    if letter not in search.givens or letter in search.values:
        raise NotYet(
            "an extremum is over a letter of the scene that has no value",
            help="write `x where Q is largest`, with `x: unknown` or `x: m` under `given`",
        )
    quantity, curve = as_function_of(search, condition.phrase, letter)
    smooth = search.solver.simplify(curve**2) if may_bend(curve, letter) else curve
    slope = search.solver.simplify(differentiate(smooth, letter))
    said, shown = flatness(name_to_text(quantity.asked.find.name), curve, letter, slope, search)
    given = search.givens[letter]
    own = letter if given.asked else asked_symbol(find.name)
    at, reason = best_place(
        Curve(letter, Symbol(quantity.asked.letter), curve, slope, smooth), condition.word, search, only=not aside
    )
    # else it is at an end, where nothing needs to vanish
    flat = is_zero(shown.substitute({letter: at}), search.solver.positive)
    equation = Equality(shown.substitute({letter: Symbol(own)}) if flat else shown, ZERO)
    question = Asked(find, Symbol(own), own, given.dimension, section=quantity.asked.section)
    answered = by_condition(search, question, at, Conclusion(said, equation, reason), quantity, aside=aside)
    search.extrema[(quantity.asked.formula, letter, condition.word)] = answered
    if given.asked:
        forget(quantity, search)  # from here on the letter has its value, and the quantity that of this place
    return answered


def flatness(name: str, curve: Formula, letter: str, slope: Formula, search: Search) -> tuple[str, Formula]:
    """What vanishes at an extremum, in words and as a formula: the derivative, of a root or a size that of its square."""
    square = search.solver.simplify(curve**2)
    if (has_root(curve, letter) and not has_root(square, letter)) or may_bend(curve, letter):
        return f"d({name}²)/d{name_to_text(letter)} = 0", search.solver.simplify(differentiate(square, letter))
    return f"d{name}/d{name_to_text(letter)} = 0", slope


def may_bend(curve: Formula, letter: str) -> bool:
    """Whether a curve is a size, which may bend sharply where its letter changes."""
    return any(letter in node.symbols() for node in curve.walk("abs"))


def as_function_of(search: Search, phrase: Find, letter: str) -> tuple[Answered, Formula]:
    """The quantity of a phrase, and its closed form as a function of a letter."""
    quantity = answer_over(search, phrase, letter)
    curve = quantity.found.formula
    if curve is None or letter not in curve.symbols():
        raise NotYet(f"`{phrase.text.strip()}` is no function of `{letter}` in closed form")
    return quantity, curve


def answer_over(search: Search, phrase: Find, letter: str) -> Answered:
    """The quantity of a phrase while a letter has no value, settled on the way where no question asks for it."""
    question = question_for(phrase, search.scene, search.letters())
    for item in search.answered:
        if question.formula in (item.asked.formula, Symbol(item.asked.letter)):
            return item
    word = QUANTITIES[phrase.terms[0].path.quantity].letter if len(phrase.terms) == 1 else "Q"
    find = replace(phrase, name=fresh(word, search))
    question = question_for(find, search.scene, search.letters())
    settled = letter in search.known
    search.known.add(letter)
    try:
        return search.answer(question, aside=True)
    finally:
        if not settled:
            search.known.discard(letter)


def fresh(name: str, search: Search) -> str:
    """A name that neither a given nor a question has."""
    problem = search.scene.configuration.problem
    taken = {*search.givens, *(find.name for find in problem.finds)}
    taken |= {item.asked.find.name for item in search.answered}
    return next(word for word in (name, *(f"{name}_{number}" for number in range(1, 100))) if word not in taken)
