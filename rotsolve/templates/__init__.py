"""Templates: scenes to start from, a file each: its name is its kind, its title what it is. `rotsolve new` writes them.

A new kind is one more file; tests solve it and see that it is confirmed.
"""

from __future__ import annotations

import re
from pathlib import Path

from rotsolve.language.words import hint, quoted

FOLDER = Path(__file__).parent
TITLE = re.compile(r"^title: (.+)$", re.MULTILINE)


def template_kinds() -> dict[str, str]:
    """The kinds by name, each with its title."""
    return {path.stem: title_of(path) for path in sorted(FOLDER.glob("*.yaml"))}


def title_of(path: Path) -> str:
    found = TITLE.search(path.read_text(encoding="utf-8"))
    return found[1] if found else ""


def template(kind: str) -> str:
    """The text of a kind. Raises KeyError with a hint for an unknown one."""
    known = template_kinds()
    if kind not in known:
        raise KeyError(f"unknown kind {quoted(kind)}; {hint(kind, known, 'kinds')}")
    return (FOLDER / f"{kind}.yaml").read_text(encoding="utf-8")
