"""A particle that a hinge holds at the end of a rod turns there as nobody asks: it is held as by a ball or a clamp.

By hand, from the level to straight down: ½ (⅓ M + m) L² w² = (½ M + m) g L, and N = m g + m L w².
"""

from __future__ import annotations

from math import sqrt

import pytest

from rotsolve import solve

ROD = """up: z
given: {m: 1 kg, M: 2 kg, L: 1 m, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: M, length: L}, bead: {shape: particle, mass: m}}
connections: {pin: {hinge: rod.start, along: -y}, held: {HELD}}
states: {start: {rod.angle: 0 deg, rod.angular_velocity: 0 rad/s}, low: {rod.angle: -90 deg}}
find: {w: rod.angular_velocity.y at low, N: held.force.z at low, v: bead.velocity.x at low}
"""
RATE = sqrt((0.5 * 2 + 1) * 9.8 * 2 / (2 / 3 + 1))


@pytest.mark.parametrize(
    "held",
    [
        "hinge: [rod.end, bead], along: y",
        "hinge: [rod.end, bead], along: x",
        "ball: [rod.end, bead]",
        "clamp: [rod.end, bead]",
    ],
)
def test_a_bead_at_the_end_of_a_rod(held: str) -> None:
    found = solve(ROD.replace("HELD", held))
    assert found.answers["w"].float == pytest.approx(RATE)
    assert found.answers["N"].float == pytest.approx(9.8 + RATE**2)
    assert found.answers["v"].float == pytest.approx(-RATE)
    assert all(item.holds for item in found.derivation.confirmed)


def test_one_of_which_the_scene_says_how_it_turns_is_left_on_its_hinge() -> None:
    scene = ROD.replace("HELD", "hinge: [rod.end, bead], along: y").replace(
        "rod.angular_velocity: 0 rad/s", "rod.angular_velocity: 0 rad/s, bead.angular_velocity: 3 rad/s"
    )
    found = solve(scene.replace("N: held.force.z at low, ", "W: bead.angular_velocity.y at start in rod axes, "))
    assert abs(found.answers["W"].float or 0.0) == pytest.approx(3)


def test_a_particle_that_is_hinged_beside_itself_swings() -> None:
    """A point of its own, away from it: a pendulum, α = g cos φ/L."""
    scene = """up: z
given: {L: 0.5 m, g: 9.8 m/s^2}
bodies: {bob: {shape: particle, mass: 1 kg, points: {O: [-L, 0, 0]}}}
connections: {pin: {hinge: bob.O, along: -y}}
states: {start: {bob.velocity: [0, 0, 0]}}
find: {F: pin.force.z at start, a: bob.acceleration.z at start}
"""
    found = solve(scene)
    assert found.answers["a"].float == pytest.approx(-9.8)
    assert found.answers["F"].float == pytest.approx(0)
