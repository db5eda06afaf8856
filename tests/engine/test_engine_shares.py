"""What one body has among others that are joined to it, names of rims and parts as places, torques about points: by formulas of paper."""

from __future__ import annotations

import math
from collections.abc import Mapping

import pytest

from rotsolve import Unsolvable, solve

G = 9.8


def holds(scene: str, true: Mapping[str, float]) -> None:
    answers = solve(f"title: shares\n{scene}").answers
    assert {name: answers[name].float for name in true} == pytest.approx(true, rel=1e-6, abs=1e-9)


ROD, BAR, BOB = (2.0, 0.8), (1.0, 0.6), 0.5  # masses and lengths in a row: rod, bar, bob at the end


@pytest.mark.parametrize("reach", ["[rod.end, bar.start]", "[bar.start, rod.end]"])
@pytest.mark.parametrize("knot", ["[bar.end, bob]", "[bob, bar.end]"])
@pytest.mark.parametrize("swapped", [False, True])
def test_the_order_of_welds_decides_nothing(reach: str, knot: str, *, swapped: bool) -> None:
    welds = [f"  reach: {{weld: {reach}}}\n", f"  knot: {{weld: {knot}}}\n"]
    (m, length), (n, short), whole = ROD, BAR, ROD[1] + BAR[1]
    parts = m * length**2 / 3, n * (short**2 / 12 + (length + short / 2) ** 2), BOB * whole**2
    inertia = sum(parts)
    alpha = -(m * length / 2 + n * (length + short / 2) + BOB * whole) * G / inertia
    holds(
        "bodies:\n  bob: {mass: 0.5 kg}\n  bar: {shape: rod, mass: 1 kg, length: 0.6 m}\n  rod: {shape: rod, mass: 2 kg, length: 0.8 m}\n"
        f"connections:\n{''.join(reversed(welds) if swapped else welds)}  pin: {{hinge: rod.start}}\n"
        "states: {now: {bar.angle: 0, at rest: all}}\n"
        "find: {al: rod.angular_acceleration at now, be: bar.angular_acceleration at now, a: bob.acceleration.y at now,\n"
        "  I: inertia about pin at now, I1: rod.inertia about pin at now, I2: bar.inertia about pin at now,\n"
        "  I3: bob.inertia about pin at now}\n",
        {"al": alpha, "be": alpha, "a": alpha * whole, "I": inertia, "I1": parts[0], "I2": parts[1], "I3": parts[2]},
    )


def test_two_rods_are_welded_at_the_angle_that_a_state_tells() -> None:
    inertia, torque = 2 / 3 + 1 * (0.36 / 12 + 1 + 0.09), -(2 * 0.5 + 1 * 1) * G
    holds(
        "bodies: {a: {shape: rod, mass: 2 kg, length: 1 m}, b: {shape: rod, mass: 1 kg, length: 0.6 m}}\n"
        "connections: {corner: {weld: [a.end, b.start]}, pin: {hinge: a.start}}\n"
        "states: {now: {a.angle: 0, b.angle: 90 deg, at rest: all}}\n"
        "find: {al: a.angular_acceleration at now, tip: b.end.acceleration.x at now}\n",
        {"al": torque / inertia, "tip": -0.6 * torque / inertia},
    )


def test_what_is_joined_travels_along_the_way_that_it_names_itself() -> None:
    a = G * (math.sin(0.4) - 0.1 * math.cos(0.4))
    later = 4 + 2 * a
    holds(
        "surfaces: {ramp: {slope: 0.4 rad, down: right}}\nbodies: {crate: {mass: 3 kg, moves: down}, load: {mass: 1 kg, moves: up}}\n"
        "connections: {below: {contact: [crate, ramp], friction: 0.1}, tie: {weld: [crate, load]}}\n"
        "states: {now: {load.velocity: -2 m/s}, then: {crate.displacement: 1 m}}\n"
        "find: {v: crate.velocity at now, a: load.acceleration at now, p: load.momentum at now, u: load.velocity at then,\n"
        "  K: load.kinetic_energy at then, U: change of load.potential_energy from now to then}\n",
        {"v": 2, "a": -a, "p": -2, "u": -math.sqrt(later), "K": later / 2, "U": -G * math.sin(0.4)},
    )


