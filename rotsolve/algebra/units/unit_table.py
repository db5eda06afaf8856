"""The table of units: each with its exact factor to SI, a rational times a power of π, and its dimension."""

from __future__ import annotations

import re
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.formula import PI, Formula, Number, divide, multiply
from rotsolve.algebra.units.dimension import (
    ANGLE,
    ANGULAR_VELOCITY,
    ENERGY,
    FORCE,
    FREQUENCY,
    LENGTH,
    MASS,
    NONE,
    POWER,
    PRESSURE,
    TIME,
    VELOCITY,
    VOLUME,
    Dimension,
)


def power_of_pi(value: Fraction, power: int) -> Formula:
    """value · π^power, the plainest formula for it."""
    if power < 0:
        return divide(Number(value), PI**-power)
    return multiply(Number(value), PI**power) if power else Number(value)


TURNS = ("rev", "turn", "rpm")
POUNDS = frozenset(("in", "ft", "yd", "mi", "lb", "oz", "slug", "lbf", "kip", "mph", "hp_mechanical"))
FOREIGN = POUNDS | {"dyn", "erg"}


class Unit(Struct, frozen=True):
    """A unit: its text (`kg m²/s`), and its factor to SI, scale · π^pi_power."""

    text: str
    scale: Fraction
    pi_power: int
    dimension: Dimension

    @property
    def factor(self) -> Formula:
        return power_of_pi(self.scale, self.pi_power)

    @property
    def latex(self) -> str:
        """The unit in LaTeX: \\mathrm{kg\\,m^{2}/s}."""
        text = "".join(f"^{{{_RAISED[char]}}}" if char in _RAISED else _LATEX.get(char, char) for char in self.text)
        text = re.sub(r"\^\(([^)]*)\)", r"^{\1}", text)
        return rf"\mathrm{{{text}}}" if text else ""

    @property
    def is_foreign(self) -> bool:
        """Whether a unit of feet and pounds, or of the cgs system, stands in it."""
        return not FOREIGN.isdisjoint(self.words)

    @property
    def words(self) -> list[str]:
        """The units of which it is made: kg, m and s of kg m²/s."""
        return re.findall(r"[A-Za-zµ_]+", self.text)

    @property
    def is_hertz(self) -> bool:
        """Whether it counts what happens in a unit of time: Hz, kHz."""
        return "Hz" in self.text

    @property
    def counts_turns(self) -> bool:
        """Whether a turn is what it counts: rev, rev/min, rpm."""
        return any(word in self.text for word in TURNS)

    @property
    def of_turns(self) -> Unit:
        """A unit of an angle or of angular velocity as one of turns or of frequency: 2π rad are one, 1 rev/s is 1 Hz."""
        return Unit(self.text, self.scale / 2, self.pi_power - 1, NONE if self.dimension == ANGLE else FREQUENCY)

    def after(self, number: str) -> str:
        """The number with its unit: `2 kg`, `30°`, `5`."""
        return f"{number}{'' if self.text.startswith('°') else ' '}{self.text}" if self.text else number


_RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789", strict=True))
_LATEX = {" ": r"\,", "°": r"^{\circ}", "%": r"\%", "µ": r"\mu ", "_": r"\_"}

ONE_UNIT = Unit("", Fraction(1), 0, NONE)

