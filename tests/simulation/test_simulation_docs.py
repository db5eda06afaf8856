"""docs/simulate.md: its example prints what it shows, and its Python runs."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from rotsolve import cli

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "simulate.md"


EXAMPLE = re.compile(r"```sh\nrotsolve (.*?)\n```\n\n```text\n(.*?)```", re.DOTALL)
COMMANDS = [found[1] for found in EXAMPLE.finditer(PAGE.read_text(encoding="utf-8"))]


@pytest.mark.parametrize("command", COMMANDS)
def test_an_example_prints_what_it_shows(
    command: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], regenerate: bool
) -> None:
    """The figures of the last section depend on the machine's sine."""
    monkeypatch.chdir(ROOT)
    text = PAGE.read_text(encoding="utf-8")
    found = next(example for example in EXAMPLE.finditer(text) if example[1] == command)
    with pytest.raises(SystemExit) as left:
        cli.main(shlex.split(command))
    printed = capsys.readouterr().out
    if regenerate:
        PAGE.write_text(text[: found.start(2)] + printed + text[found.end(2) :], encoding="utf-8")
        return
    assert left.value.code == 0
    assert printed.partition("\nAccuracy\n")[0] == found[2].partition("\nAccuracy\n")[0]


def test_there_is_an_example_of_the_plane_and_of_space() -> None:
    assert len(COMMANDS) == 2


def test_the_python_of_the_page_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    (code,) = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    names: dict[str, object] = {}
    exec(code, names)
    assert 0 <= names["bound"] < 1e-11  # type: ignore[operator]
