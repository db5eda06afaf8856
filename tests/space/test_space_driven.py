"""Hinges in space that are driven: by an angular acceleration that stays, from a rate at the first state, or by a formula of time.

Values by hand: ω = ω₀ + α t, φ = φ₀ + ω₀ t + ½ α t², ω² = ω₀² + 2 α Δφ, and their integrals.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import SceneError, Unsolvable, solve

PAIR = "angular_velocity: 2 rad/s, angular_acceleration: ALPHA rad/s^2"
START = "table.angle: 0.3 rad"
THERE = "th: table.angle at b, w: table.angular_velocity at b, e: table.x_axis at b, F: axis.force at b"
LEVEL = (  # a joint on the ground, and what carries it
    "bodies: {table: {shape: rectangle, mass: 2 kg, sides: [60 cm, 40 cm]}}\n"
    "connections: {axis: {hinge: table.corner1, along: [3/5, 4/5, 0], DRIVE}}\n"
)
CASES = {  # the drive, the first state, the others, and at b the angle and the rate, whether the motion up to there is confirmed
    "with a rate besides, for a time": (PAIR.replace("ALPHA", "1"), START, "b: {time: 0.5 s}", 1.425, 2.5, True),
    "slower, for so long that it turns back": (PAIR.replace("ALPHA", "-1"), START, "b: {time: 5 s}", -2.2, -3, True),
    "with a rate besides, to an angle": (
        PAIR.replace("ALPHA", "1"),
        START,
        "b: {table.angle: 0.6 rad}",
        0.6,
        math.sqrt(4.6),
        True,
    ),
    "slower, to an angle that it comes to on its way back": (
        PAIR.replace("ALPHA", "-1"),
        START,
        "b: {table.angle: 0 rad}",
        0,
        -math.sqrt(4.6),
        True,
    ),
    "by an acceleration alone, to an angle": (
        "angular_acceleration: 1 rad/s^2",
        f"{START}, table.angular_velocity: 2 rad/s",
        "b: {table.angle: 0.6 rad}",
        0.6,
        math.sqrt(4.6),
        True,
    ),
    "by a rate that goes by the time": (
        "angular_velocity: 2 rad/s*cos(n*time)",
        START,
        "b: {time: 0.5 s}",
        0.3 + 2 / 3 * math.sin(1.5),
        2 * math.cos(1.5),
        False,
    ),
    "by an acceleration that goes by the time": (
        "angular_acceleration: 2 rad/s^2*cos(n*time)",
        f"{START}, table.angular_velocity: 1 rad/s",
        "b: {time: 0.5 s}",
        0.8 + 2 / 9 * (1 - math.cos(1.5)),
        1 + 2 / 3 * math.sin(1.5),
        False,
    ),
    "by an acceleration that goes by the time, from a clock that shows another time": (
        "angular_acceleration: 2 rad/s^3*time",
        f"{START}, table.angular_velocity: 1 rad/s, time: 1 s",
        "m: {time: 0.25 s}, b: {time: 0.5 s}",
        0.3 + (1.75**3 - 1) / 3,
        1.75**2,
        False,
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_where_a_drive_has_turned_its_body_to_is_told(name: str) -> None:
    drive, first, others, angle, rate, followed = CASES[name]
    scene = f"up: z\ngiven: {{n: 3 rad/s}}\n{LEVEL.replace('DRIVE', drive)}states: {{a: {{{first}}}, {others}}}\n"
    derivation = solve(f"{scene}find: {{{THERE}}}\n").complete().derivation
    turned, speed, own, _ = derivation.answers
    assert turned.value is not None
    assert turned.value.float == pytest.approx(angle, rel=1e-12, abs=1e-12)
    parts = [part.value.float for part in speed.components if part.value is not None]
    assert parts == pytest.approx([0.6 * rate, 0.8 * rate, 0], rel=1e-12, abs=1e-12)
    axis = [part.value.float for part in own.components if part.value is not None]
    cos, sin = math.cos(angle), math.sin(angle)
    assert axis == pytest.approx([0.36 + 0.64 * cos, 0.48 * (1 - cos), -0.8 * sin], rel=1e-12, abs=1e-12)
    assert all(item.holds is not False for item in derivation.confirmed)
    if followed:
        assert all(item.holds is True for item in derivation.confirmed), [item.why for item in derivation.confirmed]


@pytest.mark.parametrize("drive", ["angular_velocity: 2 rad/s", PAIR.replace("ALPHA", "-1")])
def test_the_angle_at_any_time_is_confirmed(drive: str) -> None:
    scene = f"up: z\n{LEVEL.replace('DRIVE', drive)}states: {{a: {{{START}}}, b: {{time: 9 s}}}}\n"
    derivation = (
        solve(f"{scene}find: {{th: table.angle at any time, w: table.angular_velocity.x at any time}}\n")
        .complete()
        .derivation
    )
    assert [item.holds for item in derivation.confirmed] == [True, True]


def test_a_rotor_that_an_axle_carries_is_driven_faster() -> None:
    """s² = 4 + 2 · 0.6 of the rotor against the arm, about which the arm's own rate stands square."""
    scene = """up: z
bodies: {arm: {shape: rod, mass: 1 kg, length: 1 m}, disc: {shape: disc, mass: 1 kg, radius: 0.1 m}}
connections:
  hub: {hinge: arm.start, along: z, angular_velocity: 3 rad/s}
  axle: {axle: [arm.end, disc], along: x, angular_velocity: 2 rad/s, angular_acceleration: 1 rad/s^2}
states: {a: {disc.angle: 0 rad, arm.angle: 0 rad}, b: {disc.angle: 0.6 rad, arm.angle: 90 deg}}
find: {s: disc.spin at b, w: disc.angular_velocity at b}
"""
    spin, whole = solve(scene).complete().derivation.answers
    assert spin.value is not None
    assert spin.value.float == pytest.approx(math.sqrt(5.2))
    assert [part.value.float for part in whole.components if part.value] == pytest.approx([0, math.sqrt(5.2), 3])


