"""What flies freely in the plane, alone or welded: held against formulas of its centre of mass, and against the independent assembly."""

from __future__ import annotations

import math

import pytest

from rotsolve import solve
from rotsolve.core.faults import Unsolvable
from rotsolve.solution import Solution

G, T, U, V, W, Q, M, L = 9.8, 0.7, 4.0, 3.0, 2.0, 5.0, 2.0, 0.6
GIVEN = f"given: {{M: {M} kg, L: {L} m, u: {U} m/s, v: {V} m/s, w: {W} rad/s, Q: {Q} N m, t1: {T} s}}\n"
BODIES = {  # each with its moment of inertia about its centre of mass
    "rod": ("{shape: rod, mass: M, length: L}", M * L**2 / 12),
    "disc": ("{shape: disc, mass: M, radius: L}", M * L**2 / 2),
    "plate": ("{shape: rectangle, mass: M, sides: [L, L/2]}", M * (L**2 + L**2 / 4) / 12),
}


def confirmed(text: str, law: str | None = None) -> Solution:
    solution = solve(text, law=law)
    assert not solution.refused, [str(reason) for reason in solution.refused.values()]
    assert all(item.holds for item in solution.derivation.confirmed), solution.derivation.confirmed
    return solution


def value(solution: Solution, name: str) -> float:
    number = solution.answers[name].float
    assert number is not None
    return number


@pytest.mark.parametrize("plane", ["vertical", "horizontal"])
@pytest.mark.parametrize("turned", [-1, 1])
@pytest.mark.parametrize("shape", BODIES)
def test_a_free_body_flies_as_its_centre_of_mass_does(shape: str, turned: int, plane: str) -> None:
    written, inertia = BODIES[shape]
    gravity = G if plane == "vertical" else 0.0
    text = (
        f"plane: {plane}\n{GIVEN}bodies: {{one: {written}}}\n"
        f"actions: {{twist: {{couple: {turned}*Q, on: one}}}}\n"
        "states:\n  start: {one.angle: 30 deg, one.velocity: [u, v], one.angular_velocity: w}\n  end: {time: t1}\n"
        "find: {vx: one.velocity.x at end, vy: one.velocity.y at end, K: one.kinetic_energy at end, w1: one.angular_velocity at end}\n"
    )
    solution = confirmed(text)
    rise, spin = V - gravity * T, W + turned * Q * T / inertia
    assert value(solution, "vx") == pytest.approx(U, rel=1e-3)
    assert value(solution, "vy") == pytest.approx(rise, rel=1e-3, abs=1e-3)
    assert value(solution, "w1") == pytest.approx(spin, rel=1e-3)
    assert value(solution, "K") == pytest.approx((M * (U**2 + rise**2) + inertia * spin**2) / 2, rel=1e-3)


@pytest.mark.parametrize("angle", [0, 30, -140])
def test_an_end_of_a_rod_that_flies_goes_round_its_middle(angle: int) -> None:
    text = (
        f"{GIVEN}bodies: {{one: {BODIES['rod'][0]}}}\nstates:\n"
        f"  start: {{one.angle: {angle} deg, one.velocity: [u, v], one.angular_velocity: w}}\n  end: {{time: t1}}\n"
        "find: {x: one.end.velocity.x at end, y: one.end.velocity.y at end}\n"
    )
    solution, turned = confirmed(text), math.radians(angle) + W * T
    assert value(solution, "x") == pytest.approx(U - W * L / 2 * math.sin(turned), rel=1e-3)
    assert value(solution, "y") == pytest.approx(V - G * T + W * L / 2 * math.cos(turned), rel=1e-3)


