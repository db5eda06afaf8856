"""Letters that a condition tells in space: where another value fulfils it too, no one of them is confirmed, and the largest is the largest.

The values are those of τ = ω × L by hand: of a disc on a slanted axle that is carried round, of a disc askew on its shaft.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve

CARRIED = """up: z
gravity: none
given: {m: 5 kg, r: 0.1 m, W: unknown, p: 100 rad/s, T: 3 N m}
bodies: {fork: {mass: 0, inertia: {principal: [0, 0, 0]}}, disc: {shape: disc, mass: m, radius: r}}
connections:
  post: {hinge: fork, along: z, angular_velocity: W}
  axle: {axle: [fork, disc], along: [4/5, 0, 3/5], angular_velocity: -p}
find: {x: FIND}
"""
ASKEW = """up: z
gravity: none
given: {M: 10 kg, R: 0.3 m, w: 100 rad/s, phi: unknown, Q: 500 N m}
bodies: {wheel: {shape: disc, mass: M, radius: R}}
connections: {shaft: {hinge: wheel.center, along: [sin(phi), 0, cos(phi)], angular_velocity: w}}
find: {x: FIND}
"""


def torque(rate: float) -> float:
    """τ_y = W m r² (3 W − 10 p)/25 of the carried disc, by L = I ω with ω = W ẑ − p n."""
    m, r, p = 5, 0.1, 100
    along = [0.8, 0, 0.6]
    axial, across = m * r**2 / 2, m * r**2 / 4
    own = rate * along[2] - p  # along its axis
    rest = [-rate * along[2] * along[0], rate - rate * along[2] ** 2]  # across, along x and z
    momentum_x = axial * own * along[0] + across * rest[0]
    return rate * momentum_x


def test_the_torque_by_hand_is_that_of_the_scene() -> None:
    for rate in (1.5, -2, 300):
        found = solve(CARRIED.replace("W: unknown", f"W: {rate} rad/s").replace("FIND", "axle.torque.y"))
        assert found.answers["x"].float == pytest.approx(torque(rate))


@pytest.mark.parametrize(
    ("asked", "value"),
    [
        ("largest W where size of axle.torque = T", 3),
        ("smallest W where axle.torque.y = -T", -3),
        ("largest W where axle.torque.y = -T", -3),
    ],
)
def test_the_largest_and_the_smallest_are_of_all_that_do(asked: str, value: float) -> None:
    found = solve(CARRIED.replace("FIND", asked)).answers["x"].float
    assert found is not None
    assert torque(found) == pytest.approx(value, rel=1e-6)
    a, b = 0.05 * 3 / 25, -0.05 * 10 * 100 / 25  # τ = a W² + b W
    roots = [(-b + way * math.sqrt(b * b + 4 * a * side)) / (2 * a) for way in (1, -1) for side in (3, -3)]
    beyond = [
        root for root in roots if root > 0 and ("size" in asked or torque(root) == pytest.approx(value, rel=1e-6))
    ]
    assert found == pytest.approx((max if "largest" in asked else min)(beyond), rel=1e-6)


@pytest.mark.parametrize(
    "scene",
    [
        CARRIED.replace("FIND", "W where size of axle.torque = T"),
        CARRIED.replace("FIND", "W where axle.torque.y = -T"),
        ASKEW.replace("FIND", "phi where size of shaft.torque = Q"),
        ASKEW.replace("FIND", "phi where shaft.torque.y = -Q"),
    ],
)
def test_where_several_values_do_none_is_confirmed(scene: str) -> None:
    with pytest.raises(Unsolvable, match="makes it so too"):
        solve(scene)


def test_a_value_against_the_sense_of_a_size_is_named() -> None:
    """τ_y = T with W = 334.8 rad/s, and with −1.493 rad/s."""
    found = solve(CARRIED.replace("FIND", "W where axle.torque.y = T"))
    (verdict,) = found.derivation.confirmed
    assert verdict.holds
    assert verdict.also == " = -1.49331 in SI units makes it so too"


ROTOR = """up: z
gravity: none
given: {m1: 0.6 kg, mb: 0.5 kg, r: 0.1 m, n: 30 rad/s, q: unknown}
bodies:
  rotor:
    parts:
      one: {shape: particle, mass: m1, at: [r, 0, 0]}
      b1: {shape: particle, mass: mb, at: [r*cos(q), r*sin(q), 0]}
    points: {O: [0, 0, 0]}
