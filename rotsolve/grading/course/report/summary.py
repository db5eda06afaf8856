"""Summary: a class on one page: its marks, what went wrong most, and what a teacher should look at."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from fractions import Fraction
from statistics import mean
from typing import Any

from rotsolve.core.derivation import Words
from rotsolve.core.faults import printable
from rotsolve.grading.comparing.formulas import NUMBERS_ALONE
from rotsolve.grading.course.analysis import FEW, complete_papers, part_figures
from rotsolve.grading.course.marked import MarkedSheet
from rotsolve.grading.course.report.results import MarkedClass, Result
from rotsolve.grading.course.report.student import marked_data, marks_of, marks_text, printable_words, title_data
from rotsolve.grading.course.report.tally import about_columns, doubtful_variants, overview
from rotsolve.grading.verdict import NO_ANSWER, NOT_MARKED, OUTCOMES, PARTLY, RIGHT, UNDECIDED, WRONG, JudgedPart
from rotsolve.page.bars import Bars, LabelledBar
from rotsolve.page.blocks import Page, PageBlock, Paragraph, Table, Title
from rotsolve.page.text import plain_text

USUAL = (RIGHT, PARTLY, WRONG, UNDECIDED, NO_ANSWER)  # states that a table has a column for, whether they occur or not
LOST = (PARTLY, WRONG)  # states in which something is said of a mistake
CHANCE = "With so few, chance may make all of these numbers: they mean little."
LEGEND = (
    "Difficulty is the mean share of the marks: the lower, the harder. The correlation is that with the marks of all other answers; "
    "best less worst is the mean share in the best 27 % of the papers less that in the worst 27 %. An answer that strong papers have and "
    "weak ones lack has both near 1; near 0 or below, it is worth a look."
)
CLASSES = 10  # of the distribution
COMMONEST = 20
NO_MISTAKES = (
    "followed",
    "comma",
    "chain",
    "numbers",
    NUMBERS_ALONE,
)  # kinds of remarks that tell of no mistake of their own


class SummaryPage(Page, frozen=True):
    """The page of a class; `targets` are the students' pages."""

    course: MarkedClass
    targets: tuple[str, ...] = ()

    def blocks(self) -> Iterator[PageBlock]:
        course = self.course
        sections = (
            ("", overview(course.tally, course.seed)),
            ("Distribution", distribution(course.papers)),
            ("Answers, by how often they went wrong", answers_by_failures(course)),
            ("Analysis", analysed(course)),
            ("Commonest mistakes", commonest_mistakes(course)),
            ("To be looked at", to_be_looked_at(course)),
            ("Marked by hand", hand_marks(course)),
            ("Students", [students_table(course, self.targets)]),
        )
        yield Title(1, (printable(f"{course.task.title}: the class"),))
        for heading, found in sections:
            blocks = tuple(found)
            if heading and blocks:
                yield Title(2, (heading,))
            yield from map(printable_block, blocks)

    def data(self) -> dict[str, Any]:
        papers = [result_data(self.course, result) for result in self.course.results]
        return {**title_data(self.course.task), "papers": papers, "analysis": analysis_data(self.course)}


def result_data(course: MarkedClass, result: Result) -> dict[str, Any]:
    """A student of a class: the row and what is said of it, and, where it was marked, the papers."""
    said = [*result.entry.remarks, *map(plain_text, result.unmarked(course.task))]
    row = {"line": result.entry.line, "remarks": said}
    if not result.is_marked:
        number = {"number": result.student.number} if result.student.number else {}
        return {"student": result.student.called, **number, "variant": result.variant, "marked": False, **row}
    own = marked_data(course.task, result.sheet, result.student, result.variant)
    return {**own, "marked": True, **row}


