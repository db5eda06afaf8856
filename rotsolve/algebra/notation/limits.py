"""Limits: refuse formulas that would be slow or deep to work with, before anyone works with them."""

from __future__ import annotations

from fractions import Fraction

from rotsolve.algebra.formula import Formula, Negative, Number, Power, Product, Quotient, Sum, Symbol
from rotsolve.algebra.notation.tokens import FormulaError

MAX_TREE_DEPTH = 120
MAX_POWER = 64
MAX_ROOT = 1000


def rational(formula: Formula) -> Fraction | None:
    """The value of a formula that is plain arithmetic of numbers without powers; None for any other."""
    if isinstance(formula, Number):
        return formula.value
    if not isinstance(formula, (Negative, Sum, Product, Quotient)):
        return None
    values = [rational(child) for child in formula.children()]
    known = [value for value in values if value is not None]
    if len(known) < len(values):
        return None
    if isinstance(formula, Negative):
        return -known[0]
    if isinstance(formula, Quotient):
        return known[0] / known[1] if known[1] else None
    result = Fraction(0 if isinstance(formula, Sum) else 1)
    for value in known:
        result = result + value if isinstance(formula, Sum) else result * value
    return result


def check_depth(formula: Formula, end: int) -> None:
    """Refuse a tree so deep (`a/b/c/…`) that walking it by recursion could fail."""
    stack = [(formula, 1)]
    while stack:
        node, depth = stack.pop()
        if depth > MAX_TREE_DEPTH:
            raise FormulaError("the formula is nested too deep", 0, end)
        stack.extend((child, depth + 1) for child in node.children())


def _degree(formula: Formula) -> Fraction:
    """The largest product of nested numeric exponents."""
    largest, stack = Fraction(1), [(formula, Fraction(1))]
    while stack:
        node, degree = stack.pop()
        largest = max(largest, degree)
        if isinstance(node, Power):
            value = rational(node.exponent)
            stack.append((node.base, degree if value is None else degree * max(abs(value), Fraction(1))))
        else:
            stack.extend((child, degree) for child in node.children())
    return largest


def check_power(base: Formula, exponent: Formula, start: int, end: int) -> None:
    """Refuse towers of numbers such as 9^9^9, large exponents, and powers of powers that multiply to large ones."""
    small = isinstance(exponent, Number) and exponent.value.denominator == 1 and abs(exponent.value) <= MAX_POWER
    if small and isinstance(base, Symbol):
        return  # as most are
    check_depth(base, end)
    check_depth(exponent, end)
    nodes = tuple(exponent.walk())
    if any(isinstance(node, Power) for node in nodes) and not any(isinstance(node, Symbol) for node in nodes):
        raise FormulaError("a power of numbers in an exponent is not allowed", start, end)
    value = rational(exponent)
    if value is None:
        return
    if abs(value) * _degree(base) > MAX_POWER:
        raise FormulaError(f"the exponent is too large: at most {MAX_POWER}", start, end)
    if value.denominator > MAX_ROOT:
        raise FormulaError(f"the exponent's denominator is too large: at most {MAX_ROOT}", start, end)
