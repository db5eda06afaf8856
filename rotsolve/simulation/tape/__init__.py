"""Tape: formulas as one list of operations, what they are worth, and linear equations on it."""
