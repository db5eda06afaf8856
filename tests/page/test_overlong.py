"""No page holds formulas of more than a dozen lines: dots stand for them, and what they come to is certified all the same."""

from __future__ import annotations

import math

import pytest

from rotsolve import solve
from rotsolve.algebra.exact.order import length
from rotsolve.page.overlong import LONGEST, formulas_of, within_a_page

TURNED_ON = """up: z
gravity: none
given: {a: 3 rad/s, b: -2 rad/s, c: 5 rad/s, T: 1.3 s, I1: 0.2 kg m^2, I3: 0.35 kg m^2}
bodies: {egg: {mass: 2 kg, inertia: {principal: [I1, I1, I3]}, axis: z, points: {Q: [0.1 m, 0.2 m, 0.3 m]}}}
states:
  now:
    egg.tilt: 40 deg
    egg.spin_angle: 25 deg
    egg.precession_angle: 15 deg
    egg.precession: a
    egg.nutation: b
    egg.spin: c
    egg.velocity: [1 m/s, 2 m/s, 3 m/s]
  later: {time: T}
find: {FIND}
"""
LONG = "w: egg.angular_velocity at later, ps: egg.spin_angle at later in deg, v: egg.Q.velocity at later"
MOST_LINES = 150
FORMATS = ("text", "markdown", "latex", "typst", "html")


def turned_on() -> dict[str, list[float]]:
    """ω and v of the point at the later time: the axis goes round L at L/I₁, and the body about it at ω₃ (I₁ − I₃)/I₁."""

    def matrix(axis: list[float], angle: float) -> list[list[float]]:
        (x, y, z), c, s = axis, math.cos(angle), math.sin(angle)
        return [
            [c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
            [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
            [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)],
        ]

    def put(rows: list[list[float]], vector: list[float]) -> list[float]:
        return [sum(a * b for a, b in zip(row, vector, strict=True)) for row in rows]

    def cross(u: list[float], v: list[float]) -> list[float]:
        return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]

    a, b, c, time, one, three, tilt = 3.0, -2.0, 5.0, 1.3, 0.2, 0.35, math.radians(40)
    at_node = [b, a * math.sin(tilt), a * math.cos(tilt) + c]
    standing = [matrix([0, 0, 1], math.radians(15)), matrix([1, 0, 0], tilt)]
    momentum, omega = ([one, one, three], at_node)
    seen = [size * part for size, part in zip(momentum, omega, strict=True)]
    for rows in reversed(standing):
        seen, omega = put(rows, seen), put(rows, omega)
    whole = math.hypot(*seen)
    on = matrix([part / whole for part in seen], whole / one * time)
    spin = math.radians(25) + at_node[2] * (one - three) / one * time
    place = put(matrix([0, 0, 1], spin), [0.1, 0.2, 0.3])
    for rows in reversed(standing):
        place = put(rows, place)
    later, arm = put(on, omega), put(on, place)
    return {"w": later, "v": [p + q for p, q in zip([1, 2, 3], cross(later, arm), strict=True)]}


def test_what_is_too_long_to_print_is_a_certified_number() -> None:
    found = solve(TURNED_ON.replace("FIND", LONG))
    for name, parts in turned_on().items():
        for axis, part in zip("xyz", parts, strict=True):
            assert found.answers[name].components[axis].float == pytest.approx(part, rel=1e-9)
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize("form", FORMATS)
def test_a_page_is_no_longer_than_pages_are(form: str) -> None:
    text = solve(TURNED_ON.replace("FIND", LONG)).to(form)
    assert len(text.splitlines()) < 2 * MOST_LINES
    assert "too long to print" in text


def test_every_formula_of_a_page_is_bounded() -> None:
    derivation = within_a_page(solve(TURNED_ON.replace("FIND", LONG)).derivation)
    assert max(length(one) for one in formulas_of(derivation) if one is not None) <= LONGEST


def test_what_is_short_stays_as_it_is() -> None:
    derivation = solve(TURNED_ON.replace("FIND", "w: egg.axial_rate at later")).derivation
    assert within_a_page(derivation) is derivation


OPEN = """up: z
gravity: none
given: {I1: 2 kg m^2, I3: 1 kg m^2, GIVEN}
bodies: {e: {mass: 1 kg, inertia: {principal: [I1, I1, I3]}, axis: z, points: {Q: [0.1 m, 0.2 m, 0.3 m]}}}
states: {now: {e.angular_velocity: [1 rad/s, 2 rad/s, 3 rad/s], e.velocity: [0, 0, 0]}, later: {time: T}}
find: {v: e.Q.velocity AT}
"""


@pytest.mark.parametrize(("given", "at"), [("T: s", "at later"), ("T: 1.3 s", "at any time")])
def test_what_is_open_keeps_its_closed_form_beside_the_page(given: str, at: str) -> None:
    """Letters without a number, and functions of time, have no number to stand for them: Python has the form, and pages dots."""
    found = solve(OPEN.replace("GIVEN", given).replace("AT", at))
    assert all(part.formula is not None for part in found.answers["v"].components.values())
    page = found.to("text")
    assert "too long to print" in page
    assert len(page.splitlines()) < MOST_LINES
