"""Vectors: components, size and direction; tangential and normal components of points on an axis and in free motion."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from fractions import Fraction

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Number, call
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import heading
from rotsolve.pipeline import solve
from rotsolve.solution.answer import AnswerView

WHEEL = """
title: Wheel rolling faster and faster
given: {R: 0.3 m, v: 2 m/s, a: 1.5 m/s^2, phi: 25 deg}
surfaces: {floor: level}
bodies: {wheel: {shape: disc, mass: 2 kg, radius: R, moves: right, points: {P: [R*cos(phi), R*sin(phi)]}}}
connections: {road: {rolls: [wheel, floor]}}
actions: {push: {force: unknown, on: wheel.center, direction: right}}
states: {now: {wheel.velocity: v, wheel.acceleration: a}}
find: {%s}
"""
PLATE = """
title: Plate speeding up about a corner
gravity: none
given: {p: 0.4 m, q: 0.3 m, w: 3 rad/s, e: 2 rad/s^2, m: 1.5 kg}
bodies:
  plate: {shape: rectangle, sides: [p, q], mass: m, turns: TURN, points: {P: [p/2, q/2]}}
connections: {nail: {hinge: plate.corner1}}
states: {now: {plate.angular_velocity: w, plate.angular_acceleration: e}}
find: {FIND}
"""


def answers(scene: str) -> Mapping[str, AnswerView]:
    return solve(scene).answers


def numbers(answer: AnswerView) -> list[float | None]:
    return [part.float for part in answer.components.values()]


def rim(phi: float) -> tuple[complex, complex]:
    """Velocity and acceleration of the wheel's P as complex numbers, by v + ω × r and a + α × r − ω² r."""
    radius, v, a = 0.3, 2.0, 1.5
    spot = radius * complex(math.cos(phi), math.sin(phi))
    spin, rate = -v / radius, -a / radius
    return v + 1j * spin * spot, a + 1j * rate * spot - spin**2 * spot


def test_a_vector_has_components_size_and_direction() -> None:
    found = answers(WHEEL % "u: wheel.P.velocity, b: wheel.P.acceleration")
    for name, expected in zip("ub", rim(math.radians(25)), strict=True):
        answer = found[name]
        assert numbers(answer) == pytest.approx([expected.real, expected.imag], rel=1e-12)
        assert answer.float == pytest.approx(abs(expected), rel=1e-12)
        assert answer.angle == pytest.approx(math.degrees(math.atan(abs(expected.imag / expected.real))), rel=1e-12)
        assert list(answer.components) == [f"{name}_x", f"{name}_y"]
    assert found["u"].direction == "down and to the right"
    assert found["b"].direction == "down and to the left"


def test_tangential_is_along_the_own_velocity_in_free_motion() -> None:
    found = answers(
        WHEEL % "s: wheel.P.acceleration.tangential, n: wheel.P.acceleration.normal, c: wheel.P.velocity.normal"
    )
    velocity, acceleration = rim(math.radians(25))
    along = (acceleration * velocity.conjugate()) / abs(velocity)
    assert found["s"].float == pytest.approx(along.real, rel=1e-12)
    assert found["n"].float == pytest.approx(abs(along.imag), rel=1e-12)
    assert found["c"].float == 0
    assert not found["s"].components


def test_the_top_of_a_rolling_wheel() -> None:
    found = answers(WHEEL % "s: wheel.top.acceleration.tangential, n: wheel.top.acceleration.normal")
    assert (found["s"].exact, found["n"].exact) == ("2 a", "v²/R")


def test_a_point_at_rest_has_no_tangent() -> None:
    with pytest.raises(Unsolvable, match="bottom is at rest: its path has no direction there"):
        solve(WHEEL % "s: wheel.bottom.acceleration.tangential")


