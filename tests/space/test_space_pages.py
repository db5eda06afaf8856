"""What pages of scenes in space print: each thing once, in words that a reader of a textbook knows."""

from __future__ import annotations

import pytest

from rotsolve.pipeline import solve
from rotsolve.solution import Solution

TOP = """
up: z
assume: [fast spin]
given: {{M: 150 g, l: 4 cm, I1: 5e-4 kg m^2, I3: 6e-5 kg m^2, w: {spin}, theta: {tilt}}}
bodies: {{top: {{mass: M, inertia: {{about: tip, principal: [I1, I1, I3]}}, axis: z, points: {{tip: [0, 0, -l]}}}}}}
connections: {{floor: {{ball: top.tip}}}}
states: {{now: {{{state}, steady: true}}}}
find: {{W: {find}}}
"""
BALL = """
up: z
given: {{m: 0.25 kg, F: 4 N, b: 2 m, u: 5 m/s}}
gravity: none
bodies: {{ball: {{shape: particle, mass: m}}}}
actions: {{pull: {{force: F, on: ball, direction: y}}}}
states: {{now: {{ball.position: {place}, ball.velocity: {going}}}}}
find: {{L: "ball.angular_momentum about [0, 0, 0] at now"}}
"""
ROACH = """
up: z
gravity: none
given: {m: kg, b: m, w: rad/s, mu: number, g: m/s^2, u: unknown}
bodies: {table: {shape: disc, mass: 0}, roach: {shape: particle, mass: m}}
connections: {axis: {hinge: table.center, along: z, angular_velocity: w}}
actions: {hold: {force: any, on: roach}}
states:
  now:
    roach.position relative to table: [b, 0, 0]
    roach.velocity relative to table: [0, -u, 0]
    roach.acceleration relative to table: [-u^2/b, 0, 0]
find: {u: u where size of hold.force = mu*m*g}
"""
SHAFT = """
up: z
given: {m: kg, l: m, W: rad/s}
bodies: {bob: {parts: {b: {shape: particle, mass: m, at: [l, 0, 0]}}, points: {O: [0, 0, 0]}}}
connections: {shaft: {hinge: bob.O, along: z, angular_velocity: W}}
find: {F: shaft.force in body axes, L: bob.angular_momentum}
"""
LEANING = """
up: z
given: {m: 200 kg, g: 9.81 m/s^2, L: 7 m, Bx: unknown, By: unknown}
bodies: {shaft: {shape: rod, mass: m, length: L, turned: [{about: y, by: -asin(3/7)}, {about: z, by: 180 deg + atan(3)}]}}
connections: {A: {ball: shaft.start}}
actions: {walls: {force: [Bx, By, 0 N], on: shaft.end}}
states: {rest: {balance: true}}
find: {Bx: Bx, By: By}
"""


def page(scene: str, **parts: str) -> list[str]:
    """The lines of a page, each with what is wrapped in it."""
    return text_of(solve(scene.format(**parts)))


def text_of(solution: Solution) -> list[str]:
    return [line.strip() for line in solution.to("text", width=1000).splitlines()]


def line_with(lines: list[str], part: str) -> str:
    return next((line for line in lines if part in line), "")


def top(state: str, spin: str = "300 rad/s", tilt: str = "25 deg", find: str = "top.precession") -> list[str]:
    return page(TOP, state=state, spin=spin, tilt=tilt, find=find)


# a top that spins fast


def test_a_fast_top_is_told_by_the_level_part_of_its_angular_momentum() -> None:
    lines = top("top.tilt: theta, top.axial_rate: w")
    signs = line_with(lines, "the spin is fast, so")
    assert "L = I₃ w lies along the axis of top; its level part L sin θ goes round with the axis at W" in signs
    assert signs.endswith("changes by W L sin θ per second: that is the torque M g l sin θ")
    assert "M g l sin θ ≈ I₃ w W sin θ" in line_with(lines, "(1) τ = dL/dt, top about its tip ")


def test_a_step_of_its_own_divides_by_the_sine() -> None:
    lines = top("top.tilt: theta, top.axial_rate: w")
    assert "M g l = I₃ w W" in line_with(lines, "From (1)")
    assert "(both sides divided by sin θ ≠ 0)" in lines
    assert "M g l/(I₃ w)" in line_with(lines, "From (2)")


