"""What a later state says may be so where the motion sets out as well: meant is the first instant after that."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

G = 9.8
LADDER = """
title: ladder
given: {{m: 10 kg, l: 4 m, w: 0.01 rad/s}}
surfaces: {{floor: level, side: {{wall: {side}}}}}
bodies: {{ladder: {{shape: rod, mass: m, length: l}}}}
connections:
  foot: {{contact: [ladder.start, floor], friction: none}}
  top: {{contact: [ladder.end, side], friction: none}}
states: {{up: {{ladder.angle: 90 deg, {start}}}, off: {{{line}}}}}
find: {{x: ladder.angle at off in deg, v: ladder.velocity.x at off}}
"""
ROD = """
title: rod
given: {{m: 3 kg, L: 1.4 m, w: 0.01 rad/s}}
bodies: {{rod: {{shape: rod, mass: m, length: L}}}}
connections: {{pin: {{hinge: rod.start}}}}
states: {{up: {{rod.angle: 90 deg, {start}}}, z: {{{line}}}}}
find: {{x: rod.angle at z in deg}}
"""
OFF = math.degrees(
    math.asin(2 / 3)
)  # where a rod that falls from upright pushes its hinge, or a ladder its wall, no longer


def number(text: str, name: str = "x") -> float:
    value = solve(text).answers[name].float
    assert value is not None
    return value


@pytest.mark.parametrize("line", ["top: leaves", "top.normal_force: 0"])
@pytest.mark.parametrize("start", ["at rest: all", "ladder.angular_velocity: {}w"])
@pytest.mark.parametrize("side", ["left", "right"])
def test_a_ladder_leaves_its_wall_after_it_has_stood_upright(side: str, start: str, line: str) -> None:
    """Its foot goes away from the wall, and never into it, whichever way the least push goes."""
    sign = 1 if side == "left" else -1
    text = LADDER.format(side=side, line=line, start=start.format("" if sign > 0 else "-"))
    assert number(text) == pytest.approx(math.degrees(math.pi) - OFF if sign > 0 else OFF, abs=1e-2)
    assert number(text, "v") == pytest.approx(sign * math.sqrt(4 * G) / 3, rel=1e-3)


@pytest.mark.parametrize(("line", "place"), [("pin.force.x: 0", OFF), ("rod.angular_acceleration: 0", -90.0)])
@pytest.mark.parametrize("start", ["at rest: all", "rod.angular_velocity: -w", "rod.angular_velocity: w"])
def test_a_rod_comes_from_upright_to_where_it_is_so_again(start: str, line: str, place: float) -> None:
    place = 180.0 - place if start.endswith(" w") else place
    assert number(ROD.format(start=start, line=line)) == pytest.approx(place, abs=1e-2)


COLLAR = """
title: collar
given: {{m: 2 kg, d: 0.3 m, k: 300 N/m, l0: 0.25 m}}
bodies: {{collar: {{mass: m, moves: down}}}}
connections: {{coil: {{spring: [[-d, 0], collar], stiffness: k, rest_length: l0}}}}
states: {{go: {{collar.displacement: 0, {start}}}, {between}end: {{collar.velocity: 0}}}}
find: {{x: collar.displacement from go to end}}
"""
COLLARS = {  # how it sets out, a place on its way, sign of the place where it comes to rest
    "dropped": ("at rest: all", "", 1),
    "dropped, by a place": ("at rest: all", "low: {collar.displacement: 0.2 m}, ", 1),
    "thrown down": ("collar.velocity: 1 m/s", "", 1),
    "thrown down, by a place": ("collar.velocity: 1 m/s", "low: {collar.displacement: 0.2 m}, ", 1),
    "thrown up": ("collar.velocity: -1 m/s", "", -1),
}


@pytest.mark.parametrize("kind", COLLARS)
def test_a_collar_comes_to_rest_ahead_of_it(kind: str) -> None:
    start, between, sign = COLLARS[kind]
    x = number(COLLAR.format(start=start, between=between))
    begun = 0.0 if start.startswith("at rest") else 1.0
    stored = 150 * ((math.hypot(0.3, x) - 0.25) ** 2 - 0.05**2)
    assert x * sign > 0.01
    assert 2 * G * x + begun == pytest.approx(stored, rel=1e-5)


@pytest.mark.parametrize(("before", "place"), [("far", 0.0), ("low", 0.392)])
def test_a_block_on_a_spring_goes_on_from_a_place_to_the_next_turning_point(before: str, place: float) -> None:
    """The place at which it is not stretched is a turning point like the other, and no start, where another state lies between."""
    back = "far: {block.velocity: 0}, " if before == "far" else ""
    text = f"""
title: on a spring
given: {{m: 2 kg, k: 100 N/m}}
bodies: {{block: {{mass: m, moves: down}}}}
connections: {{coil: {{spring: [ceiling, block], stiffness: k}}}}
states: {{go: {{coil.elongation: 0, at rest: all}}, {back}mid: {{coil.elongation: 0.1 m}}, end: {{block.velocity: 0}}}}
find: {{x: coil.elongation at end}}
"""
    assert number(text) == pytest.approx(place, abs=1e-4)


def test_a_rod_on_collars_comes_to_rest_past_a_place_on_its_way() -> None:
    text = """
title: collars
given: {m: 3 kg, L: 0.8 m, k: 60 N/m}
bodies:
  rod: {shape: rod, mass: m, length: L}
  d: {mass: m/2, moves: right}
connections:
  a: {hinge: [d, rod.start]}
  b: {slot: rod.end, along: up}
  coil: {spring: [ground, d], stiffness: k}
