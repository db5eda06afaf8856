"""What turns steadily on something that turns or is led: which of its angles and rates is meant, by hand and by the assembly.

A rod on a hinge of a turntable, at an angle α below the level: its weight and the centrifugal forces balance about the hinge,
g cos α = W² sin α (d + ⅔ L cos α).
"""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from rotsolve import Solution, Unsolvable, solve

TURNTABLE = """
up: z
given: {{M: 2 kg, L: 0.8 m, d: 0.3 m, W: 6 rad/s, g: 9.8 m/s^2, alpha: unknown}}
bodies:
  table: {{shape: disc, mass: 0, radius: 1 m, points: {{E: [d, 0, 0]}}}}
  rod: {{shape: rod, mass: M, length: L}}
connections:
  post: {{hinge: table.center, along: z, angular_velocity: W}}
  pin: {{hinge: [table.E, rod.start], along: y}}
states: {{now: {{rod.angle: {angle}, {more}steady: true}}}}
find: {{al: {word} alpha, F: pin.force in table axes}}
"""
GOVERNOR = """
up: z
given: {M: kg, L: m, W: rad/s, alpha: unknown, g: m/s^2}
bodies: {table: {shape: disc, mass: 0, radius: 1 m}, rod: {shape: rod, mass: M, length: L}}
connections:
  post: {hinge: table.center, along: z, angular_velocity: W}
  pin: {hinge: [table.center, rod.start], along: y}
states: {now: {rod.angle: 90 deg - alpha, steady: true}}
find: {al: WORD alpha, F: pin.force in table axes}
"""
TRUCK = """
up: z
given: {M: kg, L: m, a: m/s^2, g: m/s^2, alpha: unknown}
bodies: {truck: {mass: 0, acceleration: [a, 0, 0]}, rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: [truck, rod.start], along: y}}
states: {now: {rod.angle: alpha, steady: true}}
find: {al: largest alpha, F: pin.force}
"""
SPINNING = """
up: z
given: {M: 2 kg, R: 0.3 m, d: 0.5 m, W: 6 rad/s}
bodies: {table: {shape: disc, mass: 0, radius: d, points: {E: [d, 0, 0]}}, disc: {shape: disc, mass: M, radius: R}}
connections:
  post: {hinge: table.center, along: z, angular_velocity: W}
  pin: {hinge: [table.E, disc.center], along: z}
states: {now: {steady: true}}
find: {w: disc.angular_velocity}
"""
COUNTERWEIGHT = """
up: z
given: {M: 1.5 kg, R: 8 cm, l: 12 cm, m: 0.6 kg, c: 15 cm, s: 250 rad/s, g: 9.8 m/s^2}
bodies:
  frame: {parts: {w: {mass: m, at: [0, 0, -c]}}, axis: z, points: {O: [0, 0, 0], P: [0, 0, l]}}
  rotor: {shape: disc, mass: M, radius: R}
connections: {pivot: {ball: frame.O}, axle: {axle: [frame.P, rotor], along: z, angular_velocity: s}}
states: {now: {frame.tilt: 60 deg, frame.spin: 0 rad/s, LINEsteady: true}}
find: FIND
"""
NUMBERS = "M: 2 kg, L: 0.8 m, W: 6 rad/s, alpha: unknown, g: 9.8 m/s^2"
UPWARDS = math.degrees(math.acos(3 * 9.8 / (2 * 0.8 * 6**2)))  # of the vertical: cos = 3 g/(2 L W²)
DIGITS = 5e-4  # how far answers are printed
LETTERS = "{M: kg, R: m, l: m, m: kg, c: m, s: rad/s, g: m/s^2}"


def number(solution: Solution, name: str) -> float:
    return float(solution.answers[name].value)


def confirmed(solution: Solution) -> set[str]:
    return {item.name for item in solution.derivation.confirmed if item.holds}


def balanced() -> list[float]:
    """The angles between −180° and 180° at which weight and centrifugal forces balance about the hinge, and to which it comes back."""

    def left(a: float) -> float:
        return 36.0 * math.sin(a) * (0.3 + 1.6 / 3 * math.cos(a)) - 9.8 * math.cos(a)

    found, places = [], [-math.pi + 0.001 + k * 2 * math.pi / 999 for k in range(1000)]
    for low, high in pairwise(places):
        if left(low) < 0 <= left(high):  # beyond it, further down, more drives up
            for _ in range(60):
                middle = (low + high) / 2
                low, high = (middle, high) if left(low) * left(middle) > 0 else (low, middle)
            found.append(low)
    return found


