"""The order of variants: every number once, and the same for a seed with every Python and on every machine."""

from __future__ import annotations

from collections import Counter
from itertools import islice

import pytest

from rotsolve.keys.variants import shuffled


@pytest.mark.parametrize("size", [1, 2, 3, 10, 257])
def test_every_number_comes_once(size: int) -> None:
    assert sorted(shuffled(size, 5)) == list(range(size))


def test_the_order_is_that_of_the_first_release() -> None:
    """It is part of what users rely on: a change would make other sheets of the same seed."""
    assert list(shuffled(12, 1)) == [1, 10, 9, 5, 7, 8, 2, 0, 3, 6, 11, 4]
    assert list(islice(shuffled(10**30, 7), 2)) == [323832764833162384349082732415, 72436286667542819182275460520]


def test_seeds_differ() -> None:
    assert len({tuple(shuffled(20, seed)) for seed in range(50)}) == 50


def test_all_orders_are_as_likely() -> None:
    counts = Counter(tuple(shuffled(3, seed)) for seed in range(6000))
    assert len(counts) == 6
    assert all(850 < count < 1150 for count in counts.values())


def test_a_large_range_takes_no_memory() -> None:
    found = list(islice(shuffled(10**15, 3), 1000))
    assert len(set(found)) == 1000
    assert max(found) < 10**15
