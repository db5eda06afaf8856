"""Bounds: a definite integral as it stands before it is worked out, F(upper) − F(lower): (M/(3 L)) ((½ L)³ − (−½ L)³)."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from rotsolve.algebra.calculus.antiderivative import antiderivative
from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import (
    ONE,
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
    call,
    divide,
    multiply,
    negate,
    total,
)

TWO = Number(Fraction(2))
Tidy = Callable[[Formula], Formula]


def at_bounds(integral: Integral, tidy: Tidy) -> Formula | None:
    """k (F(upper) − F(lower)) with what does not vary in front; an end where F vanishes is not written. None without an F."""
    name = integral.variable
    constant, rest = split(tidy(integral.integrand), name)
    primitive = written_antiderivative(rest, name, tidy)
    if primitive is None:
        return None
    terms = [tidy(term) for term in spread(primitive, name)]
    if len(terms) == 1:
        factor, terms[0] = split(terms[0], name)
        constant = tidy(multiply(constant, factor))
        if isinstance(terms[0], Call) and terms[0].function == "log":  # k (ln u − ln l) = k ln(u/l)
            last, first = (at(terms[0].arguments[0], name, end, tidy) for end in (integral.upper, integral.lower))
            return multiply(constant, call("log", divide(last, first)))
    high, low = (total([at(term, name, end, tidy) for term in terms]) for end in (integral.upper, integral.lower))
    if is_zero(low):
        return in_front(constant, high)
    if is_zero(high):
        return in_front(negate(constant), low)
    symmetric = is_zero(integral.lower + integral.upper)
    if len(terms) > 1 and symmetric and is_zero(high + low):  # an even function from −a to a
        return multiply(TWO, in_front(constant, high))
    return in_front(constant, high - low)


def written_antiderivative(f: Formula, name: str, tidy: Tidy) -> Formula | None:
    """What a textbook integrates by hand, and k ln g of k g′/g."""
    found = antiderivative(f, name)
    if found is not None or not isinstance(f, Quotient):
        return found
    slope = tidy(differentiate(f.denominator, name))
    share = tidy(f.numerator / slope)
    return None if name in share.symbols() else multiply(share, call("log", f.denominator))


def at(term: Formula, name: str, end: Formula, tidy: Tidy) -> Formula:
    """A term at an end: functions as they stand there, and (½ L)³ and (−R)³, but R² R as R³."""
    bare = end.operand if isinstance(end, Negative) else end
    raised = any(isinstance(node, Power) and name in node.symbols() for node in term.walk())
    alone = end != bare and split(term, name)[0] == ONE
    if alone or (raised and not isinstance(bare, (Symbol, Number))):
        return term.substitute({name: end})
    calls = dict.fromkeys(node for node in term.walk() if isinstance(node, Call) and name in node.symbols())
    letters: dict[Formula, Symbol] = {call: Symbol(f"|{number}") for number, call in enumerate(calls)}
    there = tidy(term.transform(lambda node: letters.get(node) or node).substitute({name: end}))
    return there.substitute({letter.name: call.substitute({name: end}) for call, letter in letters.items()})


def split(f: Formula, name: str) -> tuple[Formula, Formula]:
    """A product as its factors without a letter, and those with it."""
    if name not in f.symbols():
        return f, ONE
    if isinstance(f, Negative):
        constant, rest = split(f.operand, name)
        return negate(constant), rest
    if isinstance(f, Quotient):
        (above, top), (below, bottom) = split(f.numerator, name), split(f.denominator, name)
        return divide(above, below), divide(top, bottom)
    if isinstance(f, Product):
        constant, rest = ONE, ONE
        for factor in f.factors:
            own, varying = split(factor, name)
            constant, rest = multiply(constant, own), multiply(rest, varying)
        return constant, rest
    return ONE, f


def spread(f: Formula, name: str) -> list[Formula]:
    """The terms of an antiderivative: a factor in front of a sum goes to each."""
    if isinstance(f, Sum):
        return [part for term in f.terms for part in spread(term, name)]
    constant, rest = split(f, name)
    return [multiply(constant, part) for part in spread(rest, name)] if isinstance(rest, Sum) else [f]


def in_front(constant: Formula, value: Formula) -> Formula:
    """k (a − b), and M R⁴/(2 R²) of a single term."""
    if isinstance(constant, Negative):
        return negate(in_front(constant.operand, value))
    if isinstance(constant, Quotient) and not isinstance(value, Sum):
        return divide(multiply(constant.numerator, value), constant.denominator)
    return multiply(constant, value)