_ROWS: tuple[tuple[Dimension, dict[str, str]], ...] = (  # name -> factor to SI
    (NONE, {"%": "1/100"}),
    (LENGTH, {"m": "1", "km": "1000", "dm": "0.1", "cm": "0.01", "mm": "0.001", "µm": "1e-6", "nm": "1e-9"}),
    (LENGTH, {"in": "0.0254", "ft": "0.3048", "yd": "0.9144", "mi": "1609.344"}),
    (MASS, {"kg": "1", "g": "0.001", "mg": "1e-6", "t": "1000"}),
    (MASS, {"lb": "0.45359237", "oz": "0.028349523125"}),
    (MASS, {"slug": "44482216152605/3048000000000"}),  # 1 lbf s²/ft
    (TIME, {"s": "1", "ms": "0.001", "µs": "1e-6", "ns": "1e-9", "min": "60", "h": "3600", "day": "86400"}),
    (TIME, {"d": "86400", "week": "604800", "year": "31557600"}),  # the Julian year, 365.25 days
    (ANGLE, {"rad": "1", "mrad": "0.001"}),
    (VOLUME, {"L": "0.001", "mL": "1e-6"}),
    (VELOCITY, {"mph": "0.44704", "knot": "463/900"}),
    (FORCE, {"N": "1", "mN": "0.001", "µN": "1e-6", "kN": "1000", "MN": "1e6", "dyn": "1e-5"}),
    (FORCE, {"lbf": "4.4482216152605", "kip": "4448.2216152605", "kgf": "9.80665"}),
    (ENERGY, {"J": "1", "mJ": "0.001", "kJ": "1000", "MJ": "1e6", "GJ": "1e9", "erg": "1e-7"}),
    (ENERGY, {"cal": "4.184", "kcal": "4184", "Wh": "3600", "kWh": "3600000", "eV": "1.602176634e-19"}),
    (POWER, {"W": "1", "mW": "0.001", "kW": "1000", "MW": "1e6", "GW": "1e9"}),
    (POWER, {"hp_textbook": "746", "hp_mechanical": "745.69987158227022", "hp_metric": "735.5"}),
    (FREQUENCY, {"Hz": "1", "kHz": "1000", "MHz": "1e6"}),
    (PRESSURE, {"Pa": "1", "kPa": "1000", "MPa": "1e6", "bar": "1e5"}),
)

_WITH_PI: tuple[tuple[Dimension, dict[str, str]], ...] = (  # name -> factor to SI without its π
    (ANGLE, {"deg": "1/180", "rev": "2", "turn": "2", "grad": "1/200", "arcmin": "1/10800", "arcsec": "1/648000"}),
    (ANGULAR_VELOCITY, {"rpm": "1/30"}),
)

UNITS: dict[str, Unit] = {
    name: Unit("°" if name == "deg" else name, Fraction(scale), power, dimension)
    for power, rows in ((0, _ROWS), (1, _WITH_PI))
    for dimension, names in rows
    for name, scale in names.items()
}
# the Greek letter beside the micro sign
UNITS |= {"°": UNITS["deg"], "μm": UNITS["µm"], "μs": UNITS["µs"], "μN": UNITS["µN"]}

AMBIGUOUS = {  # what is refused, and what to write
    "hp": "write hp_textbook (746 W), hp_mechanical (745.69987158227022 W) or hp_metric (735.5 W)",
    "HP": "write hp_textbook (746 W), hp_mechanical (745.69987158227022 W) or hp_metric (735.5 W)",
    "PS": "write hp_metric (735.5 W)",
}

MEANT = {  # words that people write, for the suggestion
    "kilogram": "kg", "kilograms": "kg", "kgs": "kg", "gram": "g", "grams": "g", "gm": "g", "tonne": "t", "ton": "t",
    "meter": "m", "meters": "m", "metre": "m", "metres": "m", "feet": "ft", "foot": "ft", "inch": "in", "inches": "in",
    "mile": "mi", "miles": "mi", "yard": "yd", "yards": "yd",
    "dyne": "dyn", "dynes": "dyn", "slugs": "slug", "kips": "kip", "knots": "knot", "kp": "kgf",
    "um": "µm", "us": "µs", "uN": "µN", "sec": "s", "secs": "s", "second": "s", "seconds": "s", "minute": "min", "minutes": "min",
    "hr": "h", "hrs": "h", "hour": "h", "hours": "h", "days": "day", "yr": "year", "years": "year",
    "newton": "N", "newtons": "N", "joule": "J", "joules": "J", "watt": "W", "watts": "W", "hertz": "Hz",
    "degree": "deg", "degrees": "deg", "radian": "rad", "radians": "rad", "rads": "rad", "turns": "turn",
    "revs": "rev", "revolution": "rev", "revolutions": "rev", "gon": "grad", "lbs": "lb", "pound": "lb",
    "Nm": "N m", "kmh": "km/h", "kph": "km/h", "rps": "rev/s",
}  # fmt: skip
