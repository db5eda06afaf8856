"""The edge of stability as the assembly finds it: the least spin of an upright top, however little inertia it has about its axis.

ω₃ = 2 √(I₁ M g l)/I₃ (Goldstein, Poole & Safko, Classical Mechanics, §5.7); a number beside it, larger or smaller, is not taken for it.
"""

from __future__ import annotations

import math

import pytest

from rotsolve.confirm.course.samples import sets_of_numbers
from rotsolve.confirm.space.hearing import Hearing
from rotsolve.confirm.space.inquiry import Inquiry
from rotsolve.confirm.space.stability import eigenvalues_of
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_text
from rotsolve.space.complete import configured_in_space

TOP = """title: T
up: z
given: {{M: {mass}, l: {length}, A: {across}, C: {axial}, g: 9.8 m/s^2, w: unknown}}
bodies: {{top: {{mass: M, inertia: {{about: tip, principal: [A, A, C]}}, axis: z, points: {{tip: [0, 0, -l]}}}}}}
connections: {{floor: {{ball: top.tip}}}}
states: {{up: {{top.tilt: 0 deg, top.axial_rate: w, steady: true}}}}
find: {{w_0: smallest w where up is stable}}
"""
RATIOS = (1.4, 0.7, 0.05, 1e-3, 1e-5)  # I₃/I₁
BESIDE = (0.9, 0.99, 0.998, 1.002, 1.01, 1.1)


def least_spin(axial: float) -> tuple[Hearing, float]:
    scene = TOP.format(mass="0.2 kg", length="5 cm", across="2e-3 kg m^2", axial=f"{axial!r} kg m^2")
    problem = configured_in_space(read_text(scene)).problem
    return Hearing(problem, next(iter(sets_of_numbers(problem))), {}), 2 * math.sqrt(2e-3 * 0.2 * 9.8 * 0.05) / axial


@pytest.mark.parametrize("ratio", RATIOS)
def test_the_least_spin_is_told_from_numbers_beside_it(ratio: float) -> None:
    hearing, own = least_spin(ratio * 2e-3)
    find = hearing.problem.finds[0]
    assert hearing.under_condition(find, own) == own
    for share in BESIDE:
        assert abs(hearing.under_condition(find, share * own) / (share * own) - 1) > 0.01, share


@pytest.mark.parametrize("ratio", RATIOS)
def test_a_small_lean_goes_as_the_roots_say(ratio: float) -> None:
    """I₁ σ² − I₃ ω₃ σ + M g l = 0, at a spin half as large again as the least one, and at half of it."""
    hearing, own = least_spin(ratio * 2e-3)
    for share in (1.5, 0.5):
        inquiry = Inquiry(hearing.problem, {**hearing.known, "w": share * own}, {})
        found = eigenvalues_of(inquiry.ways("up")[0].worlds[0], "top")
        middle, half = share * math.sqrt(49.0), math.sqrt(49.0 * abs(share**2 - 1))  # M g l/I₁ = 49/s²
        sizes = [middle - half, middle + half] if share > 1 else [7.0]
        for root in found:
            near = [abs(abs(root) - size) for size in (0.0, *sizes)]
            assert min(near) < 1e-4 * 7.0, found
        grows = max(root.real for root in found)
        assert grows == pytest.approx(half if share < 1 else 0.0, abs=1e-4)


def test_letters_have_their_least_spin() -> None:
    scene = TOP.format(mass="kg", length="m", across="kg m^2", axial="kg m^2").replace("g: 9.8 m/s^2, ", "")
    derivation = solve(scene).complete().derivation
    assert [item.holds for item in derivation.confirmed] == [True]


ROLLING = """up: z
given: {m: 2 kg, R: 0.3 m, r: 0.2 m, A: 0.05 kg m^2, C: 0.08 kg m^2, v: unknown, g: 9.8 m/s^2}
bodies: {coin: BODY}
surfaces: {table: level}
connections: {grip: {rolls: [ON, table]}}
states: {rolling: {coin.tilt: 90 deg, coin.spin: v/RIM, coin.precession: 0 rad/s, steady: true}}
find: {v_0: smallest v where rolling is stable}
"""
WHEELS = {  # what rolls on which rim, its radius, and its moments of inertia across and about its axis
    "an annulus on its outer rim": (
        "{shape: annulus, mass: m, radii: {inner: r, outer: R}}",
        ("coin", "R", 0.3),
        (2 * 0.13 / 4, 2 * 0.13 / 2),
    ),
    "a stepped wheel on its smaller rim": (
        "{mass: m, inertia: {about: center, principal: [A, A, C]}, axis: z, radii: {big: R, small: r}}",
        ("coin.small", "r", 0.2),
        (0.05, 0.08),
    ),
    "parts on a rim that is told": (
        "{parts: {a: {shape: disc, mass: m, radius: r, at: [0, 0, 0]}}, axis: z, radius: R}",
        ("coin", "R", 0.3),
        (2 * 0.04 / 4, 2 * 0.04 / 2),
    ),
}


@pytest.mark.parametrize("case", WHEELS)
def test_what_rolls_on_any_rim_is_confirmed(case: str) -> None:
    """I₃ (I₃ + m R²) v² = I₁ m g R³ of a wheel that rolls upright."""
    body, (on, letter, rim), (across, axial) = WHEELS[case]
    solution = solve(ROLLING.replace("BODY", body).replace("ON", on).replace("RIM", letter))
    least = math.sqrt(across * 2 * 9.8 * rim**3 / (axial * (axial + 2 * rim**2)))
    assert float(solution.answers["v_0"].value) == pytest.approx(least, rel=5e-4)
    assert [item.holds for item in solution.derivation.confirmed] == [True]


TWO_TOPS = """title: t
up: z
given: {m: kg, a: 10 cm, w: unknown}
bodies:
  one: {parts: {d: {shape: disc, mass: m, radius: a, at: [0, 0, a/2]}}, axis: z, points: {tip: [0, 0, 0]}}
  two: {parts: {e: {shape: disc, mass: m, radius: a, at: [0, 0, a]}}, axis: z, points: {tip: [0, 0, 0]}}
connections: {f1: {ball: one.tip}, f2: {ball: two.tip}}
states: {now: {one.tilt: STATE, steady: true}, asleep: {two.tilt: 0 deg, two.axial_rate: w, steady: true}}
find: {w_2: smallest w where asleep is stable}
"""


@pytest.mark.parametrize("state", ["45 deg, one.axial_rate: 90 rad/s", "0 deg, one.axial_rate: w"])
def test_a_body_of_which_its_state_does_not_speak_spoils_no_verge(state: str) -> None:
    """(I₃ w)² = 4 I₁ m g a with I₃ = ½ m a², I₁ = 5/4 m a²."""
    solution = solve(TWO_TOPS.replace("STATE", state))
    assert float(solution.answers["w_2"].value) == pytest.approx(math.sqrt(20 * 9.8 / 0.1), rel=5e-4)
    assert [item.holds for item in solution.derivation.confirmed] == [True]