def test_of_a_blow_on_joined_bodies_each_has_its_share() -> None:
    centre = (2 * 0.5 + 0.5) / 2.5
    inertia = 2 / 12 + 2 * (centre - 0.5) ** 2 + 0.5 * (1 - centre) ** 2
    w, v = -3 * centre / inertia, 3 / 2.5
    lump, rod = v + w * (1 - centre), v + w * (0.5 - centre)
    holds(
        "gravity: none\nbodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}, lump: {mass: 0.5 kg}}\n"
        "connections: {tie: {weld: [rod.end, lump]}}\nstates: {a: {rod.angle: 0, at rest: all}, b: {}}\n"
        "events: {hit: {impulse: 3 N s, on: rod.start, direction: up, from: a, to: b}}\n"
        "find: {w: rod.angular_velocity at b, v: lump.velocity.y at b, p: lump.momentum.y at b, q: rod.momentum.y at b,\n"
        "  L: rod.angular_momentum at b, K: kinetic_energy at b, J: rod.kinetic_energy at b}\n",
        {
            "w": w,
            "v": lump,
            "p": lump / 2,
            "q": 2 * rod,
            "L": w / 6,
            "K": 1.25 * v**2 + inertia * w**2 / 2,
            "J": rod**2 + w**2 / 12,
        },
    )


def test_of_a_hit_the_parts_add_up_to_the_whole() -> None:
    bar, clay = 1.6 * 0.75**2 / 3, 0.3 * 0.25
    w = 0.3 * 9 * 0.5 / (bar + clay)
    holds(
        "bodies: {bar: {shape: rod, mass: 1.6 kg, length: 0.75 m}, clay: {mass: 0.3 kg, moves: right}}\n"
        "connections: {pin: {hinge: bar.start}}\n"
        "states: {before: {bar.angle: -90 deg, at rest: bar, clay.velocity: 9 m/s}, after: {}}\n"
        "events: {hit: {joins: [clay, bar.at(0.5 m)], from: before, to: after}}\n"
        "find: {L1: clay.angular_momentum about pin at before, L2: clay.angular_momentum about pin at after,\n"
        "  L3: bar.angular_momentum at after, L: angular_momentum about pin at after, K: clay.kinetic_energy at after,\n"
        "  v: clay.velocity.x at after, I: inertia about pin at after, I1: bar.inertia about pin at after, m: clay.mass at after,\n"
        "  M: mass at after, Le: clay.angular_momentum about bar.end at before}\n",
        {
            "L1": 1.35, "L2": clay * w, "L3": bar * w, "L": 1.35, "K": clay * w**2 / 2, "v": w / 2,
            "I": bar + clay, "I1": bar, "m": 0.3, "M": 1.9, "Le": -0.3 * 9 * 0.25,
        },
    )  # fmt: skip


PULLEYS = {  # a string on the hub of a pulley: made of parts, or welded
    "parts": (
        "w: {turns: clockwise, parts: {big: {shape: disc, mass: 2 kg, radius: 0.3 m}, hub: {shape: disc, mass: 1 kg, radius: 0.1 m}}}",
        "w.hub",
        "",
    ),
    "weld": (
        "w: {shape: disc, mass: 2 kg, radius: 0.3 m, turns: clockwise}, hub: {shape: disc, mass: 1 kg, radius: 0.1 m}",
        "hub",
        "tie: {weld: [w, hub]}, ",
    ),
}


@pytest.mark.parametrize("form", PULLEYS)
def test_a_string_runs_on_the_rim_of_the_part_that_it_names(form: str) -> None:
    bodies, rim, weld = PULLEYS[form]
    a = 4 * G / (4 + (0.09 + 0.005) / 0.01)
    holds(
        f"bodies: {{{bodies}, load: {{mass: 4 kg, moves: down}}}}\n"
        f"connections: {{hold: {{axle: w}}, {weld}rope: {{string: [{rim}, load]}}}}\n"
        "find: {a: load.acceleration, T: rope.tension, al: w.angular_acceleration}\n",
        {"a": a, "T": 4 * (G - a), "al": a / 0.1},
    )


def test_a_named_rim_is_a_place_where_something_can_hang() -> None:
    holds(
        "bodies: {d: {inertia: 0.2 kg m^2, mass: 5 kg, radii: {big: 0.3 m, small: 0.1 m}}}\nconnections: {nail: {hinge: d.small}}\n"
        "find: {T: period of small swings, I: d.inertia about nail, J: d.inertia about d.big}\n",
        {"T": 2 * math.pi * math.sqrt(0.25 / (5 * G * 0.1)), "I": 0.25, "J": 0.2 + 5 * 0.09},
    )


def test_torques_and_angular_momenta_are_about_the_point_that_is_named() -> None:
    holds(
        "bodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}}\nconnections: {pin: {hinge: rod.start}}\n"
        "actions: {pull: {force: 7 N, on: rod.end, direction: up}}\nstates: {now: {rod.angle: 0, rod.angular_velocity: 3 rad/s}}\n"
        "find: {a: pull.torque about rod.center at now, b: pull.torque at now, c: pull.torque about pin at now,\n"
        "  d: rod.torque.gravity about rod.end at now, e: rod.torque.pull at now, f: rod.torque at now,\n"
        "  L: rod.angular_momentum about pin at now, Lc: rod.angular_momentum about rod.cm at now,\n"
        "  Le: rod.angular_momentum about rod.end at now}\n",
        {"a": 3.5, "b": 7, "c": 7, "d": G, "e": 7, "f": 7 - G, "L": 2, "Lc": 0.5, "Le": -1},
    )


