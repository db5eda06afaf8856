"""Commands: what the LaTeX commands mean that a student may write."""

from __future__ import annotations

from rotsolve.algebra.notation.letters import GREEK_LETTERS
from rotsolve.algebra.notation.tokens import FUNCTION_NAMES, FormulaError
from rotsolve.grading.reading.grammar.functions import RECIPROCAL

NAMES = (  # commands that are letters or functions
    GREEK_LETTERS
    | {f"var{name}": GREEK_LETTERS[name] for name in ("epsilon", "theta", "phi", "rho", "sigma")}
    | {name: name for name in (*FUNCTION_NAMES, *RECIPROCAL) if name not in ("sqrt", "integral")}
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


def command_mark(word: str) -> str | None:
    """The mark that a command stands for."""
    return _MARK_OF.get(word)


def unknown_command(found: str, start: int, end: int) -> FormulaError:
    """The fault that no such command is known, with the one that was probably meant."""
    from difflib import get_close_matches  # only a faulty text pays for this import

    known = [*NAMES, *FRACTION, "sqrt", *CONTENT, *_MARK_OF]
    meant = next(iter(get_close_matches(found[1:], known, n=1)), None)
    return FormulaError(f"unknown LaTeX command `{found}`", start, end, f"\\{meant}" if meant else None)
