"""Chains: the members of `a = 2/3 · 9.81 · 0.5 = 3.27 m/s²`: the last one is the answer, the others are the way to it."""

from __future__ import annotations

import re

from rotsolve.grading.reading.names import Names

EQUALS = re.compile(r"(?<![<>!]):?==?|[≈≃＝]|\\(?:approx|simeq)(?![A-Za-z])")
_NAME = r"\\?[^\W\d_][\w{}\\]*(?:\(t\))?"
_ALONE = re.compile(rf"[\s$]*({_NAME})[\s$]*")
_SET = str.maketrans("", "", "\\{}$ ")  # what only says how letters are set: \omega_{0} is omega_0
_NEXT_ANSWER = re.compile(
    rf"(?:[,;\n]|\band\b|\bund\b|&|\\\\)\s*\$?\s*{_NAME}\s*$"
)  # `a = 3 m/s², T` before another `=`


def members(text: str, names: Names) -> tuple[str, ...]:
    """The members of a chain, each at its place in the line, with blanks before it; nothing where the line is none.

    A name in front that is the one asked for is no member. What tells another name, or is an equation with the asked one in it, is no
    chain of values, nor are several answers in one line.
    """
    if text.count("=") < 1 and EQUALS.search(text) is None:
        return ()
    pieces = _pieces(text)
    alone = _ALONE.fullmatch(pieces[0])
    if not pieces[0].strip(" $") or (alone and names.is_asked(alone[1].removesuffix("(t)").translate(_SET))):
        pieces = pieces[1:]
    elif alone or _holds(pieces[0], names):
        return ()
    whole = len(pieces) > 1 and all(piece.strip(" $") for piece in pieces)
    return tuple(pieces) if whole and not any(_NEXT_ANSWER.search(piece) for piece in pieces[:-1]) else ()


def _pieces(text: str) -> list[str]:
    """What stands between the signs of equality."""
    pieces, start = [], 0
    for sign in EQUALS.finditer(text):
        pieces.append(" " * start + text[start : sign.start()])
        start = sign.end()
    return [*pieces, " " * start + text[start:]]


def _holds(piece: str, names: Names) -> bool:
    """Whether the name that is asked for stands in a piece as a word of its own."""
    return any(names.is_asked(match[0]) for match in re.finditer(r"[^\W\d_]\w*", piece))
