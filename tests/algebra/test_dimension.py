"""Dimensions: their arithmetic, their words, and what does not fit together."""

from __future__ import annotations

import ast
from fractions import Fraction
from pathlib import Path

import pytest

import rotsolve
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.units.dimension import (
    ACCELERATION,
    ANGLE,
    ANGULAR_ACCELERATION,
    ANGULAR_MOMENTUM,
    ANGULAR_VELOCITY,
    DIMENSIONS,
    ENERGY,
    FORCE,
    INERTIA,
    LENGTH,
    MASS,
    MOMENTUM,
    NONE,
    POWER,
    STIFFNESS,
    TIME,
    TORQUE,
    TORSION_STIFFNESS,
    VELOCITY,
    Dimension,
    DimensionError,
    describe,
    dimension_of,
    is_positive,
    printed_dimension,
    product_rank,
    word_of,
)
from rotsolve.algebra.units.quantities import unit_for
from rotsolve.core.quantity import QUANTITIES

SYMBOLS = {
    "m": MASS,
    "M": MASS,
    "g": ACCELERATION,
    "a": ACCELERATION,
    "T": FORCE,
    "R": LENGTH,
    "L": LENGTH,
    "v": VELOCITY,
    "omega": ANGULAR_VELOCITY,
    "alpha": ANGULAR_ACCELERATION,
    "theta": ANGLE,
    "I": INERTIA,
    "k": STIFFNESS,
    "kappa": TORSION_STIFFNESS,
    "n": NONE,
    "t1": TIME,
    "c": TORQUE / TIME**2,
    "J": FORCE * TIME,
}


def of(text: str) -> Dimension:
    return dimension_of(parse(text, [*SYMBOLS, "time", "q"]), SYMBOLS)


def test_arithmetic() -> None:
    assert FORCE * LENGTH == ENERGY
    assert ENERGY / TIME == POWER
    assert Dimension(length=2, time=-2) == VELOCITY**2
    assert (LENGTH**2) ** Fraction(1, 2) == LENGTH
    assert TORQUE != ENERGY
    assert TORQUE.matches(ENERGY)
    assert not FORCE.matches(MASS)
    assert TORQUE * ANGLE == ENERGY
    assert INERTIA * ANGULAR_ACCELERATION == TORQUE
    assert INERTIA * ANGULAR_VELOCITY == ANGULAR_MOMENTUM
    assert INERTIA * ANGULAR_VELOCITY**2 == ENERGY


@pytest.mark.parametrize(
    ("text", "dimension"),
    [
        ("m g - T", FORCE),
        ("T R - I alpha", TORQUE),
        ("½ m v² + ½ I omega²", ENERGY),
        ("m v + J", MOMENTUM),
        ("v - omega R", VELOCITY),
        ("2 m g/(2 m + M)", ACCELERATION),
        ("√(2 g L)", VELOCITY),
        ("(g L)^(1/2)", VELOCITY),
        ("L^-2", LENGTH**-2),
        ("sin theta", NONE),
        ("cos(L/R)", NONE),
        ("atan2(L, R)", ANGLE),
        ("asin(L/R)", ANGLE),
        ("exp(n) m", MASS),
        ("2^n", NONE),
        ("|a|", ACCELERATION),
        ("0 + m", MASS),
        ("m + 0 L", MASS),
        ("0", NONE),
        ("π n", NONE),
        ("1 + theta", NONE),
        ("∫[0 → t1] c time² d time", TORQUE * TIME),
        ("∫[0 → L] k q d q", ENERGY),
    ],
)
def test_dimension_of(text: str, dimension: Dimension) -> None:
    assert of(text).matches(dimension)


def test_angle_is_carried_along() -> None:
    assert of("I alpha") == TORQUE
    assert of("I omega²") == ENERGY
    assert of("kappa theta") == TORQUE


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("m g - a", "m g is a force (N), but a is an acceleration (m/s²)"),
        ("-T R + m", "T R is an energy or torque (J), but m is a mass (kg)"),
        ("I alpha + T", "I α is a torque (N m), but T is a force (N)"),
        ("1 + L", "1 is a pure number, but L is a length (m)"),
        ("sin L", "sin takes an angle, but L is a length (m)"),
        ("exp(2 m)", "exp takes a pure number, but 2 m is a mass (kg)"),
        ("2^L", "the exponent L is a length (m), not a pure number"),
        ("m^n", "m is a mass (kg), so its exponent must be a number, not n"),
        ("atan2(L, v)", "L is a length (m), but v is a velocity (m/s)"),
        ("q", "the dimension of q is not known"),
        ("m L³/t1 + 1", "m L³/t1 is a quantity in kg m³/s, but 1 is a pure number"),
        ("∫[0 → L] 1 d time", "the bound L is a length (m), but time is a time (s)"),
        ("∫[L → t1] 1 d q", "L is a length (m), but t₁ is a time (s)"),
    ],
)
def test_messages(text: str, message: str) -> None:
    with pytest.raises(DimensionError) as caught:
        of(text)
    assert str(caught.value) == message.replace("/t1 ", "/t₁ ")


