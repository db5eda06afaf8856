"""Papers in a stream into a table of marks: the rows of a report, from and to CSV and Parquet, whole or kept until it goes on."""

from __future__ import annotations

import csv
import re
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from statistics import mean, median
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rotsolve.grading.course.report.tally import Tally, median_of_counts
from rotsolve.grading.course.stream import kept, run
from rotsolve.grading.course.stream.assignment import BATCH, MarkedRows
from rotsolve.grading.course.stream.kept import KeptBatches
from rotsolve.grading.course.stream.marker import FORGETTING, Marker
from rotsolve.grading.course.stream.papers import cell_text, decoded_lines

pyarrow = pytest.importorskip("pyarrow")
parquet = pytest.importorskip("pyarrow.parquet")
Command = Callable[..., Any]

HEADER = "name,variant,a,alpha,T,working\n"
ROWS = HEADER + (
    'Ada,,g,g/R,0,m g = m a\nBob,,bad,,"2,5 N",bad; good\n\nada,,?,g/R,"1\n2",\n=1+1,,odd,g/R,0,\n'
    'Eve,3,g,g/R,0,\nFay,,"open,g/R,0,\nGus,,g,g/R,0,,,more\nMallory,,g,g/R,0,\nHal,x,g\n'
)


def many(count: int) -> str:
    return HEADER + "".join(f"S{number},,{'g' if number % 3 else 'bad'},g/R,0,\n" for number in range(count))


def parquet_of(text: str, file: str = "class.parquet") -> list[dict[str, str]]:
    """The same papers as a Parquet file of texts."""
    rows = [dict(zip(HEADER.strip().split(","), row, strict=True)) for row in csv.reader(text.splitlines()[1:])]
    parquet.write_table(pyarrow.Table.from_pylist(rows), file)
    return rows


def rows_in(file: str) -> list[list[str]]:
    with open(file, encoding="utf-8", newline="") as stream:
        return list(csv.reader(stream))


def head_of(out: str) -> str:
    """What a report says of the class, without what it says of its own files."""
    return "".join(line for line in out.splitlines(keepends=True) if not re.search(r"gradebook|^The summary", line))


# the same rows


@pytest.mark.parametrize(
    ("text", "name"),
    [
        (ROWS, "marks.csv"),
        (ROWS.replace(",", ";"), "marks.csv"),
        ("\ufeff" + ROWS.replace("\n", "\r\n"), "marks.csv"),
        (ROWS.replace("\n", "\r"), "marks.csv"),
        ("sep=,\n" + ROWS, "marks.csv"),
        (ROWS.replace(",", "\t"), "marks.tsv"),
    ],
)
def test_the_rows_are_those_of_a_report(made_up: Command, text: str, name: str) -> None:
    Path("class.csv").write_text(text, encoding="utf-8", newline="")
    report, stream = made_up("class.csv", "-o", "report"), made_up("class.csv", "-o", name)
    assert Path(name).read_bytes() == Path("report/marks.csv").read_bytes()
    assert (stream.code, stream.err) == (report.code, report.err) == (1, "")
    assert stream.out == f"{head_of(report.out)}The marks are in {name}.\n"
    assert not Path(f"{name}.parts").exists()


def test_several_batches_give_the_rows_of_a_report(made_up: Command) -> None:
    Path("class.csv").write_text(many(2 * BATCH + 7), encoding="utf-8")
    report, stream = made_up("class.csv", "-o", "report"), made_up("class.csv", "-o", "marks.csv")
    assert Path("marks.csv").read_bytes() == Path("report/marks.csv").read_bytes()
    assert stream.out == f"{head_of(report.out)}The marks are in marks.csv.\n"


