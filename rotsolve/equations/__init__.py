"""Equations: the scene over its states, with what the states fix and all that the laws write; swings."""