@pytest.mark.parametrize("order", ["one.bottom, two.bottom", "two.bottom, one.bottom"])
@pytest.mark.parametrize("name", ["one", "two"])
def test_the_speed_of_any_of_several_that_are_welded_is_told(name: str, order: str) -> None:
    """v of the centre of mass of each = that of the one that a state tells + ω × r, whichever stands for all."""
    text = (
        f"{GIVEN}bodies: {{one: {{shape: ring, mass: M, radius: L}}, two: {{shape: disc, mass: M/2, radius: 2*L}}}}\n"
        f"connections: {{bolt: {{weld: [{order}]}}}}\n"
        f"states: {{now: {{{name}.velocity: [u, v], {name}.angular_velocity: w}}}}\n"
        "find: {px: one.momentum.x at now, qx: two.momentum.x at now, qy: two.momentum.y at now}\n"
    )
    solution, apart = confirmed(text), L  # the centre of `two` is so far above that of `one`
    first = U if name == "one" else U + W * apart
    assert value(solution, "px") == pytest.approx(M * first, rel=1e-3)
    assert value(solution, "qx") == pytest.approx(M / 2 * (first - W * apart), rel=1e-3)
    assert value(solution, "qy") == pytest.approx(M / 2 * V, rel=1e-3)


@pytest.mark.parametrize("on", ["rolls: [one, floor]", "contact: [one, floor], friction: none"])
@pytest.mark.parametrize("point", ["bottom", "top"])
@pytest.mark.parametrize("blow", ["one.center", "two.end"])
def test_a_wheel_with_a_joint_on_its_rim_stands_as_drawn_at_a_blow(on: str, point: str, blow: str) -> None:
    """One of two rods that lean the other way presses the wheel on the floor, so that it stays there."""
    text = (
        "given: {M: 2 kg, L: 0.6 m, J: 1.5 N s}\nsurfaces: {floor: level}\n"
        "bodies: {one: {shape: disc, mass: M, radius: L, moves: right}, two: {shape: rod, mass: M, length: L}}\n"
        f"connections: {{base: {{%s}}, joint: {{hinge: [one.{point}, two.start]}}}}\n"
        "states: {start: {two.angle: %s deg, at rest: all}, after: {}}\n"
        f"events: {{hit: {{impulse: J, on: {blow}, direction: right, from: start, to: after}}}}\n"
        "find: {v: one.velocity at after, w: two.angular_velocity at after}\n"
    )
    stays = []
    for angle in (-50, 50):
        try:
            stays.append(confirmed(text % (on, angle)))
        except Unsolvable as reason:
            assert "leaves the surface" in str(reason)
    assert stays


WELDED = {  # what holds two that are welded, and how they start
    "axle": ("axle: {axle: one}", "one.angular_velocity: w"),
    "hinge": ("pin: {hinge: one.top}", "at rest: all"),
    "string": ("cord: {string: [ceiling, one]}", "at rest: all"),
    "free": ("", "one.velocity: [u, v], one.angular_velocity: w"),
}


@pytest.mark.parametrize("held", WELDED)
@pytest.mark.parametrize("order", ["one.center, two.center", "two.center, one.center"])
def test_a_weld_gives_the_force_and_couple_that_move_what_it_carries(held: str, order: str) -> None:
    """Σ F = m a and Σ τ = I α of the last-named body alone; the weld acts on the other with the opposite force."""
    holds, start = WELDED[held]
    moves = ", moves: down" if held == "string" else ""
    text = (
        f"{GIVEN}bodies: {{one: {{shape: disc, mass: M, radius: L{moves}}}, two: {{shape: ring, mass: M/2, radius: L/2}}}}\n"
        f"connections: {{{', '.join(filter(None, (holds, f'bolt: {{weld: [{order}]}}')))}}}\n"
        "actions: {twist: {couple: Q, on: two}}\n"
        f"states: {{now: {{{start}}}}}\n"
        "find: {x: bolt.force.x at now, y: bolt.force.y at now, t: bolt.torque at now, ax: two.center.acceleration.x at now, "
        "ay: two.center.acceleration.y at now, al: two.angular_acceleration at now}\n"
    )
    solution = confirmed(text)
    found = {name: value(solution, name) for name in ("x", "y", "t", "ax", "ay", "al")}
    sign = 1 if order.endswith("two.center") else -1
    assert sign * found["x"] == pytest.approx(M / 2 * found["ax"], abs=2e-2)
    assert sign * found["y"] == pytest.approx(M / 2 * (found["ay"] + G), rel=2e-3)
    assert sign * found["t"] == pytest.approx(M / 2 * (L / 2) ** 2 * found["al"] - Q, rel=2e-3)
