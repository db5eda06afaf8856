"""The table of a class: what separates it, which column is what, rows that are not as they should be, and spellings of names."""

from __future__ import annotations

import csv
from io import StringIO

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rotsolve.algebra.formula import Symbol
from rotsolve.grading.course.columns import SEPARATORS
from rotsolve.grading.course.handed_in import meant_answer, name_and_text, read_sheet
from rotsolve.grading.course.questions import SheetTask, Task
from rotsolve.grading.course.table import KEPT, Entry, Handed, read_table

ASKED = ("a", "alpha", "T", "omega0", "v_end")


SCENE = SheetTask("", (Task("", {name: Symbol(name) for name in ASKED}),))


def table(text: str) -> Handed:
    return read_table(text, "class.csv", SCENE)


def answers(entry: Entry) -> dict[str, str]:
    """What a row has answered."""
    assert entry.papers is not None, entry.remarks
    return {name: text for name, text in entry.papers[0].answers.items() if text}


@pytest.mark.parametrize("separator", SEPARATORS)
@pytest.mark.parametrize("mark", ["", "\ufeff", "sep={}\n", "\n\n"])
@pytest.mark.parametrize("end", ["\n", ""])
def test_separators(separator: str, mark: str, end: str) -> None:
    lines = ["name|a|α|T", 'Ada|"(3, 4; 5) N"|2|0', "Bob|1||"]
    found = table(mark.format(separator) + "\n".join(line.replace("|", separator) for line in lines) + end)
    assert found.columns.separator == separator
    assert [entry.student.name for entry in found.entries] == ["Ada", "Bob"]
    assert answers(found.entries[0]) == {"a": "(3, 4; 5) N", "alpha": "2", "T": "0"}
    assert answers(found.entries[1]) == {"a": "1"}
    assert found.byte_order_mark == (mark == "\ufeff")


@pytest.mark.parametrize(
    ("header", "people", "working", "unused"),
    [
        ("a,T", {}, None, ()),
        ("name,a", {"name": 0}, None, ()),
        ("Timestamp,Email Address,Full name,a,Variant", {"name": 2, "email": 1, "variant": 4}, None, ("Timestamp",)),
        ("who,a,remark", {"name": 0}, None, ("remark",)),
        ("a,Student_ID,working,version,,", {"number": 1, "variant": 3}, 2, ()),
        ("id,name,a", {"name": 1, "number": 0}, None, ()),
        ("First name,Surname,ID number,a", {"first": 0, "last": 1, "number": 2}, None, ()),
        ("Vorname,Nachname,Matrikel-Nr.,E-Mail-Adresse,a", {"first": 0, "last": 1, "number": 2, "email": 3}, None, ()),
        (
            "Student,ID,SIS User ID,SIS Login ID,Section,a",
            {"name": 0, "canvas": 1, "number": 2, "login": 3, "section": 4},
            None,
            (),
        ),
    ],
)
def test_columns(header: str, people: dict[str, int], working: int | None, unused: tuple[str, ...]) -> None:
    found = table(f"{header}\n{'x,' * header.count(',')}x\n").columns
    assert (found.people, found.workings.get(0), found.unused) == (people, working, unused)


def test_a_header_over_several_lines() -> None:
    found = table('"name\n(first and last)",a,"α"\nAda,1,2\n')
    assert found.entries[0].line == 3 and answers(found.entries[0]) == {"a": "1", "alpha": "2"}


@pytest.mark.parametrize(
    ("said", "name"),
    [
        *[(spelling, "alpha") for spelling in ("alpha", " α ", "\\alpha", "$\\alpha$")],
        *[(spelling, "omega0") for spelling in ("omega0", "ω0", "ω₀", "omega_0", "\\omega_0", "$\\omega_{0}$", "ω_0")],
        *[(spelling, "v_end") for spelling in ("v_end", "v_{end}")],
        *[(spelling, None) for spelling in ("A", "t", "", "α α", "omega", "a b", "(", "2", "a (m/s²)", "x" * 5000)],
    ],
)
def test_spellings(said: str, name: str | None) -> None:
    assert meant_answer(said, ASKED) == name


@pytest.mark.parametrize(
    ("line", "parts"),
    [
        ("a = 2 g", ("a", "2 g")),
        ("  α: g/R ", ("α", "g/R")),
        ("a=b=c", ("a", "b=c")),
        ("a ≈ 4.36 m/s²", ("a", "4.36 m/s²")),
        ("$a = 2 g$", ("a", "2 g")),
        ("$$\\alpha = g/R$$ ", ("\\alpha", "g/R")),
        ("\\(T = 5\\)", ("T", "5")),
        ("a = $2 g$", ("a", "$2 g$")),
        ("a == b", None),
        ("$$", None),
        ("2 g", None),
        ("", None),
    ],
)
def test_lines_with_a_name(line: str, parts: tuple[str, str] | None) -> None:
    assert name_and_text(line) == parts


def test_a_row_that_can_not_be_read_takes_no_other_with_it() -> None:
    rows = [
        "Ada,1,2,3",
        'Bob,"1,2,3',
        "Éva,4,5,6",
        'Fay,"7"8,9,1',
        "Gus,(1, 2),3,4",
        'Ida,"x\ny",5,6',
        'Jo,"1',
        "Kim,7,8,9",
    ]
    found = table("name,a,alpha,T\n" + "\n".join(rows) + "\n").entries
    assert [entry.student.name for entry in found] == ["Ada", "Bob", "Éva", "Fay", "Gus", "Ida", "Jo", "Kim"]
    assert [entry.line for entry in found] == [2, 3, 4, 5, 6, 7, 9, 10]
    assert [entry.papers is None for entry in found] == [False, True, False, True, True, False, True, False]
    assert answers(found[5]) == {"a": "x y", "alpha": "5", "T": "6"}
    assert all(entry.remarks for entry in found if entry.papers is None)


