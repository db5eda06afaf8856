"""A whole sheet from the command line: what is printed and written, in any order of rows and with any number of processes."""

from __future__ import annotations

import csv
import json
import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from rotsolve import cli
from rotsolve.grading.verdict import OUTCOMES

Hold = Callable[[Path, str], None]
EXPECTED = Path(__file__).parent / "expected"
WINCH = """\
title: A bucket on a winch
given: {m: 2 kg, M: 5 kg, R: 0.2 m, g: 9.8 m/s^2}
gravity: g
bodies:
  bucket: {mass: m, moves: down}
  drum: {shape: disc, mass: M, radius: R, turns: clockwise}
connections: {axle: {axle: drum}, rope: {string: [drum, bucket]}}
find: {a: bucket.acceleration, alpha: drum.angular_acceleration, T: rope.tension}
vary: {m: 1.0 kg to 3.0 kg by 0.5 kg, M: 4 kg to 8 kg by 1 kg, R: [0.15 m, 0.20 m, 0.25 m], where: M > 2*m}
marking: {a: 2, alpha: 2, T: {points: 2, tolerance: 2 %}}
"""
ROLL = """\
title: A cylinder on a slope
given: {M: 2 kg, R: 0.1 m, beta: 30 deg, g: 9.8 m/s^2}
gravity: g
surfaces: {slope: {slope: beta, down: right}}
bodies: {cylinder: {shape: cylinder, mass: M, radius: R, moves: down, turns: clockwise}}
connections: {grip: {rolls: [cylinder, slope]}}
find: {a: cylinder.acceleration, alpha: cylinder.angular_acceleration}
"""
SHEET = "sheet: Homework 4\nproblems: [winch.yaml, {problem: roll.yaml, points: 8}]\n"
CLASS = """\
Matrikelnummer;Vorname;Nachname;E-Mail;Variante;1.a;1.α;1.T;roll.a (m/s²);roll.alpha;roll.working;Zeitstempel
4711;Ada;Lovelace;ada@x.org;1;2,94 m/s²;19,6 rad/s²;10,3 N;3,27;32,7 rad/s²;m g sin β - f = m a;x
4712;Bob;Smith;bob@x.org;2;9,8 m/s²;65,3 rad/s²;0 N;2/3 g sin β;?;;x
4713;Bob;Smith;;;2mg/(2m+M);a/R;m(g - a);4,9;a/R;;
;Carol;Jones;carol@x.org;3;(2m g;;;;;;
4715;Dan;Hill;dan@x.org;99x;1;2;3;3,27;;;
4716;Eva;"Weiß;1
"""
OPTIONS = ("--variants", "30", "--seed", "7")
NUMBERS = [("4711", "14"), ("4712", "5.5"), ("4713", "10"), ("", "0"), ("4715", "4"), ("4716", "")]


class Ran:
    """What a command did."""

    def __init__(self, code: int, out: str, err: str) -> None:
        self.code, self.out, self.err = code, out, err


@pytest.fixture
def check(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Callable[..., Ran]:
    """Run `rotsolve check homework.yaml` in a folder with the sheet and a class."""
    monkeypatch.chdir(tmp_path)
    for name, text in (("winch.yaml", WINCH), ("roll.yaml", ROLL), ("homework.yaml", SHEET), ("class.csv", CLASS)):
        Path(name).write_text(text, encoding="utf-8")

    def run(*words: str, sheet: str = "homework.yaml") -> Ran:
        with pytest.raises(SystemExit) as left:
            cli.main(["check", sheet, *words])
        captured = capsys.readouterr()
        return Ran(int(left.value.code or 0), captured.out, captured.err)

    return run


def marks(folder: str = "report", separator: str = ";") -> dict[str, dict[str, str]]:
    """The rows of marks.csv by what students are called."""
    with Path(folder, "marks.csv").open(encoding="utf-8", newline="") as stream:
        return {row["student"]: row for row in csv.DictReader(stream, delimiter=separator)}


def everything(folder: str) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in Path(folder).rglob("*") if path.is_file()}


