"""Mistakes: what a wrong answer may come from: the same scene solved with one mistake in it."""
