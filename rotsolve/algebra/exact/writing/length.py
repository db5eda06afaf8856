"""Length: how long a formula is to read."""

from __future__ import annotations

from rotsolve.algebra.formula import Formula


def length(node: Formula) -> int:
    """How long a formula is to read: its number of nodes."""
    count, waiting = 0, [node]
    while waiting:
        count += 1
        waiting.extend(waiting.pop().children())
    return count
