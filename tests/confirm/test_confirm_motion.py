"""Simulated motions against steps of Runge and Kutta's with equations of motion written down by hand."""

from __future__ import annotations

import math

from rotsolve import simulate
from stepping import bisect, run

TWO_RODS = """title: Rod on a rod
given: {M: 2 kg, N: 0.7 kg, L: 1.5 m, K: 0.8 m, g: 9.8 m/s^2}
bodies:
  upper: {shape: rod, mass: M, length: L}
  lower: {shape: rod, mass: N, length: K}
connections:
  pivot: {hinge: upper.start}
  elbow: {hinge: [upper.end, lower.start]}
states: {now: {upper.angle: -20 deg, lower.angle: -75 deg, at rest: all}}
find: {alpha: upper.angular_acceleration}
"""
BELT = """title: Block on a spring on a rough floor, pulled ever harder
given: {W: 2 kg, c: 40 N/m, p: 5 N/s, g: 9.8 m/s^2}
surfaces: {floor: level}
bodies: {block: {mass: W, moves: right}}
connections:
  base: {contact: [block, floor], friction: {static: 0.5, kinetic: 0.2}}
  coil: {spring: [ground, block], stiffness: c}
actions: {pull: {force: p*time, on: block, direction: right}}
states: {start: {block.velocity: 0, coil.elongation: 0}}
find: {a: block.acceleration}
"""


def test_two_rods_move_as_lagrange_says() -> None:
    """a₁ α₁ + b cos(θ₁ − θ₂) α₂ = −b sin(θ₁ − θ₂) ω₂² − (½ M + m) g L cos θ₁, and likewise for the lower one."""
    upper, lower, long, short, g = 2.0, 0.7, 1.5, 0.8, 9.8
    first, second = (upper / 3 + lower) * long**2, lower * short**2 / 3
    both = lower * long * short / 2

    def rate(time: float, state: list[float]) -> list[float]:
        one, two, spin, turn = state
        sine, cosine = both * math.sin(one - two), both * math.cos(one - two)
        top = -sine * turn**2 - (upper / 2 + lower) * g * long * math.cos(one)
        bottom = sine * spin**2 - lower * g * short / 2 * math.cos(two)
        whole = first * second - cosine**2
        return [spin, turn, (second * top - cosine * bottom) / whole, (first * bottom - cosine * top) / whole]

    start = [math.radians(-20), math.radians(-75), 0.0, 0.0]
    motion = simulate(TWO_RODS, 3)
    for time in (1.0, 2.0, 3.0):
        one, two, spin, turn = run(rate, start, time, steps=int(4000 * time))
        found = motion.at(time)
        names = ("upper.angle", "lower.angle", "upper.angular_velocity", "lower.angular_velocity")
        for name, value in zip(names, (one, two, spin, turn), strict=True):
            assert abs(found[name][0] - value) < 1e-9 + found[name][1], (name, time)


def test_a_block_on_a_spring_sticks_and_slips() -> None:
    """It lets go where p t − c x = μₛ m g; then m x″ = p t − c x − μ m g until x′ = 0 again."""
    mass, stiffness, growth, static, kinetic = 2.0, 40.0, 5.0, 0.5 * 2 * 9.8, 0.2 * 2 * 9.8
    place, time, expected = 0.0, 0.0, []
    omega = math.sqrt(stiffness / mass)
    for _ in range(3):
        time = (static + stiffness * place) / growth
        expected.append(time)
        rest = (growth * time - kinetic) / stiffness  # where it would balance, which moves on at p/c

        def speed(since: float, rest: float = rest, place: float = place) -> float:
            drift = growth / stiffness
            return drift - drift * math.cos(omega * since) - (place - rest) * omega * math.sin(omega * since)

        since = bisect(lambda s, speed=speed: -speed(s), 0.1 / omega, 1.9 * math.pi / omega)  # type: ignore[misc]
        drift = growth / stiffness
        place = (
            rest + drift * since + (place - rest) * math.cos(omega * since) - drift / omega * math.sin(omega * since)
        )
        time += since
        expected.append(time)
    motion = simulate(BELT, expected[-1] + 0.01)
    assert [event.what for event in motion.events] == ["base begins to slip", "base: slipping ends"] * 3
    for event, moment in zip(motion.events, expected, strict=True):
        assert abs(event.time - moment) < 1e-10 + event.bound
    assert abs(motion.at(motion.end)["block.position"][0] - place) < 1e-9