def test_variants_in_any_order(command: Command) -> None:
    """Papers of the first batch name higher variants than those of the second."""
    vary = "vary: {m: 1 kg to 3 kg by 0.1 kg}\n"
    Path("scene.yaml").write_text(Path("scene.yaml").read_text(encoding="utf-8") + vary, encoding="utf-8")
    papers = "".join(f"S{number},{20 - number // 20},3.5 m/s²,,,\n" for number in range(BATCH + 20))
    Path("class.csv").write_text(HEADER + papers + "Low,1,2mg/(2m+M),a/R,,\nNone,21,g,,,\n", encoding="utf-8")
    options = ("class.csv", "--variants", "20", "--seed", "3", "-o")
    command(*options, "report")
    ran = command(*options, "marks.csv")
    assert Path("marks.csv").read_bytes() == Path("report/marks.csv").read_bytes()
    assert "there are 20 variants, so none has the number 21" in Path("marks.csv").read_text(encoding="utf-8")
    assert "Variants by seed 3." in ran.out


def test_from_and_to_parquet(made_up: Command) -> None:
    text = HEADER + 'Ada,,g,g/R,0,m g = m a\nBob,,bad,,"2,5 N",bad; good\nCid,,?,g/R,12,\nEve,3,g,g/R,0,\n'
    Path("class.csv").write_text(text, encoding="utf-8")
    parquet_of(text)
    for source in ("csv", "parquet"):
        for target in ("csv", "parquet"):
            made_up(f"class.{source}", "-o", f"{source}.{target}")
    by_csv, by_parquet = (rows_in(f"{one}.csv") for one in ("csv", "parquet"))
    assert [row[1:-1] for row in by_csv] == [
        row[1:-1] for row in by_parquet
    ]  # lines are counted from the header or not
    assert [row[0] for row in by_parquet[1:]] == ["1", "2", "3", "4"]
    table = parquet.read_table("csv.parquet")
    assert table.column_names == by_csv[0]
    assert [str(field.type) for field in table.schema][:6] == [
        "int64",
        "string",
        "string",
        "string",
        "string",
        "double",
    ]
    for row, cells in zip(by_csv[1:], table.to_pylist(), strict=True):
        told = [str(cell) if isinstance(cell, str) else cell for cell in cells.values()]
        assert [cell or None for cell in row[:4]] == [str(told[0]), *told[1:4]]
        assert [float(row[5]), float(row[10])] == [told[5], told[10]] if row[5] else told[5] is None


def test_a_report_from_parquet(made_up: Command) -> None:
    text = HEADER + "Ada,,g,g/R,0,m g = m a\nada,,bad,,0,bad\n"
    Path("class.csv").write_text(text, encoding="utf-8")
    parquet_of(text)
    by_csv, by_parquet = (made_up(file, "-f", "json") for file in ("class.csv", "class.parquet"))
    assert by_parquet.out.replace('"line": 1', "").count("\n") == by_csv.out.count("\n")
    assert "the same name stands in line 2" in by_parquet.out


def test_values_that_are_no_texts(made_up: Command) -> None:
    columns = {
        "id": [7, 8, 9],
        "variant": [None, 1.0, float("nan")],
        "a (m/s^2)": [3.5, float("nan"), 4.0],
        "T": ["g", None, "0"],
        "working": [["m g = m a", "bad"], [], None],
        "when": pyarrow.array([0, 1, 2], pyarrow.timestamp("s")),
    }
    parquet.write_table(pyarrow.table(columns), "class.parquet")
    ran = made_up("class.parquet", "-o", "marks.csv")
    rows = rows_in("marks.csv")[1:]
    assert [row[2] for row in rows] == ["7", "8", "9"]
    assert rows[0][4] == "right" and rows[1][-1].startswith("not marked: the problem has no `vary`")
    assert "No column is named alpha." in ran.out


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (None, ""),
        (3, "3"),
        (3.5, "3.5"),
        (float("nan"), ""),
        ("a\nb", "a\nb"),
        ([1.5, 2.0], "(1.5, 2.0)"),
        (["a", "b"], "a\nb"),
    ],
)
def test_cells(value: object, text: str) -> None:
    assert cell_text(value) == text


# whose papers