def test_the_summary_of_a_sheet(check: Callable[..., Ran], expected: Hold) -> None:
    ran = check("class.csv", *OPTIONS, "--width", "100")
    assert (ran.code, ran.err) == (1, "")
    expected(EXPECTED / "sheet.txt", ran.out)


def test_a_report_of_a_sheet(check: Callable[..., Ran], expected: Hold) -> None:
    ran = check("class.csv", *OPTIONS, "-o", "report", "-f", "markdown", "--answers")
    assert (ran.code, ran.err) == (1, "")
    names = ("marks.csv", "papers.csv", "overrides.csv", "gradebook-moodle.csv", "gradebook-canvas.csv")
    pages = ("students/0001-ada-lovelace-4711.md", "students/0003-bob-smith-4713.md")
    told = [f"===== {name}\n{Path('report', name).read_text(encoding='utf-8')}" for name in (*names, *pages)]
    expected(EXPECTED / "sheet-report.txt", "".join((ran.out, *told)))
    assert [(row["number"], row["marks"].replace(",", ".")) for row in marks().values()] == NUMBERS
    assert not [*Path("report", "students").glob("0006*")]


def test_the_data_of_a_sheet(check: Callable[..., Ran]) -> None:
    found = json.loads(check("class.csv", *OPTIONS, "-f", "json", "--answers").out)
    ada, *_, eva = found["papers"]
    assert found["sheet"] == "Homework 4" and (ada["number"], ada["marks"]["number"]) == ("4711", 14)
    assert [(one["name"], one["of"]["number"]) for one in ada["problems"]] == [("winch", 6), ("roll", 8)]
    assert [one["name"] for one in ada["problems"][1]["right"]] == ["a", "alpha"]
    assert eva["marked"] is False and "quotation mark" in eva["remarks"][0]
    outcomes = {
        part["outcome"] for one in found["papers"] for task in one.get("problems", ()) for part in task["answers"]
    }
    assert outcomes <= {*OUTCOMES} and len(outcomes) == 6


def test_any_number_of_processes_gives_the_same(check: Callable[..., Ran]) -> None:
    check("class.csv", *OPTIONS, "-o", "one", "--answers")
    printed = check("class.csv", *OPTIONS, "-o", "two", "--answers", "--jobs", "2")
    assert printed.err == "" and everything("one") == everything("two")


def test_the_order_of_rows_changes_no_marks(check: Callable[..., Ran]) -> None:
    head, *rows = CLASS.splitlines()
    check("class.csv", *OPTIONS, "-o", "report")
    before = marks()
    random.Random(1).shuffle(rows)
    Path("class.csv").write_text("\n".join((head, *rows)), encoding="utf-8")
    check("class.csv", *OPTIONS, "-o", "other")
    after = marks("other")
    assert after.keys() == before.keys()
    assert all({**after[name], "line": ""} == {**before[name], "line": ""} for name in before)


def test_a_late_run_is_one_run(check: Callable[..., Ran]) -> None:
    """What is handed in in two files has the marks that it has in one; a second time nothing changes."""
    head, *rows = CLASS.splitlines()
    check("class.csv", *OPTIONS, "-o", "whole")
    Path("first.csv").write_text("\n".join((head, *rows[:3])), encoding="utf-8")
    Path("late.csv").write_text("\n".join((head, *rows[3:])), encoding="utf-8")
    check("first.csv", *OPTIONS, "-o", "report")
    said = check("late.csv", *OPTIONS, "-o", "report").out
    assert "3 papers from late.csv, 0 of students who had handed in before." in said
    whole, parts = marks("whole"), marks()
    assert {name: row["marks"] for name, row in whole.items()} == {name: row["marks"] for name, row in parts.items()}
    assert [row["file"] for row in parts.values()] == ["first.csv"] * 3 + ["late.csv"] * 3
    before = everything("report")
    check("late.csv", *OPTIONS, "-o", "report")
    assert everything("report").keys() == before.keys()
    assert everything("report")["papers.csv"] == before["papers.csv"]
    assert everything("report")["marks.csv"] == before["marks.csv"]


