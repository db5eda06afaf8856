"""Comparing: whether what was read is the answer: expressions, numbers with units, vectors, and what differs in the sign alone."""
