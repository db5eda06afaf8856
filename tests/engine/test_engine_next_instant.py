"""A state is the next instant at which what it says holds: by the way that bodies go, to the left as to the right, with all laws."""

from __future__ import annotations

from math import cos, radians, sin, sqrt, tan

import pytest

from rotsolve import Unsolvable
from rotsolve.pipeline import solve
from stepping import numbers

G = 9.8


def answers(scene: str, law: str | None = None) -> dict[str, float]:
    return numbers(solve(scene, law=law))


THROWN = """
title: Thrown along its line and back
given: {u: 6 m/s, m: 1 kg, l: 1 m}
bodies: {stone: {mass: m, moves: SENSE}}
states: {thrown: {stone.velocity: SPEED}, caught: {stone.displacement: PLACE}}
find: {v: stone.velocity at caught, t: time from thrown to caught}
"""


@pytest.mark.parametrize("place", [0.0, -2.0])
@pytest.mark.parametrize("sense", ["up", "down"])
def test_what_is_thrown_up_comes_back(sense: str, place: float) -> None:
    way = 1 if sense == "up" else -1
    scene = THROWN.replace("SENSE", sense).replace("SPEED", "u" if way > 0 else "-u")
    found = answers(scene.replace("PLACE", f"{way * place}*l" if place else "0"))
    speed = sqrt(36 - 2 * G * place)
    assert found["v"] == pytest.approx(-way * speed)
    assert found["t"] == pytest.approx((6 + speed) / G)


BUFFER = """
title: On a buffer
given: {m: 800 kg, k: 20 kN/m, u: 1.5 m/s}
surfaces: {rail: level}
bodies: {truck: {mass: m, moves: SENSE}}
connections: {wheels: {contact: [truck, rail]}, buffer: {spring: ENDS, stiffness: k}}
states: {touch: {buffer.elongation: 0, truck.velocity: SPEED}, deep: {truck.velocity: 0}, back: {buffer.elongation: 0}}
find: {x: buffer.elongation at deep, d: truck.displacement from touch to deep, v: truck.velocity at back, t: time from touch to back}
"""
AT_DEEP = "x: buffer.elongation at deep, d: truck.displacement from touch to deep, "


@pytest.mark.sampled(3)
@pytest.mark.parametrize("sense", ["right", "left"])
@pytest.mark.parametrize("speed", ["u", "-u"])
@pytest.mark.parametrize("ends", ["[truck, ground]", "[ground, truck]"])
@pytest.mark.parametrize("named", [True, False])
def test_a_buffer_gives_way_as_the_truck_goes(sense: str, speed: str, ends: str, named: bool) -> None:
    scene = BUFFER.replace("SENSE", sense).replace("SPEED", speed).replace("ENDS", ends)
    deep, way = 1.5 * sqrt(800 / 20000), 1 if speed == "u" else -1
    right = way * (1 if sense == "right" else -1)
    if not named:
        scene = scene.replace("deep: {truck.velocity: 0}, ", "").replace(AT_DEEP, "")
    found = answers(scene)
    assert found["v"] == pytest.approx(-1.5 * way)
    assert found["t"] == pytest.approx(3.141592653589793 * sqrt(800 / 20000))
    if named:
        assert found["d"] == pytest.approx(deep * way)
        assert found["x"] == pytest.approx(-deep * right if ends.startswith("[truck") else deep * right)


PENDULUM = """
title: Rod that swings
given: {m: 2 kg, L: 1 m, w: W rad/s}
bodies: {rod: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: rod.start}}
states: {start: {rod.angle: FROM deg, rod.angular_velocity: w}, there: {rod.angle: TO deg}}
find: {w1: rod.angular_velocity at there}
"""


@pytest.mark.parametrize(
    ("start", "speed", "end", "sign"),
    [
        (-80, 2, -80, -1),
        (-80, 2, -100, -1),
        (-80, 2, -70, 1),
        (-100, -2, -100, 1),
        (-100, -2, -80, 1),
        (-90, 9, 260, 1),
    ],
)
def test_a_pendulum_comes_by_as_it_swings(start: float, speed: float, end: float, sign: int) -> None:
    scene = PENDULUM.replace("FROM", str(start)).replace("TO", str(end)).replace("W", str(speed))
    size = sqrt(speed**2 + 3 * G * (sin(radians(start)) - sin(radians(end))))
    assert answers(scene)["w1"] == pytest.approx(sign * size)


@pytest.mark.parametrize(("start", "speed", "end"), [(-90, 2, 260), (-80, 20, -80), (-90, -2, -440), (-60, 1, -45)])
def test_a_place_that_it_never_gets_to_is_refused(start: float, speed: float, end: float) -> None:
    scene = PENDULUM.replace("FROM", str(start)).replace("TO", str(end)).replace("W", str(speed))
    with pytest.raises(Unsolvable, match="never reached"):
        solve(scene)


