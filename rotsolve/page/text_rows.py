"""Rows of a page of plain text: how labels, forces, formulas, answers, checks, tables and assessed texts stand below each other."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from msgspec.structs import replace

from rotsolve.page import blocks
from rotsolve.page.columns import (
    GAP,
    HELD,
    ColumnRow,
    TextLine,
    boxed,
    clipped_around,
    column_lines,
    fold,
    hold,
    labelled_lines,
    paragraph_lines,
    release,
    together,
    wrap,
)
from rotsolve.page.printer import Printer

WIDEST = 76  # columns of a matrix
NUMBERS = 100  # the column at which the numbers of steps end
STEP = 6  # where the equalities of a step begin
ROLES = {blocks.GOOD: "answer", blocks.BAD: "fault"}


def merged(page_blocks: Iterable[blocks.PageBlock]) -> list[blocks.PageBlock]:
    """The blocks; formulas that follow each other within a section become one, so that they have their columns in common."""
    found: list[blocks.PageBlock] = []
    for block in page_blocks:
        last = found[-1] if found else None
        if isinstance(block, blocks.Formulas) and isinstance(last, blocks.Formulas) and block.continues(last):
            found[-1] = replace(last, rows=last.rows + block.rows)
        else:
            found.append(block)
    return found


class TextRows:
    """Sets blocks in rows, from a column on, on a page of some width."""

    def __init__(self, printer: Printer) -> None:
        self.words, self.part = printer.words, printer.part
        self.formula, self.with_unit = printer.formula, printer.with_unit

    def own(self) -> dict[type[blocks.PageBlock], Callable[[Any, int, int], Iterator[TextLine]]]:
        """How each kind of block is set."""
        return {
            blocks.Title: self.title,
            blocks.Paragraph: self.paragraph,
            blocks.Bullets: self.bullets,
            blocks.Table: self.table,
            blocks.Labels: self.labels,
            blocks.Listing: self.listing,
            blocks.Formulas: self.formulas,
            blocks.Answers: self.answers,
            blocks.Checks: self.checks,
            blocks.AssessedTexts: self.assessed,
        }

    def title(self, block: blocks.Title, indent: int, width: int) -> Iterator[TextLine]:
        """A heading; that of the page has a blank line below it."""
        role = "title" if block.level == 1 else "heading"
        yield from paragraph_lines(self.words(block.words), max(0, 2 * block.level - 4), width, role)
        yield from [TextLine("")] if block.level == 1 else []

    def paragraph(self, block: blocks.Paragraph, indent: int, width: int) -> Iterator[TextLine]:
        yield from paragraph_lines(self.words(block.words), indent, width)

    def bullets(self, block: blocks.Bullets, indent: int, width: int) -> Iterator[TextLine]:
        """A list, its items marked by dashes or numbers."""
        for item, mark in zip(block.items, block.marks, strict=True):
            yield from self._bullet(item, indent, width, mark or "-")

    def _bullet(self, item: blocks.Bullet, indent: int, width: int, mark: str) -> Iterator[TextLine]:
        inset = len(mark) + 1
        for number, line in enumerate(paragraph_lines(self.words(item.words), 0, width - indent - inset)):
            yield TextLine(f"{' ' * indent}{' ' * len(mark) if number else mark} {line.text}")
        yield from self.bullets(item.list, indent + inset, width)
        yield from (TextLine(" " * (indent + inset) + line) for line in item.code)

    def labels(self, block: blocks.Labels, indent: int, width: int) -> Iterator[TextLine]:
        """Labels in a column of their own; what may stand beside the row above does so where both fit."""
        rows, widest = [*block.rows], max((len(row.label) for row in block.rows), default=0)
        while rows:
            row = rows.pop(0)
            items, separator = self._items(row, width), HELD * 5 if row.wide else row.separator
            if rows and rows[0].beside:
                one, other = separator.join(items), "; ".join(self._items(rows[0], width)).replace(" ", HELD)
                if 8 + len(one) + 10 + len(other) <= width:
                    items = [f"{one}{HELD * 10}{other}"]
                    rows.pop(0)
            yield from labelled_lines(row.label, items, separator, width, indent, widest)
        yield TextLine("")

    def _items(self, row: blocks.Labelled, width: int) -> list[str]:
        """The items of a row; a long one is not broken within what looks like a formula."""
        items = [*map(self.words, row.items)]
        return [*map(together, items)] if len(items) == 1 and len(items[0]) > width - 8 else items

    def listing(self, block: blocks.Listing, indent: int, width: int) -> Iterator[TextLine]:
        """A row a name; what is said of a single one stands behind the caption."""
        if block.level == 2:
            yield TextLine(block.caption, "heading")
        elif len(block.rows) == 1 and not block.rows[0].remarks:
            row = block.rows[0]
            said = [*map(self.words, row.said), *([row.beside] if row.beside else [])]
            yield from labelled_lines(block.caption, said, "; ", width, 2)
            return
        else:
            yield TextLine(f"  {block.caption}", "", len(block.caption) + 2)
        yield from self._listed_lines(block.rows, 2 if block.level == 2 else 4, width)

    def _listed_lines(self, rows: Sequence[blocks.Listed], indent: int, width: int) -> Iterator[TextLine]:
        """One row a name: what is said of it, what stands beside it, and its remarks in brackets below."""
        column = indent + max(len(row.name) for row in rows) + 3
        said = ["; ".join(map(self.words, row.said)) for row in rows]
        room = width - column - GAP - max(len(row.beside) for row in rows)
        end = column + max((len(text) for text in said if len(text) <= room), default=0) + GAP
        for row, text in zip(rows, said, strict=True):
            first, *below = wrap(text, width - column, 2)
            fits = not below and column + len(first) + GAP <= end
            below += [] if fits or not row.beside else [f"({row.beside})"]
            head = " " * indent + row.name.ljust(column - indent) + first
            yield TextLine(release(head.ljust(end) + row.beside if fits else head))
            remarks = "; ".join(map(self.words, row.remarks))
            below += wrap(f"({remarks})", width - column, 1) if remarks else []
            yield from (TextLine(release(" " * column + part)) for part in below)

    def formulas(self, block: blocks.Formulas, indent: int, width: int) -> Iterator[TextLine]:
        """What is said of each formula, the formula, and its remark; only where there is nothing above has it a caption."""
        if block.level == 2:
            yield TextLine(block.caption, "heading")
        for remark in block.remarks:
            own = blocks.unindented(remark)
            yield from paragraph_lines(self.words(own), 2 if own == remark else STEP, width)
        laws = [self._law_row(row) for row in block.rows if row.numbered]
        yield from column_lines(laws, 2, width)
        for row in (row for row in block.rows if not row.numbered):
            yield from self._step_lines(row, width)

    def _law_row(self, row: blocks.FormulaRow) -> ColumnRow:
        """An equation with its number and the law that it states."""
        remark = f"({self.words(row.remark)})" if row.remark else ""
        return ColumnRow(f"{row.mark} {self.words(row.said)}", self.words(row.line(0)), remark)

    def _step_lines(self, row: blocks.FormulaRow, width: int) -> Iterator[TextLine]:
        """What a step does, and below it one equality a line, the number of the last at the right; a short one on one line."""
        said, remark = self.words(row.said), f"({self.words(row.remark)})" if row.remark else ""
        end = min(width, NUMBERS)
        first = f"  {said}{':' if said and not row.begins else ''}"
        whole = self.words(row.line(0))
        if len(row.chain) == 1 and len(first) + 2 + len(whole) <= end - len(row.mark) - GAP:
            yield from self._with_mark(f"{first}  {whole}", row.mark, remark, end, width)
            return
        yield from paragraph_lines(first.strip(), 2, width) if said else ()
        *lines, last = [line for place in range(len(row.chain)) for line in self._equality_lines(row, place, width)]
        yield from map(TextLine, map(release, lines))
        yield from self._with_mark(last, row.mark, remark, end, width)

    def _equality_lines(self, row: blocks.FormulaRow, place: int, width: int) -> Iterator[str]:
        """One equality of a step; what it comes to stands below it where there is no room behind it."""
        whole, room = self.words(row.line(place)), width - STEP
        if len(whole) <= room or not row.worth(place):
            yield from (" " * STEP + part for part in fold(whole, room))
            return
        yield from (" " * STEP + part for part in fold(self.words((blocks.equation(row.chain[place]),)), room))
        yield from (" " * (STEP + 4) + part for part in wrap(self.words((blocks.Math(row.worth(place)),)), room - 4, 2))

    @staticmethod
    def _with_mark(line: str, mark: str, remark: str, end: int, width: int) -> Iterator[TextLine]:
        """A line with its number at the right, and a remark behind it, or below it where there is no room."""
        numbered = f"{line.ljust(end - len(mark))}{mark}" if mark and len(line) + GAP + len(mark) <= end else line
        numbered += f"{' ' * GAP}{mark}" if mark and numbered == line else ""
        if remark and not mark and len(line) + GAP + len(remark) <= width:
            yield TextLine(release(f"{line}{' ' * GAP}{remark}"))
            return
        yield TextLine(release(numbered))
        yield from paragraph_lines(remark, STEP + 2, width) if remark else ()

    def answers(self, block: blocks.Answers, indent: int, width: int) -> Iterator[TextLine]:
        yield from column_lines([line for row in block.rows for line in self.answer_rows(row)], 2, width, "answer")

    def answer_rows(self, row: blocks.AnswerRow, inset: str = "") -> Iterator[ColumnRow]:
        """An answer and, further in, its components: symbol, exact form, certified number, direction."""
        if row.matrix:
            yield from self._matrix_rows(row)
            return
        symbol, behind = hold(f"{row.head}{self.formula(row.symbol)}"), self.words(row.behind)
        first, *more = [hold(self.part(form)) for form in row.forms] or [""]
        if more:
            yield ColumnRow(f"{inset}{symbol} = {first}", f"= {more[0]}{behind}")
        elif first:
            yield ColumnRow(f"{inset}{symbol} = {first}{behind}")
        else:
            yield ColumnRow(f"{inset}{symbol}: {behind.removeprefix(', ').strip()}")
        for component in row.components:
            yield from self.answer_rows(component, inset + HELD * 2)

    def _matrix_rows(self, row: blocks.AnswerRow) -> Iterator[ColumnRow]:
        """A matrix: its exact entries, then its numbers; entries too wide for a page follow one by one."""
        matrices = [form for form in row.forms if isinstance(form, blocks.Matrix)]
        formulas, numbers = self._box(matrices, amounts=False), self._box(matrices, amounts=True)
        fits = bool(formulas) and len(formulas[0]) <= WIDEST
        boxes = [box for box in (formulas if fits else [], numbers) if box]
        symbol, unit = f"{row.head}{self.formula(row.symbol)}", next((box.unit for box in matrices[-1:]), None)
        for place, lines in enumerate(zip(*boxes, strict=True)):
            middle = place == len(boxes[0]) // 2
            head = f"{symbol} = " if middle else " " * (len(symbol) + 3)
            last = self.with_unit(lines[-1], unit) if middle and numbers else lines[-1]
            cells = (head + last,) if len(lines) == 1 else (head + lines[0], f"{'=' if middle else ' '} {last}")
            yield ColumnRow(*(cell.replace(" ", HELD) for cell in cells))
        for entry in row.components if formulas and not fits else ():
            yield ColumnRow(f"{HELD * 2}{hold(self.formula(entry.symbol))} = {hold(self.part(entry.forms[0]))}")
        for note in row.notes:
            yield ColumnRow(f"{HELD * 2}({self.words(note)})")

    def _box(self, matrices: Sequence[blocks.Matrix], *, amounts: bool) -> list[str]:
        """The lines of the matrix of numbers, or of that of formulas; none where there is no such."""
        fitting = [matrix for matrix in matrices if isinstance(matrix.rows[0][0], blocks.Amount) == amounts]
        return boxed([[*map(self.part, cells)] for cells in fitting[0].rows]) if fitting else []

    def checks(self, block: blocks.Checks, indent: int, width: int) -> Iterator[TextLine]:
        """What holds, in one paragraph; then what fails and what could not be decided, one a line."""
        items = [self.words(check.words) for check in block.checks if check.holds]
        good = " · ".join(item.replace(" ", HELD) if len(item) <= width // 2 else item for item in items)
        yield from paragraph_lines(good, 2, width, "check") if good else ()
        for check in block.checks:
            if not check.holds:
                said = self.words((*block.verdict(check), *check.words))
                yield from paragraph_lines(said, 2, width, "fault")

    def table(self, block: blocks.Table, indent: int, width: int) -> Iterator[TextLine]:
        """Aligned columns; a last column that is too long goes on below."""
        cells = [[release(self.words(cell)) for cell in row] for row in block.rows]
        sizes = [max(map(len, column)) for column in zip(block.columns, *cells, strict=True)]
        last = 2 + sum(sizes[:-1]) + 3 * (len(sizes) - 1)
        for number, row in enumerate([list(block.columns), *cells]):
            head = "".join(cell.ljust(size + 3) for cell, size in zip(row[:-1], sizes, strict=False))
            first, *more = (line.text for line in paragraph_lines(row[-1], 0, max(20, width - last)))
            yield TextLine(f"  {head}{first}".rstrip(), "check" if number == 0 else "")
            yield from (TextLine(" " * last + part) for part in more)

    def assessed(self, block: blocks.AssessedTexts, indent: int, width: int) -> Iterator[TextLine]:
        """Texts below each other, each with what is thought of it behind it, and what is said of it below."""
        labels = [release(self.words(row.label)) for row in block.rows]
        start = 2 + max(map(len, labels)) + 3
        beside = max(len(row.said) for row in block.rows)
        marks = max(len(row.marks) for row in block.rows)
        room = max(20, width - start - GAP - beside - (GAP + marks if marks else 0))
        behind = start + min(room, max(len(clipped_around(row.text, room)[0]) for row in block.rows)) + GAP
        for label, row in zip(labels, block.rows, strict=True):
            text, first = clipped_around(row.text, room, row.notes[0].columns if row.notes else None)
            verdict = f"{row.said.ljust(beside)}{' ' * GAP}{row.marks.rjust(marks)}".rstrip()
            line = f"  {label}".ljust(start) + text
            yield TextLine(line.ljust(behind) + verdict, ROLES.get(row.tone, "doubt"))
            yield from self._note_lines(row, start, room, width, first)

    def _note_lines(
        self, row: blocks.AssessedText, start: int, room: int, width: int, first: int
    ) -> Iterator[TextLine]:
        """Each note below the columns that it speaks of, and how the text was read."""
        after = first
        for note in row.notes:
            if note.columns is not None:
                text, begin = clipped_around(row.text, room, note.columns)
                if begin != after:
                    yield TextLine(" " * start + text)
                at = note.columns[0] - begin + (1 if begin else 0)
                length = min(note.columns[1] - note.columns[0], len(text) - at)
                yield TextLine(" " * (start + at) + "^" * max(1, length))
            yield from paragraph_lines(self.words(note.words), start, width)
            after = -1
        if row.read_as:
            yield from paragraph_lines(f"read as {row.read_as}", start, width)
