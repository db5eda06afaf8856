"""Clock: the processor time of the best of some runs, each with nothing remembered from the one before."""

from __future__ import annotations

import gc
import sys
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


def forget() -> None:
    """Clear what the functions of rotsolve and of SymPy remember."""
    for name, module in list(sys.modules.items()):
        if name.partition(".")[0] == "rotsolve":
            for value in vars(module).values():
                getattr(value, "cache_clear", int)()
    if "sympy" in sys.modules:
        sys.modules["sympy.core.cache"].clear_cache()
