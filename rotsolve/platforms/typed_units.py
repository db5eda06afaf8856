"""Typed units: under which names a platform knows the unit of an answer, and what each is worth: 1 m is 100 cm.

A platform compares the letters that are typed, without blanks. Each unit has the spellings that students use: m/s², m/s^2; N·m, N*m, Nm.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from rotsolve.algebra.notation.letters import SUPERSCRIPTS, from_superscript
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.algebra.units.unit_table import UNITS, Unit
from rotsolve.grading.comparing.numbers import certified_number, measured_unit

RAISED = re.compile(f"[{''.join(SUPERSCRIPTS.values())}]+")
WORD = re.compile(r"[A-Za-zµ_]+|°")
MOST_UNITS = 12
SELDOM = frozenset(
    ("year", "week", "day", "d", "h", "ns", "nm", "MHz", "GW", "GJ", "eV", "mrad", "grad", "arcmin", "arcsec")
)
JOINTS = ("·", "*", "")  # between two units; the first is that of the answer that a platform shows


def typed_units(unit: Unit, dimension: Dimension, *, turns: bool = False) -> tuple[tuple[str, float], ...]:
    """The names of units that measure the same, and how many of each the unit of the answer is; that comes first, with 1."""
    if not unit.text:
        return ()
    found: dict[str, tuple[str, float]] = {}  # a database that does not tell mN from MN takes one of them
    for other in units_of_same_kind(unit):
        meant = measured_unit(other, unit, dimension, turns)
        many = certified_number(unit.factor / meant.factor, {}) if isinstance(meant, Unit) else None
        if many is not None:
            for spelling in spellings_of_unit(other.text):
                found.setdefault(spelling.casefold(), (spelling, float(f"{many.float:.12g}")))
    return tuple(found.values())


def units_of_same_kind(unit: Unit) -> Iterator[Unit]:
    """The unit, those of the table that measure the same, and those with another one in place of one of its words."""
    texts = dict.fromkeys((unit.text, *texts_of_units(unit.text, unit.is_foreign)))
    found = 0
    for text in texts:
        other = parse_unit(text)
        if other.dimension == unit.dimension and found < MOST_UNITS:
            found += 1
            yield other


def texts_of_units(text: str, foreign: bool) -> Iterator[str]:
    """The texts of other units."""
    whole = parse_unit(text)
    for name, unit in UNITS.items():
        if unit.dimension == whole.dimension and usual(name, foreign):
            yield name
    for match in WORD.finditer(text):
        one = UNITS.get(match[0])
        for name, unit in UNITS.items() if one is not None else ():
            if one is not None and unit.dimension == one.dimension and usual(name, foreign):
                yield f"{text[: match.start()]}{name}{text[match.end() :]}"


def usual(name: str, foreign: bool) -> bool:
    """Whether students may write a unit."""
    return name not in SELDOM and "μ" not in name and (foreign or not UNITS[name].is_foreign)


def spellings_of_unit(text: str) -> Iterator[str]:
    """The ways in which a unit is typed, without blanks."""
    joints = JOINTS if " " in text else JOINTS[:1]
    for joint in joints:
        joined = text.replace(" ", joint)
        yield joined
        yield RAISED.sub(lambda raised: f"^{from_superscript(raised[0])}", joined)