def test_an_angle_to_which_a_drive_never_comes_is_refused() -> None:
    scene = f"up: z\n{LEVEL.replace('DRIVE', PAIR.replace('ALPHA', '-1'))}states: {{a: {{{START}}}, b: {{table.angle: 3 rad}}}}\n"
    with pytest.raises(Unsolvable, match="never reached"):
        solve(f"{scene}find: {{w: table.angular_velocity at b}}\n").complete()


def test_a_rate_and_an_acceleration_with_an_event_between_are_refused() -> None:
    scene = (
        f"up: z\n{LEVEL.replace('DRIVE', PAIR.replace('ALPHA', '1'))}states: {{a: {{}}, b: {{}}, c: {{time: 1 s}}}}\n"
    )
    hit = "events: {hit: {impulse: 1 N s, on: table.center, direction: z, from: a, to: b}}\n"
    with pytest.raises(SceneError, match="at which state it has that rate nothing tells"):
        solve(f"{scene}{hit}find: {{w: table.angular_velocity at c}}\n")


LIFT = (
    "given: {A: 3 m/s^3, L: 60 cm, g: 9.8 m/s^2}\n"
    "bodies: {cart: {mass: 0, position: [A*time^3 + A*(2 s)*time^2, 0 m, 0 m]}, rod: {shape: rod, mass: 1 kg, length: L}}\n"
    "connections: {pin: {hinge: [cart, rod.start], along: y}}\n"
)


@pytest.mark.parametrize(
    ("states", "clock"),
    {
        "": 0,
        "states: {a: {STANDS}}": 0,
        "states: {a: {STANDS}, b: {rod.angle: 100 deg}}": 0,
        "states: {a: {STANDS, time: 1 s}}": 1,
        "states: {a: {STANDS, time: 1 s}, b: {rod.angle: 100 deg}}": 1,
    }.items(),
)
def test_the_clock_shows_nothing_at_the_first_state_unless_it_tells_its_time(states: str, clock: int) -> None:
    """α = 3 (g cos θ + a sin θ)/(2 L) with a = A (6 t + 4 s)."""
    stands = "rod.angle: 60 deg, rod.angular_velocity: 0 rad/s"
    scene = f"up: z\n{LIFT}{states.replace('STANDS', stands)}\nfind: {{al: rod.angular_acceleration.y{' at a' * bool(states)}}}\n"
    derivation = solve(scene).complete().derivation
    angle = math.radians(60 if states else 0)
    pushed = 3 * (6 * clock + 4)
    assert derivation.answers[0].value is not None
    assert derivation.answers[0].value.float == pytest.approx(
        3 * (9.8 * math.cos(angle) + pushed * math.sin(angle)) / 1.2
    )
    assert derivation.confirmed[0].holds is True


