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
