"""Tokens: a student's line cut into numbers, names and marks, each with its columns as typed; LaTeX becomes the marks that it means.

`\\frac{a}{b}` is ((a)/(b)), `\\sqrt{x}` is √(x), `\\omega_{0}` is ω_0, `^{\\circ}` is °; spaces and `\\left` mean nothing.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import ClassVar
from unicodedata import decimal, normalize

from rotsolve.algebra.notation.cursor import MAX_NESTING
from rotsolve.algebra.notation.letters import FRACTIONS, GREEK_LETTERS, RUN
from rotsolve.algebra.notation.tokens import FUNCTION_NAMES, NUMBER, RAISED, SAME_MARK, FormulaError, Lexer, Token

NAMES = (  # commands that are letters or functions
    GREEK_LETTERS
    | {f"var{name}": GREEK_LETTERS[name] for name in ("epsilon", "theta", "phi", "rho", "sigma")}
    | {name: name for name in FUNCTION_NAMES if name not in ("sqrt", "integral")}
    | {"imath": "i", "jmath": "j"}
)
FRACTION = frozenset(("frac", "dfrac", "tfrac", "cfrac"))
_CONTENT = """
    text textrm textit textbf textsf mathrm mathit mathbf mathsf mathcal boldsymbol bm rm operatorname mbox vec hat bar
    overline unit si
"""
_SILENT = """
    left right big Big bigg Bigg bigl bigr Bigl Bigr biggl biggr quad qquad displaystyle textstyle limits nolimits thinspace
    , ; : ! ( ) [ ]
