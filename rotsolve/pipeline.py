"""Pipeline: the arrows in order: scene text → problem → history (facts, equations) → session (plan, solve) → derivation with checks."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from rotsolve.algebra.text import to_text
from rotsolve.answering import NoAnswer, Session, families_for
from rotsolve.compose import Composer
from rotsolve.core.equation import LAWS
from rotsolve.core.faults import Unsolvable
from rotsolve.friction import decide
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.complete import completed
from rotsolve.motion.finds import Unclear, asked
from rotsolve.motion.history import History
from rotsolve.motion.questions import NotYet
from rotsolve.scene.model import Find, Problem
from rotsolve.scene.read import read_file, read_text
from rotsolve.solution import Solution, Trace
from rotsolve.verify import checks


def solve(source: str | os.PathLike[str], *, law: str | None = None, settings: Mapping[str, str] | None = None, digits: int = 4) -> Solution:
    """Solve a scene: a path, or YAML text (text with a line break).

    Raises SceneError for a scene that can't be read, Unsolvable for one without an answer.
    """
    if isinstance(source, str) and "\n" in source:
        problem = read_text(source, settings=settings or {})
    else:
        problem = read_file(Path(source), settings=settings or {})
    return solve_problem(problem, law=law, digits=digits)


def solve_problem(problem: Problem, *, law: str | None = None, digits: int = 4) -> Solution:
    """Solve a problem that has been read, by one law where `law` names it, else by the shortest way."""
    if law is not None and law not in LAWS:
        raise ValueError(f"unknown law {law!r}; one of {', '.join(LAWS)}")
    whole = completed(problem)
    arrangement = Arrangement(whole)
    decision = decide(arrangement)
    history = History(arrangement, decision.modes)
    session = Session(history, families_for(law), spare=law is not None)
    for find in whole.finds:
        answer(session, find)
    composer = Composer(session, decision.numbered + 1)
    derivation = composer.derivation(checks(session, composer), decision.sections)
    trace = Trace(lambda: "", lambda: equations_text(history), lambda: "")
    return Solution(problem=problem, derivation=derivation, trace=trace, digits=digits)


def answer(session: Session, find: Find) -> None:
    """Answer one question, or say why there is no answer."""
    problem = session.history.arrangement.problem
    try:
        session.answer(asked(find, session.history))
    except (NotYet, Unclear) as error:
        raise Unsolvable(str(error), span=find.span, lines=problem.lines, file=problem.file) from None
    except NoAnswer as error:
        raise Unsolvable(explained(error, session), span=find.span, lines=problem.lines, file=problem.file) from None


def explained(error: NoAnswer, session: Session) -> str:
    """What is missing, in the scene's words."""
    if error.shortage is None:
        return str(error)
    open_ = [name for name in error.shortage.unknowns]
    return f"{error}: {len(error.shortage.equations)} equations for {len(open_)} unknowns ({', '.join(open_)})"


def equations_text(history: History) -> str:
    """All equations written, one a line."""
    return "\n".join(f"{item.label}: {to_text(item.left)} = {to_text(item.right)}" for item in history.equations)
