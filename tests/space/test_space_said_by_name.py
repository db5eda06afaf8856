"""Answered, or refused by its name: an extreme tilt after a state on the way, two steady states, an axis that goes round nothing."""

from __future__ import annotations

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