"""
CONTENT = frozenset(_CONTENT.split())  # how letters are set
SILENT = frozenset((*_SILENT.split(), " "))  # what says nothing
_MARKS = {
    "*": "cdot times ast bullet",
    "/": "div slash",
    "|": "vert lvert rvert mid |",
    "(": "langle lbrace {",
    ")": "rangle rbrace }",
    "=": "approx simeq",
    "°": "degree circ",
    ";": "\\",
    "%": "%",
    "relation": "le leq ge geq lt gt ne neq",
}
_MARK_OF = {command: mark for mark, commands in _MARKS.items() for command in commands.split()}
MAX_LENGTH = 600
MARKS = {
    **SAME_MARK,
    **dict.fromkeys("⁄∶", "/"),
    **dict.fromkeys("—‐‑‒", "-"),
    **dict.fromkeys("•∗", "*"),
    **dict.fromkeys(("≈", "≃", ":=", "==", "＝"), "="),
    **{"⟨": "(", "⟩": ")", "∣": "|", "º": "°", "&": ";"},
}
_TOKEN = re.compile(
    rf"(?P<space>[\s$~\u0302\u20d7]+)|(?P<number>{NUMBER})|(?P<fraction>[{''.join(FRACTIONS)}])|(?P<name>[ÅÅ](?:ngstr[öo]ms?)?|[îĵŷẑê]|[ijkxyz]\u0302|{RUN})"
    rf"|{RAISED}"
    r"|(?P<degree>\^\s*(?:\\circ(?![A-Za-z])|\{\s*\\circ\s*\}))"
    r"|(?P<command>\\(?:[A-Za-z]+|.))|(?P<brace>[{}])|(?P<relation><=|>=|!=|[<>≤≥≠])"
    r"|(?P<mark>\*\*|:=|==|[-+*/^()\[\]|,;=.√∫→°º%@∠−–—‐‑‒·×⋅∙•∗÷∕⁄∶⟨⟩∣≈≃＝&])|(?P<other>.)"
)
_CALLED = re.compile(rf"(?<!_)(?:{'|'.join(sorted(FUNCTION_NAMES, key=len, reverse=True))})(?=[0-9])")
_INDEX = re.compile(r"_\s*(?:\{([^{}]*(?:\{[^{}]*\}[^{}]*)*)\}|([0-9]+|[A-Za-z]+)|(\\[A-Za-z]+))")
_MATRIX = re.compile(r"\s*\{\s*(?:[pbvBV]?(?:small)?matrix\s*\}|array\s*\}(?:\s*\{[^{}]*\})?)")
_CHANGED = re.compile(rf"\s*(?:\\({'|'.join(GREEK_LETTERS)})(?![A-Za-z])|([A-Za-z]))")
_ROOT = re.compile(r"\s*\[\s*([0-9]+)\s*\]")
_HATTED = {"î": "i", "ĵ": "j", "k\u0302": "k", "i\u0302": "i", "j\u0302": "j", "ê": "e"}  # no letters but unit vectors
_HATTED |= {"ŷ": "e_y", "ẑ": "e_z", **{f"{axis}\u0302": f"e_{axis}" for axis in "xyz"}}


def plain_width(text: str) -> str:
    """The text with the digits of other scripts and full-width marks as plain ones, column by column: １２．５ is 12.5."""
    return text if text.isascii() else "".join(map(_plain_form, text))


def _plain_form(char: str) -> str:
    digit = decimal(char, None)
    if digit is not None:
        return str(digit)
    return normalize("NFKC", char) if "！" <= char <= "～" else char


def unknown_command(found: str, start: int, end: int) -> FormulaError:
    """The fault that no such command is known, with the one that was probably meant."""
    from difflib import get_close_matches  # only a faulty text pays for this import

    known = [*NAMES, *FRACTION, "sqrt", *CONTENT, *_MARK_OF]
    meant = next(iter(get_close_matches(found[1:], known, n=1)), None)
    return FormulaError(f"unknown LaTeX command `{found}`", start, end, f"\\{meant}" if meant else None)


class LineLexer(Lexer):
    """Reads a line with LaTeX in it; each method takes the place where something begins and gives the place after it."""

    pattern = _TOKEN
    marks = MARKS
    longest, noun = MAX_LENGTH, "answer"

    def __init__(self, text: str) -> None:
        super().__init__(plain_width(text))
        self.depth = 0

    def name(self, found: str, start: int, end: int) -> int:
        """A run of letters, with its index where that stands in braces: `v_{end}`."""
        called = _CALLED.search(found)
        if called and found not in FUNCTION_NAMES:  # sin2θ is sin 2θ, but atan2 is atan2
            self.emit("name", found[: called.end()], start, start + called.end())
            return start + called.end()
        found = _HATTED.get(found, found)
        bare = found.rstrip("_")
        at = start + len(bare) if end - start == len(found) else end
        index = _INDEX.match(self.text, at) if self.text.startswith("_", at) else None
        if index is None:
            self.emit("name", found, start, end)
            return end
        braced, plain, command = index.groups()
        content = plain or _index_text(braced if braced is not None else command)
        self.emit("name", f"{bare}_{content}" if content else bare, start, index.end())
        return index.end()

    def brace(self, found: str, start: int, end: int) -> int:
        if found == "}":
            raise FormulaError("this `}` closes nothing", start, end)
        return self.group(start, end)

    def group(self, start: int, at: int) -> int:
        """What stands in braces, which are brackets."""
        self.emit("(", "(", start, at)
        at = self.inside(start, at)
        self.emit(")", ")", at - 1, at)
        return at

    def inside(self, start: int, at: int) -> int:
        """What stands up to the brace that closes the one at `start`."""
        self.depth += 1
        if self.depth > MAX_NESTING:
            raise FormulaError(f"nested too deep: at most {MAX_NESTING} levels", start, start + 1)
        while not self.text.startswith("}", at):
            if at >= len(self.text):
                raise FormulaError("this `{` is never closed", start, start + 1)
            at = self.step(at)
        self.depth -= 1
        return at + 1

    def degree(self, found: str, start: int, end: int) -> int:
        self.emit("°", "°", start, end)
        return end

    def command(self, found: str, start: int, end: int) -> int:
        """A LaTeX command with what belongs to it."""
        word = found[1:]
        if word in SILENT:
            return end
        change = _CHANGED.match(self.text, end) if word == "Delta" else None
        if change:  # \Delta K is ΔK
            return self.name("Δ" + (change[2] or NAMES.get(change[1], "")), start, change.end())
        if word in NAMES:
            return self.name(NAMES[word], start, end)
        if word in FRACTION:
            return self.fraction(start, end)
        if word == "sqrt":
            return self.root(start, end)
        if word in CONTENT:
            return self.content(word, start, end)
        if word in ("begin", "end"):
            return self.matrix(word, start, end)
        mark = _MARK_OF.get(word)
        if mark is None:
            raise unknown_command(found, start, end)
        self.emit(mark, mark, start, end)
        return end

    def argument(self, command: int, at: int) -> int:
        """What a command takes: a group in braces, another command, or one letter or digit."""
        while self.text[at : at + 1].isspace():
            at += 1
        following = self.text[at : at + 1]
        if following == "{":
            return self.group(at, at + 1)
        if following == "\\":
            return self.step(at)
        if not following.isalnum():
            raise FormulaError(f"`{self.text[command:at].strip()}` needs an argument in braces", command, at)
        self.emit("number" if following.isdecimal() else "name", following, at, at + 1)
        return at + 1

    def fraction(self, start: int, at: int) -> int:
        self.emit("(", "(", start, at)
        middle = self.argument(start, at)
        self.emit("/", "/", middle, middle)
        last = self.argument(start, middle)
        self.emit(")", ")", last, last)
        return last

    def root(self, start: int, at: int) -> int:
        """√(x), or (x)^(1/n) for the nth root."""
        nth = _ROOT.match(self.text, at)
        if nth is None:
            self.emit("√", "√", start, at)
        self.emit("(", "(", start, at)
        last = self.argument(start, nth.end() if nth else at)
        self.emit(")", ")", last, last)
        if nth:
            for mark in ("^", "(", "1", "/", nth[1], ")"):
                self.emit("number" if mark.isdigit() else mark, mark, *nth.span(1))
        return last

    def matrix(self, word: str, start: int, at: int) -> int:
        """A column of components, which is a list in brackets."""
        match = _MATRIX.match(self.text, at)
        if match is None:
            raise FormulaError(f"`\\{word}` needs the name of a matrix, such as {{pmatrix}}", start, at)
        mark = "(" if word == "begin" else ")"
        self.emit(mark, mark, start, match.end())
        return match.end()

    def content(self, word: str, start: int, at: int) -> int:
        """The content of \\text{…} and its like, which only says how letters are set; \\hat{x} is a unit vector."""
        before = len(self.tokens)
        while self.text[at : at + 1].isspace():
            at += 1
        at = self.inside(at, at + 1) if self.text.startswith("{", at) else self.argument(start, at)
        if self.text.startswith("_", at) and self.tokens and self.tokens[-1].kind == "name":
            named = self.tokens.pop()  # \mathrm{hp}_{m}
            return self.name(named.text, named.start, at)
        if word == "hat" and len(self.tokens) == before + 1 and self.tokens[-1].text in ("x", "y", "z"):
            axis = self.tokens.pop()
            self.emit("name", f"e_{axis.text}", axis.start, axis.end)
        return at

    def other(self, found: str, start: int, end: int) -> int:
        """A character that is no mark: the plain letter that it is a form of, such as 𝑚 or ｍ."""
        plain = normalize("NFKC", found)
        match = _TOKEN.fullmatch(plain)
        if match is not None and plain != found and not plain.startswith("\\"):
            mark = MARKS.get(plain, plain)
            is_mark = match.lastgroup == "mark"
            self.emit(mark if is_mark else str(match.lastgroup), mark if is_mark else plain, start, end)
            return end
        return super().other(found, start, end)

    special: ClassVar[Mapping[str, Callable[..., int]]] = {
        **Lexer.special,
        "name": name,
        "command": command,
        "brace": brace,
        "degree": degree,
        "other": other,
    }


def tokens_of(text: str, start: int = 0, end: int | None = None) -> list[Token]:
    """The tokens of a line, or of a part of it, an `end` token last."""
    return LineLexer(text).tokenize(start, end)


def _index_text(content: str) -> str:
    """The index that LaTeX writes: `\\text{end}` is end, `1,x` is 1_x, `\\alpha` is α."""
    words = re.sub(r"\\([A-Za-z]+)\s*", lambda match: NAMES.get(match[1], ""), content)
    return re.sub(r"[\s,]+", "_", re.sub(r"[{}]", "", words).strip())
