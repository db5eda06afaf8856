"""Conditions: `x where path = value` solves with one more equation; `largest F where touch sticks` on the point of slipping;
`smallest k where upright is stable` on the verge of stability."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.exact.solving.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Equality
from rotsolve.core.equation import Equation
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.writing import spoken
from rotsolve.inquiry.answers import NoAnswer
from rotsolve.inquiry.finds import asked
from rotsolve.inquiry.friction.sticking import limiting
from rotsolve.inquiry.history import term_of
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.inquiry.questions import Asked
from rotsolve.inquiry.questions.meaning import NotYet, label_of
from rotsolve.inquiry.swings.settling import verge
from rotsolve.inquiry.where.conclude import Conclusion, by_condition, forget
from rotsolve.inquiry.where.extremum import extreme_value, function_of, place_of_extremum
from rotsolve.language.problem import Find
from rotsolve.solver import Choice


def answer_where(inquiry: Inquiry, find: Find) -> None:
    """Answer a question that has a condition, or asks for the largest value over a letter."""
    condition = find.where
    if condition is None:
        extreme_value(inquiry, find)
    elif condition.word == "stable":
        on_the_verge(inquiry, find)
    elif condition.phrase is None:
        on_the_point_of_slipping(inquiry, find)
    elif condition.word is not None:
        place_of_extremum(inquiry, find)
    else:
        with_equation(inquiry, find)


def with_equation(inquiry: Inquiry, find: Find) -> None:
    """One more equation, quantity = value, that holds for this question."""
    condition = find.where
    assert condition is not None and condition.phrase is not None and condition.value is not None
    letter = find.formula.name if isinstance(find.formula, Symbol) else ""
    free = letter in inquiry.givens and letter not in inquiry.values and letter not in inquiry.solver.solved
    if free and letter in inquiry.known:
        over_letter(inquiry, find, letter, condition.phrase, condition.value)
        return
    question = asked(replace(find, where=None), inquiry.history, inquiry.letters())
    said = asked(condition.phrase, inquiry.history, inquiry.letters())
    limit = Equation(said.formula, condition.value, f"the condition{told(condition.phrase)}", said.section, "", 2)
    try:
        answered = inquiry.answer(question, limit)
    except NoAnswer:
        if not free:
            raise
        # all equations at once may hide the letter in a factor that two of them share; as a function of it the quantity shows
        over_letter(inquiry, find, letter, condition.phrase, condition.value)
        return
    if not any(inquiry.planner.pool[index] is limit for index in answered.used):
        raise NotYet(
            f"`{find.name}` does not depend on `{condition.phrase.text.strip()}`: it is settled without the condition",
            help="leave the condition out, or declare as `unknown` the letter that it is to settle",
        )


def over_letter(inquiry: Inquiry, find: Find, letter: str, phrase: Find, value: Formula) -> None:
    """The value of a letter at which a quantity, found first as a function of it, has a given value."""
    quantity = function_of(inquiry, phrase, letter)
    curve = quantity.found.formula
    if curve is None or letter not in curve.symbols():
        raise NotYet(f"`{phrase.text.strip()}` is no function of `{letter}` in closed form")
    given = inquiry.givens[letter]
    own = Symbol(letter if given.asked else f"asked{SEPARATOR}{find.name}")
    said = f"{name_to_text(quantity.asked.find.name)} = {to_text(value)}"
    equation = Equality(curve.substitute({letter: own}), value)
    order, positive = inquiry.solver.order, inquiry.solver.positive - {letter}
    roots = solve_polynomial(curve - value, letter, order=order, positive=positive)
    roots = roots or [item.formula for item in solve_trig(curve - value, letter, order=order, positive=positive)]
    picked = inquiry.choose_root(letter, roots) if len(roots) > 1 else Choice(0)
    if not roots or picked is None:
        raise NotYet(f"no value of `{letter}` in closed form fulfils the condition")
    root = inquiry.solver.simplify(picked.of(roots))
    question = Asked(find, own, own.name, given.dimension, section=quantity.asked.section)
    by_condition(inquiry, question, root, Conclusion(said, equation, picked.words), quantity, aside=False)
    if given.asked:
        forget(quantity, inquiry)


def told(phrase: Find) -> str:
    """What a condition is about, in words: ", horizontal impulse of pin"."""
    if len(phrase.terms) != 1:
        return ""
    term = phrase.terms[0]
    side = {"x": "horizontal ", "y": "vertical "}.get(term.path.component or "", "")
    return f", {side}{label_of(term.path, term)}"


def on_the_verge(inquiry: Inquiry, find: Find) -> None:
    """`smallest k where upright is stable`: the value at which the equilibrium is only just stable."""
    assert find.where is not None
    question = asked(without_condition(find), inquiry.history, inquiry.letters())
    swing = inquiry.history.swing(term_of(find.where))
    inquiry.answer(question, verge(swing, question.letter, modifier_of(find), inquiry))


def without_condition(find: Find) -> Find:
    """The quantity of a question alone."""
    terms = tuple(replace(term, modifier="") for term in find.terms)
    return replace(find, where=None, modifier="", terms=terms)


def modifier_of(find: Find) -> str:
    """`largest` or `smallest` in front of a question, or of its quantity."""
    return find.modifier or (find.terms[0].modifier if find.terms else "")


def on_the_point_of_slipping(inquiry: Inquiry, find: Find) -> None:
    """`largest F where touch sticks`: the value at which the contact is on the point of slipping."""
    condition, history = find.where, inquiry.history
    assert condition is not None and condition.path is not None
    if condition.word not in ("sticks", "rolls"):
        raise NotYet(f"`where {condition.path.owner} is {condition.word}` is not solved yet")
    question = asked(without_condition(find), history, inquiry.letters())
    state = find.terms[0].at if find.terms and find.terms[0].at else history.configuration.timeline.states[-1].name
    candidates = []
    for equation, normal in limiting(history, condition.path.owner, state):
        trial = Inquiry(history, inquiry.families, spare=inquiry.spare)
        try:
            value = trial.answer(question, equation).found.formula
            push = trial.value_of(next(iter(normal.symbols())))
        except NoAnswer:
            continue
        number = trial.number(value) if value is not None else None
        pressed = trial.number(push) if push is not None else None
        if number is None or (number > 0 and (pressed is None or pressed >= 0)):
            candidates.append((0.0 if number is None else number, equation))
    if not candidates:
        raise NotYet(f"`{spoken(condition.path.owner)}` does not come to the point of slipping")
    pick = max if modifier_of(find) == "largest" else min
    inquiry.answer(question, pick(candidates, key=lambda item: item[0])[1])
