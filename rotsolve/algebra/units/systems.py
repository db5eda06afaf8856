"""Systems of units beside SI: which one all units of a scene are of, and the unit that it has for a dimension.

In the gravitational foot-pound-second system force is basic, 1 slug = 1 lbf s²/ft: what moves is told in lbf, ft and s, what only has mass
in slugs, or in pounds where the scene tells masses so. In the cgs system 1 dyn = 1 g cm/s² and 1 erg = 1 dyn cm.
"""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.units.dimension import ENERGY, FORCE, POWER, Dimension, product_of_units
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.algebra.units.unit_table import POUNDS, Unit

ANGLES, TIMES = ("rad", "mrad", "deg", "rev", "turn", "grad", "arcmin", "arcsec"), ("s", "ms", "min", "h", "day", "d")
NEUTRAL = frozenset((*ANGLES, *TIMES, "rpm", "Hz", "kHz"))  # units that all systems have
Named = tuple[Dimension, str, str]  # a dimension, of a kind or of '', and its unit


class UnitSystem(Struct, frozen=True):
    """The units of a system, of which one of `marks` tells that it is meant, those in which it answers, and which have names of their own;
    `by_force` where force is basic, not mass."""

    members: frozenset[str]
    marks: frozenset[str]
    length: str
    mass: str
    force: str
    named: tuple[Named, ...]
    by_force: bool


FPS = UnitSystem(
    POUNDS,
    POUNDS,
    "ft",
    "slug",
    "lbf",
    ((ENERGY, "torque", "lbf ft"), (ENERGY, "", "ft lbf"), (POWER, "", "ft lbf/s")),
    True,
)
CGS = UnitSystem(
    frozenset(("cm", "mm", "g", "mg", "dyn", "erg")),
    frozenset(("dyn", "erg")),
    "cm",
    "g",
    "dyn",
    ((FORCE, "", "dyn"), (ENERGY, "torque", "dyn cm"), (ENERGY, "", "erg"), (POWER, "", "erg/s")),
    False,
)


def system_of(units: Iterable[Unit | None]) -> UnitSystem | None:
    """The system of which all units are that tell a length or a mass; None of SI, and where they are mixed."""
    words = {word for unit in units if unit is not None for word in unit.words} - NEUTRAL
    found = next((system for system in (FPS, CGS) if words & system.marks and words <= system.members), None)
    return replace(found, mass="lb") if found is FPS and "lb" in words and "slug" not in words else found


def coherent(system: UnitSystem) -> UnitSystem:
    """The same with the mass that goes with its force: slugs for pounds."""
    return replace(system, mass="slug") if system.by_force else system


def unit_in(system: UnitSystem, dimension: Dimension, kind: str = "") -> Unit | None:
    """The unit of a system for a dimension, of a kind such as a torque; None of what it has as SI does, an angle or a time."""
    if not dimension.mass and not dimension.length:
        return None
    named = next((text for own, of, text in system.named if own.matches(dimension) and of in (kind, "")), None)
    if named is not None:
        return parse_unit(named)
    mass, length, time = dimension.mass, dimension.length, dimension.time
    basic = [(system.mass, mass), (system.length, length)]
    if system.by_force and mass and time:  # M = F T²/L
        basic, time = [(system.force, mass), (system.length, length - mass)], time + 2 * mass
    return parse_unit(product_of_units((*basic, ("rad", max(dimension.angle, 0)), ("s", time))))
