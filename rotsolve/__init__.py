"""rotsolve: solves textbook rotational mechanics, exactly and with its derivation.

>>> import rotsolve
>>> solution = rotsolve.solve("problems/pulleys/block-on-disc.yaml")  # a path, the text of a scene, or a dict
>>> solution["a"].exact, float(solution["a"])
('2 m g/(2 m + M)', 4.355555555555555)
>>> print(solution)  # the whole derivation, as the command `rotsolve solve` prints it

docs/python.md describes all of it. Everything is imported when it is first used: `import rotsolve` alone costs next to nothing.
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False  # by its name a type checker takes it for true; `typing` alone takes 2 ms to load
if TYPE_CHECKING:
    from typing import Any

    from rotsolve.arrays import ManyAnswers, NotForMany
    from rotsolve.core.faults import (
        Contradicted,
        Fault,
        MissingPackage,
        NeverReached,
        RotsolveError,
        SceneError,
        Span,
        Unsolvable,
    )
    from rotsolve.grading.course.checked import CheckedPaper, VerdictView
    from rotsolve.grading.course.checked import check_answers as check
    from rotsolve.grading.course.examiner import NotMarked
    from rotsolve.grading.course.handed_in import HandedInError
    from rotsolve.language.problem import Problem
    from rotsolve.pipeline import solve
    from rotsolve.scene.read import read_source as read
    from rotsolve.simulation import Run, simulate
    from rotsolve.solution import Solution
    from rotsolve.solution.answer import AnswerView

__version__ = "0.1.0"

_HOMES = {  # the modules that define public names, which are their own there, or other ones
    "rotsolve.arrays": {"ManyAnswers": "", "NotForMany": ""},
    "rotsolve.core.faults": dict.fromkeys(
        (
            "Contradicted",
            "Fault",
            "MissingPackage",
            "NeverReached",
            "RotsolveError",
            "SceneError",
            "Span",
            "Unsolvable",
        ),
        "",
    ),
    "rotsolve.grading.course.checked": {"CheckedPaper": "", "VerdictView": "", "check": "check_answers"},
    "rotsolve.grading.course.examiner": {"NotMarked": ""},
    "rotsolve.grading.course.handed_in": {"HandedInError": ""},
    "rotsolve.language.problem": {"Problem": ""},
    "rotsolve.pipeline": {"solve": ""},
    "rotsolve.scene.read": {"read": "read_source"},
    "rotsolve.simulation": {"Run": "", "simulate": ""},
    "rotsolve.solution": {"Solution": ""},
    "rotsolve.solution.answer": {"AnswerView": ""},
}
__all__ = [
    "AnswerView",
    "CheckedPaper",
    "Contradicted",
    "Fault",
    "HandedInError",
    "ManyAnswers",
    "MissingPackage",
    "NeverReached",
    "NotForMany",
    "NotMarked",
    "Problem",
    "RotsolveError",
    "Run",
    "SceneError",
    "Solution",
    "Span",
    "Unsolvable",
    "VerdictView",
    "__version__",
    "check",
    "read",
    "simulate",
    "solve",
]


def __getattr__(name: str) -> Any:
    """Import a public name from its home on first use."""
    for module, names in _HOMES.items():
        if name in names:
            value = getattr(import_module(module), names[name] or name)
            globals()[name] = value
            return value
    raise AttributeError(f"module 'rotsolve' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
