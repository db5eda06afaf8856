"""Axles on bodies that move: trucks on rails and slopes, swinging rods, blocks on strings; also from one state to another."""

from __future__ import annotations

import math
from math import sqrt

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

G = 9.8
GIVEN = (
    "title: x\ngiven: {M: 20 kg, m: 10 kg, R: 25 cm, F: 45 N, Q: 2 N m, L: 1 m, b: 30 deg, d: 200 cm, w0: 4 rad/s}\n"
)
WHEEL = "wheel: {shape: disc, mass: m, radius: R}"
TRUCK = GIVEN + f"surfaces: {{rails: level}}\nbodies: {{truck: {{mass: M, moves: right}}, {WHEEL}}}\n"
PUSHED = "actions: {push: {force: F, on: truck, direction: right}, turn: {couple: Q, on: wheel}}\n"
ROD = (
    GIVEN
    + f"bodies: {{rod: {{shape: rod, mass: M, length: L}}, {WHEEL}}}\nconnections: {{pin: {{hinge: rod.start}}, axle: {{axle: ORDER}}}}\n"
)
FALLS = "states: {start: {rod.angle: 0, at rest: all}, end: {rod.angle: -90 deg}}\n"

I_WHEEL = 10 * 0.25**2 / 2
SPIN = 2 / I_WHEEL * sqrt(6) / 1.5  # Q t/I
HEAVY = 20 / 3 + 10  # (M/3 + m) L²
ARM = 20 / 2 + 10  # (M/2 + m) L
WOUND = 2 * 2 / (10 * 0.25) / (1 + 5 / 30 + 2 * 5 / 10)  # of a crate on a winch's rope
OVER = 5 * G / (5 + 10 / 2 + 1 / (1 / 8 + 1 / 30))  # of a load beside a truck of 30 kg with a crate of 8 kg
UNWOUND = -ARM * G * sqrt(3) / 2 / (HEAVY + 10 / 2 * 3 / 4)  # of a rod with a wheel on a thread