def test_what_is_not_in_the_file_any_more_is_kept_and_named(check: Callable[..., Ran]) -> None:
    check("class.csv", *OPTIONS, "-o", "report")
    Path("class.csv").write_text("\n".join(CLASS.splitlines()[:2]), encoding="utf-8")
    ran = check("class.csv", *OPTIONS, "-o", "report")
    assert (
        "Not in class.csv any more, but kept from an earlier run: Bob Smith, Bob Smith" in ran.out and len(marks()) == 6
    )
    check("class.csv", *OPTIONS, "-o", "report", "--anew")
    assert [*marks()] == ["Ada Lovelace"]


def test_papers_of_another_sheet_are_refused_and_kept(check: Callable[..., Ran]) -> None:
    check("class.csv", *OPTIONS, "-o", "report")
    before = everything("report")
    Path("other.yaml").write_text("sheet: Another\nproblems: [roll.yaml]\n", encoding="utf-8")
    Path("other.csv").write_text("name,roll.a\nAda,g\n", encoding="utf-8")
    ran = check("other.csv", "-o", "report", sheet="other.yaml")
    assert (ran.code, ran.out) == (2, "") and "a column `winch.a`, which is not asked" in ran.err
    assert everything("report") == before


# marks by hand

HEAD = "name,number,part,mark,reason\n"


def test_marks_by_hand_are_kept_and_shown(check: Callable[..., Ran]) -> None:
    check("class.csv", *OPTIONS, "-o", "report")
    table = (
        HEAD
        + 'Carol Jones,,1.a,1.5,a bracket\n,4713,roll.a,"2,5",\nEva Weiß,,winch.T,2,on paper\nBob Smith (4712),,2.b,8/3,x\n'
    )
    Path("report/overrides.csv").write_text(table, encoding="utf-8")
    for _ in range(2):
        check("class.csv", *OPTIONS, "-o", "report", "-f", "markdown")
        assert Path("report/overrides.csv").read_text(encoding="utf-8") == table
        found = marks()
        assert (found["Carol Jones"]["1.a verdict"], found["Carol Jones"]["1.a"]) == ("marked by hand", "1,5")
        assert found["Bob Smith (4713)"]["marks"] == "12,5" and found["Bob Smith (4712)"]["2.alpha"] == "2,67"
        assert (found["Eva Weiß"]["1.T"], found["Eva Weiß"]["marks"]) == ("2", "2")
        assert found["Eva Weiß"]["1.a verdict"] == "not marked"
    page = next(Path("report/students").glob("*carol*")).read_text(encoding="utf-8")
    assert "marked by hand: a bracket" in page
    assert "Carol Jones,,,,,1.5" in Path("report/gradebook-canvas.csv").read_text(encoding="utf-8")
    assert "Eva" not in Path("report/gradebook-canvas.csv").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("row", "column", "said", "help"),
    [
        ("Nobody,,1.a,1,x", 1, "no student is called `Nobody`", "Ada Lovelace"),
        ("Bob Smith,,1.a,1,x", 1, "`Bob Smith` may be several students", "Bob Smith (4712), Bob Smith (4713)"),
        (",4719,1.a,1,x", 2, "no student has the number `4719`", "4711"),
        ("Ada Lovelace,4712,1.a,1,x", 1, "the number 4712 is that of Bob Smith (4712)", "Bob Smith"),
        (",,1.a,1,x", 1, "the row says no student", "write the name, or the number"),
        (",4711,1.q,1,x", 7, "no answer is called `1.q`", "1.a"),
        (",4711,a,1,x", 7, "no answer is called `a`", "1.a"),
        (",4711,,1,x", 1, "the row says no part", "1.a"),
        (",4711,1.a,2.5,x", 11, "2.5 is more than the 2 marks of `1.a`", "from 0 to 2"),
        (",4711,1.a,-1,x", 11, "`-1` is no mark", "from 0 to 2"),
        (",4711,1.a,two,x", 11, "`two` is no mark", "from 0 to 2"),
        (",4711,1.a,,x", 1, "the row has no mark", "from 0 to 2"),
        (",4711,1.a,1,x,y", 1, "the row has too many cells", "in quotes"),
        (",4711,1.a,1,x\n,4711,winch.a,2,y", 7, "this answer has a mark by hand in line 2 already", "leave one"),
    ],
)
def test_rows_of_marks_by_hand_with_a_fault(
    check: Callable[..., Ran], row: str, column: int, said: str, help: str
) -> None:
    Path("report").mkdir()
    Path("report/overrides.csv").write_text(f"{HEAD}{row}\n", encoding="utf-8")
    before = everything("report")
    ran = check("class.csv", *OPTIONS, "-o", "report")
    assert (ran.code, ran.out, everything("report")) == (2, "", before)
    line = 2 + row.count("\n")
    assert f"error: {said}\n  --> report/overrides.csv:{line}:{column}\n" in ran.err and help in ran.err


