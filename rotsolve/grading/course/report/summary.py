"""Summary: a class on one page: its marks, what went wrong most, and what a teacher should look at."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from statistics import mean
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.derivation import Words
from rotsolve.core.faults import printable
from rotsolve.grading.course.report.student import Task, marked_data, marks_of, marks_text, printable_words
from rotsolve.grading.course.report.tally import Tally, doubtful_variants, overview
from rotsolve.grading.course.table import Columns, Entry
from rotsolve.grading.verdict import PARTLY, RIGHT, UNDECIDED, WRONG, JudgedPart, Marked
from rotsolve.page.blocks import Page, PageBlock, Paragraph, Table, Title
from rotsolve.page.text import plain_text

CLASSES = 10  # of the distribution
BAR = 40  # columns of its longest bar
COMMONEST = 20
NO_MISTAKES = ("followed", "comma", "chain", "numbers")  # kinds of remarks that tell of no mistake of their own


class Result(Struct, frozen=True):
    """A row, marked; None and the reason among the remarks of the row where it could not be."""

    entry: Entry
    marked: Marked | None

    @property
    def name(self) -> str:
        """The student's name, or the line where there is none."""
        return self.entry.student or f"line {self.entry.line}"

    @property
    def variant(self) -> str:
        return "" if self.entry.paper is None else self.entry.paper.variant


def result_of_row(entry: Entry, marked: Marked | str) -> Result:
    """A row with its marks, or with the reason why it has none."""
    if isinstance(marked, Marked):
        return Result(entry, marked)
    return Result(replace(entry, remarks=(*entry.remarks, *((marked,) if marked else ()))), None)


def tally_of(results: Iterable[Result]) -> Tally:
    """What the head of a summary says of rows."""
    tally = Tally()
    for result in results:
        tally.count(result.name, result.variant, result.marked)
    return tally


class MarkedClass(Struct, frozen=True):
    """A class: the problem, the columns of its table, and its rows; the seed of the variants where the problem has such."""

    task: Task
    columns: Columns
    results: tuple[Result, ...]
    byte_order_mark: bool = False
    seed: int | None = None

    @property
    def papers(self) -> list[Marked]:
        """The papers that could be marked."""
        return [result.marked for result in self.results if result.marked is not None]

    @property
    def tally(self) -> Tally:
        """How many papers there are of which kind."""
        return tally_of(self.results)


class SummaryPage(Page, frozen=True):
    """The page of a class; `targets` are the students' pages."""

    course: MarkedClass
    targets: tuple[str, ...] = ()

    def blocks(self) -> Iterator[PageBlock]:
        course, papers = self.course, self.course.papers
        sections = (
            ("", overview(course.tally, course.seed)),
            ("Distribution", distribution(papers)),
            ("Answers, by how often they went wrong", answers_by_failures(course)),
            ("Commonest mistakes", commonest_mistakes(course)),
            ("To be looked at", to_be_looked_at(course)),
            ("Students", [students_table(course, self.targets)]),
        )
        yield Title(1, (printable(f"{course.task.title}: the class"),))
        for heading, found in sections:
            blocks = tuple(found)
            if heading and blocks:
                yield Title(2, (heading,))
            yield from map(printable_block, blocks)

    def data(self) -> dict[str, Any]:
        return {"problem": self.course.task.title, "papers": [*map(result_data, self.course.results)]}


def result_data(result: Result) -> dict[str, Any]:
    """A row of a class: its line, its remarks, and, where it was marked, its paper."""
    row = {"line": result.entry.line, "remarks": list(result.entry.remarks)}
    if result.marked is None:
        return {"student": result.entry.student, "variant": result.variant, "marked": False, **row}
    return {**marked_data(result.marked, result.variant), "marked": True, **row}


def printable_block(block: Paragraph | Table) -> PageBlock:
    """The block with nothing in it that can move or colour a terminal."""
    if isinstance(block, Paragraph):
        return Paragraph(printable_words(block.words))
    rows = tuple(tuple(printable_words(cell) for cell in row) for row in block.rows)
    return Table(tuple(map(printable, block.columns)), rows, block.targets)


