"""Pages: all that is printed for one student and for a class, in each format, with a judge that is made up."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from fractions import Fraction
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

from rotsolve.grading.course.report.student import marks_text
from rotsolve.page.blocks import BAD, AssessedText, AssessedTexts, FixedPage, Note, Title
from rotsolve.page.columns import clipped_around
from rotsolve.page.formats import FORMATS
from rotsolve.page.text import PRINTER

Command = Callable[..., Any]
EXPECTED = Path(__file__).parent / "expected"
PAPER = """\
student: Ada Lovelace
# what a student may write
mg - T = ma
T R = I bad α
a = 2·m·g/(2m + M)
alpha = 2 m g odd/(R (2m + odd M)) bad
"""
CLASS = """\
Name;a;α;T;working;e-mail
Ada Lovelace;2mg/(2m+M);2 bad;5 N;"mg - T = ma
TR = bad";ada@example.org
Ada Lovelace;4,36 m/s²;0;own
=HYPERLINK("x");-4.36;?;"a | b <script>alert(1)</script> `c` $d$"
Éva;1;2;3;4;5;6
"Bob;1;2;3
Mallory;1;2;3
;1;odd;
"""


Hold = Callable[[Path, str], None]


@pytest.mark.parametrize(
    ("options", "name"),
    [
        (["--width", "80"], "student.txt"),
        (["--width", "50"], "student-narrow.txt"),
        (["-f", "markdown"], "student.md"),
        (["-f", "latex"], "student.tex"),
        (["-f", "html"], "student.html"),
        (["-f", "json"], "student.json"),
    ],
)
def test_a_student(made_up: Command, options: list[str], name: str, expected: Hold) -> None:
    Path("ada.txt").write_text(PAPER, encoding="utf-8")
    ran = made_up("ada.txt", *options)
    assert (ran.code, ran.err) == (1, "")
    expected(EXPECTED / name, ran.out)
    made_up("ada.txt", *options, "-o", f"page{Path(name).suffix}")
    if "--width" not in options or "80" in options:
        expected = Path(f"page{Path(name).suffix}").read_text(encoding="utf-8")
        assert expected == ran.out


@pytest.mark.parametrize(
    ("options", "name"),
    [
        (["--width", "100"], "class.txt"),
        (["-f", "markdown"], "class.md"),
        (["-f", "latex"], "class.tex"),
        (["-f", "html"], "class.html"),
        (["-f", "json"], "class.json"),
    ],
)
def test_a_class(made_up: Command, options: list[str], name: str, expected: Hold) -> None:
    Path("class.csv").write_text(CLASS, encoding="utf-8")
    ran = made_up("class.csv", *options)
    assert (ran.code, ran.err) == (1, "")
    expected(EXPECTED / name, ran.out)


@pytest.mark.parametrize("format", ["html", "markdown"])
def test_a_report(made_up: Command, format: str, expected: Hold) -> None:
    Path("class.csv").write_text("\ufeff" + CLASS, encoding="utf-8")
    ran = made_up("class.csv", "-o", "report", "-f", format)
    suffix = {"html": ".html", "markdown": ".md"}[format]
    assert (ran.code, ran.err) == (1, "")
    assert ran.out.endswith(f"The summary is report/summary{suffix}, the marks are in report/marks.csv.\n")
    expected(EXPECTED / "marks.csv", Path("report/marks.csv").read_text(encoding="utf-8"))
    pages = sorted(path.name for path in Path("report/students").iterdir())
    names = ["0001-ada-lovelace", "0002-ada-lovelace", "0003-hyperlink-x", "0007"]
    assert pages == [f"{name}{suffix}" for name in names]
    for page in pages:
        expected(EXPECTED / f"report-{page}", Path("report/students", page).read_text(encoding="utf-8"))
    summary = Path("report", f"summary{suffix}").read_text(encoding="utf-8")
    links = re.findall(r'href="(.*?)"|\]\(<(.*?)>\)', summary)
    assert [left or right for left, right in links] == [f"students/{page}" for page in pages]


def test_what_is_typed_is_all_that_is_marked(made_up: Command) -> None:
    right, wrong = made_up("--answer", "T = 5 N", "-a", "α = g"), made_up("--answer", "a = bad")
    assert (right.code, wrong.code) == (0, 1)
    assert right.out == (
        "Block on a disc\n\nAnswers\n  α   g      right    2 of 2\n  T   5 N    right    2 of 2\n\nMarks\n  4 of 4\n"
    )
    assert wrong.out.endswith("Marks\n  0 of 2\n")


def test_standard_input(made_up: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines as in a file; a map where every line at the margin begins like one."""

    class Stream:
        def __init__(self, text: str) -> None:
            self.buffer = self
            self.text = text

        def read(self, size: int) -> bytes:
            return self.text.encode("utf-8")

    for text in ("a = g\nalpha = 1\nT = 2\nmg - T = ma\n", "a: g\nalpha: 1\nT: 2\nworking:\n  - mg - T = ma\n"):
        monkeypatch.setattr("sys.stdin", Stream(text))
        ran = made_up("-", "-f", "json")
        found = json.loads(ran.out)
        assert [part["text"] for part in found["answers"]] == ["g", "1", "2"]
        assert [line["text"] for line in found["working"]] == ["mg - T = ma"]
        assert ran.code == 0


