"""Ropes: light strings by their legs between bodies, and heavy ropes that are bodies of their own."""
