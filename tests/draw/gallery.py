"""Gallery: every bundled problem with its pictures, drawn once for all tests."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from rotsolve.core.faults import Unsolvable
from rotsolve.draw.paper.figure import Figure
from rotsolve.draw.pictures import free_body_pictures, scene_picture
from rotsolve.language.problem import Problem
from rotsolve.pipeline import solve_problem
from rotsolve.scene.read import read_file
from rotsolve.search.acting import ActingWays
from rotsolve.solution import Solution

FOLDER = Path(__file__).resolve().parents[2] / "problems"
FILES = sorted(FOLDER.glob("*/*.yaml"))
NAMES = [f"{file.parent.name}/{file.stem}" for file in FILES]


@cache
def problem(name: str) -> Problem:
    return read_file(FOLDER / f"{name}.yaml")


DRAWN = [name for name in NAMES if problem(name).bodies]
PLANE = [name for name in DRAWN if not problem(name).space]


@cache
def scene(name: str) -> Figure:
    """The picture of a scene."""
    return scene_picture(problem(name))


@cache
def solution(name: str) -> Solution | None:
    """A solved problem; None where it has no answer."""
    try:
        return solve_problem(problem(name), confirm=False)
    except Unsolvable:
        return None


def ways(name: str) -> ActingWays | None:
    """What tells which way forces act in a problem."""
    solved = solution(name)
    return None if solved is None else solved.trace.acting()


@cache
def diagrams(name: str) -> tuple[tuple[str, str, Figure], ...]:
    """The free-body diagrams of a scene, with their states and bodies; none where nothing acts on anything."""
    try:
        return tuple(free_body_pictures(problem(name), "", ways(name)))
    except Unsolvable:
        return ()


def pictures(name: str) -> list[Figure]:
    """All of them."""
    return [scene(name), *(figure for _, _, figure in diagrams(name))]
