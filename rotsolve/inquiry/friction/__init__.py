"""Friction: whether what touches sticks or slips, decided before the laws are written."""

from rotsolve.inquiry.friction.deciding import decide, rubs

__all__ = ["decide", "rubs"]
