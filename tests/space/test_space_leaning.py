"""How a body leans: the axis of what has no mass is that of its shape, two bodies that lean on each other have to be told to which sides,
and Euler angles go with any way in which a state tells how the body turns. Numbers by numpy, from the definitions alone.
"""

from __future__ import annotations

import math
from typing import Any

import numpy
import pytest

from rotsolve import Unsolvable, solve

STRING = """title: t
up: z
given: {M: 1 kg, l: 10 cm, L: 30 cm, C: 2e-3 kg m^2, A: 1e-3 kg m^2, w: 200 rad/s, W: unknown, b: unknown}
bodies: {string: {shape: SHAPE}, wheel: {mass: M, inertia: {principal: [A, A, C]}, axis: z, points: {P: [0, 0, -l]}}}
connections: {hook: {ball: string.end}, knot: {ball: [string.start, wheel.P]}}
states:
  now: {wheel.tilt: 90 deg, wheel.axial_rate: w, wheel.precession: W, string.tilt: b, string.precession: W, SIDES steady: true}
find: {W: W, b: b}
"""
SIDES = "wheel.precession_angle: 0 deg, string.precession_angle: 180 deg,"


@pytest.mark.parametrize("shape", ["rod, mass: 0, length: L", "rod, mass: 0 kg, length: L, axis: x"])
def test_the_axis_of_a_light_rod_lies_along_it(shape: str) -> None:
    """The force of the string lies along it: g tan β = Ω² (l + L sin β), Ω = M g l/(C ω₃)."""
    answers = solve(STRING.replace("SHAPE", shape).replace("SIDES", SIDES))
    rate, lean = (answers.answers[name].float for name in ("W", "b"))
    assert rate == pytest.approx(9.8 * 0.1 / (2e-3 * 200), rel=1e-12)
    assert 9.8 * math.tan(lean) == pytest.approx(rate**2 * (0.1 + 0.3 * math.sin(lean)), rel=1e-9)
    assert [item.holds for item in answers.derivation.confirmed] == [True, True]


@pytest.mark.parametrize("told", ["", "wheel.precession_angle: 0 deg,", "string.precession_angle: 180 deg,"])
def test_to_which_sides_two_bodies_lean_has_to_be_told(told: str) -> None:
    """Where the string leans to the other side it would have to push."""
    with pytest.raises(Unsolvable, match=r"to which side `(string|wheel)` leans at `now` nothing tells"):
        solve(STRING.replace("SHAPE", "rod, mass: 0, length: L").replace("SIDES", told))


BOX = """title: t
up: z
given: {M: 3 kg}
bodies: {box: {shape: cuboid, mass: M, sides: [0.6 m, 0.4 m, 0.2 m], axis: z, points: {P: [0.3 m, 0.2 m, -0.1 m]}}}
actions: {push: {force: [5 N, -1 N, 2 N], on: box.P}}
states: {now: {TOLD, box.precession_angle: 200 deg, box.tilt: 110 deg, box.spin_angle: -40 deg}}
find: {al: box.angular_acceleration, L: box.angular_momentum, K: box.kinetic_energy.rotational, w: box.axial_rate}
"""
OMEGA = numpy.array([1.0, 2.0, -3.0])  # in body axes
TENSOR = 3 / 12 * numpy.diag([0.4**2 + 0.2**2, 0.6**2 + 0.2**2, 0.6**2 + 0.4**2])


def turn(axis: int, degrees: float) -> Any:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    rows = {0: [[1, 0, 0], [0, c, -s], [0, s, c]], 2: [[c, -s, 0], [s, c, 0], [0, 0, 1]]}
    return numpy.array(rows[axis])


STANDS = turn(2, 200) @ turn(0, 110) @ turn(2, -40)
OF_EULER = numpy.linalg.inv(  # ω in body axes by the columns of φ̇, θ̇ and ψ̇
    numpy.column_stack([STANDS.T @ [0, 0, 1], turn(2, 40) @ [1, 0, 0], [0, 0, 1]])
)


def by_components(vector: Any) -> str:
    return "[" + ", ".join(f"{part:.17g} rad/s" for part in vector) + "]"


def by_rates(last: str) -> str:
    precession, nutation, spin = OF_EULER @ OMEGA
    value = spin if last == "spin" else OMEGA[2]
    rates = {"precession": precession, "nutation": nutation, last: value}
    return ", ".join(f"box.{word}: {rate:.17g} rad/s" for word, rate in rates.items())


@pytest.mark.parametrize(
    "told",
    [
        '"box.angular_velocity in body axes": ' + by_components(OMEGA),
        "box.angular_velocity: " + by_components(STANDS @ OMEGA),
        by_rates("spin"),
        by_rates("axial_rate"),
    ],
)
def test_euler_angles_go_with_all_that_tells_how_a_body_turns(told: str) -> None:
    answers = solve(BOX.replace("TOLD", told)).answers
    force = numpy.array([5.0, -1.0, 2.0])
    torque = numpy.cross([0.3, 0.2, -0.1], STANDS.T @ force)
    faster = numpy.linalg.solve(TENSOR, torque - numpy.cross(OMEGA, TENSOR @ OMEGA))
    for name, vector in (("al", STANDS @ faster), ("L", STANDS @ TENSOR @ OMEGA)):
        assert [part.float for part in answers[name].components.values()] == pytest.approx(list(vector), rel=1e-9)
    assert answers["K"].float == pytest.approx(OMEGA @ TENSOR @ OMEGA / 2, rel=1e-9)
    assert answers["w"].float == pytest.approx(-3, rel=1e-9)


DRIVEN = """title: t
up: z
gravity: none
given: {al: 7 rad/s^2, w: 3 rad/s}
bodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}}
connections: {shaft: {hinge: rod.center, along: z, angular_acceleration: al}}
states: {now: {STATE}}
find: {tau: shaft.torque.z, L: rod.angular_momentum.z}
"""


def test_a_driven_hinge_and_a_told_rate_are_confirmed() -> None:
    solution = solve(DRIVEN.replace("STATE", "rod.angular_velocity: w"))
    assert (solution.answers["tau"].float, solution.answers["L"].float) == pytest.approx((7 / 6, 0.5))
    assert [item.holds for item in solution.derivation.confirmed] == [True, True]


@pytest.mark.parametrize("state", ["steady: true", "rod.angular_velocity: w, steady: true"])
def test_what_is_driven_faster_and_faster_is_not_steady(state: str) -> None:
    with pytest.raises(Unsolvable, match="faster and faster"):
        solve(DRIVEN.replace("STATE", state))
