"""Foreign: what other programs, lands and YAML itself take for a value, and a scene does not: `1_000`, `0x10`, `.inf`, `1.000,5`, dates.

Each is told what it is, and how a scene says the same.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Container

from rotsolve.algebra.units.quantities import MAX_LENGTH, UnitError, parse_quantity, parse_unit
from rotsolve.language.words import quoted

Told = tuple[str, str]  # what is wrong, and the cure
BLANK = "\u0020\u00a0\u2009\u202f"  # those that stand within large numbers
SIGN = r"[-+−]?"
WORDS = {
    **dict.fromkeys(("inf", "infinity", "nan", "oo", "∞"), "no number: a value is finite"),
    **dict.fromkeys(("null", "none", "nil", "~", "-", "?"), "no value"),
    **dict.fromkeys(("yes", "no", "true", "false", "on", "off"), "no quantity"),
}
LEFT_OPEN = "write a number and a unit, `2 kg`; a unit alone, `kg`, keeps a letter; `unknown` is what is sought"


def foreign_value(text: str, names: Container[str]) -> Told | None:
    """What a text is that is a value elsewhere; None of others. `names` are letters of the scene."""
    text = text.strip()
    word = text.split()[0].lstrip("-+−.").lower() if text.split() and text.strip("-+") else text
    if word in WORDS and word not in names:
        return f"{quoted(text)} is {WORDS[word]}", LEFT_OPEN
    if len(text) > MAX_LENGTH:  # the patterns would try each of its places with each other
        return None
    for pattern, told in FORMS.items():
        match = re.fullmatch(pattern, text, re.DOTALL)
        found = told(match, names) if match is not None else None
        if found is not None:
            return found
    return None


def written_as(message: str, *values: str) -> Told | None:
    """The message with what to write, of which the first at least can be read."""
    try:
        parse_quantity(values[0])
    except UnitError:
        return None
    return message, "write " + ", or ".join(f"`{value}`" for value in values)


def digits_in_groups(match: re.Match[str], names: Container[str]) -> Told | None:
    """`1_000`, `1 000`, `1'000`: a number whose digits stand in groups."""
    number = re.sub(rf"[_'’{BLANK}]", "", match["number"])
    return written_as(f"{quoted(match['number'])} is no number: its digits stand in groups", f"{number}{match['rest']}")


def with_commas(match: re.Match[str], names: Container[str]) -> Told | None:
    """`1.000,5`, `1,000.5`, and `1,000`, which may be either."""
    number, rest = match["number"], match["rest"]
    message = f"{quoted(number)} has a comma: a decimal number takes a point, and nothing between its thousands"
    points, commas = number.count("."), number.count(",")
    if commas and points:
        decimal = max(".", ",", key=number.rfind)
        other = "," if decimal == "." else "."
        return written_as(message, f"{number.replace(other, '').replace(decimal, '.')}{rest}")
    whole = number.replace(",", "")
    return written_as(message, f"{whole}{rest}", *([f"{number.replace(',', '.')}{rest}"] if commas == 1 else []))


def in_other_base(match: re.Match[str], names: Container[str]) -> Told | None:
    return written_as(f"{quoted(match['number'])} is no decimal number", f"{int(match['number'], 0)}{match['rest']}")


def number_behind(match: re.Match[str], names: Container[str]) -> Told | None:
    """`kg 2`."""
    try:
        parse_unit(match["unit"])
    except UnitError:
        return None
    named = match["unit"] in names
    return None if named else written_as("the number stands behind its unit", f"{match['number']} {match['unit']}")


def powers_plain(match: re.Match[str], names: Container[str]) -> Told | None:
    """`9.8 m/s2`: a power without its sign, where no letter has that name."""
    unit = match["unit"]
    if any(word in names for word in re.findall(r"[A-Za-z]+\d", unit)):
        return None
    raised = re.sub(r"(?<=[A-Za-z])(?=-?\d)", "^", unit)
    return (
        written_as("a power of a unit is written with `^`", f"{match['number']} {raised}") if raised != unit else None
    )


def letter_for_nought(match: re.Match[str], names: Container[str]) -> Told | None:
    number = match["number"].replace("O", "0").replace("o", "0")
    return written_as(f"{quoted(match['number'])} has the letter O in it", f"{number}{match['rest']}")


def numbers_beside(match: re.Match[str], names: Container[str]) -> Told | None:
    return f"two numbers side by side: {quoted(match['number'])}", "write one number, or `*` between them"


FORMS: dict[str, Callable[[re.Match[str], Container[str]], Told | None]] = {
    rf"(?P<number>{SIGN}\d+(?:_\d+)+(?:\.\d+)?)(?P<rest>.*)": digits_in_groups,
    rf"(?P<number>{SIGN}\d{{1,3}}(?:[{BLANK}'’]\d{{3}})+(?:\.\d+)?)(?P<rest>(?![\d.]).*)": digits_in_groups,
    rf"(?P<number>{SIGN}\d{{1,3}}(?:\.\d{{3}})+,\d+|{SIGN}\d{{1,3}}(?:,\d{{3}})+(?:\.\d+)?)(?P<rest>(?![\d.,]).*)": with_commas,
    r"(?P<number>0[xob][0-9A-Fa-f]+)(?P<rest>.*)": in_other_base,
    r"(?P<date>\d{4}-\d\d-\d\d.*)": lambda match, names: (
        f"{quoted(match['date'])} is a date, not a number",
        LEFT_OPEN,
    ),
    r"(?P<clock>\d+:\d\d(?::\d\d)?)": lambda match, names: (
        f"{quoted(match['clock'])} is a time of a clock, not a number",
        "write it in one unit, `90 s` or `1.5 min`",
    ),
    rf"(?P<number>{SIGN}\d*)\.\.+(?P<rest>\d.*)": lambda match, names: written_as(
        "two points in a number", f"{match['number']}.{match['rest']}"
    ),
    rf"(?P<number>{SIGN}[\d.]*[oO][\dOo.]*|{SIGN}\d[\d.]*[oO])(?P<rest>\s+.*|)": letter_for_nought,
    rf"(?P<number>{SIGN}\d+\.?\d*\s+\d+\.?\d*)(?P<rest>(?![\d/]).*)": numbers_beside,
    r"(?P<unit>[^\W\d_][^\d]*?(?:\^\d)?)\s*(?P<number>[-+]?\d+(?:\.\d+)?)": number_behind,
    rf"(?P<number>{SIGN}[\d.]+)\s*(?P<unit>[^\W\d_].*)": powers_plain,
    r"=\s*(?P<value>\S.*)": lambda match, names: written_as("a `=` in front of a value", match["value"]),
    r"(?P<value>[^±]*\d[^±]*?)\s*(?:±|\+/?-)\s*(?P<off>[\d.]+)\s*(?P<unit>.*)": lambda match, names: written_as(
        "a value has no uncertainty in a scene",
        match["value"] if re.search(r"[^\W\d]", match["value"]) else f"{match['value']} {match['unit']}",
    ),
}
