"""Moment: the time `t=2s` at which functions of time are evaluated; times on the command line in general."""

from __future__ import annotations

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.units.quantities import Quantity, UnitError, parse_quantity
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.language.problem import TimeValue
from rotsolve.language.words import quoted


def read_moment(text: str) -> TimeValue:
    """`t=2s`, or `2 s` alone. Raises ValueError for what is no time."""
    name, sign, written = (part.strip() for part in text.rpartition("="))
    if (sign and name not in ("t", "time")) or not written:
        raise ValueError(f"{quoted(text)} is no moment; write t=2s")
    found = read_time(written, text, "t=2s")
    number = written.removesuffix(found.unit.text).strip() if found.unit is not None else written
    return TimeValue(f"{number} {found.unit.text}" if found.unit is not None else written, found.value)


def read_seconds(text: str) -> float:
    """`10s`, `0.5 min` in seconds. Raises ValueError for what is no time, or not positive."""
    seconds = evaluate(read_time(text, text, "10s").value, {}, digits=17).float
    if not seconds > 0:
        raise ValueError(f"{quoted(text)} is not positive; write 10s")
    return seconds


def read_time(written: str, text: str, example: str) -> Quantity:
    """The time that is written in a text; a ValueError shows an example."""
    try:
        found = parse_quantity(written)
    except UnitError as error:
        raise ValueError(f"{quoted(text)}: {error.message}") from None
    if not found.dimension.matches(DIMENSIONS["time"]):
        raise ValueError(f"{quoted(text)} is no time; write {example}")
    return found
