"""What is asked of a point off the centre of what turns freely follows it round: also momenta, and points that something is `about`."""

from __future__ import annotations

import math

import pytest

from rotsolve.pipeline import solve

U, V, W, M = 2.8, 1.8, 3.9, 4.1
START = "states: {start: {body.velocity: [2.8 m/s, 1.8 m/s], body.angular_velocity: 3.9 rad/s}, end: {time: TIME s}}"
PLATE = "title: plate\nplane: horizontal\ngiven: {b: 2 m, M: 4.1 kg}\nbodies: {body: {shape: rectangle, mass: M, sides: [b, b/2]}}\n"
LOADED = """title: disc with a stone
plane: horizontal
given: {R: 0.5 m, M: 4.1 kg}
bodies: {body: {shape: disc, mass: M, radius: R, points: {P: [R/2, 0]}}, stone: {mass: M}}
connections: {glue: {weld: [body.P, stone]}}
"""


def turned(x: float, y: float, angle: float) -> tuple[float, float]:
    return x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)


@pytest.mark.parametrize("time", [0.4, 1.1])
@pytest.mark.parametrize(("corner", "x", "y"), [("corner1", -1.0, -0.5), ("corner3", 1.0, 0.5)])
def test_angular_momentum_about_a_point_that_goes_round(corner: str, x: float, y: float, time: float) -> None:
    """I ω + M r × v, r from the point to the centre."""
    scene = (
        PLATE + START.replace("TIME", str(time)) + f"\nfind: {{L: body.angular_momentum about body.{corner} at end}}\n"
    )
    a, b = turned(-x, -y, W * time)
    assert solve(scene, digits=9).answers["L"].float == pytest.approx(
        M * (4 + 1) / 12 * W + M * (a * V - b * U), rel=1e-8
    )


@pytest.mark.parametrize("time", [0.4, 1.1])
def test_momentum_and_energy_of_a_part_that_goes_round(time: float) -> None:
    """The stone goes round the common centre of mass, which goes on as it went."""
    scene = (
        LOADED
        + START.replace("TIME", str(time))
        + "\nfind: {p: stone.momentum.y at end, K: stone.kinetic_energy at end}\n"
    )
    arm, (a, b) = 0.125, turned(0.125, 0.0, W * time)
    centre = U, V + W * arm  # `velocity` is that of the disc alone
    u, v = centre[0] - W * b, centre[1] + W * a
    answers = solve(scene, digits=9).answers
    assert answers["p"].float == pytest.approx(M * v, rel=1e-8)
    assert answers["K"].float == pytest.approx(M * (u * u + v * v) / 2, rel=1e-8)