CASES = {
    "truck": (
        TRUCK + "connections: {under: {contact: [truck, rails]}, axle: {axle: ORDER}}\n" + PUSHED
        + "states: {start: at rest, end: {truck.displacement: d}}\n",
        "truck, wheel",
        {
            "a: truck.acceleration at start": 1.5,
            "N: under.normal_force at start": 30 * G,
            "Fx: axle.force.x at start": 15,
            "v: truck.velocity at end": sqrt(6),
            "p: momentum at end": 30 * sqrt(6),
            "w: wheel.angular_velocity at end": SPIN,
            "K: kinetic_energy at end": 90 + I_WHEEL * SPIN**2 / 2,
            "W: push.work from start to end": 90,
        },
    ),
    "truck on a slope": (
        TRUCK.replace("rails: level", "rails: {slope: b, down: right}")
        + "connections: {under: {contact: [truck, rails]}, axle: {axle: ORDER}}\nstates: {start: at rest, end: {time: 2 s}}\n",
        "truck, wheel",
        {
            "a: truck.acceleration at start": G / 2,
            "N: under.normal_force at start": 30 * G * sqrt(3) / 2,
            "alpha: wheel.angular_acceleration at start": 0,
            "v: truck.velocity at end": G,
        },
    ),
    "truck on its own wheel": (
        TRUCK + "connections: {under: {rolls: [wheel, rails]}, axle: {axle: ORDER}}\n"
        "actions: {push: {force: F, on: truck, direction: right}}\nstates: {start: at rest, end: {truck.displacement: d}}\n",
        "truck, wheel",
        {
            "a: truck.acceleration at start": 45 / 35,
            "f: under.friction_force at start": 5 * 45 / 35,
            "w: wheel.angular_velocity at end": sqrt(2 * 90 / 35) / 0.25,
        },
    ),
    "block on a string": (
        GIVEN + f"bodies: {{block: {{mass: M, moves: up}}, {WHEEL}}}\n"
        "connections: {rope: {string: [ceiling, block]}, axle: {axle: ORDER}}\nstates: {rest: {balance: true}}\n",
        "block, wheel",
        {"T: rope.tension": 30 * G, "Fy: axle.force.y": 10 * G},
    ),
    "swinging rod": (
        ROD + FALLS,
        "rod.end, wheel",
        {
            "alpha: rod.angular_acceleration at start": -ARM * G / HEAVY,
            "w: rod.angular_velocity at end": -sqrt(2 * ARM * G / HEAVY),
            "spin: wheel.angular_velocity at end": 0,
            "v: wheel.cm.speed at end": sqrt(2 * ARM * G / HEAVY),
        },
    ),
    "turning rod": (
        ROD.replace("bodies", "gravity: none\nbodies", 1)
        + "actions: {turn: {couple: Q, on: rod}}\nstates: {start: {rod.angular_velocity: w0, wheel.angular_velocity: 0}}\n",
        "rod.end, wheel",
        {
            "alpha: rod.angular_acceleration": 2 / HEAVY,
            "K: kinetic_energy": HEAVY * 16 / 2,
            "a: wheel.cm.acceleration.normal": 16,
            "Kw: wheel.kinetic_energy": 80,
            "p: wheel.momentum": 40,
        },
    ),
    "winch on a truck": (  # M + m = 30 kg to one side, 5 kg to the other, at Q/R less what turns the winch
        TRUCK.replace("moves: right", "moves: left")
        .replace("bodies: {", "bodies: {crate: {mass: 5 kg, moves: right}, ")
        .replace("radius: R", "radius: R, turns: clockwise")
        + "connections: {under: {contact: [truck, rails]}, base: {contact: [crate, rails]}, axle: {axle: ORDER},\n"
        "  rope: {string: [crate, wheel]}}\n"
        "actions: {turn: {couple: Q, on: wheel}}\nstates: {start: at rest}\n",
        "truck, wheel",
        {
            "A: truck.acceleration at start": 5 / 30 * WOUND,
            "a: crate.acceleration at start": WOUND,
            "T: rope.tension at start": 5 * WOUND,
        },
    ),
    "load that hangs from a winch on a truck": (  # nothing pulls the truck: a = m g/(m + ½ m_winch)
        TRUCK.replace("bodies: {", "bodies: {load: {mass: 5 kg, moves: down}, ").replace("radius: R", "radius: R, turns: clockwise")
        + "connections: {under: {contact: [truck, rails]}, axle: {axle: ORDER}, rope: {string: [wheel, load]}}\n"
        "states: {start: at rest}\n",
        "truck, wheel",
        {"a: truck.acceleration at start": 0.0, "l: load.acceleration at start": G / 2, "T: rope.tension at start": 5 * G / 2},
    ),
    "load beside a truck, over its pulley to a crate on it": (  # T (1/8 + 1/30) = l, 5 (g − l) = T + T_turn
        TRUCK.replace("bodies: {", "bodies: {load: {mass: 5 kg, moves: down}, crate: {mass: 8 kg, moves: right}, ").replace(
            "truck: {mass: M, moves: right}", "truck: {mass: M, moves: left}"
        )
        + "connections: {under: {contact: [truck, rails]}, base: {contact: [crate, truck]}, axle: {axle: ORDER},\n"
        "  rope: {string: [crate, wheel, load]}}\nstates: {start: at rest}\n",
        "truck, wheel",
        {
            "A: truck.acceleration at start": OVER / (1 / 8 + 1 / 30) / 30,
            "l: load.acceleration at start": OVER,
            "T: rope.crate.tension at start": OVER / (1 / 8 + 1 / 30),
        },
    ),
    "wheel on a truck, drawn over a pulley": (
        TRUCK.replace("bodies: {", "bodies: {load: {mass: 5 kg, moves: down}, drum: {mass: 0, radius: 1 cm, turns: clockwise}, ")
        + "connections: {under: {contact: [truck, rails]}, axle: {axle: ORDER}, shaft: {axle: drum},\n"
        "  rope: {string: [wheel.center, drum, load]}}\n"
        "states: {start: at rest}\n",
        "truck, wheel",
        {"a: truck.acceleration at start": 5 * G / 35, "T: rope.load.tension at start": 5 * G * 30 / 35},
    ),
    "wheel at the end of a rod, on a thread": (  # T = m R β/2, β = L α cos φ/R
        ROD.replace("axle: {axle: ORDER}", "axle: {axle: ORDER}, thread: {string: [ceiling, wheel]}")
        .replace("radius: R", "radius: R, turns: counterclockwise")
        + "states: {start: {rod.angle: b, at rest: all}}\n",
        "rod.end, wheel",
        {"alpha: rod.angular_acceleration at start": UNWOUND, "beta: wheel.angular_acceleration at start": -UNWOUND * sqrt(3) / 2 / 0.25},
    ),
}  # fmt: skip


