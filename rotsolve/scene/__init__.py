"""Scene: a YAML file is read as a Problem, with every fault at its line and column."""
