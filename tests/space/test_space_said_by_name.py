"""Answered, or refused by its name: an extreme tilt after a state on the way, two steady states, an axis that goes round nothing."""

from __future__ import annotations

import re
from math import acos, cos, degrees, radians, sin, sqrt

import pytest

from rotsolve import Unsolvable, solve

PENDULUM = """title: x
up: z
given: {m: 0.4 kg, l: 0.8 m, Om: RATE}
bodies: {p: {shape: rod, mass: m, length: l}}
connections: {b: {ball: p.start}}
states:
  start: {p.tilt: START, p.precession: Om, p.nutation: 0 rad/s}
  mid: {p.tilt: MID}
  end: {p.tilt: WORD}
find: {th: p.tilt at end in deg}
"""


@pytest.mark.parametrize(
    ("rate", "start", "mid", "word"), [(-3, 100, 140, "largest"), (-3, 75, 140, "largest"), (6, 150, 145, "smallest")]
)
def test_an_extreme_tilt_after_a_state_on_the_way(rate: float, start: float, mid: float, word: str) -> None:
    """½ I Ω² sin²θ₀ (u₀ + u) = ½ m g l (u² − 1), u = cos θ: from the energy and the angular momentum about the vertical."""
    scene = PENDULUM.replace("RATE", f"{rate} rad/s").replace("START", f"{start} deg").replace("MID", f"{mid} deg")
    found = solve(scene.replace("WORD", word))
    u, i, w = cos(radians(start)), 0.4 * 0.8**2 / 3, 0.4 * 9.8 * 0.4
    k = i * rate**2 * sin(radians(start)) ** 2 / (4 * w)
    assert found.answers["th"].float == pytest.approx(degrees(acos(k - sqrt(k**2 + 2 * k * u + 1))))
    assert all(item.holds for item in found.derivation.confirmed)


BAR = """title: x
up: z
given: {m: 2 kg, l: 0.8 m, W: 6 rad/s, q: unknown}
bodies: {shaft: {mass: 0, points: {O: [0, 0, 0]}}, bar: {shape: rod, mass: m, length: l}}
connections: {post: {hinge: shaft.O, along: z, angular_velocity: W}, pin: {hinge: [shaft.O, bar.start], along: "-y"}}
states: {round: {bar.angle: q, steady: true}, down: {bar.angle: -90 deg, steady: true}}
find: {q: largest q in deg, T: period of small swings of bar about round}
"""


def test_two_steady_motions_of_a_bar_do_not_follow_each_other() -> None:
    with pytest.raises(Unsolvable, match="keeps its `angle` from `round` on, which is steady"):
        solve(BAR)


DISC = """title: x
up: z
gravity: none
bodies: {b: {shape: disc, mass: 1 kg, radius: 0.1 m}}
states: {now: {b.angular_velocity: [WX, 0, W]}}
find: {p: ASKED at now}
"""


@pytest.mark.parametrize(
    ("across", "rate", "asked", "words"),
    [
        ("0 rad/s", "5 rad/s", "b.precession", "turns about its own axis alone"),
        ("0 rad/s", "5 rad/s", "b.spin", "turns about its own axis alone"),
        ("0 rad/s", "0 rad/s", "b.precession", "does not turn"),
        ("0 rad/s", "0 rad/s", "b.tilt", "does not turn"),
        ("0 rad/s", "0 rad/s", "b.period", "does not turn"),
    ],
)
def test_an_axis_that_goes_round_nothing(across: str, rate: str, asked: str, words: str) -> None:
    scene = DISC.replace("WX", across).replace("W]", f"{rate}]").replace("ASKED", asked)
    with pytest.raises(Unsolvable, match=words):
        solve(scene)


