"""Advancing: a bar for one long calculation that writes nothing on its way."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from typing import Any

from rotsolve.run import PATIENCE


@contextmanager
def advancing(name: str) -> Iterator[Callable[[float], None]]:
    """What tells how much has been done: once it takes long, and on a terminal, by a bar."""
    if not sys.stderr.isatty():
        yield lambda part: None
        return
    start = monotonic()
    bars: list[Any] = []

    def tell(part: float) -> None:
        if not bars and monotonic() - start > PATIENCE:
            from rotsolve.render.terminal import Advance

            bars.append(Advance(name, sys.stderr))
        if bars:
            bars[0].to(part)

    try:
        yield tell
    finally:
        for bar in bars:
            bar.done()