@pytest.mark.parametrize(
    ("dimension", "words"),
    [
        (NONE, "pure number"),
        (LENGTH, "length (m)"),
        (FORCE, "force (N)"),
        (TORQUE, "torque (N m)"),
        (INERTIA, "moment of inertia (kg m²)"),
        (MASS * LENGTH**2, "moment of inertia (kg m²)"),
        (ANGULAR_MOMENTUM, "angular momentum (kg m²/s)"),
        (ANGULAR_VELOCITY, "angular velocity (rad/s)"),
        (STIFFNESS, "stiffness (N/m)"),
        (LENGTH**4 / (MASS * TIME), "quantity in m⁴/(kg s)"),
        (LENGTH ** Fraction(1, 2), "quantity in m^(1/2)"),
    ],
)
def test_describe(dimension: Dimension, words: str) -> None:
    assert describe(dimension) == words


def test_kinds_stand_in_one_table() -> None:
    """No other file lists what goes by kind: a kind more is a row more of `KINDS`."""
    package = Path(rotsolve.__file__).parent
    for path in package.rglob("*.py"):
        if path == package / "algebra" / "units" / "dimension.py":
            continue
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, (ast.Dict, ast.Tuple, ast.List, ast.Set)):
                parts = node.keys if isinstance(node, ast.Dict) else node.elts
                words = {part.value for part in parts if isinstance(part, ast.Constant)}
                kinds = words & DIMENSIONS.keys() - QUANTITIES.keys()
                assert len(kinds) < 2, f"{path}:{node.lineno}: {kinds}"


def test_a_kind_tells_its_rank_sign_and_word() -> None:
    assert [
        product_rank(DIMENSIONS[word]) for word in ("number", "mass", "moment of inertia", "density", "length")
    ] == [
        0,
        1,
        2,
        3,
        12,
    ]
    assert is_positive(DIMENSIONS["mass"]) and not is_positive(DIMENSIONS["angle"]) and not is_positive(None)
    assert [word_of(DIMENSIONS[word]) for word in ("torsional stiffness", "energy")] == [
        "torsional stiffness",
        "energy",
    ]
    assert product_rank(None) == product_rank(DIMENSIONS["density"]) and word_of(DIMENSIONS["length"] ** 7) is None


@pytest.mark.parametrize(
    "text, unit",
    [
        ("v + w*R", "m/s"),
        ("w*R + v", "m/s"),
        ("w*R - 2*w*R", "m/s"),
        ("a*R - w^2*R", "m/s²"),
        ("w + v/R", "rad/s"),
        ("v/R + w", "rad/s"),
        ("w^2 - g/R", "1/s²"),
        ("a + g/R", "rad/s²"),
        ("2*cos(q) - 2 + 2*q*sin(q) - q^2", ""),
        ("q + v/(w*R)", "rad"),
        ("F*R + T", "N m"),
        ("J + m*R^2", "kg m²"),
        ("J*w + m*v*R", "kg m²/s"),
        ("m*v^2 + J*w^2", "J"),
        ("F - m*g", "N"),
    ],
)
def test_a_sum_of_givens_is_told_in_a_unit_of_a_known_kind(text: str, unit: str) -> None:
    """With its radians where such a quantity has a name, else without: a velocity is in m/s, whichever of its terms comes first."""
    letters = {
        **{"v": VELOCITY, "w": ANGULAR_VELOCITY, "R": LENGTH, "a": ANGULAR_ACCELERATION, "g": ACCELERATION, "q": ANGLE},
        **{"F": FORCE, "T": TORQUE, "J": INERTIA, "m": MASS},
    }
    assert unit_for(printed_dimension(parse(text), letters)).text == unit
