"""Typst: a complete document for A4, which Typst compiles with the fonts that it has within; a PDF is made of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, ClassVar

from rotsolve.algebra.notation.typst import number_to_typst, to_typst, typst_string, unit_in_typst
from rotsolve.page import blocks
from rotsolve.page.blocks import BOLD, BOTH, CODE, FAULT, ITALIC, LABEL, NAME, STRONG, Bullets
from rotsolve.page.pictures import drawn, picture_in_typst
from rotsolve.page.printer import Lines, Printer
from rotsolve.page.sheet_typst import TypstSheets
from rotsolve.page.typst_document import whole_document
from rotsolve.page.typst_rows import TypstRows, typst_code, typst_prose

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.algebra.units.unit_table import Unit


class Typst(Printer):
    """Pages as Typst."""

    blank = " thin "
    comma = '","'  # a bare one has a blank behind it, and divides arguments
    styles: ClassVar = {  # the semicolon ends the command, whatever stands behind it
        **dict.fromkeys((NAME, ITALIC), "#emph[{}];"),
        LABEL: "#strong[{}];#h(0.8em)",
        **dict.fromkeys((STRONG, BOLD), "#strong[{}];"),
        FAULT: "#fault[{}];",
        BOTH: "#strong[#emph[{}];];",
    }

    def prose(self, text: str) -> str:
        return typst_prose(text)

    def styled(self, style: str, text: str) -> str:
        return typst_code(text) if style == CODE else super().styled(style, text)

    def formula(self, formula: Formula) -> str:
        return self.numerals(to_typst(formula))

    def unit(self, unit: Unit) -> str:
        return unit_in_typst(unit.text)

    def number(self, mantissa: str, exponent: str) -> str:
        return self.numerals(number_to_typst(f"{mantissa}e{exponent}" if exponent else mantissa))

    def math(self, inner: str) -> str:
        return f"${inner}$" if inner else ""

    def bracketed(self, rows: Sequence[Sequence[str]]) -> str:
        return f"mat({'; '.join(', '.join(row) for row in rows)})"

    def own(self) -> dict[type[blocks.PageBlock], Callable[..., Lines]]:
        rows = TypstRows(self)
        return (
            super().own()
            | TypstSheets(self).own()
            | drawn(picture_in_typst)
            | {
                blocks.Labels: rows.labels,
                blocks.Formulas: rows.formulas,
                blocks.Answers: rows.answers,
                blocks.AssessedTexts: rows.assessed,
            }
        )

    def title(self, block: blocks.Title) -> Iterator[str]:
        yield from (f"{'=' * block.level} {self.words(block.words)}", "")

    def paragraph(self, block: blocks.Paragraph) -> Iterator[str]:
        yield from (self.words(block.words), "")

    def bullets(self, block: Bullets, inset: str = "") -> Iterator[str]:
        for item, mark in zip(block.items, block.marks, strict=True):
            code = f" #block(raw({typst_string(chr(10).join(item.code))}))" if item.code else ""
            yield f"{inset}{mark or '-'} {self.words(item.words)}{code}"
            yield from self.bullets(item.list, f"{inset}{' ' * (len(mark or '-') + 1)}")
        yield from () if inset else ("",)

    def table(self, block: blocks.Table) -> Iterator[str]:
        """A table, its head on every page; the first cells are links where they lead to files."""
        yield from (
            f"#columns-of({len(block.columns)},",
            f"  table.header{''.join(f'[{self.prose(head)}]' for head in block.columns)},",
        )
        for row, target in zip(block.rows, block.targets or ("",) * len(block.rows), strict=True):
            first, *others = map(self.words, row)
            link = f"#link({typst_string(target)})[{first}];" if target else first
            yield f"  {' '.join(f'[{cell}],' for cell in (link, *others))}"
        yield from (")", "")

    def document(self, bodies: Sequence[str]) -> str:
        """Each page on a sheet of its own; the document has the title of the first."""
        return whole_document(bodies, self.code, self.paper)


PRINTER = Typst()
