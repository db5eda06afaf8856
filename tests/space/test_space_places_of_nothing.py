"""Places that are told as 0: where a slide leads through the axis, or begins on it; in letters as by numbers. v² = u² ± w² r²."""

from __future__ import annotations

import pytest

from rotsolve import solve
from rotsolve.algebra.notation.text import to_text

BEAD = """up: z
gravity: none
given: {GIVEN}
bodies: {arm: {mass: 0, points: {P: [BEGIN, 0, 0], O: [0, 0, 0]}}, bead: {shape: particle, mass: m}}
connections: {hub: {hinge: arm.O, along: z, angular_velocity: w}, guide: {slide: [arm.P, bead], along: x}}
states: {start: {bead.velocity relative to arm: [u, 0, 0]}, later: {bead.position relative to arm: [END, 0, 0]}}
find: {v: bead.velocity.x relative to arm in arm axes at later, N: guide.force.y at later in arm axes}
"""
LETTERS, NUMBERS = "m: kg, w: rad/s, u: m/s, r: m", "m: 2 kg, w: 3 rad/s, u: 2 m/s, r: 0.3 m"


@pytest.mark.parametrize(("begin", "end", "sense"), [("0", "r", 1), ("-r", "0", -1), ("0", "-r", 1)])
@pytest.mark.parametrize("given", [LETTERS, NUMBERS])
def test_through_the_axis(begin: str, end: str, sense: int, given: str) -> None:
    if end == "-r":
        given = given.replace("u: 2", "u: -2")
    scene = BEAD.replace("GIVEN", given).replace("BEGIN", begin).replace("END", end)
    if end == "-r" and given == LETTERS:
        scene = scene.replace("[u, 0, 0]", "[-u, 0, 0]")
    found = solve(scene)
    root = f"√(u² {'+' if sense > 0 else '−'} r² w²)"
    assert found.answers["v"].formula is not None
    assert to_text(found.answers["v"].formula) == (f"−{root}" if end == "-r" else root)
    assert all(item.holds for item in found.derivation.confirmed)
