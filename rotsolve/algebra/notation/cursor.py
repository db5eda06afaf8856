"""Cursor: a place in a formula's tokens, the brackets open there, and the faults that can be told without grammar.

What the letters of a text mean, and which marks it may hold, is said by its vocabulary.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ELLIPTIC, FUNCTIONS
from rotsolve.algebra.notation.tokens import FormulaError, Token, resolve

MAX_NESTING = 60
CALLED_SO = {
    (printed, FUNCTIONS[name]): name for name, printed in ELLIPTIC.items()
}  # functions before a bracket with so many arguments, where these are no letters

CLOSERS = {"(": ")", "[": "]", "|": "|"}
DIFFERENTIAL = re.compile(r"d[^\W\d_]\w*")  # dx, dθ, dt_1
STARTS = frozenset(("number", "fraction", "name", "symbol", "constant", "function", "(", "[", "√", "∫"))


class Vocabulary(Struct, frozen=True):
    """What a text may hold: its letters (None: any), dotted paths such as `rod.end.speed`, and how functions are called.

    `strict` refuses `a/b c`; `euler` is the letter whose powers are those of e, '' for none; `inverses` are functions whose power
    of −1 may be the inverse, and `powered` those whose argument without brackets takes a power: √x².
    """

    names: Collection[str] | None = None
    paths: bool = False
    strict: bool = False
    euler: str = ""
    inverses: Mapping[str, str] = {}
    powered: Collection[str] = ()

    def meanings(self, cursor: Cursor) -> list[Token]:
        """What the name ahead means: one token, or several if a run of letters splits."""
        token = cursor.token
        function = self.elliptic(cursor)
        if function:
            return [replace(token, kind="function", text=function)]
        return resolve(token, self.names, cursor.bound, split=not self.paths)

    def elliptic(self, cursor: Cursor) -> str:
        """The elliptic function whose printed name stands ahead, as `K(m)` or `sn(u, m)`, where no letter is called so; else ''."""
        ahead = cursor.tokens[cursor.index : cursor.index + 2]
        known = self.names is None or ahead[0].text in self.names or ahead[0].text in cursor.bound
        if known or ahead[-1].kind != "(" or ahead[0].text not in ELLIPTIC.values():
            return ""
        return CALLED_SO.get((ahead[0].text, cursor.commas(cursor.index + 2) + 1), "")


class Forks:
    """One way through the places at which a text can be read in two ways: at which of them it takes the unlikely branch."""

    def __init__(self, departures: tuple[bool, ...] = ()) -> None:
        self.departures = departures
        self.taken: list[bool] = []

    def choose(self, likely: bool) -> bool:
        """The answer to a question that the text leaves open: the likely one, or on some ways the other."""
        index = len(self.taken)
        departs = index < len(self.departures) and self.departures[index]
        self.taken.append(departs)
        return likely != departs


class Cursor:
    """Reads tokens one by one; without forks, what can be read in two ways is refused."""

    def __init__(self, text: str, tokens: list[Token], vocabulary: Vocabulary, forks: Forks | None = None) -> None:
        self.text = text
        self.tokens = tokens
        self.vocabulary = vocabulary
        self.forks = forks
        self.index = 0
        self.depth = 0
        self.open: list[Token] = []  # the brackets that are open, innermost last
        self.bound: list[str] = []  # variables of integration
        self.stop: Token | None = None  # the `d` of the innermost integral

    @property
    def token(self) -> Token:
        return self.tokens[self.index]

    def next(self) -> Token:
        token = self.tokens[self.index]
        self.index += 1
        return token

    def enter(self) -> None:
        self.depth += 1
        if self.depth > MAX_NESTING:
            token = self.token
            raise FormulaError(f"nested too deep: at most {MAX_NESTING} levels", token.start, token.end)

    def unexpected(self) -> FormulaError:
        token = self.token
        if token.kind == "end" and self.open:
            opening = self.open[-1]
            return FormulaError(f"this `{opening.text}` is never closed", opening.start, opening.end)
        if token.kind == "end":
            what = "ends too early" if self.index else "is empty"
            return FormulaError(f"the formula {what}", token.start, token.end)
        if token.kind == ",":
            return FormulaError("unexpected comma: a decimal number takes a point, `1.5`", token.start, token.end)
        if token.kind in CLOSERS.values():
            return FormulaError(f"this `{token.text}` closes nothing", token.start, token.end)
        return FormulaError(f"unexpected `{self.text[token.start : token.end]}`", token.start, token.end)

    def two_ways(self, start: int, end: int, cure: str) -> FormulaError:
        return FormulaError(f"`{self.text[start:end]}` can be read in two ways: write {cure}", start, end)

    def refuse(self, start: int, end: int, cure: str) -> None:
        """Refuse what can be read in two ways, where there are no forks."""
        if self.forks is None:
            raise self.two_ways(start, end, cure)

    def tight(self) -> bool:
        """Whether the next token stands close to the one before it."""
        return self.tokens[self.index - 1].end == self.token.start

    def open_bracket(self, opening: Token) -> None:
        self.enter()
        self.open.append(opening)

    def close_bracket(self) -> None:
        """Read the mark that closes the innermost bracket."""
        if self.token.kind != CLOSERS[self.open[-1].kind]:
            raise self.unexpected()
        self.open.pop()
        self.depth -= 1
        self.index += 1

    def expect(self, mark: str) -> None:
        if self.token.kind != mark:
            raise self.unexpected()
        self.next()

    def at_path(self) -> bool:
        """Whether a dotted path begins here: names joined by dots, without spaces."""
        if not self.vocabulary.paths:
            return False
        first, dot, second = (*self.tokens[self.index : self.index + 3], self.token, self.token)[:3]
        adjacent = first.end == dot.start and dot.end == second.start
        return first.kind == second.kind == "name" and dot.kind == "." and adjacent

    def expand(self) -> int:
        """Replace the name ahead by what it means, several tokens if a run of letters splits; their number."""
        token = self.token
        if token.kind != "name" or self.at_path():
            return 1
        meanings = self.vocabulary.meanings(self)
        self.tokens[self.index : self.index + 1] = meanings
        return len(meanings)

    def starts_factor(self) -> bool:
        """Whether the next token multiplies what was read, without a mark between them."""
        token = self.token
        if token is self.stop:
            return False
        if token.kind == "|":
            return not (self.open and self.open[-1].kind == "|")
        before = self.tokens[self.index - 1]
        if token.kind in ("number", "fraction") and before.kind in ("number", "fraction"):
            both = self.text[before.start : token.end]
            raise FormulaError(f"two numbers side by side: `{both}`", before.start, token.end)
        return token.kind in STARTS

    def find(self, start: int, wanted: str) -> int:
        """The index of the first `wanted` outside of brackets from `start` on; -1 where there is none."""
        level = 0
        for index in range(start, len(self.tokens) - 1):
            token, after = self.tokens[index], self.tokens[index + 1]
            if level == 0 and token.text == wanted and (wanted != "d" or after.kind in ("name", "symbol")):
                return index
            level += (token.kind in "([") - (token.kind in ")]")
            if level < 0:
                break
        return -1

    def commas(self, start: int) -> int:
        """How many commas stand within the bracket that opens before `start`, not in others."""
        count, level = 0, 0
        for token in self.tokens[start:]:
            count += token.kind == "," and level == 0
            level += (token.kind in ("(", "[")) - (token.kind in (")", "]"))
            if level < 0:
                break
        return count

    def differential(self, start: int) -> int:
        """The index of the `d` that ends an integrand from `start` on; `dx` in one run is taken apart; -1 where there is none."""
        apart, level, barred = self.find(start, "d"), 0, False
        for index in range(start, len(self.tokens) - 1 if apart < 0 else apart):
            token = self.tokens[index]
            barred ^= token.kind == "|"
            if level == 0 and not barred and token.kind in "+-":
                break
            if level == 0 and token.kind in ("name", "symbol") and DIFFERENTIAL.fullmatch(token.text):
                split = token.start + 1
                name = Token(token.kind, token.text[1:], split, token.end)
                self.tokens[index : index + 1] = [Token("name", "d", token.start, split), name]
                return index
            level += (token.kind in "([") - (token.kind in ")]")
            if level < 0:
                break
        return apart
