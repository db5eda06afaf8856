"""Work of a force: ∫ F · dr of the point on which it acts, for bodies of every kind, against what a hand calculates."""

from __future__ import annotations

from math import cos, pi, radians, sin, sqrt

import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve

M, L, F, G = 8.0, 3.0, 20.0, 9.8
GIVEN = "given: {M: 8 kg, L: 3 m, F: 20 N, d: 20 cm}\n"
LADDER = (
    GIVEN
    + """
title: Pole in the corner of a floor and a wall
surfaces: {floor: level, side: {wall: right}}
bodies: {pole: {shape: rod, mass: M, length: L}}
connections: {foot: {contact: [pole.start, floor]}, head: {contact: [pole.end, side]}}
states: {a: {pole.angle: 70 deg, at rest: all}, b: {pole.angle: 50 deg}}
"""
)
CART = (
    GIVEN
    + """
title: Pole that stands on a cart
surfaces: {floor: {slope: 30 deg, down: left}}
bodies: {cart: {mass: M, moves: down}, pole: {shape: rod, mass: M, length: L}}
connections: {base: {contact: [cart, floor]}, foot: {weld: [cart, pole.start]}}
states: {a: {at rest: all}, b: {cart.displacement: d}}
"""
)
LINKS = (
    GIVEN
    + """
title: Two poles that stand like a roof and slide apart
surfaces: {floor: level}
bodies: {first: {shape: rod, mass: M, length: L}, pole: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: first.start}, elbow: {hinge: [first.end, pole.start]}, foot: {contact: [pole.end, floor]}}
states:
  a: {first.angle: 70 deg, pole.angle: -70 deg, at rest: all}
  b: {first.angle: 50 deg, pole.angle: -50 deg}
"""
)
TABLE = (
    GIVEN
    + """
title: Pole on a table, held at one end
gravity: none
bodies: {pole: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: pole.start}}
"""
)
TURNED = "states: {a: {at rest: all}, b: {pole.rotation: 60 deg}}\n"
LOW, HIGH = radians(50), radians(70)
SQUARES = (HIGH - LOW) / 2  # ∫ sin² = SQUARES − DOUBLE, ∫ cos² = SQUARES + DOUBLE
DOUBLE = (sin(2 * HIGH) - sin(2 * LOW)) / 4

ENDS = "w: pole.angular_velocity at b, P: pull.power at b"

CASES = {
    "a pull down, on a ladder": (
        LADDER,
        "force: F, on: pole.at(3*L/4), direction: down",
        0.75 * F * L * (sin(HIGH) - sin(LOW)),
    ),
    "a pull at the foot of a ladder": (
        LADDER,
        "force: F, on: pole.start, direction: left",
        F * L * (cos(LOW) - cos(HIGH)),
    ),
    "a pull at an angle": (
        LADDER,
        "force: F, on: pole.center, direction: 200 deg",
        F * L / 2 * ((cos(LOW) - cos(HIGH)) * cos(radians(20)) + (sin(HIGH) - sin(LOW)) * sin(radians(20))),
    ),
    "a pull by components": (
        LADDER,
        "force: F, on: pole.center, direction: [-3, -4]",
        F * L / 2 * ((cos(LOW) - cos(HIGH)) * 0.6 + (sin(HIGH) - sin(LOW)) * 0.8),
    ),
    "a force that grows as the ladder sinks": (
        LADDER,
        "force: F*sin(pole.angle), on: pole.at(L/4), direction: left",
        0.75 * F * L * (SQUARES - DOUBLE),
    ),
    "a force that turns with the ladder": (
        LADDER,
        "force: F, on: pole.end, direction: clockwise",
        F * L * (SQUARES + DOUBLE),
    ),
    "a couple on a ladder": (LADDER, "couple: F*L, on: pole, direction: clockwise", F * L * (HIGH - LOW)),
    "a pull on what a cart carries": (
        CART,
        "force: F, on: pole.end, direction: left",
        F * 0.2 * cos(radians(30)),
    ),
    "a pull on the second of two links": (
        LINKS,
        "force: F, on: pole.at(L/3), direction: right",
        F * L * 4 / 3 * (cos(LOW) - cos(HIGH)),
    ),
    "a force that keeps its direction": (TABLE + TURNED, "force: F, on: pole.end, direction: up", F * L * sin(pi / 3)),
    "a force that goes with the turn": (TABLE + TURNED, "force: F, on: pole.end", F * L * pi / 3),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("moved", "action", "work"), CASES.values(), ids=CASES)
def test_work_is_that_of_the_point(moved: str, action: str, work: float) -> None:
    text = f"{moved}actions: {{pull: {{{action}}}}}\nfind: {{W: pull.work from a to b}}\n"
    found = solve(text, confirm=False)
    assert found.answers["W"].float == pytest.approx(work, rel=1e-6)


@pytest.mark.parametrize("action", [case[1] for case in CASES.values() if case[0] == LADDER])
def test_power_is_what_the_work_grows_by(action: str) -> None:
    """W over a small turn at the end of the motion, divided by the time that it takes, P = dW/dt."""
    text = f"{LADDER}actions: {{pull: {{{action}}}}}\nfind: {{W: pull.work from a to b, {ENDS}}}\n"
    works = [solve(text.replace("50 deg", f"{angle} deg"), confirm=False) for angle in (50.01, 50, 49.99)]
    rate = (works[2].answers["W"].float - works[0].answers["W"].float) / radians(0.02) * -works[1].answers["w"].float
    assert works[1].answers["P"].float == pytest.approx(rate, rel=1e-5)


