"""Naming: the name under `find` that a student or a column means, in any of its spellings."""

from __future__ import annotations

import re
from collections.abc import Iterable

from rotsolve.algebra.notation.letters import RUN, name_to_text, spellings
from rotsolve.grading.reading.names import alike

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
    found = [item for item in names if alike(plain, item)]
    return exactly or (found[0] if len(found) == 1 else None)


def split(line: str) -> tuple[str, str] | None:
    """`a = 2 m`, `a: 2 m` or `a ≈ 2 m` as name and text; None where the line is not of that form."""
    whole = MATHEMATICS.fullmatch(line)
    match = LINE.fullmatch(next(filter(None, whole.groups()), "") if whole else line)
    return (match["name"], match["text"].rstrip()) if match else None