@pytest.mark.parametrize("head", ["name,part,reason\n", "part,mark\n", "x\n"])
def test_a_table_of_marks_by_hand_without_its_columns(check: Callable[..., Ran], head: str) -> None:
    Path("report").mkdir()
    Path("report/overrides.csv").write_text(f"{head}a,b,c\n", encoding="utf-8")
    ran = check("class.csv", *OPTIONS, "-o", "report")
    assert ran.code == 2 and "there is no column" in ran.err and "name,number,part,mark,reason" in ran.err


# gradebooks


def test_canvas_is_given_back_what_it_exported(check: Callable[..., Ran]) -> None:
    text = (
        "Student,ID,SIS User ID,SIS Login ID,Section,Homework 4 (1234),roll.a,roll.alpha\n"
        '    Points Possible,,,,,14,,\n"Lovelace, Ada",17,4711,ada,Sec A,,2/3 g sin β,a/R\n"Smith, Bob",18,4712,bob,Sec A,,g,\n'
    )
    Path("class.csv").write_text(text, encoding="utf-8")
    check("class.csv", *OPTIONS, "-o", "report")
    assert Path("report/gradebook-canvas.csv").read_text(encoding="utf-8") == (
        "Student,ID,SIS User ID,SIS Login ID,Section,Homework 4 (1234)\n    Points Possible,,,,,14\n"
        '"Lovelace, Ada",17,4711,ada,Sec A,8\n"Smith, Bob",18,4712,bob,Sec A,0\n'
    )


def test_nobody_is_taken_for_another_in_a_gradebook(check: Callable[..., Ran]) -> None:
    """Moodle gives a row without its mark to the student before; Canvas takes the first of a name."""
    rows = "student number,name,roll.a\n1,Ada,g\n,Bob,g\n,Bob,g\n2,Eve,g\n2,Fay,g\n,Gus,g\n"
    Path("class.csv").write_text(rows, encoding="utf-8")
    ran = check("class.csv", *OPTIONS, "-o", "report")
    assert Path("report/gradebook-moodle.csv").read_text(encoding="utf-8").splitlines()[1:] == ["1,Ada,0,0,0"]
    names = [
        line.partition(",")[0]
        for line in Path("report/gradebook-canvas.csv").read_text(encoding="utf-8").splitlines()[2:]
    ]
    assert names == ["Ada", "Gus"]
    assert "Left out of gradebook-moodle.csv: 5 whom nothing tells from others there." in ran.out


def test_a_number_in_the_title_is_no_assignment_of_canvas(check: Callable[..., Ran]) -> None:
    Path("homework.yaml").write_text(SHEET.replace("Homework 4", "Homework (4)"), encoding="utf-8")
    check("class.csv", *OPTIONS, "-o", "report")
    assert Path("report/gradebook-canvas.csv").read_text(encoding="utf-8").splitlines()[0].endswith(",Homework [4]")


# one student

