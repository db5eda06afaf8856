"""Conditions: `x where path = value`, `largest F where touch sticks`, `smallest k where upright is stable`: one equation more."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.equation import CONDITION, Equation
from rotsolve.core.symbols import asked_symbol
from rotsolve.core.writing import in_direction
from rotsolve.equations.scene_equations import term_of
from rotsolve.language.problem import EXTREMES, Find
from rotsolve.paths.meaning import NotYet, label_of
from rotsolve.questions.find import question_for
from rotsolve.search.answers import Answered, NoAnswer
from rotsolve.search.extrema import extreme_value, place_of_extremum, seekers
from rotsolve.search.over_letter import over_letter
from rotsolve.search.search import Search
from rotsolve.search.stability import verge_equation
from rotsolve.search.verges import modifier_of, on_the_point_of_slipping, without_condition


def answer_where(search: Search, find: Find) -> None:
    """Answer a question that has a condition, or asks for the largest value over a letter."""
    condition = find.where
    if condition is None:
        extreme_value(search, find)
    elif condition.phrase is None:
        check_not_given(find, search)
        if search.scene.configuration.problem.space:
            on_the_verge_in_space(search, find)
        else:
            (on_the_verge if condition.word == "stable" else on_the_point_of_slipping)(search, find)
    elif condition.word is not None:
        place_of_extremum(search, find)
    else:
        with_equation(search, find)


def check_not_given(find: Find, search: Search) -> None:
    """Refuse the verge of a letter that the scene gives, which is the same for all questions."""
    letter = find.formula.name if isinstance(find.formula, Symbol) and not find.terms else ""
    given = search.givens.get(letter)
    if given is not None and not given.asked:
        raise NotYet(
            f"`{letter}` is given, so that no {modifier_of(find)} value of it is looked for",
            help=f"ask for it in a scene that says `{letter}: unknown` under `given`",
        )


def with_equation(search: Search, find: Find) -> None:
    """One more equation, quantity = value, that holds for this question."""
    condition = find.where
    assert condition is not None and condition.phrase is not None and condition.value is not None
    letter = find.formula.name if isinstance(find.formula, Symbol) else ""
    free = letter in search.givens and letter not in search.values and letter not in search.solver.solved
    several = free and bool(seekers(search, find, letter))
    if free and (
        letter in search.known or ((several or find.modifier in EXTREMES) and has_values(search, find, letter))
    ):
        over_letter(search, find, letter, condition.phrase, condition.value)
        return
    question = question_for(replace(find, where=None), search.scene, search.letters())
    limit = condition_equation(search, condition.phrase, condition.value)
    search.seeking, search.solver.once_round = find, letter if search.may_be_angle(letter) else ""
    retired = set(search.retired)
    try:
        answered = search.answer(question, limit)
    except NoAnswer:
        if not free:
            raise
        # all equations at once may hide the letter in a factor that two of them share; as a function of it the quantity shows
        if several:
            message = f"`{find.name}` is not solved beside the other questions that seek `{letter}`"
            raise NotYet(message, help="ask for it in a scene of its own") from None
        over_letter(search, find, letter, condition.phrase, condition.value)
        return
    finally:
        search.seeking, search.solver.once_round = None, ""
    help = "leave the condition out" + ("" if free else ", or declare as `unknown` the letter that it is to settle")
    refuse_settled(search, answered, limit, condition.phrase.text.strip(), help)
    if letter in search.givens and seekers(search, find, letter):
        search.retired = retired
        set_free(search, answered, letter, limit)


def refuse_settled(search: Search, answered: Answered, limit: Equation, said: str, help: str) -> None:
    """Refuse an answer for which the equation of its condition was not needed, nor for a letter that was worked out before it: it is
    settled without it, and need not fulfil it."""
    used = {index for item in search.answered if item is answered or item.aside for index in item.used}
    if not any(search.planner.pool[index] is limit for index in used):
        search.take_back(answered)
        name = answered.find.name
        raise NotYet(f"`{name}` does not depend on `{said}`: it is settled without the condition", help=help)


def condition_equation(search: Search, phrase: Find, value: Formula) -> Equation:
    """quantity = value."""
    said, in_space = question_for(phrase, search.scene, search.letters()), search.scene.configuration.problem.space
    search.enter_laws(said)
    return CONDITION.equation(said.formula, value, said.section, words=condition_label(phrase, in_space))


def set_free(search: Search, answered: Answered, letter: str, limit: Equation) -> None:
    """Let the next question seek an unknown letter anew: each has an equation of its own, and its answer a symbol of its own."""
    find = answered.find
    own = asked_symbol(find.name)
    search.separate.add(find.name)
    search.solver.solved[own] = search.solver.solved.pop(letter)
    search.rivals[own] = search.rivals.pop(letter, ())
    search.known.discard(letter)
    search.known.add(own)
    if find.name != letter:  # what it is called would else stand for the answer
        search.answered.remove(answered)
        search.answered.append(replace(answered, asked=replace(answered.asked, letter=own)))
    search.retired |= {index for index, item in enumerate(search.planner.pool) if item is limit}


def has_values(search: Search, find: Find, letter: str) -> bool:
    """Whether all values of a letter are found at which a quantity, as a function of it, has the value told, of which one is an end.

    An equation more may fix the sign of a square on the way to the letter, and with that one of its values.
    """
    assert find.where is not None and find.where.phrase is not None and find.where.value is not None
    try:
        over_letter(search.another(search.families), find, letter, find.where.phrase, find.where.value, closed=True)
    except (NotYet, NoAnswer):
        return False
    return True


def condition_label(phrase: Find, in_space: bool) -> str:
    """What a condition is about, in words: ", horizontal impulse of pin"."""
    if len(phrase.terms) != 1:
        return ""
    term = phrase.terms[0]
    return f", {in_direction(label_of(term.path, term), term.path.component or '', in_space)}"


def on_the_verge(search: Search, find: Find) -> None:
    """`smallest k where upright is stable`: the value at which the equilibrium is only just stable."""
    assert find.where is not None
    question = question_for(without_condition(find), search.scene, search.letters())
    swing = search.scene.swing(term_of(find.where))
    search.answer(question, verge_equation(swing, question.letter, modifier_of(find), search))


def on_the_verge_in_space(search: Search, find: Find) -> None:
    """`smallest w where upright is stable`, `… is steady`: the value at which the motion of a state is only just so, or possible."""
    condition = find.where
    assert condition is not None and condition.path is not None
    limit = search.scene.verge(condition)  # type: ignore[attr-defined]
    question = question_for(without_condition(find), search.scene, search.letters())
    answered = search.answer(question, limit)
    said = f"{condition.owner} is {condition.word}"
    refuse_settled(search, answered, limit, said, "leave the condition out, or tell less of that state")
    found, letter = answered.found.formula, question.letter
    if found is None:
        return
    beside = f"{letter} beside"  # since the letter itself has been found now
    gap = search.solver.with_found((limit.left - limit.right).substitute({letter: Symbol(beside)}))
    slope = search.signs.decide(search.solver.with_found(differentiate(gap, beside).substitute({beside: found})))
    side = {1: "smallest", -1: "largest"}.get(slope or 0, "")
    if side and side != modifier_of(find):
        search.take_back(answered)
        raise NotYet(f"{condition.owner} is {condition.word} beyond a value", help=f"ask for the `{side}` one")
