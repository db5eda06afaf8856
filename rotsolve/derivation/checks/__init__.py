"""Checks: whether the answers hold: by a second law, by all that the laws write, in what strings and contacts can bear."""

from rotsolve.derivation.checks.consistency import contradiction, disagreement, turned_back
from rotsolve.derivation.checks.verify import checks

__all__ = ["checks", "contradiction", "disagreement", "turned_back"]
