"""Choices: which of the words to choose from a line names: `(c)`, `only c`, `Pair c`, `a and b`."""

from __future__ import annotations

import re
from collections.abc import Collection

from rotsolve.grading.reading.prose import LEADING, SAYS

NOTHING = "none"  # no option at all
_KINDS = """
    only just both all pair pairs option options case cases choice answer answers letter number no body bodies object objects set situation
    figure graph curve point part candidate und beide nur fall paar möglichkeit körper
"""
BESIDE = frozenset(_KINDS.split()) | LEADING | SAYS  # words that choose nothing


def options_named(text: str, options: Collection[str], nouns: Collection[str] = ()) -> frozenset[str] | None:
    """The options that a line names, as they are declared; None where another word stands in it, as in `not a` or `a or b`.

    `nouns` are words of what is asked, which choose nothing: `disc b`. A word that is an option is one, though it may be an article: a.
    """
    declared = {plain_words(option): option for option in (*options, NOTHING)}
    longest = sorted((option for option in declared if option), key=len, reverse=True)
    spoken = re.compile("|".join(rf"(?<!\w){re.escape(option)}(?!\w)" for option in longest))
    line = plain_words(text)
    rest = re.sub(r"[\s\W]+", " ", spoken.sub(" ", line)).split()
    if any(word not in BESIDE and word not in nouns for word in rest):
        return None
    return frozenset(declared[found] for found in spoken.findall(line)) or None


def plain_words(words: str) -> str:
    """Words in small letters with one space between them; underlines are spaces."""
    return " ".join(words.lower().replace("_", " ").split())
