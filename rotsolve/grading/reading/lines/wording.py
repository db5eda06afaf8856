"""Wording: what stands round a value and says nothing of it, as `about`, `± 0.01` or `with g = 9.81`; blanks take its place.

So every other character keeps its column.
"""

from __future__ import annotations

import re

from rotsolve.algebra.notation.letters import spellings
from rotsolve.grading.reading.grammar.tokens import MAX_LENGTH
from rotsolve.grading.reading.names import Names

_ABOUT = re.compile(
    r"(?P<before>^|[=≈:])\s*(?:ca|approx|approximately|about|roughly|circa)\b\.?(?=\s*[-+−]?[\d.√(\\])", re.IGNORECASE
)
_ERROR = re.compile(r"(?:±|\\pm|\+/-)\s*[\d.,]+(?:[eE][-+]?\d+)?")
_IS = re.compile(r"^(?P<name>\s*\\?[^\W\d_][\w{}\\]*\s*)(?P<sign>:(?!=)|(?<=\s)is\b)(?=\s*\S)")
_CAPITAL = re.compile(r"(?<![A-Za-z_\\])(?:SIN|COS|TAN|SQRT|Sin|Cos|Tan|Sqrt)(?![A-Za-z_])")
_PER = re.compile(r"(?<=[A-Za-z²³])(?P<blank>\s+)(?P<word>per|squared|cubed)\b")  # metres per second squared
_MARKS = {"per": "/", "squared": "^2", "cubed": "^3"}
_HEAD = re.compile(r"\s*(?P<name>[^\W\d_²]\w*?)\s*(?:\^\s*2|²)?\s*[=≈]")
_AGAIN = re.compile(r"[,;]\s*(?:(?:so|hence|thus|and)\s+)?(?P<name>[^\W\d_]\w*)\s*[=≈]")
_CLAUSE = re.compile(
    r"(?:[,;(]|\b(?:with|where|for|taking|using|and)\b)\s*(?P<name>[^\W\d_]\w*)\s*=\s*[-+−]?\d[^=,;()]*\)?\s*$"
)


def bare(text: str, names: Names) -> str:
    """The line without words that say nothing of its value; one that is too long for any stays as it is."""
    if len(text) > MAX_LENGTH:
        return text
    text = told_last(text, names)
    if _ABOUT.search(text):
        text = _ABOUT.sub(lambda match: match["before"] + blank(match[0][len(match["before"]) :]), text)
    text = _ERROR.sub(lambda match: blank(match[0]), text)
    text = _IS.sub(lambda match: f"{match['name']}{'=':>{len(match['sign'])}}", text)
    text = _PER.sub(lambda match: match["blank"] + _MARKS[match["word"]].ljust(len(match["word"])), text)
    text = _CAPITAL.sub(lambda match: match[0].lower(), text)
    clause = _CLAUSE.search(text)
    before = "" if clause is None else text[: clause.start()].rstrip(" ,;")
    if clause is not None and before and not names.givens.isdisjoint(spellings(clause["name"])):
        text = before.ljust(len(text))
    return text


def told_last(text: str, names: Names) -> str:
    """The line from where it tells its answer again: v² = 2 a s = 5.9, v = 2.4 m/s."""
    head = _HEAD.match(text)
    if head is None or not names.is_asked(head["name"]):
        return text
    again = [match.start("name") for match in _AGAIN.finditer(text) if names.is_asked(match["name"])]
    return text[again[-1] :].rjust(len(text)) if again else text


def blank(words: str) -> str:
    return " " * len(words)
