"""Plain text: pages as a textbook sets them, in aligned columns of letters, each line with the role that a terminal may colour it by."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from rotsolve.algebra.notation.text import to_text
from rotsolve.page import text_rows
from rotsolve.page.blocks import (
    LABEL,
    AnswerRow,
    Answers,
    Bullet,
    Bullets,
    Checks,
    Formulas,
    JudgedTexts,
    Labels,
    Listing,
    Page,
    PageBlock,
    Paragraph,
    Phrase,
    Table,
    Title,
)
from rotsolve.page.columns import SEPARATOR, TextLine, boxed, hold, page_text, paragraph_lines, release
from rotsolve.page.printer import Printer, simplified

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.algebra.units.unit_table import Unit

RAISED = str.maketrans("+-−0123456789", "⁺⁻⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


class PlainText(Printer):
    """Pages as plain text; blanks within mathematics are held, so that no line is broken there."""

    styles: ClassVar = {LABEL: "{}: "}

    def prose(self, text: str) -> str:
        return text

    def formula(self, formula: Formula) -> str:
        return to_text(formula)

    def unit(self, unit: Unit) -> str:
        return unit.text

    def number(self, mantissa: str, exponent: str) -> str:
        mantissa = mantissa.replace("-", "−")
        return f"{mantissa}×10{exponent.translate(RAISED)}" if exponent else mantissa

    def math(self, inner: str) -> str:
        return hold(inner)

    def bracketed(self, rows: Sequence[Sequence[str]]) -> str:
        return "\n".join(boxed(rows))

    def in_columns(self) -> dict[type[PageBlock], Callable[[Any, int, int], Iterator[TextLine]]]:
        """How each block is set, from a column on, on a page of some width."""
        rows = text_rows.Rows(self)
        return {
            Title: self.title_lines,
            Paragraph: lambda block, indent, width: paragraph_lines(self.words(block.words), indent, width),
            Bullets: self.bullet_lines,
            Table: rows.table,
            Labels: rows.labels,
            Listing: rows.listing,
            Formulas: rows.formulas,
            Answers: rows.answers,
            Checks: rows.checks,
            JudgedTexts: rows.judged,
        }

    def lines(self, page: Page, width: int) -> list[TextLine]:
        """The page line by line."""
        found: list[TextLine] = []
        indent, own = 0, self.in_columns()
        for block in text_rows.merged(simplified(page.blocks(), own.keys())):
            if isinstance(block, Title) and block.level > 1:
                indent = 2
                found += [TextLine("")] if page.spaced and found and found[-1].text else []
            found += own[type(block)](block, indent, width)
        return found

    def title_lines(self, block: Title, indent: int, width: int) -> Iterator[TextLine]:
        """A heading; that of the page has a blank line below it."""
        first = block.level == 1
        yield from paragraph_lines(
            self.words(block.words), max(0, 2 * block.level - 4), width, "title" if first else "heading"
        )
        yield from [TextLine("")] if first else []

    def bullet_lines(self, block: Bullets, indent: int, width: int) -> Iterator[TextLine]:
        """A list, its items marked by dashes."""
        for item in block.items:
            yield from self._bullet(item, indent, width)

    def _bullet(self, item: Bullet, indent: int, width: int) -> Iterator[TextLine]:
        for number, line in enumerate(paragraph_lines(self.words(item.words), 0, width - indent - 2)):
            yield TextLine(f"{' ' * indent}{' ' if number else '-'} {line.text}")
        for inner in item.inner:
            yield from self._bullet(inner, indent + 2, width)
        yield from (TextLine(" " * (indent + 2) + line) for line in item.code)

    def body(self, page: Page, width: int) -> str:
        return page_text(self.lines(page, width)).rstrip("\n") + "\n"

    def document(self, bodies: Sequence[str]) -> str:
        """Pages one below the other."""
        return f"\n{SEPARATOR}\n\n".join(bodies)


def answer_text(row: AnswerRow) -> str:
    """An answer alone, its components below it."""
    return "\n".join(release(f"{line.left} {line.middle}") for line in text_rows.Rows(PRINTER).answer_rows(row))


def plain_text(phrase: Phrase) -> str:
    """Words as text, on one line."""
    return release(PRINTER.words(phrase))


PRINTER = PlainText()
