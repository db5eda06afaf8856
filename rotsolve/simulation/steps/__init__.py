"""Steps: a motion followed step by step, twice, through all that happens."""
