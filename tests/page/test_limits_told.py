"""Limits and mistakes: what answers come to at the ends of letters, what that means where the laws prove it, and what is no work."""

from __future__ import annotations

import rotsolve
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Words

SLIDE = """title: t
given: {m: kg, R: m, b: number, u: m/s, mu: number, g: m/s^2}
surfaces: {floor: level}
bodies: {ball: {mass: m, inertia: b*m*R^2, radius: R, moves: right, turns: clockwise}}
connections: {contact: {contact: [ball, floor], friction: mu}}
states: {start: {ball.velocity: u, ball.angular_velocity: 0}, rolling: {contact: rolls, ball.velocity: u/(1 + b)}}
find: {d: ball.displacement from start to rolling, W: contact.work from start to rolling}
"""
GRIPPED = """title: t
given: {m: kg, R: m, b: number, u: m/s}
surfaces: {floor: level}
bodies: {ball: {mass: m, inertia: b*m*R^2, radius: R, moves: right, turns: clockwise}}
connections: {contact: {rolls: [ball, floor]}}
states: {start: {ball.velocity: u, ball.angular_velocity: 0}, rolling: {}}
events: {slide: {grips: contact, from: start, to: rolling}}
find: {v: ball.velocity at rolling, K: lost kinetic_energy during slide}
"""
BLOCK = """title: t
given: {m: kg, M: kg, R: m, g: m/s^2}
bodies: {block: {mass: m, moves: down}, disc: {shape: disc, mass: M, radius: R, turns: clockwise}}
connections: {axle: {axle: disc}, string: {string: [disc, block]}}
find: {a: block.acceleration}
"""


def as_text(words: Words) -> str:
    return "".join(part if isinstance(part, str) else to_text(part) for part in words)


def limits(scene: str) -> list[str]:
    return [as_text(check.words) for check in rotsolve.solve(scene).derivation.checks if check.limit]


def test_what_is_lost_and_what_comes_to_rest() -> None:
    """K = ½ m u² b/(1 + b) and v = u/(1 + b)."""
    none, all_ = limits(GRIPPED)
    assert none == "b → 0 (all mass at the centre) gives v = u, K = 0: no energy is lost"
    assert all_ == (
        "b → ∞ (all mass far out) gives v = 0, K = ½ m u²: all the kinetic energy is lost; "
        "ball comes to rest, as a block would that can not be set turning"
    )


def test_a_body_that_turns_at_first_is_not_said_to_slide_as_a_block() -> None:
    turning = GRIPPED.replace("ball.angular_velocity: 0", "ball.angular_velocity: w").replace(
        "u: m/s}", "u: m/s, w: rad/s}"
    )
    assert not any("as a block" in line for line in limits(turning))


def test_a_load_without_a_pulley_falls_freely() -> None:
    """a = 2 m g/(2 m + M)."""
    assert limits(BLOCK) == ["M → 0 gives a = g: block falls freely"]


def test_a_limit_that_goes_without_saying_stays_among_the_checks() -> None:
    page = rotsolve.solve(BLOCK.replace("a: block.acceleration", "al: disc.angular_acceleration")).to(width=100)
    assert "Limits" not in page and "M → 0 gives al = g/R" in page


def test_the_work_by_the_way_of_the_centre_is_named_as_a_mistake() -> None:
    """d = b u² (2 + b)/(2 μ g (1 + b)²); −μ N d is less than W = −½ m u² b/(1 + b) by ½ I ω² = ½ b m u²/(1 + b)²."""
    said = [as_text(words) for words in rotsolve.solve(SLIDE).derivation.insights]
    assert any(
        line.startswith("a mistake that is often made: W is not −μ N d = −b m u² (2 + b)/(2 (1 + b)²)")
        and "its torque gives b m u²/(2 (1 + b)²) of it back" in line
        for line in said
    ), said
