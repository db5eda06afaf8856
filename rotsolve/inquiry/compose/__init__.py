"""Composing: a solved inquiry as a derivation that can be printed."""

from rotsolve.inquiry.compose.composer import Composer
from rotsolve.inquiry.compose.letters import Letters, in_letters
from rotsolve.inquiry.compose.missing import with_missing_told

__all__ = ["Composer", "Letters", "in_letters", "with_missing_told"]
