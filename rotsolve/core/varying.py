"""Varying: values that run with time, place or speed; what they may speak of, and how fast that makes things change."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rotsolve.algebra.formula import Formula
from rotsolve.core.registry import GENERIC, SEPARATOR, TIME, in_midst

PLACES = ("angle", "rotation", "displacement")
RATES = ("angular_velocity", "velocity")
CONSTANT, POSITION, RATE, MIXED = "constant", "position", "rate", "mixed"
UNKNOWN = "unknown"  # of what nothing is said: it may vary as it likes


def paths_in(value: Formula) -> Iterator[tuple[str, str, str]]:
    """The paths of bodies in a value, as (letter, body, quantity): a letter named `wheel.rotation` stands for that path."""
    for name in sorted(value.symbols()):
        owner, dot, word = name.rpartition(".")
        if dot:
            yield name, owner, word


def pace_of(value: Formula) -> str:
    """How a value varies: 'constant', with the 'time', the 'position' or the 'rate' alone, or 'mixed'."""
    kinds = [POSITION if word in PLACES else RATE for _, _, word in paths_in(value)]
    return combined([*kinds, *([TIME] if TIME in value.symbols() else [])])


def combined(paces: Iterable[str]) -> str:
    """The pace of what depends on several things."""
    kinds = set(paces) - {CONSTANT}
    if UNKNOWN in kinds:
        return UNKNOWN
    return MIXED if len(kinds) > 1 else kinds.pop() if kinds else CONSTANT


def at_any_time(names: Iterable[str]) -> bool:
    """Whether one of the letters of quantities is of the midst of a phase."""
    return any(in_midst(name) for name in names)


def running(names: Iterable[str], kinds: Iterable[str] = (*PLACES, *RATES)) -> list[str]:
    """Of the letters of quantities, those of places and rates in the midst of a phase."""
    split = ((name, name.split(SEPARATOR)) for name in sorted(names))
    return [name for name, parts in split if parts[0] in set(kinds) and parts[-1].startswith(GENERIC)]
