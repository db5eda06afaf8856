"""Told: places that other places tell, x = ∫ c₁ φ̇ + c₂ cos φ φ̇ dt = c₁ φ + c₂ sin φ + …, need not be followed by themselves.

So the centre of a hinged rod goes with its angle, and a block with the pulley that its string turns.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from rotsolve.simulation.moving.course import Variable
from rotsolve.simulation.moving.names import letters_in
from rotsolve.simulation.tape.tape import ONE, Exact, Tape, vanishes

ANTIDERIVATIVES: Mapping[str, tuple[str, Exact]] = {"cos": ("sin", ONE), "sin": ("cos", -ONE)}


def told_by_others(
    tape: Tape, variables: Sequence[Variable], letters: Mapping[str, int], used: Collection[str]
) -> dict[str, int]:
    """The places on the tape of those numbers of a state that others tell at any moment; what is `used` stays."""
    found: dict[str, int] = {}
    holding: set[str] = set()  # numbers by which others are told
    for item in variables:
        if item.letter in holding or item.letter in used:
            continue
        others = {other.rate: other for other in variables if other is not item and other.letter not in found}
        place = antiderivative(tape, item.rate, others, letters)
        if place is not None:
            start = at_first(tape, place, variables, letters)
            found[item.letter] = tape.sum([(place, ONE), (tape.number(item.start - start), ONE)])
            holding |= letters_in(tape, place)
    return found


def antiderivative(tape: Tape, rate: int, others: Mapping[int, Variable], letters: Mapping[str, int]) -> int | None:
    """What has a rate Σ c f(φ) φ̇, f constant, a sine or a cosine; None where it is not of this form."""
    constant, terms = tape.combination(rate)
    if not terms or not vanishes(constant):
        return None
    parts: list[tuple[int, Exact]] = []
    for place, factor in terms.items():
        if place in others:
            parts.append((letters[others[place].letter], factor))
            continue
        found = of_product(tape, place, others, letters)
        if found is None:
            return None
        parts.append((found[0], factor * found[1]))
    return tape.sum(parts)


def of_product(
    tape: Tape, place: int, others: Mapping[int, Variable], letters: Mapping[str, int]
) -> tuple[int, Exact] | None:
    """The antiderivative of cos φ φ̇ or sin φ φ̇ with its sign."""
    operation = tape.operations[place]
    for function, speed in (operation.values, operation.values[::-1]) if operation.kind == "times" else ():
        inner = tape.operations[function]
        if speed in others and inner.kind in ANTIDERIVATIVES and inner.values == (letters[others[speed].letter],):
            kind, sign = ANTIDERIVATIVES[inner.kind]
            return tape.function(kind, inner.values[0]), sign
    return None


def at_first(tape: Tape, place: int, variables: Sequence[Variable], letters: Mapping[str, int]) -> Exact:
    """What a sum of numbers of the state, of their sines and cosines is worth at first."""
    starts = {letters[item.letter]: item.start for item in variables}
    total, terms = tape.combination(place)
    for value, factor in terms.items():
        operation = tape.operations[value]
        number = starts[value] if value in starts else starts[operation.values[0]]
        if operation.kind in ANTIDERIVATIVES:
            number = tape.constant(tape.function(operation.kind, tape.number(number)))
        total = total + factor * number
    return total
