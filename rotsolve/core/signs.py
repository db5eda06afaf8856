"""Signs: whether a term is written with a minus in front."""

from __future__ import annotations

from rotsolve.algebra.formula import Formula, Negative, Number, Product, Quotient


def is_negative(term: Formula) -> bool:
    """Whether a term is written with a minus sign in front."""
    if isinstance(term, Negative):
        return True
    if isinstance(term, Number):
        return term.value < 0
    if isinstance(term, (Product, Quotient)):
        return is_negative(term.children()[0])
    return False
