"""Gallery: every bundled problem with its pictures, drawn once for all tests."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from rotsolve.core.faults import Unsolvable
from rotsolve.draw.paper.figure import Figure
from rotsolve.draw.pictures import free_body_pictures, scene_picture
from rotsolve.language.problem import Problem
from rotsolve.scene.read import read_file

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
def diagrams(name: str) -> tuple[tuple[str, Figure], ...]:
    """The free-body diagrams of a scene; none where nothing acts on anything."""
    try:
        return tuple(free_body_pictures(problem(name)))
    except Unsolvable:
        return ()


def pictures(name: str) -> list[Figure]:
    """All of them."""
    return [scene(name), *(figure for _, figure in diagrams(name) if not problem(name).space)]
