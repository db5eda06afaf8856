"""docs/checking.md: its files are written, its commands are run in order, and they print what the page shows."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from rotsolve import cli

ROOT = Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs" / "checking.md"
FILE = r"(?:[Ss]ave this as|Put this into) `(?P<name>[\w./]+)`:\n\n```\w+\n(?P<file>.*?)```"
COMMAND = r"```sh\nrotsolve (?P<words>.*?)\n```\n(?:\n```text\n(?P<out>.*?)```)?"
STEP = re.compile(f"{FILE}|{COMMAND}", re.DOTALL)


def printed(words: str, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    """The exit code of a command and what it prints."""
    with pytest.raises(SystemExit) as left:
        cli.main(shlex.split(words))
    captured = capsys.readouterr()
    assert captured.err == ""
    return int(left.value.code or 0), captured.out


def test_the_commands_of_the_page_print_what_it_shows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], regenerate: bool
) -> None:
    """`pytest tests/grading/course --regenerate` writes what they print anew."""
    monkeypatch.chdir(tmp_path)
    text, told = PAGE.read_text(encoding="utf-8"), []
    for step in list(STEP.finditer(text)):
        if step["name"]:
            Path(step["name"]).write_text(step["file"], encoding="utf-8")
            told.append(step["name"])
            continue
        words, expected = step["words"], step["out"]
        code, out = printed(words, capsys)
        if regenerate and expected is not None:
            old, new = (f"rotsolve {words}\n```\n\n```text\n{said}```" for said in (expected, out))
            assert old in text
            text = text.replace(old, new, 1)
        elif expected is not None:
            assert out == expected
        assert code == (0 if "--answer " in words or words.startswith("key") else 1), words
        told.append(words.split()[0])
    assert told == [
        *("winch.yaml", "key", "class.csv", "ada.txt", "check", "check", "check", "check"),
        *(
            "roll.yaml",
            "homework.yaml",
            "form.csv",
            "check",
            "late.csv",
            "check",
            "marked/overrides.csv",
            "check",
            "check",
        ),
    ]
    if regenerate:
        PAGE.write_text(text, encoding="utf-8")
    for folder in ("report", "marked"):
        assert Path(folder, "marks.csv").is_file()
    (carol,) = Path("marked", "students").glob("*carol*")
    assert "marked by hand: the bracket is only missing" in carol.read_text(encoding="utf-8")
