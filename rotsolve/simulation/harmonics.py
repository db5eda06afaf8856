"""Harmonics: sums and products of sines and cosines as sums of single ones, so that sin² + cos² is 1 and less is left to multiply.

sin a sin b = ½ (cos(a − b) − cos(a + b)), and so on; the masses and forces of linked rods become short sums of cos(a − b).
"""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.algebra.flints import fmpq
from rotsolve.algebra.tape import HALF, ONE, ZERO, Exact
from rotsolve.simulation.tape import SeriesTape, vanishes

MOST_TERMS = 60  # a longer sum is left as it was
DEAR = ("times", "over", "power", "sin", "exp", "log", "atan", "asin", "acos")  # each costs a sum of products an order
Powers = tuple[tuple[int, int], ...]  # values of the tape with their powers
Angle = tuple[tuple[int, int], ...]  # values of the tape with whole factors: a − 2 b
Term = tuple[Powers, str, Angle]  # powers · '' | 'sin' | 'cos' of the angle
Terms = dict[Term, Exact]
PLAIN: Term = ((), "", ())


class TooLong(Exception):
    """The sum has too many terms to be worth it."""


def fewer_products(tape: SeriesTape, places: Sequence[int]) -> list[int]:
    """The same values written as sums of single sines and cosines, where that takes fewer products."""
    try:
        shorter = [write_terms(tape, terms_of(tape, place, {})) for place in places]
    except TooLong:
        return list(places)
    return shorter if price(tape, shorter) < price(tape, places) else list(places)


def price(tape: SeriesTape, places: Sequence[int]) -> int:
    """How many sums of products the values cost at each order."""
    return sum(tape.operations[place].kind in DEAR for place in tape.needed(places))


def terms_of(tape: SeriesTape, place: int, known: dict[int, Terms]) -> Terms:
    """A value as a sum of terms."""
    if place not in known:
        operation = tape.operations[place]
        if operation.kind == "number":
            known[place] = {PLAIN: operation.numbers[0]}
        elif operation.kind == "sum":
            found: Terms = {PLAIN: operation.numbers[0]}
            for value, factor in zip(operation.values, operation.numbers[1:], strict=True):
                for term, weight in terms_of(tape, value, known).items():
                    add_term(found, term, weight * factor)
            known[place] = found
        elif operation.kind == "times":
            first, second = (terms_of(tape, value, known) for value in operation.values)
            known[place] = product_of_sums(first, second)
        elif operation.kind in ("sin", "cos"):
            known[place] = one_harmonic(operation.kind, angle_of(tape, operation.values[0]))
        else:
            known[place] = {(((place, 1),), "", ()): ONE}
    return known[place]


def angle_of(tape: SeriesTape, place: int) -> Angle:
    """An argument as a whole combination of angles, or as one angle of its own."""
    constant, terms = tape.combination(place)
    whole = vanishes(constant) and all(isinstance(factor, fmpq) and factor.q == 1 for factor in terms.values())
    return tuple((value, int(factor.p)) for value, factor in sorted(terms.items())) if whole else ((place, 1),)


def add_term(terms: Terms, term: Term, weight: Exact) -> None:
    total = terms.get(term, ZERO) + weight
    if vanishes(total):
        terms.pop(term, None)
    else:
        terms[term] = total
    if len(terms) > MOST_TERMS:
        raise TooLong


def one_harmonic(kind: str, angle: Angle, factor: Exact = ONE) -> Terms:
    """factor · sin or cos of an angle, whose first factor is made positive; of no angle a number."""
    if not angle:
        return {PLAIN: factor} if kind == "cos" else {}
    if angle[0][1] < 0:
        angle = tuple((value, -times) for value, times in angle)
        factor = -factor if kind == "sin" else factor
    return {((), kind, angle): factor}


def product_of_sums(first: Terms, second: Terms) -> Terms:
    found: Terms = {}
    for (powers, kind, angle), weight in first.items():
        for (more, other, turned), factor in second.items():
            merged = powers_together(powers, more)
            for (_, made, result), part in product_of_harmonics(kind, angle, other, turned).items():
                add_term(found, (merged, made, result), weight * factor * part)
    return found


def product_of_harmonics(kind: str, angle: Angle, other: str, turned: Angle) -> Terms:
    """The product of two sines or cosines as a sum."""
    if not kind or not other:
        return {((), kind or other, angle or turned): ONE}
    if kind != other and kind == "cos":
        return product_of_harmonics(other, turned, kind, angle)
    made = "cos" if kind == other else "sin"
    found: Terms = {}
    for sign, weight in ((-1, HALF), (1, -HALF if kind == other == "sin" else HALF)):
        opposite = tuple((value, sign * times) for value, times in turned)
        for term, factor in one_harmonic(made, powers_together(angle, opposite), weight).items():
            add_term(found, term, factor)
    return found


def powers_together(first: Powers, second: Powers) -> Powers:
    """x² y and y z as x² y² z; of angles their sum."""
    counts = dict(first)
    for value, times in second:
        counts[value] = counts.get(value, 0) + times
    return tuple((value, times) for value, times in sorted(counts.items()) if times)


def write_terms(tape: SeriesTape, terms: Terms) -> int:
    """A sum of terms on the tape, those with the same sine or cosine drawn together."""
    groups: dict[tuple[str, Angle], list[tuple[int, Exact]]] = {}
    for (powers, kind, angle), factor in sorted(terms.items(), key=lambda item: item[0]):
        value = tape.number(ONE)
        for place, times in powers:
            for _ in range(times):
                value = tape.times(value, place)
        groups.setdefault((kind, angle), []).append((value, factor))
    parts = []
    for (kind, angle), weighted in groups.items():
        value = tape.sum(weighted)
        if kind:
            argument = tape.sum([(place, fmpq(times)) for place, times in angle])
            value = tape.times(tape.function(kind, argument), value)
        parts.append(value)
    return tape.add(tape.number(ZERO), *parts)
