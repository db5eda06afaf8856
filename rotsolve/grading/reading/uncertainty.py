"""Uncertainty: what stands behind a number with ±, `4.36 ± 0.02 m/s²`, `4.36 m/s² ± 0.02 m/s²`, `4.36 m/s² ± 5 %`."""

from __future__ import annotations

import re
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.grading.reading.answers import read_line, si_formula
from rotsolve.grading.reading.records import AnswerError, Names

_SIGN = re.compile(
    r"\s*(?:±|\\pm(?![A-Za-z])|\+/[-−])\s*(?P<number>\d+(?:[.,]\d+)?(?:[eE][-+−]?\d+|\s*(?:[·×*x]|\\(?:cdot|times))\s*10(?:\^\{?[-−]?\d+\}?|[⁻⁰¹²³⁴-⁹]+))?)"
    r"(?P<percent>\s*\\?%)?"
)
_EXPONENT = re.compile(r"(?<=\d)[eE](?=[-+−]?\d)|x(?=\s*10)|\\(?:cdot|times|left|,)")
_END = re.compile(r"[,;)=]|$")
NO_LETTERS = Names(frozenset())


class Uncertainty(Struct, frozen=True):
    """By how much a number may be off as a student says: as typed, and the amount, in SI units where it has a unit of its own.

    `percent` says that it is that many hundredths of the number, `measured` that it has its unit.
    """

    text: str
    amount: Fraction
    percent: bool = False
    measured: bool = False


def cut_uncertainty(text: str) -> tuple[str, Uncertainty | None]:
    """A line with blanks for its uncertainty, and this; None where it tells none. A unit for both stays where it is."""
    match = _SIGN.search(text)
    before = "" if match is None else re.split(r"[=≈]", text[: match.start()])[-1]
    if match is None or not any(char.isdigit() for char in before):
        return text, None
    end, unit = match.end(), ""
    if match["percent"] is None and any(char.isalpha() or char in "°%" for char in _EXPONENT.sub("", before)):
        behind = _END.search(text, end)
        end = len(text) if behind is None else behind.start()
        unit = text[match.end() : end]
    try:
        reading = read_line(match["number"] + unit, NO_LETTERS)[0]
    except AnswerError:
        return text, None
    form = si_formula(reading)
    if form is None:
        return text, None
    amount, said = Fraction(evaluate(form, {}).float), f"± {text[match.start('number') : end].strip()}"
    line = text[: match.start()] + " " * (end - match.start()) + text[end:]
    return line, Uncertainty(said, amount, match["percent"] is not None, reading.unit is not None)
