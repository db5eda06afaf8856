"""Exact: the normal form of formulas on FLINT and equality; `writing` and `solving` on top of it."""
