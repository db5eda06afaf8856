"""Wheels that a wire turns back: where nothing tells how they stand at first the wire is not wound yet, as they are drawn."""

from __future__ import annotations

import math

import pytest

from rotsolve import solve
from rotsolve.solution import Solution

M, R, K, TAU, T, SPEED = 2.0, 0.3, 4.0, 2.0, 0.25, 1.5
NUMBERS = f"M: {M} kg, R: {R} m, k: {K} N m/rad, tau: {TAU} N m, t1: {T} s, w: {SPEED} rad/s"
WHEELS = {  # each with its moment of inertia
    "disc": ("{shape: disc, mass: M, radius: R, turns: counterclockwise}", M * R**2 / 2),
    "ring": ("{shape: ring, mass: M, radius: R, turns: counterclockwise}", M * R**2),
    "rotor": ("{mass: M, inertia: 3*M*R^2, radius: R, turns: counterclockwise}", 3 * M * R**2),
}


def wound(
    wheel: str, start: str, end: str, find: str, *, actions: str = "", given: str = NUMBERS, wire: str = "wheel"
) -> Solution:
    text = (
        f"given: {{{given}}}\nbodies: {{wheel: {WHEELS[wheel][0]}}}\n"
        f"connections: {{axle: {{axle: wheel}}, wire: {{torsion: {wire}, stiffness: k}}}}\n{actions}"
        f"states: {{start: {start}{end}}}\nfind: {{{find}}}\n"
    )
    solution = solve(text)
    assert not solution.refused, [str(reason) for reason in solution.refused.values()]
    assert all(item.holds for item in solution.derivation.confirmed), solution.derivation.confirmed
    return solution


def value(solution: Solution, name: str) -> float:
    number = solution.answers[name].float
    assert number is not None
    return number


DRIVE = "actions: {drive: {couple: tau, on: wheel}}\n"
END = ", end: {time: t1}"


@pytest.mark.parametrize("wheel", WHEELS)
def test_a_wheel_at_rest_with_its_wire_stays_at_rest(wheel: str) -> None:
    solution = wound(wheel, "{at rest: all}", "", "a: wheel.angular_acceleration at start")
    assert value(solution, "a") == 0


@pytest.mark.parametrize("turned", [1, -1])
@pytest.mark.parametrize("wheel", WHEELS)
def test_a_couple_winds_the_wire_up(wheel: str, turned: int) -> None:
    """θ = τ/κ (1 − cos ω₀ t) from rest."""
    drive = DRIVE.replace("tau", f"{turned}*tau")
    find = "a: wheel.angular_acceleration at start, v: wheel.angular_velocity at end"
    solution = wound(wheel, "{at rest: all}", END, find, actions=drive)
    inertia = WHEELS[wheel][1]
    rate = math.sqrt(K / inertia)
    assert value(solution, "a") == pytest.approx(turned * TAU / inertia, rel=1e-3)
    assert value(solution, "v") == pytest.approx(turned * TAU / K * rate * math.sin(rate * T), rel=1e-3)


@pytest.mark.parametrize("place", [0.05, 0.2])
@pytest.mark.parametrize("wheel", WHEELS)
def test_a_wheel_that_turns_is_slowed_down_by_its_wire(wheel: str, place: float) -> None:
    """½ I ω² + ½ κ θ² stays."""
    solution = wound(
        wheel,
        "{wheel.angular_velocity: w}",
        f", end: {{wheel.rotation: {place} rad}}",
        "v: wheel.angular_velocity at end",
    )
    left = SPEED**2 - K * place**2 / WHEELS[wheel][1]
    if left > 0:
        assert value(solution, "v") == pytest.approx(math.sqrt(left), rel=1e-3)


@pytest.mark.parametrize("wheel", WHEELS)
def test_so_it_is_in_letters(wheel: str) -> None:
    given = "M: kg, R: m, k: N m/rad, tau: N m"
    solution = wound(wheel, "{at rest: all}", "", "a: wheel.angular_acceleration at start", actions=DRIVE, given=given)
    assert "k" not in (solution.answers["a"].exact or "")


@pytest.mark.parametrize("couple", ["", "actions: {twist: {couple: tau, on: wheel}}\n"])
@pytest.mark.parametrize("surface", ["level", "{slope: 35 deg, down: left}", "{slope: 35 deg, down: right}"])
@pytest.mark.parametrize("wheel", ["disc", "ring"])
def test_a_wheel_on_a_spring_swings_alike_on_every_slope(wheel: str, surface: str, couple: str) -> None:
    """T = 2π √((M + I/R²)/k): weight and couple only move the equilibrium."""
    moves = "right" if surface == "level" else "down"
    text = (
        f"given: {{M: {M} kg, R: {R} m, tau: {TAU} N m}}\nsurfaces: {{ramp: {surface}}}\n"
        f"bodies: {{wheel: {{shape: {wheel}, mass: M, radius: R, moves: {moves}}}}}\n"
        "connections: {base: {rolls: [wheel, ramp]}, coil: {spring: [ground, wheel], stiffness: 90 N/m}}\n"
        f"{couple}find: {{T: period of small swings}}\n"
    )
    solution = solve(text)
    assert value(solution, "T") == pytest.approx(2 * math.pi * math.sqrt((M + WHEELS[wheel][1] / R**2) / 90), rel=1e-3)
