"""Bodies in space that something carries, holds or leads: how they stand and turn there, and their angular momentum about any point.

Values by hand, and every answer by the assembly of all bodies' equations.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve

LIFT = """given: {M: 150 g, l: 4 cm, I1: 5e-4 kg m^2, I3: 6e-5 kg m^2, w3: 300 rad/s, theta: 25 deg, g: 9.8 m/s^2, a: 2 m/s^2}
bodies:
  lift: {mass: 0, acceleration: [0, 0, a]}
  top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}
connections: {floor: {ball: [lift, top.tip]}}
states: {now: {top.tilt: theta, top.axial_rate: w3, steady: true}}
"""
PARTS = """given: {m: 2 kg, a: 0.5 m, w: 3 rad/s}
bodies:
  b: {parts: {one: {shape: rod, mass: m, length: a, start: [0, 0, 0], end: [a, 0, 0]}, two: {shape: particle, mass: m, at: [a, a, 0]}},
      points: {P: [0, 0, a], Q: [a, 0, a]}}
"""
SLANTED = """gravity: none
given: {m: 2 kg, a: 0.5 m, w: 3 rad/s}
bodies: {b: {parts: {one: {shape: rod, mass: m, length: L, start: [0, 0, 0], end: END}}, points: {P: [0, 0, a]}}}
connections: {h: {hinge: b.P, along: x, angular_velocity: w}}
find: {H: b.angular_momentum, v: b.one.velocity}
"""
AXLED = """gravity: none
given: {M: 2 kg, R: 0.3 m, mu: 1 kg, s: 20 rad/s, W: 1 rad/s}
bodies: {frame: {shape: cuboid, mass: M, sides: [1 m, 1 m, 1 m]}, rotor: ROTOR}
connections: {shaft: {axle: [frame, rotor], along: x}}
states: {now: {frame.angular_velocity: [0, 0, W], frame.velocity: [0, 0, 0], rotor.WORD: s}}
find: {w_r: rotor.angular_velocity, H: rotor.angular_momentum, al: frame.angular_acceleration, s_r: rotor.spin}
"""
BOX = "{shape: cuboid, mass: M, sides: [a, 2*a, 3*a], turned: {about: x, by: 30 deg}, points: {P: [a/2, a, 0]}}"
WAY = math.sqrt(3) / 2
I1, I3, W3, MGL, TILT = 5e-4, 6e-5, 300.0, 0.15 * 11.8 * 0.04, math.cos(math.radians(25))
SLOW = (I3 * W3 - math.sqrt((I3 * W3) ** 2 - 4 * I1 * MGL * TILT)) / (2 * I1 * TILT)
SPUN = """given: {M: 0.5 kg, l: 12 cm, s: 20 rad/s, mu: 50 g}
bodies:
  top: {mass: M, inertia: {principal: MOMENTS}, axis: WAY, points: {tip: TIP, A: PLACE}}
  st: {shape: rod, mass: mu, length: l}
connections: {floor: {ball: top.tip}, gb: JOINT}
states: {now: {STANDS top.tilt: 110 deg, top.precession_angle: 200 deg, top.spin_angle: 35 deg,
               top.spin: -s, top.precession: 3 rad/s, top.nutation: -2 rad/s}}
