"""Asked: whether something is of a kind that few scenes have. A kind that nobody has loaded is nobody's; it is not loaded to ask.

The assembly asks this of every connection: to load all kinds for it took a thirtieth of a cold run (callgrind, `rod-30`).
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any, TypeGuard

if TYPE_CHECKING:
    from rotsolve.elements.actions import Band
    from rotsolve.elements.collisions import Collides
    from rotsolve.elements.connections.drapes import Drapes
    from rotsolve.elements.connections.drives import Belt, Gear
    from rotsolve.elements.connections.springs import Spring, Torsion
    from rotsolve.elements.connections.touch import Touch


def loaded_kind(module: str, name: str) -> tuple[type[Any], ...]:
    """The class of a module of elements, if that is loaded."""
    loaded = sys.modules.get(f"rotsolve.elements.{module}")
    return () if loaded is None else (getattr(loaded, name),)


def is_touch(item: object) -> TypeGuard[Touch]:
    return isinstance(item, loaded_kind("connections.touch", "Touch"))


def is_drapes(item: object) -> TypeGuard[Drapes]:
    return isinstance(item, loaded_kind("connections.drapes", "Drapes"))


def is_spring(item: object) -> TypeGuard[Spring]:
    return isinstance(item, loaded_kind("connections.springs", "Spring"))


def is_torsion(item: object) -> TypeGuard[Torsion]:
    return isinstance(item, loaded_kind("connections.springs", "Torsion"))


def is_belt(item: object) -> TypeGuard[Belt]:
    return isinstance(item, loaded_kind("connections.drives", "Belt"))


def is_gear(item: object) -> TypeGuard[Gear]:
    return isinstance(item, loaded_kind("connections.drives", "Gear"))


def is_band(item: object) -> TypeGuard[Band]:
    return isinstance(item, loaded_kind("actions", "Band"))


def is_collides(item: object) -> TypeGuard[Collides]:
    return isinstance(item, loaded_kind("collisions", "Collides"))
