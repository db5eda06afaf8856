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
