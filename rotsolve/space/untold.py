"""Untold: how far a body is turned about its hinge at a later state, where nothing tells it: a letter on which what is said may not hang.

All that is written holds whatever that angle is. Where the derivative by the letter is nothing, it says the same for all of them, and is
written for 0; else it is no law that is used, and no answer (cyclic coordinates: Goldstein, Poole & Safko, Classical Mechanics, §2.6).
"""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, add, negate
from rotsolve.core.equation import Equation
from rotsolve.core.symbols import of_kinds

UNTOLD = "untold angle"  # the kind of the letter
ANGLE_HELP = "tell `{}.angle` in that state"  # of what is on a hinge


def untold_in(value: Formula) -> list[str]:
    """The letters of untold angles in a formula."""
    return of_kinds(value.symbols(), (UNTOLD,))


def whatever_the_angle(value: Formula) -> Formula | None:
    """A formula without the untold angles on which it does not hang, ∂F/∂φ = 0; None where it hangs on one."""
    names = untold_in(value)
    if not names:
        return value
    if not all(is_zero(differentiate(value, name)) for name in names):
        return None
    return simplify(value.substitute(dict.fromkeys(names, ZERO)))


def law_whatever_the_angle(law: Equation) -> Equation | None:
    """An equation that is the same whatever the untold angles are, ∂(left − right)/∂φ = 0, written for 0; None of others."""
    names = untold_in(add(law.left, law.right))
    if not names:
        return law
    gap = add(law.left, negate(law.right))
    if not all(is_zero(differentiate(gap, name)) for name in names):
        return None
    plain = law.renamed(dict.fromkeys(names, ZERO))
    return replace(plain, left=simplify(plain.left), right=simplify(plain.right))
