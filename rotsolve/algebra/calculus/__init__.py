"""Calculus: derivatives, antiderivatives, definite integrals, and where a function repeats itself."""
