"""Rows of a LaTeX page: formulas and answers, aligned at their signs."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.page.blocks import AnswerRow, Answers, FormulaRow, Formulas, unindented
from rotsolve.page.printer import Printer
from rotsolve.page.tex import aligned, words_cell


class LatexRows:
    """Sets blocks as aligned equations."""

    def __init__(self, printer: Printer) -> None:
        self.printer, self.words = printer, printer.words

    def formulas(self, block: Formulas) -> Iterator[str]:
        yield rf"\textbf{{{block.caption}}}"
        for remark in block.remarks:
            yield from ("", self.words(unindented(remark)))
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
        for number, (left, right) in enumerate(map(self.printer.sides, row.chain)):
            worth = "".join(f" {self.printer.part(part)}" for part in row.worth(number))
            tag = rf" \tag{{{row.number}}}" if row.mark and number == len(row.chain) - 1 else ""
            yield f"{left} &{right}{worth}{'' if number else words_cell(said)}{tag}"

    def answers(self, block: Answers) -> Iterator[str]:
        yield from aligned([line for row in block.rows for line in self._answer_lines(row)])

    def _answer_lines(self, row: AnswerRow) -> Iterator[str]:
        """An answer and its components, a line each."""
        said = self.words(row.behind).removeprefix(", ").strip()
        sides = f"= {' = '.join(map(self.printer.part, row.forms))}" if row.forms else ""
        head = rf"\text{{{row.head}}}" if row.label else ""
        yield f"{head}{self.printer.formula(row.symbol)} &{sides}{words_cell(said)}"
        for component in () if row.matrix else row.components:
            yield from self._answer_lines(component)
