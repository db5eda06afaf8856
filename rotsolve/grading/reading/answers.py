"""Answers: all that a student's line can mean, the likeliest first."""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.cursor import Forks
from rotsolve.algebra.notation.tokens import FormulaError, Token
from rotsolve.grading.reading.lines import EQUALS, direction_behind, with_points
from rotsolve.grading.reading.numbers import (
    NumberAndUnit,
    are_letters,
    could_be_number,
    cut_at_unit,
    is_kind,
    is_strange_unit,
    likely_number,
    read_number_with_unit,
    read_unit,
)
from rotsolve.grading.reading.records import EQUATION, FORMULA, NUMBER, AnswerError, LineReading, Names
from rotsolve.grading.reading.tokens import tokens_of
from rotsolve.grading.reading.vectors import (
    SizeAndAngle,
    by_axes,
    cut_polar,
    end_at,
    polar_vector,
    read_axes,
    read_list,
    with_remarks,
)
from rotsolve.grading.reading.vocabulary import all_ways, read_formula


class AnswerLine(Struct, frozen=True):
    """A student's line, cut into what does not depend on how it is read.

    `tokens` are those of its value; of a vector told by size and angle those of the size, and `angle` those of the angle.
    """

    text: str
    names: Names
    tokens: list[Token]
    direction: str = ""
    polar: SizeAndAngle | None = None
    angle: tuple[Token, ...] = ()


def read_line(text: str, names: Names) -> tuple[LineReading, ...]:
    """All readings that a line allows; AnswerError where there is none."""
    try:
        line = answer_line(text, names)
        ways = all_ways(lambda forks: AnswerParser(line, forks).line(), len(line.tokens))
        return with_distinct_echoes([replace(one, cut=True) for one in ways] if ways.cut else ways)
    except FormulaError as error:
        raise AnswerError.of(error, text) from None


def with_distinct_echoes(readings: list[LineReading]) -> tuple[LineReading, ...]:
    """The readings; where two have one echo, as those of `5 m`, it says which has the unit."""
    if len({reading.has_units for reading in readings}) < 2:
        return tuple(readings)
    texts = [reading.text for reading in readings]
    echoes = [f"{one.text} (with {'units' if one.has_units else 'letters'})" for one in readings]
    pairs = zip(readings, echoes, strict=True)
    return tuple(replace(one, written=echo) if texts.count(one.text) > 1 else one for one, echo in pairs)


def answer_line(text: str, names: Names) -> AnswerLine:
    """The line without the name in front and without the words behind."""
    start = after_name(text, names)
    polar = cut_polar(text, start)
    if polar is not None:
        angle = tokens_of(text, polar.start, polar.stop)
        return AnswerLine(text, names, tokens_of(text, start, polar.end), "", polar, tuple(angle))
    direction, end = direction_behind(text, start)
    tokens = tokens_of(text, start, end)
    if "x" in text or "X" in text:
        tokens = [times_sign(token, text, names) for token in tokens]
    if len(tokens) > 2 and tokens[-2].kind in (".", ",", ";"):
        del tokens[-2]  # the end of a sentence
    if len(tokens) == 1:
        raise FormulaError("the answer is empty", start, max(end, start))
    return AnswerLine(text, names, tokens, direction)


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


class AnswerParser:
    """One way of reading a line."""

    def __init__(self, line: AnswerLine, forks: Forks) -> None:
        self.source, self.text, self.names, self.forks = line, line.text, line.names, forks

    def line(self) -> LineReading:
        """What the line says."""
        line = self.source
        if any(token.kind == "=" for token in line.tokens):
            return self.equation(line.tokens)
        if line.polar is not None:
            angle = self.pointed(list(line.angle))
            return polar_vector(self.pointed(line.tokens), angle, line.polar, self.forks)
        axes = by_axes(line.tokens, self.names.letters, self.names.components)
        if axes is not None and self.names.asked and not self.names.components:
            self.check_is_joule(axes)
        if axes is not None:
            return read_axes(self.text, axes, self.names.components, self.forks, self.value)
        listed = read_list(self.text, line.tokens, self.names.components, self.forks, self.value)
        if listed is not None:
            return listed
        value, direction = self.pointed(line.tokens), line.direction
        return replace(value, direction=direction, written=f"{value.text} {direction}") if direction else value

    def check_is_joule(self, axes: list[Token]) -> None:
        """A j behind a number that is no vector is the unit."""
        last = axes[-2]
        alone = [token for token in axes if token.kind in ("axis", "name")] == [last]
        if alone and last.text == "j" and len(axes) > 2:
            raise FormulaError("unknown unit `j`", last.start, last.end, "J")

    def pointed(self, tokens: list[Token]) -> LineReading:
        """A value in which commas may be decimal ones."""
        tokens, remarks = with_points(tokens, self.forks)
        return with_remarks(self.value(tokens), remarks)

    def value(self, tokens: list[Token]) -> LineReading:
        """A number with its unit, or a formula in the letters of the scene."""
        letters = self.names.letters
        parts = cut_at_unit(tokens, letters)
        if could_be_number(parts) and self.is_number(parts):
            return read_number_with_unit(self.text, parts, self.forks)
        if is_strange_unit(parts, letters):
            read_unit(self.text, list(parts.unit), self.forks)  # says which word is no unit
        formula = self.names.meant(read_formula(self.text, tokens, letters, self.forks))
        return LineReading(FORMULA if formula.symbols() else NUMBER, formula=formula)

    def is_number(self, parts: NumberAndUnit) -> bool:
        """Whether a number with what can be a unit is one; where the unit can be letters too, it has to be of a known kind."""
        if not parts.has_unit or not are_letters(parts.unit, self.names.letters):
            return True
        return is_kind(parts.unit) and self.forks.choose(likely_number(parts))

    def equation(self, tokens: list[Token]) -> LineReading:
        """left = right."""
        sign, *more = [token for token in tokens if token.kind == "="]
        if more:
            raise FormulaError("one equation at a time: a second `=`", more[0].start, more[0].end)
        at = tokens.index(sign)
        sides = []
        for side in ([*tokens[:at], end_at(sign)], tokens[at + 1 :]):
            if len(side) == 1:
                raise FormulaError("one side of the equation is empty", sign.start, sign.end)
            sides.append(self.pointed(side))
        left, right = sides
        written, remarks = f"{left.text} = {right.text}", (*left.remarks, *right.remarks)
        return LineReading(EQUATION, written, si_formula(left), right=si_formula(right), remarks=remarks)


def si_formula(side: LineReading) -> Formula | None:
    """The formula of one side of an equation, a number in SI units."""
    if side.formula is None or side.unit is None:
        return side.formula
    return side.formula * side.unit.factor