ROTOR = """up: z
gravity: none
given: {m: 15 kg, r: 5 cm, w: 330 rad/s, c: 3 rad/s^2, phi: 60 deg, T: 1 s, t1: 0.37 s}
bodies:
  frame: {mass: 0, points: {O: [0, 0, 0], C: [0.1 m, 0.2 m, 0.05 m]}}
  disc: {shape: disc, mass: m, radius: r, points: {P: [r, 0, 0]}}
connections: {hang: {hinge: frame.O, along: x, FRAME}, axle: {axle: [frame.C, disc], along: y, DISC}}
states: {now: {time: 0 s, disc.angle: 40 deg}, end: {time: t1}}
find: {v: disc.P.velocity at end}
"""
SWUNG = "angle: phi*sin(2*pi*time/T)"
WAYS = {  # how far the frame and the disc have turned, and how fast they turn
    (SWUNG, "angular_velocity: w"): lambda t: (
        math.pi / 3 * math.sin(2 * math.pi * t),
        2 * math.pi**2 / 3 * math.cos(2 * math.pi * t),
        330 * t,
        330,
    ),
    ("angular_velocity: c*time", "angular_velocity: w"): lambda t: (1.5 * t * t, 3 * t, 330 * t, 330),
    ("angular_velocity: c*time", "angular_velocity: c*time^2/T"): lambda t: (1.5 * t * t, 3 * t, t**3, 3 * t * t),
    ("angular_velocity: 2*c*T", "angular_velocity: w"): lambda t: (6 * t, 6, 330 * t, 330),
}


@pytest.mark.parametrize(("frame", "disc"), WAYS)
def test_points_of_what_is_led_round_in_time_are_confirmed(frame: str, disc: str) -> None:
    """v = A′ x̂ × (c + d) + B′ ŷ × d in the axes of the frame, d = r (cos B, 0, −sin B), turned by A about x."""
    solution = solve(ROTOR.replace("FRAME", frame).replace("DISC", disc)).complete()
    tilt, rate, turned, spin = WAYS[frame, disc](0.37)
    angle = turned + math.radians(40)
    x, z = 0.05 * math.cos(angle), -0.05 * math.sin(angle)
    y, up = -rate * (0.05 + z), rate * 0.2 - spin * x
    expected = [
        spin * z,
        y * math.cos(tilt) - up * math.sin(tilt),
        y * math.sin(tilt) + up * math.cos(tilt),
    ]
    (answer,) = solution.derivation.answers
    assert [part.value.float for part in answer.components if part.value] == pytest.approx(expected, rel=1e-9)
    assert [item.holds for item in solution.derivation.confirmed] == [True]


def test_what_is_too_far_to_be_followed_says_so() -> None:
    """What stays on the way tells the rate after 41 turns, and not where the fork stands."""
    scene = """up: z
gravity: none
bodies: {fork: {shape: cuboid, mass: 2 kg, sides: [0.4 m, 0.1 m, 0.2 m]}, disc: {shape: disc, mass: 1.5 kg, radius: 0.15 m}}
connections: {post: {hinge: fork.center, along: z}, ax: {axle: [fork.center, disc], along: x}}
actions: {push: {couple: [0, 0, 4 N m], on: fork}}
states: {start: {fork.angular_velocity: 1 rad/s, fork.angle: 0 rad, disc.spin: 300 rad/s}, end: {time: 3 s}}
find: {th: fork.angle at end}
"""
    (told,) = solve(scene).complete().derivation.confirmed
    assert told.holds is None
    assert "too long to be followed" in told.why
