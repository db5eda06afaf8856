"""Shuffle: whole numbers in an order that a seed tells, the same with every Python and on every machine.

Of `random.Random` only `random()` is called: Python promises that its numbers stay as they are for a seed, and does not promise how
`randrange` and `shuffle` make theirs. Its 53 bits become a number below n by exact arithmetic alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

BITS = 53  # of a number that `random()` gives
SPARE = 32  # bits beyond those that a number has, so that all are as likely as each other to one part in 2³²


def shuffled(size: int, seed: int) -> Iterator[int]:
    """0, …, size − 1 in a random order (Fisher and Yates); what has not been exchanged yet takes no memory."""
    generator = Random(seed)
    moved: dict[int, int] = {}
    for first in range(size):
        drawn = first + below(size - first, generator)
        left = moved.pop(first, first)
        if drawn == first:
            yield left
        else:
            yield moved.get(drawn, drawn)
            moved[drawn] = left


def below(n: int, generator: Random) -> int:
    """A number from 0 to n − 1: ⌊n x⌋ where the binary digits of x come from `random()`."""
    words = (n.bit_length() + SPARE) // BITS + 1
    digits = 0
    for _ in range(words):
        digits = digits << BITS | int(generator.random() * 2**BITS)
    return digits * n >> words * BITS