class Tags(HTMLParser):
    """The tags of a page, each closed as it was opened; and its text."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.seen: set[str] = set()
        self.text = ""

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self.seen.add(tag)
        if tag != "meta":
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


def test_nothing_that_a_student_writes_is_markup(made_up: Command) -> None:
    hostile = (
        '</code><script>alert(1)</script> <img src=x onerror="y"> ``` | [x](javascript:y) $\\input{x}$ \x1b[31m odd'
    )
    Path("ada.txt").write_text(f"student: {hostile}\na = {hostile}\n{hostile} = 1\n", encoding="utf-8")
    page = Tags()
    page.feed(made_up("ada.txt", "-f", "html").out)
    assert not page.open and not page.seen & {"script", "img", "a"}
    assert page.text.count("<script>alert(1)</script>") == 3
    text = made_up("ada.txt").out + made_up("ada.txt", "-f", "markdown").out
    assert "\x1b" not in text
    assert r"\input" not in made_up("ada.txt", "-f", "latex").out


def test_long_answers_are_clipped_around_their_remarks() -> None:
    text = "x" * 5000 + "odd" + "y" * 5000
    item = AssessedText(("a",), text, BAD, "wrong", notes=(Note(("unexpected `odd`",), 5000, 5003),))
    page = FixedPage((Title(1, ("A title",)), Title(2, ("Answers",)), AssessedTexts((item,))))
    found = [line.text for line in PRINTER.lines(page, 80)]
    assert all(len(line) <= 80 for line in found)
    answer, caret = found[3:5]
    assert answer[caret.index("^") : caret.rindex("^") + 1] == "odd"
    for format in FORMATS.values():
        assert len(format.body(page)) < 5500


@pytest.mark.parametrize("length", [0, 1, 19, 20, 21, 60])
@pytest.mark.parametrize("room", [20, 21, 59])
def test_what_is_clipped_fits(length: int, room: int) -> None:
    text = "".join(chr(97 + place % 26) for place in range(length))
    for start in range(max(1, length)):
        part, begin = clipped_around(text, room, (start, start + 1))
        assert len(part) <= room
        if length:
            assert part[start - begin + (1 if begin else 0)] == text[start]


@pytest.mark.parametrize(
    ("marks", "text"),
    [("0", "0"), ("2", "2"), ("10", "10"), ("5/2", "2.5"), ("1/3", "0.33"), ("-1/4", "-0.25"), ("199/100", "1.99")],
)
def test_marks_as_numbers(marks: str, text: str) -> None:
    assert marks_text(Fraction(marks)) == text
