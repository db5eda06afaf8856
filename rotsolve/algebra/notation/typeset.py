"""Typeset: a formula with fraction bars, roots and raised exponents; notations such as LaTeX and MathML differ in their marks alone.

The brackets and signs are those of the formula's text.
"""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from rotsolve.algebra.formula import (
    Call,
    Constant,
    Decimal,
    Formula,
    Integral,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
)
from rotsolve.algebra.notation.letters import name_to_latex
from rotsolve.algebra.notation.text import (
    ATOM,
    BARE,
    BARE_NAMES,
    CALL,
    NEGATIVE,
    POWER,
    PRODUCT,
    QUOTIENT,
    Piece,
    Signs,
    as_told,
    closing_level,
    ends_in_integral,
    is_function,
    join_terms,
    may_be_bare,
    number_to_text,
    trails,
    unsigned,
)


class Marks(Struct, frozen=True):
    """How a notation sets each part; the parts within come as they have been set already."""

    number: Callable[[str], str]
    letter: Callable[[str], str]  # by its ASCII name
    function: Callable[[str], str]  # its name
    row: Callable[[str], str]  # several parts side by side
    signs: Signs
    beside: str  # between two factors
    before: str  # between a factor and a function without brackets
    dot: str  # between a factor and a number
    applied: str  # between a function and its argument without brackets
    comma: str
    bars: Callable[[str], str]
    root: Callable[[str], str]
    fraction: Callable[[str, str], str]
    power: Callable[[str, str], str]
    integral: Callable[[str, str, str, str], str]  # lower and upper bound, integrand, letter


def typeset(formula: Formula, marks: Marks) -> str:
    """The formula in the notation that has these marks."""
    return _set(formula, marks)[0]


def _bracketed(piece: Piece, level: int, marks: Marks) -> str:
    return piece[0] if piece[1] >= level else marks.signs.brackets(piece[0])


def _set(formula: Formula, marks: Marks) -> Piece:
    positive = unsigned(formula)
    if positive is not None:
        return marks.row(
            marks.signs.first + _bracketed(_set(positive, marks), closing_level(positive), marks)
        ), NEGATIVE
    match formula:
        case Decimal(text):
            return marks.number(text), ATOM
        case Number(value):
            text = number_to_text(value)
            if "/" not in text:
                return marks.number(text), ATOM
            return marks.fraction(marks.number(str(value.numerator)), marks.number(str(value.denominator))), QUOTIENT
        case Symbol(name) | Constant(name):
            return marks.letter(name), ATOM
        case Sum(terms) if terms:
            text, level = join_terms(terms, lambda term: _set(term, marks), marks.signs)
            return marks.row(text), level
        case Sum():
            return marks.number("0"), ATOM
        case Product(factors):
            level = NEGATIVE if ends_in_integral(formula) else PRODUCT
            return (marks.row(_set_product(factors, marks)), level) if factors else (marks.number("1"), ATOM)
        case Quotient(numerator, denominator):
            return marks.fraction(_set(numerator, marks)[0], _set(denominator, marks)[0]), QUOTIENT
        case Power(base, exponent):
            raised = _set(exponent, marks)[0]
            if is_function(formula) and isinstance(base, Call):
                return _set_call(base.function, base.arguments, marks, raised)
            return marks.power(_bracketed(_set(base, marks), ATOM, marks), raised), POWER
        case Call(function, arguments):
            return _set_call(function, arguments, marks)
        case Integral(integrand, variable, lower, upper):
            body = _bracketed(_set(integrand, marks), PRODUCT, marks)
            bounds = _set(lower, marks)[0], _set(upper, marks)[0]
            return marks.integral(*bounds, body, marks.letter(variable)), NEGATIVE
    raise TypeError(f"no way to set {formula!r}")


def _set_product(factors: tuple[Formula, ...], marks: Marks) -> str:
    text = ""
    for index, factor in enumerate(factors):
        last = index == len(factors) - 1
        body = _bracketed(_set(factor, marks), NEGATIVE if last and isinstance(factor, Integral) else QUOTIENT, marks)
        root = isinstance(factor, Call) and factor.function == "sqrt"  # its bar tells where the argument ends
        if trails(factor) and not root and not last and not is_function(factors[index + 1]):
            body = marks.signs.brackets(body)
        dotted = _starts_with_digit(factor) or (index and isinstance(factor, Number))
        dotted = dotted or (index > 0 and isinstance(factors[index - 1], Decimal))
        joint = marks.dot if dotted else marks.before if is_function(factor) else marks.beside
        text = f"{text}{joint}{body}" if text else body
    return text


def _starts_with_digit(formula: Formula) -> bool:
    """Whether the text begins with a digit on the line, which must not stand right behind a factor."""
    match formula:
        case Decimal():
            return True
        case Number(value):
            return value >= 0 and "/" not in number_to_text(value)
        case Power(base, _):
            return _starts_with_digit(base)
        case Product((first, *_)):
            return _starts_with_digit(first)
    return False


def _set_call(function: str, arguments: tuple[Formula, ...], marks: Marks, raised: str = "") -> Piece:
    arguments = as_told(function, arguments)
    inner = marks.comma.join(_set(argument, marks)[0] for argument in arguments)
    if function == "abs":
        return marks.bars(inner), ATOM
    if function == "sqrt":
        return marks.root(inner), CALL
    name = marks.function(BARE_NAMES.get(function, function))
    head = marks.power(name, raised) if raised else name
    bare = function in BARE and may_be_bare(arguments[0])
    return marks.row(head + (f"{marks.applied}{inner}" if bare else marks.signs.brackets(inner))), CALL


FUNCTIONS = {"K": "K", "F": "F", "Π": r"\Pi"} | {
    name: rf"\operatorname{{{name}}}" for name in ("atan2", "sn", "cn", "dn", "am")
}

LATEX = Marks(
    number=lambda text: text.replace("°", r"^{\circ}"),
    letter=name_to_latex,
    function=lambda name: FUNCTIONS.get(name, rf"\{name}"),
    row=str,
    signs=Signs(" + ", " - ", "-", r"\left({}\right)".format),
    beside=" ",
    before=" ",
    dot=r" \cdot ",
    applied=" ",
    comma=", ",
    bars=r"\left|{}\right|".format,
    root=r"\sqrt{{{}}}".format,
    fraction=r"\frac{{{}}}{{{}}}".format,
    power="{}^{{{}}}".format,
    integral=r"\int_{{{}}}^{{{}}} {}\,\mathrm{{d}}{}".format,
)


def to_latex(formula: Formula) -> str:
    """The formula in LaTeX, without dollar signs."""
    return typeset(formula, LATEX)
