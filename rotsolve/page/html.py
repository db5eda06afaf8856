"""HTML: a page that a browser shows without a network or a script, its formulas as MathML, its style sheet within, fit for printing."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, ClassVar
from urllib.parse import quote

from rotsolve.algebra.notation import mathml
from rotsolve.page import blocks
from rotsolve.page.blocks import CODE, FAULT, LABEL, NAME, STRONG, AnswerRow, Answers, Bullets, Formulas, JudgedTexts
from rotsolve.page.printer import Lines, Printer
from rotsolve.page.style import JUDGED_STYLE, STYLE

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.algebra.units.unit_table import Unit

SPECIAL = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;"})
HEADING = re.compile(r"<h1>(.*?)</h1>")
HEAD = """\
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
"""


class Html(Printer):
    """Pages as HTML."""

    blank = '<mspace width="0.22em"></mspace>'
    relations: ClassVar = {sign: f"<mo>{sign.translate(SPECIAL)}</mo>" for sign in "=≤≥<>≈≠"}
    styles: ClassVar = {
        NAME: "<b>{}</b>",
        LABEL: '<span class="label">{}</span>',
        STRONG: "<b>{}</b>",
        FAULT: '<span class="fault">{}</span>',
        CODE: "<code>{}</code>",
    }

    def prose(self, text: str) -> str:
        return text.translate(SPECIAL)

    def formula(self, formula: Formula) -> str:
        return mathml.mathml(formula)

    def unit(self, unit: Unit) -> str:
        return mathml.unit(unit.text)

    def number(self, mantissa: str, exponent: str) -> str:
        digits = mantissa.lstrip("-−")
        said = f"<mn>{digits}</mn>" if digits == mantissa else f"<mrow><mo>−</mo><mn>{digits}</mn></mrow>"
        power = f"<msup><mn>10</mn>{self.number(exponent, '')}</msup>" if exponent else ""
        return f"<mrow>{said}<mo>×</mo>{power}</mrow>" if power else said

    def math(self, inner: str) -> str:
        return f"<math>{inner}</math>" if inner else ""

    def bracketed(self, rows: Sequence[Sequence[str]]) -> str:
        body = "".join(f"<mtr>{''.join(f'<mtd>{cell}</mtd>' for cell in row)}</mtr>" for row in rows)
        return f"<mrow><mo>(</mo><mtable>{body}</mtable><mo>)</mo></mrow>"

    def own(self) -> dict[type[blocks.PageBlock], Callable[..., Lines]]:
        return super().own() | {Formulas: self.formulas, Answers: self.answers, JudgedTexts: self.judged}

    def title(self, block: blocks.Title) -> Iterator[str]:
        yield f"<h{block.level}>{self.words(block.words)}</h{block.level}>"

    def paragraph(self, block: blocks.Paragraph) -> Iterator[str]:
        yield f"<p>{self.words(block.words)}</p>"

    def bullets(self, block: Bullets) -> Iterator[str]:
        yield "<ul>"
        for item in block.items:
            code = f"<pre>{self.prose(chr(10).join(item.code))}</pre>" if item.code else ""
            inner = "\n".join(("", *self.bullets(Bullets(item.inner)))) if item.inner else ""
            yield f"<li>{self.words(item.words)}{code}{inner}</li>"
        yield "</ul>"

    def table(self, block: blocks.Table) -> Iterator[str]:
        """A table; the first cells are links where they lead to files."""
        rows = ["".join(f"<th>{self.prose(column)}</th>" for column in block.columns)]
        for row, target in zip(block.rows, block.targets or ("",) * len(block.rows), strict=True):
            first, *others = map(self.words, row)
            link = f'<a href="{quote(target)}">{first}</a>' if target else first
            rows.append("".join(f"<td>{cell}</td>" for cell in (link, *others)))
        yield from table_of(rows)

    def formulas(self, block: Formulas) -> Iterator[str]:
        """A row for each equality: the first says where it comes from, the last has the number, which stands before a law."""
        yield from self.title(blocks.Title(block.level, (block.caption,)))
        for remark in block.remarks:
            yield from self.paragraph(blocks.Paragraph(remark))
        rows = []
        for row in block.rows:
            for number, (left, right) in enumerate(map(self.sides, row.chain)):
                said = cell("→", "then") if number else cell(self.words(row.words), "said")
                mark = cell(row.mark if row.numbered or number == len(row.chain) - 1 else "")
                formulas = cell(self.math(left), "left") + cell(self.math(right), "right")
                rows.append(f"{mark}{said}{formulas}" if row.numbered else f"{said}{formulas}{mark}")
        yield from table_of(rows)

    def answers(self, block: Answers) -> Iterator[str]:
        yield from table_of([line for row in block.rows for line in self._answer_rows(row)])

    def _answer_rows(self, row: AnswerRow) -> Iterator[str]:
        """An answer and its components; of a matrix the numbers stand below the exact entries."""
        symbol = self.math(self.formula(row.symbol))
        said = cell(self.words(row.behind).removeprefix(", ").strip(), "said")
        sides = [cell(self.math(f"{self.part('=')}{self.part(form)}"), "right") for form in row.forms]
        if row.matrix:
            for number, side in enumerate(sides):
                last = number == len(sides) - 1
                yield f"{cell('' if number else symbol, 'left')}{side}{cell('')}{said if last else ''}"
            return
        yield f"{cell(symbol, 'left')}{''.join([*sides, *[cell('', 'right')] * 2][:2])}{said}"
        for component in row.components:
            yield from self._answer_rows(component)

    def judged(self, block: JudgedTexts) -> Iterator[str]:
        """A text with what is thought of it, and below it what is said of it."""
        rows = []
        for row in block.rows:
            thought = cell(self.prose(row.said), f"verdict {row.tone}") + cell(row.marks, "marks")
            rows.append(f"{cell(self.words(row.label))}<td><code>{self._marked(row)}</code></td>{thought}")
            remarks = [self.words(note.words) for note in row.notes]
            remarks += [f"read as {self.styled(CODE, row.read_as)}"] if row.read_as else []
            rows += [f'<td></td><td class="remark" colspan="3">{remark}</td>' for remark in remarks]
        yield from table_of(rows)

    def _marked(self, row: blocks.JudgedText) -> str:
        """The text with the columns of the first note that has any marked."""
        text = blocks.clipped(row.text)
        start, end = next((note.columns for note in row.notes if note.columns and note.columns[0] < len(text)), (0, 0))
        before, inside, after = (self.prose(part) for part in (text[:start], text[start:end], text[end:]))
        return f"{before}<mark>{inside}</mark>{after}" if end else before + after

    def body(self, page: blocks.Page, width: int) -> str:
        """The page as an article, which is printed on a sheet of its own."""
        return f"<article>\n{super().body(page, width)}</article>\n"

    def document(self, bodies: Sequence[str]) -> str:
        """A page of several articles; it has the title of the first."""
        found = HEADING.search(bodies[0]) if bodies else None
        judged = any("<th>" in body or "<code>" in body for body in bodies)
        style = f"{STYLE}{JUDGED_STYLE if judged else ''}"
        title = found[1] if found else "rotsolve"
        return f"{HEAD}<title>{title}</title>\n<style>\n{style}</style>\n</head>\n<body>\n{''.join(bodies)}</body>\n</html>\n"


def cell(inner: str, kind: str = "") -> str:
    return f'<td class="{kind}">{inner}</td>' if kind else f"<td>{inner}</td>"


def table_of(rows: Iterable[str]) -> Iterator[str]:
    """Rows with their columns aligned; a wide table can be scrolled by itself."""
    found = [f"<tr>{row}</tr>" for row in rows]
    if found:
        yield from ('<div class="wide"><table>', *found, "</table></div>")


PRINTER = Html()
