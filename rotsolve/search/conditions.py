"""Conditions: `x where path = value`, `largest F where touch sticks`, `smallest k where upright is stable`: one equation more."""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig, solve_under_root
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Equality
from rotsolve.core.equation import CONDITION, POINT_OF_SLIPPING, Equation
from rotsolve.core.symbols import asked_symbol
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import term_of
from rotsolve.language.problem import Find
from rotsolve.paths.meaning import NotYet, label_of
from rotsolve.questions.find import Asked, question_for
from rotsolve.search.answers import Answered, NoAnswer
from rotsolve.search.extrema import (
    Conclusion,
    add_step,
    as_function_of,
    by_condition,
    extreme_value,
    forget,
    place_of_extremum,
    remember_answer,
)
from rotsolve.search.friction import limiting
from rotsolve.search.search import Search
from rotsolve.search.swings import verge_equation
from rotsolve.solver.steps import Found, PickedRoot


def answer_where(search: Search, find: Find) -> None:
    """Answer a question that has a condition, or asks for the largest value over a letter."""
    condition = find.where
    if condition is None:
        extreme_value(search, find)
    elif condition.word == "stable":
        on_the_verge(search, find)
    elif condition.phrase is None:
        on_the_point_of_slipping(search, find)
    elif condition.word is not None:
        place_of_extremum(search, find)
    else:
        with_equation(search, find)


def with_equation(search: Search, find: Find) -> None:
    """One more equation, quantity = value, that holds for this question."""
    condition = find.where
    assert condition is not None and condition.phrase is not None and condition.value is not None
    letter = find.formula.name if isinstance(find.formula, Symbol) else ""
    free = letter in search.givens and letter not in search.values and letter not in search.solver.solved
    if free and letter in search.known:
        over_letter(search, find, letter, condition.phrase, condition.value)
        return
    question = question_for(replace(find, where=None), search.scene, search.letters())
    said = question_for(condition.phrase, search.scene, search.letters())
    limit = CONDITION.equation(said.formula, condition.value, said.section, words=condition_label(condition.phrase))
    try:
        answered = search.answer(question, limit)
    except NoAnswer:
        if not free:
            raise
        # all equations at once may hide the letter in a factor that two of them share; as a function of it the quantity shows
        over_letter(search, find, letter, condition.phrase, condition.value)
        return
    if not any(search.planner.pool[index] is limit for index in answered.used):
        search.take_back(answered)
        raise NotYet(
            f"`{find.name}` does not depend on `{condition.phrase.text.strip()}`: it is settled without the condition",
            help="leave the condition out"
            + ("" if free else ", or declare as `unknown` the letter that it is to settle"),
        )


def over_letter(search: Search, find: Find, letter: str, phrase: Find, value: Formula) -> None:
    """The value of a letter at which a quantity, found first as a function of it, has a given value."""
    quantity, curve = as_function_of(search, phrase, letter)
    given = search.givens[letter]
    own = Symbol(letter if given.asked else asked_symbol(find.name))
    said = f"{name_to_text(quantity.asked.find.name)} = {to_text(value)}"
    equation = Equality(curve.substitute({letter: own}), value)
    order, positive = search.solver.order, search.solver.positive - {letter}
    roots = solve_polynomial(curve - value, letter, order=order, positive=positive)
    roots = roots or solve_trig(curve - value, letter, order=order, positive=positive)
    squared = [] if roots else solve_under_root(curve - value, letter, order=order, positive=search.solver.positive)
    roots = roots or [
        root for root in squared if search.signs.decide(curve.substitute({letter: root}) - value) in (0, None)
    ]
    picked = search.choose_root(letter, roots) if len(roots) > 1 else PickedRoot(0)
    if not roots or picked is None:
        raise NotYet(f"no value of `{letter}` in closed form fulfils the condition")
    root = search.solver.simplify(picked.of(roots))
    question = Asked(find, own, own.name, given.dimension, section=quantity.asked.section)
    by_condition(search, question, root, Conclusion(said, equation, picked.words), quantity, aside=False)
    if given.asked:
        forget(quantity, search)


def condition_label(phrase: Find) -> str:
    """What a condition is about, in words: ", horizontal impulse of pin"."""
    if len(phrase.terms) != 1:
        return ""
    term = phrase.terms[0]
    side = {"x": "horizontal ", "y": "vertical "}.get(term.path.component or "", "")
    return f", {side}{label_of(term.path, term)}"


