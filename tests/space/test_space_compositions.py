"""Compositions that nobody had tried, against calculations in numbers from the definitions alone (NumPy)."""

from __future__ import annotations

import math
from typing import Any

import numpy
import pytest

import rotsolve.pipeline
from rotsolve import Unsolvable, solve

HEAD = "title: t\nup: z\n"
G = 9.8


def parts(solution: Any, name: str) -> list[float]:
    return [part.float for part in solution.answers[name].components.values()]


def all_hold(solution: Any) -> bool:
    return all(item.holds for item in solution.derivation.confirmed)


VECTORS = """gravity: none
bodies: {b: {shape: cuboid, mass: 2 kg, sides: [1 m, 1 m, 1 m], points: {P: [1 m, 0, 0], Q: [0, 1 m, 0]}}}
states: {s: {b.angular_velocity: [1 rad/s, 2 rad/s, 3 rad/s], b.velocity: [1 m/s, -2 m/s, 0]}}
find: {d: b.P.velocity - b.Q.velocity, m: (b.P.velocity + b.Q.velocity)/2}
"""


def test_sums_of_vectors_are_vectors() -> None:
    solution, omega = solve(HEAD + VECTORS), numpy.array([1.0, 2.0, 3.0])
    one, other = (numpy.array([1.0, -2, 0]) + numpy.cross(omega, place) for place in ([1, 0, 0], [0, 1, 0]))
    assert parts(solution, "d") == pytest.approx(list(one - other))
    assert parts(solution, "m") == pytest.approx(list((one + other) / 2))
    assert all_hold(solution)


FLIGHT = """given: {T: 0.7 s}
bodies: {p: {shape: particle, mass: 2 kg}, q: {shape: particle, mass: 3 kg}}
states:
  now:
    p.position: [1 m, 0, 2 m]
    p.velocity: [1 m/s, 2 m/s, 0]
    q.position: [0, 1 m, 0]
    q.velocity: [-2 m/s, 0, 1 m/s]
  later: {time: T}
find: {P: (p.momentum at later) + (q.momentum at later), L: "p.angular_momentum about [0, 0, 0] at later"}
"""


def test_the_momenta_of_two_particles_that_fly() -> None:
    """About a place in space, after a time: r and v of the flight."""
    solution, fall = solve(HEAD + FLIGHT), numpy.array([0, 0, -G * 0.7])
    v, u = numpy.array([1.0, 2, 0]) + fall, numpy.array([-2.0, 0, 1]) + fall
    r = numpy.array([1.0, 0, 2]) + 0.7 * (numpy.array([1.0, 2, 0]) + v) / 2
    assert parts(solution, "P") == pytest.approx(list(2 * v + 3 * u))
    assert parts(solution, "L") == pytest.approx(list(2 * numpy.cross(r, v)))
    assert all_hold(solution)


ROTOR = """gravity: none
given: {m: 0.4 kg, r: 6 cm, q: 5 cm, w: 30 rad/s, al: ANGLE deg, m1: unknown, f1: unknown, D: 20 cm}
bodies:
  rotor:
    parts:
      a: {shape: particle, mass: m, at: [r*cos(al), r*sin(al), 0]}
      near: {shape: particle, mass: m1, at: [q*cos(f1), q*sin(f1), 0]}
    points: {O: [0, 0, 0]}
connections: {shaft: {hinge: rotor.O, along: z, bearings: [-D, D], angular_velocity: w}}
states: {now: {rotor.angle: 0 deg, shaft.bearing1.force.x: 0 N, shaft.bearing1.force.y: 0 N}}
find: {m1: m1, f1: f1}
"""


@pytest.mark.parametrize("angle", [60, 150, 200])
def test_a_mass_at_any_angle_balances_a_rotor(angle: int) -> None:
    """0.4 kg at 6 cm is balanced by 0.48 kg at 5 cm opposite: a mass is positive, whichever quadrant that takes."""
    solution = solve(HEAD + ROTOR.replace("ANGLE", str(angle)))
    assert solution.answers["m1"].float == pytest.approx(0.48, rel=1e-9)
    gap = (solution.answers["f1"].float - math.radians(angle) - math.pi) / (2 * math.pi)
    assert gap == pytest.approx(round(gap), abs=1e-9)


