"""Roots: which of several roots of an equation is meant, each choice with a stated reason."""

from rotsolve.inquiry.roots.choosing import RootChoice
from rotsolve.inquiry.roots.numbers import Numbers, rough, side_of

__all__ = ["Numbers", "RootChoice", "rough", "side_of"]
