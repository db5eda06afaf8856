"""What a couple spins up in a time, with all that it carries: ω = ω₀ + M t/I, I by hand; where that does not stay, it is refused."""

from __future__ import annotations

import pytest

from rotsolve import Unsolvable, solve

SCENE = """up: z
gravity: GRAVITY
given: {m: 3 kg, r: 8 cm, d: 13 cm, M0: 0.3 N m, T: 2 s, J: 0.02 kg m^2}
bodies:
  fork: {mass: 1 kg, inertia: {principal: [J, J, J]}, points: {O: [0, 0, 0], A: [d, 0, 0], B: [-d, 0, 0]}}
  BODIES
connections:
  shaft: {hinge: fork.O, along: AXIS}
  CARRIED
actions: {ACTING}
states: {start: {RATES}, end: {time: T}}
find: {FIND}
"""
OURS = {
    "GRAVITY": "none",
    "BODIES": "disc: {shape: disc, mass: m, radius: r}",
    "AXIS": "z",
    "CARRIED": "pin: {clamp: [fork.A, disc]}",
    "ACTING": "turn: {couple: [0, 0, M0], on: fork}",
    "RATES": "fork.angular_velocity: 1 rad/s",
    "FIND": "w: size of fork.angular_velocity at end",
}
J, AXIAL, ACROSS, OFF = 0.02, 0.5 * 3 * 0.08**2, 0.25 * 3 * 0.08**2, 3 * 0.13**2
TWO = "disc: {shape: particle, mass: m}\n  two: {shape: particle, mass: m}"
BOTH = "pin: {clamp: [fork.A, disc]}\n  other: {clamp: [fork.B, two]}"
BAR = "disc: {shape: cuboid, mass: m, sides: [5 cm, 8 cm, 13 cm]}"
LEVEL = {"GRAVITY": "9.8 m/s^2", "AXIS": "y", "ACTING": "turn: {couple: [0, M0, 0], on: fork}"}


def scene(changes: dict[str, str]) -> str:
    text = SCENE
    for word, written in (OURS | changes).items():
        text = text.replace(word, written)
    return text


def on_axle(along: str, more: str = "") -> dict[str, str]:
    return {"CARRIED": f"pin: {{axle: [fork.A, disc], along: {along}{more}}}"}


DRIVEN, FREE = ", angular_velocity: 60 rad/s", "fork.angular_velocity: 1 rad/s, disc.angular_velocity: 20 rad/s"


@pytest.mark.parametrize(
    ("changes", "gained"),
    [
        ({}, 0.6 / (J + AXIAL + OFF)),
        ({"ACTING": "turn: {couple: [0, 0, M0], on: disc}"}, 0.6 / (J + AXIAL + OFF)),
        ({"ACTING": ""}, 0.0),
        (
            {"AXIS": "[0, 3, 4]", "ACTING": "turn: {couple: [0, M0, M0], on: fork}"},
            0.84 / (J + 0.36 * ACROSS + 0.64 * AXIAL + OFF),
        ),
        (on_axle("y", DRIVEN), 0.6 / (J + ACROSS + OFF)),
        (on_axle("z", DRIVEN), 0.6 / (J + AXIAL + OFF)),
        (on_axle("[3, 0, 4]", DRIVEN), 0.6 / (J + 0.36 * ACROSS + 0.64 * AXIAL + OFF)),
        (on_axle("z") | {"RATES": FREE}, 0.6 / (J + OFF)),
        (on_axle("[3, 0, 4]") | {"RATES": FREE}, 0.6 / (J + 0.36 * ACROSS + OFF)),
        (LEVEL | {"BODIES": TWO, "CARRIED": BOTH}, 0.6 / (J + 2 * OFF)),
    ],
)
def test_it_spins_up_evenly(changes: dict[str, str], gained: float) -> None:
    solution = solve(scene(changes))
    assert solution.answers["w"].float == pytest.approx(1 + gained, rel=1e-9)
    assert all(item.holds for item in solution.derivation.confirmed)


def test_a_wheel_that_is_driven_faster_turns_it_back() -> None:
    changes = on_axle("z", ", angular_acceleration: 5 rad/s^2") | {
        "ACTING": "",
        "RATES": FREE,
        "FIND": "w: fork.angular_velocity.z at end",
    }
    assert solve(scene(changes)).answers["w"].float == pytest.approx(1 - 10 * AXIAL / (J + AXIAL + OFF), rel=1e-9)


def test_how_far_it_has_turned_is_told_too() -> None:
    gained = 0.6 / (J + AXIAL + OFF)
    solution = solve(scene({"FIND": "p: fork.angle at end, v: disc.cm.speed at end"}))
    assert solution.answers["p"].float == pytest.approx(2 + gained, rel=1e-9)
    assert solution.answers["v"].float == pytest.approx(0.13 * (1 + gained), rel=1e-9)
    assert all(item.holds for item in solution.derivation.confirmed)


PENDULUM = {
    "T: 2 s": "T: 60 s",  # too long to be followed
    "GRAVITY": "9.8 m/s^2",
    "BODIES": "disc: {shape: rod, mass: m, length: r}",
    "CARRIED": "pin: {hinge: [fork.A, disc.start], along: y}",
    "RATES": "fork.angular_velocity: 0 rad/s, disc.angle: 0 rad, disc.angular_velocity: 0 rad/s",
}
FORCED = {"ACTING": "turn: {couple: [0, 0, M0], on: fork}, push: {force: [0, 1 N, 0], on: disc}"}


@pytest.mark.parametrize(
    "changes",
    [
        pytest.param(LEVEL | {"T: 2 s": "T: 0.3 s"}, id="its weight turns it back"),
        pytest.param({"BODIES": BAR} | on_axle("y", DRIVEN), id="what spins is no wheel"),
        pytest.param(PENDULUM, id="a rod swings on it"),
        pytest.param(FORCED, id="a force keeps its direction"),
        pytest.param({"ACTING": "turn: {couple: [0, 0, M0*time/T], on: fork}"}, id="the couple grows"),
        pytest.param(
            on_axle("y") | {"RATES": FREE, "ACTING": "turn: {couple: [0, 0, M0], on: disc}"}, id="it acts on a wheel"
        ),
    ],
)
def test_what_varies_is_refused_and_the_scene_not_blamed(changes: dict[str, str]) -> None:
    with pytest.raises(Unsolvable, match="is not solved by these laws") as caught:
        solve(scene(changes))
    assert "nothing is missing in the scene" in (caught.value.fault.help or "")


def test_what_the_first_state_leaves_open_is_missing() -> None:
    told = PENDULUM | {"RATES": "fork.angular_velocity: 0 rad/s, disc.angle: 0 rad"}
    with pytest.raises(Unsolvable, match="too little is known"):
        solve(scene(told))