PULLED = """given: {M: 2 kg, b: 0.6 m, F: unknown, f: unknown}
bodies: {rod: {shape: rod, mass: M, length: b}}
connections: {h: {ball: rod.start}}
actions: {pull: {force: F, on: rod.end, direction: [0, cos(f), sin(f)]}}
states: {now: {rod.angular_velocity: [0, 0, 0], rod.angular_acceleration: [0, 0, -3 rad/s^2]}}
find: {F: F, f: f}
"""


def test_a_force_of_unknown_size_and_direction_is_positive() -> None:
    """I α = r × (F + weight): F sin f = ½ M g, ⅓ M b² α_z = b F cos f."""
    answers, across, up = solve(HEAD + PULLED).answers, 2 * 0.6 * -3 / 3, 2 * G / 2
    assert answers["F"].float == pytest.approx(math.hypot(across, up), rel=1e-9)
    assert answers["f"].float == pytest.approx(math.atan2(up, across), rel=1e-9)


ARM = """gravity: none
given: {e: 0.3 m, w: 2 rad/s, phi: unknown}
bodies: {arm: {shape: rod, mass: 1 kg, length: e}}
connections: {hub: {hinge: arm.start, along: z, angular_velocity: w}}
states: {now: {arm.angle: phi}}
find: {phi: phi where arm.end.velocity.y = 0.3 m/s at now}
"""


def test_the_mirror_image_of_an_angle_is_said_and_another_angle_objects() -> None:
    """v_y = e w cos φ and v_x = −e w sin φ: two angles of one cosine are mirror images, of one sine they are not."""
    found = solve(HEAD + ARM)
    assert found.answers["phi"].float == pytest.approx(math.pi / 3)
    assert found.derivation.confirmed[0].also == " = −60° makes it so too"
    with pytest.raises(Unsolvable, match="= −150° makes it so too"):
        solve(HEAD + ARM.replace("velocity.y", "velocity.x"))


STRUCK = """gravity: none
given: {m: 2 kg, a: 0.4 m, w: 5 rad/s, J: unknown}
bodies: {plate: {shape: rectangle, mass: m, sides: [a, a], points: {A: [-a/2, a/2, 0], B: [a/2, a/2, 0]}}}
connections: {hook: {ball: plate.A}}
states: {before: {plate.angular_velocity: [0, w, 0]}, after: {plate.B.velocity.z: 0 m/s}}
events: {hit: {impulse: J, on: plate.B, direction: z, from: before, to: after}}
find: {J: J, om: plate.angular_velocity at after}
"""


def test_a_blow_that_brings_a_point_to_rest() -> None:
    """B at rest along z after it: ω′ = ω + I⁻¹ (r × J) about A; a line of a state tells the blow."""
    solution, m, a, w = solve(HEAD + STRUCK), 2.0, 0.4, 5.0
    centre = numpy.array([a / 2, -a / 2, 0])
    tensor = m * a * a / 12 * numpy.diag([1, 1, 2]) + m * (centre @ centre * numpy.eye(3) - numpy.outer(centre, centre))
    turned = numpy.linalg.solve(tensor, numpy.cross([a, 0, 0], [0, 0, 1]))
    blow = a * w / numpy.cross(turned, [a, 0, 0])[2]
    assert solution.answers["J"].float == pytest.approx(blow, rel=1e-9)
    assert parts(solution, "om") == pytest.approx(list(numpy.array([0, w, 0]) + blow * turned))
    assert all_hold(solution)


BALLS = """bodies:
  bx: {shape: cuboid, mass: 3 kg, sides: [0.6 m, 0.4 m, 0.2 m], points: {A: [-0.3 m, -0.2 m, 0.1 m], B: [0.3 m, 0.2 m, 0.1 m]}}
connections: {HELD}
states: {now: {bx.angle: 40 deg, bx.angular_velocity: 2 rad/s}}
find: {al: bx.angular_acceleration, a: bx.acceleration}
"""


def test_two_balls_on_an_oblique_line_hold_as_a_hinge_does() -> None:
    balls = solve(HEAD + BALLS.replace("HELD", "l: {ball: bx.A}, r: {ball: bx.B}"))
    hinge = solve(HEAD + BALLS.replace("HELD", "l: {hinge: bx.A, along: [0.6, 0.4, 0]}"))
    for name in ("al", "a"):
        assert parts(balls, name) == pytest.approx(parts(hinge, name), rel=1e-9)
    assert all_hold(balls) and max(map(abs, parts(balls, "al"))) > 1


