"""Solutions of scenes that stand in files, each worked out once in a process; the tests of one scene run behind each other."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from rotsolve.pipeline import solve
from rotsolve.solution import Solution


@cache
def solved(file: Path, law: str | None = None, at: str | None = None) -> Solution:
    return solve(file, law=law, at=at)
