"""Solutions of scenes that stand in files, each worked out once in a process; the tests of one scene run behind each other."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution import Solution


def solved(file: Path, law: str | None = None, at: str | None = None, *, confirm: bool = True) -> Solution:
    found = found_once(file, law, at, confirm)
    if isinstance(found, Unsolvable):
        raise found
    return found


@cache
def found_once(file: Path, law: str | None, at: str | None, confirm: bool) -> Solution | Unsolvable:
    """The solution, or why there is none, which a cache would else work out again each time."""
    try:
        return solve(file, law=law, at=at, confirm=confirm)
    except Unsolvable as error:
        return error