def test_of_a_level_fast_top_nothing_is_divided() -> None:
    lines = top("top.tilt: 90 deg, top.spin: w")
    assert "it goes round with the axis at W" in line_with(lines, "the spin is fast, so")
    assert not line_with(lines, "divided")


@pytest.mark.parametrize(
    ("state", "spin", "find", "said"),
    [
        (
            "top.tilt: theta, top.spin: w",
            "300 rad/s",
            "top.precession",
            "W = 3.267 rad/s is small beside w = 300 rad/s",
        ),
        (
            "top.tilt: theta, top.precession: w",
            "3 rad/s",
            "top.axial_rate",
            "w = 3 rad/s is small beside W = 326.7 rad/s",
        ),
    ],
)
def test_how_small_the_precession_is_beside_the_spin(state: str, spin: str, find: str, said: str) -> None:
    assert said in line_with(top(state, spin=spin, find=find), "beside")


# definitions


@pytest.mark.parametrize(
    ("place", "going", "told"),
    [("[b, 0, -b]", "[-u, 0, u]", "Lₓ = 0"), ("[b, 0, 0]", "[0, u, 0]", "L_z = m u b")],
)
def test_the_angular_momentum_of_a_particle_is_told_by_its_arm(place: str, going: str, told: str) -> None:
    """It is so even where all of it vanishes, as r is along v."""
    law = line_with(page(BALL, place=place, going=going), "(1) ")
    assert "angular momentum of ball about (0, 0, 0), r × m v" in law
    assert told in law


# the plan


def test_a_label_is_cut_at_no_comma_within_brackets() -> None:
    lines = text_of(
        solve("""
up: z
given: {m: 1 kg, u: 5 m/s, T: 1 s}
bodies: {ball: {shape: particle, mass: m}}
states: {start: {ball.position: [0, 0, 0], ball.velocity: [u, 0, 0]}, end: {time: T}}
find: {L: "ball.angular_momentum about [0, 0, 0] at end", K: ball.kinetic_energy at start}
""")
    )
    assert "At the end: angular momentum of ball about (0, 0, 0); this gives L." in line_with(lines, "2. At the end")


def test_cases_of_letters_that_are_planned_alike_have_one_plan() -> None:
    """Each case stands below its condition, and none is headed by a word that says nothing."""
    lines = text_of(solve(ROACH))
    assert line_with(lines, "Plan").endswith("Newton's second law for roach.")
    assert {"If w > √(μ g/b)", "If w ≤ √(μ g/b)"} <= set(lines)
    assert "So" not in lines


# answers, remarks, signs


def test_a_vector_of_letters_is_printed_once() -> None:
    lines = text_of(solve(SHAFT))
    assert line_with(lines, "F = (").startswith("F = (−m l W², 0, m g)")
    assert not line_with(lines, "F = (").count("=") > 1


def test_what_cancels_is_told_of_the_vector_and_not_of_one_component() -> None:
    lines = text_of(
        solve("""
up: z
gravity: none
given: {m: 4 kg, a: 0.5 m, J: 3 N s}
bodies: {plate: {shape: rectangle, mass: m, sides: [a, a], points: {O: [a/2, a/2, 0], Q: [a/2, -a/2, 0]}}}
connections: {joint: {ball: plate.O}}
states: {before: at rest, after: {}}
events: {hit: {impulse: J, on: plate.Q, direction: z, from: before, to: after}}
find: {P: joint.impulse during hit}
""")
    )
    assert "P does not depend on" in line_with(lines, "cancel")


def test_axes_that_are_not_those_of_space_are_said_to_be_so() -> None:
    assert "axes of shaft: its own, not those of space" in line_with(text_of(solve(LEANING)), "axes of shaft")


def test_a_direction_below_zero_is_told_as_it_is_counted_to_a_whole_turn() -> None:
    lines = text_of(
        solve("""
up: z
gravity: none
given: {w: 10 rad/s, r: 0.2 m, M: 2 kg, mb: unknown, q: unknown}
bodies:
  rotor:
    parts: {one: {mass: M, at: [r, r, 0]}, b: {mass: mb, at: [r*cos(q), r*sin(q), 0]}}
    points: {O: [0, 0, 0]}
connections: {shaft: {hinge: rotor.O, along: z, angular_velocity: w}}
states: {now: {shaft.force.x: 0 N, shaft.force.y: 0 N}}
find: {m: mb, q: q in deg}
""")
    )
    assert line_with(lines, "counted to").endswith("= −135° (225° counted to 360°)")
