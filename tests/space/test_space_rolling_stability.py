"""Small disturbances of wheels that roll steadily: λ² against the eigenvalues of their equations of motion, written out by hand.

With p = φ̇ sin θ: (I₁ + M R²) θ̈ = I₁ p² cot θ − (I₃ + M R²) p ω₃ − M g R cos θ, I₁ ṗ = (I₃ ω₃ − I₁ p cot θ) θ̇, (I₃ + M R²) ω̇₃ = M R² p θ̇.
"""

from __future__ import annotations

from math import cos, pi, radians, sin, sqrt, tan

import numpy as np
import pytest

import rotsolve
from rotsolve.core.faults import Unsolvable

M, R, G = 0.01, 0.01, 9.81
ACROSS = {"disc": 0.25, "ring": 0.5}  # I₁/M R²
SCENE = """title: x
up: z
given: {m: 10 g, R: 1 cm, theta: 70 deg, W: 20 rad/s, s: unknown, g: 9.81 m/s^2}
bodies: {coin: {shape: disc, mass: m, radius: R}}
surfaces: {table: level}
connections: {grip: {rolls: [coin, table]}}
states: {now: {coin.tilt: theta, coin.spin: s, coin.precession: W, steady: true}}
find: {s: s, L: coin.stability at now}
"""
SPUN = SCENE.replace("70 deg, W: 20 rad/s, s: unknown", "90 deg, W: unknown, s: 0 rad/s").split("find")[0]
SAME = "confirmed with numbers"


def grows(shape: str, tilt: float, round_: float) -> tuple[float, float]:
    """The spin of the steady motion, and the λ² of its equations by differences."""
    across, shift = ACROSS[shape] * M * R**2, M * R**2
    axial = 2 * across

    def rate(state: np.ndarray) -> np.ndarray:
        theta, turning, p, spin = state
        tipping = across * p**2 / tan(theta) - (axial + shift) * p * spin - M * G * R * cos(theta)
        gains = (axial * spin - across * p / tan(theta)) * turning / across, shift * p * turning / (axial + shift)
        return np.array([turning, tipping / (across + shift), *gains])

    p = round_ * sin(tilt)
    spin = (across * p**2 / tan(tilt) - M * G * R * cos(tilt)) / ((axial + shift) * p)
    start, step = np.array([tilt, 0.0, p, spin]), 1e-5
    slopes = np.array([(rate(start + step * unit) - rate(start - step * unit)) / (2 * step) for unit in np.eye(4)]).T
    return spin - round_ * cos(tilt), max((root**2 for root in np.linalg.eigvals(slopes)), key=abs).real


@pytest.mark.parametrize("shape", ACROSS)
@pytest.mark.parametrize(("tilt", "round_"), [(70, 20.0), (40, 60.0), (110, 5.0), (85, 20.0), (85, 200.0)])
def test_a_wheel_that_rolls_round_a_circle(shape: str, tilt: int, round_: float) -> None:
    spin, square = grows(shape, radians(tilt), round_)
    text = SCENE.replace("70 deg", f"{tilt} deg").replace("20 rad/s", f"{round_} rad/s").replace("disc", shape)
    solution = rotsolve.solve(text)
    assert solution.answers["s"].float == pytest.approx(spin, rel=1e-9)
    assert solution.answers["L"].float == pytest.approx(square, rel=1e-6)
    assert SAME in " ".join(str(solution).split())


@pytest.mark.parametrize("shape", ACROSS)
def test_a_coin_spun_on_its_edge(shape: str) -> None:
    """ω² ≥ M g R/(I₁ + M R²); above it a lean swings with λ² = M g R/(I₁ + M R²) − ω²."""
    limit = G / (R * (1 + ACROSS[shape]))
    least = rotsolve.solve(SPUN.replace("disc", shape) + "find: {W_0: smallest W where now is stable}\n")
    assert least.answers["W_0"].float == pytest.approx(sqrt(limit), rel=1e-12)
    assert SAME in " ".join(str(least).split())
    text = SPUN.replace("disc", shape).replace("W: unknown", "W: 60 rad/s")
    period = rotsolve.solve(text + "find: {T: period of small swings of coin about now}\n").answers["T"].float
    assert period == pytest.approx(2 * pi / sqrt(60**2 - limit), rel=1e-12)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("theta: 90 deg, W: unknown, s: 0 rad/s", "theta: 80 deg, W: unknown, s: unknown", "several limits"),
        ("smallest W where", "largest W where", "stable beyond a value"),
        (", steady: true", "", "is not said to be `steady: true`"),
        ("shape: disc", "shape: sphere", "it is no thin wheel"),
        ("theta: 90 deg", "theta: 270 deg", "is not solved"),
        ("s: 0 rad/s", "s: 3 rad/s", "."),  # nothing keeps it upright then
    ],
)
def test_what_is_not_judged_so_is_refused(old: str, new: str, words: str) -> None:
    with pytest.raises(Unsolvable, match=words):
        rotsolve.solve((SPUN + "find: {W_0: smallest W where now is stable}\n").replace(old, new))
