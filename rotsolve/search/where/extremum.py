"""Extrema: `x where Q is largest` and `largest Q`: the derivative of Q by the letter is zero, or the letter is at an end of its domain."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.calculus.separable import has_root
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.core.derivation import Equality
from rotsolve.core.quantity import BY_WORD
from rotsolve.core.registry import SEPARATOR
from rotsolve.language.problem import Condition, Find, points_of
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.find import asked
from rotsolve.questions.question import Asked
from rotsolve.search.answers import Answered
from rotsolve.search.search import Search
from rotsolve.search.where.conclude import Conclusion, by_answers, by_condition, forget
from rotsolve.search.where.places import Course, best_place
from rotsolve.solver import Found


def over_a_letter(find: Find, search: Search) -> bool:
    """Whether a question is for the largest or smallest value of a quantity at a place that has no value."""
    return bool(find.extreme) and bool(free_letters(find, search))


def free_letters(find: Find, search: Search) -> list[str]:
    """Letters without a value that say at which place of a rod a quantity is asked, or on which an earlier answer depends."""
    formulas = [point.argument for point in points_of(find.terms) if point.argument is not None]
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
    quantity = function_of(search, phrase, letters[0])
    place = search.extrema.get((quantity.asked.formula, letters[0], word))
    if place is None:
        name = fresh(f"{letters[0]}_{'max' if word == 'largest' else 'min'}", search)
        condition = Condition(None, word=word, span=find.span, phrase=phrase)
        own = Find(name, Symbol(letters[0]), (), where=condition, text=letters[0], span=find.span)
        place = place_of_extremum(search, own, aside=True)
    at, curve = place.found.formula, quantity.found.formula
    assert at is not None and curve is not None
    letter = Symbol(f"asked{SEPARATOR}{find.name}")
    value = search.solver.simplify(curve.substitute({letters[0]: at}))
    question = Asked(find, letter, letter.name, quantity.asked.dimension, section=quantity.asked.section)
    line = (Equality(letter, curve.substitute({letters[0]: at})), Equality(letter, value))
    by_answers(search, question, Found(letter.name, value), line, (quantity, place))


def at_settled_place(search: Search, phrase: Find, letter: str, word: str) -> None:
    """The extreme value once the letter has the value that makes it so."""
    question = asked(phrase, search.scene, search.letters())
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
    quantity = function_of(search, condition.phrase, letter)
    curve = quantity.found.formula
    if curve is None or letter not in curve.symbols():
        raise NotYet(f"`{condition.phrase.text.strip()}` is no function of `{letter}` in closed form")
    slope = search.solver.simplify(differentiate(curve, letter))
    said, shown = flatness(name_to_text(quantity.asked.find.name), curve, letter, slope, search)
    given = search.givens[letter]
    own = letter if given.asked else f"asked{SEPARATOR}{find.name}"
    at, reason = best_place(Course(letter, Symbol(quantity.asked.letter), curve, slope), condition.word, search)
    flat = is_zero(
        shown.substitute({letter: at}), search.solver.positive
    )  # else it is at an end, where nothing needs to vanish
    equation = Equality(shown.substitute({letter: Symbol(own)}) if flat else shown, ZERO)
    question = Asked(find, Symbol(own), own, given.dimension, section=quantity.asked.section)
    answered = by_condition(search, question, at, Conclusion(said, equation, reason), quantity, aside=aside)
    search.extrema[(quantity.asked.formula, letter, condition.word)] = answered
    if given.asked:
        forget(quantity, search)  # from here on the letter has its value, and the quantity that of this place
    return answered


def flatness(name: str, curve: Formula, letter: str, slope: Formula, search: Search) -> tuple[str, Formula]:
    """What vanishes at an extremum, in words and as a formula: the derivative, of a root that of its square."""
    square = search.solver.simplify(curve**2)
    if has_root(curve, letter) and not has_root(square, letter):
        return f"d({name}²)/d{name_to_text(letter)} = 0", search.solver.simplify(differentiate(square, letter))
    return f"d{name}/d{name_to_text(letter)} = 0", slope


def function_of(search: Search, phrase: Find, letter: str) -> Answered:
    """The quantity of a phrase as a function of a letter, settled on the way where no question asks for it."""
    question = asked(phrase, search.scene, search.letters())
    known = next(
        (item for item in search.answered if question.formula in (item.asked.formula, Symbol(item.asked.letter))), None
    )
    if known is not None:
        return known
    word = BY_WORD[phrase.terms[0].path.quantity].letter if len(phrase.terms) == 1 else "Q"
    find = replace(phrase, name=fresh(word, search))
    question = asked(find, search.scene, search.letters())
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
