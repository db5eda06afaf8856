"""Student: the page of one student: every answer and every line of working with its verdict, and the marks."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from typing import Any

from rotsolve.core.derivation import Words
from rotsolve.core.faults import printable
from rotsolve.grading.course.marked import MarkedSheet
from rotsolve.grading.course.questions import SheetTask, Task
from rotsolve.grading.course.students import Student
from rotsolve.grading.verdict import (
    NO_ANSWER,
    OPEN_OUTCOMES,
    RIGHT,
    WRONG,
    JudgedLine,
    JudgedPart,
    Marked,
    Verdict,
)
from rotsolve.page.blocks import (
    BAD,
    GOOD,
    OPEN,
    Answers,
    AssessedText,
    AssessedTexts,
    Note,
    Page,
    PageBlock,
    Paragraph,
    Phrase,
    Title,
)
from rotsolve.page.text import plain_text

TONES = {RIGHT: GOOD, WRONG: BAD, NO_ANSWER: BAD}
FIRST = "wrong, here first"


class StudentPage(Page, frozen=True):
    """What one student handed in, with its verdicts, problem by problem; with the right answers where the papers have them."""

    task: SheetTask
    sheet: MarkedSheet
    student: Student
    variant: str = ""
    called: str = ""  # where another student has the same name

    def whose(self) -> Iterator[str]:
        """What says whose the page is."""
        called, number = self.called or self.student.called, self.student.number
        yield from (called,) if called else ()
        yield from (f"number {number}",) if number and number not in called else ()
        yield from (f"variant {self.variant}",) if self.variant else ()

    def blocks(self) -> Iterator[PageBlock]:
        yield Title(1, (printable(self.task.title),))
        whose = ", ".join(self.whose())
        if whose:
            yield Paragraph((printable(whose),))
        for place, task in enumerate(self.task.tasks):
            yield from self.problem(place, task)
        if self.task.is_sheet:
            yield Title(2, ("Marks",))
            yield Paragraph((sum_of_marks(self.sheet),))

    def problem(self, place: int, task: Task) -> Iterator[PageBlock]:
        """One problem; of a scene alone, the sections of the page."""
        marked, below = self.sheet.problems[place], 3 if self.task.is_sheet else 2
        if self.task.is_sheet:
            yield Title(2, (printable(f"{task.number}. {task.title}"),))
        else:
            yield Title(2, ("Answers",))
        yield AssessedTexts(tuple(judged_answer(task, part) for part in marked.parts))
        if marked.lines:
            yield Title(below, ("Working",), minor=below > 2)
            yield AssessedTexts(tuple(judged_line(number, line) for number, line in enumerate(marked.lines, 1)))
        right = self.sheet.right[place] if self.sheet.right else ()
        if right:
            yield Title(below, ("Right answers",), minor=below > 2)
            yield Answers(tuple(row for answer in right for row in answer.rows))
        if self.task.is_sheet:
            yield Paragraph((f"Marks: {sum_of_marks(marked)}",))
        else:
            yield Title(2, ("Marks",))
            yield Paragraph((sum_of_marks(marked),))

    def data(self) -> dict[str, Any]:
        return {**title_data(self.task), **marked_data(self.task, self.sheet, self.student, self.variant)}


def sum_of_marks(marked: Marked | MarkedSheet) -> str:
    """The sum of the marks, and how many answers have none yet."""
    open_ = sum(part.verdict.outcome in OPEN_OUTCOMES for part in marked.parts)
    left = f", and {'an answer' if open_ == 1 else f'{open_} answers'} to be looked at" if open_ else ""
    return marks_of(marked.marks, marked.of) + left


def judged_answer(task: Task, part: JudgedPart) -> AssessedText:
    """One answer, with the label of its part on a sheet."""
    label = f"({task.labels[part.name]}) " if task.name and len(task.labels) > 1 else ""
    words = (label, *task.letter(part.name)) if label else task.letter(part.name)
    text = "" if part.verdict.outcome == NO_ANSWER else part.text
    return judged_text(words, text, part.verdict, part.verdict.outcome, marks_of(part.marks, part.of))


def judged_line(number: int, line: JudgedLine) -> AssessedText:
    """One line of working."""
    return judged_text((str(number),), line.text, line.verdict, FIRST if line.first_wrong else line.verdict.outcome)


def judged_text(label: Words, text: str, verdict: Verdict, said: str, marks: str = "") -> AssessedText:
    """A text with its verdict; nothing in it can move or colour a terminal."""
    notes = tuple(Note(printable_words(remark.words), remark.start, remark.end) for remark in verdict.remarks)
    tone, read_as = TONES.get(verdict.outcome, OPEN), printable(verdict.read_as)
    return AssessedText(printable_words(label), printable(text), tone, said, marks, notes, read_as)


def printable_words(words: Phrase) -> Phrase:
    """Words in which nothing can move or colour a terminal."""
    return tuple(printable(word) if isinstance(word, str) else word for word in words)


@cache
def marks_text(marks: Fraction) -> str:
    """Marks as a decimal number where that is exact, else to two places: `5`, `2.5`, `0.33`."""
    hundredths = round(marks * 100)
    text = f"{hundredths // 100}.{hundredths % 100:02d}" if hundredths >= 0 else f"-{marks_text(-marks)}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def marks_of(marks: Fraction, most: Fraction) -> str:
    """`2.5 of 5`."""
    return f"{marks_text(marks)} of {marks_text(most)}"


def title_data(task: SheetTask) -> dict[str, Any]:
    return {"sheet" if task.is_sheet else "problem": task.title}


def marked_data(task: SheetTask, sheet: MarkedSheet, student: Student, variant: str) -> dict[str, Any]:
    """The papers of a student: those of a sheet under `problems`, those to a scene by themselves."""
    whose = {"student": student.called, **({"number": student.number} if student.number else {}), "variant": variant}
    papers = [paper_data(sheet, place) for place in range(len(task.tasks))]
    if not task.is_sheet:
        return {**whose, **papers[0]}
    heads = [{"number": one.number, "name": one.name, "title": one.title} for one in task.tasks]
    problems = [{**head, **paper} for head, paper in zip(heads, papers, strict=True)]
    return {**whose, "problems": problems, "marks": marks_data(sheet.marks), "of": marks_data(sheet.of)}


def paper_data(sheet: MarkedSheet, place: int) -> dict[str, Any]:
    """The paper to one problem."""
    marked, right = sheet.problems[place], sheet.right[place] if sheet.right else ()
    lines = [
        {"text": line.text, **verdict_data(line.verdict), "first_wrong": line.first_wrong} for line in marked.lines
    ]
    told = [answer.data for answer in right]
    return {
        "answers": [part_data(part) for part in marked.parts],
        "working": lines,
        **({"right": told} if told else {}),
        "marks": marks_data(marked.marks),
        "of": marks_data(marked.of),
    }


def part_data(part: JudgedPart) -> dict[str, Any]:
    marks = {"marks": marks_data(part.marks), "of": marks_data(part.of), "followed": part.followed}
    return {"name": part.name, "text": part.text, **verdict_data(part.verdict), **marks}


def verdict_data(verdict: Verdict) -> dict[str, Any]:
    """Outcome, reading and remarks; columns count from 0, the end is the one behind the last."""
    remarks = [
        {"kind": remark.kind, "text": plain_text(remark.words), "start": remark.start, "end": remark.end}
        for remark in verdict.remarks
    ]
    return {"outcome": verdict.outcome, "read_as": verdict.read_as, "remarks": remarks}


def marks_data(marks: Fraction) -> dict[str, Any]:
    return {"exact": str(marks), "number": float(marks)}
