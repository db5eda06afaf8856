"""Positive: the letters of a scene that are surely positive."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.formula import Symbol
from rotsolve.algebra.units.dimension import ANGLE, is_positive
from rotsolve.language.problem import Given


def positive_letters(givens: Sequence[Given]) -> frozenset[str]:
    """Givens that are positive: masses, lengths, times and the like without a number, and every number that is."""
    signs = SignOracle({given.name: given.value for given in givens if given.value is not None})
    told = {given.name: signs.by_numbers(Symbol(given.name)) for given in givens if not given.asked}
    return frozenset(
        given.name
        for given in givens
        if given.name in told
        and (told[given.name] == 1 if told[given.name] is not None else is_positive(given.dimension))
        and (is_positive(given.dimension) or not is_angle(given))
    )


def is_angle(given: Given) -> bool:
    """Whether a given is an angle, which may be negative."""
    return given.dimension == ANGLE