@pytest.mark.parametrize("turned_round", [False, True], ids=["mount first", "wheel first"])
@pytest.mark.parametrize(("moved", "order", "true"), CASES.values(), ids=CASES)
def test_a_mount_moves_with_what_it_carries(moved: str, order: str, true: dict[str, float], turned_round: bool) -> None:
    first, second = order.split(", ")
    named = f"[{second}, {first}]" if turned_round else f"[{first}, {second}]"
    answers = solve(moved.replace("ORDER", named) + f"find: {{{', '.join(true)}}}\n").answers
    for question, value in true.items():
        found = answers[question.partition(":")[0]].float
        sign = -1 if turned_round and question.startswith("F") else 1  # the force is that on the last-named body
        assert found == pytest.approx(value * sign, rel=1e-6, abs=1e-9), question


def test_bodies_on_one_fixed_axle_stay_there() -> None:
    """What no other connection moves is held by the axle, also where another axle holds it at the same point."""
    scene = GIVEN + f"bodies: {{table: {{inertia: 3 kg m^2}}, {WHEEL}, other: {{inertia: 1 kg m^2}}}}\n"
    scene += "connections: {one: {axle: [table, wheel]}, two: {axle: [table, other]}}\n"
    scene += "actions: {turn: {couple: Q, on: table}}\nfind: {alpha: table.angular_acceleration, beta: other.angular_acceleration}\n"
    answers = solve(scene).answers
    assert answers["alpha"].float == pytest.approx(2 / 3)
    assert answers["beta"].float == 0


def test_a_tile_hung_from_a_truck_is_told_by_the_angle_of_its_centre() -> None:
    """`angle` is that of the direction from the hinge to the centre of mass, on a truck as on the ground."""
    for point in ("P: [R/2, 0]", "P: [-R/2, 0]", "P: [0, R/2]"):
        scene = TRUCK.replace("radius: R", f"radius: R, points: {{{point}}}")
        scene += "connections: {under: {contact: [truck, rails]}, axle: {axle: [truck, wheel.P]}}\n"
        scene += "states: {start: {at rest: all, wheel.angle: 0}}\nfind: {alpha: wheel.angular_acceleration}\n"
        assert solve(scene).answers["alpha"].float == pytest.approx(-2 * G / (3 * 0.25))


HAMMER = "{parts: {stick: {shape: rod, mass: m, start: [0, 0], end: [L, 0]}, head: {mass: 2*m, at: [L, 0]}}, points: {grip: [0, 0]}}"
PLATE = "{shape: rectangle, mass: m, sides: [L, L/2]}"


