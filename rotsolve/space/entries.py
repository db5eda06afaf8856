"""Entries: a question for a vector or a tensor in space as questions for its components."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ONE, ZERO, Call, Formula, Power, Product, Sum, Symbol, formula, negate, total
from rotsolve.core.quantity import DIRECTED
from rotsolve.core.vectors.tensor import ENTRIES
from rotsolve.core.vectors.triple import AXES, square
from rotsolve.core.writing import flat
from rotsolve.language.problem import Find, Term
from rotsolve.paths.meaning import NotYet

if TYPE_CHECKING:
    from rotsolve.questions.find import Asked


def entries_in_space(find: Find) -> tuple[Find, ...]:
    """A question for a vector or a tensor, or for a sum of some, as questions for its entries; any other question alone."""
    names = {entries_of(term) for term in find.terms}
    if len(names) != 1 or not is_linear(find):
        return (find,)
    parts = []
    for name in names.pop() if not find.modifier else ():
        terms = tuple(of_entry(term, name) for term in find.terms)
        parts.append(replace(find, name=f"{find.name}_{name}", terms=terms, whole=find.name))
    return tuple(parts) or (find,)


def refuse_sizes(find: Find) -> None:
    """Refuse the size of a sum of vectors, and a product of two: in arithmetic with their sizes both would be something else."""
    vectors = [number for number, term in enumerate(find.terms) if entries_of(term)]
    if find.modifier == "size of" and len(vectors) == len(find.terms) > 1 and is_linear(find):
        help = "ask for the sum, which is told by its components"
        raise NotYet("the size of a sum of vectors is not solved", find.span, help)
    with suppress(ZeroDivisionError):
        factors = [number for number in vectors if is_zero(find.formula.substitute({f"#{number}": ZERO}))]
        if len(factors) > 1:
            help = "multiply components, as `body.velocity.x`, one by one"
            raise NotYet("the product of two vectors is not solved", find.span, help)


def by_answers(question: Asked, earlier: Iterable[Asked]) -> Asked:
    """What is asked by the letters of what has been told before: √(a² + R² αₓ²) with a = R α_y − u W, of moments λ₁ λ₂ + λ₂² + λ₂ λ₁."""
    find = question.find
    if len(find.terms) == 1 and "size of" not in (find.modifier, find.terms[0].modifier):
        return question
    if len(find.terms) == 1 and not root_of_squares(question.formula):
        return question
    told: dict[frozenset[Formula], Formula] = {}
    for asked in earlier:
        if not asked.direct and isinstance(asked.formula, Sum):
            told.setdefault(frozenset(flat([asked.formula])), Symbol(asked.letter))

    def change(node: Formula) -> Formula:
        if isinstance(node, Power) and node.exponent == formula(2) and isinstance(node.base, Sum):
            letter = told.get(frozenset(flat([negate(node.base)])))
            return node if letter is None else square(letter)
        return told.get(frozenset(flat([node])), node) if isinstance(node, Sum) else node

    return replace(question, formula=question.formula.transform(change, Sum))


def root_of_squares(size: Formula) -> bool:
    """Whether a formula is the root of a sum of squares, as that of three components is."""
    parts = size.arguments[0] if isinstance(size, Call) and size.function == "sqrt" else size
    terms = parts.terms if isinstance(parts, Sum) else (parts,)
    factors = [factor for term in terms for factor in (term.factors if isinstance(term, Product) else (term,))]
    return all(isinstance(factor, Power) and factor.exponent == formula(2) for factor in factors)


def of_entry(term: Term, name: str) -> Term:
    """A term for one entry of what it asks for."""
    whole = term.path.component
    return replace(term, path=replace(term.path, component=name if whole is None else f"{whole} {name}"))


def is_linear(find: Find) -> bool:
    """Whether a question is a sum of multiples of its quantities by givens, so that it may be a vector."""
    marks = [f"#{number}" for number in range(len(find.terms))]
    if find.formula == Symbol("#0"):
        return True
    none = dict.fromkeys(marks, ZERO)
    try:
        told = total([find.formula.substitute({**none, mark: ONE}) * Symbol(mark) for mark in marks])
        return bool(set(marks) & find.formula.symbols()) and is_zero(find.formula - told)
    except ZeroDivisionError:  # one of them is a divisor
        return False


def entries_of(term: Term) -> tuple[str, ...]:
    """The names of the entries of what a term asks for; none of a scalar."""
    path = term.path
    if term.modifier not in ("", "change of", "lost", "mean") or (path.component or "").split(" ")[-1] in (
        *AXES,
        *ENTRIES,
    ):
        return ()
    if path.quantity in DIRECTED or path.quantity == "cm":
        return AXES
    if path.quantity == "principal_moments" and path.component is None:
        return ("1", "2", "3")
    return ENTRIES if path.quantity == "inertia_tensor" else ()