GYROSCOPE = """title: x
up: z
gravity: none
bodies:
  outer: {mass: 1 kg, inertia: {principal: [0.004 kg m^2, 0.004 kg m^2, 0.004 kg m^2]}, points: {O: [0, 0, 0]}}
  inner: {mass: 1 kg, inertia: {principal: [0.001 kg m^2, 0.002 kg m^2, 0.0015 kg m^2]}}
  rotor: {mass: 1 kg, inertia: {principal: [0.002 kg m^2, 0.002 kg m^2, 0.003 kg m^2]}, axis: z}
connections:
  v: {hinge: outer.O, along: z}
  h: {hinge: [outer.O, inner.center], along: x}
  a: {axle: [inner, rotor], along: y}
states: {now: {inner.angle: 25 deg, outer.angular_velocity: 0 rad/s, rotor.spin: 300 rad/s, steady: true}}
find: {T: period of small swings of inner about now}
"""


def test_swings_of_a_gyroscope_that_leans_on_which_no_torque_acts_are_confirmed() -> None:
    assert all(item.holds for item in solve(GYROSCOPE).derivation.confirmed)


SHAFT = """title: x
up: z
given: {m: 2 kg, M0: 3 N m}
bodies: {rotor: {shape: disc, mass: m, radius: 0.2 m}}
connections: {shaft: {hinge: rotor.center, along: z}}
actions: {c: {couple: M0, on: rotor, direction: [0, 0.9063077870366499, 0.42261826174069944]}}
states: {now: {rotor.angular_velocity: 0 rad/s}}
find: {al: rotor.angular_acceleration.z}
"""


def test_a_direction_by_long_decimals_stands_in_formulas_by_letters() -> None:
    found = solve(SHAFT)
    assert found.answers["al"].float == pytest.approx(3 * 0.42261826174069944 / 0.04)
    assert "9063077870366499/" not in str(found)
    assert all(item.holds for item in found.derivation.confirmed)


MAST = """title: x
up: z
given: {M: 30 kg, m1: 1 m, F: 100 N}
bodies:
  mast: {shape: rod, mass: M, length: 2*m1, turned: {about: y, by: -90 deg}}
  c1: {shape: rod, mass: 0, length: sqrt(8)*m1}
  c2: {shape: rod, mass: 0, length: sqrt(8)*m1}
  c3: {shape: rod, mass: 0, length: sqrt(8)*m1}
connections:
  foot: {ball: FOOT}
  a1: {ball: [mast.end, c1.start]}
  b1: {ball: [[2*m1, 0, 0], c1.end]}
  a2: {ball: [mast.end, c2.start]}
  b2: {ball: [[0, 2*m1, 0], c2.end]}
  a3: {ball: [mast.end, c3.start]}
  b3: {ball: [[-1.2*m1, -1.6*m1, 0], c3.end]}
actions: {f: {force: [F, 0, 0], on: mast.center}}
states: {rest: {balance: true}}
find: {T: size of b1.force at rest}
"""


@pytest.mark.parametrize(
    ("foot", "words"),
    [("[[0, 0, 0], mast.start]", "can not tell these forces apart"), ("mast.start", r"`\[\[x, y, z\], mast\.start\]`")],
)
def test_a_mast_on_three_cables(foot: str, words: str) -> None:
    """Of it nothing tells the three pulls apart; and its own place is said to lack where that of a cable is told."""
    with pytest.raises(Unsolvable) as refused:
        solve(MAST.replace("FOOT", foot))
    assert re.search(words, str(refused.value))


def test_a_rate_told_beside_the_place_to_which_it_belongs() -> None:
    """That the rate belongs to another place is said where both are told."""
    scene = """title: x
up: z
bodies: {gate: {shape: rectangle, mass: 20 kg, sides: [1 m, 2 m], points: {A: [-0.5 m, 0, 0]}}}
connections: {post: {hinge: gate.A, along: [0, 4/5, 3/5]}}
states: {up: {gate.angle: 0 deg, gate.angular_velocity: 0 rad/s}, low: {gate.angle: 90 deg, gate.angular_velocity: 2 rad/s}}
find: {F: post.force at low}
"""
    with pytest.raises(Unsolvable) as refused:
        solve(scene)
    assert refused.value.fault.help == "by all else that is told `gate.angle` would be 13.37° at `low`, not 90°"
