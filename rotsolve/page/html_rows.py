"""Rows of an HTML page: formulas, answers and assessed texts in tables; and the style sheets, which a page holds itself."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from urllib.parse import quote

from rotsolve.page.blocks import (
    CODE,
    AnswerRow,
    Answers,
    AssessedText,
    AssessedTexts,
    FormulaRow,
    Formulas,
    Table,
    unindented,
)
from rotsolve.page.mathml_lines import math_pieces
from rotsolve.page.printer import Printer

HEADING = re.compile(r"<h1>(.*?)</h1>")
HEAD = """\
<!DOCTYPE html>
<html lang="{}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
"""
STYLE = """\
body { font: 11.5pt/1.5 Georgia, "Times New Roman", serif; color: #111; background: #fff; }
body { max-width: 50em; margin: 1.5em auto; padding: 0 1em; }
math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", math; }
h1, h2, h3 { line-height: 1.25; break-after: avoid; }
h1 { font-size: 1.5em; margin: 0 0 .6em; }
h2 { font-size: 1.15em; margin: 1.3em 0 .4em; border-bottom: 1px solid #bbb; }
h3 { font-size: 1em; margin: 1em 0 .3em; }
p, ul { margin: .4em 0; }
table { border-collapse: collapse; margin: .3em 0; }
td { padding: .25em .6em .25em 0; vertical-align: baseline; }
td.left { text-align: right; padding-right: .25em; }
td.right { padding-right: 1.2em; }
td.said { color: #333; min-width: 8em; }
p.step { margin: .7em 0 .2em; break-after: avoid; }
p.line { margin: .1em 0 .1em 2em; padding: .2em 0 .2em 2em; text-indent: -2em; break-inside: avoid; }
p.line { overflow-x: auto; overflow-y: hidden; }
p.step.line { margin-left: 0; }
.line math, td.left math, td.right math { math-style: normal; }
.mark { float: right; padding-left: 1em; text-indent: 0; }
tr { break-inside: avoid; }
.wide { overflow-x: auto; }
.label { font-weight: bold; margin-right: .5em; }
.fault { font-weight: bold; color: #a00; }
article + article { break-before: page; border-top: 2px solid #888; margin-top: 3em; padding-top: 2em; }
@media print {
  body { margin: 0; max-width: none; font-size: 10.5pt; }
  .wide { overflow: visible; }
  article + article { border: 0; margin: 0; padding: 0; }
}
"""
ASSESSED_STYLE = """\
code { font: .95em/1.4 "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
td:not(.remark) > code { display: block; width: max-content; max-width: 32em; }
mark { background: #fff3a3; border-bottom: 2px solid #c80; }
th { text-align: left; padding: .25em .6em .25em 0; border-bottom: 1px solid #bbb; font-weight: normal; color: #555; }
td.part, td.verdict, td.marks { white-space: nowrap; }
td.verdict, td.marks { padding-left: 1em; }
td.marks { width: 100%; }
td.good { color: #060; } td.bad { color: #a00; font-weight: bold; } td.open { color: #850; font-weight: bold; }
td.remark { padding-top: 0; }
"""  # of pages with student's texts or tables
PICTURE_STYLE = """\
figure { margin: .6em 0 1em; break-inside: avoid; }
figure svg { max-width: 100%; height: auto; }
"""


class HtmlRows:
    """Sets blocks as tables."""

    def __init__(self, printer: Printer) -> None:
        self.printer, self.words, self.math = printer, printer.words, printer.math

    def formulas(self, block: Formulas) -> Iterator[str]:
        """A row for each equality: before the first stands where it comes from, the last has the number, which stands before a law."""
        yield f"<h{block.level}>{block.caption}</h{block.level}>"
        yield from (f"<p>{self.words(unindented(remark))}</p>" for remark in block.remarks)
        laws = [row for row in block.rows if row.numbered]
        yield from table_of(line for row in laws for line in self._law_rows(row))
        yield from (line for row in block.rows if not row.numbered for line in self._steps(row))

    def _law_rows(self, row: FormulaRow) -> Iterator[str]:
        """A law: its number, what it is called, and its sides in columns."""
        for number, (left, right) in enumerate(map(self.printer.sides, row.chain)):
            said = cell("" if number else self.words(row.words), "said")
            yield f"{cell(row.mark)}{said}{cell(self.math(left), 'left')}{cell(math_pieces(right), 'right')}"

    def _steps(self, row: FormulaRow) -> Iterator[str]:
        """A step: what is done, and below it, or beside it where it is one, its lines; the last has the number."""
        said = f"{self.words(row.words)}{'' if row.begins or not row.words else ':'}"
        if row.says_much:
            yield f'<p class="step">{said}</p>'
        for number, (left, right) in enumerate(map(self.printer.sides, row.chain)):
            right += "".join(map(self.printer.part, row.worth(number)))
            mark = f'<span class="mark">{row.mark}</span>' if row.mark and number == len(row.chain) - 1 else ""
            beside = f"{said} " if said and not row.says_much else ""
            kind = "step line" if beside else "line"
            yield f'<p class="{kind}">{mark}{beside}{math_pieces(left)} {math_pieces(right)}</p>'

    def answers(self, block: Answers) -> Iterator[str]:
        yield from table_of([line for row in block.rows for line in self._answer_rows(row)])

    def _answer_rows(self, row: AnswerRow) -> Iterator[str]:
        """An answer and its components; of a matrix the numbers stand below the exact entries."""
        symbol = f"{row.head}{self.math(self.printer.formula(row.symbol))}"
        said = cell(self.words(row.behind).removeprefix(", ").strip(), "said")
        sides = [cell(math_pieces(f"{self.printer.part('=')}{self.printer.part(form)}"), "right") for form in row.forms]
        if row.matrix:
            for number, side in enumerate(sides):
                last = number == len(sides) - 1
                yield f"{cell('' if number else symbol, 'left')}{side}{cell('')}{said if last else ''}"
            return
        yield f"{cell(symbol, 'left')}{''.join([*sides, *[cell('', 'right')] * 2][:2])}{said}"
        for component in row.components:
            yield from self._answer_rows(component)

    def table(self, block: Table) -> Iterator[str]:
        """A table; the first cells are links where they lead to files."""
        rows = ["".join(f"<th>{self.printer.prose(column)}</th>" for column in block.columns)]
        for row, target in zip(block.rows, block.targets or ("",) * len(block.rows), strict=True):
            first, *others = map(self.words, row)
            link = f'<a href="{quote(target)}">{first}</a>' if target else first
            rows.append("".join(f"<td>{cell}</td>" for cell in (link, *others)))
        yield from table_of(rows)

    def assessed(self, block: AssessedTexts) -> Iterator[str]:
        """A text with what is thought of it, and below it what is said of it."""
        rows = []
        for row in block.rows:
            thought = cell(self.printer.prose(row.said), f"verdict {row.tone}") + cell(row.marks, "marks")
            rows.append(f"{cell(self.words(row.label), 'part')}<td><code>{self._marked(row)}</code></td>{thought}")
            remarks = [self.words(note.words) for note in row.notes]
            remarks += [f"read as {self.printer.styled(CODE, row.read_as)}"] if row.read_as else []
            rows += [f'<td></td><td class="remark" colspan="3">{remark}</td>' for remark in remarks]
        yield from table_of(rows)

    def _marked(self, row: AssessedText) -> str:
        """The text with the columns of the first note that has any marked."""
        before, inside, after = map(self.printer.prose, row.divided)
        return f"{before}<mark>{inside}</mark>{after}" if inside else before + after


def cell(inner: str, kind: str = "") -> str:
    return f'<td class="{kind}">{inner}</td>' if kind else f"<td>{inner}</td>"


def table_of(rows: Iterable[str]) -> Iterator[str]:
    """Rows with their columns aligned; a wide table can be scrolled by itself."""
    found = [f"<tr>{row}</tr>" for row in rows]
    if found:
        yield from ('<div class="wide"><table>', *found, "</table></div>")


def whole_page(bodies: Sequence[str], language: str, paper: str = "") -> str:
    """A page of several articles, with its style sheet, and the title of the first; for a paper with the number on each page."""
    found = HEADING.search(bodies[0]) if bodies else None
    assessed = any("<th>" in body or "<code>" in body for body in bodies)
    style = f"{STYLE}{ASSESSED_STYLE if assessed else ''}"
    style += PICTURE_STYLE if any("<figure>" in body for body in bodies) else ""
    if paper:
        from rotsolve.page.sheet_html import paper_style

        style += paper_style(paper, len(bodies))
    title = found[1] if found else "rotsolve"
    return f"{HEAD.format(language)}<title>{title}</title>\n<style>\n{style}</style>\n</head>\n<body>\n{''.join(bodies)}</body>\n</html>\n"


def notebook_piece(body: str) -> str:
    """A body within a page of others, as a notebook is one: its style sheet holds for it alone."""
    rules = [
        line for line in f"{STYLE}{ASSESSED_STYLE}{PICTURE_STYLE}".splitlines() if "{ " in line and line[0] not in " @"
    ]
    own = [rule.replace("body {", "& {") for rule in rules]
    return f'<div class="rotsolve"><style>\n.rotsolve {{\n{chr(10).join(own)}\n}}\n</style>\n{body}</div>\n'
