"""Friction of a contact as a scene tells it."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.core.limits import Limit


class Friction(Struct, frozen=True):
    """Friction of a contact: `none`, one coefficient, static and kinetic, or `any` (rough enough; the engine decides)."""

    kind: str = "none"  # none | coefficient | any
    static: Formula | None = None
    kinetic: Formula | None = None

    def rooms(self, name: str) -> Iterator[Limit]:
        """What slips rubs at most as much as what holds: μ_k ≤ μ_s."""
        if self.static is not None and self.kinetic is not None and self.static != self.kinetic:
            words = f"static friction of `{name}` can't be less than kinetic friction"
            yield Limit(self.static - self.kinetic, words)
