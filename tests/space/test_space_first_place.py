"""The angle at which a body on a hinge has a rate that is told: the first one on its way, whichever way it sets out.

A rod that turns about y from the x axis has its centre of mass at −½ L sin θ above the hinge: ω² = 3 g (sin θ − sin θ₀)/L + ω₀².
"""

from __future__ import annotations

import math

import pytest

from rotsolve.pipeline import solve

G, L = 9.8, 0.6
SCENE = """
up: z
given: {m: 2 kg, L: 0.6 m, th: unknown, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: rod.start, along: y}}
states: {start: {rod.angle: FROM deg, rod.angular_velocity: FIRST rad/s}, fast: {rod.angle: th, rod.angular_velocity: THEN rad/s}}
find: {th: th, v: rod.end.velocity at fast}
"""
LET_GO = [150, 30, 100, 75, -60, -120, -170, 200]


def first_angle(start: float, first: float, then: float) -> float:
    """By small steps: where the rate is the one that is told for the first time."""
    angle, rate, step = start, first, 1e-5
    push = first or math.cos(start)
    while True:
        middle = angle + rate * step / 2
        later = rate + 1.5 * G / L * math.cos(middle) * step
        if (rate - then) * (later - then) <= 0 and (rate != first or (later - then) * push < 0):
            return angle
        angle, rate = angle + (rate + later) * step / 2, later


@pytest.mark.sampled(3)
@pytest.mark.parametrize("start", LET_GO)
def test_what_is_let_go_has_a_rate_first_on_the_side_to_which_it_falls(start: int) -> None:
    way = 1 if math.cos(math.radians(start)) > 0 else -1
    lowest = math.sqrt(3 * G / L * (1 - math.sin(math.radians(start))))
    check(start, 0.0, round(way * lowest / 2, 3))


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("start", "first", "then"), [(90, 3, 2), (-30, -5, -3), (40, -2, -1), (100, 2, 1.2)])
def test_what_is_set_going_has_another_rate_first_ahead(start: int, first: float, then: float) -> None:
    check(start, first, then)


@pytest.mark.parametrize("start", [150, 30, -60, -120])
def test_what_swings_turns_back_on_the_other_side(start: int) -> None:
    check(start, 0.0, 0.0)


def check(start: int, first: float, then: float) -> None:
    text = SCENE.replace("FROM", str(start)).replace("FIRST", str(first)).replace("THEN", str(then))
    found = solve(text)
    angle = found.answers["th"].float
    assert angle == pytest.approx(first_angle(math.radians(start), first, then), abs=1e-3)
    speeds = [then * L * part for part in (-math.sin(angle), 0.0, -math.cos(angle))]
    assert [part.float for part in found.answers["v"].components.values()] == pytest.approx(speeds, abs=1e-9)
    assert all(verdict.holds for verdict in found.derivation.confirmed)


def test_in_letters_it_is_the_first_as_well() -> None:
    text = SCENE.replace("2 kg", "kg").replace("0.6 m", "m").replace("9.8 m/s^2", "m/s^2, w: rad/s")
    text = text.replace("FROM", "150").replace("FIRST", "0").replace("THEN rad/s", "-w")
    answer = solve(text).answers["th"]
    assert [case.exact for case in answer.branches] == ["π − arcsin((3 g + 2 L w²)/(6 g))"]


def test_the_largest_of_such_angles_is_refused() -> None:
    text = (
        SCENE.replace("th: th,", "th: largest th,").replace("FROM", "60").replace("FIRST", "0").replace("THEN", "1.5")
    )
    refused = solve(text).refused["th"]
    assert "is where its state is reached first: `largest` chooses none" in str(refused)


@pytest.mark.exhaustive
def test_a_hinge_the_other_way_round_in_letters() -> None:
    """Of all sets of numbers one has its place next to 0, where a share of the angle would be nothing to look at."""
    (answer,) = solve("""
up: z
given: {m: kg, b: m, h: m, th: unknown, w: rad/s, g: m/s^2}
bodies: {gate: {shape: rectangle, mass: m, sides: [b, h], points: {A: [b/2, 0, 0]}}}
connections: {post: {hinge: gate.A, along: [0, -1, 0]}}
states: {start: {gate.angle: -30 deg, gate.angular_velocity: 0 rad/s}, fast: {gate.angular_velocity: w, gate.angle: th}}
find: {th: th}
""").answers.values()
    assert [case.exact for case in answer.branches] == ["arcsin((2 b w² − 3 g)/(6 g))"]
