"""Witness: what a piece of work has asked numbers for. With other numbers of the same signs it takes the same way."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from rotsolve.algebra.formula import Formula


class Witness:
    """The formulas whose numbers were asked for; `by_size` where more of a number than its sign has decided something."""

    def __init__(self) -> None:
        self.asked: dict[Formula, None] = {}
        self.by_size = False


OPEN: list[Witness] = []


@contextmanager
def witnessed() -> Iterator[Witness]:
    """Note all that numbers are asked for meanwhile."""
    witness = Witness()
    OPEN.append(witness)
    try:
        yield witness
    finally:
        OPEN.pop()


def watched() -> bool:
    """Whether anyone wants to know."""
    return bool(OPEN)


def note(value: Formula, *, by_size: bool = False) -> None:
    """The number of a formula is asked for."""
    for witness in OPEN:
        witness.asked[value] = None
        witness.by_size |= by_size


def decided_by_size() -> None:
    """Something is decided by the size of a number, or by where the roots of an equation lie."""
    for witness in OPEN:
        witness.by_size = True
