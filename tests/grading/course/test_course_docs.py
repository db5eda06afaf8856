"""docs/checking.md: its files are written, its commands are run in order, and they print what the page shows."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from rotsolve import cli

ROOT = Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs" / "checking.md"
FILE = re.compile(r"[Ss]ave this as `([\w.]+)`:\n\n```\w+\n(.*?)```", re.DOTALL)
COMMAND = re.compile(r"```sh\nrotsolve (.*?)\n```\n(?:\n```text\n(.*?)```)?", re.DOTALL)


def printed(words: str, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    """The exit code of a command and what it prints."""
    with pytest.raises(SystemExit) as left:
        cli.main(shlex.split(words))
    captured = capsys.readouterr()
    assert captured.err == ""
    return int(left.value.code or 0), captured.out


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the files of the page."""
    for name, text in FILE.findall(PAGE.read_text(encoding="utf-8")):
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_commands_of_the_page_print_what_it_shows(
    folder: Path, capsys: pytest.CaptureFixture[str], regenerate: bool
) -> None:
    """`pytest tests/grading/course --regenerate` writes what they print anew."""
    text = PAGE.read_text(encoding="utf-8")
    shown = [(found[1], found[2]) for found in COMMAND.finditer(text)]
    assert len(shown) == 6 and {path.name for path in folder.iterdir()} == {"winch.yaml", "class.csv", "ada.txt"}
    for words, expected in shown:
        code, out = printed(words, capsys)
        if regenerate and expected is not None:
            text = text.replace(
                f"rotsolve {words}\n```\n\n```text\n{expected}", f"rotsolve {words}\n```\n\n```text\n{out}"
            )
        elif expected is not None:
            assert out == expected
        assert code == (1 if "class.csv" in words or "ada.txt" in words else 0), words
    if regenerate:
        PAGE.write_text(text, encoding="utf-8")
    assert (folder / "report" / "marks.csv").is_file() and any((folder / "handout").iterdir())
