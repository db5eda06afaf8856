"""A mistake from outside: g put in twice, by one function and its place in MISTAKES."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from rotsolve import cli
from rotsolve.algebra.formula import Symbol
from rotsolve.grading.mistakes.mistake import Change, Made
from rotsolve.grading.mistakes.scene import Scene
from rotsolve.grading.mistakes.table import MISTAKES, MistakeKind
from rotsolve.grading.mistakes.wrong_answers import WrongAnswers
from rotsolve.scene.read import read_source

SCENE = """
title: A block on a string round a disc
given: {m: 2 kg, M: 5 kg, R: 20 cm}
bodies:
  block: {mass: m, moves: down}
  disc: {shape: disc, mass: M, radius: R, turns: clockwise}
connections: {axle: {axle: disc}, cord: {string: [disc, block]}}
find: {a: block.acceleration}
"""
TWICE = "g was put in twice"


def doubled_gravity(scene: Scene) -> Made:
    """2 g for g."""
    if "g" in scene.problem.values:
        yield TWICE, Change(letters={"g": 2 * Symbol("g")})


@pytest.fixture(autouse=True)
def declared() -> Iterator[None]:
    row = MistakeKind("doubled gravity", "g is put in twice", doubled_gravity)
    MISTAKES.append(row)
    yield
    MISTAKES.remove(row)


def test_it_gives_the_wrong_answer() -> None:
    found = {mistake.name: answers for mistake, answers in WrongAnswers.of(read_source(SCENE))}
    value = found["doubled gravity"]["a"].value
    assert value is not None and value.text(3) == "8.71"  # 2 m (2 g)/(2 m + M)


def test_a_student_is_told(tmp_path_factory: pytest.TempPathFactory, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path_factory.mktemp("scene") / "block.yaml"
    file.write_text(SCENE, encoding="utf-8")
    with pytest.raises(SystemExit):
        cli.main(["check", str(file), "--answer", "a = 8.711 m/s²"])
    assert TWICE in capsys.readouterr().out
