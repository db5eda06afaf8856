"""Circles: answers that tell each other and nothing else, such as a = (m g − T)/m with T = m (g − a)."""

from __future__ import annotations

from collections.abc import Mapping


def circles(holds: Mapping[str, frozenset[str]]) -> dict[str, frozenset[str]]:
    """The answers that lead back to themselves, each with those on its way; `holds` are the answers whose letters each one holds."""
    behind: dict[str, frozenset[str]] = {}
    for name in holds:
        reached, waiting = set[str](), list(holds[name])
        while waiting:
            other = waiting.pop()
            if other not in reached:
                reached.add(other)
                waiting.extend(holds.get(other, ()))
        behind[name] = frozenset(reached)
    return {name: reached - {name} for name, reached in behind.items() if name in reached}
