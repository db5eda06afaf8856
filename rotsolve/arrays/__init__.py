"""Arrays: one solved problem for many sets of givens: its closed forms as programs, over floats (NumPy) or over certified balls."""
