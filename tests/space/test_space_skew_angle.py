"""The angle between two vectors is told without what both have in common, where its sign is known; how the rod leans is what it comes to.

Two masses at ±l (cos α, 0, sin α) about z: L = 2 m l² ω cos α (−sin α, 0, cos α), which is at α from the axis.
"""

from __future__ import annotations

from math import radians

import pytest

from rotsolve import Unsolvable, solve
from rotsolve.algebra.notation.text import to_text

SKEW = """up: z
gravity: none
given: {GIVEN}
bodies:
  rod: {parts: {one: {mass: m, at: [l*cos(a), 0, l*sin(a)]}, two: {mass: m, at: [-l*cos(a), 0, -l*sin(a)]}}}
connections: {shaft: {hinge: rod, along: z, angular_velocity: w}}
find: {q: angle of rod.angular_momentum from rod.angular_velocity}
"""
CASES = {
    "m: kg, l: m, a: 40 deg, w: 3 rad/s": ("a", 40),
    "m: 2 kg, l: 1 m, a: 40 deg, w: rad/s": ("a", 40),
    "m: kg, l: m, a: 40 deg, w: -3 rad/s": ("a", 40),
    "m: kg, l: m, a: 140 deg, w: 3 rad/s": ("atan2(sin a, −cos a)", 40),
    "m: kg, l: m, a: -40 deg, w: 3 rad/s": ("−a", 40),
    "m: kg, l: m, a: rad, w: rad/s": ("atan2(|cos a| |sin a|, cos² a)", None),
}


@pytest.mark.parametrize("given", CASES)
def test_what_both_vectors_have_in_common_falls_out(given: str) -> None:
    form, value = CASES[given]
    found = solve(SKEW.replace("GIVEN", given)).answers["q"]
    assert found.formula is not None
    assert to_text(found.formula) == form
    if value is not None:
        assert found.float == pytest.approx(radians(value), rel=1e-9)


NO_MOMENTUM = ("a: 40 deg, w: 0 rad/s", "a: 90 deg, w: 2 rad/s")


@pytest.mark.parametrize(
    "given", [f"{body}, {how}" for body in ("m: 2 kg, l: 1 m", "m: kg, l: m") for how in NO_MOMENTUM]
)
def test_a_common_factor_that_is_nothing_stays(given: str) -> None:
    """No angle from a vector that is nothing, though without the factor there would be one."""
    with pytest.raises(Unsolvable, match="has no value"):
        solve(SKEW.replace("GIVEN", given))


@pytest.mark.parametrize(("speed", "given"), [("u", "u: m/s"), ("u", "u: 3 m/s"), ("u", "u: -3 m/s")])
def test_an_angle_along_an_axis_is_a_right_one(speed: str, given: str) -> None:
    """In the middle of a turntable the acceleration is that of Coriolis alone, across the way."""
    scene = f"""up: z
gravity: none
given: {{w: rad/s, {given}}}
bodies: {{table: {{shape: disc, mass: 1 kg, radius: 1 m}}, bead: {{shape: particle, mass: 1 kg}}}}
connections: {{axis: {{hinge: table.center, along: z, angular_velocity: w}}}}
actions: {{hold: {{force: any, on: bead}}}}
states:
  now:
    bead.position relative to table: [0, 0, 0]
    bead.velocity relative to table: [{speed}, 0, 0]
    bead.acceleration relative to table: [0, 0, 0]
find: {{q: angle of bead.velocity from bead.acceleration}}
"""
    found = solve(scene)
    assert found.answers["q"].formula is not None
    assert to_text(found.answers["q"].formula) == "π/2"
    assert all(item.holds for item in found.derivation.confirmed)
