"""Swings: bodies that are displaced from their equilibrium and come back: what the laws say there, and the period."""

from rotsolve.inquiry.swings.swing import Swing

__all__ = ["Swing"]
