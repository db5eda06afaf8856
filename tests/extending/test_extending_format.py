"""An output format from outside: Org, by one printer and a row in FORMATS; all that prints pages takes it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

import pytest

from rotsolve import cli
from rotsolve.algebra.notation.text import to_text
from rotsolve.page.blocks import CODE, LABEL, NAME, Bullet, Bullets, Paragraph, Table, Title
from rotsolve.page.formats import FORMATS, Format
from rotsolve.page.printer import Printer
from rotsolve.pipeline import solve

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.algebra.units.unit_table import Unit

SCENE = """
title: A wheel and its motor
given: {m: 2 kg, R: 0.1 m, tau: 3 N m}
bodies: {wheel: {shape: disc, mass: m, radius: R}}
connections: {axle: {axle: wheel}}
actions: {motor: {couple: tau, on: wheel}}
find: {alpha: wheel.angular_acceleration}
"""


class Org(Printer):
    """Pages as outlines."""

    styles: ClassVar = {NAME: "*{}*", LABEL: "*{}:* ", CODE: "={}="}

    def prose(self, text: str) -> str:
        return text

    def formula(self, formula: Formula) -> str:
        return to_text(formula)

    def unit(self, unit: Unit) -> str:
        return unit.text

    def number(self, mantissa: str, exponent: str) -> str:
        return f"{mantissa}·10^{exponent}" if exponent else mantissa

    def math(self, inner: str) -> str:
        return inner

    def bracketed(self, rows: Sequence[Sequence[str]]) -> str:
        return "; ".join(" ".join(row) for row in rows).join("()")

    def title(self, block: Title) -> Iterator[str]:
        yield f"{'*' * block.level} {self.words(block.words)}"

    def paragraph(self, block: Paragraph) -> Iterator[str]:
        yield self.words(block.words)

    def bullets(self, block: Bullets) -> Iterator[str]:
        def lines(items: Sequence[Bullet], inset: str) -> Iterator[str]:
            for item in items:
                yield f"{inset}- {self.words(item.words)}"
                yield from (f"{inset}  : {line}" for line in item.code)
                yield from lines(item.inner, inset + "  ")

        return lines(block.items, "")

    def table(self, block: Table) -> Iterator[str]:
        for row in (tuple((name,) for name in block.columns), *block.rows):
            yield f"| {' | '.join(map(self.words, row))} |"

    def document(self, bodies: Sequence[str]) -> str:
        return "\n".join(bodies)


PRINTER = Org()


@pytest.fixture(autouse=True)
def declared(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(FORMATS, "org", Format("org", (".org",), "an outline for Emacs", __name__))


@pytest.fixture
def rotsolve(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., int]:
    """Run a command in a folder that holds the scene."""
    (tmp_path / "wheel.yaml").write_text(SCENE, encoding="utf-8")
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str) -> int:
        with pytest.raises(SystemExit) as left:
            cli.main(list(arguments))
        return int(left.value.code or 0)

    return run


def test_a_derivation_is_printed() -> None:
    printed = solve(SCENE).to("org")
    assert printed.startswith("* A wheel and its motor\n")
    assert "α = 2 τ/(m R²)" in printed and "300 rad/s²" in printed


def test_solve_takes_its_name_and_its_ending(rotsolve: Callable[..., int], tmp_path: Path) -> None:
    assert rotsolve("solve", "wheel.yaml", "-o", "wheel.org") == 0
    assert (tmp_path / "wheel.org").read_text("utf-8").startswith("* A wheel and its motor\n")
    assert rotsolve("solve", "wheel.yaml", "--format", "org", "-o", "other.txt") == 0
    assert (tmp_path / "other.txt").read_bytes() == (tmp_path / "wheel.org").read_bytes()


def test_keys_are_written(rotsolve: Callable[..., int], tmp_path: Path) -> None:
    assert rotsolve("key", "wheel.yaml", "-o", "out", "-f", "org", "--solutions") == 0
    assert sorted(file.suffix for file in (tmp_path / "out").iterdir()) == [".org"] * 3


def test_answers_are_marked(rotsolve: Callable[..., int], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert rotsolve("check", "wheel.yaml", "--answer", "alpha = 2*tau/(m*R^2)", "--format", "org") == 0
    assert "α" in capsys.readouterr().out


def test_the_help_tells_it(rotsolve: Callable[..., int], capsys: pytest.CaptureFixture[str]) -> None:
    assert rotsolve("solve", "wheel.yaml", "--format", "orgg") == 2
    assert "org" in capsys.readouterr().err.replace("orgg", "")
