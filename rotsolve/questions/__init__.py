"""Questions: what the lines of `find` ask, at which states and phases; functions of time."""
