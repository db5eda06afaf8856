"""Writing: polynomials and fractions of a field as a textbook writes them."""