states: {go: {rod.angle: 70 deg, coil.elongation: 0, at rest: all}, mid: {rod.angle: 65 deg}, low: {rod.angular_velocity: 0}}
find: {x: rod.angle at low in deg}
"""
    angle = math.radians(number(text))
    spring = 0.5 * 60 * 0.64 * (math.cos(math.radians(70)) - math.cos(angle)) ** 2
    assert math.degrees(angle) == pytest.approx(38.37, abs=5e-3)
    assert 3 * G * 0.4 * (math.sin(math.radians(70)) - math.sin(angle)) == pytest.approx(spring, rel=1e-6)


TUBE = """
title: tube
plane: horizontal
given: {{m: 1.6 kg, r1: {first} m, w: {rate} rad/s, k: 60 N/m, a: 0.15 m, u: 0.4 m/s, r3: unknown}}
bodies: {{rod: {{shape: rod, mass: 0.9 kg, length: 1 m}}, tube: {{mass: m}}}}
connections:
  pin: {{hinge: rod.start}}
  track: {{rides: [tube, rod], friction: none}}
  coil: {{spring: [rod.start, tube], stiffness: k, rest_length: a}}
states:
  start: {{tube.radius: r1, tube.velocity.radial: {speed}, rod.angular_velocity: w}}
  {between}end: {{tube.velocity.radial: 0, tube.radius: r3}}
find: {{x: r3}}
"""
TUBES = {  # where and how it sets out, how fast the rod turns, a place on its way, where it comes to rest along the rod
    "out": (0.2, "0", 5, "", 0.36692),
    "out by a place": (0.2, "0", 5, "mid: {tube.radius: 0.25 m}\n  ", 0.36692),
    "in by a place": (0.36691959, "0", 3.5310, "mid: {tube.radius: 0.25 m}\n  ", 0.2),
    "thrown out": (0.25, "u", 5, "", 0.39324),
    "thrown in": (0.25, "-u", 5, "", 0.22322),
}


@pytest.mark.parametrize("kind", TUBES)
def test_a_tube_with_a_spring_comes_to_rest_ahead_of_it(kind: str) -> None:
    first, speed, rate, between, last = TUBES[kind]
    text = TUBE.format(first=first, speed=speed, rate=rate, between=between)
    assert number(text) == pytest.approx(last, abs=2e-4)


DRUM = """
title: drum
given: {{I: 2 kg m^2, R: 0.3 m, r: 0.2 m, m: 50 kg, mu: 0.5, F: {press} N, v: 2 m/s}}
bodies: {{drum: {{inertia: I, radii: {{brake: R, rope: r}}}}, load: {{mass: m, moves: down}}}}
connections: {{axle1: {{axle: drum}}, s: {{string: [load, drum.rope]}}}}
actions: {{b: {{press: F, on: drum.brake, friction: mu}}}}
states: {{go: {{load.velocity: v}}, end: {{load.velocity: 0}}}}
find: {{x: {asked} at end}}
"""
DISCS = """
title: discs
given: {{F: 60 N, Q: {couple} N m}}
bodies: {{a: {{inertia: 0.4 kg m^2, radius: 0.1 m}}, b: {{inertia: 0.9 kg m^2, radius: 0.25 m}}}}
connections: {{axle1: {{axle: a}}, y: {{axle: b, friction_torque: 3 N m}}, z: {{contact: [a, b], press: F, friction: 0.4}}}}
actions: {{motor: {{couple: Q, on: a}}}}
states: {{start: {{a.angular_velocity: 50 rad/s, b.angular_velocity: 0}}, end: {{z: rolls}}}}
find: {{x: {asked} at end}}
"""


@pytest.mark.parametrize("asked", ["load.acceleration", "s.tension", "b.torque"])
@pytest.mark.parametrize("press", ["400", "1960/3", "900"])
def test_a_brake_that_is_too_weak_brings_nothing_to_rest(press: str, asked: str) -> None:
    """Whatever is asked of the end; just as strong as the load it lets that go on as fast as it does."""
    text = DRUM.format(press=press, asked=asked)
    if press == "900":
        assert number(text) == pytest.approx({"load": 0.0, "s": 50 * G, "b": -10 * G}[asked[: asked.index(".")]])
        return
    with pytest.raises(Unsolvable, match="`end` is never reached from `go`"):
        solve(text)


@pytest.mark.parametrize("asked", ["a.angular_acceleration", "z.friction_force"])
@pytest.mark.parametrize("couple", [10, -10])
def test_wheels_whose_slip_grows_never_roll_on_each_other(couple: int, asked: str) -> None:
    """The rim of a gains Q r/I − μ F r²/I, that of b (μ F R − τ) R/J."""
    gains = 0.1 * (couple - 2.4) / 0.4 - 0.25 * (6.0 - 3.0) / 0.9
    text = DISCS.format(couple=couple, asked=asked)
    if gains < 0:
        assert solve(text).answers
        return
    with pytest.raises(Unsolvable, match="`end` is never reached from `start`"):
        solve(text)


@pytest.mark.parametrize("friction", [0.2, 0.4])
def test_a_block_on_a_steep_ramp_never_comes_to_rest(friction: float) -> None:
    text = f"""
title: ramp
surfaces: {{ramp: {{slope: 20 deg, down: right}}}}
bodies: {{block: {{mass: 2 kg, moves: down}}}}
connections: {{base: {{contact: [block, ramp], friction: {friction}}}}}
states: {{go: {{block.velocity: 3 m/s}}, end: {{block.velocity: 0}}}}
find: {{x: block.acceleration at end}}
"""
    if friction > math.tan(math.radians(20)):
        assert number(text) == 0.0
        return
    with pytest.raises(Unsolvable) as refused:
        solve(text)
    assert "`end` is never reached from `go`" in str(refused.value)
    assert refused.value.fault.span is not None
