"""Friction: whether what touches sticks or slips, decided before the laws are written."""

from rotsolve.search.friction.deciding import Decision, decide

__all__ = ["Decision", "decide"]
