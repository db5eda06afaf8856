"""Composing: a solved search as a derivation that can be printed."""

from rotsolve.derivation.compose.composer import Composer
from rotsolve.derivation.compose.letters import Letters, in_letters
from rotsolve.derivation.compose.missing import with_missing_told

__all__ = ["Composer", "Letters", "in_letters", "with_missing_told"]
