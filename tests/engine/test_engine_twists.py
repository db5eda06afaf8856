"""A torsion spring, and a couple that speaks of an angle, twist by the `angle` of their body: of what hangs that of its centre of mass."""

from __future__ import annotations

import math

import pytest

from rotsolve.pipeline import solve

PLATE = "{shape: rectangle, mass: M, sides: [b, b/2]}"
HAMMER = "{parts: {stick: {shape: rod, mass: M, start: [0, 0], end: [b, 0]}, head: {mass: M, at: [b, b/2]}}, points: {grip: [0, 0]}}"
ROD = "{shape: rod, mass: M, length: b}"
BODIES = {  # with where it hangs, the distance of its centre of mass from there over b, its moment of inertia over M b², its mass over M
    "plate at a corner": (PLATE, "corner1", math.hypot(1 / 2, 1 / 4), 5 / 12, 1),
    "plate at another": (PLATE, "corner3", math.hypot(1 / 2, 1 / 4), 5 / 12, 1),
    "hammer": (HAMMER, "grip", math.hypot(3 / 4, 1 / 4), 1 / 3 + 5 / 4, 2),
    "rod": (ROD, "start", 1 / 2, 1 / 3, 1),
}
TWISTS = {
    "wire": "connections: {{pin: {{hinge: body.{at}}}, wire: {{torsion: body, stiffness: k}}}}",
    "couple": "connections: {{pin: {{hinge: body.{at}}}}}\nactions: {{wire: {{couple: -k*body.angle, on: body}}}}",
}


@pytest.mark.parametrize("angle", [30, -100])
@pytest.mark.parametrize("twist", TWISTS)
@pytest.mark.parametrize("name", BODIES)
def test_twist_is_the_angle_of_the_body(name: str, twist: str, angle: int) -> None:
    """κ θ and the weight of the centre of mass, which lies at θ, turn it."""
    body, at, arm, inertia, mass = BODIES[name]
    scene = f"""
given: {{M: 3 kg, b: 0.4 m, k: 20 N m/rad, g: 9.8 m/s^2}}
bodies: {{body: {body}}}
{TWISTS[twist].format(at=at)}
states: {{start: {{body.angle: {angle} deg, at rest: all}}}}
find: {{alpha: body.angular_acceleration}}
"""
    solution = solve(scene, digits=10)
    M, b, k, g, theta = 3, 0.4, 20, 9.8, math.radians(angle)
    expected = (-k * theta - mass * M * g * arm * b * math.cos(theta)) / (inertia * M * b**2)
    assert solution.answers["alpha"].float == pytest.approx(expected, rel=1e-8)
