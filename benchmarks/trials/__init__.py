"""Trials: what the stress suite is made of: random scenes, rewritten scenes, independent answers, and worker processes."""
