"""Bodies that are welded and thrown: whatever is asked of one of them, or of a point, is told as all are turned by then.

The numbers come from m r̈ = F of the common centre of mass and a turn w t, in plane arithmetic of its own.
"""

from __future__ import annotations

from cmath import exp
from math import isclose

import pytest

from rotsolve.pipeline import solve

G, L, M, N, R, U, V, W, T = 9.8, 0.5, 1.5, 2.0, 0.3, 3.8, 1.5, 2.4, 0.7
THROWN = f"""
given: {{L: {L} m, m: {M} kg, M: {N} kg, R: {R} m, u: {U} m/s, v: {V} m/s, w: {W} rad/s, t1: {T} s}}
bodies:
  hub: {{shape: disc, mass: M, radius: R}}
  plate: {{shape: rectangle, mass: m, sides: [L, L]}}
connections: {{bolt: {{weld: [hub.center, plate.corner1]}}}}
states: {{start: {{hub.velocity: [u, v], hub.angular_velocity: w}}, end: {{time: t1}}}}
find: {{q: QUESTION}}
"""
TURN = exp(1j * W * T)
PLATE, HUB = (N / (M + N) * (L + L * 1j) / 2 * TURN, -M / (M + N) * (L + L * 1j) / 2 * TURN)  # from the common centre
AT_FIRST = U + V * 1j - 1j * W * HUB / TURN  # its velocity: the scene tells that of the hub
MOVES = AT_FIRST - G * T * 1j
PLATE_MOVES = MOVES + 1j * W * PLATE
PULLED = M * (-G * 1j - W**2 * PLATE)
CORNER = PLATE + (L - L * 1j) / 2 * TURN * 1j  # the third of its corners, counterclockwise from below on the left
CORNER_MOVES = MOVES + 1j * W * CORNER
SPIN_OF_PLATE = M * L**2 / 6 * W


def cross(one: complex, other: complex) -> float:
    return (one.conjugate() * other).imag


def dot(one: complex, other: complex) -> float:
    return (one.conjugate() * other).real


ASKED = {
    "plate.speed": abs(PLATE_MOVES),
    "plate.corner3.speed": abs(CORNER_MOVES),
    "plate.kinetic_energy": M * abs(PLATE_MOVES) ** 2 / 2 + SPIN_OF_PLATE * W / 2,
    "plate.force.x": PULLED.real,
    "plate.force": abs(PULLED),
    "plate.power": dot(PULLED, PLATE_MOVES),
    "plate.power.gravity": -M * G * PLATE_MOVES.imag,
    "plate.instantaneous_centre.x": -PLATE_MOVES.imag / W,
    "plate.corner3.acceleration.tangential": dot(-G * 1j - W**2 * CORNER, CORNER_MOVES) / abs(CORNER_MOVES),
    "hub.acceleration.x": (-(W**2) * HUB).real,
    "plate.angular_momentum about hub.center": SPIN_OF_PLATE + cross(PLATE - HUB, M * PLATE_MOVES),
}


@pytest.mark.parametrize("question", ASKED)
def test_what_is_asked_is_told_as_they_are_turned(question: str) -> None:
    path, about, point = question.partition(" about ")
    solution = solve(THROWN.replace("QUESTION", f"{path}{about}{point} at end"))
    found = solution.answers["q"].float
    assert found is not None and isclose(found, ASKED[question], rel_tol=1e-6), found
    assert all(item.holds for item in solution.derivation.confirmed)


def test_a_part_of_a_thrown_body_goes_round() -> None:
    """A hammer: its head, L/3 from the common centre of mass, moves with v + ω × r as it is turned by then."""
    found = solve("""
given: {L: 60 cm, m: 1 kg, u: 3 m/s, w: 4 rad/s, t1: 0.3 s}
bodies:
  hammer: {parts: {stick: {mass: m, at: [0, 0]}, head: {mass: 2*m, at: [L, 0]}}}
states: {start: {hammer.velocity: [u, 0], hammer.angular_velocity: w}, end: {time: t1}}
find: {v: hammer.head.speed at end, K: hammer.kinetic_energy at end}
""").answers
    moves = 3 - G * 0.3j + 4j * 0.2 * exp(1.2j)
    assert isclose(found["v"].float or 0, abs(moves), rel_tol=1e-6)
    assert isclose(found["K"].float or 0, 1.5 * abs(3 - G * 0.3j) ** 2 + 0.5 * (0.16 + 2 * 0.04) * 16, rel_tol=1e-6)


@pytest.mark.parametrize("question", ["axle.force.x", "axle.force.y", "bolt.force.x", "bolt.force.y"])
@pytest.mark.parametrize("collar", ["", ", press: P, friction: mu, radius: a"], ids=["smooth", "rubbing"])
def test_forces_at_a_joint_go_round_with_the_body_that_it_holds(question: str, collar: str) -> None:
    """On a level plane a couple turns a disc with a plate on its rim, against a collar or not, for a told time: what holds them there."""
    scene = f"""
plane: horizontal
given: {{M: {N} kg, m: {M} kg, R: {R} m, L: {L} m, Q: 3 N m, P: 5 N, mu: 0.4, a: 0.2 m, t1: {T} s}}
bodies: {{hub: {{shape: disc, mass: M, radius: R}}, plate: {{shape: rectangle, mass: m, sides: [L, L]}}}}
connections: {{axle: {{axle: hub{collar}}}, bolt: {{weld: [hub.top, plate.center]}}}}
actions: {{twist: {{couple: Q, on: hub}}}}
states: {{start: {{at rest: all}}, end: {{time: t1}}}}
find: {{q: {question} at end}}
"""
    drag = 2 / 3 * 0.4 * 5 * 0.2 if collar else 0.0  # of a flat collar that is pressed evenly
    rate = (3 - drag) / (N * R**2 / 2 + M * L**2 / 6 + M * R**2)
    pull = M * (1j * rate - (rate * T) ** 2) * 1j * R * exp(1j * rate * T**2 / 2)
    solution = solve(scene if collar else scene.replace(", P: 5 N, mu: 0.4, a: 0.2 m", ""))
    found = solution.answers["q"].float
    expected = pull.real if question.endswith("x") else pull.imag
    assert found is not None and isclose(found, expected, rel_tol=1e-6), found
    assert all(item.holds for item in solution.derivation.confirmed)