PAPER = """\
student: Ada
variant: 1
Problem 1:
m g - T = m a
a = 2.94 m/s²
winch.T = 10.3 N
roll:
m g sin β - f = m a
(a) = 1
alpha = 32.7 rad/s²
2.a = 3.27 m/s²
"""


def test_one_students_paper_to_a_sheet(check: Callable[..., Ran], expected: Hold) -> None:
    Path("ada.txt").write_text(PAPER.replace("(a) = 1\n", ""), encoding="utf-8")
    ran = check("ada.txt", "--seed", "7", "--width", "80")
    assert (ran.code, ran.err) == (1, "")
    expected(EXPECTED / "sheet-student.txt", ran.out)


def test_one_students_paper_as_a_map(check: Callable[..., Ran]) -> None:
    text = (
        "student: Ada\nvariant: 1\nwinch: {a: 2.94 m/s², α: 19.6 rad/s², T: 10.3 N}\n2.a: 3.27 m/s²\nroll.alpha: a/R\n"
    )
    Path("ada.yaml").write_text(text, encoding="utf-8")
    ran = check("ada.yaml", "--seed", "7")
    assert (ran.code, ran.err) == (0, "") and ran.out.endswith("Marks\n  14 of 14\n")


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("ada.txt", "a = 1\n", "of which problem is this?\n  --> ada.txt:1:1"),
        ("ada.txt", "m g = T\n1.a = 2\n", "of which problem is this?\n  --> ada.txt:1:1"),
        ("ada.txt", "Problem 1:\n# nothing\n", "there is no answer"),
        ("ada.txt", "\n", "nothing is handed in"),
        ("ada.yaml", "rol: {a: 1}\n", "`rol` is not asked\n  --> ada.yaml:1:1"),
        ("ada.yaml", "roll: {q: 1}\n", "`q` is not asked\n  --> ada.yaml:1:8"),
        ("ada.yaml", "- 1\n", "answers are a map"),
    ],
)
def test_papers_to_a_sheet_that_can_not_be_read(check: Callable[..., Ran], name: str, text: str, said: str) -> None:
    Path(name).write_text(text, encoding="utf-8")
    ran = check(name)
    assert (ran.code, ran.out) == (2, "") and said in ran.err


def test_answers_to_a_sheet_on_the_command_line(check: Callable[..., Ran]) -> None:
    ran = check("--answer", "roll.a = 2/3 g sin β", "-a", "T = m M g/(2m+M)")
    assert (ran.code, ran.err) == (0, "") and ran.out.endswith("Marks\n  6 of 6\n")
    ran = check("--answer", "a = 3")
    assert ran.code == 2 and "which answer is this?" in ran.err and "1.a" in ran.err


# what can't be marked


def test_a_problem_that_can_not_be_solved_marks_nobody(check: Callable[..., Ran]) -> None:
    Path("roll.yaml").write_text(ROLL.replace("M: 2 kg, ", ""), encoding="utf-8")
    ran = check("class.csv", *OPTIONS, "-o", "report")
    assert ran.code in (1, 2) and "roll.yaml" in ran.err and not Path("report").exists()


@pytest.mark.parametrize("name", ["papers.csv", "overrides.csv", "marks.csv", "gradebook-moodle.csv"])
def test_a_table_of_the_report_is_no_class(check: Callable[..., Ran], name: str) -> None:
    check("class.csv", *OPTIONS, "-o", "report")
    before = everything("report")
    ran = check(f"report/{name}", *OPTIONS, "-o", "report")
    assert (ran.code, ran.err) == (2, f"error: report/{name} would be overwritten\n") and everything("report") == before


def test_the_points_are_those_of_the_sheet(check: Callable[..., Ran]) -> None:
    check("class.csv", *OPTIONS, "-o", "report")
    row: dict[str, Any] = marks()["Ada Lovelace"]
    assert sum(Fraction(row[name].replace(",", ".")) for name in ("2.a", "2.alpha")) == 8 == Fraction(row["problem 2"])