def distribution(papers: list[Marked]) -> Iterator[Table]:
    """How many papers have which part of the marks."""
    if not papers:
        return
    counts = Counter(tenth_of_marks(paper) for paper in papers)
    longest = max(counts.values())
    rows = []
    for number in range(CLASSES):
        low, high = 100 * number // CLASSES, 100 * (number + 1) // CLASSES
        count = counts[number]
        bar = "█" * (max(1, BAR * count // longest) if count else 0)
        rows.append(((f"{low} to {high} %",), (str(count),), (bar,)))
    yield Table(("of the marks", "papers", ""), tuple(rows))


def tenth_of_marks(paper: Marked) -> int:
    """The class of the distribution; full marks belong to the highest."""
    part = paper.marks / paper.of if paper.of else Fraction(1)
    return max(0, min(CLASSES - 1, int(part * CLASSES)))


def answers_by_failures(course: MarkedClass) -> Iterator[Table]:
    """Of each answer how often it was right, the one that went wrong most often first."""
    parts: dict[str, list[JudgedPart]] = {}
    for paper in course.papers:
        for part in paper.parts:
            parts.setdefault(part.name, []).append(part)
    rows = []
    for name, found in sorted(parts.items(), key=lambda item: sum(is_right_part(part) for part in item[1])):
        counts = Counter(part.verdict.outcome if part.text else "" for part in found)
        marks = marks_of(Fraction(mean(part.marks for part in found)), found[0].of)
        numbers = (counts[RIGHT], counts[PARTLY], counts[WRONG], counts[UNDECIDED], counts[""])
        rows.append((course.task.letter(name), *((str(number),) for number in numbers), (marks,)))
    if rows:
        yield Table(("answer", RIGHT, PARTLY, WRONG, UNDECIDED, "no answer", "mean marks"), tuple(rows))


def is_right_part(part: JudgedPart) -> bool:
    return part.verdict.outcome == RIGHT


def commonest_mistakes(course: MarkedClass) -> Iterator[Table | Paragraph]:
    """What was said of answers that lost marks, the commonest first."""
    counts: Counter[tuple[str, Words]] = Counter()
    for paper in course.papers:
        for part in paper.parts:
            if part.text and part.marks < part.of and part.verdict.outcome != UNDECIDED:
                said = dict.fromkeys(remark.words for remark in part.verdict.remarks if remark.kind not in NO_MISTAKES)
                counts.update((part.name, words) for words in said)
    rows = [((str(count),), course.task.letter(name), words) for (name, words), count in counts.most_common(COMMONEST)]
    if rows:
        yield Table(("papers", "answer", "what was said"), tuple(rows))
    if len(counts) > len(rows):
        yield Paragraph((f"{len(counts) - len(rows)} more were not said so often: they stand on the students' pages.",))


def to_be_looked_at(course: MarkedClass) -> Iterator[Paragraph | Table]:
    """Columns without use, answers without a column, rows with something odd, and answers that could not be decided."""
    yield from without_column(course.task, course.columns)
    if course.columns.unused:
        yield Paragraph((f"Columns that were not used: {', '.join(course.columns.unused)}.",))
    yield from doubtful_variants(course.tally, course.seed)
    odd = ((result, words) for result in course.results for words in oddities(course, result))
    rows = [((str(result.entry.line),), (result.name,), words) for result, words in odd]
    if rows:
        yield Table(("line", "student", "what"), tuple(rows))


def head_of_class(task: Task, columns: Columns, tally: Tally, seed: int | None) -> Iterator[str]:
    """What a summary begins with, a sentence a line."""
    for paragraph in (*overview(tally, seed), *without_column(task, columns), *doubtful_variants(tally, seed)):
        yield plain_text(paragraph.words)


def without_column(task: Task, columns: Columns) -> Iterator[Paragraph]:
    """Answers that no column holds."""
    absent = [name for name in task.letters if name not in columns.answers]
    if absent:
        yield Paragraph((f"No column is named {', '.join(absent)}.",))


def oddities(course: MarkedClass, result: Result) -> Iterator[Words]:
    """What a teacher should look at in one row."""
    if result.entry.remarks:
        prefix = "" if result.marked is not None else "not marked: "
        yield (prefix + "; ".join(result.entry.remarks),)
    for part in result.marked.parts if result.marked is not None else ():
        if part.text and part.verdict.outcome == UNDECIDED:
            yield (*course.task.letter(part.name), f": can't decide on {part.text[:100]}")
        for remark in part.verdict.remarks if is_right_part(part) else ():
            if remark.kind == "chain":
                yield (*course.task.letter(part.name), ": ", *remark.words, ", but the answer is right")


def students_table(course: MarkedClass, targets: tuple[str, ...]) -> Table:
    """Every student with the marks of each answer and their sum."""
    letters = [plain_text(course.task.letter(name)) for name in course.task.letters]
    rows = []
    for result in course.results:
        parts = {part.name: part for part in result.marked.parts} if result.marked is not None else {}
        marks = (marks_text(parts[name].marks) if name in parts else "" for name in course.task.letters)
        total = marks_of(result.marked.marks, result.marked.of) if result.marked is not None else "not marked"
        rows.append(((result.name,), *((text,) for text in marks), (total,)))
    return Table(("student", *letters, "marks"), tuple(rows), targets)
