"""LaTeX: a complete article that any LaTeX compiles, or the body alone for a document of one's own that uses amsmath."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import ClassVar

from rotsolve.page import blocks
from rotsolve.page.blocks import CODE, FAULT, LABEL, NAME, STRONG, AnswerRow, Answers, Bullets, FormulaRow, Formulas
from rotsolve.page.pictures import picture_in_tikz, with_tikz
from rotsolve.page.printer import Lines
from rotsolve.page.tex import WORDS, TexPrinter, aligned, latex_preamble, latex_prose, words_cell

BOLD = r"\textbf{{{}}}"
ROWS = 40  # of a table on one page


class Latex(TexPrinter):
    """Pages as LaTeX."""

    styles: ClassVar = {
        NAME: r"\emph{{{}}}",
        LABEL: BOLD + r"\quad ",
        STRONG: BOLD,
        FAULT: BOLD,
        CODE: r"\texttt{{{}}}",
    }

    def prose(self, text: str) -> str:
        return latex_prose(text)

    def own(self) -> dict[type[blocks.PageBlock], Callable[..., Lines]]:
        return super().own() | {blocks.Picture: picture_in_tikz, Formulas: self.formulas, Answers: self.answers}

    def title(self, block: blocks.Title) -> Iterator[str]:
        said = self.words(block.words)
        yield BOLD.format(said) if block.minor else rf"\{'sub' * (block.level - 1)}section*{{{said}}}"

    def paragraph(self, block: blocks.Paragraph) -> Iterator[str]:
        yield from (self.words(block.words), "")

    def bullets(self, block: Bullets) -> Iterator[str]:
        yield r"\begin{itemize}"
        for item in block.items:
            code = "".join(rf"\\ \mbox{{\texttt{{{self.prose(line).replace(' ', '~')}}}}}" for line in item.code)
            yield rf"  \item {self.words(item.words)}{code}"
            yield from self.bullets(Bullets(item.inner)) if item.inner else ()
        yield r"\end{itemize}"

    def table(self, block: blocks.Table) -> Iterator[str]:
        """A table, in parts that each fit on a page; the last cells are broken where they are long."""
        rows = [[*map(self.words, row)] for row in block.rows]
        last = r"p{0.5\linewidth}" if any(len(row[-1]) > WORDS for row in rows) else "l"
        for first in range(0, len(rows), ROWS):
            yield rf"\begin{{tabular}}{{{'l' * (len(block.columns) - 1)}{last}}}"
            yield " & ".join(map(self.prose, block.columns)) + r" \\ \hline"
            yield from (" & ".join(row) + r" \\" for row in rows[first : first + ROWS])
            yield from (r"\end{tabular}", "")

    def formulas(self, block: Formulas) -> Iterator[str]:
        yield BOLD.format(block.caption)
        for remark in block.remarks:
            yield from ("", self.words(blocks.unindented(remark)))
        lines: list[str] = []  # of one alignment, up to a step of which much is said
        for row in block.rows:
            if row.says_much:
                yield from (*aligned(lines), "", f"{self.words(row.words)}:")
                lines = []
            lines += self._formula_lines(row)
        yield from aligned(lines)

    def _formula_lines(self, row: FormulaRow) -> Iterator[str]:
        """A line for each equality: behind the first stands where it comes from, the last has the number."""
        said = "" if row.says_much else self.words(row.words)
        for number, (left, right) in enumerate(map(self.sides, row.chain)):
            worth = "".join(f" {self.part(part)}" for part in row.worth(number))
            tag = rf" \tag{{{row.number}}}" if row.mark and number == len(row.chain) - 1 else ""
            yield f"{left} &{right}{worth}{'' if number else words_cell(said)}{tag}"

    def answers(self, block: Answers) -> Iterator[str]:
        yield from aligned([line for row in block.rows for line in self._answer_lines(row)])

    def _answer_lines(self, row: AnswerRow) -> Iterator[str]:
        """An answer and its components, a line each."""
        said = self.words(row.behind).removeprefix(", ").strip()
        sides = f"= {' = '.join(map(self.part, row.forms))}" if row.forms else ""
        yield f"{self.formula(row.symbol)} &{sides}{words_cell(said)}"
        for component in () if row.matrix else row.components:
            yield from self._answer_lines(component)

    def document(self, bodies: Sequence[str]) -> str:
        """Each page on a sheet of its own."""
        return with_tikz(latex_preamble(self.babel) + "\\clearpage\n".join(bodies) + "\\end{document}\n")


PRINTER = Latex()
