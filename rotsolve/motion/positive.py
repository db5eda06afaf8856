"""Positive: the letters of a scene that are surely positive."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.language.problem import Given

POSITIVE = ("mass", "length", "moment of inertia", "stiffness", "torsional stiffness", "time", "acceleration")


def positive_letters(givens: Sequence[Given]) -> frozenset[str]:
    """Givens that are positive: masses, lengths, times and the like, and every number that is."""
    result = set()
    values = {given.name: given.value for given in givens if given.value is not None}
    for given in givens:
        sized = given.dimension is not None and any(DIMENSIONS[word] == given.dimension for word in POSITIVE)
        if sized and not given.asked:
            result.add(given.name)
        elif given.value is not None and not given.asked and not is_angle(given):
            try:
                if (evaluate(given.value, values, digits=3).sign or 0) > 0:
                    result.add(given.name)
            except (Undefined, ValueError):
                continue
    return frozenset(result)


def is_angle(given: Given) -> bool:
    """Whether a given is an angle, which may be negative."""
    return given.dimension is not None and given.dimension == DIMENSIONS["angle"]
