"""Naming: the name under `find` that a student or a column means, in any of its spellings."""

from __future__ import annotations

import re
from collections.abc import Iterable

from rotsolve.algebra.notation.letters import RUN, name_to_text, spellings

LATEX = str.maketrans("", "", "\\{}$ ")  # $\omega_{0}$ is omega_0
LINE = re.compile(r"\s*(?P<name>[^=:≈]{1,60}?)\s*[=:≈](?![=:≈])\s*(?P<text>.*)", re.DOTALL)
MATHEMATICS = re.compile(
    r"\s*(?:\${1,2}([^$]*)\${1,2}|\\\((.*)\\\)|\\\[(.*)\\\])\s*", re.DOTALL
)  # $a = 2 m$ as a whole


def meant(name: str, asked: Iterable[str]) -> str | None:
    """The asked name that is meant, None where it is none of them."""
    names = tuple(asked)
    if name.strip() in names:
        return name.strip()
    plain = name.strip().translate(LATEX)
    if not re.fullmatch(RUN, plain):
        return None
    said = {plain, *spellings(plain)}
    printed = {name_to_text(text) for text in said}
    exactly = next((item for item in names if item in said or name_to_text(item) in printed), None)
    return exactly or alike(plain, names)


def alike(plain: str, names: tuple[str, ...]) -> str | None:
    """The one name that differs in capitals and underlines alone, `Fx` for F_x, or is typed as w for ω; None where there are several."""
    folded = plain.replace("_", "").casefold()
    found = [name for name in names if name.replace("_", "").casefold() == folded and (len(plain) > 1 or name == plain)]
    if plain.startswith("w") and not found:
        found = [name for name in names if name == f"omega{plain[1:]}"]
    return found[0] if len(found) == 1 else None


def split(line: str) -> tuple[str, str] | None:
    """`a = 2 m`, `a: 2 m` or `a ≈ 2 m` as name and text; None where the line is not of that form."""
    whole = MATHEMATICS.fullmatch(line)
    match = LINE.fullmatch(next(filter(None, whole.groups()), "") if whole else line)
    return (match["name"], match["text"].rstrip()) if match else None
