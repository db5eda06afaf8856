"""What happens on the way between two states that are asked about: what gives way, what lets go, what turns back."""

from __future__ import annotations

import math

import pytest

from rotsolve.confirm.course.asked import Asker
from rotsolve.confirm.course.following import Course
from rotsolve.confirm.course.node import Astray, Budget
from rotsolve.confirm.course.samples import sets_of_numbers
from rotsolve.motion.complete import configured
from rotsolve.scene.read import read_source

G = 9.8
CLOSE = 1e-8


def asked(text: str, instants: int = 3000) -> dict[str, float]:
    """What the assembly answers to the questions of a scene."""
    problem = configured(read_source("title: by hand\n" + text)).problem
    asker = Asker(problem, Course(problem, next(sets_of_numbers(problem)), Budget(instants)))
    return {find.name: asker.answer(find, {"": math.nan}).number for find in problem.finds}


@pytest.mark.parametrize("way", ["right", "left"])
def test_a_growing_pull_overcomes_friction_on_the_way(way: str) -> None:
    """Held up to t = μ m g/c, then v = c (T − t)²/(2 m) with μ the same at rest and in motion."""
    text = f"""
given: {{m: 2 kg, c: 3 N/s, mu: 0.4, T: 6 s}}
surfaces: {{floor: level}}
bodies: {{block: {{mass: m, moves: {way}}}}}
connections: {{base: {{contact: [block, floor], friction: mu}}}}
actions: {{pull: {{force: c*time, on: block, direction: {way}}}}}
states: {{start: at rest, end: {{time: T}}}}
find: {{v: block.velocity at end, s: block.displacement from start to end}}
"""
    late = 6 - 0.4 * 2 * G / 3
    assert asked(text) == {
        "v": pytest.approx(3 * late**2 / 4, rel=CLOSE),
        "s": pytest.approx(3 * late**3 / 12, rel=CLOSE),
    }


def test_a_fading_couple_stops_a_wheel_and_turns_it_back() -> None:
    """Forward from 0 to t = 2 (Q − τ)/c, held there until t = (Q + τ)/c, then back; here both are 6 s."""
    text = """
given: {I: 0.5 kg m^2, Q: 9 N m, c: 2 N m/s, tau: 3 N m}
bodies: {wheel: {inertia: I}}
connections: {axle: {axle: wheel, friction_torque: tau}}
actions: {motor: {couple: Q - c*time, on: wheel}}
states: {start: at rest, end: {time: 14 s}}
find: {w: wheel.angular_velocity at end, W: axle.work from start to end}
"""
    found = asked(text)
    assert found["w"] == pytest.approx((12 * 8 - (14**2 - 6**2)) / 0.5, rel=CLOSE)
    assert found["W"] == pytest.approx(-1240.0, rel=CLOSE)


def test_what_is_carried_along_slips_when_the_pull_has_grown() -> None:
    """Together up to c t = μ g (m + M), then the block with μ g alone."""
    text = """
given: {m: 2 kg, M: 6 kg, mu: 0.3, c: 10 N/s, T: 4 s}
surfaces: {ice: level}
bodies: {plank: {mass: M, moves: right}, block: {mass: m, moves: right}}
connections: {below: {contact: [plank, ice]}, grip: {contact: [block, plank], friction: mu}}
actions: {pull: {force: c*time, on: plank, direction: right}}
states: {start: at rest, end: {time: T}}
find: {v: block.velocity at end, V: plank.velocity at end}
"""
    slips = 0.3 * G * 8 / 10
    together = 10 * slips**2 / 16
    found = asked(text)
    assert found["v"] == pytest.approx(together + 0.3 * G * (4 - slips), rel=CLOSE)
    assert found["V"] == pytest.approx(together + (5 * (16 - slips**2) - 0.6 * G * (4 - slips)) / 6, rel=CLOSE)


def test_a_rolling_cylinder_begins_to_slip() -> None:
    """It rolls with v = c t²/(3 m) while a third of the pull is less than μ m g."""
    text = """
given: {m: 4 kg, R: 10 cm, c: 8 N/s, mu: 0.2, T: 5 s}
surfaces: {floor: level}
bodies: {roller: {shape: cylinder, mass: m, radius: R, moves: right}}
connections: {base: {contact: [roller, floor], friction: mu}}
actions: {pull: {force: c*time, on: roller.center, direction: right}}
states: {start: at rest, end: {time: T}}
find: {v: roller.velocity at end, w: roller.angular_velocity at end}
"""
    slips = 3 * 0.2 * 4 * G / 8
    rolling = 8 * slips**2 / 12
    found = asked(text)
    assert found["v"] == pytest.approx(rolling + (4 * (25 - slips**2) - 0.8 * G * (5 - slips)) / 4, rel=CLOSE)
    assert found["w"] == pytest.approx((rolling + 2 * 0.2 * G * (5 - slips)) / 0.1, rel=CLOSE)


