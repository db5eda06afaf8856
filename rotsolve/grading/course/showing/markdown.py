"""Markdown: a page with the student's texts as code, carets below the columns that a remark speaks of, and formulas as LaTeX."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rotsolve.core.derivation import Words
from rotsolve.core.faults import printable
from rotsolve.grading.course.report.page import Judged, Judgements, Page, Paragraph, Section, Table
from rotsolve.grading.verdict import RIGHT, Remark
from rotsolve.render.voice import MARKDOWN

LONGEST = 500  # characters of a student's text that are shown


def document(page: Page) -> str:
    """The page as a file."""
    return "\n".join(lines(page)) + "\n"


def lines(page: Page) -> Iterator[str]:
    """The page line by line."""
    yield f"# {MARKDOWN.prose(printable(page.title))}"
    for section in page.sections:
        if section.heading:
            yield from ("", f"## {section.heading}")
        yield from section_lines(section)


def section_lines(section: Section) -> Iterator[str]:
    for block in section.blocks:
        yield ""
        match block:
            case Judgements():
                for item in block.items:
                    yield from judged_lines(item)
            case Paragraph():
                yield said(block.words)
            case Table():
                yield from table_lines(block)


def judged_lines(item: Judged) -> Iterator[str]:
    """A text of the student with its verdict, and what is said of it as a list within the list."""
    marks = f", {item.marks}" if item.marks else ""
    outcome = item.said if item.verdict.outcome == RIGHT else f"**{item.said}**"
    yield (
        f"- {said(item.label)}: {code(item.text)} — {outcome}{marks}"
        if item.text
        else f"- {said(item.label)}: {outcome}{marks}"
    )
    for remark in item.verdict.remarks:
        yield f"  - {said(remark.words)}"
        yield from caret_lines(item.text, remark)
    if item.verdict.read_as:
        yield f"  - read as {code(item.verdict.read_as)}"


def caret_lines(text: str, remark: Remark) -> Iterator[str]:
    """The text with carets below the columns of a remark."""
    if remark.start is None or not text or len(text) > LONGEST:
        return
    length = max(1, (remark.end or remark.start + 1) - remark.start)
    fence = "`" * max(3, longest_run(text) + 1)
    yield from (
        "",
        f"    {fence}text",
        f"    {printable(text)}",
        f"    {' ' * remark.start}{'^' * length}",
        f"    {fence}",
    )


def code(text: str) -> str:
    """The text as code, between as many backquotes as it takes."""
    plain = printable(text)
    shown = plain if len(plain) <= LONGEST else plain[: LONGEST - 1] + "…"
    fence = "`" * (longest_run(shown) + 1)
    blank = " " if shown.startswith("`") or shown.endswith("`") else ""
    return f"{fence}{blank}{shown}{blank}{fence}"


def longest_run(text: str) -> int:
    return max(map(len, re.findall("`+", text)), default=0)


def table_lines(table: Table) -> Iterator[str]:
    """A table; the first cells are links where they lead to files."""
    yield f"| {' | '.join(MARKDOWN.prose(column) for column in table.columns)} |"
    yield "|" + " --- |" * len(table.columns)
    targets = table.targets or ("",) * len(table.rows)
    for row, target in zip(table.rows, targets, strict=True):
        first, *others = (said(cell) for cell in row)
        yield f"| {' | '.join([f'[{first}](<{target}>)' if target else first, *others])} |"


def said(words: Words) -> str:
    """Words in which nothing is markup, on one line."""
    return MARKDOWN.words(tuple(printable(word) if isinstance(word, str) else word for word in words))
