"""Where a rod on a hinge, let go at an angle a, turns back: as far beyond the lowest place as it began above it, −π − a.

Where it falls the other way, that is 3 π − a.
"""

from __future__ import annotations

from math import pi, radians

import pytest

from rotsolve import solve
from rotsolve.algebra.notation.text import to_text

ROD = """up: z
given: {m: kg, L: m, a: ANGLE, g: m/s^2, q: unknown}
bodies: {rod: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: rod.start, along: -y}}
states:
  up: {rod.angle: a, rod.angular_velocity: 0 rad/s}
  turn: {rod.angle: q, rod.angular_velocity: 0 rad/s}
find: {th: q}
"""


def test_the_place_is_told_by_the_angle_itself() -> None:
    """arcsin(sin a) is a between −90° and 90°, so that the answer hangs on no sign: of letters that is meant, and said."""
    derivation = solve(ROD.replace("ANGLE", "rad")).derivation
    (answer,) = derivation.answers
    assert answer.formula is not None
    assert to_text(answer.formula) == "−π − a"
    assert not answer.conditions and not answer.otherwise
    assert any("0 < a < 90°" in "".join(map(str, said)) for said in derivation.conventions)
    assert all(item.holds for item in derivation.confirmed)


def test_it_falls_the_other_way_from_beyond_the_top() -> None:
    found = solve(ROD.replace("ANGLE", "130 deg"))
    assert found.answers["th"].float == pytest.approx(3 * pi - radians(130))
    assert all(item.holds for item in found.derivation.confirmed)
