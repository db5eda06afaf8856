"""Notation: formulas read from text and written as text."""