connections: {shaft: {hinge: rotor.O, along: z, angular_velocity: n}}
states: {now: {rotor.angle: 0 deg, TOLD}}
find: {FIND}
"""
UNSURE = "`q`, on which it may hang, has several values that fit"


def test_a_letter_on_the_way_may_have_several_values() -> None:
    """F_x = −n² r (m₁ + m cos q) = −40 N: cos q is told, and F_y = ∓42.8 N; what hangs on cos q alone is sure."""
    found = solve(ROTOR.replace("TOLD", "shaft.force.x: -40 N").replace("FIND", "F: shaft.force.y, c: rotor.cm.x"))
    verdicts = {item.name: (item.holds, item.why) for item in found.derivation.confirmed}
    assert verdicts == {"F": (None, UNSURE), "c": (True, "")}
    assert found.answers["c"].float == pytest.approx(40 / (1.1 * 900))


@pytest.mark.parametrize(("word", "degrees"), [("smallest", -153.61), ("largest", -26.39)])
def test_angles_are_compared_once_round(word: str, degrees: float) -> None:
    """F_y = −m r n² sin q = 20 N."""
    found = solve(ROTOR.replace("TOLD", "shaft.force.y: 20 N").replace("FIND", f"q: {word} q in deg"))
    assert found.answers["q"].float == pytest.approx(degrees, abs=0.01)


def test_one_of_two_angles_is_not_confirmed() -> None:
    found = solve(ROTOR.replace("TOLD", "shaft.force.y: 20 N").replace("FIND", "q: q"))
    assert [(item.holds, item.why) for item in found.derivation.confirmed] == [
        (None, "several motions fit its state: `smallest q` or `largest q` tells which")
    ]


EGG = """up: z
gravity: none
given: {I1: 0.02 kg m^2, I2: 0.05 kg m^2, I3: 0.06 kg m^2, a: unknown, c: 5 rad/s}
bodies: {egg: {mass: 2 kg, inertia: {principal: [I1, I2, I3]}, axis: z}}
connections: {pin: {ball: egg.cm}}
states:
  now:
    egg.tilt: 50 deg
    egg.precession: a
    egg.nutation: 0 rad/s
    egg.spin: c
    egg.precession_angle: 0 deg
    egg.spin_angle: 30 deg
    egg.kinetic_energy: 12 J
find: {FIND}
"""


@pytest.mark.parametrize("find", ["a: a", "w: egg.axial_rate"])
def test_a_rate_of_the_other_sense_may_have_another_size(find: str) -> None:
    found = solve(EGG.replace("FIND", find))
    assert [item.holds for item in found.derivation.confirmed] == [None]
    assert "several" in found.derivation.confirmed[0].why


def test_an_angle_to_the_other_side_is_said() -> None:
    found = solve(ROTOR.replace("TOLD", "shaft.force.x: -40 N").replace("FIND", "q: q in deg"))
    (verdict,) = found.derivation.confirmed
    assert verdict.holds
    assert verdict.also == " = −108.126° makes it so too"


def test_angles_are_looked_at_all_round() -> None:
    """What another value does is found where it is just short of half a turn: −39.0° and −177.9°."""
    scene = ROTOR.replace("[r*cos(q), r*sin(q), 0]", "[0, 0.4*r, 0]").replace("rotor.angle: 0 deg", "rotor.angle: q")
    found = solve(scene.replace("TOLD", "shaft.force.y: 20 N").replace("FIND", "F: shaft.force.x"))
    assert [(item.holds, item.why) for item in found.derivation.confirmed] == [(None, UNSURE)]


def test_of_a_blow_at_an_angle_that_to_the_other_side_is_told_too() -> None:
    """J b/2 cos q = −I ω: q and −q strike as hard across the plate."""
    solution = solve("""
title: A plate that is struck
up: z
gravity: none
given: {M: 3 kg, a: 0.6 m, b: 0.4 m, J: 2 N s, q: unknown}
bodies: {plate: {shape: rectangle, mass: M, sides: [b, a], points: {P: [b/2, 0, 0], H: [-b/2, -a/2, 0]}}}
connections: {pin: {hinge: plate.H, along: y, bearings: [0 m, a]}}
states: {before: {plate.angle: 0 deg, plate.angular_velocity: 0 rad/s}, after: {plate.angular_velocity: -3 rad/s}}
events: {hit: {impulse: J, on: plate.P, direction: [sin(q), 0, cos(q)], from: before, to: after}}
find: {q: q in deg}
""")
    (verdict,) = solution.derivation.confirmed
    assert verdict.holds
    assert "makes it so too" in verdict.also
