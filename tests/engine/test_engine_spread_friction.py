"""Friction over a face: torques against sums over pieces, ropes and bands against Euler's formula, and what is refused."""

from __future__ import annotations

import math

import pytest

import rotsolve

N = 4000  # pieces


def value(scene: str, name: str) -> float:
    found = rotsolve.solve(scene).answers[name].float
    assert found is not None
    return found


def mean_arm(inner: float, outer: float, pressure: str = "pressure") -> float:
    """Σ r p r Δr/Σ p r Δr over thin rings."""
    radii = [inner + (outer - inner) * (k + 0.5) / N for k in range(N)]
    weights = [1.0 if pressure == "wear" else r for r in radii]
    return sum(r * w for r, w in zip(radii, weights, strict=True)) / sum(weights)


TABLE = """
title: What turns on a rough table
plane: horizontal
surfaces: {table: level}
bodies: {it: {BODY, mass: 2 kg}}
connections: {HOLD face: {contact: [it, table], friction: 0.3}}
states: {start: {it.angular_velocity: 8 rad/s}, end: {it.angular_velocity: 0}}
find: {M: size of face.torque at start, t: time from start to end}
"""
ROUND = {
    "shape: disc, radius: 20 cm": (mean_arm(0.0, 0.2), 0.02),
    "shape: cylinder, radius: 20 cm": (mean_arm(0.0, 0.2), 0.02),
    "shape: ring, radius: 20 cm": (0.2, 0.04),
    "shape: annulus, radii: {inner: 10 cm, outer: 20 cm}": (mean_arm(0.1, 0.2), 0.025),
    "shape: cylindrical shell, radii: {inner: 10 cm, outer: 20 cm}": (mean_arm(0.1, 0.2), 0.025),
}


@pytest.mark.parametrize("hold", ["", "pin: {axle: it},"])
@pytest.mark.parametrize("body", ROUND)
def test_a_round_body_on_a_rough_table(body: str, hold: str) -> None:
    arm, inertia = ROUND[body]
    scene = TABLE.replace("BODY", body).replace("HOLD", hold)
    torque = 0.3 * 9.8 * 2 * arm
    assert value(scene, "M") == pytest.approx(torque, rel=1e-6)
    assert value(scene, "t") == pytest.approx(2 * inertia * 8 / torque, rel=1e-6)


@pytest.mark.parametrize("at", [0.0, 0.1, 0.25, 0.4, 0.6])
def test_a_rod_about_any_of_its_points(at: float) -> None:
    scene = TABLE.replace("BODY", "shape: rod, length: 60 cm").replace("HOLD", f"pin: {{hinge: it.at({at} m)}},")
    places = [0.6 * (k + 0.5) / N for k in range(N)]
    torque = 0.3 * 9.8 * 2 * sum(abs(x - at) for x in places) / N
    inertia = 2 * (0.6**2 / 12 + (0.3 - at) ** 2)
    assert value(scene, "M") == pytest.approx(torque, rel=1e-5)
    assert value(scene, "t") == pytest.approx(inertia * 8 / torque, rel=1e-5)


def test_the_pin_of_a_rod_takes_what_friction_leaves() -> None:
    scene = TABLE.replace("BODY", "shape: rod, length: 60 cm").replace("HOLD", "pin: {hinge: it.start},")
    scene = scene.replace("8 rad/s", "8 rad/s, it.angle: 0").replace(
        "t: time from start to end", "Y: pin.force.y at start"
    )
    # of μ M g, upwards on the pin, what slows the centre of mass down: M (L/2) α with α = 3 μ g/(2 L)
    assert value(scene, "Y") == pytest.approx(0.3 * 2 * 9.8 / 4, rel=1e-9)


def test_a_puck_at_the_end_of_a_light_rod() -> None:
    scene = """
title: A puck on a light rod
plane: horizontal
surfaces: {table: level}
bodies: {rod: {shape: rod, mass: 0, length: 50 cm}, puck: {mass: 3 kg}}
connections: {pin: {hinge: rod.start}, tie: {weld: [rod.end, puck]}, face: {contact: [puck, table], friction: 0.2}}
states: {start: {rod.angular_velocity: 6 rad/s}, end: {rod.angular_velocity: 0}}
find: {n: rod.rotation from start to end}
"""
    assert value(scene, "n") == pytest.approx(36 * 0.5 / (2 * 0.2 * 9.8), rel=1e-9)


SHAFT = """
title: A shaft whose end is pressed on a bearing
plane: horizontal
bodies: {rotor: {inertia: 2 kg m^2}}
connections: {foot: {axle: rotor, press: 300 N, friction: 0.2, FACE}}
states: {start: {rotor.angular_velocity: 9 rad/s}}
find: {M: size of foot.torque}
"""


