"""Limits: what is positive, or not negative, in every scene that can be."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.formula import Formula


class Limit(Struct, frozen=True):
    """gap ≥ 0, or gap > 0 where it is `strict`; `words` say what is the matter where it is not, `help` what to do where it is negative."""

    gap: Formula
    words: str
    strict: bool = False
    help: str = ""
