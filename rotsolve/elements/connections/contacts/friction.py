"""Friction: how rough two bodies are that touch."""

from __future__ import annotations

from dataclasses import dataclass

from rotsolve.algebra.formula import Formula


@dataclass(frozen=True)
class Friction:
    """Friction of a contact: `none`, one coefficient, static and kinetic, or `any` (rough enough; the engine decides)."""

    kind: str = "none"  # none | coefficient | any
    static: Formula | None = None
    kinetic: Formula | None = None
