"""Mistakes in reading the givens: a number without the factor of its unit, one letter for another, a diameter for a radius."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Number, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.unit_table import UNITS, Unit
from rotsolve.grading.mistakes.kinds.places import MOST, Made, each, listed
from rotsolve.grading.mistakes.mistake import Change
from rotsolve.language.problem import Body

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene

TURNS = ("rev", "rpm", "turn")  # in the text of a unit that counts revolutions
MINUTE = Number(UNITS["min"].scale)


def misread(scene: Scene, fits: Callable[[Unit], bool], wrong: Callable[[Unit], Formula], words: str) -> Made:
    """Each given in a unit that is misread times its wrong factor, then all of them; `words` speak of its {name} and {unit}."""
    found = [
        (given.name, given.unit.text, wrong(given.unit))
        for given in scene.problem.givens
        if given.value is not None and given.unit is not None and fits(given.unit)
    ]
    alone = [[one] for one in found] if len(found) <= MOST else []
    for group in [*alone, *([found] if len(found) > 1 else [])]:
        names = listed([to_text(Symbol(name)) for name, _, _ in group])
        units = listed(list(dict.fromkeys(unit for _, unit, _ in group)))
        told = words.format(name=names, unit=units, are="was" if len(group) == 1 else "were")
        yield told, Change(factors={name: factor for name, _, factor in group})


def in_degrees(unit: Unit) -> bool:
    return unit.pi_power == 1 and UNITS["°"].text in unit.text


def in_turns(unit: Unit) -> bool:
    """Revolutions, also by the minute."""
    return unit.pi_power == 1 and any(word in unit.text for word in TURNS)


def by_minutes(unit: Unit) -> bool:
    return in_turns(unit) and ("min" in unit.text or "rpm" in unit.text)


def in_hertz(unit: Unit) -> bool:
    return "Hz" in unit.text


def scaled(unit: Unit) -> bool:
    """A multiple of an SI unit."""
    return not unit.pi_power and unit.scale != 1


def without_factor(unit: Unit) -> Formula:
    return ONE / unit.factor


def without_turn(unit: Unit) -> Formula:
    return ONE / (2 * PI)


def degrees(scene: Scene) -> Made:
    """30 rad for 30°."""
    return misread(scene, in_degrees, lambda unit: 180 / PI, "{name} in degrees {are} taken as in radians")


def revolutions(scene: Scene) -> Made:
    """300 rad/s for 300 rev/min; or only the 2π or only the 60 of its factor left out."""
    yield from misread(scene, in_turns, without_factor, "{name} in {unit} {are} taken as in radians and seconds")
    yield from misread(scene, in_turns, without_turn, "the 2π was left out when {name} {are} turned into radians")
    yield from misread(scene, by_minutes, lambda unit: MINUTE, "the minutes of {name} were taken for seconds")


def hertz(scene: Scene) -> Made:
    """50 rad/s for 50 Hz."""
    return misread(scene, in_hertz, without_turn, "{name} in {unit} {are} taken as in rad/s")


def units(scene: Scene) -> Made:
    """20 m for 20 cm."""
    return misread(scene, scaled, without_factor, "{name} in {unit} {are} not turned into SI units")


# letters


def diameters(scene: Scene) -> Made:
    """2 R for R; ½ R where the radius was taken for a diameter."""
    found = radii(scene.problem.bodies)
    for name in each(found):
        letter = Symbol(name)
        yield f"the diameter was put for {to_text(letter)}", Change(letters={name: 2 * letter})
        yield f"{to_text(letter)} was halved, as if it were a diameter", Change(letters={name: letter / 2})
    if len(found) > 1:
        names = listed([to_text(Symbol(name)) for name in found])
        yield f"diameters were put for {names}", Change(letters={name: 2 * Symbol(name) for name in found})


def exchanged(scene: Scene) -> Made:
    """m₂ for m₁ and m₁ for m₂; so for two radii."""
    masses = [body.mass.name for body in scene.problem.bodies if isinstance(body.mass, Symbol)]
    for names in (masses, radii(scene.problem.bodies)):
        for one, other in combinations(each(names), 2):
            words = f"{to_text(Symbol(one))} and {to_text(Symbol(other))} were exchanged"
            yield words, Change(letters={one: Symbol(other), other: Symbol(one)})


def from_rest(scene: Scene) -> Made:
    """0 for a velocity at the start."""
    lines = scene.problem.states[0].conditions if scene.problem.states else ()
    speeds = [
        line.value.name
        for line in lines
        if line.path is not None
        and isinstance(line.value, Symbol)
        and line.path.quantity in ("velocity", "angular_velocity")
    ]
    for name in each(speeds):
        yield f"{to_text(Symbol(name))} was left out, as if the motion began at rest", Change(letters={name: ZERO})


def radii(bodies: Iterable[Body]) -> list[str]:
    """The letters of the radii of some bodies and their parts, each once."""
    return list(dict.fromkeys(name for body in bodies for name in radii_of(body)))


def radii_of(body: Body) -> Iterator[str]:
    told: Iterable[Formula | None] = (
        body.radius,
        getattr(body.shape, "radius", None),
        *(size for _, size in (*body.radii, *getattr(body.shape, "radii", ()))),
    )
    yield from (size.name for size in told if isinstance(size, Symbol))
    for part in body.parts:
        yield from radii_of(part.body)
