"""Mentions: what the states and questions of a scene speak of, and what it takes to answer them: functions of time, cuts through rods."""

from __future__ import annotations

from functools import cached_property

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.faults import Span
from rotsolve.core.quantity import INSIDE
from rotsolve.language.problem import Path, Problem, references
from rotsolve.motion.timeline import Timeline

MEAN = ("mean", "speed")
RUNNING = ("total", "largest", "smallest")  # what a quantity does on its way is asked


class Mentions(Struct, frozen=True, dict=True):
    """The quantities that a problem's states and questions name."""

    problem: Problem
    timeline: Timeline

    @cached_property
    def functions(self) -> bool:
        """Whether the scene asks for a function of time."""
        return any(find.runs for find in self.problem.finds)

    @cached_property
    def runs(self) -> bool:
        """Whether what it asks takes the laws at any moment of a phase: functions of time, whole ways, extremes."""
        terms = [term for find in self.problem.finds for term in find.terms if find.where is None]
        return self.functions or any(
            term.modifier in RUNNING or term.path.quantity == "distance" or (term.modifier, term.path.quantity) == MEAN
            for term in terms
        )

    def says(self, state: str, owner: str, *words: str) -> bool:
        """Whether a state speaks of a quantity of an element, or says a word about it."""
        lines = self.timeline.state(state).conditions
        said = ({line.path.quantity, line.word} for line in lines if line.path is not None and line.path.owner == owner)
        return any(found & set(words) for found in said)

    def untold(self, owner: str, word: str) -> tuple[str, Span | None] | None:
        """The first later state that says nothing of a quantity of an element, with its place."""
        silent = (state for state in self.timeline.states[1:] if not self.says(state.name, owner, word))
        return next(((state.name, state.span) for state in silent), None)

    def asks(self, owner: str, word: str) -> bool:
        """Whether the scene asks for, or states, a quantity of an element."""
        return any(path.owner == owner and path.quantity == word for path in self.paths)

    @cached_property
    def paths(self) -> tuple[Path, ...]:
        """All quantities that the states and questions speak of, those of conditions too."""
        spoken_of = references((self.problem.states, self.problem.finds))
        return tuple(path for path in spoken_of if isinstance(path, Path))

    @cached_property
    def cuts(self) -> dict[str, Path]:
        """The points at which the scene asks what acts inside a rod, by the index that their letters get."""
        found: dict[tuple[str, str | None, Formula | None], Path] = {}
        for path in self.paths:
            if path.quantity in INSIDE:
                found.setdefault((path.owner, path.point, path.argument), path)
        letters = [path.argument.name if isinstance(path.argument, Symbol) else "cut" for path in found.values()]
        return {
            letter if letters.count(letter) == 1 else f"{letter}{number}": path
            for number, (letter, path) in enumerate(zip(letters, found.values(), strict=True), 1)
        }
