"""Units: whether the typed unit measures what is asked, and what is said where it does not, or is missing.

A frequency in Hz counts turns; an angular velocity in rad/s counts radians. Neither stands for the other, though both are 1/s.
"""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.units.dimension import (
    ANGLE,
    ANGULAR_ACCELERATION,
    ANGULAR_VELOCITY,
    FREQUENCY,
    NONE,
    Dimension,
    describe,
    kind_of,
)
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.algebra.units.unit_table import ONE_UNIT, Unit
from rotsolve.grading.verdict import Remark

TURNS = ("rev", "turn", "rpm")  # units that count turns
ALIKE = {  # units that are taken for one another
    ANGLE: ("rad", "°", "rev"),
    ANGULAR_VELOCITY: ("rad/s", "rev/s", "rpm", "°/s"),
    ANGULAR_ACCELERATION: ("rad/s²", "rev/s²", "°/s²"),
}


class Measured(Struct, frozen=True):
    """The unit in which a typed number is meant; or the remark on a unit that does not measure what is asked."""

    unit: Unit | None = None
    fault: Remark | None = None


def measured(typed: Unit, wanted: Unit, dimension: Dimension, turns: bool = False) -> Measured:
    """How a number in the typed unit is to be taken; `turns` says that a pure number counts turns."""
    if not typed.dimension.matches(dimension):
        return Measured(fault=Remark("dimension", (other_dimension(typed, dimension),)))
    if dimension.matches(FREQUENCY):
        return of_rate(typed, wanted, dimension)
    if hertz(typed) and dimension.angle and not dimension.matches(FREQUENCY):
        return Measured(fault=Remark("unit", (f"{typed.text} counts turns, {wanted.text} radians",)))
    if turns and typed.dimension == ANGLE:
        if counts_turns(typed):
            return Measured(ONE_UNIT)
        return Measured(fault=Remark("unit", (f"a number of turns is asked for, not an angle in {typed.text}",)))
    return Measured(typed)


def other_dimension(typed: Unit, dimension: Dimension) -> str:
    """What is said of a unit that measures something else."""
    kind, asked = kind_of(typed.dimension, "frequency" if hertz(typed) else None), describe(dimension, article=True)
    here = f"is the unit of {kind.words}" if kind is not None else "is the unit of something else"
    return f"{typed.text} {here}, but {asked} is asked for"


def of_rate(typed: Unit, wanted: Unit, dimension: Dimension) -> Measured:
    """Hz beside rad/s: revolutions in a second are a frequency too, radians are not, and Hz is no angular velocity."""
    if dimension.angle and hertz(typed):
        said = f"{typed.text} counts turns: it measures a frequency, and ω = 2π f is in rad/s"
        return Measured(fault=Remark("unit", (said,)))
    if hertz(wanted) and typed.dimension.angle:
        if counts_turns(typed):
            return Measured(Unit(typed.text, typed.scale / 2, typed.pi_power - 1, FREQUENCY))
        said = f"{typed.text} measures an angular frequency: f = ω/(2π) is in Hz"
        return Measured(fault=Remark("unit", (said,)))
    return Measured(typed)


def hertz(unit: Unit) -> bool:
    return "Hz" in unit.text


def counts_turns(unit: Unit) -> bool:
    return any(word in unit.text for word in TURNS)


def without_unit(wanted: Unit, si: Unit, dimension: Dimension) -> tuple[Unit, ...]:
    """The units that a number without one may be meant in, the likeliest first."""
    return (si, wanted) if dimension.matches(NONE) else (wanted, si)


def may_lack(unit: Unit, dimension: Dimension) -> bool:
    """Whether a unit may be left out: radians may, where there is no other."""
    return dimension.matches(NONE) and unit.scale == 1 and not unit.pi_power


def likely_meant(typed: Unit | None, wanted: Unit, si: Unit, dimension: Dimension) -> tuple[Unit, ...]:
    """Units in which a number may have been worked out, though another was written."""
    alike = next((names for kind, names in ALIKE.items() if kind.matches(dimension)), ())
    units = dict.fromkeys((wanted, si, *map(parse_unit, alike)))
    return tuple(unit for unit in units if typed is None or unit.factor != typed.factor)