def test_a_pulse_moves_what_is_held_before_and_after_it() -> None:
    """A sin(π t/T) overcomes 3 N from t₁ on; at both ends nothing pulls."""
    text = """
given: {I: 0.4 kg m^2, A: 9 N m, tau: 3 N m, T: 2 s}
bodies: {wheel: {inertia: I}}
connections: {axle: {axle: wheel, friction_torque: tau}}
actions: {motor: {couple: A*sin(pi*time/T), on: wheel}}
states: {start: at rest, end: {time: T}}
find: {w: wheel.angular_velocity at end}
"""
    first = 2 / math.pi * math.asin(1 / 3)
    gained = 9 * 2 / math.pi * (math.cos(math.pi * first / 2) + 1) - 3 * (2 - first)
    assert asked(text)["w"] == pytest.approx(gained / 0.4, rel=CLOSE)


def test_a_wheel_that_stands_is_started_again() -> None:
    """Slowed to rest by τ − c t, held up to t = τ/c, then turned by what c t has more."""
    text = """
given: {I: 2 kg m^2, c: 1 N m/s, tau: 10 N m, w0: 3 rad/s, T: 16 s}
bodies: {wheel: {inertia: I}}
connections: {axle: {axle: wheel, friction_torque: tau}}
actions: {motor: {couple: c*time, on: wheel}}
states: {start: {wheel.angular_velocity: w0}, end: {time: T}}
find: {w: wheel.angular_velocity at end}
"""
    assert asked(text)["w"] == pytest.approx(9.0, rel=CLOSE)


def test_friction_turns_round_at_each_swing_until_it_holds() -> None:
    """Each swing of a wheel on a wire is shorter by 2 τ/κ on both sides: 2.2, −5/3, 17/15, −3/5, 1/15 rad, where it stays."""
    text = """
given: {I: 0.2 kg m^2, k: 3 N m/rad, tau: 0.8 N m, th0: 2.2 rad}
bodies: {wheel: {inertia: I}}
connections: {axle: {axle: wheel, friction_torque: tau}, wire: {torsion: wheel, stiffness: k}}
states: {start: {wheel.angle: th0, at rest: all}, end: {time: 10 s}}
find: {th: wheel.angle at end, d: total wheel.rotation from start to end}
"""
    assert asked(text) == {"th": pytest.approx(1 / 15, rel=1e-7), "d": pytest.approx(136 / 15, rel=1e-7)}


HOOP = """
given: {M: %s kg, m: 2 kg, R: 50 cm, u: 1.5 m/s}
surfaces: {floor: level}
bodies: {hoop: {shape: ring, mass: M, radius: R, moves: %s, turns: %s}, lump: {mass: m}}
connections: {glue: {weld: [hoop.rim, lump]}, touch: {rolls: [hoop, floor]}}
states: {start: {hoop.angle: 90 deg, hoop.velocity: u}, low: {hoop.angle: %s deg}}
find: {v: hoop.velocity at low}
"""
LOOP = """
given: {R: 50 cm, m: 0.1 kg, u: %s m/s}
surfaces: {loop: {hollow: R}}
bodies: {ball: {mass: m, moves: right}}
connections: {touch: {contact: [ball, loop]}}
states: {low: {touch.angle: -90 deg, ball.velocity: u}, far: {touch.angle: 250 deg}}
find: {v: ball.velocity at far}
"""
CART = """
given: {M: 0.5 kg, m: 4 kg, L: 1 m, w0: 16 rad/s}
surfaces: {rails: level}
bodies: {cart: {mass: M, moves: right}, rod: {shape: rod, mass: m, length: L}}
connections: {base: {contact: [cart, rails], friction: none}, pin: {hinge: [cart.center, rod.start]}}
states: {start: {rod.angle: -90 deg, cart.velocity: 0, rod.angular_velocity: w0}, end: {rod.angle: 210 deg}}
find: {w: rod.angular_velocity at end}
"""
PULSE = """
given: {m: 2 kg, A: 30 N, T: 3 s, phi: 50 deg}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: none}}
actions: {pull: {force: A*sin(pi*time/T), on: block, direction: phi}}
states: {start: at rest, end: {time: T}}
find: {v: block.velocity at end}
"""
BOB = """
given: {m: 1 kg, L: 80 cm, u: 5 m/s}
bodies: {bob: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: bob.start}}
states: {low: {bob.angle: -90 deg, bob.angular_velocity: %s rad/s}, up: {bob.angle: 200 deg}}
find: {w: bob.angular_velocity at up}
"""


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (HOOP % (0.2, "right", "clockwise", -90), "`touch` lets go on the way from `start` to `low`"),
        (HOOP % (0.2, "left", "counterclockwise", 270), "`touch` lets go on the way from `start` to `low`"),
        (LOOP % 4.6, "`touch` lets go on the way from `low` to `far`"),
        (CART, "`base` lets go on the way from `start` to `end`"),
        (PULSE, "`base` lets go on the way from `start` to `end`"),
        (BOB % 5, "`up` is not reached: what moves turns back before it"),
    ],
    ids=["hoop", "hoop-mirrored", "loop", "cart", "pulse", "turns-back"],
)
def test_a_state_to_which_the_motion_does_not_come(text: str, words: str) -> None:
    with pytest.raises(Astray) as raised:
        asked(text)
    assert str(raised.value) == words


