"""Derivative: df/dx by the rules for sums, products, quotients, powers and function calls, and of an integral by Leibniz."""

from __future__ import annotations

from fractions import Fraction

from rotsolve.algebra.formula import (
    ONE,
    ZERO,
    Call,
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
    power,
    total,
)


def differentiate(f: Formula, name: str) -> Formula:
    """df/d(name), not simplified beyond trivial zeros and ones."""
    if isinstance(f, Symbol):
        return ONE if f.name == name else ZERO
    if name not in f.symbols():
        return ZERO
    if isinstance(f, Sum):
        return total([differentiate(term, name) for term in f.terms])
    if isinstance(f, Negative):
        return negate(differentiate(f.operand, name))
    if isinstance(f, Product):
        return _product_rule(f, name)
    if isinstance(f, Quotient):
        top, bottom = differentiate(f.numerator, name), differentiate(f.denominator, name)
        first = divide(top, f.denominator)
        return add(first, negate(divide(multiply(f.numerator, bottom), power(f.denominator, 2))))
    if isinstance(f, Power):
        return _power_rule(f, name)
    if isinstance(f, Call):
        return _chain_rule(f, name)
    if isinstance(f, Integral):
        return _leibniz(f, name)
    raise ValueError(f"no derivative of {f!r}")


def _product_rule(f: Product, name: str) -> Formula:
    terms = []
    for k, factor in enumerate(f.factors):
        slope = differentiate(factor, name)
        for other in (*f.factors[:k], *f.factors[k + 1 :]):
            slope = multiply(slope, other)
        terms.append(slope)
    return total(terms)


def _power_rule(f: Power, name: str) -> Formula:
    slope = differentiate(f.base, name)
    if name not in f.exponent.symbols():
        exponent = add(f.exponent, Number(Fraction(-1)))
        lower = ONE if exponent == ZERO else f.base**exponent
        return multiply(multiply(f.exponent, lower), slope)
    growth = multiply(differentiate(f.exponent, name), call("log", f.base))
    return multiply(f, add(growth, multiply(f.exponent, divide(slope, f.base))))


def _chain_rule(f: Call, name: str) -> Formula:
    if f.function == "ellipk":
        raise ValueError(f"no derivative of {f!r}")
    u = f.arguments[0]
    slope = differentiate(u, name)
    if f.function == "atan2":
        x = f.arguments[1]
        top = add(multiply(x, slope), negate(multiply(u, differentiate(x, name))))
        return divide(top, add(power(x, 2), power(u, 2)))
    if f.function == "sin":
        return multiply(slope, call("cos", u))
    if f.function == "cos":
        return negate(multiply(slope, call("sin", u)))
    if f.function == "exp":
        return multiply(slope, f)
    below = {
        "tan": lambda: power(call("cos", u), 2),
        "sqrt": lambda: multiply(Number(Fraction(2)), f),
        "log": lambda: u,
        "asin": lambda: call("sqrt", add(ONE, negate(power(u, 2)))),
        "acos": lambda: negate(call("sqrt", add(ONE, negate(power(u, 2))))),
        "atan": lambda: add(ONE, power(u, 2)),
        "abs": lambda: divide(f, u),
    }[f.function]()
    return divide(slope, below)


def _leibniz(f: Integral, name: str) -> Formula:
    upper = multiply(f.integrand.substitute({f.variable: f.upper}), differentiate(f.upper, name))
    lower = multiply(f.integrand.substitute({f.variable: f.lower}), differentiate(f.lower, name))
    result = add(upper, negate(lower))
    if f.variable != name and name in f.integrand.symbols():
        inner = differentiate(f.integrand, name)
        result = add(result, Integral(inner, f.variable, f.lower, f.upper))
    return result