find: {w: st.angular_velocity, K: st.kinetic_energy, L: st.angular_momentum, v: st.end.velocity, e: st.x_axis, F: gb.force}
"""
UPRIGHT = {"MOMENTS": "[2 g m^2, 2 g m^2, 4 g m^2]", "WAY": "z", "TIP": "[0, 0, -l]", "PLACE": "[8 cm, 0, l/4]"}
LEVEL = {"MOMENTS": "[4 g m^2, 2 g m^2, 2 g m^2]", "WAY": "x", "TIP": "[-l, 0, 0]", "PLACE": "[l/4, 8 cm, 0]"}
CLAMPED = {"JOINT": "{clamp: [top.A, st.start]}", "STANDS": ""}
SWUNG = {"JOINT": "{hinge: [top.A, st.start], along: z, angular_velocity: 4 rad/s}", "STANDS": "st.angle: 20 deg,"}


def spun(*words: dict[str, str]) -> str:
    scene = SPUN
    for key, value in (item for own in words for item in own.items()):
        scene = scene.replace(key, value)
    return scene


def along_spun(vector: tuple[float, float, float]) -> tuple[float, float, float]:
    """R_z(200°) R_x(110°) R_z(35°) of a vector that a top has along its own axes, its own one being z."""
    x, y, z = vector
    for about, degrees in (("z", 35), ("x", 110), ("z", 200)):
        cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        x, y, z = (
            (x * cos - y * sin, x * sin + y * cos, z) if about == "z" else (x, y * cos - z * sin, y * sin + z * cos)
        )
    return x, y, z


CASES = {  # a scene, and what is known of it by hand
    "clamped to a top that has spun on": (spun(UPRIGHT, CLAMPED), {"e": along_spun((1, 0, 0))}),
    "clamped to a top whose axis is its x": (spun(LEVEL, CLAMPED), {"e": along_spun((0, 0, 1))}),
    "hinged on a top that has spun on": (spun(UPRIGHT, SWUNG), {}),
    "hinged on a top whose axis is its x": (spun(LEVEL, SWUNG), {}),
    "a steady top in a lift: g + a in place of g": (
        LIFT + "find: {W: smallest top.precession, N: floor.force.z}\n",
        {"W": (SLOW,), "N": (0.15 * 11.8,)},
    ),
    "the same, its moments told about the centre of mass": (
        LIFT.replace("about: tip, ", "") + "find: {W: largest top.precession, N: floor.force.z}\n",
        {"N": (0.15 * 11.8,)},
    ),
    "parts on a hinge, L about four points": (
        "gravity: none\n" + PARTS + "connections: {h: {hinge: b.P, along: z, angular_velocity: w}}\n"
        "find: {H: b.angular_momentum, H_c: b.angular_momentum about b.cm, H_Q: b.angular_momentum about b.Q, "
        "H_1: b.angular_momentum about b.one}\n",
        {"H": (2.25, 1.5, 3.5), "H_c": (0, 0, 17 / 24 * 1.5), "H_Q": (2.25, 1.5, 1.25)},
    ),
    "parts on a hinge that swing": (
        PARTS + "connections: {h: {hinge: b.P, along: x}}\nstates: {now: {b.angular_velocity: w}}\n"
        "find: {H: b.angular_momentum about b.Q, al: b.angular_acceleration}\n",
        {},
    ),
    "a part that stands upright": (SLANTED.replace("L,", "a,").replace("END", "[0, 0, a]"), {"v": (0, 0.75, 0)}),
    "a part that its `turned` makes stand upright: m a²/12 across, none about it": (
        "given: {m: 2 kg, a: 0.5 m}\n"
        "bodies: {b: {parts: {one: {shape: rod, mass: m, length: a, at: [0, 0, 0], turned: {about: y, by: 90 deg}}}}}\n"
        "find: {I_b: b.inertia_tensor}\n",
        {"I_b": (1 / 24, 1 / 24, 0, 0, 0, 0)},
    ),
    "a part that is slanted": (SLANTED.replace("L,", "3*a,").replace("END", "[a, 2*a, 2*a]"), {"v": (0, 0, 1.5)}),
    "a ball on an axle, its rate told by either word": (
        AXLED.replace("ROTOR", "{shape: sphere, mass: mu, radius: R}").replace("WORD", "angular_velocity"),
        {"w_r": (20, 0, 1), "s_r": (20,)},
    ),
    "a box on an axle": (
        AXLED.replace("ROTOR", "{shape: cuboid, mass: mu, sides: [R, 2*R, 3*R]}").replace("WORD", "spin"),
        {"w_r": (20, 0, 1), "s_r": (20,)},
    ),
    "a turned box in a clamp": (
        f"given: {{M: 2 kg, a: 1 m, g: 9.8 m/s^2}}\nbodies: {{b: {BOX}}}\nconnections: {{c: {{clamp: b.P}}}}\n"
        "find: {F: c.force, T: c.torque, y_b: b.y_axis}\n",
        {"F": (0, 0, 19.6), "T": (-19.6 * WAY, 9.8, 0), "y_b": (0, WAY, 0.5)},
    ),
    "a turned box clamped to a disc that turns": (
        f"given: {{M: 2 kg, a: 1 m, w: 2 rad/s, g: 9.8 m/s^2}}\nbodies: {{t: {{shape: disc, mass: M, radius: a}}, b: {BOX}}}\n"
        "connections: {h: {hinge: t.center, along: z, angular_velocity: w}, c: {clamp: [t, b.P]}}\n"
        "find: {F: c.force, T: c.torque, y_b: b.y_axis, H: b.angular_momentum}\n",
        {"F": (4, 8 * WAY, 19.6), "y_b": (0, WAY, 0.5)},
    ),
    "a turned box on a hinge of a disc that turns": (
        f"gravity: none\ngiven: {{M: 2 kg, a: 1 m, w: 2 rad/s, v: 3 rad/s}}\nbodies: {{t: {{shape: disc, mass: M, radius: a}}, b: {BOX}}}\n"
        "connections: {h: {hinge: t.center, along: z, angular_velocity: w}, c: {hinge: [t, b.P], along: y, angular_velocity: v}}\n"
        "find: {T: c.torque, w_b: b.angular_velocity, H: b.angular_momentum}\n",
        {"w_b": (0, 3 * WAY, 3.5)},
    ),
    "a shaft driven through an angle that grows with the time, at a time that is told": (
        "given: {M: 2 kg, a: 1 m, w: 2 rad/s^2}\nbodies: {b: {shape: cuboid, mass: M, sides: [a, 2*a, 3*a]}}\n"
        "connections: {h: {hinge: b.center, along: z, angle: w*time^2/2}}\nstates: {now: {time: 3 s}}\n"
        "find: {T: h.torque, K: b.kinetic_energy, x_b: b.x_axis}\n",
        {"K": (0.5 * 10 / 12 * 36,), "x_b": (math.cos(9), math.sin(9), 0)},
    ),
    "a free body with its tilt from its own angular momentum": (
        "gravity: none\ngiven: {A: 6e-4 kg m^2, C: 8e-5 kg m^2, w3: 40 rad/s, w1: 3 rad/s}\n"
        "bodies: {b: {mass: 1 kg, inertia: {principal: [A, A, C]}}}\nstates: {now: {b.angular_velocity: [w1, 0, w3]}}\n"
        "find: {W: b.precession, s: b.spin, t: b.tilt}\n",
        {"t": (math.atan2(6e-4 * 3, 8e-5 * 40),)},
    ),
    "a thrown top that turns steadily while it falls: I₃ ω₃/(I₁ cos θ)": (
        "given: {A: 0.02 kg m^2, C: 0.03 kg m^2, w3: 10 rad/s, th: 60 deg, g: 9.8 m/s^2}\n"
        "bodies: {b: {mass: 1 kg, inertia: {principal: [A, A, C]}, axis: z}}\n"
        "states: {now: {b.tilt: th, b.axial_rate: w3, b.precession: largest, steady: true}}\n"
        "find: {W: b.precession, s: b.spin, H: size of b.angular_momentum, a: b.acceleration}\n",
        {"W": (30,), "s": (-5,), "H": (0.6,), "a": (0, 0, -9.8)},
    ),
    "what is led round faster and faster, at a time that is told": (
        "gravity: none\ngiven: {M: 2 kg, a: 1 m, w: 2 rad/s^2}\n"
        "bodies: {b: {shape: cuboid, mass: M, sides: [a, 2*a, 3*a], angular_velocity: [0, 0, w*time]}}\nstates: {now: {time: 3 s}}\n"
        "find: {H: b.angular_momentum, al: b.angular_acceleration}\n",
        {"H": (0, 0, 5), "al": (0, 0, 2)},
    ),
}
ON_TABLE = """gravity: none
given: {m: 0.5 kg, u: 0.8 m/s, w: 2 rad/s}
bodies: {table: {shape: disc, mass: 0}, bead: {shape: particle, mass: m}}
connections: {axis: {hinge: table.center, along: z, angular_velocity: w}}
actions: {hold: {force: any, on: bead}}
states: {now: {bead.velocity relative to table: [u, 0, 0], bead.acceleration relative to table: [0, 0, 0]}}
find: {F: FORCE}
"""
LATER = """gravity: none
given: {M: 2 kg, a: 1 m, w: 2 rad/s, v: 3 rad/s}
bodies:
  t: {shape: disc, mass: M, radius: a, points: {q: [a, 0, 0]}}
  b: {shape: cuboid, mass: M, sides: [a, 2*a, 3*a]}
