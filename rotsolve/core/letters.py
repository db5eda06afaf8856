"""Letters: the order in which a textbook writes letters in a product, by what they measure."""

from __future__ import annotations

from collections.abc import Iterable

from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.quantity import DIMENSIONS

RANKS = (  # m g, F R, M R², I ω, m v L, ½ k x², M g L cos θ
    "number",
    "mass",
    "moment of inertia",
    "",  # constants of other dimensions, such as those of a law of force
    "stiffness",
    "torsional stiffness",
    "force",
    "torque",
    "power",
    "acceleration",
    "momentum",
    "velocity",
    "length",
    "angular velocity",
    "angular acceleration",
    "angle",
    "time",
)
_RANK = {DIMENSIONS[word]: rank for rank, word in reversed(list(enumerate(RANKS))) if word}
OTHER = RANKS.index("")


def letter_order(letters: Iterable[tuple[str, Dimension | None]]) -> tuple[str, ...]:
    """Names in the order of a printed product; equal ranks keep the order in which they come."""
    ranked = [
        (OTHER if dimension is None else _RANK.get(dimension, OTHER), index, name)
        for index, (name, dimension) in enumerate(letters)
    ]
    return tuple(name for _, _, name in sorted(ranked))
