"""Definitions: letters that a student brings in, `let h = L sin θ`, `…, with I = ½ M R²`; they are known from there on."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.letters import spellings
from rotsolve.grading.reading.answers import read_line, si_formula
from rotsolve.grading.reading.records import FORMULA, NUMBER, AnswerError, Names
from rotsolve.grading.reading.vocabulary import run_meaning

_NAME = r"(?P<name>[^\W\d_](?:[0-9₀-₉]|_\w+)*)"  # one letter, perhaps with an index: `mgh = …` is a product
_TELLS = re.compile(
    rf"\s*(?:(?:let|put|set|with|where|call|define|take)\b\s*)?{_NAME}\s*:?=(?P<value>[^=]+)", re.IGNORECASE
)
_CLAUSE = re.compile(
    rf"(?:[,;(]|\b(?:with|where|let|for|using)\b)\s*{_NAME}\s*:?=(?P<value>[^=,;]+?)\)?\s*$", re.IGNORECASE
)
_BEFORE = re.compile(rf"^\s*(?:let|with|where)\s+{_NAME}\s*:?=(?P<value>[^=,;]+)[,;]", re.IGNORECASE)

Definitions = Mapping[str, Formula]


def definition(text: str, names: Names) -> tuple[str, Formula] | None:
    """The letter that a line of working brings in, and what it stands for; None where it brings in none."""
    match = _TELLS.match(text)
    return None if match is None else _told(match["name"], match["value"], names)


def clause(text: str, names: Names) -> tuple[str, str, Formula] | None:
    """An answer without the clause behind it, or in front, that brings in a letter, that letter, and what it stands for; else None."""
    for pattern in (_CLAUSE, _BEFORE):
        match = pattern.search(text)
        told = None if match is None else _told(match["name"], match["value"], names)
        if match is not None and told is not None:
            return text[: match.start()] + text[match.end() :], *told
    return None


def _told(name: str, value: str, names: Names) -> tuple[str, Formula] | None:
    """A letter that is none of the scene's, with its formula in letters that are known."""
    if (
        not names.letters.isdisjoint(spellings(name))
        or names.is_asked(name)
        or run_meaning(name, names.letters) is not None
    ):
        return None
    try:
        readings = read_line(value, Names(names.givens, names.answers))
    except AnswerError:
        return None
    formulas = (si_formula(one) for one in readings if one.kind in (FORMULA, NUMBER))
    formula = next((one for one in formulas if one is not None), None)
    return None if formula is None else (spellings(name)[0], formula)
