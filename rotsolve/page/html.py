"""HTML: a page that a browser shows without a network or a script, its formulas as MathML, its style sheet within, fit for printing."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, ClassVar

from rotsolve.algebra.notation import mathml
from rotsolve.page import blocks
from rotsolve.page.blocks import BOLD, BOTH, CODE, FAULT, ITALIC, LABEL, NAME, STRONG, Bullets
from rotsolve.page.html_rows import HtmlRows, whole_page
from rotsolve.page.pictures import drawn, picture_in_svg
from rotsolve.page.printer import Lines, Printer
from rotsolve.page.sheet_html import HtmlSheets

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.algebra.units.unit_table import Unit

SPECIAL = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;"})


class Html(Printer):
    """Pages as HTML."""

    decimals = r"\.(?=\d+</mn>)"  # of numbers alone: widths of blanks have a point in all languages
    blank = '<mspace width="0.22em"></mspace>'
    relations: ClassVar = {sign: f"<mo>{sign.translate(SPECIAL)}</mo>" for sign in "=≤≥<>≈≠→≪≫±"}
    styles: ClassVar = {
        NAME: "<b>{}</b>",
        LABEL: '<span class="label">{}</span>',
        STRONG: "<b>{}</b>",
        FAULT: '<span class="fault">{}</span>',
        CODE: "<code>{}</code>",
        BOLD: "<b>{}</b>",
        ITALIC: "<i>{}</i>",
        BOTH: "<b><i>{}</i></b>",
    }

    def prose(self, text: str) -> str:
        return text.translate(SPECIAL)

    def formula(self, formula: Formula) -> str:
        return self.numerals(mathml.mathml(formula))

    def unit(self, unit_to_mathml: Unit) -> str:
        return mathml.unit_to_mathml(unit_to_mathml.text)

    def number(self, mantissa: str, exponent: str) -> str:
        digits = mantissa.lstrip("-−")
        said = f"<mn>{digits}</mn>" if digits == mantissa else f"<mrow><mo>−</mo><mn>{digits}</mn></mrow>"
        power = f"<msup><mn>10</mn>{self.number(exponent, '')}</msup>" if exponent else ""
        return self.numerals(f"<mrow>{said}<mo>×</mo>{power}</mrow>" if power else said)

    def math(self, inner: str) -> str:
        return f"<math>{inner}</math>" if inner else ""

    def bracketed(self, rows: Sequence[Sequence[str]]) -> str:
        body = "".join(f"<mtr>{''.join(f'<mtd>{cell}</mtd>' for cell in row)}</mtr>" for row in rows)
        return f"<mrow><mo>(</mo><mtable>{body}</mtable><mo>)</mo></mrow>"

    def own(self) -> dict[type[blocks.PageBlock], Callable[..., Lines]]:
        rows = HtmlRows(self)
        return (
            super().own()
            | HtmlSheets(self).own()
            | drawn(picture_in_svg)
            | {
                blocks.Table: rows.table,
                blocks.Formulas: rows.formulas,
                blocks.Answers: rows.answers,
                blocks.AssessedTexts: rows.assessed,
            }
        )

    def title(self, block: blocks.Title) -> Iterator[str]:
        yield f"<h{block.level}>{self.words(block.words)}</h{block.level}>"

    def paragraph(self, block: blocks.Paragraph) -> Iterator[str]:
        yield f"<p>{self.words(block.words)}</p>"

    def bullets(self, block: Bullets) -> Iterator[str]:
        tag = "ul" if block.start is None else "ol"
        yield f'<ol start="{block.start}">' if tag == "ol" else "<ul>"
        for item in block.items:
            code = f"<pre>{self.prose(chr(10).join(item.code))}</pre>" if item.code else ""
            inner = "\n".join(("", *self.bullets(item.list))) if item.inner else ""
            yield f"<li>{self.words(item.words)}{code}{inner}</li>"
        yield f"</{tag}>"

    def body(self, page: blocks.Page, width: int) -> str:
        """The page as an article, which is printed on a sheet of its own."""
        return f"<article>\n{super().body(page, width)}</article>\n"

    def document(self, bodies: Sequence[str]) -> str:
        """A page of several articles; it has the title of the first."""
        return whole_page(bodies, self.code, self.paper)


PRINTER = Html()
