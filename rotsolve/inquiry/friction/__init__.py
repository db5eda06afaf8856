"""Friction: whether what touches sticks or slips, decided before the laws are written."""

from rotsolve.inquiry.friction.deciding import decide

__all__ = ["decide"]
