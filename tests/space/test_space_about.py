"""Momenta and torques about places in space and points of other bodies, centres of mass, wheels turned by an angle, what has no least spin.

Values by hand, and every answer by the assembly of all bodies' equations.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import SceneError, Unsolvable, solve

BALL = """given: {m: 2 kg, v: 3 m/s, a: 0.4 m, b: 0.5 m, w: 2 rad/s, g: 10 m/s^2}
bodies:
  ball: {shape: particle, mass: m}
  arm: {shape: rod, mass: m, length: b}
connections: {axis: {hinge: arm.start, along: z, angular_velocity: w}}
states: {now: {ball.position: [a, 0, b], ball.velocity: [v, 0, 0]}}
"""
TABLE = """gravity: none
given: {m: 0.5 kg, r: 1.2 m, u: 0.8 m/s, w: 2 rad/s, b: 0.5 m}
bodies: {table: {shape: disc, mass: 0, radius: r, points: {P: [0, b, 0]}}, bead: {shape: particle, mass: m}}
connections: {axis: {hinge: table.center, along: z, angular_velocity: w}}
states: {now: {bead.position relative to table: [r, 0, b], bead.velocity relative to table: [u, 0, 0]}}
"""
SLIDES = """gravity: none
given: {m: 0.5 kg, r: 1.2 m, u: 0.8 m/s, w: 2 rad/s}
bodies:
  arm: {shape: rod, mass: 0, length: 2*r, points: {P: [r/2, 0, 0]}}
  bead: {shape: particle, mass: m}
connections:
  hub: {hinge: arm.start, along: z, angular_velocity: w}
  guide: {slide: [arm.P, bead], along: x}
states: {now: {bead.velocity relative to arm: [u, 0, 0]}}
"""
WHEEL = """gravity: none
given: {m: 2 kg, R: 0.5 m, W: 2 rad/s, s: 10 rad/s, psi: 90 deg}
bodies:
  frame: {mass: 0, angular_velocity: [0, 0, W]}
  blades: {shape: disc, mass: m, radius: R, points: {P: [R, 0, 0]}}
