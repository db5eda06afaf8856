"""Figures: whether the printed figures of a number are the right ones."""

from __future__ import annotations

from mpmath import floor, log10, mpf, nstr

from trials.draw import exactly
from trials.outcome import Printed

VANISHING = mpf(10) ** -60  # what an independent route leaves of an exact zero, also under a root


def wrong(printed: Printed, true: mpf, digits: int) -> str:
    """What is wrong with a printed number; '' where every figure is the rounded one, or none is printed as sure."""
    number = printed.number
    if number is None:
        return "" if printed.note else "no number is printed"
    if number == 0 or true == 0:
        return "" if number == 0 and abs(true) < VANISHING else f"{printed.text} is printed for {shown(true)}"
    figures = fewer(printed, digits)
    place = mpf(10) ** (int(floor(log10(abs(true)))) - figures + 1)
    gap = abs(exactly(number) - true)
    if gap > place / 2 * (1 + mpf(10) ** -40):
        return f"{printed.text} is printed for {shown(true)}"
    if short(printed.text, figures) and gap > abs(true) * mpf(10) ** -50:
        return f"{printed.text} is printed as if exact for {shown(true)}"
    return ""


def fewer(printed: Printed, digits: int) -> int:
    """How many figures are claimed: those that a note leaves."""
    words = printed.note.split()
    return int(words[1]) if words[:1] == ["only"] else digits


def short(text: str, digits: int) -> bool:
    """Whether fewer significant figures are printed than asked for, which claims that the number ends there."""
    mantissa = text.lstrip("-").split("e")[0]
    return len(mantissa.replace(".", "").lstrip("0")) < digits


def shown(true: mpf) -> str:
    return str(nstr(true, 25))