def test_the_side_of_the_centre_of_mass_is_told_by_numbers_not_by_how_it_is_written() -> None:
    """From the ball at the right end the centre of mass lies to the left, though (x_rod − 2 x_ball)/… is written without a minus."""
    inertia = 1 / 3 + 0.4 * 2 * 0.01
    holds(
        "bodies: {p: {parts: {rod: {shape: rod, mass: 1 kg, length: 1 m, start: [0, 0], end: [1 m, 0]},\n"
        "  ball: {shape: sphere, mass: 2 kg, radius: 0.1 m, at: [1 m, 0]}}}}\nconnections: {pin: {hinge: p.ball}}\n"
        "states: {now: {p.angle: 180 deg, at rest: all}}\nfind: {al: p.angular_acceleration at now, I: p.inertia about pin at now}\n",
        {"al": G / 2 / inertia, "I": inertia},
    )


def test_a_spring_at_a_joined_body_stores_the_energy_of_all() -> None:
    holds(
        "surfaces: {floor: level}\nbodies: {x: {mass: 3 kg, moves: right}, y: {mass: 1 kg}}\n"
        "connections: {below: {contact: [x, floor]}, tie: {weld: [x, y]}, coil: {spring: [ground, y], stiffness: 100 N/m}}\n"
        "states: {s: {coil.elongation: 0.2 m, at rest: all}, m: {coil.elongation: 0}}\n"
        "find: {v: x.velocity at m, u: y.velocity at m, K: y.kinetic_energy at m}\n",
        {"v": -1, "u": -1, "K": 0.5},
    )


def test_what_is_welded_to_a_rolling_wheel_goes_its_own_way() -> None:
    """A lump from the top of a wheel to its front: R/2 (π + 2) forward, R down; (½ M R² + M R² + 2 n R²) ω² at the front."""
    start, end = (0.5 + 1) * 3 * 0.16 + 0.16 * 4, (0.5 + 1) * 3 * 0.16 + 0.16 * 2
    w = math.sqrt((start + 2 * 0.4 * G) / end)
    holds(
        "surfaces: {road: level}\n"
        "bodies: {wheel: {shape: disc, mass: 3 kg, radius: 0.4 m, moves: right, turns: clockwise,\n"
        "  points: {P: [0, 0.4 m]}}, lump: {mass: 1 kg}}\n"
        "connections: {touch: {rolls: [wheel, road]}, tie: {weld: [wheel.P, lump]}}\n"
        "states: {now: {wheel.angular_velocity: 1 rad/s}, then: {wheel.rotation: 90 deg}}\n"
        "find: {w: wheel.angular_velocity at then, v: lump.velocity.x at then, x: lump.displacement.x from now to then,\n"
        "  y: lump.displacement.y from now to then, U: change of lump.potential_energy from now to then,\n"
        "  E: change of kinetic_energy from now to then}\n",
        {"w": w, "v": 0.4 * w, "x": 0.4 * (math.pi / 2 + 1), "y": -0.4, "U": -0.4 * G, "E": 0.4 * G},
    )


@pytest.mark.parametrize("on", ["rod.start", "one"])
def test_a_light_rod_holds_two_masses_apart(on: str) -> None:
    """A blow on the one leaves the other at rest."""
    holds(
        "gravity: none\nbodies: {rod: {shape: rod, mass: 0, length: 1 m}, one: {mass: 1 kg}, other: {mass: 2 kg}}\n"
        "connections: {u: {weld: [rod.start, one]}, v: {weld: [rod.end, other]}}\nstates: {b: {rod.angle: 0, at rest: all}, c: {}}\n"
        f"events: {{hit: {{impulse: 3 N s, on: {on}, direction: up, from: b, to: c}}}}\n"
        "find: {w: rod.angular_velocity at c, p: one.velocity.y at c, q: other.velocity.y at c}\n",
        {"w": -3, "p": 3, "q": 0},
    )


def test_rods_that_an_event_joins_stay_at_their_angle() -> None:
    inertia = 2 / 3 + 0.03 + 1 + 0.09
    holds(
        "gravity: none\nbodies: {a: {shape: rod, mass: 2 kg, length: 1 m}, b: {shape: rod, mass: 1 kg, length: 0.6 m}}\n"
        "connections: {pin: {hinge: a.start}}\n"
        "states: {before: {a.angle: 0, b.angle: 90 deg, at rest: a, b.velocity.x: 0 m/s, b.velocity.y: 4 m/s,\n"
        "  b.angular_velocity: 0}, after: {}}\n"
        "events: {hit: {joins: [b.start, a.end], from: before, to: after}}\n"
        "find: {w: a.angular_velocity at after, v: b.end.velocity.x at after}\n",
        {"w": 4 / inertia, "v": -0.6 * 4 / inertia},
    )


