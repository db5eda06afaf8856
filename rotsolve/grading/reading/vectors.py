"""Vectors: by components, `(3, 4) N` and `3i + 4j`."""

from __future__ import annotations

from collections.abc import Callable

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.algebra.notation.tokens import FormulaError, Token
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.grading.reading.grammar.forks import Forks
from rotsolve.grading.reading.lines.commas import with_points
from rotsolve.grading.reading.numbers import are_letters
from rotsolve.grading.reading.records import NUMBER, VECTOR, Reading
from rotsolve.grading.reading.units import looks_like_unit, read_unit
from rotsolve.grading.verdict import Remark

AXES = ("i", "j", "k")
OPENING, CLOSING = ("(", "[", "<"), (")", "]", ">")
MOST_COMPONENTS = 9

ReadValue = Callable[[list[Token]], Reading]


def end_at(token: Token) -> Token:
    """An end that stands before a token."""
    return Token("end", "", token.start, token.start)


def closing(tokens: list[Token]) -> int:
    """The index of the bracket that closes the first one; −1 where the line begins with none."""
    if tokens[0].kind not in OPENING and tokens[0].text != "<":
        return -1
    level = 0
    for index, token in enumerate(tokens):
        level += (token.text in OPENING) - (token.text in CLOSING)
        if level == 0:
            return index
    return -1


def unit_behind(text: str, tokens: list[Token], forks: Forks) -> Unit | None:
    """The unit that the tokens are, the last of which is an `end`; None for nothing at all."""
    return read_unit(text, tokens, forks) if len(tokens) > 1 else None


def parted(tokens: list[Token], forks: Forks) -> list[list[Token]]:
    """What stands in the brackets of a list: its components, each with an `end`; one alone where it is no list.

    Semicolons part them; else commas, of which those between digits may be decimal ones where others have a space behind.
    """
    level = 0
    marks: list[int] = []
    for index, token in enumerate(tokens):
        level += (token.text in OPENING) - (token.text in CLOSING)
        if level == 0 and token.kind in (",", ";"):
            marks.append(index)
    if any(tokens[index].kind == ";" for index in marks):
        marks = [index for index in marks if tokens[index].kind == ";"]
    else:
        tight = [index for index in marks if between_digits(tokens, index)]
        if tight and len(tight) < len(marks):
            marks = [index for index in marks if index not in tight]
        elif len(tight) == len(marks) == 1 and not forks.choose(True):
            marks = []
    starts = [0, *(index + 1 for index in marks)]
    ends = [*marks, len(tokens) - 1]
    return [[*tokens[start:end], end_at(tokens[end])] for start, end in zip(starts, ends, strict=True)]


def between_digits(tokens: list[Token], index: int) -> bool:
    """Whether the comma at a place stands between two digits without a space."""
    before, comma, after = tokens[index - 1], tokens[index], tokens[index + 1]
    return before.kind == after.kind == "number" and before.end == comma.start and comma.end == after.start


def read_list(text: str, tokens: list[Token], forks: Forks, read: ReadValue) -> Reading | None:
    """A vector in brackets, perhaps with a unit behind them; None where the line is none."""
    if not any(token.kind in (",", ";") for token in tokens):
        return None
    last = closing(tokens)
    if last < 0 or not any(token.kind in (",", ";") for token in tokens[1:last]):
        return None
    behind = tokens[last + 1 :]
    if not looks_like_unit(behind):
        return None
    inside = parted([*tokens[1:last], end_at(tokens[last])], forks)
    if len(inside) == 1:
        return None
    if len(inside) > MOST_COMPONENTS:
        raise FormulaError("a vector has two or three components", tokens[0].start, tokens[last].end)
    unit = unit_behind(text, behind, forks)
    parts = []
    for component in inside:
        if len(component) == 1:
            raise FormulaError("a component is missing", component[0].start - 1, component[0].start)
        pointed, remarks = with_points(component, forks)
        parts.append(noted(read(pointed), remarks))
    return vector(parts, unit)


def noted(reading: Reading, remarks: tuple[Remark, ...]) -> Reading:
    return replace(reading, remarks=(*reading.remarks, *remarks)) if remarks else reading