@pytest.mark.parametrize("action", [case[1] for case in CASES.values() if case[0] == LADDER])
def test_speed_of_a_ladder_follows_from_weight_and_work(action: str) -> None:
    """K = M L² ω²/6 of a pole that slides along floor and wall."""
    found = solve(
        f"{LADDER}actions: {{pull: {{{action}}}}}\nfind: {{w: pole.angular_velocity at b, W: pull.work from a to b}}\n"
    )
    sunk = M * G * L / 2 * (sin(HIGH) - sin(LOW))
    assert found.answers["w"].float == pytest.approx(
        -sqrt(6 * (found.answers["W"].float + sunk) / (M * L**2)), rel=1e-6
    )


def test_a_force_on_a_free_pole_is_not_taken_for_a_steady_torque() -> None:
    """Its arm turns: α is not 6 F/(M L) for long."""
    text = GIVEN + "title: x\ngravity: none\nbodies: {pole: {shape: rod, mass: M, length: L}}\n"
    text += "actions: {pull: {force: F, on: pole.end, direction: up}}\nstates: {a: {at rest: all}, b: {time: 3 s}}\n"
    with pytest.raises((Unsolvable, SceneError)):
        solve(text + "find: {w: pole.angular_velocity at b}\n")


DRUM = """title: Load on a drum with a wire, or on a coil
given: {m: 2 kg, k: 3 N m/rad, c: 50 N/m, h: 20 cm}
bodies: {drum: {inertia: 0.4 kg m^2, radius: 10 cm, turns: counterclockwise}, load: {mass: m, moves: down}}
connections: {ax: {axle: drum}, s: {string: [load, drum]}, TIED}
states: {start: {STRETCHED, load.velocity: 2 m/s}, end: {load.displacement: h}}
find: {U: change of tied.potential_energy from start to end, W: tied.work from start to end,
  A: change of potential_energy from start to end, L: lost tied.potential_energy from start to end,
  G: change of load.potential_energy from start to end}
"""


@pytest.mark.parametrize("turns", ["counterclockwise", "clockwise"])
@pytest.mark.parametrize(
    ("tied", "stretched", "ends", "stiffness"),
    [
        ("tied: {torsion: drum, stiffness: k}", "drum.angle: 0", (0, 2), 3),
        ("tied: {torsion: drum, stiffness: k, rest_angle: WAY*1 rad}", "drum.angle: 0", (-1, 1), 3),
        ("tied: {spring: [ceiling, load], stiffness: c}", "tied.elongation: -5 cm", (-0.05, 0.15), 50),
    ],
)
def test_the_energy_of_an_element_is_its_own(
    tied: str, stretched: str, ends: tuple[float, float], stiffness: float, turns: str
) -> None:
    """½ k x² of the spring or wire that is named, beside weights, and its work the opposite; of all together the sum."""
    way, sides = {"counterclockwise": ("1", "[load, drum]"), "clockwise": ("-1", "[drum, load]")}[turns]
    text = DRUM.replace("TIED", tied).replace("STRETCHED", stretched).replace("WAY", way)
    told = text.replace("turns: counterclockwise", f"turns: {turns}").replace("[load, drum]", sides)
    answers = solve(told, confirm=False).answers
    own = stiffness / 2 * (ends[1] ** 2 - ends[0] ** 2)
    assert answers["U"].float == pytest.approx(own, abs=1e-9)
    assert answers["W"].float == answers["L"].float == pytest.approx(-own, abs=1e-9)
    assert answers["G"].float == pytest.approx(-2 * G * 0.2)
    assert answers["A"].float == pytest.approx(own - 2 * G * 0.2)


ATWOOD = """title: Two loads over a wheel
given: {m: 1 kg, M: 2 kg, h: 10 cm}
bodies: {one: {mass: M, moves: down}, wheel: {shape: disc, mass: m, radius: 10 cm}, two: {mass: m, moves: up}}
connections: {ax: {axle: wheel}, s: {string: [one, wheel, two]}}
states: {start: {at rest: all}, end: {one.displacement: h}}
find: {J: ASKED from start to end, t: time from start to end, S: s.work from start to end}
"""


@pytest.mark.parametrize(
    ("asked", "force"), [("s.impulse", 2), ("s.impulse.y", 2), ("s.impulse.x", 0), ("ax.impulse.y", 3)]
)
def test_an_impulse_over_a_phase_is_that_on_the_body_named_last(asked: str, force: int) -> None:
    """The pull on the last load upwards, and the push on the wheel: both pulls and its weight."""
    answers = solve(ATWOOD.replace("ASKED", asked)).answers
    a = (2 - 1) * G / 3.5
    pulls = [2 * (G - a), G + a]
    size = {0: 0.0, 2: pulls[1], 3: sum(pulls) + G}[force]
    assert answers["J"].float == pytest.approx(size * sqrt(2 * 0.1 / a), abs=1e-12)
    assert answers["S"].float == 0


def test_an_impulse_in_two_directions_is_asked_by_its_components() -> None:
    refused = solve(ATWOOD.replace("ASKED", "ax.impulse")).refused["J"].fault
    assert "in several directions" in refused.message
    assert "ax.impulse.x" in refused.help


@pytest.mark.parametrize("word", ["work", "power", "force", "impulse"])
def test_an_end_of_a_string_has_its_tension_alone(word: str) -> None:
    with pytest.raises(SceneError, match=f"`s.two` has no quantity `{word}`"):
        solve(ATWOOD.replace("ASKED", f"s.two.{word}"))
