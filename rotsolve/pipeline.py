"""Pipeline: the arrows in order: scene text → problem → history (facts, equations) → inquiry (plan, solve) → derivation with checks."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Words
from rotsolve.core.equation import LAWS, NEWTON, Equation
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.core.varying import MIXED, POSITION
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.core.writing import spoken
from rotsolve.inquiry.answering import Inquiry, NoAnswer, families_for
from rotsolve.inquiry.answers import Answered
from rotsolve.inquiry.choices import choose
from rotsolve.inquiry.compose import Composer, in_letters
from rotsolve.inquiry.consistency import contradiction, turned_back
from rotsolve.inquiry.explain import (
    contradicted,
    negative_inertia,
    no_answer,
    plural,
    said_otherwise,
    unsolvable,
    with_missing_told,
)
from rotsolve.inquiry.finds import asked, entries
from rotsolve.inquiry.friction import decide
from rotsolve.inquiry.history import History
from rotsolve.inquiry.questions import NotYet, Unclear, resting
from rotsolve.inquiry.verify import SAID, checks
from rotsolve.inquiry.where import answer_where, over_a_letter
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.checks.varying import check_values
from rotsolve.motion.complete import completed
from rotsolve.motion.timeline import Interval
from rotsolve.plan import Shortage
from rotsolve.scene.model import Find, Problem
from rotsolve.scene.moment import read_moment
from rotsolve.scene.read import read_file, read_text
from rotsolve.solution import Solution, Trace


def solve(
    source: str | os.PathLike[str],
    *,
    law: str | None = None,
    settings: Mapping[str, str] | None = None,
    digits: int = 4,
    at: str | None = None,
) -> Solution:
    """Solve a scene: a path, or YAML text (text with a line break); functions of time are evaluated `at` a time such as "2 s".

    Raises SceneError for a scene that can't be read, Unsolvable for one without an answer.
    """
    if isinstance(source, str) and "\n" in source:
        problem = read_text(source, settings=settings or {})
    else:
        problem = read_file(Path(source), settings=settings or {})
    return solve_problem(problem, law=law, digits=digits, at=at)


def solve_problem(problem: Problem, *, law: str | None = None, digits: int = 4, at: str | None = None) -> Solution:
    """Solve a problem that has been read, by one law where `law` names it, else by the shortest way."""
    if law is not None and law not in LAWS:
        raise ValueError(f"unknown law {law!r}; one of {', '.join(LAWS)}")
    try:
        arrangement = Arrangement(completed(problem))
        check_values(arrangement)
    except Unsolvable as error:
        raise unsolvable(problem, error.fault.message, error.fault.span, error.fault.help) from None
    faults = list(negative_inertia(arrangement.problem))
    if faults:
        raise SceneError(faults, problem.lines, problem.file)
    try:
        decision = decide(arrangement)
        for clash in said_otherwise(arrangement, decision.modes):
            raise clash
        history = History(arrangement, decision.modes)
        inquiry = Inquiry(history, families_for(law), spare=law is not None)
    except NotYet as error:
        raise unsolvable(problem, str(error), error.span, error.help) from None
    answer_all(inquiry, arrangement.problem.finds)
    if at is not None and not arrangement.mentions.functions:
        raise unsolvable(problem, "nothing that is asked is a function of time", None, "ask for it `at any time`")
    back = turned_back(inquiry)
    if back is not None:
        raise turns_back(back, problem)
    broken = contradiction(inquiry)
    if broken is not None:
        raise contradicted(broken, history)
    if law is not None:
        check_law(inquiry, law)
    composer = Composer(inquiry, decision.numbered + 1, read_moment(at) if at else None)
    derivation = with_missing_told(
        composer.derivation(checks(inquiry, composer), decision.sections), arrangement.problem
    )
    trace = Trace(
        lambda: facts_text(history), lambda: equations_text(inquiry, composer), lambda: plan_text(inquiry, composer)
    )
    return Solution(problem=problem, derivation=derivation, trace=trace, digits=digits)


def turns_back(interval: Interval, problem: Problem) -> Unsolvable:
    """The time of a motion that comes back on its way, which is told for one way only."""
    span = next((state.span for state in problem.states if state.name == interval.end), None)
    message = f"the motion turns back from `{interval.start}` to `{interval.end}`: its time is not solved as a whole"
    return unsolvable(problem, message, span, "name the turning point as a state, such as `{block.velocity: 0}`")


def check_law(inquiry: Inquiry, law: str) -> None:
    """A law asked for must have a part in the solution."""
    used = {inquiry.planner.pool[index].family for answered in inquiry.answered for index in answered.used}
    problem = inquiry.history.arrangement.problem
    if used - {""} and law not in used:
        others = ", ".join(SAID[name] for name in LAWS if name in used)
        raise unsolvable(
            problem, f"{SAID[law]} does not settle anything that is asked here", None, f"it takes {others}"
        )


def answer_all(inquiry: Inquiry, finds: Sequence[Find]) -> None:
    """Answer all questions; one that has to wait for another (an asked letter that a later line settles) is tried again."""
    pending = list(finds)
    while pending:
        waiting: list[tuple[Find, Unsolvable]] = []
        for find in pending:
            try:
                answer(inquiry, find)
            except Unsolvable as error:
                waiting.append((find, error))
        if len(waiting) == len(pending):
            raise waiting[0][1]
        pending = [find for find, _ in waiting]


def answer(inquiry: Inquiry, find: Find) -> None:
    """Answer one question, entry by entry where it asks for a matrix or vector."""
    for part in entries(find, inquiry.history):
        if part.name not in inquiry.letters():
            answer_one(inquiry, part)


def answer_one(inquiry: Inquiry, find: Find) -> None:
    """Answer one question for a single quantity, or say why there is no answer."""
    problem = inquiry.history.arrangement.problem
    try:
        if find.choice is not None:
            inquiry.chosen.append(choose(find, find.choice, inquiry, lambda side: by_law(inquiry, side, find.name)))
        elif find.where is not None or over_a_letter(find, inquiry):
            answer_where(inquiry, find)
        else:
            by_law(inquiry, find)
    except (NotYet, Unclear) as error:
        raise unsolvable(problem, str(error), error.span or find.span, error.help) from None
    except NoAnswer as error:
        if error.shortage is not None:
            refuse_unsolved(inquiry, error.shortage, find)
        raise no_answer(error, inquiry, find) from None


def refuse_unsolved(inquiry: Inquiry, shortage: Shortage, find: Find) -> None:
    """Refuse by name what is no lack of data: motion that varies with several things, the time of one that varies with the place."""
    problem = inquiry.history.arrangement.problem
    travels = [travel for passage in inquiry.history.passages.values() for travel in passage.travels]
    several = next((travel.body for travel in travels if travel.pace == MIXED), "")
    if several:
        message = f"`{several}` is driven by what varies with more than one of time, place and speed: not solved yet"
        raise unsolvable(problem, message, find.span)
    quantities = inquiry.history.registry.quantities
    open_ = {quantities[name].kind for name in shortage.unknowns if name in quantities}
    driven = next((travel.body for travel in travels if travel.pace == POSITION and not travel.leads), "")
    if driven and open_ == {"time"}:
        message = f"how long `{driven}` takes is not solved yet, since what drives it varies with its place"
        help = "say what drives it as a `couple` or `force` that speaks of the place, or ask for a `period`"
        raise unsolvable(problem, message, find.span, help)


def by_law(inquiry: Inquiry, find: Find, whole: str = "") -> Answered:
    """Answer by the inquiry's laws; where a law asked for does not reach (no energy tells a tension), Newton's laws help out.

    `whole` names the choice to which the question belongs.
    """
    question = asked(find, inquiry.history, inquiry.letters(), inquiry.beside())
    question = replace(question, whole=whole)
    if question.moving.parts and stands(question.moving, inquiry):
        raise NotYet(resting(find.terms[0].path))
    try:
        return inquiry.answer(question)
    except NoAnswer as error:
        if NEWTON in inquiry.families:
            raise
        laws = inquiry.families
        inquiry.families = (*laws, NEWTON)
        try:
            answered = inquiry.answer(question)
        except NoAnswer:
            raise error from None
        finally:
            inquiry.families = laws
        name = whole or find.name
        inquiry.helped += [name] if name not in inquiry.helped else []
        return answered


def stands(velocity: Vector, inquiry: Inquiry) -> bool:
    """Whether a velocity turns out to be nothing."""
    aside = Inquiry(inquiry.history, families_for(None))
    parts = [aside.settled(velocity.along(axis)) for axis in (RIGHT, UP)]
    return all(part is not None and is_zero(part, inquiry.solver.positive) for part in parts)


def facts_text(history: History) -> str:
    """All facts, state by state: bodies with their forces, rules, requirements."""
    lines = []
    registry = history.registry
    for state in history.arrangement.timeline.states:
        history.facts(state.name)
    taken = frozenset(given.name for given in history.arrangement.problem.givens)
    letters = {key: Symbol(name) for key, name in registry.letters(registry.quantities, taken, {}).items()}
    for state in history.arrangement.timeline.states:
        facts = history.facts(state.name)
        lines.append(f"at {spoken(state.name)}" if state.name else "facts")
        for body in facts.bodies:
            lines.append(f"  {spoken(body.name)}: {body.motion.kind}; positive: {body.positive or 'none'}")
            lines += [f"    {words_to_text(item.words, letters)}" for item in body.acting]
        for rule in facts.rules:
            left, right = (to_text(side.substitute(letters)) for side in rule.acceleration or rule.velocity)
            lines.append(f"  {rule.label}: {left} = {right}")
    return "\n".join(lines)


def words_to_text(words: Words, letters: Mapping[str, Formula]) -> str:
    return "".join(to_text(part.substitute(letters)) if isinstance(part, Formula) else part for part in words)


def equations_text(inquiry: Inquiry, composer: Composer) -> str:
    """All equations written, one a line, those that the plan used marked."""
    used = {index for answered in inquiry.answered for index in answered.used}
    names = all_names(inquiry, composer)
    lines = []
    for index, equation in enumerate(inquiry.history.equations):
        mark = "*" if index in used else " "
        place = f"[{spoken(equation.section)}] " if equation.section else ""
        lines.append(f"{mark} {place}{equation.label}: {in_text(equation, names)}")
    return "\n".join(lines)


def plan_text(inquiry: Inquiry, composer: Composer) -> str:
    """For each question the equations that settle it."""
    names = all_names(inquiry, composer)
    lines = []
    for answered in inquiry.answered:
        name = names.get(answered.asked.letter, answered.asked.find.name)
        lines.append(f"{name}: {plural(len(answered.used), 'equation')}")
        for index in answered.used:
            equation = inquiry.planner.pool[index]
            lines.append(f"  {equation.label or 'found before'}: {in_text(equation, names)}")
    return "\n".join(lines)


def all_names(inquiry: Inquiry, composer: Composer) -> dict[str, str]:
    """Printed names of all quantities, in the derivation's letters where it has one."""
    registry = inquiry.history.registry
    taken = frozenset(inquiry.givens) - set(composer.names.values())
    return registry.letters(registry.quantities, taken, composer.names)


def in_text(equation: Equation, names: Mapping[str, str]) -> str:
    left, right = (to_text(in_letters(side, names)) for side in (equation.left, equation.right))
    return f"{left} = {right}"
