"""Coefficients: formulas in which numbers of letters are put in, `g/3` for ⅔ g sin θ with θ = 30°, or which have a rounded coefficient."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import partial
from itertools import islice, product

from rotsolve.algebra.formula import Formula, Negative, Number, Symbol

USUAL = 1 / 100  # the share by which a rounded coefficient may change a formula, where the tolerance is no share
ROUNDED = 1 / 400  # the share by which a number put in for a letter may differ from it
MOST_WAYS = 32  # in which the numbers of a formula may be letters
LEAST = 2  # figures of a number that may be rounded


def put_in(
    closed: Formula, typed: Formula, values: Mapping[str, Formula], numbers: Mapping[str, float], fits: bool
) -> Formula | None:
    """A closed form with the numbers of the letters that are missing in a formula. Where the formula does not measure what the closed
    form does (`fits`), these numbers must stand in it, as 9.81 in m·9.81/4, or be worked into a decimal; None where they are not."""
    missing = closed.symbols() - typed.symbols()
    if not missing <= values.keys():
        return None
    if not missing:
        return closed
    if not fits and not has_decimal(typed):
        found = numbers_in(typed)
        if not all(any(named(value, {name: numbers.get(name, 0)}, USUAL) for value in found) for name in missing):
            return None
    return closed.substitute({name: values[name] for name in missing})


def numbers_in(typed: Formula) -> frozenset[Fraction]:
    """The different numbers that stand in a formula."""
    return frozenset(node.value for node in typed.walk(Number) if isinstance(node, Number))


def has_decimal(typed: Formula) -> bool:
    """Whether a number of two figures or more, not a whole one, stands in a formula: 0.67, 9.81."""
    return any(is_decimal(value) for value in numbers_in(typed))


def is_decimal(value: Fraction) -> bool:
    """Whether a number is a decimal fraction with so many figures."""
    rest, twos, fives = value.denominator, 0, 0
    while rest % 2 == 0:
        rest, twos = rest // 2, twos + 1
    while rest % 5 == 0:
        rest, fives = rest // 5, fives + 1
    if rest > 1 or value.denominator == 1:
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
