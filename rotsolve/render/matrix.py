"""Matrices and vectors in brackets: the exact entries and the certified numbers of an answer that has rows."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from rotsolve.algebra.formula import ZERO
from rotsolve.core.derivation import Answer
from rotsolve.render.layout import HELD, Row, hold
from rotsolve.render.voice import TEXT, Voice, certified, exact

CORNERS = {1: (("(", ")"),), 3: (("⎡", "⎤"), ("⎢", "⎥"), ("⎣", "⎦"))}
WIDEST = 76


def cells(answer: Answer, voice: Voice, digits: int) -> tuple[list[list[str]], list[list[str]]]:
    """The exact forms and the numbers of all entries; nothing where one of them has none."""
    formulas = [
        [voice.formula(part.formula) if part.formula is not None else "" for part in row] for row in answer.rows
    ]
    numbers = [
        [voice.quantity(text, None) if (text := certified(part, digits)[0]) else "" for part in row]
        for row in answer.rows
    ]
    symbolic = any(
        exact(part) is not None and part.formula.symbols() for row in answer.rows for part in row if part.formula
    )
    return (
        formulas if symbolic and all(all(row) for row in formulas) else [],
        numbers if all(all(row) for row in numbers) else [],
    )


def boxed(rows: Sequence[Sequence[str]]) -> list[str]:
    """The rows between tall brackets, their columns aligned; a single row between round ones."""
    if len(rows) == 1:
        return [f"({', '.join(rows[0])})"]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ["   ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) for row in rows]
    return [f"{left} {line} {right}" for (left, right), line in zip(CORNERS[len(rows)], lines, strict=True)]


def text_rows(answer: Answer, digits: int) -> Iterator[Row]:
    """A matrix or vector in text: exact entries, then numbers; entries too long for a page follow one by one."""
    formulas, numbers = cells(answer, TEXT, digits)
    unit = f" {answer.unit.text}" if answer.unit is not None and answer.unit.text not in ("", "1") else ""
    symbol, middle = TEXT.formula(answer.symbol), len(answer.rows) // 2
    left, right = boxed(formulas) if formulas else [], boxed(numbers) if numbers else []
    if left and len(left[0]) > WIDEST:
        left = []
    for number, line in enumerate(left or right):
        head = f"{symbol} = " if number == middle else " " * (len(symbol) + 3)
        behind = ""
        if left and right:
            behind = f"{'=' if number == middle else ' '} {right[number]}{unit if number == middle else ''}"
        elif right and number == middle:
            line += unit
        yield Row(held(head + line), held(behind))
    if formulas and not left:
        for part in answer.components:
            if part.formula is not None and part.formula != ZERO:
                yield Row(f"{HELD * 2}{hold(TEXT.formula(part.symbol))} = {hold(TEXT.formula(part.formula))}")
    if answer.remark:
        yield Row(f"{HELD * 2}({TEXT.words(answer.remark)})")


def held(text: str) -> str:
    return text.replace(" ", HELD)


def latex_matrix(answer: Answer, voice: Voice, digits: int) -> str:
    """A matrix or vector as mathematics: its exact entries, and its numbers with the unit."""
    return " = ".join([voice.formula(answer.symbol), *set_matrices(answer, voice, digits, pmatrix)])


def mathml_matrix(answer: Answer, voice: Voice, digits: int) -> tuple[str, ...]:
    """The exact entries of a matrix or vector, and its numbers with the unit, as MathML."""
    return set_matrices(answer, voice, digits, mtable)


def set_matrices(
    answer: Answer, voice: Voice, digits: int, brackets: Callable[[list[list[str]]], str]
) -> tuple[str, ...]:
    """The exact entries and the numbers, as far as there are any, each between brackets; the unit behind the last."""
    boxes = [brackets(rows) for rows in cells(answer, voice, digits) if rows]
    return (*boxes[:-1], *(voice.measured(box, answer.unit) for box in boxes[-1:]))


def pmatrix(rows: list[list[str]]) -> str:
    body = r" \\ ".join(" & ".join(row) for row in rows)
    return rf"\begin{{pmatrix}} {body} \end{{pmatrix}}"


def mtable(rows: list[list[str]]) -> str:
    lines = ("".join(f"<mtd>{cell}</mtd>" for cell in row) for row in rows)
    body = "".join(f"<mtr>{line}</mtr>" for line in lines)
    return f"<mrow><mo>(</mo><mtable>{body}</mtable><mo>)</mo></mrow>"
