"""A stand-in for the engine, so that the command line is tested by itself: file names say what happens to them."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from rotsolve import cli
from rotsolve.algebra.notation.parse import parse
from rotsolve.core import faults
from rotsolve.core.derivation import Answer, Derivation, Equality, LawLine, Section
from rotsolve.solution import Solution, Trace


@dataclass(frozen=True)
class Digits:
    """A third, to any number of digits."""

    def figures(self, digits: int) -> tuple[str, int]:
        return "0." + "3" * digits, digits


def derivation(title: str, number: str) -> Derivation:
    law = LawLine(1, "Newton's second law, block", Equality(parse("m g"), parse("m a")))
    answer = Answer("a", parse("a"), parse("g"), Digits(), None, None)  # type: ignore[arg-type]
    return Derivation(title + number, "", (), ((parse("a"),),), (), (), (Section("", (), (), (law,)),), (answer,), ())


class Engine:
    """Solves every file but those whose names say otherwise; remembers what it was asked."""

    def __init__(self) -> None:
        self.asked: list[tuple[str, dict[str, Any]]] = []

    def solve(self, source: Path | str, **options: Any) -> Solution:
        path = None if isinstance(source, str) and "\n" in source else Path(source)
        name = "-" if path is None else path.name
        self.asked.append((name, options))
        if name.startswith("bad"):
            fault = faults.Fault("unknown body `puley` in a string", None, "did you mean `pulley`?")
            raise faults.SceneError([fault], (), name)
        if name.startswith("open"):
            raise faults.Unsolvable("2 equations for 3 unknowns (T, a, α)", file=name)
        if name.startswith("broken"):
            raise ZeroDivisionError("division\nby zero")
        if path is not None:
            path.read_text(encoding="utf-8")
        text = "".join(f", {key} = {value}" for key, value in sorted(options["settings"].items()))
        trace = Trace(lambda: "the facts\n", lambda: "the equations", lambda: "the plan\n\n")
        problem: Any = SimpleNamespace(file=name, lines=())
        return Solution(problem, derivation(f"Scene {name}", text), trace, options["digits"])


@dataclass(frozen=True)
class Ran:
    """What a command did."""

    code: int
    out: str
    err: str


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> Engine:
    engine = Engine()
    module: Any = ModuleType("rotsolve.pipeline")
    module.solve = engine.solve
    monkeypatch.setitem(sys.modules, "rotsolve.pipeline", module)
    return engine


@pytest.fixture
def rotsolve(
    engine: Engine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Callable[..., Ran]:
    """Run a command in a folder of its own, 80 columns wide."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    for name in ("one.yaml", "two.yaml"):
        (tmp_path / name).write_text("title: a scene\n")

    def run(*arguments: str) -> Ran:
        with pytest.raises(SystemExit) as left:
            cli.main(list(arguments))
        captured = capsys.readouterr()
        return Ran(int(left.value.code or 0), captured.out, captured.err)

    return run
