"""The largest and the smallest rate with which a motion comes to a place: both where it comes there in one sense alone. By hand,
v² = u² + w² (r² − r₀²).
"""

from __future__ import annotations

from math import radians, sin, sqrt

import pytest

from rotsolve import solve

BEAD = """up: z
gravity: none
given: {w: 4 rad/s, V: unknown}
bodies: {arm: {mass: 0, points: {O: [0, 0, 0], P: [30 cm, 0, 0]}}, bead: {shape: particle, mass: 1 kg}}
connections: {hub: {hinge: arm.O, along: z, angular_velocity: w}, guide: {slide: [arm.P, bead], along: x}}
states:
  start: {bead.velocity relative to arm: [FIRST m/s, 0, 0]}
  later: {bead.position relative to arm: [LAST m, 0, 0], bead.velocity relative to arm: [V, 0, 0]}
find: {V: WHICH V}
"""
ROD = """up: z
given: {w: unknown, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: 1 kg, length: 1 m}}
connections: {pin: {hinge: rod.start, along: -y}}
states: {up: {rod.angle: -90 deg, rod.angular_velocity: 3 rad/s}, turn: {rod.angle: -70 deg, rod.angular_velocity: w}}
find: {w: WHICH w}
"""


def told(scene: str, which: str) -> tuple[float, bool | None]:
    solution = solve(scene.replace("WHICH", which))
    (verdict,) = solution.derivation.confirmed
    return next(iter(solution.answers.values())).float, verdict.holds


@pytest.mark.parametrize(("first", "last"), [(0, 0.5), (1, 0.5), (-1, 0.5)])
@pytest.mark.parametrize("which", ["smallest", "largest", ""])
def test_a_bead_that_comes_by_once_has_one_rate(first: float, last: float, which: str) -> None:
    value, holds = told(BEAD.replace("FIRST", str(first)).replace("LAST", str(last)), which)
    assert value == pytest.approx(sqrt(first**2 + 16 * (last**2 - 0.09)))
    assert holds


def test_what_comes_by_twice_has_two() -> None:
    """Inward first, and outward again: the smallest is not told as the only one."""
    scene = BEAD.replace("FIRST", "-1").replace("LAST", "0.29")
    assert told(scene, "largest") == (pytest.approx(sqrt(1 + 16 * (0.29**2 - 0.09))), True)
    value, holds = told(scene, "smallest")
    assert not holds or value < 0


@pytest.mark.parametrize(("which", "sense"), [("smallest", -1), ("largest", 1)])
def test_a_rod_that_swings_back_has_both(which: str, sense: int) -> None:
    value, holds = told(ROD, which)
    assert value == pytest.approx(sense * sqrt(9 - 3 * 9.8 * (1 + sin(radians(-70)))))
    assert holds
