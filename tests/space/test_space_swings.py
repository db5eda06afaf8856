"""Bodies in space on a hinge, or on two balls as on one: how they turn when they come to an angle the first time, and what holds them.

Values by hand, and every answer by the assembly of all bodies' equations, which follows the motion.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve

GIVEN = "given: {m: 20 kg, b: 1 m, h: 2 m, g: 9.8 m/s^2, v: 1 rad/s, J: 4 N s}\n"
PLATE = "bodies: {plate: {shape: rectangle, mass: m, sides: [b, h], points: {A: [-b/2, -h/2, 0], B: [b/2, -h/2, 0], C: [b/2, h/2, 0]}}}\n"
BALLS = "connections: {one: {ball: plate.A}, two: {ball: plate.B}}\n"
SCENE = GIVEN + PLATE + BALLS
HINGE = GIVEN + PLATE + "connections: {one: {hinge: plate.A, along: x}}\n"
HIT = "events: {hit: {impulse: J, on: plate.C, direction: [0, 0, 1], from: before, to: after}}\n"
FALL = "states: {now: {at rest: all}, low: {plate.angle: -60 deg}}\n"
BACK = (
    "states: {now: {plate.angular_velocity: v}, low: {plate.angle: ANGLE}}\nfind: {w: plate.angular_velocity at low}\n"
)
FALLEN = math.sqrt(3 * 9.8 * math.sqrt(0.75) / 2)  # ω² = 3 g sin 60°/h
TABLE = (
    "given: {m: 20 kg, b: 1 m, h: 2 m, g: 9.8 m/s^2, w: 3 rad/s}\n"
    "bodies:\n  table: {shape: disc, mass: m, radius: b, points: {P: [b/2, 0, 0], Q: [-b/2, 0, 0]}}\n"
    "  plate: {shape: rectangle, mass: m, sides: [b, h], points: {A: [b/2, -h/2, 0], B: [-b/2, -h/2, 0]}}\n"
    "connections:\n  hub: {hinge: table.center, along: z, angular_velocity: w}\n"
    "  one: {ball: [table.P, plate.A]}\n  two: {ball: [table.Q, plate.B]}\n"
    "states: {now: {plate.angle: 0 deg, plate.angular_velocity: 0 rad/s}}\n"
)
TOP = """given: {{M: 0.2 kg, l: 0.05 m, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2, w3: 200 rad/s, theta: 20 deg}}
bodies: {{top: {{mass: M, inertia: {{about: tip, principal: [I1, I1, I3]}}, axis: z, points: {{tip: [0, 0, -l]}}}}}}
connections: {{floor: {{ball: top.tip}}}}
states:
  start: {{top.tilt: theta, top.axial_rate: w3, top.precession: {rate}, top.nutation: 0 rad/s}}
  mid: {{top.tilt: {tilt}}}