def vector(parts: list[Reading], unit: Unit | None) -> Reading:
    """The vector with these components, all in the unit behind the bracket where that has one."""
    if unit is not None:
        parts = [part if part.unit is not None else in_unit(part, unit) for part in parts]
        inner = ", ".join(part.text.removesuffix(unit.text).strip() for part in parts)
        shown = unit.after(f"({inner})")
    else:
        shown = f"({', '.join(part.text for part in parts)})"
    remarks = tuple(remark for part in parts for remark in part.remarks)
    return Reading(VECTOR, shown, unit=unit, parts=tuple(replace(part, remarks=()) for part in parts), remarks=remarks)


def in_unit(part: Reading, unit: Unit) -> Reading:
    return replace(part, unit=unit, written=unit.after(part.text))


def by_axes(tokens: list[Token], letters: frozenset[str]) -> list[Token] | None:
    """The tokens with each i, j or k by itself as an `axis`; None where the line has none."""
    if not letters.isdisjoint(AXES[:2]):
        return None
    result: list[Token] = []
    for token in tokens:
        if token.kind == "name" and token.text[-1] in AXES and token.text[-1] not in letters:
            result += _split_axis(token, letters)
        else:
            result.append(token)
    return result if any(token.kind == "axis" for token in result) else None


def _split_axis(token: Token, letters: frozenset[str]) -> list[Token]:
    """`mgj` as mg and j; a token that has a meaning of its own stays."""
    if token.text in AXES:
        return [Token("axis", token.text, token.start, token.end)]
    front = Token("name", token.text[:-1], token.start, token.end - 1)
    if are_letters((token,), letters) or not are_letters((front,), letters):
        return [token]
    return [front, Token("axis", token.text[-1], token.end - 1, token.end)]


def read_axes(text: str, tokens: list[Token], forks: Forks, read: ReadValue) -> Reading:
    """`3i + 4j` with a unit in its terms, behind it, or behind its bracket; the tokens have their axes told apart."""
    last = closing(tokens)
    if last > 0 and any(token.kind == "axis" for token in tokens[:last]) and looks_like_unit(tokens[last + 1 :]):
        behind = tokens[last + 1 :]
        tokens = [*tokens[1:last], end_at(tokens[last])]
    else:
        final = max(index for index, token in enumerate(tokens) if token.kind == "axis")
        behind = tokens[final + 1 :] if looks_like_unit(tokens[final + 1 :]) else tokens[-1:]
        tokens = [*tokens[: len(tokens) - len(behind)], end_at(behind[0])]
    unit = unit_behind(text, behind, forks)
    found: dict[str, Reading] = {}
    for term in terms_of(tokens):
        axis, coefficient = component(term)
        if axis.text in found:
            raise FormulaError(f"two components along {axis.text}", axis.start, axis.end)
        pointed, remarks = with_points(coefficient, forks)
        found[axis.text] = noted(read(pointed), remarks)
    wanted = AXES if "k" in found else AXES[:2]
    shared = next((part.unit for part in found.values()), None)
    nothing = Reading(NUMBER, "0", ZERO, shared)
    return vector([found.get(axis, nothing) for axis in wanted], unit)


def terms_of(tokens: list[Token]) -> list[list[Token]]:
    """The terms of a sum with their signs, each with an `end`."""
    level, cuts = 0, [0]
    for index, token in enumerate(tokens[:-1]):
        level += (token.text in OPENING) - (token.text in CLOSING)
        if (
            level == 0
            and index
            and token.kind in ("+", "-")
            and tokens[index - 1].kind not in ("^", "/", "*", "+", "-")
        ):
            cuts.append(index)
    ends = [*cuts[1:], len(tokens) - 1]
    return [[*tokens[start:end], end_at(tokens[end])] for start, end in zip(cuts, ends, strict=True)]


def component(term: list[Token]) -> tuple[Token, list[Token]]:
    """The axis of a term, and what stands before it (1 where nothing does)."""
    places = [index for index, token in enumerate(term) if token.kind == "axis"]
    if not places:
        raise FormulaError("this term has no direction: write i or j behind it", term[0].start, term[-1].end)
    if len(places) > 1:
        axis = term[places[1]]
        raise FormulaError("two directions in one term", axis.start, axis.end)
    axis = term[places[0]]
    rest = [token for token in term if token is not axis]
    if len(rest) > 1 and rest[-2].kind == "*":
        rest = [*rest[:-2], rest[-1]]
    if all(token.kind in ("+", "-", "end") for token in rest):
        rest = [*rest[:-1], Token("number", "1", axis.start, axis.start), rest[-1]]
    if rest[0].kind == "+":
        rest = rest[1:]
    return axis, rest
