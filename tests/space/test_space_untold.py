"""Angles that nothing tells at a later state: what hangs on one is refused by name, all else is answered, by hand and by the assembly.

What hangs on one joint of the ground keeps its energy and its angular momentum about the direction that is free there.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Solution, Unsolvable, solve

SHAFT = """up: z
given: {{I0: 0.2 kg m^2, M: 1 kg, L: 0.6 m, d: {d} m, w0: {w0} rad/s, g: 9.8 m/s^2}}
bodies:
  shaft: {{mass: 0, inertia: {{principal: [I0, I0, I0]}}, points: {{O: [0, 0, 0], E: [d, 0, 0]}}}}
  rod: {{shape: rod, mass: M, length: L}}
connections: {{post: {{hinge: shaft.O, along: {along}{drive}}}, pin: {{hinge: [shaft.E, rod.start], along: "-y"}}}}
states: {{up: {{{rate}rod.angle: {start} deg, rod.angular_velocity: 0 rad/s}}, there: {{rod.angle: {end} deg}}}}
find: {{{find}}}
"""
FREE = {"along": "z", "drive": "", "rate": "shaft.angular_velocity: w0, "}
ASKED = "W: shaft.angular_velocity.z at there, w: rod.angular_velocity.y in shaft axes at there"
INERTIA, MASS, LENGTH, GRAVITY = 0.2, 1.0, 0.6, 9.8
DOOR = """up: z
given: {M: 10 kg, a: 0.8 m, b: 2 m, w: 3 rad/s, h: 0.9 m}
bodies: {door: {shape: cuboid, mass: M, sides: [a, 2 cm, b], points: {H: [-a/2, 0, 0]}}}
connections: {pin: {hinge: door.H, along: z, bearings: [-h, h]}}
states: {go: {door.angular_velocity: w}, later: {door.angular_velocity: w}}
find: {FIND}
"""
GIMBALS = """up: z
given: {A: 0.05 kg m^2, C: 0.02 kg m^2, s: 100 rad/s, w0: 2 rad/s}
bodies:
  fork: {mass: 0, inertia: {principal: [A, A, A]}, points: {O: [0, 0, 0]}}
  ring: {mass: 0, inertia: {principal: [A, A, A]}, points: {O: [0, 0, 0]}}
  wheel: {mass: 1 kg, inertia: {principal: [C/2, C/2, C]}, axis: z}
connections: {post: {hinge: fork.O, along: z}, pin: {hinge: [fork.O, ring.O], along: x}, ax: {axle: [ring.O, wheel], along: y}}
states:
  a: {fork.angular_velocity: w0, ring.angle: 0 deg, ring.angular_velocity: 1 rad/s, wheel.spin: s}
  b: {ring.angle: 10 deg}
