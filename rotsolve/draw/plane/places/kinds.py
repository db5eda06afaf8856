"""Kinds: the connections of a scene by what pictures do with them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, TypeVar

from msgspec import Struct, field

from rotsolve.algebra.formula import Formula
from rotsolve.elements.connections.drapes import Drapes
from rotsolve.elements.connections.drives import Belt, Gear
from rotsolve.elements.connections.slots import PinSlot
from rotsolve.elements.connections.springs import Spring
from rotsolve.elements.connections.strings import String
from rotsolve.elements.connections.touch import Touch
from rotsolve.language.bodies import Surface
from rotsolve.language.elements import Connection

Row = TypeVar("Row")


class ConnectionKinds(Struct):
    """Connections that lay bodies on something, and those that run from one to another."""

    contacts: list[Touch] = field(default_factory=list)
    strings: list[String] = field(default_factory=list)
    springs: list[Spring] = field(default_factory=list)
    ropes: list[Drapes] = field(default_factory=list)
    gears: list[Gear] = field(default_factory=list)
    belts: list[Belt] = field(default_factory=list)
    slots: list[PinSlot] = field(default_factory=list)


KINDS: dict[type[Connection], str] = {
    Touch: "contacts",
    String: "strings",
    Spring: "springs",
    Drapes: "ropes",
    Gear: "gears",
    Belt: "belts",
    PinSlot: "slots",
}


def by_kind(connections: Iterable[Connection]) -> ConnectionKinds:
    """The connections of each kind, in their order."""
    found = ConnectionKinds()
    for item in connections:
        kind = row_for(type(item), KINDS)
        if kind is not None:
            getattr(found, kind).append(item)
    return found


def row_for(kind: type[Any], table: Mapping[type[Any], Row]) -> Row | None:
    """The row of a class in a table, or of the nearest of its base classes that has one."""
    return next((table[base] for base in kind.__mro__ if base in table), None)


def curve_radius(surface: Surface) -> Formula | None:
    """The radius of a curved surface; None of a flat one, and where it is not known."""
    return surface.radius() if surface.curved else None


def edge_height(surface: Surface) -> Formula | None:
    """How high above the floor an edge is; None of other surfaces."""
    return surface.height() if surface.curved else None