@pytest.mark.parametrize("order", ["mount, wheel", "wheel, mount"])
@pytest.mark.parametrize(
    ("body", "hinge", "named", "arm"),
    [
        (HAMMER, "grip", "mount", 2.5 / 3),
        (HAMMER, "grip", "mount.head", 1.0),
        (PLATE, "corner1", "mount", (1 / 4 + 1 / 16) ** 0.5),
        ("{shape: rod, mass: m, length: L}", "start", "mount", 0.5),
    ],
)
def test_a_mount_named_alone_carries_at_its_centre(body: str, hinge: str, named: str, arm: float, order: str) -> None:
    """The wheel goes round the hinge with the mount, as far from it as the mount's centre of mass is."""
    axle = order.replace("mount", named)
    scene = f"""
given: {{L: 1 m, m: 3 kg, R: 0.5 m, a: 2 rad/s}}
bodies: {{mount: {body}, wheel: {{shape: ring, mass: m, radius: R}}}}
connections: {{pin: {{hinge: mount.{hinge}}}, spindle: {{axle: [{axle}]}}}}
states: {{now: {{mount.angle: 0, mount.angular_velocity: a, wheel.angular_velocity: 0}}}}
find: {{K: wheel.kinetic_energy, p: wheel.momentum.y}}
"""
    answers = solve(scene, digits=9).answers
    assert answers["K"].float == pytest.approx(0.5 * 3 * (2 * arm) ** 2, rel=1e-8)
    assert answers["p"].float == pytest.approx(3 * 2 * arm, rel=1e-8)


SIZES = "given: {I: 2 kg m^2, J: 1 kg m^2, m: 3 kg, M: 5 kg, L: 1 m, d: 40 cm, R: 50 cm, F: 10 N}\n"
ROUND, SLIM = "{shape: disc, mass: m, radius: R}", "{shape: rod, mass: m, length: L}"
ARM = (
    SIZES + "bodies: {drum: {mass: M, inertia: I, radius: R, turns: clockwise}, load: {mass: m, moves: down}, "
    "arm: {mass: M, inertia: J, points: {P: [d, 0]}}, BODIES}\nstates: {start: {at rest: all, LINES}}\n"
    "connections: {x: {axle: [ORDER]}, rope: {string: [drum, load]}, MORE}\n"
    "find: {k: arm.angular_acceleration, a: load.acceleration}\n"
)
CARRIED = {  # by what the arm carries: the bodies, how they hang from it, their angles, how often m is at its point P
    "a rod": (f"rod: {SLIM}", "pin: {hinge: [arm.P, rod.start]}", "rod.angle: -90 deg", 1),
    "a rod that is named first": (f"rod: {SLIM}", "pin: {hinge: [rod.start, arm.P]}", "rod.angle: -90 deg", 1),
    "a wheel by its centre": (f"wheel: {ROUND}", "pin: {hinge: [arm.P, wheel.center]}", "", 1),
    "a wheel on an axle": (f"wheel: {ROUND}", "spindle: {axle: [arm.P, wheel]}", "", 1),
    "a wheel on an axle, named first": (f"wheel: {ROUND}", "spindle: {axle: [wheel, arm.P]}", "", 1),
    "both": (
        f"rod: {SLIM}, wheel: {ROUND}",
        "pin: {hinge: [arm.P, rod.start]}, spindle: {axle: [arm.P, wheel]}",
        "rod.angle: -90 deg",
        2,
    ),
    "a load that is welded to it": ("bob: {mass: m}", "glue: {weld: [arm.P, bob]}", "", 1),
}


@pytest.mark.parametrize("order", ["drum, arm", "arm, drum", "arm.center, drum"])
@pytest.mark.parametrize(("bodies", "more", "lines", "count"), CARRIED.values(), ids=CARRIED)
def test_an_axle_stays_fixed_whatever_its_bodies_carry(
    bodies: str, more: str, lines: str, count: int, order: str
) -> None:
    """Drum and arm turn on one axle, each by itself: what hangs from the arm does not let the axle fall."""
    text = ARM.replace("BODIES", bodies).replace("MORE", more).replace("LINES", lines)
    answers = solve(text.replace("ORDER", order)).answers
    assert answers["k"].float == pytest.approx(-count * 3 * G * 0.4 / (1 + count * 3 * 0.4**2))
    assert answers["a"].float == pytest.approx(3 * G * 0.5**2 / (2 + 3 * 0.5**2))


