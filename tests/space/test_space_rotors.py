"""Rotors that turn freely on axles which a swinging body carries: ω along the axle stays, and energy tells how fast it swings.

By hand: 0 = ½ I w² + ½ m L² w² + ½ A (ω_across² − …) − …; every answer also by the assembly, which follows the motion.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import solve

SWING = """up: z
given: {{M: 1.5 kg, m: 0.6 kg, L: 0.8 m, r: 0.1 m, g: 9.8 m/s^2}}
bodies:
  arm: {{shape: rod, mass: M, length: L, points: {{P: [L/4, 0, 0]}}}}
  disc: {{shape: disc, mass: m, radius: r}}
  lump: {{shape: particle, mass: m}}
connections:
  hub: {{hinge: arm.start, along: y}}
  ax: {{axle: [arm.end, disc], along: {along}}}
  fast: {{clamp: [arm.P, lump]}}
states: {{start: {{arm.angle: 0 deg, arm.angular_velocity: 0 rad/s, disc.spin: {spin} rad/s}}, low: {{arm.angle: 90 deg}}}}
find: {{w: arm.angular_velocity.y at low, s: disc.spin at low}}
"""
WHOLE, REACH, ROUND = 1.5, 0.8, 0.1
FALL = 1.5 * 9.8 * 0.4 + 0.6 * 9.8 * 0.8 + 0.6 * 9.8 * 0.6  # the weights' work, M g L/2 + m g L + m g 3 L/4
SWEPT = 1.5 * 0.64 / 3 + 0.6 * 0.64 + 0.6 * 0.36  # inertia of rod, disc and lump about the hinge, the disc as a point
ACROSS = (
    0.6 * 0.01 / 4
)  # of the disc about a diameter, which goes round with the arm where the axle lies across the hinge


@pytest.mark.parametrize(
    ("along", "spin", "turned", "lost"),
    [
        ("y", 0, 0.0, 1.0),  # it does not turn in space: it keeps its direction like the cabin of a big wheel
        ("y", 5, 0.0, 1.0),
        ("x", 50, ACROSS, 0.0),
        ("z", -7, ACROSS, 0.0),
        ("[3, 4, 0]", 4, 0.36 * ACROSS, 0.8),
    ],
)
def test_what_carries_a_rotor_swings_as_if_that_kept_its_turn(
    along: str, spin: int, turned: float, lost: float
) -> None:
    """½ (I + A sin²) w² = the work, A about a diameter and sin the angle of the axle from the hinge; s = s₀ − w · n."""
    derivation = solve(SWING.format(along=along, spin=spin)).complete().derivation
    rate = math.sqrt(2 * FALL / (SWEPT + turned))
    found = [answer.value.float for answer in derivation.answers if answer.value is not None]
    assert found == pytest.approx([rate, spin - lost * rate], rel=1e-10)
    assert [item.holds for item in derivation.confirmed] == [True, True]


def test_a_rotor_on_a_driven_arm_keeps_its_rate_in_space() -> None:
    """s₀ + 2 rad/s = s + 3 rad/s."""
    scene = """up: z
bodies: {arm: {shape: rod, mass: 1 kg, length: 1 m}, disc: {shape: disc, mass: 1 kg, radius: 0.1 m}}
connections:
  hub: {hinge: arm.start, along: z, angular_velocity: 2 rad/s + (1 rad/s^2)*time}
  ax: {axle: [arm.end, disc], along: z}
states: {a: {disc.spin: 10 rad/s}, b: {time: 1 s}}
find: {s: disc.spin at b, w: disc.angular_velocity.z at b}
"""
    answers = solve(scene).complete().derivation.answers
    assert [answer.value.float for answer in answers if answer.value] == pytest.approx([9, 12])
