"""Differing: what of an answer with a mistake in it differs from the right one, so that it is never named on a right answer."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Formula
from rotsolve.core.derivation import Answer

NEARLY = 1e-9  # relative: numbers closer than this are not told apart


def differing(wrong: Answer, right: Answer, positive: Collection[str]) -> Answer | None:
    """The wrong answer without its form where that is the right one, and without its number where that is; None where nothing is left."""
    parts = {part.name: part for part in right.components}
    components = tuple(
        left
        for part in wrong.components
        if part.name in parts and (left := differing(part, parts[part.name], positive)) is not None
    )
    form = wrong.closed if wrong.closed is not None and not same_form(wrong.closed, right.closed, positive) else None
    value = wrong.value if wrong.value is not None and not same_number(wrong.value, right.value) else None
    word = wrong.word if wrong.word != right.word else ""
    if form is None and value is None and not word and not components:
        return None
    formula = None if form is None else wrong.formula
    kept = wrong.components if components else ()
    return replace(wrong, formula=formula, closed=form, value=value, word=word, components=kept)


def same_form(wrong: Formula, right: Formula | None, positive: Collection[str]) -> bool:
    """Whether two closed forms are equal, or cannot be told apart."""
    try:
        return right is not None and equal(wrong, right, positive)
    except ArithmeticError:
        return True


def same_number(wrong: Certified, right: Certified | None) -> bool:
    """Whether two numbers are equal, or so close that no student tells them apart."""
    if right is None:
        return False
    return bool(abs(wrong.ball - right.ball) <= NEARLY * abs(right.ball)) or wrong.ball.overlaps(right.ball)


def alike(some: Mapping[str, Answer], others: Mapping[str, Answer]) -> bool:
    """Whether two mistakes give the same answers: the same forms as they are written, and the same numbers."""
    return some.keys() == others.keys() and all(same(one, others[name]) for name, one in some.items())


def same(one: Answer, other: Answer) -> bool:
    """Whether two answers have the same form and number, part by part."""
    if one.closed != other.closed or one.word != other.word or len(one.components) != len(other.components):
        return False
    if one.value is None or other.value is None:
        return one.value is other.value
    parts = zip(one.components, other.components, strict=True)
    return same_number(one.value, other.value) and all(same(part, twin) for part, twin in parts)