def printable_block(block: PageBlock) -> PageBlock:
    """The block with nothing in it that can move or colour a terminal."""
    if isinstance(block, Paragraph):
        return Paragraph(printable_words(block.words))
    if isinstance(block, Table):
        rows = tuple(tuple(printable_words(cell) for cell in row) for row in block.rows)
        return Table(tuple(map(printable, block.columns)), rows, block.targets)
    return block


def distribution(papers: Sequence[MarkedSheet]) -> Iterator[Bars]:
    """How many papers have which part of the marks."""
    if not papers:
        return
    counts = Counter(tenth_of_marks(paper) for paper in papers)
    rows = []
    for number in range(CLASSES):
        low, high = 100 * number // CLASSES, 100 * (number + 1) // CLASSES
        rows.append(LabelledBar(f"{low} to {high} %", Fraction(counts[number]), str(counts[number])))
    yield Bars("Distribution of the marks", ("of the marks", "papers"), tuple(rows), Fraction(max(counts.values())))


def tenth_of_marks(paper: MarkedSheet) -> int:
    """The class of the distribution; full marks belong to the highest."""
    part = paper.marks / paper.of if paper.of else Fraction(1)
    return max(0, min(CLASSES - 1, int(part * CLASSES)))


def answers_by_failures(course: MarkedClass) -> Iterator[Table]:
    """Of each answer how often it was in which state, the one that went wrong most often first."""
    found = [
        (asked, [paper.parts[place] for paper in course.papers]) for place, asked in enumerate(course.task.asked())
    ]
    if not course.papers:
        return
    states = [
        word
        for word in OUTCOMES
        if word in USUAL or any(part.verdict.outcome == word for _, own in found for part in own)
    ]
    rows = []
    for asked, own in sorted(found, key=lambda item: sum(map(is_right_part, item[1]))):
        counts = Counter(part.verdict.outcome for part in own)
        marks = marks_of(Fraction(mean(part.marks for part in own)), own[0].of)
        rows.append((course.task.label(asked), *((str(counts[word]),) for word in states), (marks,)))
    yield Table(("answer", *states, "mean marks"), tuple(rows))


def is_right_part(part: JudgedPart) -> bool:
    return part.verdict.outcome == RIGHT


def analysed(course: MarkedClass) -> Iterator[PageBlock]:
    """How hard each answer was, and how well it tells strong papers from weak ones."""
    complete = complete_papers(course.papers)
    figures = part_figures(complete, course.task)
    if len(complete) < 2 or not figures:
        return
    said = f"By the {len(complete)} papers of which every answer has its marks. A bar is the mean share of the marks of an answer."
    yield Paragraph((f"{said} {CHANCE}" if len(complete) < FEW else said,))
    bars = (LabelledBar(course.task.heading(one.asked), one.share, percent(one.share)) for one in figures)
    yield Bars("Mean share of the marks of each answer", ("answer", "mean share"), tuple(bars), Fraction(1))
    rows = []
    for one in figures:
        tied = "none" if one.correlation is None else coefficient_text(one.correlation)
        numbers = (percent(one.share), tied, coefficient_text(float(one.gap)))
        rows.append((course.task.label(one.asked), *((number,) for number in numbers)))
    yield Table(("answer", "difficulty", "correlation", "best less worst"), tuple(rows))
    yield Paragraph((LEGEND,))


def percent(share: Fraction) -> str:
    """A share in whole percents."""
    return f"{round(100 * share)} %"


def coefficient_text(number: float) -> str:
    """A coefficient to two places, with a minus that is one."""
    text = f"{number:.2f}"
    return "0.00" if text == "-0.00" else text.replace("-", "−")


def analysis_data(course: MarkedClass) -> dict[str, Any]:
    """The figures of the analysis for programs."""
    complete = complete_papers(course.papers)
    figures = [
        {
            "answer": course.task.key(one.asked),
            "difficulty": float(one.share),
            "correlation": one.correlation,
            "best_less_worst": float(one.gap),
        }
        for one in part_figures(complete, course.task)
    ]
    return {"papers": len(complete), "answers": figures}