connections: {h: {hinge: t.center, along: z, angular_velocity: w}, c: {hinge: [t.q, b.center], along: x, angular_velocity: v}}
states: {now: {}, later: {t.angle: 30 deg}}
find: {H: b.angular_momentum at later}
"""


@pytest.mark.parametrize("name", CASES)
def test_what_is_carried_goes_along(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(f"title: T\nup: z\n{scene}").complete().derivation
    assert derivation.confirmed
    for item in derivation.confirmed:
        assert item.holds is True, (item.name, item.why)
    for answer in derivation.answers:
        if answer.name in known:
            parts = answer.components or (answer,)
            found = [part.value.float for part in parts if part.value is not None]
            assert found == pytest.approx(known[answer.name], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("force", ["hold.force", "bead.force.centrifugal relative to table"])
def test_where_a_body_is_in_a_frame_is_not_guessed(force: str) -> None:
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{ON_TABLE.replace('FORCE', force)}")
    assert "where `bead` is in `table` nothing tells" in str(caught.value)


def test_how_a_carried_body_stands_later_is_not_guessed() -> None:
    """It turned on its hinge since: by how much nothing tells."""
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{LATER}")
    assert "`b.angular_momentum.x` hangs on how `b` stands at `later`, which nothing tells" in str(caught.value)
    told = solve(f"title: T\nup: z\n{LATER.replace('30 deg}', '30 deg, b.angle: 20 deg}')}")
    assert [item.holds for item in told.derivation.confirmed] == [True]
