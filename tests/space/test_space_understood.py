"""Every clause of a question, and every key of an element, has a meaning in space or is refused by its name: none is left out silently."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve

SCENE = """
up: z
given: {M: 2 kg, L: 1 m, W: 3 rad/s}
bodies: {arm: {shape: rod, mass: M, length: L, points: {P: [0.2 m, 0, 0]}}, bead: {mass: 0.5 kg}}
connections: {pin: {hinge: arm.start, along: z, angular_velocity: W}}
actions: {hold: {force: any, on: bead}}
states:
  now:
    bead.position relative to arm: [0.3 m, 0, 0]
    bead.velocity relative to arm: [1 m/s, 0, 0]
    bead.acceleration relative to arm: [0, 0, 0]
"""
QUESTIONS = (  # each with a clause that means nothing for it
    *(f"arm.end.{word}.{part}" for word in ("velocity", "acceleration") for part in ("normal", "tangential")),
    "arm.end.velocity.radial",
    "pin.force.normal",
    *(f"bead.{word} relative to arm" for word in ("kinetic_energy", "momentum", "angular_velocity")),
    "bead.kinetic_energy about arm.start",
    "hold.power relative to arm",
    "arm.inertia along [0, 0, 1] in space axes",
    "arm.gyration along z in space axes",
    "arm.inertia_tensor in bead axes",
    "arm.kinetic_energy in body axes",
    "arm.end.velocity along [0, 1, 0]",
    "arm.momentum about arm.start",
    *(f"{word} arm.kinetic_energy at now" for word in ("lost", "change of", "mean", "total", "largest", "smallest")),
    "largest 2*arm.kinetic_energy at now",
    "largest arm.end.velocity.x at any time",
    "lost arm.angular_momentum.z at now",
)
KEYS = {  # keys of elements that mean nothing there
    "friction_torque": "bodies: {arm: {shape: rod, mass: 1 kg, length: 1 m}}\n"
    "connections: {pin: {hinge: arm.start, along: z, friction_torque: 2 N m}}\n",
    "from": "bodies: {arm: {shape: rod, mass: 1 kg, length: 1 m}}\nconnections: {pin: {hinge: arm.start, along: z}}\n"
    "actions: {push: {couple: [0, 0, 1 N m], on: arm, from: a}}\n",
    "over": "bodies: {arm: {shape: disc, mass: 1 kg, radius: 1 m}}\nactions: {pull: {force: [0, 0, 1 N], on: arm.center, over: true}}\n",
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_a_clause_without_a_meaning_is_refused(question: str) -> None:
    with pytest.raises((Unsolvable, SceneError)):
        solve(f"{SCENE}find: {{x: '{question}'}}\n", confirm=False)


@pytest.mark.parametrize("word", KEYS)
def test_a_key_of_the_plane_is_refused(word: str) -> None:
    scene = f"up: z\n{KEYS[word]}states: {{a: {{at rest: all}}}}\nfind: {{x: arm.kinetic_energy at a}}\n"
    with pytest.raises(SceneError) as caught:
        solve(scene)
    assert f"`{word}` is for scenes in the plane" in str(caught.value)


CAUGHT = """{up}gravity: none
given: {{{given}}}
bodies: {{rod: {{shape: rod, mass: 2 kg, length: 1 m}}}}
states: {{before: {{rod.velocity: {velocity}, rod.angular_velocity: {turning}}}, after: {{{stopped}}}}}
events: {{catch: {{{event}, from: before, to: after}}}}
find: {{om: rod.angular_velocity{part} at after}}
"""


@pytest.mark.parametrize(
    ("given", "event", "stopped", "up"),
    [
        ("J: unknown, p: unknown, q: unknown", "direction: [p, 1, q]", "[0, 0, 0]", "0.5 m/s"),
        ("J: unknown", "direction: y", "0 m/s", "0"),
    ],
)
def test_what_the_help_writes_for_a_point_that_is_held_is_the_same(
    given: str, event: str, stopped: str, up: str
) -> None:
    """A rod that goes across with 3 m/s and turns at 2 rad/s, held at its start: I ω′ = I_cm ω + M v l/2, ω′ = (2/6 + 3)/(2/3) = 5."""
    flat = CAUGHT.format(
        up="",
        part="",
        given="J: N s",
        velocity="[1 m/s, 3 m/s]",
        turning="2 rad/s",
        stopped="",
        event="fixes: rod.start",
    ).replace("given: {J: N s}\n", "")
    plane = solve(flat).derivation.answers[0].value
    word = "rod.start.velocity.y" if stopped == "0 m/s" else "rod.start.velocity"
    spatial = CAUGHT.format(
        up="up: z\n",
        part=".z",
        given=given,
        velocity=f"[1 m/s, 3 m/s, {up}]",
        turning="[0, 0, 2 rad/s]",
        stopped=f"{word}: {stopped}",
        event=f"impulse: J, on: rod.start, {event}",
    )
    found = solve(spatial).complete().derivation.answers[0].value
    assert plane is not None and found is not None
    assert found.float == pytest.approx(plane.float) and found.float == pytest.approx(5)
    in_space = flat.replace("[1 m/s, 3 m/s]", "[1 m/s, 3 m/s, 0]").replace(": 2 rad/s", ": [0, 0, 2 rad/s]")
    held = (
        solve("up: z\n" + in_space.replace("rod.angular_velocity at", "rod.angular_velocity.z at"))
        .derivation.answers[0]
        .value
    )
    assert held is not None and held.float == pytest.approx(5)
    with pytest.raises(SceneError, match=r"an unknown impulse stops a point"):
        solve("up: z\n" + in_space.replace("fixes: rod.start", "grips: rod"))


def test_a_couple_against_the_motion_is_the_friction_of_a_hinge() -> None:
    """As in the plane: ω² = 9 − 2 · 6 · 0.5, α = −2/(1/3)."""
    scene = """{up}gravity: none