def test_a_number_that_stands_twice(made_up: Command) -> None:
    """A table of marks has a row for each paper; a report has the last of each student."""
    papers = "Ada,4711,g\nBob,12,g\nAda,4711,bad\nBob,13,g\nAda,,g\nAda L.,4711,g\n"
    Path("class.csv").write_text(f"name,number,a\n{papers}", encoding="utf-8")
    made_up("class.csv", "-o", "marks.csv")
    rows = rows_in("marks.csv")[1:]
    assert [row[1] for row in rows] == [
        *("Ada (4711), line 2", "Bob (12)", "Ada (4711), line 4", "Bob (13)", "Ada (line 6)", "Ada L.")
    ]
    assert [row[-1].partition(";")[0] for row in rows] == [
        "the same name stands in line 6",
        "",
        "the same name stands in line 6",
        "",
        "the same name stands in lines 2, 4",
        "the number 4711 stands in lines 2, 4",
    ]
    assert "the number 4711 stands in lines 4, 7" in rows[0][-1] and rows[1][-1] == ""


def test_a_sheet_by_processes(made_up: Command) -> None:
    """All problems of a sheet; and the rows are those of a report, in one process or in two."""
    Path("roll.yaml").write_text(Path("scene.yaml").read_text(encoding="utf-8"), encoding="utf-8")
    sheet = "sheet: Two\nproblems: [{problem: scene.yaml, points: 9}, {problem: roll.yaml, name: roll}]\n"
    Path("sheet.yaml").write_text(sheet, encoding="utf-8")
    rows = "".join(f"{number},g,{'bad' if number % 7 else 'g'},m g = m a\n" for number in range(BATCH + 9))
    Path("class.csv").write_text(f"number,1.a,roll.a,2.working\n{rows}", encoding="utf-8")
    Path("scene.yaml").replace("first.yaml")
    Path("sheet.yaml").write_text(sheet.replace("scene.yaml", "first.yaml"), encoding="utf-8")
    Path("sheet.yaml").replace("scene.yaml")  # which is what the command marks by
    for output, words in (("report", ()), ("one.csv", ()), ("two.csv", ("--jobs", "2")), ("report2", ("--jobs", "2"))):
        assert made_up("class.csv", "-o", output, *words).code == 1
    whole = Path("report/marks.csv").read_text(encoding="utf-8")
    assert whole.startswith("line,student,number,variant,1.a verdict,1.a,") and "problem 1,problem 2,marks" in whole
    assert whole == Path("one.csv").read_text(encoding="utf-8")
    real = Path("two.csv").read_text(encoding="utf-8")  # processes have the real judge
    assert real == Path("report2/marks.csv").read_text(encoding="utf-8")
    assert real.count("\n") == whole.count("\n") and real != whole


# what can't be


@pytest.mark.parametrize(
    ("columns", "said"),
    [
        ({"name": ["Ada"], "q": ["g"]}, "no column has the name of an answer"),
        ({"name": ["Ada"], "alpha": ["g"], "α": ["g"]}, "two columns are `α`"),
        ({"name": ["Ada"], "a": [b"g"]}, "the column `a` holds binary"),
        ({"name": pyarrow.array([], "string"), "a": pyarrow.array([], "string")}, "the table has no row"),
    ],
)
def test_tables_that_are_none(made_up: Command, columns: dict[str, Any], said: str) -> None:
    parquet.write_table(pyarrow.table(columns), "class.parquet")
    for output in (("-o", "marks.csv"), ()):
        ran = made_up("class.parquet", *output)
        assert ran.code == 2 and said in ran.err and ran.out == ""
    assert not list(Path().glob("marks*"))


def test_a_file_that_is_no_parquet(made_up: Command) -> None:
    Path("class.parquet").write_text(ROWS, encoding="utf-8")
    assert "this is no Parquet file" in made_up("class.parquet", "-o", "marks.csv").err
    assert "can't read `gone.parquet`: No such file" in made_up("gone.parquet", "-o", "marks.csv").err


