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
from rotsolve.inquiry.answers import Answered
from rotsolve.inquiry.finds import asked
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.inquiry.questions import Asked
from rotsolve.inquiry.questions.meaning import NotYet
from rotsolve.inquiry.where.conclude import Conclusion, by_answers, by_condition, forget
from rotsolve.inquiry.where.places import Course, best_place
from rotsolve.language.problem import Condition, Find, points_of
from rotsolve.solver import Found


def over_a_letter(find: Find, inquiry: Inquiry) -> bool:
    """Whether a question is for the largest or smallest value of a quantity at a place that has no value."""
    return bool(find.extreme) and bool(free_letters(find, inquiry))


def free_letters(find: Find, inquiry: Inquiry) -> list[str]:
    """Letters without a value that say at which place of a rod a quantity is asked, or on which an earlier answer depends."""
    formulas = [point.argument for point in points_of(find.terms) if point.argument is not None]
    earlier = next((item for item in inquiry.answered if Symbol(item.asked.find.name) == find.formula), None)
    if earlier is not None:
        sought = [letter for formula, letter, _ in inquiry.extrema if formula == earlier.asked.formula]
        formulas += [Symbol(letter) for letter in sought] or [earlier.found.formula or ZERO]
    names = {name for formula in formulas for name in formula.symbols()}
    return sorted(name for name in names if name in inquiry.givens and name not in inquiry.values)


def extreme_value(inquiry: Inquiry, find: Find) -> None:
    """`largest Q` over the one free letter of Q: its value at the place of the extremum."""
    letters, word = free_letters(find, inquiry), find.extreme
    if len(letters) != 1:
        raise NotYet(f"`{find.text.strip()}` is open over several letters: {', '.join(letters)}")
    terms = tuple(replace(term, modifier="") for term in find.terms)
    phrase = replace(find, modifier="", terms=terms)
    if letters[0] in inquiry.solver.solved:
        at_settled_place(inquiry, phrase, letters[0], word)
        return
    quantity = function_of(inquiry, phrase, letters[0])
    place = inquiry.extrema.get((quantity.asked.formula, letters[0], word))
    if place is None:
        name = fresh(f"{letters[0]}_{'max' if word == 'largest' else 'min'}", inquiry)
        condition = Condition(None, word=word, span=find.span, phrase=phrase)
        own = Find(name, Symbol(letters[0]), (), where=condition, text=letters[0], span=find.span)
        place = place_of_extremum(inquiry, own, aside=True)
    at, curve = place.found.formula, quantity.found.formula
    assert at is not None and curve is not None
    letter = Symbol(f"asked{SEPARATOR}{find.name}")
    value = inquiry.solver.simplify(curve.substitute({letters[0]: at}))
    question = Asked(find, letter, letter.name, quantity.asked.dimension, section=quantity.asked.section)
    line = (Equality(letter, curve.substitute({letters[0]: at})), Equality(letter, value))
    by_answers(inquiry, question, Found(letter.name, value), line, (quantity, place))


def at_settled_place(inquiry: Inquiry, phrase: Find, letter: str, word: str) -> None:
    """The extreme value once the letter has the value that makes it so."""
    question = asked(phrase, inquiry.history, inquiry.letters())
    if (question.formula, letter, word) not in inquiry.extrema:
        raise NotYet(f"`{letter}` has been settled by another condition: this quantity has one value only")
    inquiry.answer(question)


def place_of_extremum(inquiry: Inquiry, find: Find, *, aside: bool = False) -> Answered:
    """`x where Q is largest`: where dQ/dx = 0 or at an end, whichever gives most."""
    condition = find.where
    assert condition is not None and condition.phrase is not None and condition.word is not None
    letter = find.formula.name if isinstance(find.formula, Symbol) else ""
    if letter not in inquiry.givens or letter in inquiry.values:
        raise NotYet(
            "an extremum is over a letter of the scene that has no value",
            help="write `x where Q is largest`, with `x: unknown` or `x: m` under `given`",
        )
    quantity = function_of(inquiry, condition.phrase, letter)
    curve = quantity.found.formula
    if curve is None or letter not in curve.symbols():
        raise NotYet(f"`{condition.phrase.text.strip()}` is no function of `{letter}` in closed form")
    slope = inquiry.solver.simplify(differentiate(curve, letter))
    said, shown = flatness(name_to_text(quantity.asked.find.name), curve, letter, slope, inquiry)
    given = inquiry.givens[letter]
    own = letter if given.asked else f"asked{SEPARATOR}{find.name}"
    at, reason = best_place(Course(letter, Symbol(quantity.asked.letter), curve, slope), condition.word, inquiry)
    flat = is_zero(
        shown.substitute({letter: at}), inquiry.solver.positive
    )  # else it is at an end, where nothing needs to vanish
    equation = Equality(shown.substitute({letter: Symbol(own)}) if flat else shown, ZERO)
    question = Asked(find, Symbol(own), own, given.dimension, section=quantity.asked.section)
    answered = by_condition(inquiry, question, at, Conclusion(said, equation, reason), quantity, aside=aside)
    inquiry.extrema[(quantity.asked.formula, letter, condition.word)] = answered
    if given.asked:
        forget(quantity, inquiry)  # from here on the letter has its value, and the quantity that of this place
    return answered


def flatness(name: str, curve: Formula, letter: str, slope: Formula, inquiry: Inquiry) -> tuple[str, Formula]:
    """What vanishes at an extremum, in words and as a formula: the derivative, of a root that of its square."""
    square = inquiry.solver.simplify(curve**2)
    if has_root(curve, letter) and not has_root(square, letter):
        return f"d({name}²)/d{name_to_text(letter)} = 0", inquiry.solver.simplify(differentiate(square, letter))
    return f"d{name}/d{name_to_text(letter)} = 0", slope


def function_of(inquiry: Inquiry, phrase: Find, letter: str) -> Answered:
    """The quantity of a phrase as a function of a letter, settled on the way where no question asks for it."""
    question = asked(phrase, inquiry.history, inquiry.letters())
    known = next(
        (item for item in inquiry.answered if question.formula in (item.asked.formula, Symbol(item.asked.letter))), None
    )
    if known is not None:
        return known
    word = BY_WORD[phrase.terms[0].path.quantity].letter if len(phrase.terms) == 1 else "Q"
    find = replace(phrase, name=fresh(word, inquiry))
    question = asked(find, inquiry.history, inquiry.letters())
    settled = letter in inquiry.known
    inquiry.known.add(letter)
    try:
        return inquiry.answer(question, aside=True)
    finally:
        if not settled:
            inquiry.known.discard(letter)


def fresh(name: str, inquiry: Inquiry) -> str:
    """A name that neither a given nor a question has."""
    problem = inquiry.history.configuration.problem
    taken = {*inquiry.givens, *(find.name for find in problem.finds)}
    taken |= {item.asked.find.name for item in inquiry.answered}
    return next(word for word in (name, *(f"{name}_{number}" for number in range(1, 100))) if word not in taken)
