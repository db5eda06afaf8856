"""Languages: in which pages are printed besides English, each by one file, the table of its phrases; it is read when it is asked for."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rotsolve.page.languages.language import Language

ENGLISH = "en"  # in which all prose is written
LANGUAGES = {ENGLISH: "English", "de": "German"}  # another one is a row here, and a table `fr.txt` in this folder


@cache
def language_named(name: str) -> Language | None:
    """The language of that name, None for English; a KeyError names the ones there are."""
    if name not in LANGUAGES:
        raise KeyError(f"unknown language {name!r}: {', '.join(LANGUAGES)}")
    if name == ENGLISH:
        return None
    from rotsolve.page.languages.language import read_language

    return read_language(name)
