"""Units and dimensions, with exact factors."""
