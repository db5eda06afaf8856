"""Student: the page of one student: every answer and every line of working with its verdict, and the marks."""

from __future__ import annotations

from rotsolve.grading.course.report.page import Judged, Judgements, Page, Paragraph, Section, Task, of
from rotsolve.grading.verdict import UNDECIDED, JudgedLine, JudgedPart, Marked, Verdict

FIRST = "wrong, here first"


def student_page(task: Task, marked: Marked, variant: str = "") -> Page:
    """The page of one student."""
    whose = ", ".join(filter(None, (marked.student, f"variant {variant}" if variant else "")))
    sections = [Section("", (Paragraph((whose,)),))] if whose else []
    sections.append(Section("Answers", (Judgements(tuple(judged(task, part) for part in marked.parts)),)))
    if marked.lines:
        numbered = tuple(working(number, line) for number, line in enumerate(marked.lines, 1))
        sections.append(Section("Working", (Judgements(numbered),)))
    sections.append(Section("Marks", (Paragraph((total(marked),)),)))
    return Page(task.title, tuple(sections))


def total(marked: Marked) -> str:
    """The sum of the marks, and how many answers have none yet."""
    open_ = sum(bool(part.text) and part.verdict.outcome == UNDECIDED for part in marked.parts)
    left = f", and {'an answer' if open_ == 1 else f'{open_} answers'} to be looked at" if open_ else ""
    return of(marked.marks, marked.of) + left


def judged(task: Task, part: JudgedPart) -> Judged:
    """One answer; of one that is missing there is no more to say."""
    label, marks = task.letter(part.name), of(part.marks, part.of)
    if not part.text:
        return Judged(label, "", Verdict(part.verdict.outcome), "no answer", marks)
    said = f"{part.verdict.outcome}, but followed through" if part.followed else part.verdict.outcome
    return Judged(label, part.text, part.verdict, said, marks)


def working(number: int, line: JudgedLine) -> Judged:
    """One line of working."""
    return Judged((str(number),), line.text, line.verdict, FIRST if line.first_wrong else line.verdict.outcome)
