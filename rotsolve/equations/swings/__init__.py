"""Swings: bodies that are displaced from their equilibrium and come back: what the laws say there, and the period."""

from rotsolve.equations.swings.swing import Swing

__all__ = ["Swing"]
