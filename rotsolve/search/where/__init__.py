"""Where: questions with a condition: one more equation, the point of slipping, or an extremum over a letter."""

from rotsolve.search.where.conditions import answer_where
from rotsolve.search.where.extremum import over_a_letter

__all__ = ["answer_where", "over_a_letter"]