@pytest.mark.parametrize("more", ["", "rod.angular_velocity: 0 rad/s, "])
@pytest.mark.parametrize("word", ["smallest", "largest"])
def test_the_largest_and_the_smallest_angle_lie_within_half_a_turn(word: str, more: str) -> None:
    solution = solve(TURNTABLE.format(angle="alpha", more=more, word=word))
    meant = (min if word == "smallest" else max)(balanced())
    assert number(solution, "al") == pytest.approx(meant, rel=DIGITS)
    assert confirmed(solution) == {"al", "F"}


@pytest.mark.parametrize(
    ("angle", "shift"), [("alpha + 250 deg", 250.0), ("alpha - 100 deg", -100.0), ("alpha + 120 deg", 120.0)]
)
def test_so_does_one_that_is_counted_from_elsewhere(angle: str, shift: float) -> None:
    solution = solve(TURNTABLE.format(angle=angle, more="", word="largest"))
    angles = [math.remainder(one - math.radians(shift), 2 * math.pi) for one in balanced()]
    assert number(solution, "al") == pytest.approx(max(angles), rel=DIGITS)
    assert confirmed(solution) == {"al", "F"}


@pytest.mark.parametrize(
    ("word", "angle", "meant"),
    [
        ("smallest", "90 deg - alpha", -UPWARDS),
        ("largest", "90 deg - alpha", UPWARDS),
        ("smallest", "200 deg - alpha", 110.0 - UPWARDS),
        ("smallest", "alpha + 200 deg", -110.0 - UPWARDS),
    ],
)
def test_an_angle_in_closed_form_is_turned_back_into_half_a_turn(word: str, angle: str, meant: float) -> None:
    scene = GOVERNOR.replace("WORD", word).replace("90 deg - alpha", angle)
    solution = solve(scene.replace("M: kg, L: m, W: rad/s, alpha: unknown, g: m/s^2", NUMBERS))
    assert math.degrees(number(solution, "al")) == pytest.approx(meant, rel=DIGITS)
    assert "al" in confirmed(solution)


def test_each_case_of_an_angle_in_letters_is_held_against_the_assembly() -> None:
    solution = solve(GOVERNOR.replace("WORD", "smallest"))
    told = str(solution.answers["al"])
    assert "arccos(3 g/(2 L W²))" in told and "⅔ L W²" in told
    assert confirmed(solution) == {"al", "F"}


def test_what_hangs_in_a_truck_does_not_swing_in_a_steady_state() -> None:
    solution = solve(TRUCK)
    assert str(solution.answers["al"]).endswith("π − arctan(g/a)") and "(M a, 0, M g)" in str(solution.answers["F"])
    assert confirmed(solution) == {"al", "F"}


def test_what_is_round_may_spin_steadily_on_its_hinge() -> None:
    with pytest.raises(Unsolvable, match="too little is known"):
        solve(SPINNING)


# a gyroscope that carries its rotor: φ̇ by I φ̇² sin θ cos θ + I₃ s φ̇ sin θ = (M l − m c) g sin θ about the pivot


def precessions() -> list[float]:
    across, axial = 0.6 * 0.15**2 + 1.5 * 0.12**2 + 1.5 * 0.08**2 / 4, 1.5 * 0.08**2 / 2
    a, b, c = (axial - across) * 0.5, axial * 250.0, -(1.5 * 0.12 - 0.6 * 0.15) * 9.8
    root = math.sqrt(b * b - 4 * a * c)
    return sorted([(-b + root) / (2 * a), (-b - root) / (2 * a)])


@pytest.mark.parametrize(
    ("line", "find"),
    [
        ("", "{slow: smallest frame.precession, fast: largest frame.precession}"),
        ("frame.precession: smallest, ", "{slow: frame.precession, fast: largest frame.precession}"),
        ("frame.precession: largest, ", "{slow: smallest frame.precession, fast: frame.precession}"),
    ],
)
def test_both_precessions_of_what_carries_its_rotor(line: str, find: str) -> None:
    solution = solve(COUNTERWEIGHT.replace("LINE", line).replace("FIND", find))
    assert [number(solution, name) for name in ("slow", "fast")] == pytest.approx(precessions(), rel=DIGITS)
    assert confirmed(solution) == {"slow", "fast"}


def test_they_are_told_by_cases_in_letters() -> None:
    scene = COUNTERWEIGHT.replace("LINE", "").replace("FIND", "{slow: smallest frame.precession}")
    given = next(line for line in scene.splitlines() if line.startswith("given"))
    solution = solve(scene.replace(given, f"given: {LETTERS}"))
    assert confirmed(solution) == {"slow"}
