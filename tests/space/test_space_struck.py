"""What stays through a blow: how bodies stand, by an angle, a tilt or the vertical, and where they are.

Values by hand, and every answer by the assembly of all bodies' equations.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import solve

DOOR = """given: {m: 20 kg, b: 1 m, h: 2 m, J: 5 N s}
bodies:
  door: {shape: rectangle, mass: m, sides: [b, h], turned: {about: x, by: 90 deg}, points: {A: [-b/2, 0, 0], B: [b/2, 0, 0]}}
connections: {post: {hinge: door.A, along: y}}
states: {before: {door.angle: 30 deg, door.angular_velocity: 0 rad/s}, after: {}}
events: {hit: {impulse: J, on: door.B, direction: [0, 1, 0], from: before, to: after}}
"""
ROD = """given: {m: 2 kg, b: 1 m, J: 5 N s, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: m, length: b, turned: {about: y, by: 90 deg}}}
connections: {post: {hinge: rod.start, along: y}}
states:
  start: {rod.angle: 60 deg, rod.angular_velocity: 0 rad/s}
  before: {rod.angle: 0 deg}
  after: {}
  up: {rod.angle: -90 deg}
events: {hit: {impulse: J, on: rod.end, direction: x, from: before, to: after}}
"""
LEANING = """given: {m: 0.5 kg, a: 0.1 m, I1: 0.02 kg m^2, I3: 0.03 kg m^2, J: 2 N s, v: 1 m/s, w: 10 rad/s, g: 9.8 m/s^2}
bodies:
  top: {mass: m, inertia: {principal: [I3, I3, I1], about: tip}, points: {tip: [-a, 0, 0]}}
  ball: {shape: particle, mass: m}
connections: {floor: {ball: top.tip}}
states:
  before: {"top.angular_velocity in body axes": [0, 0, w], top.vertical: [0.6, 0, 0.8], ball.position: [a, 0, 0], ball.velocity: [0, 0, v]}
  after: {}
events: {hit: {impulse: J, on: ball, direction: y, from: before, to: after}}
"""
CENTRAL = """gravity: none
given: {m: 3 kg, a: 0.7 m, J: 2e5 N s, th: 33 deg}
bodies: {box: {shape: cuboid, mass: m, sides: [a, 3*a/7, a/7], turned: {about: z, by: th}, points: {P: [a/2, 0, 0]}}}
states: {before: at rest, after: {}}
events: {hit: {impulse: J, on: box.P, direction: [cos(th), sin(th), 0], from: before, to: after}}
"""
RATE = 0.25 * 3 * math.sqrt(3) / 2
FALLEN = math.sqrt(3 * 9.8 / 2)  # of the rod from 60° down
CASES = {
    "a door that stands open": (
        DOOR + "find: {w: door.angular_velocity at after, th: door.angle at after, v: door.B.velocity at after, "
        "F: post.force at after}\n",
        {
            "w": (0, 0, RATE),
            "th": (math.pi / 6,),
            "v": (-RATE / 2, RATE * math.sqrt(3) / 2, 0),
            "F": (-10 * RATE**2 * math.sqrt(3) / 2, -5 * RATE**2, 20 * 9.8),
        },
    ),
    "that told no angle": (
        DOOR.replace("door.angle: 30 deg, ", "") + "find: {th: door.angle at after, v: door.B.velocity at after}\n",
        {"th": (0,), "v": (0, 0.75, 0)},
    ),
    "a rod that swings down, is struck, and swings on": (
        ROD
        + "find: {w: rod.angular_velocity.y at after, th: rod.angle at after, u: size of rod.angular_velocity at up}\n",
        {"w": (-FALLEN - 7.5,), "th": (0,), "u": (math.sqrt((FALLEN + 7.5) ** 2 - 29.4),)},
    ),
    "what leans by its vertical, and where a ball is": (
        LEANING + "find: {E: top.energy at after, T: top.torque.gravity at after in body axes, "
        'L: "ball.angular_momentum at after about [0, 0, 0]"}\n',
        {"E": (1 + 0.06 * 4.9,), "T": (0, 0.08 * 4.9, 0), "L": (0, -0.05, 0.2)},
    ),
    "what a large blow through the centre does not turn": (
        CENTRAL + "find: {w: box.angular_velocity at after, K: box.kinetic_energy.rotational at after, "
        "L: box.angular_momentum at after, v: box.velocity at after in body axes}\n",
        {"w": (0, 0, 0), "K": (0,), "L": (0, 0, 0), "v": (2e5 / 3, 0, 0)},
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_stays_through_a_blow(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(f"title: T\nup: z\n{scene}").complete().derivation
    assert derivation.confirmed
    assert all(item.holds for item in derivation.confirmed), derivation.confirmed
    for answer in derivation.answers:
        found = [part.value.float for part in answer.components or (answer,) if part.value is not None]
        assert found == pytest.approx(list(known[answer.name]), rel=1e-9, abs=1e-9), answer.name
