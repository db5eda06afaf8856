"""Integral: definite integrals in closed form, by antiderivatives that a textbook finds; SymPy is asked only beyond that."""

from __future__ import annotations

from collections.abc import Callable, Collection

from rotsolve.algebra.calculus.antiderivative import antiderivative
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Call, Formula, Integral, Number, Product, Quotient, Sum, Symbol, add, negate


def integrate(
    f: Formula, name: str, lower: Formula, upper: Formula, *, positive: Collection[str] = ()
) -> Formula | None:
    """∫ f d(name) from lower to upper in closed form, None where neither a textbook nor SymPy finds one."""
    found = integrate_by_hand(f, name, lower, upper, positive=positive)
    if found is not None:
        return found
    from rotsolve.algebra.sympy_bridge import definite_integral

    return definite_integral(f, name, lower, upper, positive)


def integrate_by_hand(
    f: Formula, name: str, lower: Formula, upper: Formula, *, positive: Collection[str] = ()
) -> Formula | None:
    """∫ f d(name) without SymPy; an antiderivative with a pole or logarithm only where both ends have one known sign."""
    primitive = antiderivative(f, name)
    if primitive is None or not _continuous(primitive, name, lower, upper, positive):
        return None
    high = primitive.substitute({name: upper})
    return simplify(add(high, negate(primitive.substitute({name: lower}))), positive=positive)


def carried_out(
    f: Formula, positive: Collection[str] = (), tidied: Callable[[Formula], Formula] | None = None
) -> Formula:
    """All integrals in closed form where there is one, each result `tidied`."""

    def change(node: Formula) -> Formula:
        if not isinstance(node, Integral):
            return node
        done = integrate(node.integrand, node.variable, node.lower, node.upper, positive=positive)
        return node if done is None else tidied(done) if tidied else done

    return f.transform(change, Integral)


def _continuous(primitive: Formula, name: str, lower: Formula, upper: Formula, positive: Collection[str]) -> bool:
    """Whether the antiderivative has no pole in `name`, or both ends are certainly positive."""
    singular = any(
        (isinstance(node, Quotient) and name in node.denominator.symbols())
        or (isinstance(node, Call) and node.function == "log" and name in node.symbols())
        for node in primitive.walk(Quotient, "log")
    )
    return not singular or all(_is_positive(end, positive) for end in (lower, upper))


def _is_positive(end: Formula, positive: Collection[str]) -> bool:
    if isinstance(end, Number):
        return end.value > 0
    if isinstance(end, (Sum, Product, Quotient)):
        return all(_is_positive(child, positive) for child in end.children())
    return isinstance(end, Symbol) and end.name in positive
