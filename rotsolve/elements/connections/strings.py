"""Strings over and round pulleys and drums."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import Formula
from rotsolve.core.facts import Couple, Force, Requirement, Rule
from rotsolve.elements.connections.connection import Connection, Fact
from rotsolve.scene.keys import key
from rotsolve.scene.model import PointRef

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant



@dataclass(frozen=True)
class String(Connection):
    """A string over, round and under what it touches, named in order from its first end (on the left) to its last."""

    word = "string"
    about = "a string by what it touches, in order from its first end on the left to its last"
    quantities = ("tension", "force", "work", "power", "impulse", "length")
    words = ("slack", "taut")
    string: tuple[PointRef, ...] = key(
        "points", "what it touches, in order", count=(2, 50), required=True, example="[left, pulley, right]"
    )
    pulls: tuple[tuple[str, str], ...] = key(
        "map of directions", "direction in which it pulls a body", default=(), choices=("left", "right", "up", "down"), refers=BODIES
    )
    over: tuple[str, ...] = key("names", "pulleys that it passes over, turning them clockwise (the default)", default=(), refers=BODIES)
    under: tuple[str, ...] = key("names", "pulleys that it passes under, turning them counterclockwise", default=(), refers=BODIES)
    along: str | None = key("name", "the surface that it runs along", default=None, refers=("surface",))
    mass: Formula | None = key("quantity", "mass of the string", dimension="mass", limits="nonnegative", default=None, letter="m", later=True)
