"""Accelerations by Lagrange's equations, written by hand for each scene, without a line of the engine.

Each case names a scene, its coordinates, kinetic and potential energy, and what the asked quantities are in the coordinates'
accelerations.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import sympy
from sympy import cos, sin, symbols

from rotsolve.algebra.formula import Formula
from rotsolve.language.problem import Problem
from rotsolve.search.search import Search

HERE = Path(__file__).resolve().parent / "scenes"
M, m, n, p, K, L, R, r, s, d, g, ell, I, J = symbols("M m n p K L R r s d g l I J", positive=True)  # noqa: E741
beta, gamma, theta, phi, F, k, q, x, w, u, stretch = symbols("beta gamma theta phi F k q x w u stretch")
(X, Y), (VX, VY), (AX, AY) = symbols("X Y"), symbols("VX VY"), symbols("AX AY")
DISC = sympy.Rational(1, 2)
SPHERE = sympy.Rational(2, 5)
Expression = Any


@dataclass(frozen=True)
class Case:
    """One or two coordinates X, Y with rates VX, VY; `force` are the generalized forces without a potential."""

    scene: str
    kinetic: Expression
    potential: Expression
    asked: dict[str, Expression]  # in AX, AY and the givens
    place: Sequence[Expression] = (0, 0)
    rate: Sequence[Expression] = (0, 0)
    force: Sequence[Expression] = (0, 0)
    degrees: int = 1


def wheel(share: Expression, mass: Expression, speed: Expression) -> Expression:
    """½ I ω² of a round body whose rim has this speed: I = share · m R²."""
    return share * mass * speed**2 / 2


def speed_squared(x_place: Expression, y_place: Expression) -> Expression:
    """v² of a place that is a function of the coordinates."""
    return sum((sympy.diff(place, X) * VX + sympy.diff(place, Y) * VY) ** 2 for place in (x_place, y_place))


def rod_in_plane(
    mass: Expression, length: Expression, centre: tuple[Expression, Expression], angle: Expression
) -> Expression:
    """½ m v² + ½ (m l²/12) ω² of a rod."""
    turning = sympy.diff(angle, X) * VX + sympy.diff(angle, Y) * VY
    return mass * speed_squared(*centre) / 2 + mass * length**2 * turning**2 / 24


UPPER = (L / 2 * cos(X), L / 2 * sin(X))
LOWER = (L * cos(X) + ell / 2 * cos(Y), L * sin(X) + ell / 2 * sin(Y))
TWO_RODS = rod_in_plane(M, L, UPPER, X) + rod_in_plane(m, ell, LOWER, Y)
LADDER = (L / 2 * cos(X), -L / 2 * sin(X))  # X is the angle from start, on the wall, to end, on the floor
FRAME = 3 * m * s**2 * (sympy.Rational(1, 12)) + m * s**2 * (sympy.Rational(1, 4) * 2 + sympy.Rational(3, 4))
HANGING_BOB = M * L**2 / 3 + m * r**2 / 2 + m * L**2
SPOOL = (I + M * R**2) / R**2

CASES = (
    Case(
        "string-block-on-disc",
        m * VX**2 / 2 + wheel(DISC, M, VX),
        -m * g * X,
        {"a": AX, "alpha": AX / R, "T": m * (g - AX)},
    ),
    Case(
        "string-atwood-heavy",
        (m + n) * VX**2 / 2 + wheel(DISC, M, VX),
        (m - n) * g * X,
        {"a": AX, "T": m * (g + AX), "S": n * (g - AX), "Fy": M * g + m * (g + AX) + n * (g - AX)},
    ),
    Case(
        "string-atwood-senses-mixed", (m + n) * VX**2 / 2 + wheel(1, M, VX), (n - m) * g * X, {"a": AX, "alpha": AX / R}
    ),
    Case("string-atwood-light", (m + n) * VX**2 / 2, (m - n) * g * X, {"a": AX, "T": m * (g + AX)}),
    Case(
        "string-double-atwood",  # X: the third block down; Y: turn of the low pulley, clockwise
        p * VX**2 / 2
        + wheel(DISC, M, VX)
        + K * VX**2 / 2
        + wheel(DISC, K, r * VY)
        + m * (-VX - r * VY) ** 2 / 2
        + n * (-VX + r * VY) ** 2 / 2,
        -g * (p * X - K * X + m * (-X - r * Y) + n * (-X + r * Y)),
        {"a": AX, "b": -AX - r * AY, "c": -AX + r * AY, "T": m * (g + AX + r * AY)},
        degrees=2,
    ),
    Case(
        "string-slope-left",
        (m + n) * VX**2 / 2 + wheel(DISC, M, VX),
        m * g * X * sin(beta) - n * g * X,
        {"a": AX, "T": m * (AX + g * sin(beta)), "S": n * (g - AX), "Fx": m * (AX + g * sin(beta)) * cos(beta)},
    ),
    Case(
        "string-slope-right",
        (m + n) * VX**2 / 2 + wheel(DISC, M, VX),
        (n - m * sin(beta)) * g * X,
        {"a": AX, "alpha": AX / R},
    ),
    Case(
        "string-two-slopes",
        (m + n) * VX**2 / 2 + wheel(DISC, M, VX),
        (m * sin(beta) - n * sin(gamma)) * g * X,
        {"a": AX},
    ),
    Case(
        "string-stepped-drum",
        m * (r * VX) ** 2 / 2 + n * (R * VX) ** 2 / 2 + I * VX**2 / 2,
        m * g * r * X - n * g * R * X,
        {"a": r * AX, "alpha": AX, "T": m * (g + r * AX)},
    ),
    Case(
        "string-drum-under",
        m * (r * VX) ** 2 / 2 + n * (R * VX) ** 2 / 2 + I * VX**2 / 2,
        -n * g * R * X,
        {"a": r * AX, "alpha": AX, "T": m * r * AX},
    ),
    Case(
        "string-chain-of-three",
        (m + n + p) * VX**2 / 2 + wheel(DISC, M, VX) + wheel(1, K, VX),
        (m - p) * g * X,
        {"a": AX, "T": m * (g + AX) + M * AX / 2, "S": p * (g - AX) - K * AX},
    ),
    Case(
        "string-moving-pulley",  # X: the moving pulley up; the string runs twice as fast
        (K + m) * VX**2 / 2 + wheel(DISC, K, VX) + wheel(DISC, M, 2 * VX) + n * (2 * VX) ** 2 / 2,
        (K + m) * g * X - n * g * 2 * X,
        {"a": 2 * AX, "b": AX, "T": m * (g + AX)},
    ),
    Case(
        "string-moving-pulley-light", m * VX**2 / 2 + n * (2 * VX) ** 2 / 2, (m - 2 * n) * g * X, {"a": 2 * AX, "b": AX}
    ),
    Case("string-yoyo", M * VX**2 / 2 + wheel(DISC, M, VX), -M * g * X, {"a": AX, "alpha": AX / R, "T": M * (g - AX)}),
    Case("string-yoyo-hub", M * VX**2 / 2 + I * (VX / r) ** 2 / 2, -M * g * X, {"a": AX, "T": M * (g - AX)}),
    Case(
        "string-disc-to-falling-disc",  # X: string let off by the pulley; Y: string let off by the falling cylinder
        wheel(DISC, M, VX) + K * (VX + VY) ** 2 / 2 + wheel(DISC, K, VY),
        -K * g * (X + Y),
        {"a": AX + AY, "alpha": AX / R, "T": K * (g - AX - AY)},
        degrees=2,
    ),
    Case(
        "string-rolling-cylinder-and-block",
        M * VX**2 / 2 + wheel(DISC, M, VX) + wheel(DISC, K, 2 * VX) + n * (2 * VX) ** 2 / 2,
        -n * g * 2 * X,
        {"a": AX, "b": 2 * AX},
    ),
    Case(
        "string-roller-axle-and-block",
        M * VX**2 / 2 + wheel(DISC, M, VX) + wheel(DISC, K, VX) + n * VX**2 / 2,
        (M * sin(beta) - n) * g * X,
        {"a": AX, "f": M * AX / 2, "T": n * (g - AX)},
    ),
    Case(
        "contact-smooth-slope-cylinder-string",
        M * VX**2 / 2 + wheel(DISC, M, VX),
        -M * g * sin(beta) * X,
        {"a": AX, "T": M * (g * sin(beta) - AX)},
    ),
    Case("contact-ball-slope-any", m * VX**2 / 2 + wheel(SPHERE, m, VX), -m * g * sin(beta) * X, {"a": AX}),
    Case(
        "rolls-slope-left-down", M * VX**2 / 2 + wheel(DISC, M, VX), -M * g * sin(beta) * X, {"a": AX, "alpha": AX / R}
    ),
    Case(
        "rolls-slope-right-up", M * VX**2 / 2 + wheel(SPHERE, M, VX), M * g * sin(beta) * X, {"a": AX, "alpha": -AX / R}
    ),
    Case("rolls-level-pulled-at-centre", M * VX**2 / 2 + wheel(1, M, VX), 0, {"a": AX, "f": F - M * AX}, force=(F, 0)),
    Case(
        "rolls-spool-pulled",
        SPOOL * VX**2 / 2,
        0,
        {"a": AX, "f": F * cos(phi) - M * AX},
        force=(F * cos(phi) - F * r / R, 0),
    ),
    Case("hinge-rod-at-end", M * L**2 * VX**2 / 6, M * g * L / 2 * sin(X), {"alpha": AX}, place=(theta, 0)),
    Case(
        "hinge-rod-off-centre-clockwise",
        M * L**2 * VX**2 / 18,
        M * g * L / 6 * sin(X),
        {"alpha": -AX, "a_end": sympy.Abs(AX) * 2 * L / 3},
        place=(theta, 0),
    ),
    Case(
        "hinge-rod-on-rod",
        TWO_RODS,
        g * (M * UPPER[1] + m * LOWER[1]),
        {
            "alpha": AX,
            "beta": AY,
            "Fx": m * (-L * sin(theta) * AX - ell / 2 * sin(phi) * AY),
            "Fy": m * (g + L * cos(theta) * AX + ell / 2 * cos(phi) * AY),
        },
        place=(theta, phi),
        degrees=2,
    ),
    Case(
        "hinge-rod-on-rod-moving",
        TWO_RODS,
        g * (M * UPPER[1] + m * LOWER[1]),
        {"alpha": AX, "beta": -AY},
        place=(theta, phi),
        rate=(w, u),
        degrees=2,
    ),
    Case(
        "hinge-disc-on-rod",
        M * L**2 * VX**2 / 6 + m * L**2 * VX**2 / 2 + m * r**2 * VY**2 / 4,
        (M / 2 + m) * g * L * sin(X),
        {"alpha": AX, "beta": AY},
        place=(theta, 0),
        degrees=2,
    ),
    Case(
        "hinge-triangle-at-corner",
        FRAME * VX**2 / 2,
        3 * m * g * s / sympy.sqrt(3) * sin(X),
        {"alpha": AX},
        place=(sympy.pi / 6, 0),
    ),
    Case("weld-bob-on-rod", HANGING_BOB * VX**2 / 2, (M / 2 + m) * g * L * sin(X), {"alpha": AX}, place=(theta, 0)),
    Case("contact-ladder", rod_in_plane(M, L, LADDER, X), M * g * LADDER[1], {"alpha": AX}, place=(-theta, 0)),
    Case(
        "contact-ladder-moving",
        rod_in_plane(M, L, LADDER, X),
        M * g * LADDER[1],
        {
            "alpha": AX,
            "N": M * (g - L / 2 * (cos(theta) * AX + sin(theta) * w**2)),
            "P": M * L / 2 * (sin(theta) * AX - cos(theta) * w**2),
        },
        place=(-theta, 0),
        rate=(w, 0),
    ),
    Case(
        "contact-rod-slipping-foot",  # X: the foot to the right; Y: the angle
        rod_in_plane(M, L, (X + L / 2 * cos(Y), L / 2 * sin(Y)), Y),
        M * g * L / 2 * sin(Y),
        {"alpha": AY, "N": M * (g + L / 2 * cos(theta) * AY)},
        place=(0, theta),
        degrees=2,
    ),
    Case("belt-plain", I * VX**2 / 2 + J * (VX * r / R) ** 2 / 2, 0, {"a": AX, "b": AX * r / R}, force=(q, 0)),
    Case(
        "belt-crossed",  # X: motor clockwise, so the wheel counterclockwise and the block up
        I * VX**2 / 2 + J * (VX * r / R) ** 2 / 2 + m * (VX * r) ** 2 / 2,
        m * g * r * X,
        {"a": AX, "b": -AX * r},
        force=(-q, 0),
    ),
    Case("gear-plain", I * VX**2 / 2 + J * (VX * r / R) ** 2 / 2, 0, {"a": AX * r / R}, force=(q, 0)),
    Case(
        "gear-inside",  # X: drum clockwise, with the block on its right side; the small gear turns the same way
        J * VX**2 / 2 + I * (VX * R / r) ** 2 / 2 + m * (VX * s) ** 2 / 2,
        -m * g * s * X,
        {"a": s * AX, "b": AX * R / r},
    ),
    Case(
        "spring-on-slope",
        M * VX**2 / 2 + wheel(DISC, M, VX),
        -M * g * sin(beta) * X + k * X**2 / 2,
        {"a": AX},
        place=(x, 0),
    ),
    Case("torsion-disc", M * R**2 * VX**2 / 4, sympy.Symbol("kappa") * X**2 / 2, {"alpha": AX}, place=(theta, 0)),
)


def accelerations(case: Case, values: dict[str, float]) -> dict[str, float]:
    """d/dt ∂L/∂v − ∂L/∂x = Q, solved for the accelerations, at one moment."""
    places, rates = (X, Y)[: case.degrees], (VX, VY)[: case.degrees]
    lagrangian = case.kinetic - case.potential
    numbers = {symbol: values[symbol.name] for symbol in symbols_of(case) if symbol.name in values}
    moment = dict(zip((*places, *rates), (*case.place[: case.degrees], *case.rate[: case.degrees]), strict=True))

    def value(expression: Expression) -> float:
        return float(sympy.sympify(expression).subs(moment).subs(numbers))

    masses, pushes = [], []
    for index, (place, rate) in enumerate(zip(places, rates, strict=True)):
        impulse = sympy.diff(lagrangian, rate)
        masses.append([value(sympy.diff(impulse, other)) for other in rates])
        drift = sum(sympy.diff(impulse, other) * speed for other, speed in zip(places, rates, strict=True))
        pushes.append(value(sympy.diff(lagrangian, place) - drift + case.force[index]))
    found = sympy.Matrix(masses).LUsolve(sympy.Matrix(pushes))
    results = dict(zip((AX, AY), found, strict=False))
    return {name: float(sympy.sympify(asked).subs(results).subs(numbers)) for name, asked in case.asked.items()}


def symbols_of(case: Case) -> set[Any]:
    parts = (case.kinetic, case.potential, *case.place, *case.rate, *case.force, *case.asked.values())
    return set().union(*(sympy.sympify(part).free_symbols for part in parts))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("case", CASES, ids=[case.scene for case in CASES])
def test_lagrange_gives_the_same_accelerations(
    case: Case,
    search_of: Callable[..., Search],
    number: Callable[[Formula, dict[str, float]], float],
    nearby: Callable[[Problem, random.Random], dict[str, float]],
) -> None:
    search = search_of(HERE / f"{case.scene}.yaml")
    chance = random.Random(case.scene)
    found = {answered.asked.find.name: answered.found.formula for answered in search.answered}
    for _ in range(3):
        values = nearby(search.scene.configuration.problem, chance)
        for name, expected in accelerations(case, values).items():
            formula = found[name]
            assert formula is not None
            given = number(formula, values)
            assert abs(given - expected) <= 1e-9 * max(1.0, abs(expected)), f"{name} = {given}, by Lagrange {expected}"
