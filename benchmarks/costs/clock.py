"""Clock: the processor time of the best of some runs."""

from __future__ import annotations

import gc
from collections.abc import Callable
from time import process_time
from typing import Any

ENOUGH = 3.0  # seconds after which no further run is made


def best(work: Callable[[], Any], runs: int, *, before: Callable[[], Any] | None = None) -> float:
    """The least seconds of so many runs, `before` each of which something is cleared."""
    least, spent = float("inf"), 0.0
    for _ in range(runs):
        if before is not None:
            before()
        gc.collect()
        start = process_time()
        work()
        took = process_time() - start
        least, spent = min(least, took), spent + took
        if spent > ENOUGH:
            break
    return least
