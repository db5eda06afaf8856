"""A letter that a question seeks has its own value where it is looked at whether time runs forwards, not any other."""

from __future__ import annotations

import pytest

from rotsolve.confirm.course.samples import holding
from rotsolve.pipeline import solve

MACHINE = """
given: {p: kg, q: kg, J: kg m^2, r: m, u: m/s, h: m}
bodies: {one: {mass: p, moves: up}, wheel: {inertia: J, radius: r, turns: clockwise}, two: {mass: q, moves: down}}
connections: {axle: {axle: wheel}, rope: {string: [one, wheel, two]}}
states: {start: {two.velocity: u}, top: {two.velocity: 0}}
find: {Js: J where two.displacement = h from start to top}
"""


@pytest.mark.parametrize(("p", "q", "h"), [(3.0, 1.0, 0.9), (1.2, 1.1, 5.0), (1.0, 3.0, 0.9)])
def test_an_inertia_by_how_far_it_is_to_the_turn(p: float, q: float, h: float) -> None:
    """u² = 2 a h with a = (p − q) g/(p + q + J/r²): J > 0 where p > q and h is large enough."""
    answer = solve(MACHINE, confirm=False).answers["Js"].answer
    numbers = {"p": p, "q": q, "r": 0.5, "u": 2.0, "h": h, "g": 9.8}
    true = 0.25 * (2 * (p - q) * 9.8 * h / 4 - p - q)
    case = holding(answer, numbers)
    assert (case is not None) == (true > 0)


WOUND = """
given: {m: kg, J: kg m^2, r: m, c: N m/rad, h: m, v: m/s}
bodies: {wheel: {inertia: J, radius: r, turns: clockwise}, load: {mass: m, moves: down}}
connections: {axle: {axle: wheel}, wire: {torsion: wheel, stiffness: c}, rope: {string: [wheel, load]}}
states: {start: {wheel.angle: 0, at rest: all}, low: {load.displacement: h}}
find: {hs: h where load.velocity = v at low}
"""


@pytest.mark.parametrize(("v", "reached"), [(1.0, True), (2.0, True), (3.5, False)])
def test_a_depth_by_the_speed_there(v: float, reached: bool) -> None:
    """½ (m + J/r²) v² = m g h − ½ c h²/r²: reached where m² g² r⁴ ≥ c v² (J + m r²), for m = 1, J = 0.5, r = 0.5, c = 1 to v = 2.83."""
    answer = solve(WOUND, confirm=False).answers["hs"].answer
    numbers = {"m": 1.0, "J": 0.5, "r": 0.5, "c": 1.0, "v": v, "g": 9.8}
    assert (v**2 * 0.75 <= 9.8**2 * 0.0625) is reached
    assert (holding(answer, numbers) is not None) is reached