GATE = """
title: Puck and gate
plane: horizontal
given: {M: 1.2 kg, m: MASS kg, L: 80 cm, u: 5 m/s, v: unknown}
bodies: {gate: {shape: rod, mass: M, length: L}, puck: {mass: m, moves: SENSE}}
connections: {post: {hinge: gate.start}}
states: {before: {gate.angle: 0, at rest: gate, puck.velocity: SPEED}, after: {puck.velocity: v}}
events: {hit: {collides: [puck, gate.at(PART*L)], from: before, to: after}}
find: {v: v where lost kinetic_energy during hit = 0}
"""


@pytest.mark.parametrize("sense", ["up", "down"])
@pytest.mark.parametrize("speed", [5, -5])
@pytest.mark.parametrize(("mass", "part"), [(0.4, 0.75), (2.5, 0.5)])
def test_what_meets_does_not_pass_through(sense: str, speed: float, mass: float, part: float) -> None:
    scene = GATE.replace("SENSE", sense).replace("SPEED", "u" if speed > 0 else "-u")
    scene = scene.replace("MASS", str(mass)).replace("PART", str(part))
    inertia, arm = 1.2 * 0.64 / 3, part * 0.8
    expected = speed * (mass * arm**2 - inertia) / (mass * arm**2 + inertia)
    assert answers(scene)["v"] == pytest.approx(expected)


HELD = """
title: Held on a slope
given: {m: 4 kg, beta: SLOPE deg, mu: 0.2, P: unknown}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {crate: {mass: m, moves: up}}
connections: {touch: {contact: [crate, ramp], friction: mu}}
actions: {push: {force: P, on: crate, direction: beta}}
states: {start: at rest}
find: {FIND}
"""
LARGEST, SMALLEST = "large: largest P where touch sticks", "small: smallest P where touch sticks"


@pytest.mark.parametrize("order", [f"{LARGEST}, {SMALLEST}", f"{SMALLEST}, {LARGEST}", LARGEST, SMALLEST])
def test_both_ends_of_what_holds(order: str) -> None:
    found = answers(HELD.replace("SLOPE", "30").replace("FIND", order))
    along, across = 4 * G * sin(radians(30)), 0.2 * 4 * G * cos(radians(30))
    expected = {"large": along + across, "small": along - across}
    assert found == pytest.approx({name: expected[name] for name in found})


def test_what_holds_without_a_push_has_no_smallest() -> None:
    with pytest.raises(Unsolvable, match="sticks however small `P` is"):
        solve(HELD.replace("SLOPE", "8").replace("FIND", SMALLEST))


TWO = """
title: Friction settled by one
given: {m: 3 kg, R: 20 cm, beta: 35 deg, mu: unknown}
surfaces: {ramp: {slope: beta, down: right}}
bodies:
  one: {shape: ONE, mass: m, radius: R, moves: down}
  other: {shape: OTHER, mass: m, radius: R, moves: down}
connections:
  grip1: {contact: [one, ramp], friction: mu}
  grip2: {contact: [other, ramp], friction: mu}
states: {start: {at rest: all}}
find: {mu: smallest mu where grip1 sticks, a: other.acceleration at start}
"""
SHARES = {"ring": 1.0, "cylinder": 0.5, "sphere": 0.4}


@pytest.mark.parametrize("one", SHARES)
@pytest.mark.parametrize("other", SHARES)
def test_contacts_slip_by_a_friction_that_another_settles(one: str, other: str) -> None:
    found, slope = answers(TWO.replace("ONE", one).replace("OTHER", other)), radians(35)
    mu = tan(slope) * SHARES[one] / (1 + SHARES[one])
    rolls = SHARES[other] <= SHARES[one]
    expected = G * sin(slope) / (1 + SHARES[other]) if rolls else G * (sin(slope) - mu * cos(slope))
    assert found == pytest.approx({"mu": mu, "a": expected})


@pytest.mark.parametrize("sense", ["down", "up"])
def test_a_force_that_takes_a_load_from_rest_to_rest_does_not_stay_the_same(sense: str) -> None:
    scene = f"""
title: From rest to rest
given: {{m: 250 kg, E: 9 kJ, d: unknown}}
bodies: {{load: {{mass: m, moves: {sense}}}}}
actions: {{rope: {{force: unknown, on: load, direction: up}}}}
states: {{held: {{load.velocity: 0}}, there: {{load.displacement: d, load.velocity: 0}}}}
find: {{d: d where (rope.work from held to there) = {"-E" if sense == "down" else "E"}, p: load.momentum at held}}
"""
    assert answers(scene) == pytest.approx({"d": 9000 / (250 * G), "p": 0.0})
