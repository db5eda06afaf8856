"""Asked: whether something is of a kind that few scenes have. A kind that nobody has loaded is nobody's; it is not loaded to ask.

The assembly asks this of every connection: to load all kinds for it took a thirtieth of a cold run (callgrind, `rod-30`).
"""

from __future__ import annotations

import sys
from functools import cache
from typing import TYPE_CHECKING, Any, TypeGuard

if TYPE_CHECKING:
    from rotsolve.elements.actions import Band
    from rotsolve.elements.collisions import Collides
    from rotsolve.elements.connections.drapes import Drapes
    from rotsolve.elements.connections.drives import Belt, Gear
    from rotsolve.elements.connections.springs import Spring, Torsion
    from rotsolve.elements.connections.strings import String
    from rotsolve.elements.connections.touch import Touch
    from rotsolve.elements.surfaces import Curved, Level, Slope, Wall


def loaded_kind(module: str, name: str) -> tuple[type[Any], ...]:
    """The class of a module of elements, if that is loaded."""
    loaded = sys.modules.get(f"rotsolve.elements.{module}")
    return () if loaded is None else (getattr(loaded, name),)


@cache
def home_of_kind(kind: type[Any]) -> str:
    """Where a kind of element is, as `elements/tables` says it: `connections.springs.Spring`."""
    return f"{kind.__module__.removeprefix('rotsolve.elements.')}.{kind.__name__}"


@cache
def derives_from(kind: Any, module: str, name: str) -> bool:
    """Whether a class is of a kind, remembered: a class has its bases as long as it is there."""
    return issubclass(kind, loaded_kind(module, name))


def is_touch(item: Any) -> TypeGuard[Touch]:
    return derives_from(item.__class__, "connections.touch", "Touch")


def is_string(item: Any) -> TypeGuard[String]:
    return derives_from(item.__class__, "connections.strings", "String")


def is_drapes(item: Any) -> TypeGuard[Drapes]:
    return derives_from(item.__class__, "connections.drapes", "Drapes")


def is_spring(item: Any) -> TypeGuard[Spring]:
    return derives_from(item.__class__, "connections.springs", "Spring")


def is_torsion(item: Any) -> TypeGuard[Torsion]:
    return derives_from(item.__class__, "connections.springs", "Torsion")


def is_belt(item: Any) -> TypeGuard[Belt]:
    return derives_from(item.__class__, "connections.drives", "Belt")


def is_gear(item: Any) -> TypeGuard[Gear]:
    return derives_from(item.__class__, "connections.drives", "Gear")


def is_band(item: Any) -> TypeGuard[Band]:
    return derives_from(item.__class__, "actions", "Band")


def is_collides(item: Any) -> TypeGuard[Collides]:
    return derives_from(item.__class__, "collisions", "Collides")


def is_curved(item: Any) -> TypeGuard[Curved]:
    return derives_from(item.__class__, "surfaces", "Curved")


def is_level_surface(item: Any) -> TypeGuard[Level]:
    return derives_from(item.__class__, "surfaces", "Level")


def is_slope(item: Any) -> TypeGuard[Slope]:
    return derives_from(item.__class__, "surfaces", "Slope")


def is_wall(item: Any) -> TypeGuard[Wall]:
    return derives_from(item.__class__, "surfaces", "Wall")