bodies: {{arm: {{shape: rod, mass: 1 kg, length: 1 m}}}}
connections: {{pin: {{hinge: arm.start{more}}}}}
{actions}states: {{a: {{arm.angular_velocity: 3 rad/s, arm.angle: 0 rad}}, b: {{arm.angle: 0.5 rad}}}}
find: {{w: arm.angular_velocity{z} at b}}
"""
    flat = solve(scene.format(up="", more=", friction_torque: 2 N m", actions="", z="")).derivation.answers[0].value
    rub = "actions: {rub: {couple: -2 N m, on: arm}}\n"
    spatial = solve(scene.format(up="up: z\n", more=", along: z", actions=rub, z=".z")).derivation.answers[0].value
    assert flat is not None and spatial is not None
    assert flat.float == pytest.approx(spatial.float) and spatial.float == pytest.approx(math.sqrt(3))
    with pytest.raises(SceneError, match="a couple against that does the same"):
        solve(scene.format(up="up: z\n", more=", along: z, friction_torque: 2 N m", actions="", z=".z"))


def test_a_body_that_is_led_round_is_not_solved_when_time_has_passed() -> None:
    scene = (
        "up: z\ngravity: none\nbodies: {ship: {mass: 0, angular_velocity: [0, 0, 0.2 rad/s]}}\n"
        "states: {start: {}, later: {time: 3 s}}\nfind: {x: ship.x_axis at later}\n"
    )
    with pytest.raises(Unsolvable) as caught:
        solve(scene)
    assert "which is led, stands at `later`" in str(caught.value)


def test_the_largest_value_over_a_letter_is_that_at_its_place() -> None:
    """As in the plane: M W² (⅔ R² − R x + x²/2) is least at x = R, and ⅙ M R² W² there."""
    scene = """
up: z
gravity: none
given: {M: 2 kg, R: 0.3 m, W: 20 rad/s, x: m}
bodies:
  bar:
    parts: {rod: {shape: rod, mass: M, start: [0, 0, 0], end: [R, 0, 0]}, lump: {mass: M, at: [x, 0, 0]}}
    points: {O: [R, 0, 0]}
connections: {pin: {hinge: bar.O, along: z}}
states: {now: {bar.angle: 0 deg, bar.angular_velocity: W}}
find: {K: bar.kinetic_energy at now, p: x where K is smallest, K_m: smallest K}
"""
    answers = {answer.name: answer.value for answer in solve(scene).derivation.answers}
    assert answers["p"].float == pytest.approx(0.3) and answers["K_m"].float == pytest.approx(12)


def test_a_speed_relative_to_a_body_is_the_size_of_the_velocity_there() -> None:
    answers = solve(f"{SCENE}find: {{x: bead.speed relative to arm at now}}\n").derivation.answers
    assert answers[0].value is not None and answers[0].value.float == pytest.approx(1)