CART = f"{SIZES}surfaces: {{rails: level}}\nactions: {{push: {{force: F, on: cart, direction: right}}}}\n"
CART += f"bodies: {{cart: {{mass: M, moves: right}}, wheel: {ROUND}, BODIES}}\nstates: {{start: {{at rest: all}}}}\n"
CART += "connections: {under: {contact: [cart, rails], friction: none}, MORE}\nfind: {a: cart.acceleration}\n"
RODS = f"{SIZES}bodies: {{rod: {{shape: rod, mass: M, length: L}}, wheel: {ROUND}, BODIES}}\n"
RODS += (
    "connections: {MORE}\nstates: {start: {at rest: all, rod.angle: 0, LINES}}\nfind: {a: rod.angular_acceleration}\n"
)
LED = {  # what leads an axle by way of others: the scene, its bodies and connections, the angles, and what is asked
    "welded to a cart": (CART, f"post: {SLIM}", "foot: {weld: [cart, post.start]}, x: {axle: [post.end, wheel]}", "", 10 / 11),
    "on the axle of a cart": (CART, f"next: {ROUND}", "x: {axle: [wheel, cart]}, y: {axle: [next, wheel]}", "", 10 / 11),
    "on that axle, named before it": (CART, f"next: {ROUND}", "y: {axle: [wheel, next]}, x: {axle: [cart, wheel]}", "", 10 / 11),
    "at the elbow of two rods": (
        RODS,
        "next: {shape: rod, mass: M, length: L}",
        "pin: {hinge: rod.start}, elbow: {hinge: [rod.end, next.start]}, x: {axle: [next.start, wheel]}",
        "next.angle: -90 deg",
        -(5 / 2 + 5 + 3) * G / (5 / 3 + 5 + 3),
    ),
    "on a rod hinged at a quarter": (
        RODS,
        "",
        "pin: {hinge: rod.at(L/4)}, x: {axle: [rod.at(3*L/4), wheel]}",
        "",
        -(5 / 4 + 3 / 2) * G / (5 / 12 + 5 / 16 + 3 / 4),
    ),
    "on a rod on an axle of its own": (
        RODS, f"next: {ROUND}", "x: {axle: [rod.end, wheel]}, y: {axle: [next, rod]}", "", -3 / 2 * G / (5 / 12 + 3 / 4),
    ),
}  # fmt: skip


@pytest.mark.parametrize(("setting", "bodies", "more", "lines", "true"), LED.values(), ids=LED)
def test_an_axle_goes_with_what_is_led_by_way_of_others(
    setting: str, bodies: str, more: str, lines: str, true: float
) -> None:
    answers = solve(setting.replace("BODIES", bodies).replace("MORE", more).replace("LINES", lines)).answers
    assert answers["a"].float == pytest.approx(true)


@pytest.mark.parametrize(
    ("setting", "bodies", "more", "named"),
    [
        (RODS, f"next: {ROUND}", "x: {axle: [rod.start, wheel]}, y: {axle: [rod.end, next]}", "which of `x` and `y` is fixed"),
        (CART, f"rod: {SLIM}", "pin: {hinge: [rod.start, cart]}, x: {axle: [rod.end, wheel]}", "`rod` carries `cart`"),
        (RODS, f"next: {SLIM}", "pin: {hinge: next.end}, elbow: {hinge: [rod.end, next.start]}, x: {axle: [rod.start, wheel]}",
         "`rod` carries `next`"),
    ],
)  # fmt: skip
def test_an_axle_that_may_be_fixed_or_carried_is_refused(setting: str, bodies: str, more: str, named: str) -> None:
    with pytest.raises(Unsolvable, match=named):
        solve(setting.replace("BODIES", bodies).replace("MORE", more).replace("LINES", ""))


SLEDGE = """
given: {M: 20 kg, m: 10 kg, R: 25 cm, Q: 60 N m, b: 30 deg}
surfaces: {ramp: {slope: b, down: SIDE}, hill: {slope: 40 deg, down: right}}
bodies: {sledge: {mass: M, moves: up}, drum: {shape: disc, mass: m, radius: R, turns: TURNS}}
connections:
  under: {contact: [sledge, ramp]}
  axle: {axle: [sledge, drum]}
  rope: {string: ROPE, ALONG}
actions: {motor: {couple: Q, on: drum, direction: AGAINST}}
states: {start: at rest}
find: {A: sledge.acceleration at start, T: rope.tension at start}
"""


