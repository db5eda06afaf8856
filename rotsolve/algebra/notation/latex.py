"""LaTeX: a formula as LaTeX source, with the same brackets and signs as its text."""

from __future__ import annotations

from rotsolve.algebra.formula import Call, Constant, Formula, Integral, Number, Power, Product, Quotient, Sum, Symbol
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
    is_function,
    join_terms,
    may_be_bare,
    number_to_text,
    trails,
    unsigned,
)


def latex(formula: Formula) -> str:
    """The formula in LaTeX, without dollar signs."""
    return _latex(formula)[0]


def _wrap(piece: Piece, level: int) -> str:
    return piece[0] if piece[1] >= level else rf"\left({piece[0]}\right)"


def _latex(formula: Formula) -> Piece:
    positive = unsigned(formula)
    if positive is not None:
        return f"-{_wrap(_latex(positive), PRODUCT)}", NEGATIVE
    match formula:
        case Number(value):
            text = number_to_text(value)
            if "/" not in text:
                return text, ATOM
            return rf"\frac{{{value.numerator}}}{{{value.denominator}}}", QUOTIENT
        case Symbol(name) | Constant(name):
            return name_to_latex(name), ATOM
        case Sum(terms):
            return join_terms(terms, _latex, "-", r"\left(", r"\right)") if terms else ("0", ATOM)
        case Product(factors):
            return (_product(factors), PRODUCT) if factors else ("1", ATOM)
        case Quotient(numerator, denominator):
            return rf"\frac{{{_latex(numerator)[0]}}}{{{_latex(denominator)[0]}}}", QUOTIENT
        case Power(base, exponent):
            if is_function(formula) and isinstance(base, Call):
                return _call(base.function, base.arguments, f"^{{{_latex(exponent)[0]}}}")
            return f"{_wrap(_latex(base), ATOM)}^{{{_latex(exponent)[0]}}}", POWER
        case Call(function, arguments):
            return _call(function, arguments, "")
        case Integral(integrand, variable, lower, upper):
            body = _wrap(_latex(integrand), PRODUCT)
            bounds = f"_{{{_latex(lower)[0]}}}^{{{_latex(upper)[0]}}}"
            return rf"\int{bounds} {body}\,\mathrm{{d}}{name_to_latex(variable)}", NEGATIVE
    raise TypeError(f"no LaTeX for {formula!r}")


def _product(factors: tuple[Formula, ...]) -> str:
    text = ""
    for index, factor in enumerate(factors):
        body = _wrap(_latex(factor), QUOTIENT)
        if trails(factor) and index < len(factors) - 1 and not is_function(factors[index + 1]):
            body = rf"\left({body}\right)" if not body.startswith(r"\sqrt") else body
        joint = r" \cdot " if body[0].isdigit() or (index and isinstance(factor, Number)) else " "
        text = f"{text}{joint}{body}" if text else body
    return text


def _call(function: str, arguments: tuple[Formula, ...], raised: str) -> Piece:
    inner = ", ".join(_latex(argument)[0] for argument in arguments)
    if function == "abs":
        return rf"\left|{inner}\right|", ATOM
    if function == "sqrt":
        return rf"\sqrt{{{inner}}}", CALL
    name = BARE_NAMES.get(function, function)
    command = {"atan2": r"\operatorname{atan2}", "ellipk": "K"}.get(function, rf"\{name}")
    bare = function in BARE and may_be_bare(arguments[0])
    return f"{command}{raised}" + (f" {inner}" if bare else rf"\left({inner}\right)"), CALL
