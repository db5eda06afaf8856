"""Student: the page of one student: every answer and every line of working with its verdict, and the marks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.core.derivation import Words
from rotsolve.core.faults import printable
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, JudgedLine, JudgedPart, Marked, Verdict
from rotsolve.page.blocks import (
    BAD,
    GOOD,
    OPEN,
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

TONES = {RIGHT: GOOD, WRONG: BAD}
FIRST = "wrong, here first"


class Task(Struct, frozen=True):
    """The problem that is marked: its title, and what is asked by name with the letter that is printed for it.

    `parts` are the names of the components of vectors in space, each with that of the vector.
    """

    title: str
    letters: Mapping[str, Formula]
    parts: Mapping[str, str] = {}

    def letter(self, name: str) -> Words:
        return (self.letters[name],) if name in self.letters else (name,)


class StudentPage(Page, frozen=True):
    """What one student handed in, with its verdicts."""

    task: Task
    marked: Marked
    variant: str = ""

    def blocks(self) -> Iterator[PageBlock]:
        yield Title(1, (printable(self.task.title),))
        whose = ", ".join(filter(None, (self.marked.student, f"variant {self.variant}" if self.variant else "")))
        if whose:
            yield Paragraph((printable(whose),))
        yield Title(2, ("Answers",))
        yield AssessedTexts(tuple(judged_answer(self.task, part) for part in self.marked.parts))
        if self.marked.lines:
            yield Title(2, ("Working",))
            yield AssessedTexts(tuple(judged_line(number, line) for number, line in enumerate(self.marked.lines, 1)))
        yield Title(2, ("Marks",))
        yield Paragraph((sum_of_marks(self.marked),))

    def data(self) -> dict[str, Any]:
        return {"problem": self.task.title, **marked_data(self.marked, self.variant)}


def sum_of_marks(marked: Marked) -> str:
    """The sum of the marks, and how many answers have none yet."""
    open_ = sum(bool(part.text) and part.verdict.outcome == UNDECIDED for part in marked.parts)
    left = f", and {'an answer' if open_ == 1 else f'{open_} answers'} to be looked at" if open_ else ""
    return marks_of(marked.marks, marked.of) + left


def judged_answer(task: Task, part: JudgedPart) -> AssessedText:
    """One answer; of one that is missing there is no more to say."""
    label, marks = task.letter(part.name), marks_of(part.marks, part.of)
    if not part.text:
        return judged_text(label, "", Verdict(part.verdict.outcome), "no answer", marks)
    said = f"{part.verdict.outcome}, but followed through" if part.followed else part.verdict.outcome
    return judged_text(label, part.text, part.verdict, said, marks)


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


def marked_data(marked: Marked, variant: str) -> dict[str, Any]:
    return {
        "student": marked.student,
        "variant": variant,
        "answers": [part_data(part) for part in marked.parts],
        "working": [
            {"text": line.text, **verdict_data(line.verdict), "first_wrong": line.first_wrong} for line in marked.lines
        ],
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