find: {{nu: top.nutation at mid, W: top.precession at mid}}
"""
CASES = {  # a scene, and what is known of it by hand
    "a gate on two balls, let go": (
        SCENE + "states: {now: {at rest: all}}\n"
        "find: {al: plate.angular_acceleration, F: one.force.z, G: two.force.z, f: plate.freedoms}\n",
        {"al": (-7.35, 0, 0), "F": (24.5,), "G": (24.5,), "f": (1,)},
    ),
    "a gate on two balls that falls: the force at an end": (
        SCENE + FALL + "find: {w: plate.angular_velocity at low, F: one.force.y at low, G: two.force.z at low}\n",
        {"w": (-FALLEN, 0, 0)},
    ),
    "a plate on balls at two corners, which turns about its diagonal": (
        "gravity: none\n" + SCENE.replace("plate.B", "plate.C") + "states: {now: {plate.angular_velocity: v}}\n"
        "find: {H: plate.angular_momentum, F: one.force.z in body axes, K: plate.kinetic_energy}\n",
        {"H": (20 * 4 / 12 / math.sqrt(5), 20 * 2 / 12 / math.sqrt(5), 0)},
    ),
    "a plate on two balls, struck at a corner": (
        "gravity: none\n"
        + SCENE
        + "states: {before: at rest, after: {}}\n"
        + HIT
        + "find: {w: plate.angular_velocity at after, P: one.impulse.z during hit, Q: two.impulse.z during hit}\n",
        {"w": (0.3, 0, 0), "P": (3,), "Q": (-1,)},
    ),
    "two balls on a table that turns": (TABLE + "find: {al: plate.angular_acceleration, F: one.force.z}\n", {}),
    "a plate on a hinge that falls": (
        HINGE + FALL + "find: {w: plate.angular_velocity at low}\n",
        {"w": (-FALLEN, 0, 0)},
    ),
    "the same about the opposite direction": (
        HINGE.replace("along: x", "along: -x")
        + FALL.replace("-60", "60")
        + "find: {w: plate.angular_velocity at low}\n",
        {"w": (-FALLEN, 0, 0)},
    ),
    "one that is thrown up": (
        HINGE + BACK.replace("ANGLE", "40 deg").replace("v}", "5*v}"),
        {"w": (math.sqrt(25 - 14.7 * math.sin(math.radians(40))), 0, 0)},
    ),
    "one that is thrown up and falls back": (
        HINGE + BACK.replace("ANGLE", "-40 deg"),
        {"w": (-math.sqrt(1 + 14.7 * math.sin(math.radians(40))), 0, 0)},
    ),
    "one that a blow starts": (
        HINGE
        + "states: {before: at rest, after: {}, low: {plate.angle: -40 deg}}\n"
        + HIT
        + "find: {w: plate.angular_velocity at low}\n",
        {"w": (-math.sqrt(0.09 + 14.7 * math.sin(math.radians(40))), 0, 0)},
    ),
    "one that comes to two angles, one after the other, and turns back between": (
        HINGE
        + "states: {now: {plate.angular_velocity: v}, up: {plate.angle: 1 deg}, low: {plate.angle: -10 deg}, end: {plate.angle: -60 deg}}\n"
        "find: {w_1: plate.angular_velocity at up, w_2: plate.angular_velocity at low, w_3: plate.angular_velocity at end}\n",
        {
            "w_1": (math.sqrt(1 - 14.7 * math.sin(math.radians(1))), 0, 0),
            "w_2": (-math.sqrt(1 + 14.7 * math.sin(math.radians(10))), 0, 0),
            "w_3": (-math.sqrt(1 + 14.7 * math.sin(math.radians(60))), 0, 0),
        },
    ),
    "a top that sinks through a tilt": (TOP.format(rate="0 rad/s", tilt="24 deg"), {}),
    "a top that rises through one": (TOP.format(rate="16 rad/s", tilt="19.8 deg"), {}),
    "letters": (
        "given: {m: kg, b: m, h: m, th: rad}\n" + PLATE + "connections: {one: {hinge: plate.A, along: x}}\n"
        "states: {now: {at rest: all}, low: {plate.angle: -th}}\nfind: {w: plate.angular_velocity at low}\n",
        {},
    ),
}
ASKED = """given: {m: 2 kg, q: LENGTH, v: RATE, g: 9.8 m/s^2}
bodies: {b: {shape: rod, mass: m, length: q}}
connections: {h: {hinge: b.start, along: -y}}
states: {now: {b.angular_velocity: START}, low: {b.angle: -90 deg, b.angular_velocity: -9 rad/s}}
find: {found: LETTER}
"""
RATE_ASKED = ASKED.replace("LENGTH", "1 m").replace("RATE", "unknown").replace("LETTER", "v")
CASES |= {
    "a rate that is asked for, downwards at once": (
        RATE_ASKED.replace("START", "-v"),
        {"found": (math.sqrt(81 - 29.4),)},
    ),
    "a length that is asked for": (
        ASKED.replace("LENGTH", "unknown").replace("RATE", "0 rad/s").replace("LETTER", "q").replace("START", "v"),
        {"found": (3 * 9.8 / 81,)},
    ),
}
REFUSED = {  # a scene, and what is said of it
    "the force along the line": (
        SCENE + "states: {now: {at rest: all}}\nfind: {F: one.force.x}\n",
        "is statically indeterminate: along the line through `one` and `two` only the sum of their forces is told",
    ),
    "a hinge and a ball": (
        GIVEN
        + PLATE
        + "connections: {one: {hinge: plate.A, along: x}, two: {ball: plate.B}}\nstates: {now: {at rest: all}}\n"
        "find: {al: plate.angular_acceleration}\n",
        "`plate` is held by several joints",
    ),
    "three balls": (
        SCENE.replace("two:", "tre: {ball: plate.C}, two:")
        + "states: {now: {at rest: all}}\nfind: {al: plate.angular_acceleration}\n",
        "`plate` is held by several joints",
    ),
    "two balls at one point": (
        SCENE.replace("plate.B", "plate.A") + "states: {now: {at rest: all}}\nfind: {al: plate.angular_acceleration}\n",
        "hold the same point",
    ),
    "an angle behind a barrier": (
        HINGE + BACK.replace("ANGLE", "200 deg"),
        "would have to pass its highest place on the way, and turns back before",
    ),
    "a rate that is asked for, with which it goes over the top": (
        RATE_ASKED.replace("START", "v"),
        "in which sense `b` turns at `now` nothing tells",
    ),
    "the angle from which it comes": (HINGE + BACK.replace("ANGLE", "0 deg"), "nothing tells"),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", CASES)
def test_what_swings_comes_to_its_angle(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(f"title: T\nup: z\n{scene}").complete().derivation
    assert derivation.confirmed
    for item in derivation.confirmed:
        assert item.holds is True, (item.name, item.why)
    for answer in derivation.answers:
        if answer.name in known:
            parts = answer.components or (answer,)
            found = [part.value.float for part in parts if part.value is not None]
            assert found == pytest.approx(known[answer.name], rel=1e-9, abs=1e-9), answer.name


@pytest.mark.parametrize("name", REFUSED)
def test_what_laws_or_lines_leave_open_is_refused_by_name(name: str) -> None:
    scene, said = REFUSED[name]
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{scene}")
    assert said in str(caught.value)