def test_a_byte_that_is_no_letter_is_told_with_its_line(made_up: Command) -> None:
    Path("class.csv").write_bytes(ROWS.encode() + b"J\xfcrgen,,g,g/R,0,\n")
    whole, stream = made_up("class.csv", "-o", "report"), made_up("class.csv", "-o", "marks.csv")
    assert stream.code == 2 and stream.err == whole.err and ":13:2" in stream.err


def test_lines_are_split_as_the_whole_text_is(tmp_path: Path) -> None:
    for content in ("a\nb", "a\r\nb\r\n", "a\rb\r", "\n\na", "a\n\r\nb", ""):
        (tmp_path / "one.csv").write_bytes(content.encode())
        plain = content.replace("\r\n", "\n").replace("\r", "\n")
        assert "\n".join(decoded_lines(str(tmp_path / "one.csv"))).rstrip("\n") == plain.rstrip("\n")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("-o", "class.csv"), "error: class.csv would be overwritten\n"),
        (("-o", "./class.csv"), "error: class.csv would be overwritten\n"),
        (
            ("-o", "marks.csv", "-f", "html"),
            "error: marks.csv is a table of marks, which has no format of pages; leave out -f html\n",
        ),
        (
            ("-o", "marks.csv", "--answers"),
            "error: marks.csv is a table of marks, which has no pages of students; leave out --answers\n",
        ),
        (("-o", "gone/marks.csv"), "error: cannot write gone/marks.csv: No such file or directory\n"),
    ],
)
def test_where_marks_can_not_be(made_up: Command, words: tuple[str, ...], said: str) -> None:
    Path("class.csv").write_text(ROWS, encoding="utf-8")
    ran = made_up("class.csv", *words)
    assert (ran.code, ran.out, ran.err) == (2, "", said)


def test_without_the_package(made_up: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("class.csv").write_text(ROWS, encoding="utf-8")
    parquet_of(HEADER + "Ada,,g,,,\n")
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    for words in (("class.parquet",), ("class.parquet", "-o", "marks.csv"), ("class.csv", "-o", "marks.parquet")):
        ran = made_up(*words)
        assert (ran.code, ran.err) == (2, "error: Parquet takes pyarrow: pip install 'rotsolve[parquet]'\n")


# whole, or kept


@pytest.fixture
def stopped(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[BaseException | None], list[int]]]:
    """How often batches are stored; the third time, what is given happens instead."""

    def after_two(error: BaseException | None) -> list[int]:
        stored: list[int] = []

        def store(self: KeptBatches, number: int, rows: MarkedRows) -> None:
            if error is not None and len(stored) == 2:
                raise error
            stored.append(number)
            plain(self, number, rows)

        monkeypatch.setattr(KeptBatches, "store", store)
        return stored

    plain = KeptBatches.store
    yield after_two


def test_what_was_interrupted_goes_on(made_up: Command, stopped: Callable[[BaseException | None], list[int]]) -> None:
    Path("class.csv").write_text(many(3 * BATCH + 5), encoding="utf-8")
    made_up("class.csv", "-o", "whole.csv")
    stopped(KeyboardInterrupt())
    ran = made_up("class.csv", "-o", "marks.csv")
    kept_so = "2 of 4 batches are kept in marks.csv.parts: the same command goes on from there\n"
    assert (ran.code, ran.out, ran.err) == (130, "", f"{kept_so}interrupted\n")
    assert not Path("marks.csv").exists()
    Path("marks.csv.parts/00000001.rows").write_bytes(b"\x93half")  # as where the machine went down
    stored = stopped(None)
    ran = made_up("class.csv", "-o", "marks.csv")
    assert stored == [1, 2, 3] and ran.err == "note: 1 of 4 batches were marked before\n"
    assert Path("marks.csv").read_bytes() == Path("whole.csv").read_bytes()
    assert not Path("marks.csv.parts").exists()


