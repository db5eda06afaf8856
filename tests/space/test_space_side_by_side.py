"""Bodies that do not touch: what is so of one, in letters or in numbers, is no condition of what is asked of another; and equal moments of
inertia, at which a quadratic law is a linear one. Values by the quadratic A cos θ Ω² − C ω₃ Ω + M g l = 0, or with ω₃ = ψ̇ + Ω cos θ.
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from rotsolve import Unsolvable, solve
from rotsolve.confirm.space.quadratics import rate_groups, shared_roots

HEAD = "title: t\nup: z\n"
BODY = "{name}: {{mass: M, inertia: {{about: {tip}, principal: [A, A, C]}}, axis: z, points: {{{tip}: [0, 0, -l]}}}}"
TWO = f"bodies: {{{BODY.format(name='top', tip='tip')}, {BODY.format(name='other', tip='foot')}}}\n"
HELD = "connections: {floor: {ball: top.tip}, table: {ball: other.foot}}\n"
LETTERS = "given: {M: kg, l: m, A: kg m^2, C: kg m^2, s: rad/s, theta: rad, w: WHAT}\n"
NUMBERS = "given: {{M: 0.3 kg, l: 2 cm, A: {A} kg m^2, C: {C} kg m^2, s: {s} rad/s, theta: 50 deg, w: unknown}}\n"
LEAST = """states:
  now: {top.tilt: theta, top.spin: s, steady: true}
  least: {other.tilt: theta, other.axial_rate: w, steady: true}
