"""Reading: what a student may write, as formulas, numbers with units, vectors, words and equations."""
