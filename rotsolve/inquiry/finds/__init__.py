"""Finds: what the `find` lines of a scene ask for, each at its own states, phases and events."""

from rotsolve.inquiry.finds.entries import entries
from rotsolve.inquiry.finds.find import asked

__all__ = ["asked", "entries"]
