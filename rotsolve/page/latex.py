"""LaTeX: a complete article that any LaTeX compiles, or the body alone for a document of one's own that uses amsmath."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import ClassVar

from rotsolve.page import blocks
from rotsolve.page.blocks import (
    BOLD,
    BOTH,
    CODE,
    FAULT,
    ITALIC,
    LABEL,
    NAME,
    STRONG,
    Answers,
    Bullets,
    Formulas,
)
from rotsolve.page.latex_rows import LatexRows
from rotsolve.page.pictures import drawn, picture_in_tikz, with_tikz
from rotsolve.page.printer import Lines
from rotsolve.page.sheet_latex import LatexSheets, counted_sheet, on_latex_paper
from rotsolve.page.tex import WORDS, TexPrinter, latex_preamble, latex_prose

STRESS = r"\textbf{{{}}}"
ROWS = 40  # of a table on one page


class Latex(TexPrinter):
    """Pages as LaTeX."""

    styles: ClassVar = {
        NAME: r"\emph{{{}}}",
        LABEL: STRESS + r"\quad ",
        STRONG: STRESS,
        FAULT: STRESS,
        CODE: r"\texttt{{{}}}",
        BOLD: STRESS,
        ITALIC: r"\textit{{{}}}",
        BOTH: r"\textbf{{\textit{{{}}}}}",
    }

    def prose(self, text: str) -> str:
        return latex_prose(text)

    def own(self) -> dict[type[blocks.PageBlock], Callable[..., Lines]]:
        rows, sheets = LatexRows(self), LatexSheets(self).own()
        return super().own() | sheets | drawn(picture_in_tikz) | {Formulas: rows.formulas, Answers: rows.answers}

    def title(self, block: blocks.Title) -> Iterator[str]:
        said = self.words(block.words)
        yield STRESS.format(said) if block.minor else rf"\{'sub' * (block.level - 1)}section*{{{said}}}"

    def paragraph(self, block: blocks.Paragraph) -> Iterator[str]:
        yield from (self.words(block.words), "")

    def bullets(self, block: Bullets) -> Iterator[str]:
        kind = "itemize" if block.start is None else "enumerate"
        yield rf"\begin{{{kind}}}"
        for item, mark in zip(block.items, block.marks, strict=True):
            code = "".join(rf"\\ \mbox{{\texttt{{{self.prose(line).replace(' ', '~')}}}}}" for line in item.code)
            yield rf"  \item{f'[{mark}]' if mark else ''} {self.words(item.words)}{code}"
            yield from self.bullets(item.list) if item.inner else ()
        yield rf"\end{{{kind}}}"

    def table(self, block: blocks.Table) -> Iterator[str]:
        """A table, in parts that each fit on a page; the last cells are broken where they are long."""
        rows = [[*map(self.words, row)] for row in block.rows]
        last = r"p{0.5\linewidth}" if any(len(row[-1]) > WORDS for row in rows) else "l"
        for first in range(0, len(rows), ROWS):
            yield rf"\begin{{tabular}}{{{'l' * (len(block.columns) - 1)}{last}}}"
            yield " & ".join(map(self.prose, block.columns)) + r" \\ \hline"
            yield from (" & ".join(row) + r" \\" for row in rows[first : first + ROWS])
            yield from (r"\end{tabular}", "")

    def document(self, bodies: Sequence[str]) -> str:
        """Each page on a sheet of its own."""
        if self.paper:
            bodies = [counted_sheet(body, number) for number, body in enumerate(bodies, 1)]
        preamble = on_latex_paper(latex_preamble(self.babel), self.paper) if self.paper else latex_preamble(self.babel)
        return with_tikz(preamble + "\\clearpage\n".join(bodies) + "\\end{document}\n")


PRINTER = Latex()
