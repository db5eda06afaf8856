"""SymPy bridge: formulas to SymPy and back; SymPy is imported by the call that needs it."""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction
from functools import lru_cache
from typing import Any

from rotsolve.algebra.formula import (
    FUNCTIONS,
    ONE,
    PI,
    ZERO,
    Call,
    Constant,
    Formula,
    Integral,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
    add,
    call,
    divide,
    multiply,
    negate,
    total,
)

INTEGRALS = 500  # found, or not, by SymPy, that are remembered: the plans of a scene ask for the same ones
_NAMES = {"abs": "Abs", "ellipk": "elliptic_k", "ellipf": "elliptic_f", "ellippi": "elliptic_pi"}
_WORDS = {name: word for word, name in _NAMES.items()}
_LONGER = {("elliptic_pi", 3): "ellippiinc"}  # what has the name of another one with fewer arguments


def to_sympy(f: Formula, positive: Collection[str] = (), *, plain: bool = False) -> Any:
    """The formula as a SymPy expression: symbols real, those in `positive` positive; `plain` ones as `sympy.Symbol("m")` makes them."""
    import sympy

    def symbol(name: str) -> Any:
        return sympy.Symbol(name) if plain else _symbol(name, positive)

    def convert(node: Formula) -> Any:
        if isinstance(node, Number):
            return sympy.Rational(node.value.numerator, node.value.denominator)
        if isinstance(node, Symbol):
            return symbol(node.name)
        if isinstance(node, Constant):
            return sympy.pi
        parts = [convert(child) for child in node.children()]
        if isinstance(node, Sum):
            return sympy.Add(*parts)
        if isinstance(node, Product):
            return sympy.Mul(*parts)
        if isinstance(node, Quotient):
            return parts[0] / parts[1]
        if isinstance(node, Power):
            return parts[0] ** parts[1]
        if isinstance(node, Negative):
            return -parts[0]
        if isinstance(node, Call):
            name = next((word for (word, _), own in _LONGER.items() if own == node.function), node.function)
            name = _NAMES.get(name, name)
            return getattr(sympy, name, sympy.Function(name))(*parts)  # it has no sn, cn and dn
        if isinstance(node, Integral):
            return sympy.Integral(parts[0], (symbol(node.variable), parts[1], parts[2]))
        raise ValueError(f"not convertible: {node!r}")

    return convert(f)


def _symbol(name: str, positive: Collection[str]) -> Any:
    import sympy

    return sympy.Symbol(name, positive=True) if name in positive else sympy.Symbol(name, real=True)


def from_sympy(expr: Any) -> Formula:
    """A SymPy expression as a formula; ValueError for what formulas have no word for."""
    import sympy

    if expr.is_Rational:
        return Number(Fraction(int(expr.p), int(expr.q)))
    if expr is sympy.pi:
        return PI
    if expr is sympy.E:
        return call("exp", ONE)
    if expr.is_Symbol:
        return Symbol(expr.name)
    if expr.is_Add:
        return total([from_sympy(term) for term in expr.as_ordered_terms()])
    if expr.is_Mul:
        return _from_product(expr)
    if isinstance(expr, sympy.exp):
        return call("exp", from_sympy(expr.args[0]))
    if expr.is_Pow:
        return _from_power(*expr.as_base_exp())
    if isinstance(expr, sympy.Integral) and len(expr.limits) == 1 and len(expr.limits[0]) == 3:
        variable, lower, upper = expr.limits[0]
        return Integral(from_sympy(expr.function), variable.name, from_sympy(lower), from_sympy(upper))
    return _from_function(expr)


def _from_product(expr: Any) -> Formula:
    above: Formula = ONE
    below: Formula = ONE
    for factor in expr.as_ordered_factors():
        base, exponent = factor.as_base_exp()
        if factor.is_Rational:
            above = multiply(above, Number(Fraction(int(factor.p))))
            below = multiply(below, Number(Fraction(int(factor.q))))
        elif exponent.is_Rational and exponent.is_negative:
            below = multiply(below, _from_power(base, -exponent))
        else:
            above = multiply(above, from_sympy(factor))
    return divide(above, below)


def _from_power(base: Any, exponent: Any) -> Formula:
    if exponent.is_Rational and exponent.is_negative:
        return divide(ONE, _from_power(base, -exponent))
    if exponent == 1:
        return from_sympy(base)
    if exponent.is_Rational and exponent.q == 2:
        root = call("sqrt", from_sympy(base))
        return root if exponent.p == 1 else Power(root, Number(Fraction(int(exponent.p))))
    return Power(from_sympy(base), from_sympy(exponent))


def _from_function(expr: Any) -> Formula:

    name = type(expr).__name__
    name = _LONGER.get((name, len(expr.args)), _WORDS.get(name, name))
    arguments = [from_sympy(argument) for argument in expr.args]
    if name in ("cot", "sec", "csc"):
        below = {"cot": "tan", "sec": "cos", "csc": "sin"}[name]
        return divide(ONE, call(below, *arguments))
    if name in ("sinh", "cosh", "tanh"):
        up, down = call("exp", arguments[0]), call("exp", negate(arguments[0]))
        odd, even = add(up, negate(down)), add(up, down)
        return divide(odd, even) if name == "tanh" else divide(odd if name == "sinh" else even, Number(Fraction(2)))
    if FUNCTIONS.get(name) != len(arguments):
        raise ValueError(f"no formula for {expr}")
    return call(name, *arguments)


def definite_integral(
    f: Formula, name: str, lower: Formula, upper: Formula, positive: Collection[str] = ()
) -> Formula | None:
    """∫ f d(name) from lower to upper as SymPy finds it, None where it does not."""
    if lower == upper:
        return ZERO
    letters = f.symbols() | lower.symbols() | upper.symbols() | {name}
    return _definite_integral(f, name, lower, upper, letters & frozenset(positive))


@lru_cache(INTEGRALS)
def _definite_integral(
    f: Formula, name: str, lower: Formula, upper: Formula, positive: frozenset[str]
) -> Formula | None:
    """The same for the positive ones of its own letters."""
    import sympy

    variable = _symbol(name, positive)
    ends = to_sympy(lower, positive), to_sympy(upper, positive)
    try:
        found = sympy.integrate(to_sympy(f, positive), (variable, *ends))
        if found.has(sympy.Integral, sympy.Piecewise, sympy.I, sympy.nan, sympy.zoo, sympy.oo):
            return None
        return from_sympy(found)
    except (ValueError, NotImplementedError, TypeError):
        return None
