"""Formulas: one held against the closed form of an answer, at points and exactly, with numbers put in too."""