@pytest.mark.parametrize("uniform", ["pressure", "wear"])
@pytest.mark.parametrize(("face", "inner"), [("radius: 8 cm", 0.0), ("radii: {inner: 3 cm, outer: 8 cm}", 0.03)])
@pytest.mark.parametrize(("cone", "sine"), [("", 1.0), (", cone: 25 deg", math.sin(math.radians(25)))])
def test_a_face_that_is_pressed(uniform: str, face: str, inner: float, cone: str, sine: float) -> None:
    scene = SHAFT.replace("FACE", f"{face}{cone}, uniform: {uniform}")
    assert value(scene, "M") == pytest.approx(0.2 * 300 * mean_arm(inner, 0.08, uniform) / sine, rel=1e-6)


BAND = """
title: A band brake
plane: horizontal
bodies: {drum: {inertia: 2 kg m^2, radius: 20 cm}}
connections: {axle: {axle: drum}}
actions: {brake: {band: 30 N, on: drum.rim, friction: 0.25, wrap: 200 deg, direction: SENSE}}
states: {start: {drum.angular_velocity: RATE}}
find: {M: brake.torque, T: brake.tension}
"""


@pytest.mark.parametrize(("sense", "drawn"), [("clockwise", -1), ("counterclockwise", 1)])
@pytest.mark.parametrize("rate", [7, -7])
def test_a_band_holds_more_where_the_rim_runs_towards_the_pull(sense: str, drawn: int, rate: int) -> None:
    scene = BAND.replace("SENSE", sense).replace("RATE", f"{rate} rad/s")
    growth = math.exp(0.25 * math.radians(200))
    tension = 30 * (growth if rate * drawn > 0 else 1 / growth)
    assert value(scene, "T") == pytest.approx(tension, rel=1e-9)
    assert value(scene, "M") == pytest.approx(drawn * (30 - tension) * 0.2, rel=1e-9)
    assert value(scene, "M") * rate < 0


POST = """
title: Two loads on a rope over a rough beam
surfaces: {beam: post}
bodies: {one: {mass: FIRST kg, moves: up}, two: {mass: 4 kg, moves: down}}
connections: {rope: {string: [one, beam, two], friction: 0.3, wrap: 180 deg}}
states: {start: START}
find: {a: two.acceleration, T1: rope.one.tension, T2: rope.two.tension}
"""
GROWTH = math.exp(0.3 * math.pi)


@pytest.mark.parametrize("first", [1, 1.5, 1.7, 4, 10, 10.5, 30])
def test_a_rope_sticks_to_its_post_or_slips(first: float) -> None:
    scene, g = POST.replace("FIRST", str(first)).replace("START", "at rest"), 9.8
    down, up = (4 - first * GROWTH) * g / (4 + first * GROWTH), (4 * GROWTH - first) * g / (4 * GROWTH + first)
    expected = down if down > 0 else min(up, 0.0)
    assert value(scene, "a") == pytest.approx(expected, rel=1e-9, abs=1e-12)
    assert value(scene, "T1") == pytest.approx(first * (g + expected), rel=1e-9)
    assert value(scene, "T2") == pytest.approx(4 * (g - expected), rel=1e-9)


def test_a_rope_that_slips_rubs_against_that() -> None:
    scene = POST.replace("FIRST", "1").replace("START", "{two.velocity: -1 m/s}")
    assert value(scene, "a") == pytest.approx((4 * GROWTH - 1) * 9.8 / (4 * GROWTH + 1), rel=1e-9)


COIN = """
title: A coin on a turntable
plane: horizontal
given: {w: rad/s, c: 3 rad/s^2, mu: 0.35}
bodies: {table: {inertia: 1 kg m^2}, coin: {mass: 10 g, radius: 12 cm}}
connections: {pin: {axle: table, angular_acceleration: c}, lies: {contact: [coin, table], friction: mu}}
states: {start: at rest, slip: {lies: slips}}
find: {w1: table.angular_velocity at slip}
"""


def test_a_coin_slips_where_all_of_its_acceleration_is_too_much() -> None:
    spin = value(COIN.replace("w: rad/s, ", ""), "w1")
    assert 0.12 * math.hypot(spin**2, 3) == pytest.approx(0.35 * 9.8, rel=1e-9)


def test_a_wheel_that_rolling_resistance_holds() -> None:
    scene = """
title: A wheel on a slope
given: {beta: ANGLE}
surfaces: {ramp: {slope: beta}}
bodies: {wheel: {shape: disc, mass: 10 kg, radius: 30 cm, moves: down}}
connections: {touch: {rolls: [wheel, ramp], rolling_friction: 1 cm}}
states: {start: at rest}
find: {a: wheel.acceleration}
"""
    angle = math.radians(3)
    push = 9.8 * (math.sin(angle) - 0.01 / 0.3 * math.cos(angle)) / 1.5
    assert value(scene.replace("ANGLE", "3 deg"), "a") == pytest.approx(push, rel=1e-9)
    assert value(scene.replace("ANGLE", "1 deg"), "a") == 0


