"""Functions that students write beside those of the program: reciprocals, and inverses as a power of −1."""

from __future__ import annotations

RECIPROCAL = {"cot": "tan", "sec": "cos", "csc": "sin", "cosec": "sin"}  # cot x is 1/tan x
INVERSE = {"sin": "asin", "cos": "acos", "tan": "atan"}  # sin⁻¹ x may be arcsin x
TAKES_POWER = frozenset(("sqrt", "log", "exp", "asin", "acos", "atan"))  # √x² is √(x²), but sin θ² is likelier (sin θ)²
EULER = "e"  # the base of the exponential, where no letter of the scene is called so
