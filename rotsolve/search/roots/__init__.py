"""Roots: which of several roots of an equation is meant, each choice with a stated reason."""