@pytest.mark.parametrize("along", ["along: ramp", ""])
@pytest.mark.parametrize("drum", ["drum", "drum.rim"])
@pytest.mark.parametrize("side", ["left", "right"])
def test_a_rope_of_what_a_sledge_carries_runs_up_its_slope(side: str, drum: str, along: str) -> None:
    """A drum hauls its sledge up: (M + m) A = T − (M + m) g sin β, Q − T R = ½ m R² A/R."""
    turns = ("clockwise", "counterclockwise") if side == "left" else ("counterclockwise", "clockwise")
    rope = f"[{drum}, ground]" if side == "left" else f"[ground, {drum}]"
    text = SLEDGE.replace("ROPE", rope).replace("SIDE", side).replace("TURNS", turns[0]).replace("AGAINST", turns[1])
    answers = solve(text.replace(", ALONG", f", {along}" if along else "")).answers
    gain = (60 / 0.25 - 30 * G / 2) / (30 + 10 / 2)
    assert answers["A"].float == pytest.approx(gain)
    assert answers["T"].float == pytest.approx(30 * (gain + G / 2))


def test_a_surface_along_which_nothing_on_a_string_travels_is_refused() -> None:
    text = SLEDGE.replace("ROPE", "[drum, ground]").replace("SIDE", "left").replace("TURNS", "clockwise")
    with pytest.raises(Unsolvable, match="nothing that `rope` touches travels along `hill`"):
        solve(text.replace("AGAINST", "counterclockwise").replace("ALONG", "along: hill"))


@pytest.mark.parametrize("end", ["truck", "drum.center", "drum"])
@pytest.mark.parametrize("floor", ["level", "{slope: b, down: left}", "{slope: b, down: right}"])
@pytest.mark.parametrize("first", [True, False], ids=["truck first", "crate first"])
def test_a_spring_or_a_string_is_drawn_to_what_a_truck_carries_as_to_the_truck(
    end: str, floor: str, first: bool
) -> None:
    """The earlier-named of two on one line stands on the left, whatever names the truck's end; a stretched spring draws both together."""
    moves = "right" if floor == "level" else "up"
    ends = f"{end}, crate" if first else f"crate, {end}"
    scene = f"""
given: {{M: 20 kg, m: 10 kg, n: 5 kg, R: 25 cm, k: 40 N/m, e: 0.5 m, b: 30 deg}}
surfaces: {{rails: {floor}}}
bodies: {{truck: {{mass: M, moves: {moves}}}, crate: {{mass: n, moves: {moves}}}, drum: {{shape: disc, mass: m, radius: R}}}}
connections:
  under: {{contact: [truck, rails]}}
  base: {{contact: [crate, rails]}}
  axle: {{axle: [truck, drum]}}
  coil: {{spring: [{ends}], stiffness: k}}
states: {{start: {{coil.elongation: e, at rest: all}}}}
find: {{A: truck.acceleration, a: crate.acceleration}}
"""
    solution = solve(scene)
    weight = 0.0 if floor == "level" else -G / 2
    right = -1 if "down: right" in floor else 1  # there `up` runs to the left
    pull = 20.0 * (right if first else -right)
    assert solution.answers["A"].float == pytest.approx(weight + pull / 30)
    assert solution.answers["a"].float == pytest.approx(weight - pull / 5)
    assert all(verdict.holds for verdict in solution.derivation.confirmed)


HUNG = """
given: {M: 20 kg, m: 10 kg, n: 5 kg, L: 1 m, k: 400 N/m, e: 0.2 m}
surfaces: {rails: level}
bodies: {truck: {mass: M, moves: right}, rod: {shape: rod, mass: m, length: L}, crate: {mass: n, moves: right}}
connections:
  under: {contact: [truck, rails]}
  base: {contact: [crate, rails]}
  pin: {hinge: [truck, rod.start]}
  coil: {spring: ENDS, stiffness: k}
states: {start: {rod.angle: PHI deg, coil.elongation: e, at rest: all}}
find: {A: truck.acceleration, alpha: rod.angular_acceleration, a: crate.acceleration}
"""


