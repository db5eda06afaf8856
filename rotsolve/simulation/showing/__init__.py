"""Showing: a motion as a table, as numbers, and as a picture."""