def on_the_verge(search: Search, find: Find) -> None:
    """`smallest k where upright is stable`: the value at which the equilibrium is only just stable."""
    assert find.where is not None
    question = question_for(without_condition(find), search.scene, search.letters())
    swing = search.scene.swing(term_of(find.where))
    search.answer(question, verge_equation(swing, question.letter, modifier_of(find), search))


def without_condition(find: Find) -> Find:
    """The quantity of a question alone."""
    terms = tuple(replace(term, modifier="") for term in find.terms)
    return replace(find, where=None, modifier="", terms=terms)


def modifier_of(find: Find) -> str:
    """`largest` or `smallest` in front of a question, or of its quantity."""
    return find.modifier or (find.terms[0].modifier if find.terms else "")


def on_the_point_of_slipping(search: Search, find: Find) -> None:
    """`largest F where touch sticks`: the value at which the contact is on the point of slipping, beyond which it slips."""
    condition, scene = find.where, search.scene
    assert condition is not None and condition.path is not None
    contact, word = condition.path.owner, modifier_of(find)
    if condition.word not in ("sticks", "rolls"):
        raise NotYet(f"`where {contact} is {condition.word}` is not solved yet")
    question = question_for(without_condition(find), scene, search.letters())
    state = find.terms[0].at if find.terms and find.terms[0].at else scene.configuration.timeline.states[-1].name
    verges = [verge for limit in limiting(scene, contact, state) if (verge := verge_at(search, question, *limit))]
    if not verges:
        raise NotYet(f"`{spoken(contact)}` does not come to the point of slipping")
    ends = [verge for verge in verges if verge.side in (0, 1 if word == "largest" else -1)]
    if not ends:
        bound = "large" if word == "largest" else "small"
        quantity = find.text.split(" where ")[0].removeprefix(word).strip()
        raise NotYet(f"`{contact}` sticks however {bound} `{quantity}` is")
    verge = ends[0]
    for other in ends[1:]:
        ahead = search.numbers.side(other.value - verge.value)
        verge = other if ahead == (1 if word == "largest" else -1) else verge
    if question.letter not in search.solver.solved:
        search.answer(question, verge.limit)
        return
    own = asked_symbol(find.name)  # the letter has the value of another verge
    question = replace(question, letter=own, formula=Symbol(own))
    sides = verge.limit
    chain = (Equality(sides.left, sides.right), Equality(Symbol(own), verge.value))
    steps = add_step(search, question, ("words", POINT_OF_SLIPPING.name), (), chain, ())
    remember_answer(search, Answered(question, Found(own, verge.value), (), steps))


class Verge(Struct, frozen=True):
    """A value at which a contact is on the point of slipping one way; `side` is +1 where it slips beyond it, −1 below it, 0 where
    nothing tells."""

    value: Formula
    limit: Equation
    side: int


def verge_at(search: Search, question: Asked, limit: Equation, normal: Formula) -> Verge | None:
    """The value at which friction has its limit in one direction; None where there is none, or the surface would have to pull."""
    trial = search.another(search.families, spare=search.spare)
    try:
        value = trial.answer(question, limit).found.formula
        push = trial.value_of(next(iter(normal.symbols())))
    except NoAnswer:
        return None
    pressed = trial.numbers.side(push) if push is not None else None
    if value is None or pressed == -1 or trial.numbers.side(value) in (0, -1):
        return None
    return Verge(value, limit, slipping_side(search, question, limit, value))


def slipping_side(search: Search, question: Asked, limit: Equation, value: Formula) -> int:
    """On which side of a verge |f| > μ N, by the rate at which μ N − |f| grows with the quantity there; 0 where nothing tells."""
    other = search.another(search.families, spare=search.spare)
    letter = question.letter
    try:
        other.planned(question, set())
        other.known.add(letter)
        friction, most = other.settled(limit.left), other.settled(limit.right)
    except NoAnswer:
        return 0
    if friction is None or most is None:
        return 0
    # f = ±μ N at the verge: friction is left where ±μ N ± f grows
    room = differentiate(most - friction, letter).substitute({letter: value})
    way, grows = (search.numbers.side(side.substitute({letter: value})) for side in (most, room))
    return -(grows or 0) * (way or 0)
