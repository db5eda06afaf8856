"""HTML: a page with the columns that a remark speaks of marked in the student's text, and formulas as MathML."""

from __future__ import annotations

from collections.abc import Iterator
from urllib.parse import quote

from rotsolve.core.derivation import Words
from rotsolve.core.faults import printable
from rotsolve.grading.course.report.page import Judged, Judgements, Page, Paragraph, Section, Table
from rotsolve.grading.verdict import RIGHT, WRONG, Verdict
from rotsolve.render import html
from rotsolve.render.prose import HTML

LONGEST = 500  # characters of a student's text that are shown
STYLE = """\
code { font: .95em/1.4 "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
td:not(.remark) > code { display: block; width: max-content; max-width: 32em; }
mark { background: #fff3a3; border-bottom: 2px solid #c80; }
th { text-align: left; padding: .25em .6em .25em 0; border-bottom: 1px solid #bbb; font-weight: normal; color: #555; }
td.verdict, td.marks { white-space: nowrap; padding-left: 1em; }
td.marks { width: 100%; }
td.good { color: #060; } td.bad { color: #a00; font-weight: bold; } td.open { color: #850; font-weight: bold; }
td.remark { padding-top: 0; }
"""
CLASSES = {RIGHT: "good", WRONG: "bad"}


def document(page: Page) -> str:
    """The page as a file."""
    return html.page(plain(page.title), (html.article(lines(page)),), STYLE)


def lines(page: Page) -> Iterator[str]:
    """The page line by line."""
    yield f"<h1>{plain(page.title)}</h1>"
    for section in page.sections:
        if section.heading:
            yield f"<h2>{section.heading}</h2>"
        yield from section_lines(section)


def section_lines(section: Section) -> Iterator[str]:
    for block in section.blocks:
        match block:
            case Judgements():
                yield from html.table(row for item in block.items for row in judged_rows(item))
            case Paragraph():
                yield f"<p>{said(block.words)}</p>"
            case Table():
                yield from table_rows(block)


def judged_rows(item: Judged) -> Iterator[str]:
    """A text of the student with its verdict, and below it what is said of it."""
    kind = CLASSES.get(item.verdict.outcome, "open")
    behind = f'<td class="verdict {kind}">{plain(item.said)}</td><td class="marks">{item.marks}</td>'
    yield f"<td>{said(item.label)}</td><td><code>{marked(item.text, item.verdict)}</code></td>{behind}"
    remarks = [said(remark.words) for remark in item.verdict.remarks]
    if item.verdict.read_as:
        remarks.append(f"read as <code>{plain(item.verdict.read_as)}</code>")
    yield from (f'<td></td><td class="remark" colspan="3">{remark}</td>' for remark in remarks)


def marked(text: str, verdict: Verdict) -> str:
    """The text with the columns of the first remark that has any marked."""
    shown = printable(text)
    shown = shown if len(shown) <= LONGEST else shown[: LONGEST - 1] + "…"
    for remark in verdict.remarks:
        if remark.start is not None and remark.start < len(shown):
            end = max(remark.start + 1, remark.end or 0)
            before, inside, after = shown[: remark.start], shown[remark.start : end], shown[end:]
            return f"{plain(before)}<mark>{plain(inside)}</mark>{plain(after)}"
    return plain(shown)


def table_rows(table: Table) -> Iterator[str]:
    """A table; the first cells are links where they lead to files."""
    head = "".join(f"<th>{plain(column)}</th>" for column in table.columns)
    targets = table.targets or ("",) * len(table.rows)
    rows = [cells(row, target) for row, target in zip(table.rows, targets, strict=True)]
    yield from html.table([head, *rows])


def cells(row: tuple[Words, ...], target: str) -> str:
    first, *others = (said(cell) for cell in row)
    link = f'<a href="{quote(target)}">{first}</a>' if target else first
    return "".join(f"<td>{cell}</td>" for cell in (link, *others))


def said(words: Words) -> str:
    """Words in which nothing is markup."""
    return HTML.words(tuple(printable(word) if isinstance(word, str) else word for word in words))


def plain(text: str) -> str:
    return HTML.prose(printable(text))
