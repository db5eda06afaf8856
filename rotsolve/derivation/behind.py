"""Behind: the equations on which an answer rests, those of its own plan and of the answers that it uses, and their laws."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.core.equation import FAMILIES, Equation

if TYPE_CHECKING:
    from rotsolve.search.answers import Answered
    from rotsolve.search.search import Search


def families(answered: Answered, search: Search) -> set[str]:
    """The laws behind an answer: those of its own plan, and of the answers that it uses."""
    return {law.family for law in behind(answered, search)} & FAMILIES.keys()


def behind(answered: Answered, search: Search) -> Iterator[Equation]:
    """The equations behind an answer, each once: those of its own plan, and of the answers that it uses."""
    by_letter = {item.asked.letter: item for item in search.answered}
    pending, seen = [by_letter.get(answered.asked.letter, answered)], set()
    yielded: set[int] = set()
    every = [number for other in search.answered for number in other.used]
    while pending:
        item = pending.pop()
        for index in item.used:
            equation = search.planner.pool[index]
            stepped = not equation.family and search.refs.get(index, ("law", 0))[0] == "step"
            for number in (index, *(every if stepped else ())):
                if number not in yielded:
                    yielded.add(number)
                    yield search.planner.pool[number]
            for name in equation.symbols():
                if name in by_letter and name not in seen:
                    seen.add(name)
                    pending.append(by_letter[name])
