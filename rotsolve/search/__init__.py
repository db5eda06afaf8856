"""Search: a run over the questions by a choice of laws; roots, extrema, cases, and why there is no answer."""
