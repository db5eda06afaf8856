"""What a state says to stick or to roll goes on so: where friction is too weak its slip only turns round, and that is refused by name."""

from __future__ import annotations

from math import radians, tan

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

CLUTCH = """
plane: horizontal
given: {I: 1 kg m^2, K: 2 kg m^2, w: W, v: V, tau: 3 N m, Q: LOAD}
bodies: {a: {inertia: I}, b: {inertia: K}}
connections: {shaft: {axle: [a, b]}, c: {clutch: [a, b], friction_torque: tau}}
actions: {load: {couple: -Q, on: b}}
states: {start: {a.angular_velocity: w, b.angular_velocity: v}, one: {c: sticks}}
find: {t: time from start to one, w1: b.angular_velocity at one}
"""
PLANK = """
given: {m: 1 kg, M: 3 kg, mu: 0.2, u: U, v: V, F: LOAD}
surfaces: {ice: level}
bodies: {block: {mass: m, moves: right}, plank: {mass: M, moves: right}}
connections: {below: {contact: [plank, ice]}, grip: {contact: [block, plank], friction: mu}}
actions: {pull: {force: F, on: plank, direction: right}}
states: {start: {block.velocity: u, plank.velocity: v}, one: {grip: sticks}}
find: {t: time from start to one, w: block.velocity at one}
"""
SLOPE = """
given: {m: 1 kg, R: 0.1 m, theta: 30 deg, mu: MU, v: 4 m/s}
surfaces: {hill: {slope: theta}}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: up}}
connections: {base: {contact: [ball, hill], friction: mu}}
states: {start: {ball.velocity: v, ball.angular_velocity: 0}, roll: {base: rolls}}
find: {t: time from start to roll, u: ball.velocity at roll}
"""
RIMS = """
plane: horizontal
given: {I: 1 kg m^2, K: 1 kg m^2, R: 0.5 m, w: 20 rad/s, mu: 0.3, P: 20 N, Q: LOAD}
bodies: {a: {inertia: I, radius: R, turns: clockwise}, b: {inertia: K, radius: R}}
connections: {left: {axle: a}, right: {axle: b}, touch: {contact: [a.rim, b.rim], friction: mu, press: P}}
actions: {load: {couple: Q, on: b}}
states: {start: {a.angular_velocity: w, b.angular_velocity: 0}, one: {touch: rolls}}
find: {t: time from start to one}
"""


def held(text: str) -> bool:
    """Whether the last state is reached, and an assembly says the same; else it is refused by its name."""
    try:
        found = solve(text)
    except Unsolvable as error:
        assert "is never reached from `start`" in error.fault.message
        return False
    assert all(item.holds for item in found.derivation.confirmed)
    return True


@pytest.mark.parametrize(("w", "v"), [(1, 5), (5, 1)])
@pytest.mark.parametrize("load", [8.9, 9.1])
def test_a_clutch_has_to_carry_its_load(w: int, v: int, load: float) -> None:
    """As one they have the acceleration −Q/(I + K): the first needs I Q/(I + K) ≤ τ, Q ≤ 9."""
    text = CLUTCH.replace("W,", f"{w} rad/s,").replace("V,", f"{v} rad/s,").replace("LOAD", f"{load} N m")
    assert held(text) == (load < 9)


@pytest.mark.parametrize(("u", "v"), [(3, 1), (1, 3)])
@pytest.mark.parametrize("pull", [7.8, 7.9])
def test_a_block_is_taken_along(u: int, v: int, pull: float) -> None:
    """F m/(M + m) ≤ μ m g, F ≤ 0.2 · 9.8 · 4 = 7.84; the block in front of the plank is caught up by any pull, but does not stay."""
    text = PLANK.replace("U,", f"{u} m/s,").replace("V,", f"{v} m/s,").replace("LOAD", f"{pull} N")
    assert held(text) == (pull < 7.84)


@pytest.mark.parametrize("share", [0.99, 1.01])
def test_a_ball_rolls_on_up_a_slope(share: float) -> None:
    """m g sin θ − f = m a, f R = ⅖ m R² α: f = 2/7 m g sin θ, μ ≥ 2/7 tan θ."""
    text = SLOPE.replace("MU", f"{share * 2 / 7 * tan(radians(30)):.6f}")
    assert held(text) == (share > 1)


def test_in_letters_it_is_a_condition_of_each_branch() -> None:
    names = ("I", "K", "w", "v", "tau", "Q")
    units = ("kg m^2", "kg m^2", "rad/s", "rad/s", "N m", "N m")
    given = ", ".join(f"{name}: {unit}" for name, unit in zip(names, units, strict=True))
    head, _, tail = CLUTCH.partition("given: {")
    answer = solve(f"{head}given: {{{given}}}{tail.partition('}')[2]}").answers["t"]
    said = [" and ".join(map(str, branch.conditions)) for branch in (answer, *answer.branches)]
    assert len(said) >= 2
    assert all("Q" in words for words in said if "w" in words)


def test_rolling_on_is_asked_of_the_slope_alone() -> None:
    """2/7 tan θ again, as the condition of both answers."""
    text = SLOPE.replace(
        "m: 1 kg, R: 0.1 m, theta: 30 deg, mu: MU, v: 4 m/s", "m: kg, R: m, theta: rad, mu: number, v: m/s"
    )
    found = solve(text)
    for name in ("t", "u"):
        assert [str(line) for line in found.answers[name].conditions] == ["μ ≥ 2 tan θ/7"]


def test_a_later_state_is_what_the_scene_says_too() -> None:
    """Where another state follows the same is refused, not followed with a slip that turns round."""
    text = CLUTCH.replace("W,", "1 rad/s,").replace("V,", "5 rad/s,").replace("LOAD", "10 N m")
    later = text.replace("one: {c: sticks}}", "one: {c: sticks}, late: {time: 0.5 s}}").replace(
        "w1: b", "x: b.angular_velocity at late, w1: b"
    )
    with pytest.raises(Unsolvable, match="`c` slips at `one`: friction is too weak to hold it"):
        solve(later)


def test_right_before_a_blow_it_has_no_time_to_slip() -> None:
    """The instant at which both have one speed is reached; what would come then does not."""
    text = CLUTCH.replace("W,", "1 rad/s,").replace("V,", "5 rad/s,").replace("LOAD", "10 N m")
    text = text.replace(
        "one: {c: sticks}}", "one: {c: sticks}, off: {}}\nevents: {apart: {removes: c, from: one, to: off}}"
    )
    assert all(item.holds for item in solve(text).derivation.confirmed)


@pytest.mark.parametrize("load", [5.9, 6.1])
def test_wheels_that_are_pressed_together(load: float) -> None:
    """At the rims the friction μ P = 6 N carries Q R/(R² (I + K)/I) … of equal wheels half the load: Q/(2 R) ≤ μ P, Q ≤ 6."""
    assert held(RIMS.replace("LOAD", f"{load} N m")) == (load < 6)
