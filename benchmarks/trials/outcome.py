"""Outcome: what rotsolve makes of a scene, as plain data: the printed figures of every answer, or why there is none."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from fractions import Fraction

from rotsolve.algebra.units.dimension import NONE, Dimension
from rotsolve.core.derivation import Answer
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.page.values import certified_digits, machine_number
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

SOLVED, OBJECTED, NOT_YET, UNSOLVABLE, BAD, INTERNAL = "solved", "objected", "not yet", "unsolvable", "bad", "internal"


@dataclass(frozen=True)
class Printed:
    """One printed number: as printed, exactly, with its note, its direction or word, and its dimension."""

    text: str
    note: str = ""
    said: str = ""
    dimension: Dimension = NONE

    @property
    def number(self) -> Fraction | None:
        return Fraction(self.text) if self.text else None


@dataclass(frozen=True)
class Outcome:
    """What became of a scene: its kind, the printed answers by name, the message where there are none, and the CPU time."""

    kind: str
    answers: dict[str, Printed] = field(default_factory=dict)
    message: str = ""
    seconds: float = 0.0
    solution: Solution | None = None


def outcome(text: str, digits: int = 6, law: str | None = None, confirm: bool = True) -> Outcome:
    """Solve the text of a scene; whatever happens becomes an outcome."""
    start = time.process_time()
    try:
        solution = solve(text + "\n", digits=digits, law=law, confirm=confirm)
        answers = printed_answers(solution, digits)
        solution.to("text")
    except SceneError as error:
        kind = NOT_YET if getattr(error, "not_yet", False) else BAD
        return Outcome(kind, {}, str(error), time.process_time() - start)
    except Unsolvable as error:
        return Outcome(UNSOLVABLE, {}, str(error), time.process_time() - start)
    except Exception as error:
        return Outcome(INTERNAL, {}, f"{type(error).__name__}: {error}", time.process_time() - start)
    kind = OBJECTED if any(check.holds is False for check in solution.checks) else SOLVED
    return Outcome(kind, answers, "", time.process_time() - start, solution)


def printed_answers(solution: Solution, digits: int) -> dict[str, Printed]:
    """All printed numbers of a solution, those of components by dotted names."""
    found: dict[str, Printed] = {}

    def take(name: str, answer: Answer) -> None:
        text, note = certified_digits(answer.value, digits)
        said = " ".join(part for part in (answer.direction, answer.word) if part)
        found[name] = Printed(machine_number(text), note, said, answer.dimension or NONE)
        for part in answer.components:
            take(f"{name}.{part.name}", part)

    for answer in solution.derivation.answers:
        take(answer.name, answer)
    return found
