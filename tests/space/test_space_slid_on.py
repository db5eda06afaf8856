"""What slides from state to state: a bead on a rod that turns freely, a block on a slanted slide."""

from __future__ import annotations

from math import cos, radians, sqrt

import pytest

import rotsolve
from rotsolve.core.faults import NeverReached, Unsolvable

FREE_ROD = """title: x
up: z
given: {m: 0.5 kg, I: 0.2 kg m^2, w: -6 rad/s, r1: 0.3 m, r2: OUT, u: SPEED}
bodies:
  arm: {mass: 2 kg, inertia: {principal: [I, I, I]}, points: {O: [0, 0, 0], P: [r1, 0, 0]}}
  bead: {shape: particle, mass: m}
connections: {hub: {hinge: arm.O, along: z}, g: {slide: [arm.P, bead], along: x}}
states:
  start: {arm.angular_velocity: w, "bead.velocity relative to arm": [u, 0, 0]}
  out: {"bead.position relative to arm": [r2, 0, 0]}
find: {W: arm.angular_velocity.z at out, v: bead.velocity.x relative to arm in arm axes at out}
"""


@pytest.mark.parametrize(("u", "r"), [(1.0, 0.9), (-1.0, 0.9), (-5.0, -0.2)])
def test_a_bead_on_a_rod_that_turns_freely(u: float, r: float) -> None:
    """(I + m r²) ω stays, and ½ (I + m r²) ω² + ½ m u²; it comes outward, whichever way it set out, or through the hub."""
    found = rotsolve.solve(FREE_ROD.replace("OUT", f"{r} m").replace("SPEED", f"{u} m/s"))
    start, end = 0.2 + 0.5 * 0.3**2, 0.2 + 0.5 * r**2
    rate = -6 * start / end
    speed = sqrt(u**2 + (start * 36 - end * rate**2) / 0.5)
    assert found.answers["W"].float == pytest.approx(rate)
    assert found.answers["v"].float == pytest.approx(speed if r > 0 else -speed)
    assert all(item.holds for item in found.derivation.confirmed)


def test_it_turns_back_before_the_hub() -> None:
    with pytest.raises(NeverReached):
        rotsolve.solve(FREE_ROD.replace("OUT", "-0.2 m").replace("SPEED", "-1 m/s"))


SLANT = """title: x
up: z
given: {M: 1 kg, be: 30 deg, u: 3 m/s}
bodies: {b: {shape: cuboid, mass: M, sides: [0.1 m, 0.2 m, 0.1 m]}}
connections: {g: {slide: b.center, along: [cos(be), 0, -sin(be)]}}
states:
  now: {b.velocity: [UP*cos(be), 0, -UP*sin(be)], b.position: [FROM*cos(be), 0, -FROM*sin(be)]}
  later: {b.position: [TO*cos(be), 0, -TO*sin(be)]}
find: {v: b.velocity.x at later}
"""


@pytest.mark.parametrize(
    ("up", "start", "end", "down"),
    [("0*u", 0.0, 2.0, True), ("0*u", 1.0, 2.0, True), ("-u", 0.0, -0.5, False), ("-u", 1.0, 2.0, True)],
)
def test_a_block_on_a_slanted_slide(up: str, start: float, end: float, down: bool) -> None:
    """v² = v₀² + 2 g s sin β, s the way down; thrown up it comes to a place above going up, to one below going down."""
    scene = SLANT.replace("UP", up).replace("FROM", f"{start} m").replace("TO", f"({end} m)")
    found = rotsolve.solve(scene)
    speed = sqrt((9 if "-" in up else 0) + 9.8 * (end - start))
    assert found.answers["v"].float == pytest.approx((1 if down else -1) * speed * cos(radians(30)))
    assert all(item.holds for item in found.derivation.confirmed)


def test_it_is_never_as_high_as_it_does_not_come() -> None:
    with pytest.raises(Unsolvable, match="`later` is never reached from `now`"):
        rotsolve.solve(SLANT.replace("UP", "-u").replace("FROM", "0 m").replace("TO", "(-2 m)"))
