"""On a terminal: the same text in colour, and a progress bar where marking takes long."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rotsolve import run

Command = Callable[..., Any]
PAPER = "a = g\nalpha = bad\nT = ?\nmg - T = ma\n"
CLASS = "name,a,alpha,T\nAda,g,bad,?\nBob,g,g,g\n"


class Terminal(io.StringIO):
    """What is written to a terminal."""

    def isatty(self) -> bool:
        return True


def plain(text: str) -> str:
    return re.sub(r"\x1b\[[0-9;]*m", "", text)


@pytest.mark.parametrize(("file", "content"), [("ada.txt", PAPER), ("class.csv", CLASS)])
def test_the_same_text_in_colour(made_up: Command, monkeypatch: pytest.MonkeyPatch, file: str, content: str) -> None:
    Path(file).write_text(content, encoding="utf-8")
    expected = made_up(file, "--width", "80").out
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.delenv("NO_COLOR", raising=False)
    screen = Terminal()
    monkeypatch.setattr("sys.stdout", screen)
    made_up(file, "--width", "80")
    assert plain(screen.getvalue()) == expected != screen.getvalue()
    if file == "ada.txt":
        lines = {plain(line): line for line in screen.getvalue().splitlines()}
        colours = [lines[line][2:6] for line in lines if re.search("right|wrong|decide", line)]
        assert colours == ["1;32", "1;31", "1;33", "1;32"]


@pytest.mark.parametrize("patience", [-1.0, 1000.0])
def test_a_progress_bar_comes_only_where_it_takes_long(
    made_up: Command, monkeypatch: pytest.MonkeyPatch, patience: float
) -> None:
    Path("class.csv").write_text(CLASS, encoding="utf-8")
    monkeypatch.setattr(run, "PATIENCE", patience)
    screen = Terminal()
    monkeypatch.setattr("sys.stderr", screen)
    expected = made_up("class.csv", "-o", "report").out
    assert "marks are in report/marks.csv" in expected
    assert [word in screen.getvalue() for word in ("marking", "writing")] == [patience < 0] * 2
