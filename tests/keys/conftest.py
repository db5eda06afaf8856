"""A small set of problems for the tests of keys: one that varies, one that does not, one that can't be solved."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from pages import FALL, OPEN, PLAIN
from rotsolve import cli


@pytest.fixture
def page(tmp_path: Path) -> Path:
    """A folder with the problems."""
    for name, text in (("fall", FALL), ("plain", PLAIN), ("open", OPEN), ("broken", "title: [\n")):
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    return tmp_path


@pytest.fixture
def key(
    page: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Callable[..., tuple[int, str]]:
    """Run `rotsolve key` in the folder: its exit code and its messages."""
    monkeypatch.chdir(page)

    def run(*arguments: str) -> tuple[int, str]:
        with pytest.raises(SystemExit) as left:
            cli.main(["key", *arguments])
        captured = capsys.readouterr()
        assert captured.out == ""
        sys.stdout.flush()
        return int(left.value.code or 0), captured.err

    return run
