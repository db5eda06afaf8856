"""Body in space: the kinds of bodies of which scenes in space are made, each with a point P somewhere on it."""

from __future__ import annotations

from collections.abc import Callable

from compositions.body import Entry, Kind, shaped
from compositions.letters import Letters


def placed(letters: Letters) -> list[str]:
    """Somewhere on a body, off its axes or on one of them."""
    return [letters.chance.choice(("0 m", letters.new("p", "m"), f"-{letters.new('p', 'm')}")) for _ in range(3)]


def with_point(entry: Callable[[Letters, str], Entry]) -> Callable[[Letters, str], Entry]:
    """The body with a point P somewhere; now and then it is turned from how it is drawn."""

    def made(letters: Letters, name: str) -> Entry:
        found = {**entry(letters, name), "points": {"P": placed(letters)}}
        if letters.chance.random() < 0.2:
            turns = [
                {"about": axis, "by": letters.chance.choice(("90 deg", letters.new("beta", "deg")))} for axis in "xz"
            ]
            found["turned"] = turns if letters.chance.random() < 0.5 else turns[0]
        return found

    return made


def cuboid(letters: Letters, name: str) -> Entry:
    return {"shape": "cuboid", "mass": letters.new("M", "kg"), "sides": [letters.new(size, "m") for size in "abc"]}


def principal(letters: Letters, name: str) -> Entry:
    moments = [letters.new("I", "kg m^2") for _ in range(3)]
    return {"mass": letters.new("M", "kg"), "inertia": {"principal": moments}}


def symmetric(letters: Letters, name: str) -> Entry:
    across, along = letters.new("A", "kg m^2"), letters.new("C", "kg m^2")
    return {"mass": letters.new("M", "kg"), "inertia": {"principal": [across, across, along]}, "axis": "z"}


def tensor(letters: Letters, name: str) -> Entry:
    """Moments with one product of inertia, small enough that a body can have them."""
    one, two, three = (letters.new("I", "kg m^2") for _ in range(3))
    rows = [[one, f"-{two}/9", "0 kg m^2"], [f"-{two}/9", two, "0 kg m^2"], ["0 kg m^2", "0 kg m^2", three]]
    return {"mass": letters.new("M", "kg"), "inertia": {"tensor": rows}}


def skew(letters: Letters, name: str) -> Entry:
    """A disc askew and a particle beside it."""
    radius, beta = letters.new("R", "m"), letters.new("beta", "deg")
    wheel = {"shape": "disc", "mass": letters.new("M", "kg"), "radius": radius, "at": ["0 m", "0 m", "0 m"]}
    lump = {"mass": letters.new("q", "kg"), "at": [radius, "0 m", letters.new("h", "m")]}
    return {"parts": {f"{name}_disc": {**wheel, "turned": {"about": "y", "by": beta}}, f"{name}_lump": lump}}


ROUND = ("disc", "ring", "sphere", "cylinder", "cone", "symmetric")
KINDS = tuple(
    Kind(word, with_point(entry), points)
    for word, entry, points in (
        ("cuboid", cuboid, ("center", "P")),
        ("cylinder", shaped("cylinder", radius="R", length="L"), ("center", "P")),
        ("disc", shaped("disc", radius="R"), ("center", "P")),
        ("ring", shaped("ring", radius="R"), ("center", "P")),
        ("rod", shaped("rod", length="L"), ("start", "center", "end", "P")),
        ("sphere", shaped("sphere", radius="R"), ("center", "P")),
        ("cone", shaped("cone", radius="R", length="L"), ("tip", "base", "P")),
        ("principal", principal, ("cm", "P")),
        ("symmetric", symmetric, ("cm", "P")),
        ("tensor", tensor, ("cm", "P")),
        ("parts", skew, ("cm", "P")),
    )
)