AT = """bodies: {b: {shape: rod, mass: 2 kg, length: 1 m}}
connections: {h: {hinge: b.at(0.2 m), along: y}}
states: {now: {b.angle: 30 deg, b.angular_velocity: -2 rad/s}}
find: {al: b.angular_acceleration.y}
"""


def test_a_rod_is_held_at_any_place_on_it() -> None:
    """½ L − x from its middle: I α = M g (½ L − x) cos φ about the place held."""
    solution, inertia = solve(HEAD + AT), 2 / 12 + 2 * 0.3**2
    assert solution.answers["al"].float == pytest.approx(2 * G * 0.3 * math.cos(math.radians(30)) / inertia)
    assert all_hold(solution)


DRIVES = """bodies:
  fr: {mass: 0, inertia: {principal: [0, 0, 0]}, points: {P: [0.4 m, 0.1 m, 0.2 m]}}
  bx: {shape: cuboid, mass: 2 kg, sides: [0.6 m, 0.4 m, 0.2 m], points: {A: [-0.3 m, 0, 0.1 m]}}
connections: {h1: {hinge: fr, along: z, FIRST}, h2: {hinge: [fr.P, bx.A], along: y, SECOND}}
states: {s: {}, now: {time: 0.7 s}}
find: {F: h2.force at now, v: bx.velocity at now, L: bx.angular_momentum about bx.cm at now}
"""


def test_constant_drives_lead_to_later_states() -> None:
    """Told as rates, and told as angles by time: the same."""
    rates, angles = (
        solve(HEAD + DRIVES.replace("FIRST", first).replace("SECOND", second))
        for first, second in (
            ("angular_velocity: 2 rad/s", "angular_velocity: -3 rad/s"),
            ("angle: 2 rad/s*time", "angle: -3 rad/s*time"),
        )
    )
    for name in ("F", "v", "L"):
        assert parts(rates, name) == pytest.approx(parts(angles, name), rel=1e-9)


NAMED = """bodies:
  b:
    parts:
      ONE: {shape: disc, mass: 1 kg, radius: 1 m, at: [1 m, 0, 0]}
      TWO: {shape: disc, mass: 2 kg, radius: 2 m, at: [0, 0, 1 m]}
    points: {O: [0, 0, 0]}
find: {I: b.inertia_tensor about b.O}
"""


def test_parts_may_be_called_as_axes_are() -> None:
    named, plain = (solve(HEAD + NAMED.replace("ONE", a).replace("TWO", b)) for a, b in (("x", "z"), ("p", "q")))
    assert parts(named, "I") == pytest.approx(parts(plain, "I"))


HOLLOW = """bodies: {b: {shape: sphere, mass: 2 kg, radius: 0.3 m, holes: {a: {shape: sphereRADIUS}}}}
find: {I: b.inertia along z}
"""


def test_a_hole_without_a_radius_has_a_letter() -> None:
    """⅖ m (R⁵ − a⁵)/(R³ − a³) of a hollow ball, a by its letter."""
    letters = solve(HEAD + HOLLOW.replace("RADIUS", ""))
    assert letters.answers["I"].value is None and "Rₐ" in letters.to()
    told = solve(HEAD + HOLLOW.replace("RADIUS", ", radius: 0.1 m"))
    assert told.answers["I"].float == pytest.approx(0.4 * 2 * (0.3**5 - 0.1**5) / (0.3**3 - 0.1**3))


CARRIED = """bodies:
  fr:
    mass: 3 kg
    inertia: {principal: [0.3 kg m^2, 0.4 kg m^2, 0.5 kg m^2]}
    points: {A: [0.1 m, -0.2 m, 0.3 m], P: [0.5 m, 0.1 m, 0.2 m]}
  bx: {shape: cuboid, mass: 2 kg, sides: [0.6 m, 0.4 m, 0.2 m], points: {A: [-0.3 m, 0.1 m, 0.05 m]}}
connections:
  jfr: {hinge: fr.A, along: z, angular_velocity: 2 rad/s, angular_acceleration: -1.5 rad/s^2}
  jbx: {hinge: [fr.P, bx.A], along: [1, 2, 2], angular_velocity: -4 rad/s}
states: {now: {fr.angle: 30 deg, bx.angle: -70 deg}}
find: {tn: fr.torque.net about fr.cm}
"""


