"""Lines: what stands round the values of a line: words, directions, signs of equality, decimal commas."""
