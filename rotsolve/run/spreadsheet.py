"""Spreadsheet: texts for the cells of a CSV, none of which a spreadsheet works out."""

from __future__ import annotations

import re

NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
FORMULA = ("=", "+", "-", "@", "\t", "\r", "＝", "＋", "－", "＠")  # with these a cell begins that is worked out


def harmless(text: str) -> str:
    """The text as a spreadsheet keeps it: an apostrophe in front of what it would take for a formula, and is no number."""
    return f"'{text}" if text.startswith(FORMULA) and not NUMBER.fullmatch(text) else text
