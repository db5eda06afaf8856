"""Moment: the time `t=2s` at which functions of time are evaluated."""

from __future__ import annotations

from rotsolve.algebra.units.quantities import UnitError, parse_quantity
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.scene.model import Moment
from rotsolve.scene.words import quoted


def read_moment(text: str) -> Moment:
    """`t=2s`, or `2 s` alone. Raises ValueError for what is no time."""
    name, sign, written = (part.strip() for part in text.rpartition("="))
    if (sign and name not in ("t", "time")) or not written:
        raise ValueError(f"{quoted(text)} is no moment; write t=2s")
    try:
        found = parse_quantity(written)
    except UnitError as error:
        raise ValueError(f"{quoted(text)}: {error.message}") from None
    if not found.dimension.matches(DIMENSIONS["time"]):
        raise ValueError(f"{quoted(text)} is no time; write t=2s")
    number = written.removesuffix(found.unit.text).strip() if found.unit is not None else written
    return Moment(f"{number} {found.unit.text}" if found.unit is not None else written, found.value)
