"""Frames: answers as a table of pandas, which is imported here alone."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rotsolve.core.faults import missing_package
from rotsolve.solution.answer import AnswerView

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rotsolve.solution import Solution

COLUMNS = ("value", "unit", "exact", "direction", "conditions")


def pandas() -> Any:
    """The package, or what to install."""
    try:
        import pandas
    except ModuleNotFoundError:
        raise missing_package("tables take", "pandas", "frames") from None
    return pandas


def frame_of_answers(solution: Solution) -> Any:
    """A row for each answer, named as `evaluate_many` names them; a word stands under `exact`."""
    rows = [(name, frame_cells(answer)) for view in solution.answers.values() for name, answer in single_views(view)]
    names = pandas().Index([name for name, _ in rows], name="answer")
    return pandas().DataFrame([cells for _, cells in rows], index=names, columns=list(COLUMNS))


def single_views(view: AnswerView) -> Iterator[tuple[str, AnswerView]]:
    """An answer by its name; of a vector in space or a tensor each part by its own."""
    if view.answer.rows:
        yield from ((f"{view.name}.{name}", part) for name, part in view.components.items())
    else:
        yield view.name, view


def frame_cells(view: AnswerView) -> tuple[Any, ...]:
    number = float("nan") if view.float is None else view.float
    return number, view.unit, view.exact or view.word, view.direction, ", ".join(view.conditions)
