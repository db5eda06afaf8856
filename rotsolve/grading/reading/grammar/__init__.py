"""Grammar: a line as tokens, LaTeX too, and formulas with the ways to read them."""
