"""Axes: a vector or tensor in space along other axes than those that are asked, as a student names them: "in body axes"."""

from __future__ import annotations

import re

from msgspec.structs import replace

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.core.quantity import DIRECTED
from rotsolve.core.remembered import remembered
from rotsolve.grading.comparing.scalars import Close, Same
from rotsolve.grading.marking.target import SceneLetters, Target, targets_of
from rotsolve.language.problem import Find, Problem
from rotsolve.pipeline import solve_problem

NODES = "e_1"  # the first of the unit vectors of node axes
KINDS = {  # of axes, by the words for them
    "space": ("space", "space-fixed", "fixed", "inertial", "lab", "laboratory", "world"),
    "body": ("body", "body-fixed", "principal"),
    "node": ("node", "nodal"),
}
WORDS = {word: kind for kind, words in KINDS.items() for word in words}


def cut_axes(text: str, problem: Problem) -> tuple[str, str]:
    """A line without the words for its axes behind it, and these axes: space, body, node or a body's name; '' where it names none."""
    if not problem.space or not re.search(r"axes|frame", text, re.IGNORECASE):
        return text, ""
    known = {**WORDS, **{body.name.lower(): body.name for body in problem.bodies}}
    words = "|".join(sorted(map(re.escape, known), key=len, reverse=True))
    behind = re.compile(
        rf"[\s,;(]*\b(?:in|along)\s+(?:the\s+)?(?P<axes>{words})(?:'s)?[\s-]+(?:axes|frame)\b[\s).]*$", re.IGNORECASE
    )
    match = behind.search(text)
    return (text, "") if match is None else (text[: match.start()], known[match["axes"].lower()])


def vector_question(problem: Problem, name: str) -> Find | None:
    """The question for a vector or tensor, if that is all it asks for."""
    find = next((find for find in problem.finds if find.group == name), None)
    single = find is not None and len(find.terms) == 1 and find.terms[0].path.quantity in (*DIRECTED, "inertia_tensor")
    return find if problem.space and single else None


def named_axes(problem: Problem, name: str) -> str:
    """The axes along which the components of an answer are asked; '' where it has none."""
    find = vector_question(problem, name)
    if find is None:
        return ""
    return find.terms[0].axes or ("body" if find.terms[0].path.quantity == "inertia_tensor" else "space")


class OtherAxes:
    """The answers of a scene in space along other axes; solved anew when a student's answer needs them."""

    def __init__(self, problem: Problem, same: Same, close: Close) -> None:
        self.problem, self.same, self.close = problem, same, close

    @remembered
    def target(self, name: str, axes: str) -> Target | str:
        """What an answer along these axes is held against, or why nothing is known of it."""
        find = vector_question(self.problem, name)
        if find is None:
            return "it is no single vector or tensor"
        asked = replace(find, terms=(replace(find.terms[0], axes=axes),))
        try:
            solution = solve_problem(replace(self.problem, finds=(asked,))).complete()
        except (Unsolvable, SceneError) as error:
            return error.faults[0].message if isinstance(error, SceneError) else error.fault.message
        return next(targets_of(SceneLetters.of(solution), self.same, self.close))
