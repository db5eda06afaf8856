"""Wheels that are held still, and what falls or swings with an arm round them: against ½ I ω² + U, with all rates told by the arm."""

from __future__ import annotations

import math

import pytest

import rotsolve

A, B, M, ARM, G = 0.12, 0.04, 1.0, 0.5, 9.8
SCENE = """
title: An arm that falls round a wheel
given: {a: 12 cm, b: 4 cm, m: 1 kg, M: 500 g}
bodies:
  wheel: {shape: ring, mass: m, radius: a}
  planet: {shape: disc, mass: m, radius: b}
  second: {shape: disc, mass: m, radius: a}
  arm: {shape: rod, mass: M, length: LENGTH}
connections:
  fixed: {axle: wheel, HELD}
  post: {hinge: arm.start}
  pin: {hinge: [arm.at(AT), planet.center]}
LINKS
states: {start: {arm.angle: 30 deg, at rest: MOVING}, low: {arm.angle: -90 deg}}
find:
  w: arm.angular_velocity at low
  T: period of small swings
  W: fixed.work from start to low
  alpha: arm.angular_acceleration at start
"""
STILL = ("angular_velocity: 0", "angle: 20 deg")
GEAR, INSIDE = "  teeth: {gear: [wheel, planet]}", "  teeth: {gear: [planet, wheel], inside: true}"
IDLER = "  p2: {hinge: [arm.end, second.center]}\n  t1: {gear: [wheel, planet]}\n  t2: {gear: [planet, second]}"
BELT = "  strap: {belt: [wheel, planet]}"
EQUAL = "  p2: {hinge: [arm.end, second.center]}\n  strap: {belt: [wheel, second]}\n  teeth: {gear: [wheel, planet]}"
KINDS: dict[str, tuple[str, str, float, list[tuple[float, float, float]]]] = {
    # length, links, the arm's length, and of each wheel its distance, its radius and its turns per turn of the arm
    "outside": ("a + b", GEAR, A + B, [(A + B, B, (A + B) / B)]),
    "inside": ("a - b", INSIDE, A - B, [(A - B, B, (B - A) / B)]),
    "a second wheel": ("2*a + 2*b", IDLER, 2 * (A + B), [(A + B, B, (A + B) / B), (2 * (A + B), A, 0.0)]),
    "a belt": ("a + b", BELT, A + B, [(A + B, B, (B - A) / B)]),
    "a belt on equal wheels": ("2*a + 2*b", EQUAL, 2 * (A + B), [(A + B, B, (A + B) / B), (2 * (A + B), A, 0.0)]),
}


def scene(kind: str, held: str) -> str:
    length, links, whole, wheels = KINDS[kind]
    text = SCENE.replace("LENGTH", length).replace("LINKS", links).replace("HELD", held)
    if len(wheels) == 1:
        text = text.replace("  second: {shape: disc, mass: m, radius: a}\n", "")
    moving = "[arm, planet, second]" if len(wheels) > 1 else "[arm, planet]"
    return text.replace("MOVING", moving).replace("AT)", f"{'a + b' if whole > A else 'a - b'})")


@pytest.mark.parametrize("held", STILL)
@pytest.mark.parametrize("kind", KINDS)
def test_arm_falls_and_swings_round_a_wheel_that_is_held(kind: str, held: str) -> None:
    _, _, whole, wheels = KINDS[kind]
    inertia = ARM * whole**2 / 3 + sum(M * away**2 + 0.5 * M * radius**2 * turns**2 for away, radius, turns in wheels)
    pull = G * (ARM * whole / 2 + sum(M * away for away, _, _ in wheels))
    answers = rotsolve.solve(scene(kind, held)).answers
    assert answers["w"].float == pytest.approx(-math.sqrt(2 * pull * 1.5 / inertia))
    assert answers["T"].float == pytest.approx(2 * math.pi * math.sqrt(inertia / pull))
    assert answers["alpha"].float == pytest.approx(-pull * math.cos(math.radians(30)) / inertia)
    assert answers["W"].float == 0.0


def test_where_the_arm_hangs_is_said_by_the_numbers() -> None:
    """Of lengths that are differences, a − b, no letters tell which way is down."""
    page = str(rotsolve.solve(scene("inside", STILL[0])))
    assert "(hanging straight down)" in page
    assert "straight up" not in page


def test_what_is_held_does_not_swing() -> None:
    with pytest.raises(rotsolve.Unsolvable, match="`wheel` is held still"):
        rotsolve.solve(scene("outside", STILL[0]).split("find:")[0] + "find: {T: period of small swings of wheel}\n")


def test_a_wheel_that_turns_is_no_ground() -> None:
    with pytest.raises(rotsolve.Unsolvable, match="is led"):
        rotsolve.solve(scene("outside", "angular_velocity: 2 rad/s").replace("  w: arm.angular_velocity at low\n", ""))


def test_what_is_welded_to_the_ground_is_told_how_to_be_held() -> None:
    text = scene("outside", STILL[0]).replace("{axle: wheel, angular_velocity: 0}", "{weld: [ground, wheel]}")
    text = text.replace("  W: fixed.work from start to low\n", "")
    with pytest.raises(rotsolve.Unsolvable, match="angular_velocity: 0"):
        rotsolve.solve(text)
