"""Slides, sleeves and screws in space: what slides along something that turns, falls along a guide, or winds down a thread.

Values by hand, and every answer by the assembly of all bodies' equations.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve

GIVEN = "given: {m: 2 kg, M: 3 kg, r: 0.5 m, w: 3 rad/s, u: 1.5 m/s, b: 2 rad/s^2, J: 5 N s, s: 8 rad/s, p: 5 mm, R: 0.1 m, g: 9.8 m/s^2}\n"
ARM = "arm: {shape: rod, mass: MASS, length: 2*r, points: {P: [r, 0, 0]}}"
BEAD = "bead: {shape: particle, mass: m}"
BOX = "bead: {shape: cuboid, mass: m, sides: [r/5, r/10, r/10]}"
RING = "bead: {shape: cylinder, mass: m, radius: R, length: 2*R, turned: {about: y, by: 90 deg}}"
SLIDE = "guide: {slide: [arm.P, bead], along: x}"
SLANTED = (
    "bodies:\n  " + ARM.replace("MASS", "0").replace("}}", "}, turned: {about: y, by: -30 deg}}") + "\n  " + BEAD + "\n"
    "connections: {hub: {hinge: arm.start, along: [1/2, 0, sqrt(3)/2], angular_velocity: OMEGA}, " + SLIDE + "}\n"
)


def on_arm(bead: str, pair: str, mass: str = "M", drive: str = "") -> str:
    arm = ARM.replace("MASS", mass)
    return f"{GIVEN}bodies:\n  {arm}\n  {bead}\nconnections: {{hub: {{hinge: arm.start, along: z{drive}}}, {pair}}}\n"


DRIVEN = ", angular_velocity: w, angular_acceleration: b"
STRUCK = (
    "states: {before: at rest, after: {}}\n"
    "events: {hit: {impulse: J, on: POINT, direction: [WAY], from: before, to: after}}\n"
)
NUT = "bodies: {nut: {shape: cylinder, mass: m, radius: R, length: 2*R, points: {e: [R, 0, 0]}}}\n"
THREAD = "connections: {thread: {screw: nut, along: z, pitch: p}}\n"
LEAD = 0.005 / (2 * math.pi)
PULL = 2 * 9.8 * LEAD / (0.01 + 2 * LEAD**2)  # m g k/(I + m k²) with I = m R²/2 and k = p/2π
CASES = {  # a scene, and what is known of it by hand
    "a bead on an arm that is driven: m (2 u w + 2 r b) across it, 2 r w² along it": (
        on_arm(BEAD, SLIDE, "0", DRIVEN) + "gravity: none\nstates: {now: {bead.velocity relative to arm: [u, 0, 0]}}\n"
        "find: {F: guide.force, v: bead.velocity, a: bead.acceleration, a_r: bead.acceleration relative to arm,\n"
        "  F_c: bead.force.coriolis relative to arm, F_z: bead.force.centrifugal relative to arm, T: hub.torque}\n",
        {
            "F": (0, 2 * 11, 0),
            "v": (1.5, 3, 0),
            "a": (0, 11, 0),
            "a_r": (9, 0, 0),
            "F_c": (0, -18, 0),
            "F_z": (18, 0, 0),
            "T": (0, 0, 22),
        },
    ),
    "a box on an arm that turns freely": (
        on_arm(BOX, SLIDE) + "states: {now: {arm.angular_velocity: w, bead.velocity relative to arm: [u, 0, 0]}}\n"
        "find: {al: arm.angular_acceleration, F: guide.force, T: guide.torque, H: bead.angular_momentum, K: bead.kinetic_energy}\n",
        {},
    ),
    "a bead on a slanted arm, held by nothing": (
        GIVEN + SLANTED.replace("OMEGA", "w") + "states: {now: {bead.velocity relative to arm: [0, 0, 0]}}\n"
        "find: {F: guide.force in arm axes, a_r: bead.acceleration relative to arm in arm axes}\n",
        {"F": (0, 0, 2 * (9.8 + 4.5) * math.sqrt(0.75)), "a_r": (0.75 * 9 - 4.9, 0, 0)},
    ),
    "the rate at which it stays there": (
        GIVEN.replace("w: 3 rad/s", "w: unknown")
        + SLANTED.replace("OMEGA", "w")
        + "states: {now: {bead.velocity relative to arm: [0, 0, 0], steady: true}}\nfind: {w_0: w}\n",
        {},
    ),
    "a box that falls along a slope, from rest": (
        GIVEN
        + "bodies: {"
        + BOX
        + "}\nconnections: {guide: {slide: bead, along: [3/5, 0, -4/5]}}\nstates: {now: {at rest: all}}\n"
        "find: {F: guide.force, a: bead.acceleration, T: guide.torque}\n",
        {"F": (9.408, 0, 7.056), "a": (4.704, 0, -6.272), "T": (0, 0, 0)},
    ),
    "a ring on an arm that turns, spinning about it": (
        on_arm(RING, "guide: {sleeve: [arm.P, bead], along: x}")
        + "states: {now: {arm.angular_velocity: w, bead.velocity relative to arm: [u, 0, 0], bead.angular_velocity: s}}\n"
        "find: {F: guide.force, T: guide.torque, v: bead.velocity, al: arm.angular_acceleration, w_b: bead.angular_velocity}\n",
        {"v": (1.5, 3, 0), "w_b": (8, 0, 3)},
    ),
    "a nut that winds down: g k²/(R²/2 + k²)": (
        GIVEN + NUT + THREAD + "states: {now: {nut.angular_velocity: s}}\n"
        "find: {v: nut.velocity, a: nut.acceleration, al: nut.angular_acceleration, F: thread.force, T: thread.torque}\n",
        {"v": (0, 0, 8 * LEAD), "a": (0, 0, -PULL * LEAD), "al": (0, 0, -PULL)},
    ),
    "a nut on an arm that is driven, told by how the point held at its rim goes: s = 2π u/R": (
        on_arm(
            "bead: {shape: cylinder, mass: m, radius: R, length: 2*R, points: {e: [0, R, 0]}}",
            "guide: {screw: [arm.P, bead.e], along: x, pitch: R}",
            "0",
            DRIVEN,
        )
        + "states: {now: {bead.e.velocity relative to arm: [u, 0, 0]}}\n"
        "find: {w_b: bead.angular_velocity, v: bead.velocity, a: bead.acceleration, F: guide.force, T: guide.torque}\n",
        {"w_b": (30 * math.pi, 0, 3), "v": (1.5 + 0.3, 3, -3 * math.pi)},
    ),
    "a nut pressed on an arm at rest, told by how the point held goes faster: 2π (u̇)/R": (
        on_arm(
            "bead: {shape: cylinder, mass: m, radius: R, length: 2*R, points: {e: [0, R, 0]}}",
            "guide: {screw: [arm.P, bead.e], along: x, pitch: R}",
            "0",
            ", angular_velocity: 0 rad/s",
        )
        + "actions: {push: {couple: any, on: bead}}\n"
        "states: {now: {bead.e.velocity relative to arm: [u, 0, 0], bead.e.acceleration relative to arm: [b*R, 0, 0]}}\n"
        "find: {al: bead.angular_acceleration, v: bead.velocity}\n",
        {"al": (4 * math.pi, 0, 0), "v": (1.5, 0, -3 * math.pi)},
    ),
    "a nut struck at its rim": (
        GIVEN
        + NUT
        + THREAD
        + STRUCK.replace("POINT", "nut.e").replace("WAY", "0, 1, 0")
        + "find: {w_1: nut.angular_velocity at after, v: nut.velocity at after, P: thread.impulse during hit}\n",
        {"w_1": (0, 0, 0.5 / (0.01 + 2 * LEAD**2))},
    ),
    "a box struck on an arm: along the slide it goes alone": (
        on_arm(BOX, SLIDE)
        + STRUCK.replace("POINT", "bead").replace("WAY", "3, 4, 0")
        + "find: {v_r: bead.velocity relative to arm at after, w_1: arm.angular_velocity at after, P: guide.impulse during hit,\n"
        "  Q: hub.impulse during hit}\n",
        {"v_r": (1.5, 0, 0)},
    ),
    "two rods on hinges, the second struck at its end": (
        GIVEN + "bodies: {arm: {shape: rod, mass: M, length: 2*r}, bob: {shape: rod, mass: m, length: r}}\n"
        "connections: {hub: {hinge: arm.start, along: z}, elbow: {hinge: [arm.end, bob.start], along: z}}\n"
        + STRUCK.replace("POINT", "bob.end").replace("WAY", "0, 1, 0")
        + "find: {w_b: bob.angular_velocity at after, w_a: arm.angular_velocity at after, P: elbow.impulse during hit}\n",
        {"w_b": (0, 0, 20), "w_a": (0, 0, -5 / 3), "P": (0, 5 / 3, 0)},
    ),
}
FREE = (
    "gravity: none\n" + GIVEN + "bodies:\n"
    "  one: {shape: cuboid, mass: M, sides: [r, 2*r, 3*r], points: {q: [r/2, 0, 0], e: [r/2, r, 0]}}\n  two: TWO\n"
)
FREED = "find: {w_1: one.angular_velocity at after, v: two.velocity at after, K: two.kinetic_energy at after, VECTOR}\n"
CASES |= {
    "a free body struck with a rod on it by a ball": (
        FREE.replace("TWO", "{shape: rod, mass: m, length: r}")
        + "connections: {k: {ball: [one.q, two.start]}}\n"
        + STRUCK.replace("POINT", "one.e").replace("WAY", "0, 3, 4")
        + FREED.replace("VECTOR", "P: k.impulse during hit"),
        {},
    ),
    "a free body struck with a wheel on it, which does not turn about its axle": (
        FREE.replace("TWO", "{shape: disc, mass: m, radius: R}")
        + "connections: {k: {axle: [one.q, two], along: x}}\n"
        + STRUCK.replace("POINT", "one.e").replace("WAY", "0, 0, 1")
        + FREED.replace("VECTOR", "w_2: two.angular_velocity.x at after"),
        {"w_2": (0,)},
    ),
}
REFUSED = {  # a scene, and what is said of it
    "a velocity across the slide": (
        on_arm(BEAD, SLIDE, "0", DRIVEN)
        + "states: {now: {bead.velocity relative to arm: [u, u, 0]}}\nfind: {F: guide.force}\n",
        "`bead` can only slide along `guide`",
    ),
    "a point of a screw that is told to go across it": (
        on_arm(
            "bead: {shape: sphere, mass: m, radius: R, points: {e: [0, R, 0]}}",
            "guide: {screw: [arm.P, bead.e], along: x, pitch: R}",
            "0",
            DRIVEN,
        )
        + "states: {now: {bead.e.velocity relative to arm: [u, u, 0]}}\nfind: {F: guide.force}\n",
        "`bead.e` can only slide along `guide`",
    ),
    "a velocity that is not that along the slide": (
        on_arm(BEAD, SLIDE, "0", DRIVEN) + "states: {now: {bead.velocity: [u, 0, 0]}}\nfind: {F: guide.force}\n",
        "how fast is told relative to that",
    ),
    "a place that nothing tells": (
        on_arm(BEAD, SLIDE, "0", DRIVEN)
        + "states: {now: {bead.velocity relative to arm: [u, 0, 0]}, later: {arm.angle: 30 deg}}\nfind: {F: guide.force at later}\n",
        "where `bead` is on `guide` at `later` nothing tells",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_slides_goes_along_with_what_it_slides_on(name: str) -> None:
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
def test_what_no_slide_lets_or_nothing_tells_is_refused_by_name(name: str) -> None:
    scene, said = REFUSED[name]
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{scene}")
    assert said in str(caught.value)
