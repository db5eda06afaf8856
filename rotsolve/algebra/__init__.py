"""Algebra: formulas, and what is true of them: normal forms, calculus, certified numbers, units, notation."""
