"""Conditions: what a student writes behind an answer that holds in one case, `½ g sin β if μ > ½ tan β; 0 otherwise`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from msgspec import Struct

from rotsolve.core.derivation import Equality
from rotsolve.grading.reading.answers import read_line, si_formula
from rotsolve.grading.reading.records import AnswerError, Names

_SIGN = r"<=|>=|[<>≤≥⩽⩾]|\\(?:leq?|geq?|lt|gt)(?![A-Za-z])"
_BEHIND = re.compile(
    rf"[\s,]*(?P<open>\()?\s*\b(?:if|when|for|where|while|provided(?:\s+that)?|as\s+long\s+as|falls|wenn|für)\b(?P<said>.*(?:{_SIGN}).*)$",
    re.IGNORECASE,
)
_REST = re.compile(r"[\s,(]*\b(?:otherwise|else|sonst)\b[\s.)]*$", re.IGNORECASE)
_ELSE = re.compile(r"[\s,(]*\b(?:otherwise|else|sonst)\b[\s,:]+(?P<text>\S.*)$", re.IGNORECASE)
# before `else 0`, `, 0 otherwise`
_NEXT = re.compile(
    r";|,?\s*(?=\b(?:else|otherwise|sonst)\b\s*[^\s.)])|,(?=[^,;]*\b(?:else|otherwise|sonst)\b[\s.)]*$)", re.IGNORECASE
)
CONDITIONAL = re.compile(
    rf"\b(?:if|when|for|where|while|provided|as long as|falls|wenn|für)\b.*(?:{_SIGN})", re.IGNORECASE
)
_AND = re.compile(r"\band\b|[,&]|\\land\b", re.IGNORECASE)
_SIGNS = {
    "<=": "≤",
    ">=": "≥",
    "⩽": "≤",
    "⩾": "≥",
    "\\le": "≤",
    "\\leq": "≤",
    "\\ge": "≥",
    "\\geq": "≥",
    "\\lt": "<",
    "\\gt": ">",
}


class Claim(Struct, frozen=True):
    """An answer and the conditions under which it is given; none where it is given in all other cases."""

    text: str
    conditions: tuple[Equality, ...]


def claims_in(text: str, names: Names) -> tuple[Claim, ...]:
    """The answers in a line, each with its conditions; nothing where one has none, or they can't be read."""
    if not re.search(_SIGN, text):
        return ()
    try:
        return tuple(claim_of(piece, names) for piece in _NEXT.split(text) if piece.strip())
    except AnswerError:
        return ()


def claim_of(text: str, names: Names) -> Claim:
    """One answer with what stands behind it."""
    first = _ELSE.match(text)
    if first is not None:
        return Claim(first["text"], ())
    rest = _REST.search(text)
    if rest is not None:
        return Claim(text[: rest.start()], ())
    behind = _BEHIND.search(text)
    if behind is None:
        raise AnswerError("it has no condition", 0, len(text))
    said = behind["said"].rstrip(" .")
    said = said.removesuffix(")") if behind["open"] else said
    return Claim(text[: behind.start()], tuple(conditions_read(said, names)))


def conditions_read(said: str, names: Names) -> Iterator[Equality]:
    """What has to hold: μ ≥ ½ tan β, 0 < u < w."""
    for part in _AND.split(said):
        signs = [_SIGNS.get(sign, sign) for sign in re.findall(_SIGN, part)]
        readings = (read_line(side, Names(names.givens, names.answers)) for side in re.split(_SIGN, part))
        sides = [next((one for one in map(si_formula, found) if one is not None), None) for found in readings]
        if not signs or None in sides:
            raise AnswerError("its condition can't be read", 0, len(said))
        for sign, (left, right) in zip(signs, pairwise(sides), strict=True):
            assert left is not None and right is not None
            yield Equality(left, right, sign)
