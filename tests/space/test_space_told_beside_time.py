"""What a state in space tells beside its time follows from the motion: it is held against that, settles what is unknown, or is refused."""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve
from rotsolve.solution import Solution

TOP = """title: t
up: z
given: {M: 0.15 kg, l: 4 cm, I1: 5e-4 kg m^2, I3: 6e-5 kg m^2, w: 300 rad/s, theta: 25 deg}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states: {now: {top.tilt: theta, top.axial_rate: w, top.precession: smallest, steady: true}, later: {time: 1 s, LINE}}
find: {W: top.precession at AT}
"""
LETTERS = "{M: kg, l: m, I1: kg m^2, I3: kg m^2, w: rad/s, theta: rad, g: m/s^2, b: rad}"
STONE = """title: t
up: z
given: {T: TIME}
bodies: {s: {mass: 1 kg}}
states: {start: {s.position: [0, 0, 0], s.velocity: [1 m/s, 0, 5 m/s]}, later: {time: T, LINE}}
find: {K: s.kinetic_energy at start, T: T}
"""
DOOR = """title: t
up: z
given: {m: 20 kg, b: 1 m, tau: 8 N m}
bodies: {door: {shape: rod, mass: m, length: b}}
connections: {post: {hinge: door.start, along: zDRIVE}}
actions: {push: {couple: [0, 0, tau], on: door}}
states: {start: {door.angle: 0 degRATE}, later: {time: 1 s, LINE}}
find: {F: post.force at later}
"""
SPIN = ", door.angular_velocity: 1 rad/s"
CONTRADICT = "the data contradict each other"
FOLLOWS = "how `top` stands and turns at `later` follows from the time that has passed"


def confirmed(solution: Solution) -> dict[str, float]:
    """The numbers of the answers that the assembly gives too."""
    holds = {item.name for item in solution.derivation.confirmed if item.holds}
    return {item.name: item.value.float for item in solution.derivation.answers if item.name in holds and item.value}


@pytest.mark.sampled(4)
@pytest.mark.parametrize("at", ["now", "later"])
@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("top.tilt: 30 deg", FOLLOWS),
        ("top.tilt: 30 deg, steady: true", FOLLOWS),
        ("top.nutation: 5 rad/s", FOLLOWS),
        ("at rest: top", FOLLOWS),
        ("top.axial_rate: 200 rad/s", CONTRADICT),
        ("top.spin: 99 rad/s", CONTRADICT),
        ("top.precession: 99 rad/s", CONTRADICT),
        ("top.precession_angle: 10 deg", CONTRADICT),
        ("top.spin_angle: 10 deg", CONTRADICT),
        ("top.kinetic_energy: 99 J", CONTRADICT),
        ("floor.force.z: 9 N", CONTRADICT),
    ],
)
def test_no_line_of_a_later_state_of_a_steady_top_is_dropped(line: str, said: str, at: str) -> None:
    with pytest.raises(Unsolvable, match=said):
        solve(TOP.replace("LINE", line).replace("AT", at))


def test_another_tilt_later_is_refused_in_letters_too() -> None:
    text = TOP.replace("LINE", "top.tilt: b").replace("AT", "later")
    start, end = text.index("{M:"), text.index("}\nbodies") + 1
    with pytest.raises(Unsolvable, match=FOLLOWS):
        solve(text[:start] + LETTERS + text[end:])


@pytest.mark.parametrize("line", ["top.tilt: 25 deg", "top.axial_rate: 300 rad/s"])
def test_a_line_that_says_the_same_once_more_does_no_harm(line: str) -> None:
    found = confirmed(solve(TOP.replace("LINE", line).replace("AT", "later")))
    half, weight = 6e-5 * 300 / 2, 0.15 * 9.8 * 0.04  # M g l = W (I₃ w − I₁ W cos θ)
    along = 5e-4 * math.cos(math.radians(25))
    assert found == {"W": pytest.approx((half - math.sqrt(half**2 - along * weight)) / along, rel=1e-9)}


@pytest.mark.parametrize(
    "line", ["s.velocity: [2 m/s, 0, 0]", "s.position: [3 m, 0, 0]", "s.momentum.x: 3 kg m/s", "s.speed: 9 m/s"]
)
def test_what_is_told_of_a_flight_is_held_against_it(line: str) -> None:
    with pytest.raises(Unsolvable, match=CONTRADICT):
        solve(STONE.replace("LINE", line).replace("TIME", "1 s").replace(", T: T}", "}"))


@pytest.mark.parametrize(
    ("line", "time"),
    [
        ("s.velocity: [1 m/s, 0, 0]", 5 / 9.8),
        ("s.velocity: [1 m/s, 0, -2 m/s]", 7 / 9.8),
        ("s.position: [0.5 m, 0, 1.275 m]", 0.5),
    ],
)
def test_what_is_told_of_a_flight_tells_its_time(line: str, time: float) -> None:
    found = confirmed(
        solve(STONE.replace("LINE", line).replace("TIME", "unknown").replace("K: s.kinetic_energy at start, ", ""))
    )
    assert found == {"T": pytest.approx(time, rel=1e-9)}


def test_a_flight_that_comes_by_twice_does_not_tell_its_time() -> None:
    text = STONE.replace("LINE", "s.position: [0, 0, 1 m]").replace("TIME", "unknown").replace("1 m/s, 0, 5", "0, 0, 5")
    assert "T" not in confirmed(solve(text.replace("K: s.kinetic_energy at start, ", "")))


@pytest.mark.parametrize(("drive", "rate"), [("", SPIN), (", angular_velocity: 2 rad/s", "")])
@pytest.mark.parametrize("line", ["door.angle: 50 deg", "door.angular_velocity: 5 rad/s", "at rest: door"])
def test_what_is_told_of_a_hinge_is_no_gap_but_contradicts(line: str, drive: str, rate: str) -> None:
    text = DOOR.replace("DRIVE", drive).replace("RATE", rate).replace("LINE", line)
    with pytest.raises(Unsolvable) as caught:
        solve(text)
    assert "is not solved by these laws" not in str(caught.value)
