"""Swings by another way: the full equation of motion stepped in time (Runge-Kutta), and elliptic integrals by quadrature.

The moments of inertia, torques and springs are written out here by hand; nothing of the solver is used but its answers.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import mpmath
import pytest

from rotsolve.pipeline import solve

PROBLEMS = Path(__file__).parent.parent.parent / "problems"
G = 9.8
Acceleration = Callable[[float], float]


def answer(problem: str, name: str) -> float:
    value = solve(PROBLEMS / f"{problem}.yaml").answers[name].float
    assert value is not None
    return value


def step(place: float, rate: float, time: float, acceleration: Acceleration) -> tuple[float, float]:
    """One Runge-Kutta step of the fourth order."""
    k1, l1 = rate, acceleration(place)
    k2, l2 = rate + time / 2 * l1, acceleration(place + time / 2 * k1)
    k3, l3 = rate + time / 2 * l2, acceleration(place + time / 2 * k2)
    k4, l4 = rate + time * l3, acceleration(place + time * k3)
    return place + time / 6 * (k1 + 2 * k2 + 2 * k3 + k4), rate + time / 6 * (l1 + 2 * l2 + 2 * l3 + l4)


def period(acceleration: Acceleration, amplitude: float, time: float) -> float:
    """Four times the time from rest at the amplitude to the equilibrium; the last step is halved down to the crossing."""
    place, rate, passed = amplitude, 0.0, 0.0
    while time > 1e-13:
        further = step(place, rate, time, acceleration)
        if further[0] > 0:
            (place, rate), passed = further, passed + time
        else:
            time /= 2
    return 4 * passed


TINY = 1e-4
ROD_WITH_NUT = 0.3 * 0.8**2 / 3 + 1.2 * 0.8**2 + 0.15 * 0.3**2
SMALL: dict[tuple[str, str], Acceleration] = {
    ("swinging-rod", "T"): lambda q: -1.5 * G * 0.45 * math.sin(q) / (1.5 * 0.9**2 / 3),
    ("disc-and-ring-on-nails", "T1"): lambda q: -0.8 * G * 0.25 * math.sin(q) / (1.5 * 0.8 * 0.25**2),
    ("disc-and-ring-on-nails", "T2"): lambda q: -0.3 * G * 0.25 * math.sin(q) / (2 * 0.3 * 0.25**2),
    ("clock-pendulum-nut", "T"): lambda q: -G * (0.3 * 0.4 + 1.2 * 0.8 + 0.15 * 0.3) * math.sin(q) / ROD_WITH_NUT,
    ("spring-pulley-swings", "T"): lambda q: (1.5 * G - 60 * (1.5 * G / 60 + q)) / (2 + 1.5 + 0.5),
    ("rolling-on-a-spring", "T"): lambda q: -200 * q / (3 + 1.5),
    # an upright spring keeps upright where it is long: its foot moves along with the rod
    ("rod-held-level-swings", "T"): lambda q: (
        (-2 * G * 0.6 - 300 * (-2 * G * 0.6 / (300 * 0.9) + 0.9 * math.sin(q)) * 0.9) * math.cos(q) / (2 * 1.2**2 / 3)
    ),
}


@pytest.mark.parametrize(("problem", "name"), SMALL)
def test_small_swings_take_as_long_as_the_full_motion(problem: str, name: str) -> None:
    assert period(SMALL[problem, name], TINY, 1e-3) == pytest.approx(answer(problem, name), rel=1e-7)


LARGE: dict[tuple[str, str], tuple[Acceleration, float]] = {
    ("swing-from-60-degrees", "T"): (lambda q: -1.5 * G / 1.2 * math.sin(q), math.radians(60)),
    ("swing-from-170-degrees", "T"): (lambda q: -G / 0.75 * math.sin(q), math.radians(170)),
    ("torsion-pendulum-any-size", "T"): (lambda q: -0.03 * q / (0.6 * 0.5**2 / 12), math.radians(140)),
}


@pytest.mark.parametrize(("problem", "name"), LARGE)
def test_large_swings_take_as_long_as_the_full_motion(problem: str, name: str) -> None:
    acceleration, amplitude = LARGE[problem, name]
    assert period(acceleration, amplitude, 1e-3) == pytest.approx(answer(problem, name), rel=1e-9)


@pytest.mark.parametrize("degrees", [60, 170])
def test_ratio_of_large_to_small_swings_by_the_arithmetic_geometric_mean(degrees: int) -> None:
    ratio = 1 / mpmath.agm(1, mpmath.cos(mpmath.radians(degrees) / 2))
    assert answer(f"swing-from-{degrees}-degrees", "n") == pytest.approx(float(ratio), rel=1e-12)
