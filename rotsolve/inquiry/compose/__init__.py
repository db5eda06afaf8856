"""Composing: a solved inquiry as a derivation that can be printed."""

from rotsolve.inquiry.compose.composer import Composer, in_letters

__all__ = ["Composer", "in_letters"]