REFUSED = {
    "travels over `table` seen from above": TABLE.replace("BODY", "shape: disc, radius: 1 m, moves: right"),
    "`velocity` moves its centre": TABLE.replace("BODY", "shape: disc, radius: 1 m").replace(
        "8 rad/s}", "8 rad/s, it.velocity: 1 m/s}"
    ),
    "`push` moves its centre": TABLE.replace("BODY", "shape: disc, radius: 1 m")
    + "actions: {push: {force: 2 N, on: it, direction: right}}",
    "`tug` moves its centre": TABLE.replace("BODY", "shape: disc, radius: 1 m")
    + "actions: {tug: {band: 2 N, on: it.rim, friction: 0.2, wrap: 90 deg, direction: clockwise}}",
    "a rectangle, rubs on `table` about that axis is not solved": TABLE.replace(
        "BODY", "shape: rectangle, sides: [1 m, 2 m]"
    ),
    "a sphere, rubs on `table`": TABLE.replace("BODY", "shape: sphere, radius: 1 m"),
    "a disc, rubs on `table` about that axis": TABLE.replace("BODY", "shape: disc, radius: 1 m").replace(
        "HOLD", "pin: {hinge: it.rim},"
    ),
    "over what face `it` rubs": TABLE.replace("BODY", "radius: 1 m, inertia: 2 kg m^2"),
    "static and kinetic friction that differ": TABLE.replace("BODY", "shape: disc, radius: 1 m").replace(
        "friction: 0.3", "friction: {static: 0.4, kinetic: 0.3}"
    ),
    "nothing presses `it` on `table`": TABLE.replace("BODY", "shape: disc, radius: 1 m") + "gravity: none",
    "has no face that rubs": SHAFT.replace(", FACE", ""),
    "has a `press` and no `friction`": SHAFT.replace(" friction: 0.2, FACE", " radius: 8 cm"),
    "has a `radius`, as of a full face, and `radii`": SHAFT.replace(
        "FACE", "radius: 8 cm, radii: {inner: 1 cm, outer: 8 cm}"
    ),
    "tells its `friction_torque` and, by `press`": SHAFT.replace("FACE", "radius: 8 cm, friction_torque: 2 N m"),
    "does not just run from one body round one post": POST.replace("[one, beam, two]", "[one, two]"),
    "has no `wrap`": POST.replace(", wrap: 180 deg", "").replace("FIRST", "1").replace("START", "at rest"),
    "draws on it from where its ends run": BAND.replace("SENSE", "clockwise")
    .replace("RATE", "7 rad/s")
    .replace("M: brake.torque, T: brake.tension", "F: axle.force"),
    "in a scene seen from above": COIN.replace("plane: horizontal", "").replace("contact:", "rides:"),
}


@pytest.mark.parametrize("message", REFUSED)
def test_what_is_not_solved_is_refused_by_name(message: str) -> None:
    scene = REFUSED[message].replace("HOLD ", "").replace("FIRST", "1").replace("START", "at rest")
    with pytest.raises((rotsolve.Unsolvable, rotsolve.SceneError)) as refusal:
        rotsolve.solve(scene)
    assert message in str(refusal.value)


BORNE = """
plane: horizontal
given: {M: 2 kg, m: 1 kg, R: 30 cm, mu: 0.25, w: 10 rad/s}
surfaces: {table: level}
bodies: {disc: {shape: disc, mass: M, radius: R}, ring: {shape: ring, mass: m, radius: R}}
connections: {pin: {axle: disc}, j: {weld: [disc.center, ring.center]}, face: {contact: [disc, table], friction: mu}}
states: {start: {disc.angular_velocity: w}, end: {disc.angular_velocity: 0}}
find: {t: time from start to end}
"""
LOADED_COIN = """
plane: horizontal
given: {m: 20 g, n: 30 g, r: 10 cm, mu: 0.3, w: 2 rad/s}
bodies: {table: {inertia: 1 kg m^2}, coin: {mass: m, radius: r}, lump: {mass: n}}
connections: {axle: {axle: table}, lies: {contact: [coin, table], friction: mu}, other: OTHER}
ACTS
states: {now: {table.angular_velocity: w, table.angular_acceleration: 0}}
find: {f: lies.friction_force}
"""


def test_what_a_body_on_a_table_bears_presses_too() -> None:
    """It needs a contact of its own: I ω/(⅔ μ M g R + μ m g R)."""
    with pytest.raises(rotsolve.core.faults.Unsolvable, match="`ring` is borne by `disc`"):
        rotsolve.solve(BORNE)
    found = (
        rotsolve.solve(BORNE.replace("face:", "rim: {contact: [ring, table], friction: mu}, face:")).answers["t"].float
    )
    assert found == pytest.approx((1 + 1) * 0.09 * 10 / (0.25 * 9.8 * 0.3 * (4 / 3 + 1)), rel=1e-9)


@pytest.mark.parametrize(
    ("other", "acts"),
    [("{weld: [coin, lump]}", ""), ("{axle: lump}", "actions: {push: {force: 0.1 N, on: coin, direction: right}}")],
)
def test_friction_alone_holds_a_coin(other: str, acts: str) -> None:
    with pytest.raises(rotsolve.core.faults.Unsolvable, match="friction alone holds what lies on a turning table"):
        rotsolve.solve(LOADED_COIN.replace("OTHER", other).replace("ACTS", acts))
