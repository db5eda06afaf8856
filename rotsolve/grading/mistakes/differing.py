"""Differing: what of an answer with a mistake in it differs from the right one, so that it is never named on a right answer."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import ONE, Formula, Integral, Number
from rotsolve.core.derivation import Answer

NEARLY = 1e-9  # relative: numbers closer than this are not told apart
DIGITS = 10  # to which a difference of two forms is worked out


class Differing(Struct, frozen=True):
    """Compares answers of a scene, by the letters that are positive and the numbers of its givens."""

    positive: frozenset[str]
    values: Mapping[str, Formula]

    def left_of(self, wrong: Answer, right: Answer) -> Answer | None:
        """The wrong answer without its form where that is the right one, without its number where that is; None where nothing is left."""
        parts = {part.name: part for part in right.components}
        pairs = ((part, parts.get(part.name)) for part in wrong.components)
        apart = any(twin is not None and self.left_of(part, twin) is not None for part, twin in pairs)
        form = wrong.closed if wrong.closed is not None and self.differ(wrong.closed, right.closed) else None
        value = wrong.value if wrong.value is not None and not same_number(wrong.value, right.value) else None
        word = wrong.word if wrong.word != right.word else ""
        if form is None and value is None and not word and not apart:
            return None
        formula, components = (None if form is None else wrong.formula), wrong.components if apart else ()
        return replace(wrong, formula=formula, closed=form, value=value, word=word, components=components)

    def differ(self, wrong: Formula, right: Formula | None) -> bool:
        """Whether two closed forms are certainly not the same: a ball round their difference holds no 0.

        Integrals are told apart by their numbers alone.
        """
        if wrong.holds(Integral):
            return False
        if right is None:
            return True
        try:
            if equal(wrong, right, self.positive):
                return False
        except ArithmeticError:
            return False
        return any(apart(wrong - right, values) for values in self.points(wrong.symbols() | right.symbols()))

    def points(self, letters: frozenset[str]) -> Iterator[dict[str, Formula]]:
        """Numbers for letters: near those of the scene, where nothing agrees by chance, then those of the scene."""
        own = {name: self.values.get(name, ONE) for name in sorted(letters | self.values.keys())}
        yield {name: value * Number(Fraction(97 + 2 * place, 100)) for place, (name, value) in enumerate(own.items())}
        yield own


def apart(difference: Formula, values: Mapping[str, Formula]) -> bool:
    """Whether a difference is certainly not 0 at some numbers."""
    try:
        return bool(evaluate(difference, values, digits=DIGITS, max_precision=1000).sign)
    except (Undefined, ArithmeticError):
        return False


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
    if (one.value is None) != (other.value is None):
        return False
    number = one.value is None or same_number(one.value, other.value)
    return number and all(same(part, twin) for part, twin in zip(one.components, other.components, strict=True))