find: {W: fork.angular_velocity.z at b, w: ring.angular_velocity.x in ring axes at b, s_2: wheel.spin at b}
"""


def values(solution: Solution) -> list[float]:
    return [answer.value.float for answer in solution.derivation.answers if answer.value is not None]


def verdicts(solution: Solution) -> set[bool | None]:
    return {item.holds for item in solution.derivation.confirmed}


def about_shaft(angle: float, d: float) -> float:
    """∫ (d + s cos φ)² dm of the rod."""
    cosine = math.cos(math.radians(angle))
    return MASS * (d * d + d * LENGTH * cosine + LENGTH**2 * cosine**2 / 3)


def fallen(start: float, end: float) -> float:
    return MASS * GRAVITY * LENGTH / 2 * (math.sin(math.radians(start)) - math.sin(math.radians(end)))


@pytest.mark.parametrize(
    ("d", "w0", "start", "end"),
    [(0, 5, 89.9, 0), (0, 5, 60, 0), (0.3, 2, 0, -80), (0.1, -3, 120, 200), (0.03, 1, 60, -70)],
)
def test_a_rod_falls_on_a_shaft_that_turns_freely(d: float, w0: float, start: float, end: float) -> None:
    """L = (I₀ + I_rod(φ)) W and ½ J φ̇² = what the weight does − ½ L (W − W₀)."""
    solution = solve(SHAFT.format(d=d, w0=w0, start=start, end=end, find=ASKED, **FREE)).complete()
    momentum = (INERTIA + about_shaft(start, d)) * w0
    rate = momentum / (INERTIA + about_shaft(end, d))
    turned = math.sqrt(2 * (fallen(start, end) - momentum * (rate - w0) / 2) / (MASS * LENGTH**2 / 3))
    assert values(solution) == pytest.approx([rate, math.copysign(turned, start - end)], rel=1e-9)
    assert verdicts(solution) == {True}


def test_a_rod_falls_on_a_shaft_that_is_driven_round() -> None:
    """½ J φ̇² = what the weight does + ½ Ω² (I(φ) − I(φ₀)): E − Ω L stays."""
    asked = "w: rod.angular_velocity.y in shaft axes at there"
    scene = SHAFT.format(d=0.1, w0=4, start=60, end=0, find=asked, along="z", drive=", angular_velocity: w0", rate="")
    work = fallen(60, 0) + 8 * (about_shaft(0, 0.1) - about_shaft(60, 0.1))
    solution = solve(scene).complete()
    assert values(solution) == pytest.approx([math.sqrt(2 * work / (MASS * LENGTH**2 / 3))], rel=1e-9)
    assert verdicts(solution) == {True}


def test_what_hangs_on_the_angle_is_refused_by_name() -> None:
    find = "x: rod.cm.position.x at there, a: shaft.x_axis at there, w: rod.angular_velocity at there"
    with pytest.raises(Unsolvable) as caught:
        solve(SHAFT.format(d=0, w0=5, start=60, end=0, find=find, **FREE))
    for asked in ("rod.cm.position.x", "shaft.x_axis.x", "rod.angular_velocity.x"):
        assert f"`{asked}` hangs on how `shaft` stands at `there`, which nothing tells" in str(caught.value)
    assert "ask for it `in shaft axes`, or tell `shaft.angle` in that state" in str(caught.value)


def test_on_a_shaft_that_leans_all_hangs_on_it() -> None:
    """Its weight turns it: the energy hangs on where it has turned to, and no angular momentum stays."""
    with pytest.raises(Unsolvable) as caught:
        solve(SHAFT.format(d=0, w0=5, start=60, end=0, find=ASKED, **FREE | {"along": "[1, 0, 2]"}))
    assert "how `shaft` stands at `there` nothing tells" in str(caught.value)


def test_what_never_comes_there_is_not_answered() -> None:
    """With the rod down it turns faster than its energy allows, though not beyond that."""
    scene = SHAFT.replace("0.2 kg", "0.02 kg").format(d=0.03, w0=12, start=-135, end=-45, find=ASKED, **FREE)
    with pytest.raises(Unsolvable) as caught:
        solve(scene)
    assert "`there` is never reached from `up`" in str(caught.value)


def test_a_door_that_turns_on_is_held_as_before() -> None:
    """Its centre goes round: M w² a/2 = 36 N, shared as the weight's torque asks: ± M g a/(4 h)."""
    solution = solve(
        DOOR.replace("FIND", "F: pin.bearing1.force in door axes at later, v: size of door.cm.velocity at later")
    )
    share = 10 * 9.8 * 0.8 / (4 * 0.9)
    force = solution.derivation.answers[0]
    parts = [part.value.float for part in force.components if part.value is not None]
    assert parts == pytest.approx([share - 18, 0, 98], rel=1e-9)
    with pytest.raises(Unsolvable) as caught:
        solve(DOOR.replace("FIND", "F: pin.bearing1.force at later"))
    assert "`pin.bearing1.force.x` hangs on how `door` stands at `later`, which nothing tells" in str(caught.value)


def test_a_gyroscope_in_gimbals() -> None:
    """4 A + C cos² θ and C ω₃ sin θ make L about the vertical, ω₃ = s + W sin θ stays."""
    solution = solve(GIMBALS).complete()
    a, c, spin, start, angle = 0.05, 0.02, 100, 2, math.radians(10)
    sine, cosine = math.sin(angle), math.cos(angle)
    rate = (start * (2 * a + c / 2) - c * spin * sine) / (2 * a + c * cosine**2 / 2)
    energy = (2 * a + c / 2) * start**2 / 2 + (a + c / 2) / 2 - (2 * a + c * cosine**2 / 2) * rate**2 / 2
    nods = math.sqrt(2 * energy / (a + c / 2))
    assert values(solution) == pytest.approx([rate, nods, spin - rate * sine], rel=1e-9)
    assert verdicts(solution) == {True}
