"""Chains: the members of `a = 2/3 · 9.81 · 0.5 = 3.27 m/s²`: the last one is the answer, the others are the way to it."""

from __future__ import annotations

import re

from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.grading.reading.grammar.tokens import MAX_LENGTH, tokens_of
from rotsolve.grading.reading.names import Names
from rotsolve.grading.reading.numbers import are_letters, could_be_number, cut, is_kind, likely_number

EQUALS = re.compile(r"(?<![<>!]):?==?|[≈≃＝]|\\(?:approx|simeq)(?![A-Za-z])")
# what stands between members
_LEADS = re.compile(rf"=>|⇒|[-–]>|→|∴|(?:[,;]\s*)?(?:\bthat is\b|\bi\.e\.),?|{EQUALS.pattern}|;")
WORDS = ("s", ".", ",")  # how the leads end that are words
_IN_BRACKETS = re.compile(r"(?P<formula>.*\S)\s+\((?P<value>[≈\s]*[-+−]?\d[^()]*)\)\s*$")  # 3/5 g sin β (2.49 m/s²)
_NAME = r"\\?[^\W\d_][\w{}\\]*(?:\(t\))?"
_ALONE = re.compile(rf"[\s$]*({_NAME})[\s$]*")
_SET = str.maketrans("", "", "\\{}$ ")  # what only says how letters are set: \omega_{0} is omega_0
# `a = 3 m/s², T` before another `=`
_NEXT_ANSWER = re.compile(rf"(?:[,;\n]|\band\b|&|\\\\)\s*\$?\s*{_NAME}\s*$")


def members(text: str, names: Names) -> tuple[str, ...]:
    """The members of a chain, each at its place in the line, with blanks before it; nothing where the line is none.

    A name in front that is the one asked for is no member. What tells another name, or is an equation with the asked one in it, is no
    chain of values, nor are several answers in one line.
    """
    pieces = _pieces(text, names) if len(text) <= MAX_LENGTH else []
    if len(pieces) < 2:
        return ()
    alone = _ALONE.fullmatch(pieces[0])
    if not pieces[0].strip(" $") or (alone and names.is_asked(alone[1].removesuffix("(t)").translate(_SET))):
        pieces = pieces[1:]
    elif alone or _holds(pieces[0], names):
        return ()
    whole = len(pieces) > 1 and all(piece.strip(" $") for piece in pieces)
    return tuple(pieces) if whole and not any(_NEXT_ANSWER.search(piece) for piece in pieces[:-1]) else ()


def _pieces(text: str, names: Names) -> list[str]:
    """What stands between the signs of equality, those that lead from one value to the next, and a value in brackets behind a formula."""
    pieces, start = [], 0
    for sign in _LEADS.finditer(text):
        if EQUALS.fullmatch(sign[0]) is None and _depth(text[start : sign.start()]):
            continue  # ; in a vector, → between the ends of an integral
        if sign[0][-1:] in WORDS and not any(char.isdigit() for char in text[sign.end() :]):
            continue  # −8 N, i.e. left
        pieces.append(" " * start + text[start : sign.start()])
        start = sign.end()
    last = " " * start + text[start:]
    behind = _IN_BRACKETS.fullmatch(last)
    if behind and any(char.isalpha() for char in behind["formula"]) and _is_value(behind["value"], names):
        return [*pieces, behind["formula"], " " * behind.start("value") + behind["value"]]
    return [*pieces, last]


def _is_value(text: str, names: Names) -> bool:
    """Whether a text is a number with a unit, which is not made of letters of the scene."""
    try:
        parts = cut(tokens_of(text.replace("≈", " ")))
    except FormulaError:
        return False
    if not parts.has_unit or not could_be_number(parts):
        return False
    return not are_letters(parts.unit[:-1], names.letters) or (is_kind(parts.unit) and likely_number(parts))


def _depth(text: str) -> int:
    """How many brackets are open."""
    return sum((char in "([{") - (char in ")]}") for char in text)


def _holds(piece: str, names: Names) -> bool:
    """Whether the name that is asked for stands in a piece as a word of its own."""
    return any(names.is_asked(match[0]) for match in re.finditer(r"[^\W\d_]\w*", piece))
