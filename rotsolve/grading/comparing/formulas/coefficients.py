"""Coefficients: formulas in which numbers of letters are put in, `g/3` for ⅔ g sin θ with θ = 30°, or which have a rounded coefficient."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from itertools import islice, product

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Negative, Number, Symbol

USUAL = 1 / 100  # the share by which a rounded coefficient may change a formula, where the tolerance is no share
ROUNDED = 1 / 400  # the share by which a number put in for a letter may differ from it
MOST_WAYS = 32  # in which the numbers of a formula may be letters
MOST_PLACES = 40  # of a decimal that may be rounded
LEAST = 2  # figures of a number that may be rounded


class Put(Struct, frozen=True):
    """A formula and its closed form, written in givens, both with the numbers of the letters that do not stand in the formula."""

    typed: Formula
    closed: Formula
    missing: tuple[str, ...]


def put_in(
    closed: Formula, typed: Formula, values: Mapping[str, Formula], answers: Mapping[str, Formula]
) -> Put | None:
    """The numbers that a formula has in place of letters put into both sides: T + (2 kg) a/2, where `answers` tell T and a by givens.

    None where a letter has no number.
    """
    written = typed.substitute({name: answers[name] for name in typed.symbols() - values.keys() if name in answers})
    missing = (written.symbols() | closed.symbols()) - typed.symbols()
    if not missing <= values.keys():
        return None
    put = {name: values[name] for name in missing}
    return Put(written.substitute(put), closed.substitute(put), tuple(sorted(missing)))


def numbers_stand(typed: Formula, missing: Iterable[str], numbers: Mapping[str, float]) -> bool:
    """Whether a formula that has lost its units can have the numbers of letters in it: they stand there, or are worked into a decimal."""
    found = numbers_in(typed)
    return has_decimal(typed) or all(
        any(named(value, {name: numbers.get(name, 0)}, USUAL) for value in found) for name in missing
    )


def numbers_in(typed: Formula) -> frozenset[Fraction]:
    """The different numbers that stand in a formula."""
    return frozenset(node.value for node in typed.walk(Number) if isinstance(node, Number))


def has_decimal(typed: Formula) -> bool:
    """Whether a number of two figures or more, not a whole one, stands in a formula: 0.67, 9.81."""
    return any(is_decimal(value) for value in numbers_in(typed))


def rounding(typed: Formula) -> float:
    """The share by which a formula may be off because its decimals are rounded: a unit of the last figure of each."""
    return sum(float(Fraction(1, 10 ** places(value)) / abs(value)) for value in numbers_in(typed) if is_decimal(value))


def places(value: Fraction) -> int:
    """The decimal places of a number that has so many and no more."""
    return next(count for count in range(MOST_PLACES) if (value * 10**count).denominator == 1)


def is_decimal(value: Fraction) -> bool:
    """Whether a number is a decimal fraction with so many figures."""
    rest, twos, fives = value.denominator, 0, 0
    while rest % 2 == 0:
        rest, twos = rest // 2, twos + 1
    while rest % 5 == 0:
        rest, fives = rest // 5, fives + 1
    if rest > 1 or value.denominator == 1 or max(twos, fives) >= MOST_PLACES:
        return False
    digits = value.numerator * 10 ** max(twos, fives) // value.denominator
    return len(str(abs(digits)).rstrip("0")) >= LEAST


def with_letters(typed: Formula, numbers: Mapping[str, float]) -> Iterator[tuple[Formula, tuple[str, ...]]]:
    """A formula with letters for the numbers that they have, m₁ (g + a) for m₁ (9.81 + a), in all ways, and which letters these are."""
    letters = {value: named(abs(value), numbers) for value in sorted(numbers_in(typed))}
    choices = [[(value, ""), *((value, name) for name in names)] for value, names in letters.items() if names]
    for chosen in islice(product(*choices), MOST_WAYS):
        put = {value: Symbol(name) for value, name in chosen if name}
        if put:
            yield typed.transform(partial(lettered, put), Number), tuple(symbol.name for symbol in put.values())


def named(value: Fraction, numbers: Mapping[str, float], share: float = ROUNDED) -> list[str]:
    """The letters that have a number, perhaps rounded."""
    try:
        size = float(value)
    except OverflowError:
        return []
    return [name for name, number in numbers.items() if number and abs(size - number) <= share * abs(number)]


def lettered(put: Mapping[Fraction, Symbol], node: Formula) -> Formula:
    """The letter for a number, with its sign."""
    letter = put.get(node.value) if isinstance(node, Number) else None
    if letter is None or not isinstance(node, Number):
        return node
    return Negative(letter) if node.value < 0 else letter