connections: {shaft: {axle: [frame, blades], along: x, angular_velocity: s}}
states: {now: {blades.angle: psi}}
"""
TOP = """given: {M: 0.2 kg, l: 0.05 m, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2, w: unknown}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, PLACE]}}}
connections: {pivot: {ball: top.tip}}
states: {now: {top.tilt: TILT, top.axial_rate: w, steady: true}}
"""
CASES = {
    "about a place in space": (
        BALL + 'find: {L: "ball.angular_momentum about [0, 0, 0]", T: "ball.torque.net about [0, 0, 0]"}\n',
        {"L": (0, 0.5 * 6, 0), "T": (0, 0.4 * 20, 0)},
    ),
    "about a point of another body": (
        BALL + "find: {L: ball.angular_momentum about arm.end, K: arm.angular_momentum about ball.cm}\n",
        {"L": (0, 0.5 * 6, 0), "K": (0.5 * 2 * 0.5, 0, 2 * 0.25 * 2 / 12 + (0.25 - 0.4) * 2 * 0.5)},
    ),
    "of what is told by a frame that turns": (
        TABLE + "find: {L: bead.angular_momentum about table.center, K: bead.angular_momentum about table.P, "
        "S: bead.angular_momentum}\n",
        {"L": (-0.5 * 1.2, 0.5 * 0.4, 1.2 * 1.2), "K": (-0.6, 0.2, 1.2 * 1.2 + 0.5 * 0.4), "S": (0, 0, 0)},
    ),
    "of what slides on an arm that turns": (
        SLIDES + 'find: {L: "bead.angular_momentum about [0, 0, 0]", K: bead.angular_momentum about arm.end, '
        "T: bead.torque.net about arm.start}\n",
        {"L": (0, 0, 1.8 * 1.8), "K": (0, 0, -0.6 * 1.8), "T": (0, 0, 1.8 * 2 * 0.8)},
    ),
    "where the centre of mass is": (
        "given: {m: 2 kg, a: 0.4 m}\n"
        "bodies: {b: {points: {P: [0, 0, a]}, parts: {p: {mass: m, at: [a, 0, 2*a]}, q: {mass: 3*m, at: [0, a, -a]}}}}\n"
        "find: {c: b.cm, z: b.cm.z about b.P}\n",
        {"c": (0.1, 0.3, -0.1), "z": (-0.5,)},
    ),
    "a blade of a wheel that is turned by an angle": (
        WHEEL + "find: {v: blades.P.velocity, a: blades.P.acceleration, L: blades.angular_momentum}\n",
        {"v": (-1, 0, 5), "a": (0, -52, 0), "L": (2.5, 0, 0.25)},
    ),
    "that is driven through an angle": (
        "gravity: none\ngiven: {m: 2 kg, R: 0.5 m, c: 2 rad/s^2, T: 1 s}\n"
        "bodies: {blades: {shape: disc, mass: m, radius: R, points: {P: [R, 0, 0]}}}\n"
        "connections: {shaft: {axle: blades, along: x, angle: c*time^2/2}}\nstates: {now: {time: T}}\n"
        "find: {v: blades.P.velocity, a: blades.P.acceleration}\n",
        {
            "v": (0, math.cos(1), math.sin(1)),
            "a": (0, math.cos(1) - 2 * math.sin(1), math.sin(1) + 2 * math.cos(1)),
        },
    ),
}
REFUSED = {
    "about a point of a body of which nothing tells where it is": (
        BALL.replace("ball.position: [a, 0, b], ", "") + "find: {L: ball.angular_momentum about arm.end}\n",
        "where `ball` is at `now` nothing tells",
    ),
    "about a place where it has slid by a later state": (
        SLIDES.replace("[u, 0, 0]}}", "[u, 0, 0]}, then: {}}")
        + 'find: {K: bead.kinetic_energy at now, L: "bead.angular_momentum at then about [0, 0, 0]"}\n',
        "where `bead` is",
    ),
    "inertia about another's point": (
        BALL + "find: {I: arm.inertia along z about ball.cm}\n",
        "is told about its own points",
    ),
    "a blade after some time": (
        WHEEL.replace("now: {blades.angle: psi}", "now: {blades.angle: psi}, then: {}")
        + "find: {v: blades.P.velocity at then, u: blades.P.velocity at now}\n",
        "how `frame`, which is led, stands at `then` is not solved",
    ),
    "a rotor that would carry what is led": (
        WHEEL.replace("[frame, blades]", "[blades, frame]").replace("blades.angle: psi", "blades.velocity: [0, 0, 0]")
        + "find: {T: shaft.torque}\n",
        "`frame` is led along, so that `blades` can't carry it",
    ),
    "the least spin of a top that hangs upright": (
        TOP.replace("PLACE", "l").replace("TILT", "0 deg") + "find: {w_0: smallest w where now is stable}\n",
        "is stable at `now` however it spins",
    ),
    "of one that hangs askew": (
        TOP.replace("PLACE", "-l").replace("TILT", "130 deg") + "find: {w_0: smallest w where now is steady}\n",
        "has a steady precession at `now` however it spins",
    ),
    "a top on what is pushed sideways": (
        TOP.replace("PLACE", "-l")
        .replace("TILT", "30 deg")
        .replace("w: unknown", "w: 300 rad/s")
        .replace("bodies: {", "bodies: {block: {mass: 0, acceleration: [1 m/s^2, 0, 0]}, ")
        .replace("ball: top.tip", "ball: [block, top.tip]")
        + "find: {W: smallest top.precession}\n",
        "`block` accelerates its point sideways",
    ),
    "a weld": (
        BALL.replace("axis: {", "glue: {weld: [arm.end, ball]}, axis: {") + "find: {K: kinetic_energy}\n",
        "write `clamp`: it says the same in space",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_asked_about_places(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(f"title: T\nup: z\n{scene}").complete().derivation
    assert derivation.confirmed
    assert all(item.holds for item in derivation.confirmed), derivation.confirmed
    for answer in derivation.answers:
        found = [part.value.float for part in answer.components or (answer,) if part.value is not None]
        assert found == pytest.approx(list(known[answer.name]), rel=1e-9, abs=1e-9), answer.name


@pytest.mark.parametrize("name", REFUSED)
def test_what_can_not_be_told_is_refused(name: str) -> None:
    scene, words = REFUSED[name]
    with pytest.raises((SceneError, Unsolvable)) as refusal:
        solution = solve(f"title: T\nup: z\n{scene}").complete()
        raise Unsolvable("; ".join(item.fault.message for item in solution.derivation.refused) or "answered")
    assert words in str(refusal.value)


CARRIED = """
title: What a joint on a carrier gives at the point that it holds
up: z
given: {M: 2 kg, L: 0.8 m, W: 6 rad/s, d: 0.5 m}
bodies:
  table: {shape: disc, mass: 0, radius: 1 m, points: {E: [d, 0, 0]}}
  beam: {shape: rod, mass: M, length: L}
connections:
  post: {hinge: table.center, along: z, angular_velocity: W}
  joint: {KIND: [table.E, beam.start]MORE}
states: {now: {STATE}}
find: {t: joint.torque in table axes, c: joint.torque about beam.cm in table axes}
"""


def carried(kind: str, more: str = "", state: str = "") -> dict[str, tuple[float, float, float]]:
    text = CARRIED.replace("KIND", kind).replace("MORE", more).replace("STATE", state)
    answers = solve(text).answers
    return {name: tuple(answers[name].components[axis].float or 0.0 for axis in "xyz") for name in ("t", "c")}


def test_a_clamp_on_a_carrier_gives_its_couple_where_it_holds() -> None:
    """The weight M g at L/2 and nothing of M W² r, whose force passes through the point held; about the centre of mass nothing is left."""
    found = carried("clamp")
    assert found["t"] == pytest.approx((0, -2 * 9.8 * 0.4, 0))
    assert found["c"] == pytest.approx((0, 0, 0), abs=1e-9)


def test_a_hinge_on_a_carrier_gives_no_couple_about_its_own_axis() -> None:
    found = carried("hinge", ", along: y", "beam.angle: 90 deg, beam.angular_velocity: 0")
    assert found["t"][1] == pytest.approx(0, abs=1e-9)
