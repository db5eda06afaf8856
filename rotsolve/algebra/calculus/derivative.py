"""Derivatives, and what they tell of a formula: its period, and how it goes by the powers of a letter: ω₀ + a t − ½ b t²."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from functools import reduce

from rotsolve.algebra.exact.normal import Fractions, degree, is_zero, simplify
from rotsolve.algebra.formula import (
    ELLIPTIC,
    ONE,
    PI,
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
    others = [(*f.factors[:k], *f.factors[k + 1 :]) for k in range(len(f.factors))]
    slopes = [differentiate(factor, name) for factor in f.factors]
    return total([reduce(multiply, rest, slope) for rest, slope in zip(others, slopes, strict=True)])


def _power_rule(f: Power, name: str) -> Formula:
    slope = differentiate(f.base, name)
    if name not in f.exponent.symbols():
        exponent = add(f.exponent, Number(Fraction(-1)))
        lower = ONE if exponent == ZERO else f.base**exponent
        return multiply(multiply(f.exponent, lower), slope)
    growth = multiply(differentiate(f.exponent, name), call("log", f.base))
    return multiply(f, add(growth, multiply(f.exponent, divide(slope, f.base))))


def _chain_rule(f: Call, name: str) -> Formula:
    if f.function in ELLIPTIC:
        return _elliptic_rule(f, name)
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


def _elliptic_rule(f: Call, name: str) -> Formula:
    """am' = dn, sn' = cn dn, cn' = −sn dn, dn' = −m sn cn, ∂F/∂φ = 1/√(1 − m sin² φ), ∂Π/∂φ = (∂F/∂φ)/(1 − n sin² φ) (NIST Handbook,
    22.13 and 19.4); none by the parameter m, nor by n."""
    *first, u, m = ZERO, *f.arguments
    if f.function in ("ellipk", "ellippi") or any(name in fixed.symbols() for fixed in (*first, m)):
        raise ValueError(f"no derivative of {f!r}")
    if f.function in ("ellipf", "ellippiinc"):
        below = call("sqrt", add(ONE, negate(multiply(m, power(call("sin", u), 2)))))
        lessened = add(ONE, negate(multiply(first[-1], power(call("sin", u), 2))))
        return divide(differentiate(u, name), multiply(lessened, below))
    sn, cn, dn = (call(function, u, m) for function in ("ellipsn", "ellipcn", "ellipdn"))
    slope = {
        "ellipam": dn,
        "ellipsn": multiply(cn, dn),
        "ellipcn": negate(multiply(sn, dn)),
        "ellipdn": negate(multiply(m, multiply(sn, cn))),
    }
    return multiply(differentiate(u, name), slope[f.function])


def _leibniz(f: Integral, name: str) -> Formula:
    upper = multiply(f.integrand.substitute({f.variable: f.upper}), differentiate(f.upper, name))
    lower = multiply(f.integrand.substitute({f.variable: f.lower}), differentiate(f.lower, name))
    result = add(upper, negate(lower))
    if f.variable != name and name in f.integrand.symbols():
        inner = differentiate(f.integrand, name)
        result = add(result, Integral(inner, f.variable, f.lower, f.upper))
    return result


ROUND = ("sin", "cos", "sqrt", "abs")  # functions of what comes round that come round with it


def period_of(function: Formula, letter: str) -> Formula | None:
    """2π/n of a function in which a letter x stands in sin n x and cos n x only, also under a root of what is made of them."""
    found = {node for node in function.walk(Call) if isinstance(node, Call) and letter in node.symbols()}
    calls = {node for node in found if node.function in ("sin", "cos")}
    outside = function.transform(lambda node: PI if node in calls else node, Call)
    if not calls or letter in outside.symbols() or any(node.function not in ROUND for node in found):
        return None
    slopes = {simplify(differentiate(node.arguments[0], letter)) for node in calls}
    slope = slopes.pop()
    return None if slopes or letter in slope.symbols() else 2 * PI / slope


def same_a_turn_on(function: Formula, letter: str) -> bool:
    """Whether a function of an angle x is the same a whole turn on: x stands only in sin, cos and tan of n x + c, n a whole number."""

    def still(node: Formula) -> Formula:
        if not isinstance(node, Call) or node.function not in ("sin", "cos", "tan") or letter not in node.symbols():
            return node
        slope = simplify(differentiate(node.arguments[0], letter))
        return PI if isinstance(slope, Number) and slope.value.denominator == 1 else node

    return letter not in function.transform(still, Call).symbols()


LONGEST = 12  # powers of a polynomial that is written by them


def in_powers(value: Formula, name: str, *, order: Sequence[str] = (), positive: Collection[str] = ()) -> Formula:
    """The terms c₀ + c₁ x + c₂ x² + … with cₙ = f⁽ⁿ⁾(0)/n!; as it stands where it is no polynomial in the letter."""
    if name not in value.symbols() or degree(value, name) is None or is_below(value, name):
        return value
    terms: list[Formula] = []
    slope, factor = value, 1
    for exponent in range(LONGEST):
        part = simplify(slope.substitute({name: ZERO}) / factor, order=order, positive=positive)
        terms.append(simplify(part * Symbol(name) ** exponent, order=order, positive=positive))
        slope, factor = simplify(differentiate(slope, name)), factor * (exponent + 1)
        if is_zero(slope):
            return total(terms)
    return value


def is_below(value: Formula, name: str) -> bool:
    """Whether a letter stands below the line."""
    problem = Fractions([value], extra=(name,))
    _, bottom = problem.field.cancel(problem.ratio())
    return bool(bottom.degrees()[problem.field.index[Symbol(name)]])
