"""Every kind of answers that can't be read: all that the command prints, and its exit code. The files stand in bad_answers.txt."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

TABLE = Path(__file__).parent / "bad_answers.txt"
CASE = re.compile(
    r"^===== (?P<name>.+?) \[(?P<code>\d)\] (?P<arguments>.*)\n(?P<file>(?s:.*?))^-----\n(?P<message>(?s:.*?))(?=^=====|\Z)",
    re.M,
)
CASES = [case.groupdict() for case in CASE.finditer(TABLE.read_text(encoding="utf-8"))]
Command = Callable[..., Any]


def test_the_table_is_read() -> None:
    assert len(CASES) == TABLE.read_text(encoding="utf-8").count("\n=====") > 20
    assert len({case["name"] for case in CASES}) == len(CASES)


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_message(case: dict[str, str], made_up: Command, expected: Any) -> None:
    arguments = case["arguments"].split()
    Path(arguments[0]).write_text(case["file"], encoding="utf-8")
    ran = made_up(*arguments)
    assert ran.out == ""
    name, tail = case["name"], f"{case['arguments']}\n{case['file']}-----\n"
    heads = (f"===== {name} [{case['code']}] {tail}", f"===== {name} [{ran.code}] {tail}")
    expected.case(TABLE, heads, (case["message"], ran.err))
    assert Path("scene.yaml").is_file() and Path(arguments[0]).read_text(encoding="utf-8") == case["file"]


SAVE = "help: save it as UTF-8; spreadsheets call it `CSV UTF-8`\n"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (
            "name,a\nAda,g\nJos\xe9,g\n".encode("latin-1"),
            f"the byte E9 is not UTF-8: in Latin-1 it is `é`\n  --> class.csv:3:4\n 3 | José,g\n   |    ^\n{SAVE}",
        ),
        (
            "name,a\nÉva,½ g\n".encode("cp1252"),
            f"the byte C9 is not UTF-8: in Latin-1 it is `É`\n  --> class.csv:2:1\n 2 | Éva,½ g\n   | ^\n{SAVE}",
        ),
        ("name,a\nAda,g\n".encode("utf-16"), f"the file is UTF-16, not UTF-8\n  --> class.csv\n{SAVE}"),
        (b"PK\3\4\0\0\0\0", f"this is no text file: it holds a NUL byte\n  --> class.csv\n{SAVE}"),
    ],
    ids=["Latin-1", "Windows", "UTF-16", "a workbook"],
)
def test_other_encodings(content: bytes, message: str, made_up: Command) -> None:
    Path("class.csv").write_bytes(content)
    ran = made_up("class.csv")
    assert (ran.code, ran.out, ran.err) == (2, "", f"error: {message}")


@pytest.mark.parametrize(
    "content", ["$" * 199_000, "a = g\n" * 9_999, "[" * 199_000, "a: " * 60_000, "$" * 10**6, "x\n" * 10**5]
)
@pytest.mark.parametrize("name", ["ada.txt", "ada.yaml"])
def test_hostile_sheets_are_refused_in_no_time(name: str, content: str, made_up: Command) -> None:
    Path(name).write_text(content, encoding="utf-8")
    start = time.process_time()
    ran = made_up(name)
    assert (ran.code == 2 and ran.err.startswith("error: ")) or (name == "ada.txt" and content.startswith("a = g"))
    assert time.process_time() - start < 5


def test_a_file_that_is_not_there(made_up: Command) -> None:
    ran = made_up("none.csv")
    assert (ran.code, ran.err) == (2, "error: can't read `none.csv`: No such file or directory\n")


def test_a_folder(made_up: Command) -> None:
    Path("answers").mkdir()
    assert made_up("answers").err == "error: can't read `answers`: Is a directory\n"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "Invalid value for 'ANSWERS': either a file of answers, or --answer"),
        (["ada.txt", "--answer", "a = g"], "Invalid value for 'ANSWERS': either a file of answers, or --answer"),
        (["ada.txt", "-f", "docx"], "'docx' is not one of text, markdown, latex, typst, pdf, html, json"),
        (["ada.txt", "--variant", "0"], "Invalid value for '--variant': 0 is not in the range x>=1."),
    ],
)
def test_wrong_usage(arguments: list[str], message: str, made_up: Command) -> None:
    ran = made_up(*arguments)
    assert (ran.code, ran.out) == (2, "") and message in ran.err


@pytest.mark.parametrize(
    ("typed", "message"),
    [
        (["g"], "which answer is this?\n  --> --answer:1:1\n 1 | g\n   | ^\nhelp: write `a = …`; asked: a, alpha, T"),
        (["a = "], "there is no answer\n  --> --answer\nhelp: write `a = …`; asked: a, alpha, T"),
        (["b = g"], "`b` is not asked\n  --> --answer:1:1\n 1 | b = g\n   | ^\nhelp: asked: a, alpha, T"),
        (["alfa = g"], "`alfa` is not asked\n  --> --answer:1:1\n 1 | alfa = g\n   | ^^^^\nhelp: did you mean `alpha`? asked: a, alpha, T"),
        (["a = g", "a = 2 g"], "`a` is answered twice\n  --> --answer:2:1\n 2 | a = 2 g\n   | ^\nhelp: leave one out"),
    ],
)  # fmt: skip
def test_typed_answers(typed: list[str], message: str, made_up: Command) -> None:
    ran = made_up(*(word for text in typed for word in ("--answer", text)))
    assert (ran.code, ran.out, ran.err) == (2, "", f"error: {message}\n")


def test_a_scene_without_an_answer_marks_nothing(made_up: Command) -> None:
    Path("scene.yaml").write_text("title: x\nbodies: {b: {mass: 2 kg}}\nfind: {p: b.speed}\n", encoding="utf-8")
    ran = made_up("--answer", "p = 3 m/s")
    assert (ran.code, ran.out) == (2, "") and ran.err.startswith("error: ")


def test_hostile_tables_are_read_in_no_time(made_up: Command) -> None:
    Path("class.csv").write_text("name,a\n" + 'Ada,"2\n' * 2000 + "Eve,g\n" + "," * 100_000 + "x\n", encoding="utf-8")
    start = time.process_time()
    ran = made_up("class.csv", "-f", "json")
    assert ran.code == 1 and '"student": "Eve"' in ran.out
    assert time.process_time() - start < 10