def test_what_is_not_told_from_nothing_is_printed() -> None:
    """Two components are nothing, perhaps by a cancelling that no algebra shows: I_zz α alone is left."""
    page = solve(HEAD + CARRIED).to(detail="brief").replace("≈ ", "")
    assert "tn = (0, 0, −0.75" in page


LONG = "{shape: cuboid, mass: N kg, sides: [1 m, 2 m, N m], at: [N m, 1 m, 0], turned: {about: [1, N, 2], by: 30 deg}}"


def test_what_takes_too_long_takes_no_other_answer_with_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """With little work allowed the mass is still told, and of the rest it is said that it is not."""
    bodies = ", ".join(f"p{n}: {LONG.replace('N', str(n))}" for n in (1, 2, 3))
    monkeypatch.setattr(rotsolve.pipeline, "STEPS", 120)
    scene = f"{HEAD}bodies: {{b: {{parts: {{{bodies}}}}}}}\nfind: {{M: b.mass, c: b.cm, I: b.inertia_tensor}}\n"
    solution = solve(scene, confirm=False)
    assert solution.answers["M"].float == pytest.approx(6)
    assert "beside the other questions" in solution.derivation.refused[0].fault.message


FAST = """assume: [fast spin]
given: {M: 0.15 kg, l: 4 cm, A: 5e-4 kg m^2, C: 6e-5 kg m^2, w: unknown, p: 3.27 rad/s, th: 25 deg}
bodies: {top: {mass: M, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states: {now: {top.tilt: th, top.axial_rate: w, top.precession: p, steady: true}}
find: {w: w}
"""


def test_a_fast_spin_leaves_the_square_out_whatever_is_sought() -> None:
    """M g l = I₃ ω₃ Ω, also for ω₃ by a precession that is told."""
    assert solve(HEAD + FAST).answers["w"].float == pytest.approx(0.15 * G * 0.04 / (6e-5 * 3.27), rel=1e-9)


def test_a_spin_is_sought_by_a_condition_on_the_precession() -> None:
    """M g l = C ω₃ Ω − A Ω² cos θ exactly."""
    scene = FAST.replace("assume: [fast spin]\n", "").replace(", p: 3.27 rad/s", "").replace("top.precession: p, ", "")
    found = solve(HEAD + scene.replace("{w: w}", "{w: w where top.precession = 3.27 rad/s at now}"))
    exact = (0.15 * G * 0.04 + 5e-4 * 3.27**2 * math.cos(math.radians(25))) / (6e-5 * 3.27)
    assert found.answers["w"].float == pytest.approx(exact, rel=1e-9)


def test_a_particle_moves_in_three_ways() -> None:
    solution = solve(HEAD + "bodies: {p: particle}\nfind: {f: p.freedoms, r: p.freedoms.rotations}\n")
    assert (solution.answers["f"].float, solution.answers["r"].float) == (3, 0) and all_hold(solution)


LET_GO = """bodies: {rod: {shape: rod, mass: 1 kg, length: 1 m}}
connections: {pin: {hinge: rod.start, along: y}}
states: {a: {rod.angle: 0 deg, at rest: rod}, e: {rod.angle: 180 deg}}
find: {w: rod.angular_velocity.y at e}
"""


def test_a_swing_that_turns_back_has_no_rate_there() -> None:
    solution = solve(HEAD + LET_GO)
    assert solution.answers["w"].float == 0 and all_hold(solution)


OPPOSITE = """bodies: {wh: {shape: disc, mass: 1 kg, radius: 0.2 m}}
connections: {ax: {axle: wh, along: -z, angular_velocity: 3 rad/s}}
states: {now: {wh.angle: 0 deg}}
find: {x: wh.x_axis, z: wh.z_axis, om: wh.angular_velocity}
"""


def test_an_axle_against_the_axis_turns_the_wheel_over() -> None:
    solution = solve(HEAD + OPPOSITE)
    assert [parts(solution, name) for name in ("x", "z", "om")] == [[-1, 0, 0], [0, 0, -1], [0, 0, -3]]
    assert all_hold(solution)
