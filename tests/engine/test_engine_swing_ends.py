"""A swing of any size is as large on the other side: what only pulls or presses does so there too, or its period is not told."""

from __future__ import annotations

import pytest

import rotsolve

WINCH = """
title: Winch on a wire, let go wound up
given: {J: kg m^2, r: m, m: kg, c: N m/rad, b: rad}
bodies: {winch: {inertia: J, radius: r, turns: clockwise}, sack: {mass: m, moves: down}}
connections: {axle: {axle: winch}, wire: {torsion: winch, stiffness: c}, cord: {string: [winch, sack]}}
states: {freed: {winch.angle: -b, at rest: all}}
find: {T: period of swings from freed}
"""
HUNG = """
title: Two sacks over a wheel, one on a spring
given: {J: kg m^2, r: m, p: kg, q: kg, k: N/m, a: m, u: m/s}
bodies: {one: {mass: p, moves: up}, wheel: {inertia: J, radius: r, turns: clockwise}, two: {mass: q, moves: down}}
connections: {axle: {axle: wheel}, cord: {string: [one, wheel, two]}, coil: {spring: [ground, one], stiffness: k}}
states: {freed: {coil.elongation: a, SPEED}}
find: {T: period of swings from freed}
"""
THROWN, RESTING = HUNG.replace("SPEED", "one.velocity: u"), HUNG.replace("SPEED", "at rest: all")
SIZES = {"J": "1 kg m^2", "r": "1 m", "p": "1 kg", "q": "2 kg", "k": "10 N/m"}


def taut(text: str, settings: dict[str, str]) -> bool:
    """Whether no check objects to the period at some numbers."""
    checks = rotsolve.solve(text, settings=settings).derivation.checks
    return not any(check.holds is False for check in checks)


def test_a_rope_pulls_on_the_other_side_of_a_swing_in_letters() -> None:
    """T = m (J g + c r θ + m g r²)/(J + m r²) at θ from −m g r/c, with −b there to start: c b ≤ g (J + 2 m r²)/r."""
    (limit,) = rotsolve.solve(WINCH).answers["T"].conditions
    assert limit == "c ≤ g (J + 2 m r²)/(r b)"


@pytest.mark.parametrize(("turn", "holds"), [("2.9 rad", True), ("2.98 rad", False)])
def test_a_rope_pulls_on_the_other_side_of_a_swing_in_numbers(turn: str, holds: bool) -> None:
    """At J = 1, r = 1, m = 1, c = 10 SI: b ≤ 2.94."""
    assert taut(WINCH, {"J": "1 kg m^2", "r": "1 m", "m": "1 kg", "c": "10 N m/rad", "b": turn}) is holds


def ends(stretch: float, speed: float) -> tuple[float, float]:
    """How far from x₀ = q g/k, minus p g/k, the spring is stretched at both ends: s = J/r² + p + q = 4 kg, ω² = k/s."""
    rest = (2 - 1) * 9.8 / 10
    size = ((stretch - rest) ** 2 + speed**2 * 4 / 10) ** 0.5
    return rest - size, rest + size


@pytest.mark.parametrize("stretch", ["0.7", "3", "4.5"])
@pytest.mark.parametrize("speed", ["", "2", "-2", "6", "12"])
def test_a_swing_that_is_thrown_goes_further(stretch: str, speed: str) -> None:
    """a = (q g − p g − k x)/s along the cord, and q (g − a) > 0, p (g + a) + k x > 0 at both ends."""
    pulls = []
    for x in ends(float(stretch), float(speed or 0)):
        a = (9.8 - 10 * x) / 4
        pulls += [2 * (9.8 - a), 9.8 + a + 10 * x]
    text = THROWN if speed else RESTING
    settings = {**SIZES, "a": f"{stretch} m", **({"u": f"{speed} m/s"} if speed else {"u": "1 m/s"})}
    assert taut(text, settings) is (min(pulls) >= 0)
