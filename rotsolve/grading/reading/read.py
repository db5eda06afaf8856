"""Reading: all that a student's line can mean, the likeliest first."""

from __future__ import annotations

import re

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.tokens import FormulaError, Token
from rotsolve.grading.reading.grammar.forks import Forks, all_ways
from rotsolve.grading.reading.grammar.formulas import read_formula
from rotsolve.grading.reading.grammar.tokens import tokens_of
from rotsolve.grading.reading.lines.chains import EQUALS
from rotsolve.grading.reading.lines.commas import with_points
from rotsolve.grading.reading.lines.directions import direction_behind
from rotsolve.grading.reading.names import Names
from rotsolve.grading.reading.numbers import (
    Parts,
    are_letters,
    could_be_number,
    cut,
    is_kind,
    is_strange_unit,
    likely_number,
    read_number,
)
from rotsolve.grading.reading.polar import Cut, cut_polar, polar_vector
from rotsolve.grading.reading.records import EQUATION, FORMULA, NUMBER, WORD, AnswerError, Reading
from rotsolve.grading.reading.units import read_unit
from rotsolve.grading.reading.vectors import by_axes, end_at, noted, read_axes, read_list

_WORDS = re.compile(r"[^\W\d_]+(?:[\s'’-]+[^\W\d_]+)*")


class Line(Struct, frozen=True):
    """A student's line, cut into what does not depend on how it is read.

    `tokens` are those of its value; of a vector told by size and angle those of the size, and `angle` those of the angle.
    """

    text: str
    names: Names
    word: str
    tokens: list[Token]
    direction: str = ""
    polar: Cut | None = None
    angle: tuple[Token, ...] = ()


def read_answer(text: str, names: Names) -> tuple[Reading, ...]:
    """All readings that a line allows; AnswerError where there is none."""
    try:
        line = line_of(text, names)
        return told_apart(all_ways(lambda forks: Reader(line, forks).line(), len(line.tokens)))
    except FormulaError as error:
        raise AnswerError.of(error, text) from None


def told_apart(readings: list[Reading]) -> tuple[Reading, ...]:
    """The readings; where two have one echo, as those of `5 m`, it says which has the unit."""
    if len({reading.has_units for reading in readings}) < 2:
        return tuple(readings)
    texts = [reading.text for reading in readings]
    return tuple(
        replace(reading, written=f"{reading.text} (with {'units' if reading.has_units else 'letters'})")
        if texts.count(reading.text) > 1
        else reading
        for reading in readings
    )


def line_of(text: str, names: Names) -> Line:
    """The line without the name in front and without the words behind."""
    start = after_name(text, names)
    word = word_of(text[start:].strip(" \t$"), names) if names.words else ""
    if word:
        return Line(text, names, word, [])
    polar = cut_polar(text, start)
    if polar is not None:
        angle = tokens_of(text, polar.start, polar.stop)
        return Line(text, names, "", tokens_of(text, start, polar.end), "", polar, tuple(angle))
    direction, end = direction_behind(text, start)
    tokens = tokens_of(text, start, end)
    if "x" in text or "X" in text:
        tokens = [times_sign(token, text, names) for token in tokens]
    if len(tokens) > 2 and tokens[-2].kind in (".", ",", ";"):
        del tokens[-2]  # the end of a sentence
    if len(tokens) == 1:
        raise FormulaError("the answer is empty", start, max(end, start))
    return Line(text, names, "", tokens, direction)


def word_of(value: str, names: Names) -> str:
    """The word that answers a question, as the scene has it where only its capitals differ; '' where a line is none."""
    folded = {word.casefold(): word for word in names.words}
    typed = " ".join(value.rstrip(".!").split())
    return folded.get(typed.casefold(), typed if _WORDS.fullmatch(typed) else "")


