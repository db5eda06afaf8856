"""What rotsolve costs: the parts of `benchmarks/cost.py`, one question a file."""
