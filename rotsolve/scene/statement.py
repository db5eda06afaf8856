"""Statement: the text of a problem, in which `{m}` stands for a given with its value, `m = 2 kg`, and `{value of m}` for `2 kg` alone."""

from __future__ import annotations

import re
from collections.abc import Iterator

from msgspec import Struct

BRACES = re.compile(r"\{\{|\}\}|\{(?P<inner>[^{}]*)\}")
ALONE = "value of "


class Slot(Struct, frozen=True):
    """A place in the text where a given is told: with its letter, or by its value `alone`; `text` is the place as written."""

    name: str
    alone: bool
    text: str


def parts(text: str) -> Iterator[str | Slot]:
    """The text in pieces of prose and slots; `{{` and `}}` are braces."""
    position = 0
    for match in BRACES.finditer(text):
        yield text[position : match.start()]
        position = match.end()
        inner = match["inner"]
        if inner is None:
            yield match[0][0]
            continue
        words = " ".join(inner.split())
        yield Slot(words.removeprefix(ALONE), words.startswith(ALONE), match[0])
    yield text[position:]


def slots(text: str) -> Iterator[Slot]:
    """The slots of a text."""
    return (part for part in parts(text) if isinstance(part, Slot))