def after_name(text: str, names: Names) -> int:
    """Where the value begins: behind `NAME =`, if that stands there, whose name has to be the one asked for."""
    sign = EQUALS.search(text) if names.asked else None
    if sign is None:
        return 0
    second = EQUALS.search(text, sign.end())
    if second is not None:
        raise FormulaError("one answer at a time: a second `=`", *second.span())
    left = tokens_of(text, 0, sign.start())[:-1]
    timed = [token.kind for token in left[1:]] == ["(", "name", ")"]  # ω(t) = …
    if not left or ((len(left) == 1 or timed) and names.is_asked(left[0].text)):
        return sign.end()
    start, end = left[0].start, left[-1].end
    if names.is_asked(left[0].text) and "".join(token.text for token in left[1:]) in ("²", "^2", "^(2)"):
        raise FormulaError(f"`{names.asked}` is asked for, not its square: take the root", start, end)
    raise FormulaError(f"`{names.asked}` is asked for, not `{text[start:end]}`", start, end, f"{names.asked} = …")


def times_sign(token: Token, text: str, names: Names) -> Token:
    """The x of `1.2 x 10^3` as a mark; any other token as it is."""
    if token.kind == "name" and token.text in ("x", "X") and token.text not in names.letters:
        before, after = text[: token.start].rstrip(), text[token.end :].lstrip()
        if before[-1:].isdigit() and after[:1].isdigit():
            return Token("*", "*", token.start, token.end)
    return token


class Reader:
    """One way of reading a line."""

    def __init__(self, line: Line, forks: Forks) -> None:
        self.text, self.names, self.forks = line.text, line.names, forks
        self.source = line

    def line(self) -> Reading:
        """What the line says."""
        line = self.source
        if line.word:
            return Reading(WORD, line.word)
        if any(token.kind == "=" for token in line.tokens):
            return self.equation(line.tokens)
        if line.polar is not None:
            angle = self.pointed(list(line.angle))
            return polar_vector(self.pointed(line.tokens), angle, line.polar, self.forks)
        axes = by_axes(line.tokens, self.names.letters)
        if axes is not None:
            return read_axes(self.text, axes, self.forks, self.value)
        listed = read_list(self.text, line.tokens, self.forks, self.value)
        if listed is not None:
            return listed
        value = self.pointed(line.tokens)
        return (
            replace(value, direction=line.direction, written=f"{value.text} {line.direction}")
            if line.direction
            else value
        )

    def pointed(self, tokens: list[Token]) -> Reading:
        """A value in which commas may be decimal ones."""
        tokens, remarks = with_points(tokens, self.forks)
        return noted(self.value(tokens), remarks)

    def value(self, tokens: list[Token]) -> Reading:
        """A number with its unit, or a formula in the letters of the scene."""
        parts, letters = cut(tokens), self.names.letters
        if could_be_number(parts) and self.is_number(parts):
            return read_number(self.text, parts, self.forks)
        if is_strange_unit(parts, letters):
            read_unit(self.text, list(parts.unit), self.forks)  # says which word is no unit
        formula = self.names.meant(read_formula(self.text, tokens, letters, self.forks))
        return Reading(FORMULA if formula.symbols() else NUMBER, formula=formula)

    def is_number(self, parts: Parts) -> bool:
        """Whether a number with what can be a unit is one; where the unit can be letters too, it has to be of a known kind."""
        if not parts.has_unit or not are_letters(parts.unit, self.names.letters):
            return True
        return is_kind(parts.unit) and self.forks.choose(likely_number(parts))

    def equation(self, tokens: list[Token]) -> Reading:
        """left = right."""
        signs = [index for index, token in enumerate(tokens) if token.kind == "="]
        if len(signs) > 1:
            second = tokens[signs[1]]
            raise FormulaError("one equation at a time: a second `=`", second.start, second.end)
        sides = []
        for side in ([*tokens[: signs[0]], end_at(tokens[signs[0]])], tokens[signs[0] + 1 :]):
            if len(side) == 1:
                raise FormulaError("one side of the equation is empty", tokens[signs[0]].start, tokens[signs[0]].end)
            sides.append(self.pointed(side))
        left, right = sides
        remarks = (*left.remarks, *right.remarks)
        return Reading(EQUATION, f"{left.text} = {right.text}", in_si(left), right=in_si(right), remarks=remarks)


def in_si(side: Reading) -> Formula | None:
    """The formula of one side of an equation, a number in SI units."""
    if side.formula is None or side.unit is None:
        return side.formula
    return side.formula * side.unit.factor