def test_bodies_of_opposite_senses_are_joined() -> None:
    holds(
        "bodies: {p: {inertia: 2 kg m^2}, q: {inertia: 3 kg m^2, turns: clockwise}}\nconnections: {x: {axle: [p, q]}}\n"
        "states: {b: {p.angular_velocity: 5 rad/s, q.angular_velocity: 5 rad/s}, c: {}}\nevents: {j: {joins: [p, q], from: b, to: c}}\n"
        "find: {w: p.angular_velocity at c, u: q.angular_velocity at c, L: q.angular_momentum at c, K: q.kinetic_energy at c}\n",
        {"w": -1, "u": 1, "L": 3, "K": 1.5},
    )


ROLLERS = {
    "parts": (
        "{wheel: {moves: right, radius: 0.5 m,\n"
        "  parts: {rim: {shape: ring, mass: 2 kg, radius: 0.5 m}, lump: {mass: 1 kg, at: [0, -0.5 m]}}}}",
        "",
    ),
    "weld": (
        "{wheel: {shape: ring, mass: 2 kg, radius: 0.5 m, moves: right}, lump: {mass: 1 kg}}",
        ", tie: {weld: [wheel.bottom, lump]}",
    ),
}


@pytest.mark.parametrize("form", ROLLERS)
def test_a_wheel_with_a_lump_rocks_on_the_floor(form: str) -> None:
    """T = 2π √(2 M R²/(n g R)): the lump, lowest, is at rest for a moment."""
    bodies, weld = ROLLERS[form]
    holds(
        f"surfaces: {{floor: level}}\nbodies: {bodies}\nconnections: {{touch: {{rolls: [wheel, floor]}}{weld}}}\n"
        "find: {T: period of small swings}\n",
        {"T": 2 * math.pi * math.sqrt(2 * 2 * 0.25 / (G * 0.5))},
    )


@pytest.mark.parametrize("at", ["", ", direction: up"])
def test_a_blow_on_the_rim_of_a_wheel_at_the_end_of_a_rod(at: str) -> None:
    inertia = 1 / 3 + 2 * (0.02 + 1)
    holds(
        "gravity: none\nbodies: {rod: {shape: rod, mass: 1 kg, length: 1 m}, disc: {shape: disc, mass: 2 kg, radius: 0.2 m}}\n"
        "connections: {pin: {hinge: rod.start}, tie: {weld: [rod.end, disc]}}\nstates: {b: {rod.angle: 0, at rest: all}, c: {}}\n"
        f"events: {{hit: {{impulse: 3 N s, on: disc.rim{at}, from: b, to: c}}}}\n"
        "find: {w: rod.angular_velocity at c, v: disc.velocity.y at c}\n",
        {"w": 3.6 / inertia, "v": 3.6 / inertia},
    )


REFUSED = {
    "nothing tells what keeps": "bodies: {y: {shape: disc, mass: 2 kg, radius: 0.1 m, moves: down}, l: {mass: 0.5 kg}}\n"
    "connections: {s: {string: [ceiling, y]}, tie: {weld: [y.rim, l]}}\nfind: {a: y.acceleration}\n",
    "hold at two points": "bodies: {a: {shape: rod, mass: 2 kg, length: 1 m}, b: {shape: rod, mass: 1 kg, length: 0.6 m}}\n"
    "connections: {tie: {weld: [a.end, b.start]}, h: {hinge: a.start}, k: {hinge: b.end}}\n"
    "states: {now: {a.angle: 0, at rest: all}}\nfind: {al: a.angular_acceleration at now}\n",
    "not round its axis": "bodies: {a: {mass: 1 kg, radius: 0.3 m, parts: {d: {shape: disc, mass: 1 kg, radius: 0.1 m, at: [0.1 m, 0]}}},\n"
    "  b: {shape: disc, mass: 1 kg, radius: 0.2 m}}\nconnections: {x: {axle: a}, y: {axle: b}, teeth: {gear: [a.d, b]}}\n"
    "actions: {m: {couple: 1 N m, on: b}}\nfind: {al: a.angular_acceleration}\n",
    "through the centre of a wheel": "bodies: {d: {shape: annulus, mass: 1 kg, radii: {inner: 0.1 m, outer: 0.2 m}}}\n"
    "connections: {x: {axle: d.inner}}\nactions: {m: {couple: 1 N m, on: d}}\nfind: {al: d.angular_acceleration}\n",
}


@pytest.mark.parametrize("words", REFUSED)
def test_what_is_not_solved_is_refused_by_name(words: str) -> None:
    with pytest.raises(Unsolvable, match=words):
        solve(f"title: refused\n{REFUSED[words]}")