@pytest.mark.parametrize("change", ["papers", "problem", "variant"])
def test_other_papers_begin_anew(
    made_up: Command, stopped: Callable[[BaseException | None], list[int]], change: str
) -> None:
    Path("class.csv").write_text(many(3 * BATCH), encoding="utf-8")
    stopped(OSError(28, "No space left on device"))
    ran = made_up("class.csv", "-o", "marks.csv")
    assert ran.code == 2 and ran.err.endswith("error: cannot write marks.csv: No space left on device\n")
    Path("marks.csv.parts/letter.txt").write_text("the teacher's", encoding="utf-8")
    if change == "papers":
        Path("class.csv").write_text(many(3 * BATCH).replace("bad", "g"), encoding="utf-8")
    if change == "problem":
        Path("scene.yaml").write_text(Path("scene.yaml").read_text(encoding="utf-8") + "\n", encoding="utf-8")
    stored = stopped(None)
    ran = made_up("class.csv", "-o", "marks.csv", *(("--variant", "2") if change == "variant" else ()))
    assert stored == [0, 1, 2] and ran.err == ""
    assert [path.name for path in Path("marks.csv.parts").iterdir()] == ["letter.txt"]


def test_what_is_there_stays_until_all_is_written(made_up: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("class.csv").write_text(many(5), encoding="utf-8")
    Path("marks.csv").write_text("of last year", encoding="utf-8")

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr(run, "counted_rows", lambda *_: map(full, range(1)))
        assert made_up("class.csv", "-o", "marks.csv").code == 2
    assert Path("marks.csv").read_text(encoding="utf-8") == "of last year"
    assert made_up("class.csv", "-o", "marks.csv").err == "note: 1 of 1 batches were marked before\n"
    assert len(Path("marks.csv").read_text(encoding="utf-8").splitlines()) == 6


def test_papers_that_change_while_they_are_read(made_up: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("class.csv").write_text(many(2 * BATCH), encoding="utf-8")
    told = kept.told_run

    def shorter(*words: Any) -> str:
        of_these = told(*words)
        Path("class.csv").write_text(many(BATCH), encoding="utf-8")
        return of_these

    monkeypatch.setattr(run, "told_run", shorter)
    ran = made_up("class.csv", "-o", "marks.csv")
    assert ran.code == 2 and "it has changed while it was read" in ran.err and not Path("marks.csv").exists()


# bounds


def test_few_papers_are_held(made_up: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of thousands of rows no more than two batches are read that are not marked yet, and a judge lives for some thousand papers."""
    Path("class.csv").write_text(many(FORGETTING + 3 * BATCH), encoding="utf-8")
    read, most, judges = 0, 0, set()
    rows, plain = Marker.rows, run.varied_entry

    def counting(entry: Any, variant: int | None) -> Any:
        nonlocal read
        read += 1
        return plain(entry, variant)

    def watching(self: Marker, named: Any) -> Any:
        nonlocal read, most
        most = max(most, read)
        read -= len(named)
        found = rows(self, named)
        kept_alive.append(self.examination.judges[0].judge(0))
        judges.add(id(kept_alive[-1]))
        return found

    kept_alive: list[Any] = []
    monkeypatch.setattr(run, "varied_entry", counting)
    monkeypatch.setattr(Marker, "rows", watching)
    assert made_up("class.csv", "-o", "marks.csv").code == 1
    assert read == 0 and most <= 2 * BATCH and len(judges) == 2


@given(st.lists(st.fractions(0, 6, max_denominator=4), min_size=1))
def test_the_median_of_counts(marks: list[Fraction]) -> None:
    counts = {one: marks.count(one) for one in marks}
    assert median_of_counts(counts) == median(marks)


def test_tallies_add_up() -> None:
    left = Tally(3, {"1": 2}, "6", variants=1, without=2, named=["A", "B"], numbers=1)
    left.add(Tally(1, {"1": 1, "6": 1}, "6", full=1, without=1, named=["C"], varied=1, faultless=1))
    assert (left.papers, left.marks, left.full, left.marked, left.named) == (4, {"1": 3, "6": 1}, 1, 4, ["A", "B", "C"])
    assert mean([1, 1, 1, 6]) == sum(Fraction(text) * count for text, count in left.marks.items()) / 4