@pytest.mark.parametrize(("turns", "sense"), [("counterclockwise", 1), ("clockwise", -1)])
def test_on_an_axis_tangential_is_along_the_positive_turn_and_normal_towards_the_axis(turns: str, sense: int) -> None:
    asked = ", ".join(
        f"{name}: {path}"
        for name, path in {
            "vt": "plate.corner3.velocity.tangential",
            "vn": "plate.corner3.velocity.normal",
            "bt": "plate.corner3.acceleration.tangential",
            "bn": "plate.corner3.acceleration.normal",
            "b": "plate.corner3.acceleration",
            "Ft": "plate.force.tangential",
            "Fn": "plate.force.normal",
            "Nt": "nail.force.tangential",
            "Nn": "nail.force.normal",
        }.items()
    )
    scene = PLATE.replace("TURN", turns).replace("FIND", asked)
    scene = scene.replace("states:", "actions: {motor: {couple: unknown, on: plate}}\nstates:")
    found = answers(scene)
    radius, w, e, m = 0.5, 3.0, 2.0, 1.5
    spot = complex(0.4, 0.3)
    acceleration = 1j * sense * e * spot - w**2 * spot
    expected = {
        "vt": radius * w,
        "vn": 0,
        "bt": radius * e,
        "bn": radius * w**2,
        "Ft": m * radius / 2 * e,
        "Fn": m * radius / 2 * w**2,
        "Nt": m * radius / 2 * e,
        "Nn": m * radius / 2 * w**2,
    }
    assert {name: found[name].float for name in expected} == pytest.approx(expected, rel=1e-12)
    assert numbers(found["b"]) == pytest.approx([acceleration.real, acceleration.imag], rel=1e-12)


def test_a_vector_along_an_axis_is_told_shortly() -> None:
    solution = solve(WHEEL % "u: wheel.top.velocity, W: wheel.force.gravity")
    u, weight = solution.answers["u"], solution.answers["W"]
    assert (u.direction, weight.direction) == ("to the right", "down")
    assert numbers(u) == pytest.approx([4, 0])
    assert numbers(weight) == pytest.approx([0, -19.6])
    assert "u_x" not in solution.to("text") and "uₓ" not in solution.to("text")


def test_a_component_asked_before_is_not_worked_out_again() -> None:
    solution = solve(WHEEL % "u_y: wheel.P.velocity.y, u: wheel.P.velocity, k: u/v")
    text = solution.to("text")
    assert text.count("velocity of the wheel's P, vertically") + text.count("velocity of wheel") == 1
    velocity, _ = rim(math.radians(25))
    assert solution.answers["k"].float == pytest.approx(abs(velocity) / 2, rel=1e-12)


def test_displacement_of_a_point_is_a_chord() -> None:
    scene = """
title: Chord
gravity: none
given: {L: 2 m, w: 0.5 rad/s}
bodies: {rod: {shape: rod, mass: 1 kg, length: L}}
connections: {pin: {hinge: rod.start}}
states: {one: {rod.angle: 30 deg, rod.angular_velocity: w}, two: {rod.angle: 90 deg}}
find: {s: rod.end.displacement from one to two}
"""
    found = answers(scene)["s"]
    assert numbers(found) == pytest.approx([-math.sqrt(3), 1], rel=1e-12)
    assert found.float == pytest.approx(2, rel=1e-12)
    drawn = answers(scene.replace("rod.angle: 30 deg, ", "").replace("rod.angle: 90 deg", "time: 1 s"))[
        "s"
    ]  # level at first
    assert numbers(drawn) == pytest.approx([2 * math.cos(0.5) - 2, 2 * math.sin(0.5)], rel=1e-12)


