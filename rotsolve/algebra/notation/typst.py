"""Typst: a formula in the mathematics of Typst, `frac(1, 2) M R^2`, without dollar signs; and how Typst writes text between quotes."""

from __future__ import annotations

import re

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.letters import GREEK_LETTERS, PRIME, from_superscript, parts
from rotsolve.algebra.notation.text import Signs
from rotsolve.algebra.notation.typeset import Marks, typeset

KNOWN = frozenset(("sin", "cos", "tan", "ln", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "exp"))  # functions
SPECIAL = str.maketrans({"\\": r"\\", '"': r"\"", "\n": r"\n"})
SIMPLE = re.compile(r'[A-Za-z]|[0-9]+|"[^"\\]*"')  # stands raised or lowered without brackets
UNIT = re.compile(r"(?P<raised>[⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹]+|\^\([^)]*\))|(?P<mark>[ /])|(?P<word>[^⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹^ /]+)")


def to_typst(formula: Formula) -> str:
    """The formula as it stands between dollar signs."""
    return typeset(formula, MARKS)


def typst_string(text: str) -> str:
    """A text between quotes, in which Typst reads nothing; letters that do not print are left out."""
    return f'"{"".join(char for char in text if char.isprintable() or char == chr(10)).translate(SPECIAL)}"'


def name_to_typst(name: str) -> str:
    """An ASCII name as a letter with what stands below it: theta_0, a_"end"; a name that is no letter, such as a path, as text."""
    found = parts(name)
    if found is None:
        return typst_string(name)
    below = filter(None, (found.index, head_in_typst(found.word) if found.word else ""))
    head = head_in_typst(found.head)
    if found.dots:
        head = f"{('dot', 'dot.double')[found.dots - 1]}({head})"
    text = ("Delta " if found.change else "") + head + PRIME * found.prime + attached("_", ",".join(below))
    return f"{text} ({name_to_typst(found.of)})" if found.of else text


def head_in_typst(head: str) -> str:
    """A letter or a number as it stands, a word upright."""
    plain = head in GREEK_LETTERS or len(head) == 1 or head.isdigit()
    return head if plain else typst_string(head.replace("_", ","))


def attached(sign: str, text: str) -> str:
    """What is raised by `^` or lowered by `_`: in brackets, which do not print, where it has parts; nothing where it is empty."""
    simple = text in GREEK_LETTERS or SIMPLE.fullmatch(text)
    return f"{sign}{text}" if simple else f"{sign}({text})" if text else ""


def number_to_typst(text: str) -> str:
    """A decimal number, with its power of ten where it has one."""
    mantissa, power, exponent = text.partition("e")
    return f"{mantissa} times 10^({exponent.lstrip('+')})" if power else text


def function_in_typst(name: str) -> str:
    """The name of a function, upright, but for the elliptic integrals."""
    letter = {"K": "K", "F": "F", "Π": "Pi"}.get(name)
    return letter or (name if name in KNOWN else f'op("{name}")')


def unit_in_typst(text: str) -> str:
    """A unit as it is printed, `kg m²/s`, upright and with raised powers."""
    return "".join(map(unit_piece, UNIT.finditer(text)))


def unit_piece(found: re.Match[str]) -> str:
    if found["mark"]:
        return {" ": " thin ", "/": r"\/"}[found["mark"]]
    if found["word"]:
        return found["word"] if found["word"].isdigit() else typst_string(found["word"])
    raised = found["raised"]
    return attached("^", raised[2:-1] if raised[0] == "^" else from_superscript(raised))


MARKS = Marks(
    number=number_to_typst,
    letter=name_to_typst,
    function=function_in_typst,
    row=str,
    signs=Signs(" + ", " - ", "-", "({})".format),
    beside=" ",
    before=" ",
    dot=" dot ",
    applied=" ",
    comma=", ",
    bars="abs({})".format,
    root="sqrt({})".format,
    fraction="frac({}, {})".format,
    power=lambda base, raised: base + attached("^", raised),
    integral="integral_({})^({}) {} dif {}".format,
)
