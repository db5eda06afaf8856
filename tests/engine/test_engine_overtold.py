"""Of data that contradict each other it is said which line does not go with all else, what would, and what would drive a body as told;
each cure that is named works when it is applied."""

from __future__ import annotations

import re

import pytest

from rotsolve import Unsolvable, solve

WHEEL = """given: {I: 2 kg m^2, tau: 3 N m}
bodies: {w: {mass: 1 kg, inertia: I, turns: counterclockwise}}
connections: {post: {axle: w}}
actions: {push: {couple: tau, on: w}}
states: {start: {w.angular_velocity: 1 rad/s, w.angle: 0 deg}, end: {LINES}}
find: {W: w.angular_velocity at end}
"""
WHEEL_IN_SPACE = """up: z
given: {I: 2 kg m^2, tau: 3 N m}
bodies: {w: {mass: 1 kg, inertia: {principal: [I, I, I]}}}
connections: {post: {hinge: w.cm, along: z}}
actions: {push: {couple: [0, 0, tau], on: w}}
states: {start: {w.angular_velocity: 1 rad/s, w.angle: 0 deg}, end: {LINES}}
find: {W: w.angular_velocity at end}
"""
STONE = """up: z
bodies: {s: {mass: 2 kg}}
states: {start: {s.position: [0, 0, 0], s.velocity: [1 m/s, 0, 5 m/s]}, end: {LINES}}
find: {K: s.kinetic_energy at end}
"""
TIME_AND_ANGLE = "time: 2 s, w.angle: 6 rad"  # α = 3/2 rad/s²: 1·2 + ½·1.5·2² = 5
TIME_AND_RATE = "time: 2 s, w.angular_velocity: 3 rad/s"  # 1 + 1.5·2 = 4


@pytest.mark.parametrize(
    ("text", "lines", "would"),
    [
        (WHEEL, TIME_AND_ANGLE, "`w.angle` would be 5 rad at `end`, not 6 rad"),
        (WHEEL_IN_SPACE, TIME_AND_ANGLE, "`w.angle` would be 5 rad at `end`, not 6 rad"),
        (WHEEL, TIME_AND_RATE, "`w.angular_velocity` would be 4 rad/s at `end`, not 3 rad/s"),
        (WHEEL_IN_SPACE, TIME_AND_RATE, "`w.angular_velocity` would be 4 rad/s at `end`, not 3 rad/s"),
        (WHEEL, "w.angular_velocity: 2 rad/s, w.angle: 100 deg", "`w.angle` would be 57.30° at `end`, not 100 deg"),
        (STONE, "time: 1 s, s.position: [1 m, 0, 3 m]", "`s.position.z` would be 0.1 m at `end`, not 3 m"),
    ],
)
def test_what_would_follow_is_told_at_the_line_that_does_not(text: str, lines: str, would: str) -> None:
    with pytest.raises(Unsolvable) as refused:
        solve(text.replace("LINES", lines))
    fault = refused.value.fault
    assert fault.help == f"by all else that is told {would}"
    assert "`end`" in fault.message


def test_what_comes_after_a_contradiction_is_not_blamed_on_what_was_before() -> None:
    text = """bodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}}
connections: {pivot: {hinge: rod.start}, cord: {string: [ceiling, rod.end]}}
states: {held: {rod.angle: 0, balance: true}, free: {balance: true}}
events: {cut: {cuts: cord, from: held, to: free}}
find: {alpha: rod.angular_acceleration at free}
"""
    with pytest.raises(Unsolvable) as refused:
        solve(text)
    assert "would be" not in refused.value.fault.help


LIFT = """up: z
given: {M: 0.5 kg, l: 6 cm, I1: 2.5e-3 kg m^2, I3: 6e-4 kg m^2, s: 150 rad/s, acc: 4 m/s^2}
bodies:
  lift: {mass: 0, points: {O: [0, 0, 0]}}
  top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}
connections: {rail: {slide: lift.O, along: z}, stand: {ball: [lift.O, top.tip]}}
states: {now: {lift.acceleration: [0, 0, -acc], top.tilt: 50 deg, top.axial_rate: s, top.precession: smallest, steady: true}}
find: {p: top.precession at now}
"""
BARE_WHEEL = """bodies: {w: {mass: 1 kg, inertia: 2 kg m^2, turns: counterclockwise}}
connections: {post: {axle: w}}
states: {now: {w.angular_acceleration: 3 rad/s^2}}
find: {L: w.angular_acceleration}
"""
BARE_WHEEL_IN_SPACE = """up: z
bodies: {w: {shape: disc, mass: 1 kg, radius: 2 m}}
connections: {post: {hinge: w.center, along: z}}
states: {now: {w.angular_acceleration: 3 rad/s^2}}
find: {T: post.torque}
"""


def refused_help(text: str) -> str:
    with pytest.raises(Unsolvable, match="nothing drives") as refused:
        solve(text)
    return refused.value.fault.help


@pytest.mark.parametrize(
    ("text", "name", "value"),
    [(LIFT, "p", 2.00512), (BARE_WHEEL, "L", 3.0), (LIFT.replace("-acc", "-4 m/s^2"), "p", 2.00512)],
)
def test_a_force_or_couple_that_is_named_cures_it(text: str, name: str, value: float) -> None:
    """The lift: I₁ cos θ Ω² − I₃ s Ω + M (g − a) l = 0, with the smaller root by hand."""
    (actions,) = re.findall(r"`(actions: .*?)`", refused_help(text))
    assert solve(text.replace("states:", f"{actions}\nstates:")).answers[name].float == pytest.approx(value, rel=1e-3)


def test_leading_that_is_named_cures_it() -> None:
    help = refused_help(LIFT)
    (line,) = re.findall(
        r"write `(acceleration: .*?)` in the body `lift`, not in the state, and leave `rail` out", help
    )
    text = LIFT.replace("lift: {mass: 0,", f"lift: {{mass: 0, {line},").replace("lift.acceleration: [0, 0, -acc], ", "")
    led = solve(text.replace("rail: {slide: lift.O, along: z}, ", ""))
    assert led.answers["p"].float == pytest.approx(2.00512, rel=1e-3)


@pytest.mark.parametrize("text", [BARE_WHEEL, BARE_WHEEL_IN_SPACE])
def test_a_hinge_that_is_named_as_one_that_drives_cures_it(text: str) -> None:
    (line,) = re.findall(r"write `(angular_acceleration: .*?)` in `post`", refused_help(text))
    text = re.sub(r"post: {(.*?)}", rf"post: {{\1, {line}}}", text).replace("w.angular_acceleration: 3 rad/s^2", "")
    found = solve(re.sub(r"^states.*\n", "", text, flags=re.MULTILINE))
    assert [item.holds for item in found.derivation.confirmed] == [True]