@pytest.mark.parametrize(
    ("text", "value"),
    [
        (HOOP % (4, "right", "clockwise", -90), math.sqrt(1.5**2 + 2 * 2 * (G * 0.5 + 1.5**2) / 4)),
        (LOOP % 6, math.sqrt(36 - 2 * G * 0.5 * (1 + math.sin(math.radians(250))))),
        (BOB % 9, math.sqrt(81 - 3 * G / 0.8 * (1 + math.sin(math.radians(200))))),
    ],
    ids=["hoop", "loop", "bob"],
)
def test_a_state_to_which_it_comes(text: str, value: float) -> None:
    """The same with what keeps contact, or is fast enough."""
    found = asked(text)
    assert next(iter(found.values())) == pytest.approx(value, rel=CLOSE)


BALLS = """
given: {m: 0.5 kg, R: 5 cm, u: 2 m/s, e: %s, mu: 0.3, T: 3 s}
surfaces: {cloth: level}
bodies:
  one: {shape: sphere, mass: m, radius: R, moves: %s, turns: %s}
  two: {shape: sphere, mass: m, radius: R, moves: %s, turns: %s}
connections: {g1: {contact: [one, cloth], friction: mu}, g2: {contact: [two, cloth], friction: mu}}
states: {before: {one.velocity: u, g1: rolls, at rest: two}, after: {}, late: {time: T}}
events: {hit: {collides: [%s], restitution: e, from: before, to: after}}
find: {s1: one.displacement from after to late, s2: two.displacement from after to late}
"""
PUCK = """
given: {m: 1 kg, M: 2 kg, k: 50 N/m, u: 3 m/s, e: 0.5, T: %s s}
surfaces: {ice: level}
bodies: {puck: {mass: m, moves: right}, block: {mass: M, moves: right}}
connections: {b1: {contact: [puck, ice]}, b2: {contact: [block, ice]}, coil: {spring: [ground, block], stiffness: k}}
states: {before: {puck.velocity: u, at rest: block, coil.elongation: 0}, after: {}, late: {time: T}}
events: {hit: {collides: [puck, block], restitution: e, from: before, to: after}}
find: {x: block.displacement from after to late}
"""
RIGHT, LEFT = ("right", "clockwise"), ("left", "counterclockwise")


@pytest.mark.parametrize(
    "text",
    [
        BALLS % (0.2, *RIGHT, *RIGHT, "one, two"),
        BALLS % (0.2, *LEFT, *LEFT, "two, one"),
        BALLS % (0.2, *RIGHT, *LEFT, "one, two"),
        PUCK % 0.9,
    ],
    ids=["balls", "mirrored", "positive-otherwise", "puck"],
)
def test_bodies_do_not_go_through_each_other(text: str) -> None:
    """A ball that rolls faster behind another, a block that comes back to the puck that struck it."""
    with pytest.raises(Astray, match="meet again on the way from `after` to `late`"):
        asked(text)


def test_bodies_that_stay_apart() -> None:
    """e > 2/5: the ball behind is the slower one when both roll; the block has not yet come back."""
    found = asked(BALLS % (0.5, *RIGHT, *RIGHT, "one, two"))
    assert found["s1"] < found["s2"]
    omega = math.sqrt(50 / 2)
    assert asked(PUCK % 0.5)["x"] == pytest.approx(1.5 / omega * math.sin(omega * 0.5), rel=CLOSE)


CRATE = """
given: {M: 100 kg, m: 20 kg, w: 40 cm, h: 1.2 m, A: %s m/s^2, mu: 0.6}
surfaces: {road: level}
bodies: {cart: {mass: M, moves: %s}, crate: {shape: rectangle, mass: m, sides: [w, h], moves: %s}}
connections: {below: {contact: [cart, road]}, grip: {contact: [crate, cart], friction: mu}}
actions: {pull: {force: 120 kg*A, on: cart, direction: %s}}
find: {a: crate.acceleration}
"""
CORNER = """
given: {m: 20 kg, w: 40 cm, h: 1.2 m, F: %s N}
surfaces: {road: level}
bodies: {crate: {shape: rectangle, mass: m, sides: [w, h], moves: right}}
connections: {grip: {contact: [crate, road], friction: 0.3}}
actions: {pull: {force: F, on: crate.corner3, direction: right}}
find: {a: crate.acceleration}
"""


@pytest.mark.parametrize(
    ("text", "stays"),
    [
        (CRATE % (3.2, "right", "right", "right"), True),  # a h/2 < g w/2
        (CRATE % (3.3, "right", "right", "right"), False),
        (CRATE % (3.3, "left", "left", "left"), False),
        (CORNER % 32, True),  # F h < m g w/2 = 39.2 N m
        (CORNER % 33, False),
    ],
)
def test_tall_crates_tip_over(text: str, stays: bool) -> None:
    if stays:
        assert asked(text)["a"] == pytest.approx(3.2 if "cart" in text else 0.0, abs=1e-9)
        return
    with pytest.raises(Astray, match="`crate` tips over"):
        asked(text)
