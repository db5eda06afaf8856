"""Reading: all that a student's line can mean, the likeliest first."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError, Token
from rotsolve.grading.reading.forks import Forks, all_ways
from rotsolve.grading.reading.grammar import read_formula
from rotsolve.grading.reading.names import Names
from rotsolve.grading.reading.numbers import are_letters, could_be_number, cut, likely_number, read_number
from rotsolve.grading.reading.records import EQUATION, FORMULA, AnswerError, Reading
from rotsolve.grading.reading.tokens import tokens_of


def read_answer(text: str, names: Names) -> tuple[Reading, ...]:
    """All readings that a line allows; AnswerError where there is none."""
    try:
        tokens = named(text, tokens_of(text), names)
        return tuple(all_ways(lambda forks: read_line(text, tokens, names, forks)))
    except FormulaError as error:
        raise AnswerError.of(error, text) from None


def named(text: str, tokens: list[Token], names: Names) -> list[Token]:
    """The tokens without the `NAME =` in front, which has to be the name asked for."""
    marks = [index for index, token in enumerate(tokens) if token.kind == "="]
    if not names.asked or not marks:
        return tokens
    first = marks[0]
    left = tokens[:first]
    if len(left) == 1 and left[0].kind == "name" and names.is_asked(left[0].text):
        if len(marks) > 1:
            mark = tokens[marks[1]]
            raise FormulaError("one answer at a time: a second `=`", mark.start, mark.end)
        return tokens[first + 1 :]
    end = left[-1].end if left else tokens[first].end
    start = left[0].start if left else tokens[first].start
    raise FormulaError(f"`{names.asked}` is asked for, not `{text[start:end]}`", start, end, f"{names.asked} = …")


def read_line(text: str, tokens: list[Token], names: Names, forks: Forks) -> Reading:
    """A line without its name, read on one way through its forks."""
    if len(tokens) == 1:
        raise FormulaError("the answer is empty", 0, len(text))
    if any(token.kind == "=" for token in tokens):
        return read_equation(text, tokens, names, forks)
    return read_value(text, tokens, names, forks)


def read_value(text: str, tokens: list[Token], names: Names, forks: Forks) -> Reading:
    """A number with its unit, or a formula in the letters of the scene."""
    parts = cut(tokens)
    if could_be_number(parts) and (
        not parts.has_unit or not are_letters(parts.unit, names.letters) or forks.choose(likely_number(parts))
    ):
        return read_number(text, parts, forks)
    formula = read_formula(text, tokens, names.letters, forks)
    return Reading(FORMULA, to_text(formula), formula)


def read_equation(text: str, tokens: list[Token], names: Names, forks: Forks) -> Reading:
    """left = right."""
    at = next(index for index, token in enumerate(tokens) if token.kind == "=")
    sign = tokens[at]
    left = [*tokens[:at], Token("end", "", sign.start, sign.start)]
    sides = [read_side(text, side, names, forks) for side in (left, tokens[at + 1 :])]
    if any(token.kind == "=" for token in tokens[at + 1 :]):
        raise FormulaError("one equation at a time: a second `=`", sign.start, tokens[-1].end)
    return replace(
        sides[0], kind=EQUATION, right=sides[1].formula, text=f"{sides[0].text} = {sides[1].text}", unit=None
    )


def read_side(text: str, tokens: list[Token], names: Names, forks: Forks) -> Reading:
    """One side of an equation, a number in SI units."""
    side = read_value(text, tokens, names, forks)
    if side.unit is None or side.formula is None:
        return side
    return replace(side, formula=side.formula * side.unit.factor)
