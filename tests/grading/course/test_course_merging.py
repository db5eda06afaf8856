"""Papers of several files: who is whose, which paper counts, and that nothing of what was handed in before is lost."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from rotsolve.algebra.formula import Symbol
from rotsolve.core.faults import SceneError
from rotsolve.grading.course.papers import KnownStudent, KnownStudents, papers_table, read_papers, with_file
from rotsolve.grading.course.questions import SheetTask, Task
from rotsolve.grading.course.students import Student, names_apart
from rotsolve.grading.course.table import Entry, read_table

NAMES = ("a", "alpha", "T")
SCENE = SheetTask("", (Task("", {name: Symbol(name) for name in NAMES}),))
SHEET = SheetTask(
    "Homework 4",
    (
        Task("Winch", {name: Symbol(name) for name in NAMES}, number=1, name="winch", labels={"a": "a", "alpha": "b", "T": "c"}),
        Task("Roll", {"b": Symbol("b"), "x": Symbol("x")}, number=2, name="roll", labels={"b": "a", "x": "b"}),
    ),
    is_sheet=True,
)  # fmt: skip


def rows(text: str, file: str = "class.csv", sheet: SheetTask = SCENE) -> tuple[Entry, ...]:
    return read_table(text, file, sheet).entries


def counting(*files: tuple[Entry, ...]) -> list[KnownStudent]:
    """The students of several files, handed in one after the other."""
    found: list[Entry] = []
    for own in files:
        found = with_file(found, own)
    return KnownStudents(found).all


def answers(holder: KnownStudent, place: int = 0) -> dict[str, str] | None:
    papers = holder.counting.papers
    return None if papers is None else {name: text for name, text in papers[place].answers.items() if text}


@pytest.mark.parametrize(
    ("heading", "asked"),
    [
        ("1.a", (0, "a")),
        ("winch.a", (0, "a")),
        ("Winch. α", (0, "alpha")),
        ("1.b", (0, "alpha")),  # a label on paper, where no answer has that name
        ("2.b", (1, "b")),  # the name before the label
        ("2.(b)", (1, "x")),  # in brackets the label alone
        ("2.(a)", (1, "b")),
        ("2.(x)", None),
        ("roll.a", (1, "b")),
        ("roll.x", (1, "x")),
        ("x", (1, "x")),  # the only one of that name
        ("T", (0, "T")),
        ("3.a", None),
        ("1.q", None),
        ("1.", None),
        ("a b", None),
    ],
)
def test_headings_of_a_sheet(heading: str, asked: tuple[int, str] | None) -> None:
    assert SHEET.meant(heading) == asked


def test_a_heading_that_is_the_label_of_another_answer_says_so() -> None:
    said = SHEET.other_label("2.b")
    assert said == (
        "The column `2.b` is taken as the answer named b, which is (a) on the sheet; `2.(b)` would be the answer (b) there, x."
    )
    assert not any(map(SHEET.other_label, ("1.a", "1.b", "2.(b)", "2.x", "2.a", "q", "x")))
    alone = SheetTask("", (Task("", {"b": Symbol("b"), "a": Symbol("a")}, labels={"b": "a", "a": "b"}),))
    assert (alone.meant("a"), alone.meant("(a)"), alone.meant("c")) == ((0, "a"), (0, "b"), None)
    assert alone.other_label("a").startswith("The column `a` is taken as the answer named a, which is (b) on the sheet")


def test_a_name_of_two_problems_means_neither() -> None:
    twice = SheetTask("", (SHEET.tasks[0], SHEET.tasks[0]), is_sheet=True)
    assert twice.meant("alpha") is None and twice.meant("1.alpha") == (0, "alpha")


def test_first_and_last_names_are_joined_in_whatever_columns_they_stand() -> None:
    for head in ("First name,Last name,1.a", "Vorname,Nachname,1.a", "given name,Surname,1.a", "Vorname,Name,1.a"):
        assert rows(f"{head}\nAda,Lovelace,1\n", sheet=SHEET)[0].student.name == "Ada Lovelace"
    assert rows("Surname,Name,1.a\nLovelace,Ada,1\n", sheet=SHEET)[0].student.name == "Ada Lovelace"


def test_a_row_of_canvas_that_is_no_student() -> None:
    text = 'Student,ID,SIS User ID,SIS Login ID,Section,1.a\n"    Points Possible",,,,,2\n"Lovelace, Ada",17,4711,ada,A,1\n'
    (one,) = rows(text, sheet=SHEET)
    assert one.student == Student("Lovelace, Ada", "4711", "", "ada", "A", "17")


def test_working_belongs_to_its_problem() -> None:
    (one,) = rows("name,1.a,winch.working,2.working\nAda,1,a = 1; b = 2,c = 3\n", sheet=SHEET)
    assert one.papers is not None and [paper.working for paper in one.papers] == [("a = 1", "b = 2"), ("c = 3",)]


# merging


def test_the_later_paper_counts_and_says_so() -> None:
    (ada,) = counting(rows("number,name,a\n1,Ada,1\n"), rows("number,name,a\n1,Ada,2\n", "late.csv"))
    assert answers(ada) == {"a": "2"}
    assert ada.counting.remarks == ("handed in before, in line 2 of class.csv: the later answers count",)


def test_an_empty_cell_takes_no_answer_away() -> None:
    """In a later file and in the same one; what has been answered in the later row counts."""
    early, late = "1,Ada,1,2,3\n", "1,Ada,,5,\n"
    head = "number,name,a,alpha,T\n"
    for files in ((rows(head + early), rows(head + late, "late.csv")), (rows(head + early + late),)):
        (ada,) = counting(*files)
        assert answers(ada) == {"a": "1", "alpha": "5", "T": "3"}
        here = "line 2 of class.csv" if len(files) > 1 else "line 2"
        assert ada.counting.remarks == (
            f"handed in before, in {here}: the later answers count",
            f"what the later paper leaves empty stands as in {here}",
        )


def test_a_number_without_its_zeros_is_the_same_number() -> None:
    first = rows("number,name,a\n007,Ada,1\n0,Bob,1\n")
    ada, bob = counting(first, rows("number,name,a\n7,Ada,2\n00,Bob,2\n", "late.csv"))
    assert (answers(ada), answers(bob)) == ({"a": "2"}, {"a": "2"})
    assert "the number 7 is 007 in line 2 of class.csv: taken as the same" in ada.counting.remarks
    ada, bob, eve = counting(first, rows("number,name,a\n7,Eve,2\n", "late.csv"))
    assert (ada.student.name, eve.student.name) == ("Ada", "Eve")
    assert "the number 7 stands with two names: Eve, in line 2 of late.csv" in ada.counting.remarks


def test_a_late_table_without_a_column_leaves_that_answer_and_the_variant_as_they_were() -> None:
    first = rows("name,variant,1.a,2.b\nAda,7,1,2\n", sheet=SHEET)
    (ada,) = counting(first, rows("name,2.x\nada,3\n", "late.csv", SHEET))
    assert (answers(ada), answers(ada, 1)) == ({"a": "1"}, {"b": "2", "x": "3"})
    assert ada.counting.papers is not None and {paper.variant for paper in ada.counting.papers} == {"7"}
    assert ada.counting.remarks == ()


@pytest.mark.parametrize(
    "late", ["name,a\nLovelace Ada,2\n", "name,a\nADA  LOVELACE,2\n", 'name,a\n"Lovelace, Ada",2\n']
)
def test_a_name_in_another_form_is_the_same_student(late: str) -> None:
    (ada,) = counting(rows("name,number,a\nAda Lovelace,4711,1\n"), rows(late, "late.csv"))
    assert answers(ada) == {"a": "2"} and ada.counting.student.number == "4711"


def test_equal_names_with_different_numbers_are_two_students() -> None:
    class_file = rows("number,name,a\n1,Bob,1\n2,Bob,2\n")
    one, other = counting(class_file, rows("number,name,a\n2,Bob,3\n", "late.csv"))
    assert (answers(one), answers(other)) == ({"a": "1"}, {"a": "3"})
    assert all("same name" not in remark for entry in class_file for remark in entry.remarks)
    assert names_apart([(holder.student, "line 1") for holder in (one, other)]) == ["Bob (1)", "Bob (2)"]


def test_a_name_that_may_be_several_students_is_not_guessed() -> None:
    found = counting(rows("number,name,a\n1,Bob,1\n2,Bob,2\n"), rows("name,a\nBob,3\n", "late.csv"))
    assert [answers(holder) for holder in found] == [{"a": "1"}, {"a": "2"}, None]
    assert "whose paper is this?" in found[2].counting.remarks[0]


def test_a_number_with_two_names_is_pointed_out_at_both() -> None:
    one, other = counting(rows("number,name,a\n1,Ada,1\n1,Bob,2\n"))
    assert (answers(one), answers(other)) == ({"a": "1"}, {"a": "2"})
    assert "the number 1 stands with two names" in one.counting.remarks[0] + other.counting.remarks[0]
    assert one.remarks and other.remarks


def test_two_rows_of_one_number_are_one_student() -> None:
    (ada,) = counting(rows("number,name,a\n1,Ada,1\n1,Ada,2\n"))
    assert answers(ada) == {"a": "2"} and "handed in before, in line 2" in ada.counting.remarks[0]


def test_a_later_row_that_can_not_be_read_takes_no_marks_away() -> None:
    (ada,) = counting(rows("name,a,T\nAda,1,2\n"), rows("name,a,T\nAda,1,2,3\n", "late.csv"))
    assert answers(ada) == {"a": "1", "T": "2"}
    assert "a later paper, in line 2 of late.csv, can't be read" in ada.counting.remarks[0]


def test_a_file_that_is_corrected_takes_its_own_place_and_loses_nobody() -> None:
    late = rows("name,a\nAda,9\n", "late.csv")
    found = counting(rows("name,a\nAda,1\nBob,2\nEve,x,y\n"), late, rows("name,a\nAda,5\nEve,6\nFay,7\n"))
    assert {holder.student.name: answers(holder) for holder in found} == {
        "Ada": {"a": "9"}, "Eve": {"a": "6"}, "Fay": {"a": "7"}, "Bob": {"a": "2"},
    }  # fmt: skip


WORDS = st.text(st.sampled_from("ab ,;\"'=\n€α"), max_size=6).map(lambda text: " ".join(text.split()))
ROW = st.tuples(st.sampled_from(["", "1", "2", "3"]), st.sampled_from(["Ada", "Bob", "Éva"]), WORDS, WORDS)


def table_of(found: Sequence[tuple[str, ...]]) -> str:
    from io import StringIO

    text = StringIO()
    csv.writer(text, lineterminator="\n").writerows([("number", "name", "1.a", "2.working"), *found])
    return text.getvalue()


@example([("", "Ada", "", "''=")], [("", "Ada", "'=a", "'")], ",")
@given(st.lists(ROW, min_size=1, max_size=6), st.lists(ROW, min_size=1, max_size=6), st.sampled_from(",;\t"))
@settings(max_examples=150, deadline=None)
def test_what_is_kept_comes_back(first: list[tuple[str, ...]], later: list[tuple[str, ...]], separator: str) -> None:
    """The table of the papers reads as what was handed in; handing a file in again changes nothing."""
    from tempfile import TemporaryDirectory

    one, other = rows(table_of(first), sheet=SHEET), rows(table_of(later), "late.csv", SHEET)
    found = with_file(with_file([], one), other)
    assert len(found) == len(first) + len(later)
    assert with_file(found, other) == found
    assert {id(entry) for entry in with_file(found, one)} == {id(entry) for entry in found}
    with TemporaryDirectory() as folder:
        Path(folder, "papers.csv").write_text(papers_table(found, SHEET, separator, ""), encoding="utf-8", newline="")
        back, _ = read_papers(Path(folder), SHEET)
    assert [holder.counting.papers for holder in KnownStudents(back).all] == [
        holder.counting.papers for holder in KnownStudents(found).all
    ]
    assert [holder.student for holder in KnownStudents(back).all] == [
        holder.student for holder in KnownStudents(found).all
    ]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("file,line,name,a,q\nx,1,Ada,1,2\n", "a column `q`, which is not asked"),
        ("name,a\nAda,1\n", "lost columns"),
        ("file,line,name,a\nclass.csv,two,Ada,1\n", "no file or no line"),
        ('file,line,name,a\nclass.csv,2,"Ada,1\n', "can't be read"),
    ],
)
def test_a_table_of_papers_that_is_not_ours(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "papers.csv").write_text(text, encoding="utf-8")
    with pytest.raises(SceneError, match=said) as error:
        read_papers(tmp_path, SCENE)
    assert "--anew" in str(error.value)
