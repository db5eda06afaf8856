"""Up to the end: where forces go by speeds, what grips in a phase grips up to its end, and what slips is told to slip up to there."""

from __future__ import annotations

import math
from random import Random

import pytest

from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.verdicts import number_of
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

SLEDGE = """
title: A sledge with a crate on ice, in the wind
given: {{m: kg, M: kg, F: N, mu: number, c: kg/s, T: s, S: s}}
surfaces: {{ice: level}}
bodies: {{sledge: {{mass: M, moves: right}}, crate: {{mass: m, moves: right}}}}
connections: {{below: {{contact: [sledge, ice]}}, grip: {{contact: [crate, sledge], friction: mu}}}}
actions: {{pull: {{force: F, on: sledge, direction: right}}, air: {{force: -c*crate.velocity, on: crate, direction: right}}}}
states: {{start: at rest, mid: {{time: T}}, {later}}}
find: {{v: crate.velocity at mid}}
"""
LATER = ["end: {time: S}", "end: {crate.velocity: largest}"]
ROLLER = """
title: A sphere that is pulled at its top, in the wind
given: {m: kg, R: m, F: N, mu: number, c: kg/s, T: s, S: s}
surfaces: {floor: level}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: right}}
connections: {touch: {contact: [ball, floor], friction: mu}}
actions: {pull: {force: F, on: ball.top, direction: right}, air: {force: -c*ball.velocity, on: ball.center, direction: right}}
states: {start: at rest, mid: {time: T}, end: {time: S}}
find: {v: ball.velocity at mid}
"""
WATER = """
title: A sledge with a crate runs into water
given: {m: kg, M: kg, mu: number, u: m/s, c: kg/m, d: m}
surfaces: {ice: level}
bodies: {sledge: {mass: M, moves: right}, crate: {mass: m, moves: right}}
connections: {below: {contact: [sledge, ice]}, grip: {contact: [crate, sledge], friction: mu}}
actions: {water: {force: -c*sledge.velocity^2, on: sledge, direction: right}}
states: {start: {sledge.velocity: u, crate.velocity: u}, mid: {sledge.displacement: d}}
find: {v: sledge.velocity at mid}
"""


def left_open(found: Solution) -> str:
    return "\n".join("".join(map(str, check.words)) for check in found.checks if check.holds is None)


def followed(m: float, M: float, F: float, mu: float, c: float, T: float) -> float:
    """Speed of the crate at T, by short steps: it sticks while |F − M a| ≤ μ m g, with a of both."""
    v = w = 0.0  # of crate and sledge
    h, g = T / 4000, 9.8
    for _ in range(4000):
        common = (F - c * v) / (m + M)
        if abs(v - w) < 1e-9 and abs(F - M * common) <= mu * m * g:
            v = w = v + h * common
        else:
            v, w = v + h * (mu * m * g - c * v) / m, w + h * (F - mu * m * g) / M
    return v


@pytest.mark.sampled(2)
@pytest.mark.parametrize("later", LATER)
def test_a_grip_that_gives_way_before_a_state_is_not_held_up_to_it(later: str) -> None:
    """What is answered of numbers is what following the motion gives, wherever an answer is."""
    found = solve(SLEDGE.format(later=later), confirm=False)
    (answer,), random, told = found.derivation.answers, Random(7), 0
    for _ in range(60):
        of = {name: random.uniform(0.5, 3.0) for name in ("m", "M", "F", "c", "T", "S")}
        of |= {"mu": random.uniform(0.02, 0.3), "g": 9.8}
        case = holding(answer, of)
        value = None if case is None else number_of(case, of)
        if value is None:
            continue
        told += 1
        true = followed(**{name: of[name] for name in ("m", "M", "F", "mu", "c", "T")})
        assert math.isclose(value, true, rel_tol=3e-3), of
    assert told


@pytest.mark.sampled(2)
@pytest.mark.parametrize("text", [ROLLER, WATER])
def test_what_may_stop_slipping_is_said(text: str) -> None:
    assert "stops slipping on the way from start to mid" in left_open(solve(text, confirm=False))