find: {slow: smallest top.precession at now, w_min: smallest w where least is steady}
"""
G, M, L, TILT = 9.8, 0.3, 0.02, math.radians(50)


def alone(given: str, find: str) -> Any:
    body = f"bodies: {{{BODY.format(name='top', tip='tip')}}}\nconnections: {{floor: {{ball: top.tip}}}}\n"
    return solve(f"{HEAD}{given}{body}states: {{now: {{top.tilt: theta, top.spin: s, steady: true}}}}\nfind: {find}\n")


def test_at_equal_moments_the_law_is_linear() -> None:
    """(A − C) cos θ Ω² − C s Ω + M g l = 0 for A = C: Ω = M g l/(C s), the only one, though A and C are different letters."""
    solution = alone(NUMBERS.format(A="1.5e-3", C="1.5e-3", s=350).replace(", w: unknown", ""), "{W: top.precession}")
    assert solution.answers["W"].float == pytest.approx(M * G * L / (1.5e-3 * 350), rel=1e-12)
    assert [item.holds for item in solution.derivation.confirmed] == [True]


def test_in_letters_equal_moments_are_a_case() -> None:
    solution = alone(LETTERS.replace(", w: WHAT", ""), "{slow: smallest top.precession, fast: largest top.precession}")
    page = solution.to()
    assert "slow = M g l/(C s) (if A = C)" in page and "fast = M g l/(C s) (if A = C)" in page
    assert "contradict" not in page and all(item.holds for item in solution.derivation.confirmed)


def test_a_condition_of_one_body_is_none_of_another() -> None:
    solution = solve(HEAD + LETTERS.replace("WHAT", "unknown") + TWO + HELD + LEAST)
    answers = {answer.name: answer for answer in solution.derivation.answers}
    assert answers["slow"].conditions and not answers["w_min"].conditions and not answers["w_min"].otherwise
    assert all(item.holds for item in solution.derivation.confirmed)


def test_what_has_no_steady_motion_takes_no_other_body_with_it() -> None:
    """C s < 2 √((A − C) M g l cos θ): `top` has none; `other` needs C w ≥ 2 √(A M g l cos θ)."""
    given, away = NUMBERS.format(A="9e-3", C="2e-3", s=3), "top spins too slowly"
    solution = solve(HEAD + given + TWO + HELD + LEAST)
    least = 2 * math.sqrt(9e-3 * M * G * L * math.cos(TILT)) / 2e-3
    assert solution.answers["w_min"].float == pytest.approx(least, rel=1e-9)
    assert [refusal.name for refusal in solution.derivation.refused] == ["slow"]
    assert away.replace("top", "`top`") in solution.derivation.refused[0].fault.message
    assert all(item.holds for item in solution.derivation.confirmed)


def test_roots_that_lie_far_apart_are_all_found() -> None:
    """Two rates that no equation holds together: 1e-4 x² − x + 1e-3 = 0 and y² − 3 y + 2 = 0."""
    base = [1e-3, 2.0]
    linear = [[-1.0, 0.0], [0.0, -3.0]]
    square = [[[1e-4, 0.0], [0.0, 0.0]], [[0.0, 0.0], [0.0, 1.0]]]
    assert len(rate_groups((base, linear, square))) == 2
    found = sorted((round(x, 6), round(y, 6)) for x, y in shared_roots((base, linear, square)))
    assert found == [(0.001, 1.0), (0.001, 2.0), (9999.999, 1.0), (9999.999, 2.0)]


def test_rates_that_hang_together_are_solved_together() -> None:
    """x y = 2 and x + y = 3."""
    base, linear = [-2.0, -3.0], [[0.0, 1.0], [0.0, 1.0]]
    square = [[[0.0, 0.0], [0.5, 0.0]], [[0.5, 0.0], [0.0, 0.0]]]
    assert len(rate_groups((base, linear, square))) == 1
    found = {tuple(round(part, 9) for part in root) for root in shared_roots((base, linear, square))}
    assert found == {(1.0, 2.0), (2.0, 1.0)}


def test_an_equation_that_holds_none_of_the_rates_refuses_all() -> None:
    assert shared_roots(([-1.0, 0.5], [[1.0, 0.0]], [[[0.0, 0.0]]])) == []


MASSES = HEAD + (
    "gravity: none\ngiven: {m1: 0.6 kg, mb: unknown, r1: 120 mm, rb: 80 mm, d: 0.2 m, n: 30 rad/s}\n"
    "bodies: {rotor: {parts: {one: {mass: m1, at: [r1, 0, d]}, b: {mass: mb, at: [-rb, 0, d]}}, points: {O: [0, 0, 0]}}}\n"
    "connections: {shaft: {hinge: rotor.O, along: z, bearings: [-d, 4*d], angular_velocity: n}}\n"
)


@pytest.mark.parametrize(
    ("state", "find"),
    [
        ("", "mb where size of shaft.bearing1.force = 0 N"),  # which only touches 0 there
        ("", "mb where shaft.bearing1.force.x = 0 N"),
        (", shaft.bearing1.force.x: 0 N", "mb"),
        (", shaft.bearing2.force: [0 N, 0 N, 0 N]", "mb"),
    ],
)
def test_a_force_that_is_told_tells_a_mass(state: str, find: str) -> None:
    """m₁ r₁ = m_b r_b in one plane: no bearing is pushed."""
    solution = solve(f'{MASSES}states: {{now: {{rotor.angle: 0 deg{state}}}}}\nfind: {{mb: "{find}"}}\n')
    assert solution.answers["mb"].float == pytest.approx(0.9, rel=1e-12)
    assert all(item.holds for item in solution.derivation.confirmed)


def test_a_force_that_is_told_and_can_not_be_so_is_refused() -> None:
    scene = MASSES.replace("mb: unknown", "mb: 0.7 kg")
    with pytest.raises(Unsolvable, match="contradict each other"):
        solve(
            scene
            + "states: {now: {rotor.angle: 0 deg, shaft.bearing1.force.x: 0 N}}\nfind: {F: shaft.bearing2.force}\n"
        )


@pytest.mark.parametrize("tilt", [30, 75, 90, 120])
@pytest.mark.parametrize("told", ["spin", "axial_rate"])
def test_a_fast_top_goes_on_as_it_did(tilt: int, told: str) -> None:
    """φ = M g l t/(C ω) at a later state as well, whichever rate is told."""
    body = BODY.format(name="top", tip="tip")
    solution = solve(
        f"{HEAD}assume: [fast spin]\ngiven: {{M: 0.3 kg, l: 5 cm, A: 9e-4 kg m^2, C: 3e-4 kg m^2, w: 400 rad/s, T: 2 s}}\n"
        f"bodies: {{{body}}}\nconnections: {{floor: {{ball: top.tip}}}}\n"
        f"states: {{now: {{top.tilt: {tilt} deg, top.{told}: w, top.precession_angle: 0 deg, steady: true}}, later: {{time: T}}}}\n"
        "find: {W: top.precession at now, phi: top.precession_angle at later}\n"
    )
    rate = 0.3 * 9.8 * 0.05 / (3e-4 * 400)
    assert solution.answers["W"].float == pytest.approx(rate, rel=1e-12)
    assert solution.answers["phi"].float == pytest.approx(2 * rate, rel=1e-12)


COIN = HEAD + (
    "given: {m: 20 g, b: 1.5 cm, theta: unknown, W: 6 rad/s, v: 0.5 m/s}\nbodies: {coin: {shape: disc, mass: m, radius: b}}\n"
    "surfaces: {table: level}\nconnections: {grip: {rolls: [coin, table]}}\n"
    "states: {now: {coin.tilt: theta, coin.precession: W, steady: true}}\n"
)


@pytest.mark.parametrize(("word", "low", "high"), [("smallest", 0.0, 90.0), ("largest", 90.0, 180.0)])
def test_a_tilt_under_a_condition_lies_from_0_to_180_degrees(word: str, low: float, high: float) -> None:
    """|4 g − b W² sin θ| |cos θ|/(6 W sin θ) = v, from both sides of the upright."""
    solution = solve(f'{COIN}find: {{t: "{word} theta where size of coin.velocity = v"}}\n')
    angle = solution.answers["t"].float or 0.0
    sine, cosine = math.sin(angle), math.cos(angle)
    assert low < math.degrees(angle) < high
    assert abs((4 * 9.8 - 0.015 * 36 * sine) * cosine / (6 * 6 * sine)) == pytest.approx(0.5, rel=1e-9)
    assert [item.holds for item in solution.derivation.confirmed] == [True]
