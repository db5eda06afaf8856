"""Plain text: pages as a textbook sets them, in aligned columns of letters, each line with the role that a terminal may colour it by."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rotsolve.algebra.notation.text import to_text
from rotsolve.page import text_rows
from rotsolve.page.blocks import AnswerRow, Page, Phrase, Title
from rotsolve.page.columns import SEPARATOR, TextLine, boxed, hold, page_text, release
from rotsolve.page.printer import Printer, simplified

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.algebra.units.unit_table import Unit

RAISED = str.maketrans("+-−0123456789", "⁺⁻⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


class PlainText(Printer):
    """Pages as plain text; blanks within mathematics are held, so that no line is broken there."""

    def prose(self, text: str) -> str:
        return text

    def formula(self, formula: Formula) -> str:
        return self.numerals(to_text(formula))

    def unit(self, unit: Unit) -> str:
        return unit.text

    def number(self, mantissa: str, exponent: str) -> str:
        mantissa = self.numerals(mantissa.replace("-", "−"))
        return f"{mantissa}×10{exponent.translate(RAISED)}" if exponent else mantissa

    def math(self, inner: str) -> str:
        return hold(inner)

    def bracketed(self, rows: Sequence[Sequence[str]]) -> str:
        return "\n".join(boxed(rows))

    def lines(self, page: Page, width: int) -> list[TextLine]:
        """The page line by line."""
        found: list[TextLine] = []
        indent, own = 0, text_rows.TextRows(self).own()
        for block in text_rows.merged(simplified(page.blocks(), own.keys())):
            if isinstance(block, Title) and block.level > 1:
                indent = 2
                found += [TextLine("")] if page.spaced and found and found[-1].text else []
            found += own[type(block)](block, indent, width)
        return found

    def body(self, page: Page, width: int) -> str:
        return page_text(self.lines(page, width)).rstrip("\n") + "\n"

    def document(self, bodies: Sequence[str]) -> str:
        """Pages one below the other."""
        return f"\n{SEPARATOR}\n\n".join(bodies)


def answer_text(row: AnswerRow) -> str:
    """An answer alone, its components below it."""
    return "\n".join(release(f"{line.left} {line.middle}") for line in text_rows.TextRows(PRINTER).answer_rows(row))


def plain_text(phrase: Phrase) -> str:
    """Words as text, on one line."""
    return release(PRINTER.words(phrase))


PRINTER = PlainText()
