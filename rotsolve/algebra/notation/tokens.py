"""Tokens: a formula's text cut into numbers, names and marks, with the caps that keep hostile text harmless."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import ClassVar

from msgspec import Struct

from rotsolve.algebra.formula import FUNCTIONS, Number
from rotsolve.algebra.notation.derived import DERIVED_NAMES
from rotsolve.algebra.notation.letters import FRACTIONS, RUN, SEGMENT, spellings

MAX_LENGTH = 2000
MAX_RUN = 100
MAX_DIGITS = 60
MAX_LITERAL_EXPONENT = 400
REMEMBERED = 4096  # numbers: the same few are met over and over

ALIASES = {"ln": "log", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctan2": "atan2"}
FUNCTION_NAMES = {name: name for name in (*FUNCTIONS, "integral")} | ALIASES | DERIVED_NAMES
SHORTEST = 3  # letters of a function that may stand within a run: `mlg` is m l g, and so is `lg` where both are letters
SAME_MARK = dict.fromkeys("−–", "-") | dict.fromkeys("·×⋅∙", "*") | dict.fromkeys("÷∕", "/") | {"**": "^"}
NUMBER = r"(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+\-−]?[0-9]+)?"
RAISED = r"(?P<raised>[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
_TOKEN = re.compile(
    rf"(?P<number>{NUMBER})|(?P<fraction>[{''.join(FRACTIONS)}])|(?P<name>{RUN})|{RAISED}"
    r"|(?P<mark>\*\*|[-+*/^()\[\]|,.√∫→−–·×⋅∙÷∕])|(?P<space>\s+)|(?P<other>.)"
)


class FormulaError(ValueError):
    """A text that is no formula: what is wrong, in which columns, and perhaps what was meant."""

    def __init__(self, message: str, start: int, end: int, suggestion: str | None = None) -> None:
        super().__init__(message if suggestion is None else f"{message}; did you mean `{suggestion}`?")
        self.message = message
        self.start = start
        self.end = end
        self.suggestion = suggestion


class UnknownName(FormulaError):
    """A name that is none of those that are known."""


class Token(Struct, frozen=True):
    """A piece of the text; marks have their own text as kind."""

    kind: str
    text: str
    start: int
    end: int


class Lexer:
    """Cuts a text into tokens from left to right; `special` kinds have a method, which gives the place after what it has read."""

    pattern = _TOKEN
    marks = SAME_MARK
    longest, noun = MAX_LENGTH, "formula"

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens: list[Token] = []

    def tokenize(self, start: int = 0, end: int | None = None) -> list[Token]:
        """The tokens of a part of the text, an `end` token last."""
        if len(self.text) > self.longest:
            message = f"the {self.noun} is too long: {len(self.text)} characters, at most {self.longest}"
            raise FormulaError(message, self.longest, len(self.text))
        if end is not None:
            self.text = self.text[:end]
        at, last = start, len(self.text)
        while at < last:
            at = self.step(at)
        self.emit("end", "", last, last)
        return self.tokens

    def emit(self, kind: str, found: str, start: int, end: int) -> None:
        self.tokens.append(Token(kind, found, start, end))

    def step(self, at: int) -> int:
        match = self.pattern.match(self.text, at)
        assert match is not None
        kind, found, end = str(match.lastgroup), match[0], match.end()
        special = self.special.get(kind)
        if special is not None:
            return special(self, found, at, end)
        if kind == "mark":
            kind = found = self.marks.get(found, found)
        if kind != "space":
            self.tokens.append(Token(kind, found, at, end))
        return end

    def other(self, found: str, start: int, end: int) -> int:
        """A character that is no mark; degrees stand behind a number, sin 75°."""
        if found == "°":
            self.emit(found, found, start, end)
            return end
        hint = ": a formula has no equals sign" if found == "=" else ""
        shown = found if found.isprintable() else f"U+{ord(found):04X}"
        raise FormulaError(f"unexpected character `{shown}`{hint}", start, end)

    def number(self, found: str, start: int, end: int) -> int:
        """A number; `m.5` is none times 0.5, but something that has been left out."""
        last = self.tokens[-1] if self.tokens else None
        if found.startswith(".") and last is not None and last.end == start and last.kind in ("name", ")", "]"):
            message = f"`{found}` stands right behind `{last.text}`: write `*0{found}` where it is a factor"
            raise FormulaError(message, start, end)
        self.emit("number", found, start, end)
        return end

    special: ClassVar[Mapping[str, Callable[..., int]]] = {"other": other, "number": number}


def read_number(text: str, start: int = 0) -> Fraction:
    """The exact value of a decimal literal, within the caps."""
    mantissa, _, exponent = text.lower().replace("−", "-").partition("e")
    if len(mantissa) - mantissa.count(".") > MAX_DIGITS:
        raise FormulaError(f"the number has more than {MAX_DIGITS} digits", start, start + len(text))
    if exponent and (len(exponent) > 5 or abs(int(exponent)) > MAX_LITERAL_EXPONENT):
        raise FormulaError(f"the exponent of ten is beyond ±{MAX_LITERAL_EXPONENT}", start, start + len(text))
    whole, _, decimals = mantissa.partition(".")
    return Fraction(int(whole + decimals)) * Fraction(10) ** (int(exponent or 0) - len(decimals))


@lru_cache(REMEMBERED)
def _known_number(text: str) -> Number:
    return Number(read_number(text))


def literal_number(text: str, start: int) -> Number:
    """The exact number that a text at a place writes."""
    try:
        return _known_number(text)
    except FormulaError:
        return Number(read_number(text, start))  # fails again, at its place


def resolve(token: Token, names: Collection[str] | None, bound: Collection[str], *, split: bool) -> list[Token]:
    """What a run of name characters means: one symbol, constant or function, or several of them side by side."""
    raw = token.text
    whole = one_name(token, names, bound)
    if whole is not None:
        return [whole]
    pieces = [Token("name", m[0], token.start + m.start(), token.start + m.end()) for m in re.finditer(SEGMENT, raw)]
    if names is not None and split:
        found = side_by_side(token, names, bound)
        if found:
            return found
        known = [*names, *bound, *FUNCTION_NAMES]
        raise UnknownName(f"unknown name `{raw}`", token.start, token.end, suggest(raw, known))
    if len(pieces) == 1 or sum(len(piece.text) for piece in pieces) < len(raw):
        return [Token("symbol", spellings(raw)[0], token.start, token.end)]
    return [
        one_name(piece, names, bound) or Token("symbol", spellings(piece.text)[0], piece.start, piece.end)
        for piece in pieces
    ]


def one_name(token: Token, names: Collection[str] | None, bound: Collection[str]) -> Token | None:
    """The token as one known name, function or constant; None if it is none."""
    raw = token.text
    candidates = spellings(raw)
    known = [name for name in candidates if name in bound or (names is not None and name in names)]
    if raw in known:
        known = [raw]
    if len(known) > 1:
        choice = " or ".join(f"`{name}`" for name in known)
        raise FormulaError(f"`{raw}` can be read in two ways: write {choice}", token.start, token.end)
    if known:
        return Token("symbol", known[0], token.start, token.end)
    function = next((FUNCTION_NAMES[name] for name in candidates if name in FUNCTION_NAMES), None)
    if function is not None and not (len(raw) < SHORTEST and names is not None and all(char in names for char in raw)):
        return Token("function", function, token.start, token.end)
    return Token("constant", "pi", token.start, token.end) if candidates[0] == "pi" else None


def side_by_side(token: Token, names: Collection[str], bound: Collection[str]) -> list[Token]:
    """The run as known names side by side, longest first; empty if it does not split fully."""
    raw = token.text[:MAX_RUN]
    size = len(token.text)
    if size > MAX_RUN:
        return []
    longest = max(map(len, (*names, *bound, "arctan2")))
    # parts[i] splits raw[i:]; built from the end, so that the time stays quadratic at worst.
    parts: list[list[Token] | None] = [None] * size + [[]]
    for start in range(size - 1, -1, -1):
        for end in range(min(size, start + longest), start, -1):
            rest = parts[end]
            if rest is None:
                continue
            piece = one_name(Token("name", raw[start:end], token.start + start, token.start + end), names, bound)
            # A function comes last, before its argument, or in front of a Greek letter: `mgsin`, `cosθ`.
            called = piece is not None and piece.kind == "function"
            if piece is not None and (not called or (end - start >= SHORTEST and (not rest or not raw[end].isascii()))):
                parts[start] = [piece, *rest]
                break
    return parts[0] or []


def suggest(word: str, known: Collection[str]) -> str | None:
    """The known word that was probably meant."""
    folded = [name for name in known if name.lower() == spellings(word)[0].lower()]
    if folded:
        return folded[0]
    from difflib import get_close_matches  # only a faulty text pays for this import

    return next(iter(get_close_matches(word, list(known), n=1)), None)
