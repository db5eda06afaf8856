"""Entries: a question for a vector or a tensor in space as questions for its components."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ONE, ZERO, Call, Formula, Power, Product, Sum, Symbol, formula, negate, sqrt, total
from rotsolve.core.quantity import DIRECTED, EITHER_WAY
from rotsolve.core.vectors.tensor import ENTRIES
from rotsolve.core.vectors.triple import AXES, square
from rotsolve.core.writing import flat
from rotsolve.language.joints import joints_at
from rotsolve.language.problem import Find, Term
from rotsolve.paths.meaning import NotYet

if TYPE_CHECKING:
    from rotsolve.equations.scene_equations import SceneEquations
    from rotsolve.questions.find import Asked


def entries_in_space(find: Find) -> tuple[Find, ...]:
    """A question for a vector or a tensor, or for a sum of some, as questions for its entries; any other question alone."""
    names = {entries for term in find.terms if (entries := entries_of(term))}
    if len(names) != 1 or find.modifier or not is_linear(find):
        return (find,)
    parts = []
    for name in names.pop():
        terms = tuple(of_entry(term, name) if entries_of(term) else term for term in find.terms)
        parts.append(replace(find, name=f"{find.name}_{name}", terms=terms, whole=find.name))
    return tuple(parts)


def refuse_mixed_axes(find: Find, scene: SceneEquations) -> None:
    """Refuse a sum of vectors by components along axes that are not the same ones."""
    if not find.whole or len(find.terms) < 2:
        return
    problem = scene.configuration.problem
    bodies = {
        joint.owner: joint.body.owner for joint in joints_at(problem, problem.states[-1].name if problem.states else "")
    }
    bodies |= {action.name: action.touches()[0].owner for action in problem.actions}
    along = {
        bodies.get(term.path.owner, term.path.owner) if term.axes in ("body", "node") else term.axes or "space"
        for term in find.terms
        if term.path.quantity in DIRECTED
    }
    if len(along) > 1:
        message = f"`{find.text.strip()}` is a sum of components along different axes"
        raise NotYet(message, find.span, "ask for all of them along the axes of one body, `in NAME axes`, or of space")


def refuse_products(find: Find) -> None:
    """Refuse a product of two vectors, which in arithmetic with their sizes would be something else, and a sum with what has no sense."""
    vectors = [number for number, term in enumerate(find.terms) if entries_of(term)]
    if len(find.terms) > 1 and any(term.path.quantity in EITHER_WAY for term in find.terms):
        help = "ask for it alone, or for `angle of A from B`"
        raise NotYet("a principal axis has no sense, so that it has no sum with anything", find.span, help)
    with suppress(ZeroDivisionError):
        factors = [number for number in vectors if is_zero(find.formula.substitute({f"#{number}": ZERO}))]
        if len(factors) > 1:
            help = "multiply components, as `body.velocity.x`, one by one"
            raise NotYet("the product of two vectors is not solved", find.span, help)


def size_of_sum(value: Formula, terms: Sequence[Term], first: int) -> tuple[Formula, tuple[Term, ...]] | None:
    """|Σ c v| = √(Σ (Σ c vₓ)²) of a sum of multiples of several vectors, with their components as terms, which count from `first` on;
    None of anything else.

    It is the same along all axes: those of space, where they are named otherwise for each.
    """
    vectors = [number for number, term in enumerate(terms) if entries_of(term)]
    if len(vectors) < 2 or {entries_of(terms[number]) for number in vectors} != {AXES}:
        return None
    if not is_sum(value, [f"#{first + number}" for number in vectors]):
        return None
    named = {(term.axes, term.path.owner if term.axes in ("body", "node") else "") for term in terms}
    parts, squares = list[Term](), list[Formula]()
    for axis in AXES:
        marks = {f"#{first + number}": Symbol(f"#{first + len(parts) + number}") for number in range(len(terms))}
        squares.append(square(value.substitute(marks)))
        for number, term in enumerate(terms):
            plain = term if len(named) == 1 else replace(term, axes=None)
            parts.append(of_entry(plain, axis) if number in vectors else term)
    return sqrt(total(squares)), tuple(parts)


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
    vectors = [f"#{number}" for number, term in enumerate(find.terms) if entries_of(term)]
    several = len(vectors) > 1 or len(find.terms) == 1
    return find.formula == Symbol("#0") or (several and is_sum(find.formula, vectors))


def is_sum(value: Formula, marks: Sequence[str]) -> bool:
    """Whether a formula is a sum of multiples of what it marks."""
    none = dict.fromkeys(marks, ZERO)
    try:
        told = total([value.substitute({**none, mark: ONE}) * Symbol(mark) for mark in marks])
        return bool(set(marks) & value.symbols()) and is_zero(value - told)
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
