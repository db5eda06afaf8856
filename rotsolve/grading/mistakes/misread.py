"""Mistakes in reading the givens: a number without the factor of its unit, a diameter for a radius."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import PI, Formula, Number, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.grading.mistakes.mistake import Change
from rotsolve.grading.mistakes.places import Made, listed
from rotsolve.scene.model import Body

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene

MINUTE = Fraction(60)


def misread(scene: Scene, wrong: Callable[[Unit], Formula | None], words: str) -> Made:
    """Each given in a unit that is misread times its wrong factor, then all of them; `words` speak of its {name} and {unit}."""
    found = [
        (given, given.value * factor)
        for given in scene.problem.givens
        if given.value is not None and given.unit is not None and (factor := wrong(given.unit)) is not None
    ]
    for group in [[one] for one in found] + ([found] if len(found) > 1 else []):
        names = listed([to_text(Symbol(given.name)) for given, _ in group])
        units = listed(list(dict.fromkeys(given.unit.text for given, _ in group if given.unit is not None)))
        told = words.format(name=names, unit=units, are="was" if len(group) == 1 else "were")
        yield told, Change(numbers={given.name: value for given, value in group})


def in_degrees(unit: Unit) -> bool:
    return unit.pi_power == 1 and "°" in unit.text


def in_turns(unit: Unit) -> bool:
    """Revolutions, also by the minute."""
    return unit.pi_power == 1 and any(word in unit.text for word in ("rev", "rpm", "turn"))


def degrees(scene: Scene) -> Made:
    """30 rad for 30°."""
    return misread(
        scene, lambda unit: 180 / PI if in_degrees(unit) else None, "{name} in degrees {are} taken as in radians"
    )


def revolutions(scene: Scene) -> Made:
    """300 rad/s for 300 rev/min; or only the 2π or only the 60 of its factor left out."""
    yield from misread(
        scene, lambda unit: 1 / unit.factor if in_turns(unit) else None, "{name} in {unit} {are} taken as in rad and s"
    )
    yield from misread(
        scene,
        lambda unit: 1 / (2 * PI) if in_turns(unit) else None,
        "the 2π was left out when {name} {are} turned into rad",
    )
    minutes = "the minutes of {name} were taken for seconds"
    yield from misread(scene, lambda unit: Number(MINUTE) if in_turns(unit) and "min" in unit.text else None, minutes)


def hertz(scene: Scene) -> Made:
    """50 rad/s for 50 Hz."""
    return misread(
        scene, lambda unit: 1 / (2 * PI) if "Hz" in unit.text else None, "{name} in {unit} {are} taken as in rad/s"
    )


def units(scene: Scene) -> Made:
    """20 m for 20 cm."""
    return misread(
        scene,
        lambda unit: 1 / unit.factor if not unit.pi_power and unit.scale != 1 else None,
        "{name} in {unit} {are} not turned into SI units",
    )


# sizes


def diameters(scene: Scene) -> Made:
    """2 R for R; ½ R where the radius was taken for a diameter."""
    found = dict.fromkeys(name for body in scene.problem.bodies for name in radii(body))
    for name in found:
        letter = Symbol(name)
        yield f"the diameter was put for {to_text(letter)}", Change(letters={name: 2 * letter})
        yield f"{to_text(letter)} was halved, as if it were a diameter", Change(letters={name: letter / 2})
    if len(found) > 1:
        names = listed([to_text(Symbol(name)) for name in found])
        yield f"diameters were put for {names}", Change(letters={name: 2 * Symbol(name) for name in found})


def radii(body: Body) -> Iterator[str]:
    """The letters of the radii of a body and its parts."""
    shape = body.shape
    told: Iterable[Formula | None] = (
        body.radius,
        getattr(shape, "radius", None),
        *(size for _, size in (*body.radii, *getattr(shape, "radii", ()))),
    )
    yield from (size.name for size in told if isinstance(size, Symbol))
    for part in body.parts:
        yield from radii(part.body)
