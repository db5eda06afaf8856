"""Explain: why there is no answer, in the scene's words: what is missing or contradictory, where, and what may help."""
