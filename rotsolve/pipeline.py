"""Pipeline: the arrows in order: scene text → problem → history (facts, equations) → inquiry (plan, solve) → derivation with checks."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from rotsolve.core.equation import LAWS
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.inquiry.answering import answer_all
from rotsolve.inquiry.checks import checks, contradiction, turned_back
from rotsolve.inquiry.compose import Composer, with_missing_told
from rotsolve.inquiry.explain import contradicted, negative_inertia, said_otherwise, turns_back, unsolvable
from rotsolve.inquiry.friction import decide
from rotsolve.inquiry.history import History
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.inquiry.planning import SAID, families_for
from rotsolve.inquiry.questions import NotYet
from rotsolve.inquiry.stages import equations_text, facts_text, plan_text
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.checks.varying import check_values
from rotsolve.motion.complete import completed
from rotsolve.scene.model import Problem
from rotsolve.scene.moment import read_moment
from rotsolve.scene.read import read_file, read_text
from rotsolve.solution import Solution, Trace

MOST_DIGITS = 1000


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
    if not 1 <= digits <= MOST_DIGITS:
        raise ValueError(f"from 1 to {MOST_DIGITS} digits can be asked for, not {digits}")
    if law is not None and law not in LAWS:
        raise ValueError(f"unknown law {law!r}; one of {', '.join(LAWS)}")
    arrangement = arranged(problem)
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
    check_consistent(inquiry)
    if law is not None:
        check_law(inquiry, law)
    composer = Composer(inquiry, decision.numbered + 1, read_moment(at) if at else None)
    derivation = composer.derivation(checks(inquiry, composer.letters), decision.sections)
    derivation = with_missing_told(derivation, arrangement.problem)
    trace = Trace(
        lambda: facts_text(history),
        lambda: equations_text(inquiry, composer.letters),
        lambda: plan_text(inquiry, composer.letters),
    )
    return Solution(problem=problem, derivation=derivation, trace=trace, digits=digits)


def arranged(problem: Problem) -> Arrangement:
    """The problem with letters for what it leaves out; refused where a value in it can not be."""
    try:
        arrangement = Arrangement(completed(problem))
        check_values(arrangement)
    except Unsolvable as error:
        raise unsolvable(problem, error.fault.message, error.fault.span, error.fault.help) from None
    faults = list(negative_inertia(arrangement.problem))
    if faults:
        raise SceneError(faults, problem.lines, problem.file)
    return arrangement


def check_consistent(inquiry: Inquiry) -> None:
    """The answers must agree with everything that the laws write about the scene."""
    back = turned_back(inquiry)
    if back is not None:
        raise turns_back(back, inquiry.history.arrangement.problem)
    broken = contradiction(inquiry)
    if broken is not None:
        raise contradicted(broken, inquiry.history)


def check_law(inquiry: Inquiry, law: str) -> None:
    """A law asked for must have a part in the solution."""
    used = {inquiry.planner.pool[index].family for answered in inquiry.answered for index in answered.used}
    problem = inquiry.history.arrangement.problem
    if used - {""} and law not in used:
        others = ", ".join(SAID[name] for name in LAWS if name in used)
        raise unsolvable(
            problem, f"{SAID[law]} does not settle anything that is asked here", None, f"it takes {others}"
        )
