"""Places and directions in bodies that are turned, spin, or ride on wheels, and inertia told about a point beside the axis.

Values by hand, and every answer by the assembly of all bodies' equations, which takes none of them from the laws.
"""

from __future__ import annotations

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

BOX = "bodies: {b: {shape: cuboid, mass: 6 kg, sides: [1 m, 2 m, 3 m], turned: {about: x, by: 90 deg}}}\n"
ON_WHEEL = """gravity: none
bodies:
  a: {shape: disc, radius: 0.5 m, mass: 1 kg, points: {q: [0.3 m, 0, 0.1 m]}}
  b: {shape: cuboid, sides: [0.6 m, 0.3 m, 0.2 m], mass: 1 kg}
connections:
  h: {axle: a, along: y, angular_velocity: 2 rad/s}
  k: {axle: [a.q, b], along: z, angular_velocity: 3 rad/s}
find: {w: b.angular_velocity, K: b.kinetic_energy, L: b.angular_momentum, T: k.torque}
"""
SPUN = """gravity: none
bodies: {b: {shape: disc, mass: 2 kg, radius: 1 m, points: {p: [1 m, 0, 0]}}}
states: {now: {b.tilt: 0 deg, b.precession: 1 rad/s, b.nutation: 0 rad/s, b.spin: 3 rad/s, b.spin_angle: 90 deg, b.velocity: [0, 0, 0]}}
find: {v: b.p.velocity}
"""
BESIDE = """bodies: {b: {shape: cone, radius: 0.1 m, length: 0.2 m, mass: 1 kg, points: {p: [0.2 m, 0.3 m, 0.4 m]}}}
connections: {h: {ball: b.p}}
states: {now: {b.tilt: 90 deg, b.precession: 0.6 rad/s, b.nutation: 0.4 rad/s, b.spin: 6 rad/s, b.spin_angle: 25 deg}}
find: {p: b.momentum, L: b.angular_momentum, F: h.force}
"""
OFF_AXIS = "bodies: {b: {mass: 2 kg, inertia: {value: 5 kg m^2, about: p}, axis: z, points: {p: [0.5 m, 0, 0]}}}\n"
CASES = {  # a scene, and what is known of it by hand
    "an axle across a turned box: 2 rad/s along its own −z, where I = M (1² + 2²)/12": (
        "gravity: none\n" + BOX + "connections: {h: {axle: b, along: y, angular_velocity: 2 rad/s}}\n"
        "find: {w: b.angular_velocity in body axes, L: b.angular_momentum, K: b.kinetic_energy}\n",
        {"w": (0, 0, -2), "L": (0, 5, 0), "K": (5,)},
    ),
    "an axle on a wheel, told in the wheel's own axes: its axis is y of space, so that 2 and 3 rad/s add up": (
        ON_WHEEL,
        {"w": (0, 5, 0)},
    ),
    "a rim point a quarter turn on: at y = 1 m, and 4 rad/s": (SPUN, {"v": (-4, 0, 0)}),
    "a ball joint beside the axis of what spins": (BESIDE, {}),
    "inertia about a point 0.5 m beside the axis: 5 − 2 · 0.25": (
        "gravity: none\n" + OFF_AXIS + "connections: {h: {hinge: b.center, along: z, angular_velocity: 3 rad/s}}\n"
        "find: {I: b.inertia, K: b.kinetic_energy}\n",
        {"I": (4.5,), "K": (20.25,)},
    ),
    "a hinge driven through an angle that grows with the time, which carries the end along": (
        "bodies: {b: {shape: rod, mass: 2 kg, length: 1 m}}\n"
        "connections: {h: {hinge: b.start, along: [0, 0, 1], angle: (3 rad/s)*time}}\nfind: {v: b.end.velocity, F: h.force}\n",
        {},
    ),
    "all heights are those in space, of what hangs on a hinge at a told place as of what is clamped to it": (
        "bodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}, lump: {mass: 3 kg}}\n"
        "connections: {h: {hinge: [[0, 0, 4 m], rod.start], along: y}, c: {clamp: [rod.end, lump]}}\n"
        "states: {now: {rod.angle: 90 deg, rod.angular_velocity: 2 rad/s}}\n"
        "find: {U: rod.potential_energy, V: lump.potential_energy, W: potential_energy, E: energy}\n",
        {"U": (2 * 9.8 * 3.5,), "V": (3 * 9.8 * 3,), "W": (9.8 * 16,), "E": (9.8 * 16 + 4 / 3 + 6,)},
    ),
    "the impulse of a hinge during a blow at the end of a rod: ω = 2 rad/s, M ω l/2 = 3 N s": (
        "gravity: none\nbodies: {b: {shape: rod, mass: 3 kg, length: 1 m}}\n"
        "connections: {h: {hinge: b.start, along: z}}\nstates: {before: {b.angular_velocity: 0 rad/s}, after: {}}\n"
        "events: {hit: {impulse: 2 N s, on: b.end, direction: [0, 1, 0], from: before, to: after}}\n"
        "find: {J: h.impulse during hit}\n",
        {"J": (0, 1, 0)},
    ),
    "a place in a frame held off its centre counts from there: a = −x ω², 3 N outward": (
        "gravity: none\nbodies: {arm: {shape: rod, mass: 3 kg, length: 1 m}, bead: {mass: 2 kg}}\n"
        "connections: {h: {hinge: arm.start, along: z, angular_velocity: 2 rad/s}}\nactions: {hold: {force: any, on: bead}}\n"
        "states: {now: {bead.position relative to arm: [0.375 m, 0, 0], bead.velocity relative to arm: [0, 0, 0], "
        "bead.acceleration relative to arm: [0, 0, 0]}}\n"
        "find: {a: bead.acceleration, F: bead.force.centrifugal relative to arm, r: bead.position, v: bead.velocity}\n",
        {"a": (-1.5, 0, 0), "F": (3, 0, 0), "r": (0.375, 0, 0), "v": (0, 0.75, 0)},
    ),
    "of a body on a fixed axis all kinetic energy is rotation: M b² ω²/6": (
        "gravity: none\nbodies: {rod: {shape: rod, mass: 3 kg, length: 1 m}}\n"
        "connections: {axis: {hinge: rod.start, along: z, angular_velocity: 2 rad/s}}\n"
        "find: {K: rod.kinetic_energy, R: rod.kinetic_energy.rotational, T: rod.kinetic_energy.translational}\n",
        {"K": (2,), "R": (2,), "T": (0,)},
    ),
    "all bodies together": (
        "bodies: {one: {shape: sphere, mass: 2 kg, radius: 1 m}, two: {shape: disc, mass: 3 kg, radius: 1 m}}\n"
        "states: {start: {one.velocity: [2 m/s, 0, 4 m/s], one.angular_velocity: [5 rad/s, 0, 1 rad/s], "
        "two.velocity: [0, -2 m/s, 2 m/s], two.angular_velocity: [0, 5 rad/s, 4 rad/s]}}\n"
        "find: {M: mass at start, p: momentum at start, K: kinetic_energy at start}\n",
        {"M": (5,), "p": (4, -6, 14), "K": (20 + 0.4 * 26 + 12 + 0.375 * 25 + 0.75 * 16,)},
    ),
}
REFUSED = {  # a scene, and what is said of it
    "a place by the page": (
        "bodies: {c: {shape: disc, mass: 2 kg, radius: 30 cm}}\nsurfaces: {floor: level}\nconnections: {r: {rolls: [c, floor]}}\n"
        "states: {now: {c.tilt: 90 deg, c.spin: 5 rad/s, c.precession: 0 rad/s, steady: true}}\nfind: {v: c.top.velocity at now}\n",
        "`top` of `c` is no place on it in space",
    ),
    "one component of three": (
        "bodies: {b: {shape: sphere, mass: 1 kg, radius: 0.1 m}}\nconnections: {r: {ball: b.center}}\n"
        "states: {now: {b.angular_velocity.z: 4 rad/s}}\nfind: {w: b.angular_velocity at now}\n",
        "of `b.angular_velocity` nothing tells x, y",
    ),
    "motion in a frame in which nothing tells it": (
        "gravity: none\nbodies: {t: {shape: disc, mass: 1 kg, radius: 1 m}, b: {shape: particle, mass: 2 kg}}\n"
        "connections: {h: {hinge: t.center, along: z, angular_velocity: 3 rad/s}}\nactions: {push: {force: any, on: b}}\n"
        "states: {now: {b.velocity: [1 m/s, 0, 0]}}\nfind: {v: b.velocity relative to t at now}\n",
        "how `b` moves in `t` nothing tells",
    ),
    "the share of a part": (
        "gravity: none\nbodies: {b: {points: {O: [0, 0, 0]}, parts: {p: {shape: particle, mass: 1 kg, at: [1 m, 0, 0]}, "
        "q: {shape: particle, mass: 2 kg, at: [0, 1 m, 0]}}}}\n"
        "connections: {h: {hinge: b.O, along: z, angular_velocity: 1 rad/s}}\nfind: {L: b.p.angular_momentum}\n",
        "the share of a part in the angular momentum of `b` is not solved in space",
    ),
    **{
        f"{word} of all bodies together": (
            "bodies: {one: {shape: sphere, mass: 2 kg, radius: 1 m}, two: {shape: disc, mass: 3 kg, radius: 1 m}}\n"
            "states: {now: {at rest: all}}\n"
            f"find: {{x: {word} at now}}\n",
            "nothing tells about which point"
            if word == "angular_momentum"
            else "of all bodies together is not solved in space",
        )
        for word in ("cm", "inertia", "angular_momentum")
    },
}


@pytest.mark.parametrize("name", CASES)
def test_places_and_directions_are_those_of_the_body(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(f"title: T\nup: z\n{scene}").derivation
    for item in derivation.confirmed:
        assert item.holds is True, (item.name, item.why)
    for answer in derivation.answers:
        parts = answer.components or (answer,)
        if answer.name in known:
            found = [part.value.float for part in parts if part.value is not None]
            assert found == pytest.approx(known[answer.name], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_told_or_not_solved_is_refused_by_name(name: str) -> None:
    scene, said = REFUSED[name]
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{scene}")
    assert said in str(caught.value)
