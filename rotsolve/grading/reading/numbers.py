"""Numbers: a number with its unit as typed, and how many significant figures it has."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from rotsolve.algebra.notation.letters import from_superscript, superscripted
from rotsolve.algebra.notation.tokens import FormulaError, Token
from rotsolve.algebra.units.dimension import kind_of
from rotsolve.algebra.units.unit_table import AMBIGUOUS, UNITS
from rotsolve.grading.reading.grammar.forks import Forks
from rotsolve.grading.reading.grammar.formulas import read_formula
from rotsolve.grading.reading.grammar.runs import LONGEST, meaning
from rotsolve.grading.reading.records import NUMBER, Reading, echo
from rotsolve.grading.reading.units import MARKS, looks_like_unit, read_unit

WEIGHT = "mg"  # seldom milligrams where both are letters
NO_NAMES: frozenset[str] = frozenset()


class Parts(Struct, frozen=True):
    """A line cut where a unit may begin: the number before it, and the unit (nothing but its `end` where there is none)."""

    number: tuple[Token, ...]
    unit: tuple[Token, ...]

    @property
    def has_unit(self) -> bool:
        return len(self.unit) > 1


def cut(tokens: list[Token]) -> Parts:
    """The tokens before the first word that belongs to no number, and those from there on; `3/s` and `3 1/s` have 1/s."""
    at = unit_start(tokens)
    while at and at < len(tokens) - 1 and tokens[at - 1].kind in ("(", "["):
        at -= 1  # that of a fraction of units, or of [m/s]
    before, unit = tokens[:at], tokens[at:]
    if len(unit) > 1 and before and before[-1].kind == "/":
        slash = before.pop()
        one = Token("number", "1", slash.start, slash.start)
        unit = [one, slash, *unit]
        if len(before) > 1 and before[-1].text == "1" and before[-2].kind in ("number", "raised", "fraction"):
            before.pop()
    elif len(unit) > 1 and before and before[-1].kind == "*":
        before.pop()
    end = unit[0].start
    return Parts((*before, Token("end", "", end, end)), tuple(unit))


def unit_start(tokens: list[Token]) -> int:
    """The index of the first word that is no function or π, or of a sign of degrees outside of functions (sin 30° is a number)."""
    called = False
    for index, token in enumerate(tokens):
        if token.kind == "name":
            if meaning(token.text, NO_NAMES) is None:
                return index
            called = called or token.text not in ("pi", "π")
        elif token.kind == "%" or (token.kind == "°" and not called):
            return index
    return len(tokens) - 1


def read_number(text: str, parts: Parts, forks: Forks) -> Reading:
    """The number with its unit."""
    number = list(parts.number)
    value = read_formula(text, number, NO_NAMES, forks)
    unit = read_unit(text, list(parts.unit), forks) if parts.has_unit else None
    written, figures = literal(number)
    shown = written or echo(value)
    return Reading(NUMBER, unit.after(shown) if unit else shown, value, unit, figures)


def literal(tokens: list[Token]) -> tuple[str, int | None]:
    """A decimal number as it is printed, and its significant figures; nothing for what is no plain decimal.

    Zeros at the end of a whole number do not count: 1200 may be told to two figures.
    """
    if tokens[0].kind == "(" and tokens[-2].kind == ")":
        tokens = [*tokens[1:-2], tokens[-1]]
    sign = "−" if tokens[0].kind == "-" else ""
    plain = tokens[tokens[0].kind in ("-", "+") : -1]
    if not plain or plain[0].kind != "number":
        return "", None
    mantissa, _, exponent = plain[0].text.lower().partition("e")
    power = exponent.replace("−", "-") or _power_of_ten(plain[1:])
    if power is None:
        return "", None
    digits = mantissa.replace(".", "").lstrip("0")
    figures = len(digits if "." in mantissa else digits.rstrip("0"))
    raised = f"×10{superscripted(int(power))}" if power else ""
    return f"{sign}{mantissa}{raised}", max(figures, 1)


def _power_of_ten(tokens: list[Token]) -> str | None:
    """The exponent in `*10^3`, '' where nothing is there, None where something else is."""
    kinds = [token.kind for token in tokens]
    if not tokens:
        return ""
    if kinds[:2] != ["*", "number"] or tokens[1].text != "10":
        return None
    if kinds[2:] == ["raised"]:
        return from_superscript(tokens[2].text)
    digits = "".join(token.text for token in tokens[3:] if token.kind not in "()")
    return digits if kinds[2:3] == ["^"] and digits.removeprefix("-").isdigit() else None


def could_be_number(parts: Parts) -> bool:
    """Whether a number stands in front of what can be a unit; no bracket reaches from one into the other."""
    depth = sum((token.kind in "([") - (token.kind in ")]") for token in parts.number[:-1])
    return depth == 0 and len(parts.number) > 1 and (not parts.has_unit or looks_like_unit(list(parts.unit)))


def are_letters(tokens: Iterable[Token], names: frozenset[str]) -> bool:
    """Whether all words are letters of the scene."""
    return all(
        meaning(token.text, names) is not None if token.kind == "name" else token.kind not in ("°", "%")
        for token in tokens
    )


def is_strange_unit(parts: Parts, names: frozenset[str]) -> bool:
    """Whether a number stands apart in front of words of which none begins with a letter of the scene: `12 hp`, `3.4 m/ss`."""
    words = [token.text for token in parts.unit if token.kind == "name"]
    plain = all(token.kind == "name" or token.kind in MARKS for token in parts.unit[:-1])
    apart = parts.has_unit and len(parts.number) > 1 and parts.unit[0].start > parts.number[-2].end
    numeric = all(token.kind not in ("name", "√") for token in parts.number)
    strange = all(word in AMBIGUOUS or not begins_with_letter(word, names) for word in words)
    return plain and apart and numeric and strange


def begins_with_letter(word: str, names: frozenset[str]) -> bool:
    """Whether a letter of the scene stands first in a run, so that it is rather a product than a unit."""
    return any(meaning(word[:end], names) is not None for end in range(1, min(len(word), LONGEST) + 1))


def likely_number(parts: Parts) -> bool:
    """Whether `12 m` is likelier a length than a product of letters: by a decimal point, or by a space before m, N or km, not before g."""
    last, first = parts.number[-2], parts.unit[0]
    if any("." in token.text for token in parts.number):
        return True
    if first.start == last.end:
        return False
    words = [token.text for token in parts.unit if token.kind == "name"]
    long = any(len(word) > 1 and word in UNITS and word != WEIGHT for word in words)
    return long or all(word in UNITS and UNITS[word].scale == 1 for word in words)


def is_kind(unit: tuple[Token, ...]) -> bool:
    """Whether a unit is that of a known kind of quantity, or a power of one unit: N m and m⁴ are, m g is not."""
    names = [token.text for token in unit if token.kind == "name"]
    if len(names) == 1 and names[0] in UNITS and any(token.kind in ("raised", "^") for token in unit):
        return True
    try:
        return kind_of(read_unit("", list(unit), Forks()).dimension) is not None
    except FormulaError:
        return False
