"""Sheet schema: the keys of a sheet file as a JSON Schema for editors."""

from __future__ import annotations

from typing import Any

from rotsolve.language.sheet_keys import LISTED, SHEET
from rotsolve.scene.schema import DIALECT, map_schema

EXAMPLE = {
    "sheet": "Turning bodies",
    "paper": "a4",
    "problems": ["winch.yaml", {"problem": "roll.yaml", "points": 6, "room": "3 cm"}],
}


def sheet_schema() -> dict[str, Any]:
    """The schema of a sheet file."""
    about = {
        "$schema": DIALECT,
        "title": "rotsolve sheet",
        "description": "problems on one sheet, as docs/keys.md describes it",
        "examples": [EXAMPLE],
    }
    sheet = map_schema(SHEET)
    item = {"anyOf": [{"type": "string"}, map_schema(LISTED)]}
    sheet["properties"]["problems"] |= {"anyOf": [{"type": "string"}, {"type": "array", "items": item, "minItems": 1}]}
    return {**about, **sheet}
