"""Exact: the normal form of formulas on FLINT, equality, textbook form, linear systems and roots."""
