"""Friction: how rough two bodies are that touch."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.formula import Formula


class Friction(Struct, frozen=True):
    """Friction of a contact: `none`, one coefficient, static and kinetic, or `any` (rough enough; the engine decides)."""

    kind: str = "none"  # none | coefficient | any
    static: Formula | None = None
    kinetic: Formula | None = None
