"""docs/checking.md: its files are written, its commands are run in order, and they print what the page shows."""

from __future__ import annotations

import csv
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
    assert len(shown) == 5 and {path.name for path in folder.iterdir()} == {"winch.yaml", "class.csv", "ada.txt"}
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


def test_the_key_of_each_variant_has_full_marks(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The answers of the key, handed in with the variants that they belong to, are right; with those of others they are not."""
    printed("key winch.yaml --variants 30 --seed 7 -o handout -f csv", capsys)
    with (folder / "handout" / "key.csv").open(encoding="utf-8", newline="") as stream:
        key = list(csv.DictReader(stream))
    answers: dict[str, dict[str, str]] = {}
    for row in key:
        answers.setdefault(row["variant"], {})[row["answer"]] = f"{row['value']} {row['unit']}"
    assert [*answers] == [str(number) for number in range(1, 31)]
    for shift, marks in ((0, "6"), (1, None)):
        with (folder / "all.csv").open("w", encoding="utf-8", newline="") as stream:
            writer = csv.writer(stream)
            writer.writerow(["name", "variant", "a", "alpha", "T"])
            for number, found in answers.items():
                variant = (int(number) - 1 + shift) % 30 + 1
                writer.writerow([f"Student {number}", variant, found["a"], found["alpha"], found["T"]])
        code, _ = printed("check winch.yaml all.csv --variants 30 --seed 7 -o all", capsys)
        with (folder / "all" / "marks.csv").open(encoding="utf-8", newline="") as stream:
            given = [row["marks"] for row in csv.DictReader(stream)]
        assert len(given) == 30
        assert (set(given) == {marks}, code) == ((True, 0) if marks else (False, 1))
        assert marks or given.count("6") == 0


def test_a_variant_is_marked_as_the_scene_says(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Points and tolerances stand in the scene alone; the tension may be off by 2 %, the acceleration by 1 %."""
    (folder / "ada.txt").write_text("variant: 1\na = 2.985 m/s²\nα = 19.6 rad/s²\nT = 10.45 N\n", encoding="utf-8")
    code, out = printed("check winch.yaml ada.txt --seed 7", capsys)
    assert code == 1 and out.endswith("Marks\n  4 of 6\n")


@pytest.mark.parametrize(("words", "variant"), [("--seed 7 --variant 2", 2), ("--seed 8 --variant 2", None)])
def test_the_variant_on_the_command_line(
    folder: Path, capsys: pytest.CaptureFixture[str], words: str, variant: int | None
) -> None:
    (folder / "bob.txt").write_text("a = 1.96 m/s²\nα = 13.07 rad/s²\nT = 7.84 N\n", encoding="utf-8")
    assert printed(f"check winch.yaml bob.txt {words}", capsys)[0] == (0 if variant else 1)
