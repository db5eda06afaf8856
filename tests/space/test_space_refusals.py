"""What a scene in space can't mean is refused by name, with its line and what would be right."""

from __future__ import annotations

import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve

HEAD = "title: T\nup: z\ngiven: {M: 2 kg, a: 1 m, J: 3 kg m^2, w: 5 rad/s}\n"
BOX = "bodies: {b: {shape: cuboid, mass: M, sides: [a, a, a], points: {P: [a/2, 0, 0]}}}\n"
TOP = "bodies: {b: {mass: M, inertia: {principal: [J, J, J/2], about: O}, axis: z, points: {O: [0, 0, -a]}}}\n"
HELD = "connections: {p: {ball: b.O}}\n"
ROD = "bodies: {b: {shape: rod, mass: M, length: a}}\nconnections: {p: {ball: b.start}}\n"
STEADILY = "states: {s: {%s, steady: true}}\nfind: {O: smallest b.precession}\n"
CASES = {  # a scene, what is said of it, and what would be right
    "moments that no body has": (
        HEAD + "bodies: {b: {inertia: {principal: [J, J, 3*J]}}}\nfind: {I: b.inertia along x}\n",
        "no body has these moments of inertia: I_z is larger than the other two together",
        "can't be negative",
    ),
    "a steady state that does not exist, beside a turning point": (
        HEAD
        + "bodies: {b: {shape: cuboid, mass: M, sides: [a, a/2, a], axis: z, points: {O: [0, 0, -a]}}}\n"
        + HELD
        + "actions: {hands: {couple: any, on: b}}\n"
        + "states: {s: {b.tilt: 1 rad, b.spin: w, steady: true, b.precession: largest}, e: {b.tilt: largest}}\n"
        + "find: {x: b.energy at s}\n",
        "it does not precess steadily",
        "leave out `steady: true`",
    ),
    "a tensor that is not symmetric": (
        HEAD + "bodies: {b: {inertia: {tensor: [[J, 0, 0], [J/9, J, 0], [0, 0, J]]}}}\nfind: {I: b.inertia along x}\n",
        "an inertia tensor is symmetric, but this has two values for I_xy",
        "",
    ),
    "a tensor that no body has": (
        HEAD
        + "bodies: {b: {inertia: {tensor: [[J, -2*J, 0], [-2*J, J, 0], [0, 0, J]]}}}\nfind: {I: b.inertia along x}\n",
        "no body has this inertia tensor",
        "can't be negative",
    ),
    "where a hinge turns back, by a word": (
        HEAD
        + ROD.replace("{ball: b.start}", "{hinge: b.start, along: -y}")
        + "states: {s: {b.angle: 1 rad, b.angular_velocity: 0 rad/s}, e: {b.angle: smallest}}\nfind: {x: b.angle at e}\n",
        "where `b.angle` is smallest is no line of a state in space",
        "has the rate 0: tell that, and as `b.angle` a letter that is `unknown`",
    ),
    "an angle where a rate alone is told": (
        HEAD
        + ROD.replace("{ball: b.start}", "{hinge: b.start, along: -y}")
        + "states: {s: {b.angle: 1 rad, b.angular_velocity: 0 rad/s}, e: {b.angular_velocity: 0 rad/s}}\n"
        + "find: {x: b.angle at e}\n",
        "`b.angle` is not told at `e`",
        "`b.angle: q` with `q: unknown`",
    ),
    "an angle of what swings, by the time alone": (
        HEAD
        + ROD.replace("{ball: b.start}", "{hinge: b.start, along: -y}")
        + "states: {s: {b.angle: 1 rad, b.angular_velocity: 0 rad/s}, e: {time: 1 s}}\nfind: {x: b.angle at e}\n",
        "`b.angle` is not told at `e`",
        "`rotsolve simulate` follows it",
    ),
    "a direction of length 0": (
        HEAD + BOX + "connections: {h: {hinge: b, along: [0, 0, 0], angular_velocity: w}}\nfind: {tau: h.torque}\n",
        "`along` is a direction of length 0",
        "it needs a component that is not 0",
    ),
    "no direction": (
        HEAD + BOX + "connections: {h: {hinge: b, along: q, angular_velocity: w}}\nfind: {tau: h.torque}\n",
        "`q` is no direction in space",
        "directions: x, y, z",
    ),
    "an axis that nothing tells": (
        HEAD + BOX + "connections: {h: {hinge: b, angular_velocity: w}}\nfind: {tau: h.torque}\n",
        "nothing tells the direction of the axis of `h`",
        "give `along: z`",
    ),
    "two components": (
        HEAD + BOX + "states: {s: {b.angular_velocity: [w, w]}}\nfind: {L: b.angular_momentum}\n",
        "`b.angular_velocity` wants `[x, y, z]` in space",
        "write its three components",
    ),
    "one component": (
        HEAD + BOX + "states: {s: {b.angular_velocity: w}}\nfind: {K: b.kinetic_energy}\n",
        "its angular velocity has three components",
        "write `b.angular_velocity: [x, y, z]`",
    ),
    "words of the plane": (
        HEAD + "bodies: {b: {mass: M, moves: up}}\nfind: {a: b.acceleration}\n",
        "`moves` is for scenes in the plane, and this one is in space",
        "leave out `up: z`",
    ),
    "words of space": (
        "title: T\ngiven: {M: 2 kg, R: 1 m}\nbodies: {d: {shape: disc, mass: M, radius: R}}\n"
        "connections: {x: {axle: d, along: z}}\nfind: {L: d.angular_momentum}\n",
        "`along` is for scenes in space, and this one is in the plane",
        "a scene in space has `up: z` at the top",
    ),
    "spin and axial rate": (
        HEAD
        + TOP
        + HELD
        + "states: {s: {b.tilt: 30 deg, b.spin: w, b.axial_rate: w, b.precession: w}}\nfind: {E: b.energy}\n",
        "`b` has both a `spin` and an `axial_rate`",
        "give one of them",
    ),
    "a vertical that is no unit vector": (
        HEAD
        + TOP
        + HELD
        + "states: {s: {b.vertical: [1, 1, 0], b.angular_velocity: [w, 0, 0]}}\nfind: {E: b.energy}\n",
        "the vertical of `b` is a direction of length 1",
        "add up to 1",
    ),
    "a steady state that does not exist": (
        HEAD
        + TOP
        + HELD
        + "states: {s: {b.tilt: 30 deg, b.axial_rate: w, steady: true}}\nfind: {O: smallest b.precession}\n",
        "`b` spins too slowly for a steady precession at `s`",
        "at least 9.515 rad/s",
    ),
    "one without any spin": (
        HEAD + TOP + HELD + STEADILY % "b.tilt: 30 deg, b.axial_rate: 0 rad/s",
        "`b` spins too slowly for a steady precession at `s`",
        "at least 9.515 rad/s",
    ),
    "one that tells the spin beside the precession": (
        HEAD + TOP + HELD + STEADILY % "b.tilt: 30 deg, b.spin: 2 rad/s",
        "`b` spins too slowly for a steady precession at `s`",
        "it needs I₃ ψ̇ ≥ 2 √((I₁ − I₃) M g l cos θ), at least 6.728 rad/s",
    ),
    "a thin rod above its pivot": (
        HEAD + ROD + STEADILY % "b.tilt: 30 deg",
        "`b` has no steady precession at `s`: its weight turns it away from the vertical, and it is thin",
        "",
    ),
    "a level top that does not spin": (
        HEAD + TOP + HELD + (STEADILY % "b.tilt: 90 deg, b.spin: 0 rad/s").replace("smallest ", ""),
        "`b` is level at `s` and does not spin: it has no steady precession there",
        "none is the least",
    ),
    "a level rod": (HEAD + ROD + STEADILY % "b.tilt: 90 deg", "`b` is level at `s` and does not spin", ""),
    "rates that hold a top at no tilt": (
        HEAD + TOP + HELD + "states: {s: {b.axial_rate: w, b.precession: w/9, steady: true}}\nfind: {t: b.tilt}\n",
        "no tilt but upright or upside down is steady with these rates",
        "|M g l − I₃ ω₃ φ̇| < I₁ φ̇²",
    ),
    "a steady state that is none": (
        HEAD
        + TOP
        + HELD
        + "states: {s: {b.tilt: 30 deg, b.axial_rate: 30 rad/s, b.precession: 1 rad/s, steady: true}}\n"
        "find: {O: b.spin}\n",
        "contradict",
        "",
    ),
    "one of two precessions": (
        HEAD
        + TOP
        + HELD
        + "states: {s: {b.tilt: 30 deg, b.axial_rate: 30 rad/s, steady: true}}\nfind: {O: b.precession}\n",
        "two steady motions are possible, and nothing tells which is meant",
        "`smallest` or `largest`",
    ),
    "several joints": (
        HEAD + BOX + "connections: {p: {ball: b}, q: {clamp: b.P}}\nfind: {K: b.kinetic_energy}\n",
        "`b` is held by several joints",
        "`bearings`",
    ),
    "a line on which nothing depends": (
        HEAD
        + BOX
        + "states: {s: {b.angular_velocity: [w, 0, 0], b.rotation: 30 deg}}\nfind: {L: b.angular_momentum}\n",
        "what the state says of `b.rotation` says nothing here",
        "leave it out",
    ),
    "how a body stands later": (
        HEAD + "gravity: none\n" + BOX + "states: {s: {b.angular_velocity: [w, 0, 0]}, t: {b.velocity: [0, 0, 0]}}\n"
        "find: {L: b.angular_momentum at t}\n",
        "how `b` stands at `t` nothing tells",
        "tell its `tilt`",
    ),
}


@pytest.mark.parametrize("case", CASES, ids=str)
def test_what_can_not_be_is_refused_by_name(case: str) -> None:
    scene, message, right = CASES[case]
    with pytest.raises((SceneError, Unsolvable)) as caught:
        solve(scene)
    assert message in str(caught.value)
    assert right in str(caught.value)