def test_a_blow_is_that_on_the_last_named_body() -> None:
    scene = """
title: Ball sticks to a rod
given: {m: 1 kg, M: 3 kg, L: 1 m, u: 4 m/s}
plane: horizontal
bodies: {rod: {shape: rod, mass: M, length: L}, ball: {mass: m, moves: right}}
connections: {pin: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, rod.angular_velocity: 0, ball.velocity: u}, after: {}}
events: {hit: {joins: [ball, rod.at(3*L/4)], from: before, to: after}}
find: {K: hit.impulse during hit, J: pin.impulse during hit, p: change of momentum from before to after}
"""
    turned = "joins: [rod.at(3*L/4), ball]"
    omega = 0.75 * 4 / (1 + 0.75**2)  # m u ¾L = (⅓ M L² + m (¾L)²) ω
    found = answers(scene)
    assert numbers(found["K"]) == pytest.approx([4 - 0.75 * omega, 0])
    assert numbers(found["J"]) == pytest.approx(numbers(found["p"]))
    assert found["J"].float == pytest.approx(3 * omega / 2 - (4 - 0.75 * omega))
    assert numbers(answers(scene.replace("joins: [ball, rod.at(3*L/4)]", turned))["K"]) == pytest.approx(
        [-(4 - 0.75 * omega), 0]
    )


def test_change_and_mean_of_a_vector_are_vectors() -> None:
    scene = """
title: Disc turning steadily
gravity: none
given: {R: 2 m, w: 0.5 rad/s}
bodies: {disc: {shape: disc, mass: 1 kg, radius: R, points: {P: [R, 0]}}}
connections: {axle: {axle: disc}}
states: {one: {disc.angle: 0, disc.angular_velocity: w}, two: {disc.angle: 90 deg}}
find:
  d: change of disc.P.velocity from one to two
  b: lost disc.P.velocity from one to two
  m: mean disc.P.velocity from one to two
  s: change of disc.P.speed from one to two
  k: size of disc.P.velocity at two
"""
    found = answers(scene)
    assert numbers(found["d"]) == pytest.approx([-1, -1])
    assert numbers(found["b"]) == pytest.approx([1, 1])
    assert found["d"].float == pytest.approx(math.sqrt(2))
    assert numbers(found["m"]) == pytest.approx([-2 / math.pi, 2 / math.pi])
    assert (found["s"].float, found["k"].float) == (0, 1)


@pytest.mark.parametrize(("y", "x"), [(1, 2), (3, -4), (-1, 2), (-2, -5)])
def test_the_direction_of_a_plain_slope_has_exact_components(y: int, x: int) -> None:
    own = heading(call("atan2", Number(Fraction(y)), Number(Fraction(x))))
    for sense, turned in itertools.product((1, -1), (0, 90, 180, 270)):
        found = (own if sense > 0 else -own).turned(turned)
        angle = sense * math.atan2(y, x) + math.radians(turned)
        for value, expected in ((found.cos(), math.cos(angle)), (found.sin(), math.sin(angle))):
            assert evaluate(value, {}).float == pytest.approx(expected, rel=1e-12)
            assert "atan2" not in to_text(value)


def test_a_plate_is_turned_by_the_angle_of_its_centre_of_mass() -> None:
    scene = """
title: Plate
given: {s: 0.4 m, M: 1 kg, w: 3 rad/s}
bodies: {plate: {shape: rectangle, sides: [s, s/2], mass: M, turns: clockwise}}
connections: {nail: {hinge: plate.corner1}}
states: {now: {plate.angular_velocity: w, plate.angle: 0}}
find: {F: nail.force}
"""
    arm = math.sqrt(0.4**2 + 0.2**2) / 2
    rate = 9.8 * arm / (4 / 3 * arm**2)
    solution = solve(scene)
    assert numbers(solution.answers["F"]) == pytest.approx([-arm * 9, 9.8 - arm * rate])
    assert "atan2" not in solution.to("text")


def test_momentum_of_the_whole_scene_is_a_vector() -> None:
    scene = """
title: Two particles
gravity: none
given: {m: 2 kg, M: 3 kg, u: 4 m/s, w: 1 m/s}
bodies: {one: {mass: m, moves: right}, two: {mass: M, moves: up}}
states: {now: {one.velocity: u, two.velocity: w}}
find: {p: momentum, q: two.momentum.y}
"""
    found = answers(scene)
    assert numbers(found["p"]) == pytest.approx([8, 3])
    assert found["q"].float == 3