@pytest.mark.parametrize(
    ("ends", "phi", "across", "up"),
    [
        ("[ceiling, rod.end]", -60, 0, 80),
        ("[ground, rod.end]", -60, 0, -80),
        ("[rod.end, crate]", -90, 80, 0),
        ("[crate, rod.end]", -90, -80, 0),
    ],
)
def test_a_spring_to_a_rod_that_a_truck_carries_is_upright_but_for_what_travels(
    ends: str, phi: int, across: float, up: float
) -> None:
    """(M + m) A − ½ m L sin φ α = F_x, ⅓ m L² α − ½ m L sin φ A = L (F_y cos φ − F_x sin φ) − ½ m g L cos φ."""
    solution = solve(HUNG.replace("ENDS", ends).replace("PHI", str(phi)))
    sine, cosine = math.sin(math.radians(phi)), math.cos(math.radians(phi))
    coupling, twist = -10 / 2 * sine, -10 * G / 2 * cosine + up * cosine - across * sine
    share = 30 * 10 / 3 - coupling**2
    found = {
        "A": (across * 10 / 3 - coupling * twist) / share,
        "alpha": (30 * twist - coupling * across) / share,
        "a": -across / 5,
    }
    for name, value in found.items():
        assert solution.answers[name].float == pytest.approx(value, abs=1e-9), name
    assert all(verdict.holds for verdict in solution.derivation.confirmed)


@pytest.mark.parametrize("along", ["", ", along: ramp"])
@pytest.mark.parametrize("order", ["load, wheel, cart", "cart, wheel, load"])
@pytest.mark.parametrize("falls", ["left", "right"])
@pytest.mark.parametrize("rubs", ["friction: none", "friction: mu"])
def test_a_string_along_a_slope_pulls_up_that_slope(along: str, order: str, falls: str, rubs: str) -> None:
    """(m + n) a = n g − m g sin β − μ m g cos β of a load that draws a cart up, whichever way the slope falls and the names stand."""
    found = solve(f"""title: Load over a pulley at the top of a slope
given: {{m: 2 kg, n: 6 kg, beta: 25 deg, mu: 0.1, g: 9.8 m/s^2}}
surfaces: {{ramp: {{slope: beta, down: {falls}}}}}
bodies: {{cart: {{mass: m, moves: up}}, load: {{mass: n, moves: down}}, wheel: {{shape: disc, mass: 0}}}}
connections:
  base: {{contact: [cart, ramp], {rubs}}}
  ax: {{axle: wheel}}
  line: {{string: [{order}]{along}}}
find: {{a: cart.acceleration, T: line.tension}}
""")
    rubbing = 0.1 * math.cos(math.radians(25)) if "mu" in rubs else 0.0
    a = 9.8 * (6 - 2 * math.sin(math.radians(25)) - 2 * rubbing) / 8
    assert found.answers["a"].float == pytest.approx(a)
    assert found.answers["T"].float == pytest.approx(6 * (9.8 - a))


@pytest.mark.parametrize(
    ("order", "falls"), [("drum.rim, cart", "left"), ("drum.rim, cart", "right"), ("cart, drum.rim", "left")]
)
def test_a_drum_at_the_top_of_a_slope_holds_what_would_run_down(order: str, falls: str) -> None:
    """(I/R² + m) a = m g sin β down the slope."""
    found = solve(f"""title: Cart that unwinds a drum
given: {{m: 2 kg, I: 0.1 kg m^2, R: 0.2 m, beta: 25 deg, g: 9.8 m/s^2}}
surfaces: {{ramp: {{slope: beta, down: {falls}}}}}
bodies: {{cart: {{mass: m, moves: down}}, drum: {{inertia: I, radius: R}}}}
connections: {{base: {{contact: [cart, ramp], friction: none}}, ax: {{axle: drum}}, line: {{string: [{order}], along: ramp}}}}
find: {{a: cart.acceleration}}
""")
    assert found.answers["a"].float == pytest.approx(2 * 9.8 * math.sin(math.radians(25)) / (2 + 0.1 / 0.04))
