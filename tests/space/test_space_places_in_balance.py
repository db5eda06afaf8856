"""Places sought in balance, at rest, with rates told and in a steady motion: the smallest may be negative, and what else fits is told.

By hand: a level boom 2 m long, hinged at h, has under its end a strut 1.3 m long, whose foot stands 1.2 m nearer and at u = h ± 0.5 m; it
carries half of the weight, F_z = −M g/2, and pushes along itself, F_x/F_z = 1.2 m/(h − u).
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Solution, Unsolvable, solve

BOOM = """up: z
given: {M: 3 kg, u: unknown, g: 9.8 m/s^2}
bodies: {boom: {shape: rod, mass: M, length: 2 m}, strut: {shape: rod, mass: 0, length: 1.3 m}}
connections:
  h: {hinge: [[0 m, 0 m, HEIGHT m], boom.start], along: "-y"}
  p: {ball: [[0.8 m, 0 m, u], strut.start]}
  q: {ball: [boom.end, strut.end]}
states: {rest: {boom.angle: 0 deg, STILL}}
find: {u: ASKED, F: q.force.x at rest}
"""
STILL = (
    "balance: true",
    "boom.angular_velocity: 0 rad/s",
    "boom.angular_velocity: 0 rad/s, boom.angular_acceleration: 0 rad/s^2",
)
LUMP = """up: z
gravity: none
given: {m: 0.6 kg, M: 2 kg, L: 1 m, n: 10 rad/s, x: unknown, d: 0.3 m}
bodies:
  rod:
    points: {O: [d, 0, 0]}
    parts:
      bar: {shape: rod, mass: M, start: [0, 0, 0], end: [L, 0, 0]}
      lump: {shape: particle, mass: m, at: [x, 0, 0]}
connections: {pin: {hinge: rod.O, along: z, angular_velocity: n}}
states: {now: {rod.angle: 0 deg, rod.kinetic_energy: 25 J, steady: true}}
find: {x: ASKED}
"""
AWAY = math.sqrt((0.5 - 2 / 12 - 2 * 0.2**2) / 0.6)
PUSHED = """up: z
given: {M: 3 kg, F: unknown, c: 10 N, g: 9.8 m/s^2}
bodies: {boom: {shape: rod, mass: M, length: 2 m}}
actions: {f: {force: [0, 0, (F*F - 3*F*c)/c], on: boom.end}, g1: {force: F, on: boom.start, direction: x}}
connections: {h: {hinge: boom.start, along: "-y"}}
states: {rest: {boom.angle: 0 deg, balance: true}}
find: {F: ASKED}
"""


def said(solution: Solution) -> dict[str, tuple[bool | None, str]]:
    return {one.name: (one.holds, one.also) for one in solution.derivation.confirmed}


@pytest.mark.parametrize("still", STILL)
@pytest.mark.parametrize("height", [-1.0, 0.0, 0.3, 1.0])
@pytest.mark.parametrize(("word", "way"), [("smallest", -1), ("largest", 1)])
def test_the_extreme_of_a_place_is_told_by_its_value(still: str, height: float, word: str, way: int) -> None:
    text = BOOM.replace("HEIGHT", str(height)).replace("STILL", still).replace("ASKED", f"{word} u")
    found = solve(text)
    assert found.answers["u"].float == pytest.approx(height + way * 0.5)
    assert found.answers["F"].float == pytest.approx(way * 0.5 * 3 * 9.8 * 1.2 / 0.5)
    assert said(found) == {"u": (True, ""), "F": (True, "")}


@pytest.mark.parametrize("still", STILL)
def test_a_plain_place_has_the_other_one_beside_it(still: str) -> None:
    found = solve(BOOM.replace("HEIGHT", "0.3").replace("STILL", still).replace("ASKED", "u"))
    assert found.answers["u"].float == pytest.approx(0.8)
    assert said(found)["u"] == (True, " = -0.2 in SI units makes it so too")


@pytest.mark.parametrize("height", ["-1", "1"])
def test_two_places_of_one_sign_are_refused(height: str) -> None:
    with pytest.raises(Unsolvable, match="several motions are possible, and nothing tells which is meant"):
        solve(BOOM.replace("HEIGHT", height).replace("STILL", STILL[0]).replace("ASKED", "u"))


@pytest.mark.parametrize(("asked", "way"), [("x", 1), ("largest x", 1), ("smallest x", -1)])
def test_places_in_a_steady_motion(asked: str, way: int) -> None:
    found = solve(LUMP.replace("ASKED", asked))
    assert found.answers["x"].float == pytest.approx(0.3 + way * AWAY)
    beside = f" = {0.3 - AWAY:g} in SI units makes it so too" if asked == "x" else ""
    assert said(found)["x"] == (True, beside)


@pytest.mark.parametrize("asked", ["F", "smallest F", "largest F"])
def test_a_force_is_a_size_and_one_against_it_is_told(asked: str) -> None:
    found = solve(PUSHED.replace("ASKED", asked))
    roots = [15 + way * math.sqrt(225 + 10 * 3 * 9.8 / 2) for way in (-1, 1)]  # F² − 3 c F = ½ c M g
    assert found.answers["F"].float == pytest.approx(roots[1])
    beside = "" if asked == "largest F" else f" = {roots[0]:g} in SI units makes it so too"
    assert said(found)["F"] == (True, beside)


@pytest.mark.parametrize(("asked", "holds"), [("q", None), ("largest q", True), ("smallest q", None)])
def test_of_two_angles_in_balance_a_plain_one_is_not_confirmed(asked: str, holds: bool | None) -> None:
    """Only at the upper one, M g (L/2) cos q = τ with q > 0, a rod that is displaced comes back."""
    text = """up: z
given: {M: 3 kg, q: unknown, tau: 10 N m, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: M, length: 1 m}}
connections: {h: {hinge: rod.start, along: y}}
actions: {m1: {couple: [0, -tau, 0], on: rod}}
states: {rest: {rod.angle: q, balance: true}}
find: {q: ASKED}
"""
    found = solve(text.replace("ASKED", asked))
    assert abs(found.answers["q"].float) == pytest.approx(math.acos(10 / (3 * 9.8 / 2)))
    assert said(found)["q"][0] is holds