def commonest_mistakes(course: MarkedClass) -> Iterator[Table | Paragraph]:
    """What was said of answers that lost marks, the commonest first, then in the order of the sheet."""
    counts: Counter[tuple[int, Words]] = Counter()
    for place in range(len(course.parts) if course.papers else 0):
        for part in (paper.parts[place] for paper in course.papers):
            if part.verdict.outcome in LOST and part.marks < part.of:
                said = dict.fromkeys(remark.words for remark in part.verdict.remarks if remark.kind not in NO_MISTAKES)
                counts.update((place, words) for words in said)
    asked = list(course.task.asked())
    order = sorted(counts.items(), key=lambda item: (-item[1], item[0][0], plain_text(item[0][1])))
    rows = [((str(count),), course.task.label(asked[place]), words) for (place, words), count in order[:COMMONEST]]
    if rows:
        yield Table(("papers", "answer", "what was said"), tuple(rows))
    if len(counts) > len(rows):
        yield Paragraph((f"{len(counts) - len(rows)} more were not said so often: they stand on the students' pages.",))


def to_be_looked_at(course: MarkedClass) -> Iterator[Paragraph | Table]:
    """Columns without use, answers without a column, rows with something odd, and answers that could not be decided."""
    yield from (Paragraph((said,)) for said in course.merged)
    yield from about_columns(course.task, course.columns, course.held)
    if course.columns.unused:
        yield Paragraph((f"Columns that were not used: {', '.join(course.columns.unused)}.",))
    yield from doubtful_variants(course.tally, course.seed)
    odd = ((result, words) for result in course.results for words in oddities(course, result))
    rows = [((course.row(result),), (result.name,), words) for result, words in odd]
    if rows:
        yield Table(("line", "student", "what"), tuple(rows))


def oddities(course: MarkedClass, result: Result) -> Iterator[Words]:
    """What a teacher should look at in one row."""
    if result.entry.remarks:
        head = "" if result.entry.papers is not None else f"{NOT_MARKED}: "
        yield (head + "; ".join(result.entry.remarks),)
    for place, asked in enumerate(course.task.asked()):
        part, label = result.part(place), course.task.label(asked)
        if part.verdict.outcome == UNDECIDED:
            yield (*label, f": {UNDECIDED} on {part.text[:100]}")
        for remark in part.verdict.remarks if is_right_part(part) else ():
            if remark.kind == "chain":
                yield (*label, ": ", *remark.words, ", but the answer is right")
    yield from result.unmarked(course.task)


def hand_marks(course: MarkedClass) -> Iterator[Table]:
    """The marks that were given by hand, and why."""
    rows: list[tuple[Words, ...]] = []
    for result in course.results:
        for one in result.by_hand:
            most = course.task.tasks[one.asked[0]].points[one.asked[1]]
            rows.append(((result.name,), course.task.label(one.asked), (marks_of(one.marks, most),), (one.reason,)))
    if rows:
        yield Table(("student", "answer", "marks", "reason"), tuple(rows))


def students_table(course: MarkedClass, targets: tuple[str, ...]) -> Table:
    """Every student with the marks of each answer, on a sheet of each problem, and their sum."""
    if course.task.is_sheet:
        heads = [f"{task.number}. {task.name}" for task in course.task.tasks]
    else:
        heads = [course.task.heading(asked) for asked in course.task.asked()]
    rows: list[tuple[Words, ...]] = []
    for result in course.results:
        own = result.sheet.problems if course.task.is_sheet else result.sheet.parts
        marks = [marks_text(one.marks) if result.is_marked else "" for one in own]
        total = marks_of(result.sheet.marks, result.sheet.of) if result.is_marked else NOT_MARKED
        number = [result.student.number] if course.numbered else []
        rows.append(tuple((text,) for text in (result.name, *number, *marks, total)))
    return Table(("student", *(["number"] if course.numbered else []), *heads, "marks"), tuple(rows), targets)
