"""docs/keys.md: every command of the page does what it says, its Python runs, and every file that it names is written."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path

import pytest

from pages import ROOT
from rotsolve import cli
from rotsolve.language.sheet_keys import LISTED, SHEET
from rotsolve.pipeline import solve
from rotsolve.scene.tex import tex_phrase

PAGE = (ROOT / "docs" / "keys.md").read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE, flags=re.MULTILINE | re.DOTALL)


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the files of the page, and the bundled ones."""
    for name, text in zip(("winch.yaml", "roll.yaml", "homework4.yaml"), blocks("yaml"), strict=True):
        (tmp_path / name).write_text(text, encoding="utf-8")
    for name in ("pulleys/atwood.yaml", "rolling/bowling-ball.yaml"):
        (tmp_path / "problems" / name).parent.mkdir(parents=True)
        shutil.copy(ROOT / "problems" / name, tmp_path / "problems" / name)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run(command: str) -> int:
    program, *arguments = shlex.split(command)
    assert program == "rotsolve"
    with pytest.raises(SystemExit) as left:
        cli.main(arguments)
    return int(left.value.code or 0)


def test_every_command_of_the_page(desk: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("typst")
    commands = [line for block in blocks("sh") for line in block.splitlines()]
    assert len(commands) >= 4
    for command in commands:
        assert run(command) == 0, command
    assert capsys.readouterr().err == ""
    numbers = [f"{number:02}" for number in range(1, 31)]
    pages = [f"{word}-{number}.html" for word in ("sheet", "solutions") for number in numbers]
    first = ["sheet.html", "key.html"]  # of the run without variants
    together = ["sheets.html", "sheets.csv", "key.csv"]
    assert {path.name for path in (desk / "sheets").iterdir()} == {*pages, *first, *together}
    assert {path.name for path in (desk / "quiz").iterdir()} == {
        "key.pdf",
        "sheets.pdf",
        *(f"sheet-{number}.pdf" for number in range(1, 6)),
    }
    made = {f"{word}.{format}" for word in ("sheet", "key", "solutions") for format in ("html", "pdf")}
    assert {path.name for path in (desk / "homework").iterdir()} == made
    assert {path.name for path in (desk / "rolling").iterdir()} == {"sheet.html", "key.html"}


def test_the_sheet_of_the_page_says_what_the_page_says(desk: Path) -> None:
    assert run("rotsolve key homework4.yaml -o homework --solutions -f text") == 0
    sheet, key, solutions = (
        (desk / "homework" / f"{word}.txt").read_text("utf-8") for word in ("sheet", "key", "solutions")
    )
    for said in (
        "Homework 4",
        "Date: 12 December",
        "1. Bucket on a winch [6 points]",
        "(b) the force T with which the rope holds it [3 points]",
        "2. A cylinder rolls down [8 points]",
        "(b) μ, the ratio of the friction force between the cylinder and the ramp",
        "3. Atwood machine with a heavy pulley [5 points]",
    ):
        assert said in sheet, said
    assert "(a) a = ⅔ g sin β" in key and "(4 points, ±1 %)" in key
    assert all(line.strip() in solutions for line in sheet.splitlines() if line.lstrip().startswith("(a)"))


def test_every_key_of_a_sheet_stands_on_the_page() -> None:
    sheet = set(re.findall(r"^(\w+):", blocks("yaml")[2], flags=re.MULTILINE)) | {"pictures", "ruled"}
    assert sheet == {*SHEET} and all(f"`{word}" in PAGE for word in {**SHEET, **LISTED})


@pytest.mark.parametrize("tex", sorted(set(re.findall(r"`\$(.+?)\$`", PAGE))))
def test_the_formulas_of_the_page_are_understood(tex: str) -> None:
    assert tex_phrase(tex)


def test_the_python_of_the_page(desk: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exec(blocks("python")[0], {})
    lines = capsys.readouterr().out.splitlines()
    assert [line[0] for line in lines] == ["1", "2", "3"]


def test_the_problem_of_the_page_is_solved_for_every_variant_of_the_key(desk: Path) -> None:
    run("rotsolve key winch.yaml -o sheets --variants 6 -f csv")
    text = (desk / "sheets" / "key.csv").read_text("utf-8")
    for row in text.splitlines()[1:]:
        _, _, _, given, _, name, value, unit, *_ = row.split(",")
        settings = dict(pair.split(" = ") for pair in given.split("; ") if not pair.startswith("g "))
        answer = solve(desk / "winch.yaml", settings=settings).answers[name]
        assert (answer.value, answer.unit) == (value, unit)
