"""Joined on wires: what a wire turns keeps its twist as an event joins something to it, whichever of both is named first."""

from __future__ import annotations

from math import sqrt

import pytest

from rotsolve.pipeline import solve
from rotsolve.solution import Solution

DISC, RING, WIRE, COIL, PHI = 2.0, 1.0, 3.0, 5.0, 0.6
GIVEN = "plane: horizontal\ngiven: {I: 2 kg m^2, K: 1 kg m^2, D: 3 N m/rad, C: 5 N m/rad, phi: 0.6 rad, w: 9 rad/s}\n"
BODIES = "bodies: {disc: {inertia: I}, ring: {inertia: K}}\n"
ONE = """
connections: {axle: {axle: [disc, ring]}, wire: {torsion: disc, stiffness: D}}
states: {start: {AT: phi, at rest: all}, mid: {AT: phi/2}, joined: {}, home: {AT: 0}, late: {AT: -phi/2}}
events: {drop: {joins: [PAIR], from: mid, to: joined}}
find: {a: OWNER.angular_velocity at joined, b: OWNER.angular_velocity at home, c: OWNER.angular_velocity at late}
"""
TWO = """
connections: {axle: {axle: [disc, ring]}, wire: {torsion: disc, stiffness: D}, coil: {torsion: ring, stiffness: C}}
states: {start: {ONE: phi, disc.angular_velocity: -w, ring.angular_velocity: 0OTHER}, joined: {}, home: {ONE: 0}}
events: {drop: {joins: [PAIR], from: start, to: joined}}
find: {a: disc.angular_velocity at joined, b: disc.angular_velocity at home}
"""
PAIRS = ("disc, ring", "ring, disc")


def confirmed(text: str, given: str = GIVEN) -> Solution:
    solution = solve(given + BODIES + text.lstrip(), digits=10)
    assert all(item.holds for item in solution.derivation.confirmed)
    return solution


def value(solution: Solution, name: str) -> float:
    found = solution.answers[name].value
    assert found is not None
    return float(found)


@pytest.mark.parametrize("owner", ["disc", "ring"])
@pytest.mark.parametrize("told", ["wire.angle", "disc.angle"])
@pytest.mark.parametrize("pair", PAIRS)
def test_the_wire_stays_twisted(pair: str, told: str, owner: str) -> None:
    """I w² = 3 D φ²/4, (I + K) a = I w, (I + K) b² = (I + K) a² + D φ²/4, and as much less at the other side."""
    given = GIVEN.replace(", C: 5 N m/rad", "").replace(", w: 9 rad/s", "")
    found = confirmed(ONE.replace("PAIR", pair).replace("AT", told).replace("OWNER", owner), given)
    a = -DISC * sqrt(0.75 * WIRE * PHI**2 / DISC) / (DISC + RING)
    b = -sqrt(a**2 + WIRE * PHI**2 / 4 / (DISC + RING))
    assert [value(found, name) for name in "abc"] == pytest.approx([a, b, a])


@pytest.mark.parametrize("pair", PAIRS)
def test_a_wire_whose_disc_has_no_told_angle_when_it_is_joined(pair: str) -> None:
    """At the turning point nothing says how far it is twisted: D a² = I w² up to there, (I + K) b² = D a² after it."""
    text = """
connections: {axle: {axle: [disc, ring]}, wire: {torsion: disc, stiffness: D}}
states:
  start: {wire.angle: 0, disc.angular_velocity: w, at rest: ring}
  mid: {disc.angular_velocity: 0}
  joined: {}
  home: {wire.angle: 0}
events: {drop: {joins: [PAIR], from: mid, to: joined}}
find: {a: wire.angle at mid, b: disc.angular_velocity at home}
"""
    found = confirmed(text.replace("PAIR", pair), GIVEN.replace(", C: 5 N m/rad, phi: 0.6 rad", ""))
    assert [value(found, name) for name in "ab"] == pytest.approx(
        [9 * sqrt(DISC / WIRE), -9 * sqrt(DISC / (DISC + RING))]
    )


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize(
    ("one", "other"), [("wire.angle", "coil.angle"), ("disc.angle", "ring.angle"), ("wire.angle", "")]
)
def test_two_wires_keep_the_twist_of_each(pair: str, one: str, other: str) -> None:
    """E₁ = ½ (I + K) a² + ½ D φ² + ½ C θ², and once the first is straight ½ C (θ − φ)²; what nothing is said of stands as drawn."""
    theta = 0.1 if other else 0.0
    text = TWO.replace("PAIR", pair).replace("ONE", one).replace("OTHER", f", {other}: 0.1 rad" if other else "")
    found = confirmed(text)
    a = -DISC * 9 / (DISC + RING)
    b = -sqrt(a**2 + (WIRE * PHI**2 + COIL * theta**2 - COIL * (theta - PHI) ** 2) / (DISC + RING))
    assert [value(found, name) for name in "ab"] == pytest.approx([a, b])
