"""Checks: what a scene must fulfil to be solved, before anything is worked out; what does not is refused by name."""
