"""Body: the kinds of bodies of which compositions are made, with the points at which each can be held, struck and asked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from compositions.letters import Letters

Entry = dict[str, Any]


@dataclass(frozen=True)
class Kind:
    """A kind of body: how it is written, its points, whether it has a rim, an axis, and an extent at all."""

    word: str
    entry: Callable[[Letters, str], Entry]  # from its letters and its name
    points: tuple[str, ...] = ("center",)
    rims: tuple[str, ...] = ()
    extended: bool = True

    def places(self, name: str, entry: Entry) -> list[str]:
        """Its points, as paths; the body itself where it has no extent."""
        return [f"{name}.{point.format(name, **entry)}" for point in self.points] or [name]


def shaped(word: str, **sizes: str) -> Callable[[Letters, str], Entry]:
    """A body of a shape with its mass and sizes; each size is named by its letter."""

    def entry(letters: Letters, name: str) -> Entry:
        lengths = {key: letters.new(size, "m") for key, size in sizes.items()}
        return {"shape": word, "mass": letters.new("M", "kg"), **lengths}

    return entry


def annulus(letters: Letters, name: str) -> Entry:
    inner = letters.new("r", "m")
    return {"shape": "annulus", "mass": letters.new("M", "kg"), "radii": {"inner": inner, "outer": f"2*{inner}"}}


def spool(letters: Letters, name: str) -> Entry:
    small = letters.new("r", "m")
    mass = letters.new("M", "kg")
    return {"mass": mass, "inertia": f"{mass}*{small}^2", "radii": {"big": f"2*{small}", "small": small}}


def loaded(letters: Letters, name: str) -> Entry:
    """A disc with a particle in it, off its centre."""
    radius = letters.new("R", "m")
    parts = {
        f"{name}_hoop": {"shape": "disc", "mass": letters.new("M", "kg"), "radius": radius},
        f"{name}_lump": {"mass": letters.new("m", "kg"), "at": [f"{radius}/2", "0"]},
    }
    return {"radius": radius, "parts": parts}


def hammer(letters: Letters, name: str) -> Entry:
    """A rod with a disc at its end."""
    length = letters.new("L", "m")
    parts = {
        f"{name}_stick": {"shape": "rod", "mass": letters.new("m", "kg"), "start": ["0", "0"], "end": [length, "0"]},
        f"{name}_head": {"shape": "disc", "mass": letters.new("M", "kg"), "radius": f"{length}/4", "at": [length, "0"]},
    }
    return {"parts": parts, "points": {"grip": ["0", "0"]}}


def plate(letters: Letters, name: str) -> Entry:
    side = letters.new("b", "m")
    return {
        "shape": "rectangle",
        "mass": letters.new("M", "kg"),
        "sides": [side, f"{side}/2"],
        "points": {"P": [f"{side}/3", "0"]},
    }


ROUND = ("center", "rim", "top", "bottom")
KINDS = (
    Kind("particle", lambda letters, name: {"mass": letters.new("m", "kg")}, points=(), extended=False),
    Kind("rod", shaped("rod", length="L"), points=("start", "end", "center", "at({length}/3)")),
    Kind(
        "light rod",
        lambda letters, name: {"shape": "rod", "mass": "0", "length": letters.new("L", "m")},
        points=("start", "end"),
    ),
    Kind("disc", shaped("disc", radius="R"), points=ROUND, rims=("",)),
    Kind("ring", shaped("ring", radius="R"), points=ROUND, rims=("",)),
    Kind("sphere", shaped("sphere", radius="R"), points=ROUND, rims=("",)),
    Kind("half ball", shaped("hemisphere", radius="R"), points=("center", "cm"), rims=("",)),
    Kind("annulus", annulus, points=(*ROUND, "inner", "outer"), rims=("", "outer")),
    Kind("spool", spool, points=("center", "big", "small"), rims=("big", "small")),
    Kind("plate", plate, points=("center", "corner1", "corner2", "P")),
    Kind("loaded wheel", loaded, points=("center", "{}_lump"), rims=("",)),
    Kind("hammer", hammer, points=("grip", "{}_head", "cm")),
)
