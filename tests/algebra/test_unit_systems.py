"""Answers in the units of the givens, where these are all of one system: feet and pounds, or centimetres and grams with dynes or ergs."""

from __future__ import annotations

import pint
import pytest

from rotsolve import solve
from rotsolve.algebra.units.dimension import (
    ACCELERATION,
    ANGULAR_VELOCITY,
    ENERGY,
    FORCE,
    INERTIA,
    LENGTH,
    MASS,
    POWER,
    TIME,
    VELOCITY,
    Dimension,
)
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.algebra.units.systems import CGS, FPS, UnitSystem, coherent, system_of, unit_in

SPELLED = {"lbf": "force_pound", "dyn": "dyne"}
MOMENTUM, SPRING, DENSITY = MASS * VELOCITY, FORCE / LENGTH, MASS / LENGTH**3


@pytest.mark.parametrize(
    ("units", "system"),
    [
        (("ft", "slug", "s"), FPS),
        (("lbf", "ft/s²", "rev/min", "°"), FPS),
        (("mph", "in"), FPS),
        (("dyn cm", "g"), CGS),
        (("erg", "cm/s"), CGS),
        (("cm", "g"), None),  # so they are in SI too
        (("ft", "kg"), None),
        (("lbf", "m/s²"), None),
        (("dyn", "kg"), None),
        (("rad/s", "s"), None),
        ((), None),
    ],
)
def test_all_units_are_of_one_system_or_it_is_si(units: tuple[str, ...], system: UnitSystem | None) -> None:
    assert system_of([None, *map(parse_unit, units)]) == system


@pytest.mark.parametrize(
    ("system", "dimension", "kind", "text"),
    [
        (FPS, LENGTH, "", "ft"),
        (FPS, VELOCITY, "", "ft/s"),
        (FPS, ACCELERATION, "", "ft/s²"),
        (FPS, MASS, "", "slug"),
        (FPS, INERTIA, "", "slug ft²"),
        (FPS, DENSITY, "", "slug/ft³"),
        (FPS, FORCE, "", "lbf"),
        (FPS, ENERGY, "", "ft lbf"),
        (FPS, ENERGY, "torque", "lbf ft"),
        (FPS, POWER, "", "ft lbf/s"),
        (FPS, MOMENTUM, "", "lbf s"),
        (FPS, MOMENTUM * LENGTH, "", "lbf ft s"),
        (FPS, SPRING, "", "lbf/ft"),
        (CGS, FORCE, "", "dyn"),
        (CGS, ENERGY, "", "erg"),
        (CGS, ENERGY, "torque", "dyn cm"),
        (CGS, POWER, "", "erg/s"),
        (CGS, INERTIA, "", "g cm²"),
        (CGS, MOMENTUM, "", "g cm/s"),
    ],
)
def test_each_dimension_has_its_unit(system: UnitSystem, dimension: Dimension, kind: str, text: str) -> None:
    """Its factor by pint, which has a table of its own."""
    unit = unit_in(system, dimension, kind)
    assert unit is not None and unit.text == text and unit.dimension.matches(dimension)
    spelled = " * ".join(SPELLED.get(word, word) for word in text.split("/")[0].replace("²", "**2").split())
    below = text.split("/")[1:]
    spelled += "".join(f" / {part.replace('²', '**2').replace('³', '**3')}" for part in below)
    assert float(unit.scale) == pytest.approx(pint.UnitRegistry()(spelled).to_base_units().magnitude, rel=1e-12)


@pytest.mark.parametrize("dimension", [ANGULAR_VELOCITY, TIME])
def test_what_has_no_mass_and_no_length_is_the_same_everywhere(dimension: Dimension) -> None:
    assert unit_in(FPS, dimension) is None


def test_pounds_of_mass_are_kept_and_put_in_as_slugs() -> None:
    told = system_of([parse_unit("lb"), parse_unit("ft")])
    assert told is not None and unit_in(told, MASS).text == "lb" and unit_in(told, INERTIA).text == "lb ft²"  # type: ignore[union-attr]
    assert unit_in(coherent(told), MASS).text == "slug"  # type: ignore[union-attr]


WHEEL = """
title: Wheel with a weight
given: {GIVEN}
bodies: {wheel: {shape: disc, mass: M, radius: R}, block: {mass: m}}
connections: {axle: {hinge: wheel.center}, cord: {string: [wheel, block]}}
states: {now: {wheel.angular_velocity: 2 rad/s}}
find: {a: block.acceleration, T: cord.tension, K: wheel.kinetic_energy, L: wheel.angular_momentum, w: wheel.angular_velocity}
"""


@pytest.mark.parametrize(
    ("given", "units"),
    [
        ("M: 2 slug, R: 6 in, m: 1 slug", ["ft/s²", "lbf", "ft lbf", "lbf ft s", "rad/s"]),
        ("M: 2 lb, R: 6 in, m: 1 lb", ["ft/s²", "lbf", "ft lbf", "lbf ft s", "rad/s"]),
        ("M: 2 lb, R: 15 cm, m: 1 lb", ["m/s²", "N", "J", "kg m²/s", "rad/s"]),
        ("M: 2 kg, R: 15 cm, m: 1 kg", ["m/s²", "N", "J", "kg m²/s", "rad/s"]),
    ],
)
def test_a_scene_answers_in_the_system_of_its_givens(given: str, units: list[str]) -> None:
    solution = solve(WHEEL.replace("GIVEN", given))
    assert [answer.unit.text for answer in solution.derivation.answers if answer.unit is not None] == units
    assert all(item.holds for item in solution.derivation.confirmed)


def test_numbers_that_are_put_in_come_to_the_answer_in_its_unit() -> None:
    text = solve(WHEEL.replace("GIVEN", "M: 2 slug, R: 6 in, m: 1 slug, g: 32 ft/s^2")).to("text")
    assert "R = 6 in = 0.5000 ft" in text and "kg" not in text and " J" not in text
    assert "ω_wheel² = ¼·2·0.5²·2² ft lbf = 0.5 ft lbf" in text
