"""Integrals: carried out in closed form, by the way that a textbook takes."""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.algebra.calculus.integral import integrate, integrate_by_hand
from rotsolve.algebra.calculus.separable import Stretch, Unending, has_root, needs_care
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import Formula, Integral

Sign = Callable[[Formula], int | None]


def in_closed_form(node: Integral, sign: Sign, order: tuple[str, ...], positive: frozenset[str]) -> Formula | None:
    """An integral in closed form; None where it has none that a page would hold."""
    done = separated(node, sign, order, positive)
    if done is not None:
        return done
    summed = integrate_by_hand if has_root(node.integrand, node.variable) else integrate
    return summed(node.integrand, node.variable, node.lower, node.upper, positive=positive)


def separated(node: Integral, sign: Sign, order: tuple[str, ...], positive: frozenset[str]) -> Formula | None:
    """An integral with its variable below the line or under a root; the signs of its coefficients tell which real form it has."""
    if not needs_care(node.integrand, node.variable):
        return None
    try:
        return Stretch(node.variable, node.lower, node.upper, sign, order, positive).integral(node.integrand)
    except Unending as error:
        raise Undefined(str(error)) from None