def test_what_is_noted_of_rows() -> None:
    found = table("name,a,alpha,T\nAda,1\nada,1,2,3\n,1,2,3,,,\n\n,,,\nBob,1,2,3\n").entries
    assert [entry.remarks for entry in found] == [
        ("the row ends before alpha, T", "the same name stands in line 3"),
        ("the same name stands in line 2",),
        ("the row has 7 cells, the first line 4", "the row has no name"),
        (),
    ]


def test_empty_cells_at_the_end_of_all_rows_are_nothing_to_speak_of() -> None:
    assert [entry.remarks for entry in table("name,a,T,,\nAda,1,2,,\nBob,3,4,,\n").entries] == [(), ()]


def test_a_decimal_comma_may_have_cut_a_number() -> None:
    found = table(
        "name,a,alpha,T\nAda,2,18 m/s²,10\nBob,2 m/s²,18 rad/s²,10 N\nCarol,2,18,10\nDan,a = 3,27 m/s²,\n"
    ).entries
    said = "is `{}` one number with a decimal comma? Then it must be in quotes"
    assert [entry.remarks for entry in found] == [(said.format("2,18 m/s²"),), (), (), (said.format("a = 3,27 m/s²"),)]
    assert table("name;a;T\nAda;2;18 N\n").entries[0].remarks == ()


@pytest.mark.parametrize("heading", ["a (m/s²)", "a [m/s^2]", "a in m/s²", "a / m/s²"])
def test_a_unit_over_a_column(heading: str) -> None:
    found = table(f"name,{heading},T\nAda,4.36,19.6\nBob,-4.36 m/s²,1\nCarol,m g,\n").entries
    assert [answers(entry)["a"] for entry in found] == ["4.36 m/s²", "-4.36 m/s²", "m g"]


def test_what_is_no_unit_over_a_column() -> None:
    assert answers(table("name,a (3 points),T\nAda,4.36,1\n").entries[0]) == {"a": "4.36", "T": "1"}


def test_an_apostrophe_by_which_a_spreadsheet_kept_a_text() -> None:
    found = table("name,a,alpha,T\n'=Ada,'-4.36 m/s²,'=g/R,5' 3\n").entries[0]
    assert (found.student.name, answers(found)) == ("=Ada", {"a": "-4.36 m/s²", "alpha": "=g/R", "T": "5' 3"})


def test_a_name_in_a_thousand_rows() -> None:
    found = table("name,a\n" + "Ada,1\n" * 5000).entries
    assert found[0].remarks == ("the same name stands in lines 3, 4, 5, 6, 7",)
    assert found[-1].remarks == ("the same name stands in lines 2, 3, 4, 5, 6",)


def test_working_in_a_cell() -> None:
    found = table('name,a,working\nAda,1,"mg - T = ma\n\nTR = Iα; a = αR ;"\n').entries
    assert found[0].papers is not None and found[0].papers[0].working == ("mg - T = ma", "TR = Iα", "a = αR")


CELLS = st.text(st.characters(exclude_categories=("Cs", "Cc"), include_characters="\n\t"), max_size=30)


@given(st.lists(st.lists(CELLS, min_size=4, max_size=4), min_size=1, max_size=8), st.sampled_from(SEPARATORS))
@settings(max_examples=300, deadline=None)
def test_what_a_spreadsheet_writes_is_read_as_it_was(rows: list[list[str]], separator: str) -> None:
    """Cells of any text, written by Python's writer, come back, but for the blanks around them and the form of line breaks."""
    text = StringIO()
    writer = csv.writer(text, delimiter=separator, lineterminator="\n", quoting=csv.QUOTE_ALL)
    writer.writerow(["name", "a", "alpha", "T"])
    writer.writerows(["s" + cells[0], *cells[1:]] for cells in rows)
    found = table(text.getvalue()).entries
    for entry, cells in zip(found, rows, strict=True):
        kept = [cell.strip()[1:] if KEPT.match(cell.strip()) else cell.strip() for cell in cells[1:]]
        expected = {name: " ".join(cell.split("\n")) for name, cell in zip(ASKED[:3], kept, strict=True)}
        assert answers(entry) == {name: cell for name, cell in expected.items() if cell}


@given(st.text(max_size=300))
@settings(max_examples=300, deadline=None)
def test_any_text_is_a_table_or_refused(text: str) -> None:
    from rotsolve.core.faults import SceneError

    for content in (text, f"name,a\n{text}", f"a = {text}", f"a: {text}"):
        for read, asked in ((read_table, SCENE), (read_sheet, ASKED)):
            try:
                read(content, "x", asked)
            except SceneError as error:
                assert error.faults


def test_the_last_line_of_a_name_is_its_answer() -> None:
    paper = read_sheet("T = ½ M a\nmg - T = ma\na = g\n\n# done\nT = 5 N\nvariant: 3\n", "ada.txt", ASKED)
    assert dict(paper.answers) == {"a": "g", "T": "5 N"}
    assert paper.working == ("T = ½ M a", "mg - T = ma") and paper.variant == "3"


def test_a_map_of_answers() -> None:
    text = "student: Ada\nvariant: 3\nω₀: 2\nT:\nworking: |\n  a = g\n  T R = I α\n"
    paper = read_sheet(text, "ada.yaml", ASKED)
    assert (paper.student, paper.variant, dict(paper.answers)) == ("Ada", "3", {"omega0": "2"})
    assert paper.working == ("a = g", "T R = I α")
