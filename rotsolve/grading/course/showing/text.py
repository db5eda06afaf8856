"""Text: a page at a fixed width, its lines with the roles that a terminal may colour."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.core.derivation import Words
from rotsolve.core.faults import printable
from rotsolve.grading.course.report.page import Judged, Judgements, Page, Paragraph, Section, Table
from rotsolve.grading.verdict import RIGHT, WRONG, Remark
from rotsolve.render import layout
from rotsolve.render.layout import GAP, Line, paragraph, release
from rotsolve.render.voice import TEXT

ROLES = {RIGHT: "answer", WRONG: "fault"}
INDENT = 2


def lines(page: Page, width: int) -> Iterator[Line]:
    """The page line by line."""
    yield from paragraph(printable(page.title), 0, width, "title")
    for section in page.sections:
        yield Line("")
        if section.heading:
            yield Line(section.heading, "heading")
        yield from section_lines(section, width)


def said(words: Words) -> str:
    """Words on a terminal, which nothing in them can move or colour."""
    return TEXT.words(tuple(printable(word) if isinstance(word, str) else word for word in words))


def section_lines(section: Section, width: int) -> Iterator[Line]:
    indent = INDENT if section.heading else 0
    for block in section.blocks:
        match block:
            case Judgements():
                yield from judgement_lines(block, width)
            case Paragraph():
                yield from paragraph(said(block.words), indent, width)
            case Table():
                yield from table_lines(block, width)


def judgement_lines(block: Judgements, width: int) -> Iterator[Line]:
    """The texts of the student below each other, each with its verdict behind it and what is said of it below."""
    labels = [release(said(item.label)) for item in block.items]
    start = INDENT + max(map(len, labels)) + 3
    beside = max(len(item.said) for item in block.items)
    marks = max(len(item.marks) for item in block.items)
    room = max(20, width - start - GAP - beside - (GAP + marks if marks else 0))
    behind = start + min(room, max(len(shown(item.text, room)[0]) for item in block.items)) + GAP
    for label, item in zip(labels, block.items, strict=True):
        text, first = shown(item.text, room, item.verdict.remarks[0] if item.verdict.remarks else None)
        head = f"{' ' * INDENT}{label}".ljust(start) + text
        verdict = f"{item.said.ljust(beside)}{' ' * GAP}{item.marks.rjust(marks)}".rstrip()
        yield Line(head.ljust(behind) + verdict, ROLES.get(item.verdict.outcome, "doubt"))
        yield from remark_lines(item, start, room, width, first)


def remark_lines(item: Judged, start: int, room: int, width: int, first: int) -> Iterator[Line]:
    """How the text was read, and each remark below the columns that it speaks of."""
    after = first
    for remark in item.verdict.remarks:
        if remark.start is not None:
            text, begin = shown(item.text, room, remark)
            if begin != after:
                yield Line(" " * start + text)
            yield Line(" " * start + caret(remark, begin, text))
        yield from paragraph(said(remark.words), start, width)
        after = -1
    if item.verdict.read_as:
        yield from paragraph(f"read as {item.verdict.read_as}", start, width)


def caret(remark: Remark, begin: int, text: str) -> str:
    """Carets below the columns of a remark, in a text that is shown from the column `begin` on."""
    assert remark.start is not None
    at = remark.start - begin + (1 if begin else 0)
    length = max(1, (remark.end or remark.start + 1) - remark.start)
    return " " * at + "^" * max(1, min(length, len(text) - at))


def shown(text: str, room: int, remark: Remark | None = None) -> tuple[str, int]:
    """The text on one line, clipped around the columns of a remark where it is long; and the column at which it begins."""
    plain = printable(text)
    if len(plain) <= room:
        return plain, 0
    wanted = remark.start if remark is not None and remark.start is not None else 0
    begin = 0 if wanted < room * 2 // 3 else min(wanted - room // 3, len(plain) - room + 2)
    end = begin + room - (2 if begin else 1)
    return f"{'…' if begin else ''}{plain[begin:end]}{'…' if end < len(plain) else ''}", begin


def table_lines(table: Table, width: int) -> Iterator[Line]:
    """Aligned columns; a last column that is too long goes on below."""
    cells = [[release(said(cell)) for cell in row] for row in table.rows]
    sizes = [max(map(len, column)) for column in zip(table.columns, *cells, strict=True)]
    last = INDENT + sum(sizes[:-1]) + 3 * (len(sizes) - 1)
    for number, row in enumerate([list(table.columns), *cells]):
        head = "".join(cell.ljust(size + 3) for cell, size in zip(row[:-1], sizes, strict=False))
        first, *more = (line.text for line in paragraph(row[-1], 0, max(20, width - last)))
        yield Line(f"{' ' * INDENT}{head}{first}".rstrip(), "check" if number == 0 else "")
        yield from (Line(" " * last + part) for part in more)


def document(page: Page) -> str:
    """The page as a file of plain text."""
    return layout.page(lines(page, layout.WIDTH))
