"""Rows of a Typst page: labels, formulas, answers and assessed texts; and words in which Typst reads no markup."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rotsolve.algebra.notation.typst import typst_string
from rotsolve.page.blocks import (
    AnswerRow,
    Answers,
    AssessedText,
    AssessedTexts,
    FormulaRow,
    Formulas,
    Labels,
    joined_phrases,
    unindented,
)
from rotsolve.page.printer import Printer

# what means something anywhere, and what does beside its like, before a number or at the beginning of a line
MARKUP = re.compile(
    r"[\\*_`$#@<\[\]~/]|^[=+]|(?<=^ )[=+]|(?<![A-Za-z])-|-(?![A-Za-z])|\.(?=\.)|(?<=\.)\.|(?<=\d)\.(?=\s|$)"
)
LONG_WORD = re.compile(r"\S{24}(?=\S)")  # of what someone typed: a line may end behind it


def typst_prose(text: str) -> str:
    """Prose as Typst; letters that do not print are left out."""
    line = "".join(" " if char.isspace() else char for char in text if char.isspace() or char.isprintable())
    return MARKUP.sub(r"\\\g<0>", re.sub(" +", " ", line))


def typst_code(text: str) -> str:
    """What someone typed, letter by letter; the semicolon ends the command, whatever stands behind it."""
    pieces = LONG_WORD.sub("\\g<0>\n", text).split("\n") if LONG_WORD.search(text) else [text]
    return "#sym.zws;".join(f"#raw({typst_string(piece)});" for piece in pieces)


class TypstRows:
    """Sets blocks by the functions that a document begins with."""

    def __init__(self, printer: Printer) -> None:
        self.printer, self.words = printer, printer.words

    def labels(self, block: Labels) -> Iterator[str]:
        yield "#labels("
        for row in block.rows:
            said = self.words(joined_phrases(row.items, row.separator))
            yield f"  ([{self.printer.prose(row.label)}], [{said}]),"
        yield from (")", "")

    def formulas(self, block: Formulas) -> Iterator[str]:
        """The lines in groups, whose signs stand below each other: a step of which much is said begins one."""
        yield from (f"{'=' * block.level} {self.printer.prose(block.caption)}", "")
        for remark in block.remarks:
            yield f"#above[{self.words(unindented(remark))}]"
        lines: list[str] = []
        for row in block.rows:
            if row.says_much:
                yield from grouped(lines)
                yield f"#above[{self.words(row.words)}:]"
                lines = []
            lines += self._formula_lines(row)
        yield from grouped(lines)

    def _formula_lines(self, row: FormulaRow) -> Iterator[str]:
        """A line for each equality: before the first stands where it comes from, behind the last its number."""
        for place, (left, right) in enumerate(map(self.printer.sides, row.chain)):
            said = "" if place or row.says_much else self.words(row.words)
            amounts = [self.printer.part(part) for part in row.worth(place) if part != "="]
            sides = ", ".join(f"${side}$" for side in (right, *(f"= {amount}" for amount in amounts)))
            mark = f", mark: [{row.mark}]" if row.mark and place == len(row.chain) - 1 else ""
            yield f"  line-of([{said}], ${left}$, {sides}{mark}),"

    def answers(self, block: Answers) -> Iterator[str]:
        yield from grouped([line for row in block.rows for line in self._answer_lines(row)])

    def _answer_lines(self, row: AnswerRow) -> Iterator[str]:
        """An answer and its components, a line each."""
        sides = "".join(f", $= {self.printer.part(form)}$" for form in row.forms)
        behind = self.words(row.behind)
        head = row.head.strip()
        yield f"  line-of([{head}], ${self.printer.formula(row.symbol)}${sides}{f', behind: [{behind}]' if behind else ''}),"
        for component in () if row.matrix else row.components:
            yield from self._answer_lines(component)

    def assessed(self, block: AssessedTexts) -> Iterator[str]:
        """A text with what is thought of it, and below it what is said of it."""
        yield "#assessed("
        for row in block.rows:
            cells = (
                self.words(row.label),
                self._marked(row),
                self.printer.prose(row.said),
                self.printer.prose(row.marks),
            )
            remarks = [self.words(note.words) for note in row.notes]
            remarks += [f"read as {typst_code(row.read_as)}"] if row.read_as else []
            said = "".join(f", [{cell}]" for cell in (*cells, *remarks))
            yield f"  (tone: {typst_string(row.tone)}, cells: ({said.removeprefix(', ')})),"
        yield from (")", "")

    def _marked(self, row: AssessedText) -> str:
        """The text with the columns of the first note that has any marked."""
        before, inside, after = (typst_code(part) if part else "" for part in row.divided)
        return f"{before}#highlight[{inside}];{after}" if inside else before + after


def grouped(lines: list[str]) -> Iterator[str]:
    """Lines of formulas whose signs stand below each other."""
    if lines:
        yield from ("#formulas(", *lines, ")", "")
