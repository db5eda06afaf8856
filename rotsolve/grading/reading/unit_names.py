"""Unit names: units as students write them: in full, in the plural, in English and German, with every SI prefix, and in short forms.

`centimetres`, `Zentimeter` and `cm` are one unit, which is said back as `cm`. A scene file takes the symbols of the table of units alone.
"""

from __future__ import annotations

import re
from fractions import Fraction
from functools import lru_cache

from rotsolve.algebra.units.dimension import LENGTH
from rotsolve.algebra.units.unit_table import MEANT, UNITS, Unit

_PREFIXES = """
    quetta Q 30 ronna R 27 yotta Y 24 zetta Z 21 exa E 18 peta P 15 tera T 12 giga G 9 mega M 6 kilo k 3 hecto h 2 deca da 1 deci d -1
    centi c -2 milli m -3 micro µ -6 nano n -9 pico p -12 femto f -15 atto a -18 zepto z -21 yocto y -24 ronto r -27 quecto q -30
"""
_PARTS = _PREFIXES.split()
POWERS = {symbol: int(power) for symbol, power in zip(_PARTS[1::3], _PARTS[2::3], strict=True)}  # of ten
SYMBOLS = dict(zip(_PARTS[::3], _PARTS[1::3], strict=True))  # of prefixes by their names
SYMBOLS |= {"deka": "da", "hekto": "h", "dezi": "d", "zenti": "c", "mikro": "µ", "piko": "p"}
PREFIXED = frozenset(
    ("m", "g", "s", "N", "J", "W", "Pa", "Hz", "rad", "L", "eV", "Wh", "cal", "bar")
)  # what takes a prefix
LARGE = {"t": ("k", "M")}  # a kilotonne, but no millitonne
FULL = {  # the names of units in the singular, in small letters
    "meter": "m", "metre": "m", "gram": "g", "gramm": "g", "gramme": "g", "second": "s", "sekunde": "s", "newton": "N", "joule": "J",
    "watt": "W", "pascal": "Pa", "hertz": "Hz", "radian": "rad", "radiant": "rad", "liter": "L", "litre": "L", "electronvolt": "eV",
    "elektronenvolt": "eV", "watthour": "Wh", "wattstunde": "Wh", "calorie": "cal", "kalorie": "cal", "bar": "bar", "tonne": "t",
    "ton": "t", "minute": "min", "hour": "h", "stunde": "h", "day": "day", "tag": "day", "woche": "week", "jahr": "year",
    "degree": "deg", "revolution": "rev", "umdrehung": "rev", "turn": "turn", "inch": "in", "foot": "ft", "feet": "ft", "yard": "yd",
    "mile": "mi", "meile": "mi", "pound": "lb", "pfund": "lb", "ounce": "oz", "knot": "knot", "knoten": "knot", "dyne": "dyn",
    "bogenminute": "arcmin", "arcminute": "arcmin", "bogensekunde": "arcsec", "arcsecond": "arcsec", "gon": "grad",
}  # fmt: skip
SHORT = {  # short forms, and what is made of several units; `Grad` is German for a degree, `grad` the gon
    "l": "L", "mps": "m/s", "kmh": "km/h", "kmph": "km/h", "kph": "km/h", "fps": "ft/s", "cc": "cm^3", "ccm": "cm^3", "cbm": "m^3",
    "qm": "m^2", "sek": "s", "std": "h", "mins": "min", "Grad": "deg", "grade": "deg", "U": "rev", "upm": "rpm", "pfd": "lb",
    "newtonmeter": "N m", "newtonmetre": "N m", "newtonmeters": "N m", "newtonmetres": "N m", "newtonsekunden": "N s",
    "wattsekunden": "W s", "joulesekunden": "J s",
}  # fmt: skip
ENDINGS = ("", "s", "es", "n", "en")  # of a plural
ANGSTROM = Unit("Å", Fraction(1, 10**10), 0, LENGTH)
_ANGSTROM = re.compile(r"[ÅÅ]|[åa]ngstr[öo]ms?", re.IGNORECASE)
MADE_OF = re.compile(r"[A-Za-zµÅ]+|[/^]|\d")
REMEMBERED = 4096  # words: students write the same few over and over


@lru_cache(REMEMBERED)
def unit_called(word: str) -> Unit | None:
    """The one unit that a word names; None where it names none, or several."""
    if word in UNITS:
        return UNITS[word]
    if _ANGSTROM.fullmatch(word):
        return ANGSTROM
    named = _in_full(word.lower()) if len(word) > 1 else None
    return named or _by_symbols(word)


@lru_cache(REMEMBERED)
def units_called(word: str) -> tuple[str, ...]:
    """The units that a short form stands for, with the marks between them: `mps` is m / s; nothing where it is none."""
    meant = SHORT.get(word) or MEANT.get(word)
    if meant is None and unit_called(word) is None:  # Kmh is km/h, but Qm is 10³⁰ m
        meant = SHORT.get(word.lower()) or MEANT.get(word.lower())
    return tuple(MADE_OF.findall(meant)) if meant is not None else ()


def _in_full(name: str) -> Unit | None:
    """The unit of a name in small letters: kilometres is km, Sekunden is s."""
    for prefix in ("", *(prefix for prefix in SYMBOLS if name.startswith(prefix))):
        rest = name.removeprefix(prefix)
        for ending in ENDINGS:
            symbol = FULL.get(rest.removesuffix(ending)) if rest.endswith(ending) else None
            if symbol is not None:
                return UNITS[symbol] if not prefix else _with_prefix(SYMBOLS[prefix], symbol)
    return None


def _by_symbols(word: str) -> Unit | None:
    """The unit of a prefix and a symbol: Mg, cm, µg; the Greek letter stands for the sign of micro."""
    plain = re.sub(r"^[μu](?=[A-Za-z])", "µ", word)
    for length in (1, 2):
        prefix, symbol = plain[:length], "L" if plain[length:] == "l" else plain[length:]
        found = _with_prefix(prefix, symbol) if prefix in POWERS else None
        if found is not None:
            return found
    return None


def _with_prefix(prefix: str, symbol: str) -> Unit | None:
    """So many times a unit; None where it takes no prefix."""
    if symbol not in PREFIXED and prefix not in LARGE.get(symbol, ()):
        return None
    whole = UNITS.get(prefix + symbol)
    one = UNITS[symbol]
    return whole or Unit(prefix + symbol, one.scale * Fraction(10) ** POWERS[prefix], 0, one.dimension)