@pytest.mark.parametrize(
    ("pair", "way", "word", "twist"),
    [
        ("[ball, rod.end]", "left", "left", 0.9),
        ("[rod.end, ball]", "left", "right", 0),
        ("[ball, rod.end]", "right", "left", 0.9),
        ("[ball, rod.start]", "left", "left", -0.9),
    ],
)
def test_a_collision_acts_on_its_last_named_body(pair: str, way: str, word: str, twist: float) -> None:
    scene = f"""title: Ball that bounces off an upright rod on its centre
plane: horizontal
given: {{u: {"3" if way == "left" else "-3"} m/s}}
bodies: {{rod: {{shape: rod, mass: 2 kg, length: 1 m}}, ball: {{mass: 1 kg, moves: {way}}}}}
connections: {{pin: {{hinge: rod.center}}}}
states: {{before: {{rod.angle: 90 deg, at rest: rod, ball.velocity: u}}, after: {{}}}}
events: {{hit: {{collides: {pair}, restitution: 1/2, from: before, to: after}}}}
find: {{J: hit.impulse during hit, H: hit.angular_impulse during hit, size: size of hit.impulse during hit}}
"""
    answers = solve(scene).answers
    assert answers["J"].direction == word
    assert abs(answers["J"].float or 0) == answers["size"].float == pytest.approx(1.8)
    assert answers["H"].float == pytest.approx(twist)


def test_angular_momentum_about_a_point_of_the_body_itself() -> None:
    scene = """
title: Ball that rolls, rod that slides and spins
gravity: none
surfaces: {floor: level}
bodies: {ball: {shape: sphere, mass: 2 kg, radius: 10 cm, moves: right}, rod: {shape: rod, mass: 2 kg, length: 1 m}}
connections: {base: {rolls: [ball, floor]}}
states: {now: {ball.velocity: 3 m/s, rod.angle: 90 deg, "rod.velocity": [3 m/s, 0], rod.angular_velocity: 4 rad/s}}
find:
  foot: ball.angular_momentum about ball.bottom
  own: ball.angular_momentum about ball.center
  start: rod.angular_momentum about rod.start
  end: rod.angular_momentum about rod.end
"""
    found = answers(scene)
    expected = {"foot": 0.84, "own": 0.24, "start": 2 / 3 - 3, "end": 2 / 3 + 3}
    assert {name: view.float for name, view in found.items()} == pytest.approx(expected)
    assert found["foot"].direction == "clockwise"


def test_kinetic_energy_is_named_by_its_part_and_written_with_squares() -> None:
    scene = """
title: Ball that rolls, rod that flies
gravity: none
given: {m: 2 kg, v: 3 m/s, w: 4 rad/s}
surfaces: {floor: level}
bodies: {ball: {shape: sphere, mass: m, moves: right}, rod: {shape: rod, mass: m, length: 100 cm}}
connections: {base: {rolls: [ball, floor]}}
states: {now: {ball.velocity: v, rod.angle: 90 deg, "rod.velocity": [v, 2*v], rod.angular_velocity: w}}
find: {A: ball.kinetic_energy.rotational, B: ball.kinetic_energy.translational, C: rod.kinetic_energy.translational}
"""
    solution = solve(scene)
    assert [solution.answers[name].float for name in "ABC"] == pytest.approx([3.6, 9, 45])
    text = solution.to("text")
    assert "rotational kinetic energy of ball" in text and "B = ½ m v²" in text and "v v" not in text


def test_the_size_of_a_vector_needs_no_bars() -> None:
    scene = """
given: {M: 1 kg, L: 1 m}
bodies: {stick: {shape: rod, mass: M, length: L}}
connections: {pivot: {hinge: stick.start}}
states: {up: {stick.angle: 90 deg, at rest: all}, down: {stick.angle: 0}}
find: {F: size of pivot.force at down}
"""
    assert "|" not in str(solve(scene))