LIFTED = """
title: A body that slows down under a lift that goes by its speed
given: {{m: kg, R: m, c: kg/s, a: kg/s, b: kg/m, u: m/s, w: m/s}}
surfaces: {{ice: level}}
bodies: {{sled: {body}}}
connections: {{base: {base}}}
actions:
  drag: {{force: -c*sled.velocity, on: sled.center, direction: right}}
  lift: {{force: a*sled.velocity - b*sled.velocity^2, on: sled.center, direction: up}}
states: {{start: {{sled.velocity: u}}, end: {{sled.velocity: w}}}}
find: {{N: base.normal_force at end}}
"""
SLIDES = ("{shape: rectangle, mass: m, sides: [R, R], moves: right}", "{contact: [sled, ice]}")
ROLLS = ("{shape: ring, mass: m, radius: R, moves: right}", "{rolls: [sled, ice]}")
FAN = """
title: A sledge with a fan that rubs
given: {m: kg, p: kg/m, a: kg/s, mu: number, u: m/s, w: m/s}
surfaces: {floor: level}
bodies: {sled: {mass: m, moves: right}}
connections: {b1: {contact: [sled, floor], friction: mu}}
actions: {fan: {force: a*sled.velocity - p*sled.velocity^2, on: sled, direction: right}}
states: {start: {sled.velocity: u}, end: {sled.velocity: w}}
find: {v: sled.acceleration at end}
"""


@pytest.mark.parametrize(("body", "base"), [SLIDES, ROLLS])
def test_what_presses_by_the_speed_does_so_between_two_speeds(body: str, base: str) -> None:
    """N = m g − a v + b v² is least at v = a/(2 b); a hoop's friction, which may pull it up, has no limit here."""
    found = solve(LIFTED.format(body=body, base=base), confirm=False)
    (answer,), random, told = found.derivation.answers, Random(5), set[bool]()
    for _ in range(300):
        of = {name: random.uniform(0.5, 4.0) for name in ("m", "c", "b", "u", "w")} | {"g": 9.8, "R": 0.5}
        of["a"] = random.uniform(1.0, 20.0)
        low, high = sorted((of["u"], of["w"]))
        speeds = [low + (high - low) * step / 200 for step in range(201)]
        presses = min(of["m"] * of["g"] - of["a"] * v + of["b"] * v * v for v in speeds)
        if abs(presses) > 0.05:
            told.add(of["u"] > of["w"] and presses > 0)
            assert (holding(answer, of) is not None) == (of["u"] > of["w"] and presses > 0), of
    assert told == {True, False}


@pytest.mark.exhaustive
def test_a_speed_is_reached_only_with_forces_that_lead_to_it_all_the_way() -> None:
    """From u to w the net force a v − p v² − μ m g points from one to the other throughout."""
    (answer,), random, told = solve(FAN, confirm=False).derivation.answers, Random(5), 0
    for _ in range(300):
        of = {name: random.uniform(0.3, 6.0) for name in ("m", "p", "u", "w")} | {"g": 9.8}
        of |= {"a": random.uniform(0.5, 20.0), "mu": random.uniform(0.05, 0.6)}
        speeds = [of["u"] + (of["w"] - of["u"]) * step / 200 for step in range(201)]
        way = 1 if of["w"] > of["u"] else -1
        pushes = [way * (of["a"] * v - of["p"] * v * v - of["mu"] * of["m"] * of["g"]) for v in speeds]
        if holding(answer, of) is not None:
            told += 1
            assert min(pushes) > 0, of
    assert told


def test_a_speed_that_no_case_tells_leaves_open_what_is_between() -> None:
    """A motor of given power lifts a cage against a weight: in the case in which it has no largest speed nothing tells one on the way."""
    found = solve(
        """
given: {P: W, M: kg, m: kg, p: kg, R: m, r: m, u: m/s}
bodies:
  drum: {shape: disc, mass: M, radius: R, radii: {big: R, small: r}, turns: clockwise}
  cage: {mass: m, moves: up}
  weight: {mass: p, moves: down}
connections: {axle: {axle: drum}, rope: {string: [cage, drum.big]}, tail: {string: [drum.small, weight]}}
actions: {motor: {power: P, on: drum}}
states: {start: {cage.velocity: u}, end: {cage.velocity: largest}}
find: {v: cage.velocity at end}
""",
        confirm=False,
    )
    assert {case.exact for case in found.answers["v"].branches} == {"P R/(g (m R − p r))"}
