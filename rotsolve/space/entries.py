"""Entries: a question for a vector or a tensor in space as questions for its components."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ONE, Formula, Symbol
from rotsolve.core.quantity import DIRECTED
from rotsolve.core.vectors.tensor import ENTRIES
from rotsolve.core.vectors.triple import (
    AXES,
)
from rotsolve.language.problem import Find, Term


def entries_in_space(find: Find) -> tuple[Find, ...]:
    """A question for a vector or a tensor as questions for its entries; any other question alone."""
    if len(find.terms) != 1 or find.modifier or not proportional(find.formula):
        return (find,)
    term = find.terms[0]
    names = entries_of(term)
    whole = term.path.component
    parts = []
    for name in names:
        path = replace(term.path, component=name if whole is None else f"{whole} {name}")
        parts.append(replace(find, name=f"{find.name}_{name}", terms=(replace(term, path=path),), whole=find.name))
    return tuple(parts) or (find,)


def proportional(formula: Formula) -> bool:
    """Whether a formula is a multiple of its only quantity by givens, so that it may be a vector."""
    rest = formula.substitute({"#0": ONE})
    return "#0" in formula.symbols() and (formula == Symbol("#0") or is_zero(formula - rest * Symbol("#0")))


def entries_of(term: Term) -> tuple[str, ...]:
    """The names of the entries of what a term asks for; none of a scalar."""
    path = term.path
    if term.modifier not in ("", "change of", "lost", "mean") or path.component in (*AXES, *ENTRIES):
        return ()
    if path.quantity in DIRECTED or path.quantity == "cm":
        return AXES
    if path.quantity == "principal_moments" and path.component is None:
        return ("1", "2", "3")
    return ENTRIES if path.quantity == "inertia_tensor" else ()
