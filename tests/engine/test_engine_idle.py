"""Every word takes part: what nothing reads is refused at its place; points, components and clauses are honoured or refused by name."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.language.noted import Noted, noting, read_all, unread
from rotsolve.pipeline import solve

ROD = """title: A rod on a pin
given: {{M: 2 kg, L: 1 m, w: 2 rad/s, P: 3 N}}
bodies: {{rod: {{shape: rod, mass: M, length: L{body}}}}}
connections: {{pin: {{hinge: rod.at(L/4)}}}}
actions: {{pull: {{force: P, on: rod.end, direction: up}}}}
states: {{now: {{rod.angle: 30 deg, rod.angular_velocity: w{line}}}}}
find: {{x: {find}}}
"""
CRATE = """title: A crate and a wheel
given: {M: 2 kg, R: 10 cm}
surfaces: {floor: level, side: {wall: right}}
bodies: {wheel: {shape: disc, mass: M, radius: R}, load: {mass: 3 kg, moves: down}}
connections: {axle: {axle: wheel}, cord: {string: [wheel, load]%s}}
find: {a: load.acceleration}
"""


def rod(find: str, body: str = "", line: str = "") -> float:
    value = solve(ROD.format(find=find, body=body, line=line)).answers["x"].float
    assert value is not None
    return value


class Declared(Noted, frozen=True):
    name: str
    size: int = 0
    places: tuple[str, ...] = ()


def test_records_note_what_is_read() -> None:
    twin = noting(Declared("a", 3, ("b",)))
    assert unread(twin) == ("size", "places")
    assert twin.size == 3 and unread(twin) == ("places",)
    assert read_all(twin) == Declared("a", 3, ("b",)) and not unread(twin)
    assert unread(noting(Declared("a"))) == (), "what is as by default was not said"
    with pytest.raises(AttributeError, match="colour"):
        _ = twin.colour


@pytest.mark.parametrize("word", ["left", "up"])
def test_a_key_that_nothing_reads_is_refused_at_its_place(word: str) -> None:
    with pytest.raises(SceneError, match=rf"`moves: {word}` of `rod` says nothing here") as caught:
        rod("rod.angular_acceleration", body=f", moves: {word}")
    (fault,) = caught.value.faults
    assert fault.span is not None and fault.span.line == 3 and fault.help


def test_a_surface_that_nothing_touches_is_harmless() -> None:
    assert solve(CRATE % "").answers["a"].value == "7.35"


def test_the_way_that_a_string_pulls_holds_at_either_end() -> None:
    assert solve(CRATE % ", pulls: {load: up}").answers["a"].value == "7.35"
    assert solve(CRATE % ", pulls: {wheel: down}").answers["a"].value == "7.35"
    with pytest.raises(Unsolvable, match=r"pulls: \{other: up\}"):
        solve(CRATE.replace("load: {", "other: {mass: 1 kg}, load: {") % ", pulls: {other: up}")


COSINE, SINE, MOMENT = math.cos(math.pi / 6), math.sin(math.pi / 6), 2 / 12 + 2 / 16
SPEEDING = (3 * 0.75 * COSINE - 2 * 9.8 * 0.25 * COSINE) / MOMENT  # about the pin


@pytest.mark.parametrize(
    ("find", "true"),
    [
        ("pull.torque", 3 * 0.75 * COSINE),
        ("pull.torque about pin", 3 * 0.75 * COSINE),
        ("pull.torque about rod.start", 3 * COSINE),
        ("pull.torque about rod.end", 0.0),
        ("rod.torque about pin", MOMENT * SPEEDING),
        ("rod.torque.gravity about rod.start", -2 * 9.8 * 0.5 * COSINE),
        ("rod.angular_momentum", MOMENT * 2),
        ("rod.angular_momentum about pin", MOMENT * 2),
        ("rod.angular_momentum about rod.end", 2 / 12 * 2 - 2 * 0.5 * 0.5),  # I ω − m (L/2) v, v = ω L/4
        ("rod.angular_momentum about rod.start", 2 / 12 * 2 + 2 * 0.5 * 0.5),
        ("rod.angular_velocity.z", 2.0),
        ("rod.end.velocity.y", 2 * 0.75 * COSINE),
    ],
)
def test_points_and_components_are_honoured(find: str, true: float) -> None:
    assert rod(find) == pytest.approx(true, abs=1e-12)


def test_the_turn_about_z_is_counterclockwise_whatever_a_body_declares() -> None:
    assert rod("rod.angular_velocity", body=", turns: clockwise") == 2.0
    assert rod("rod.angular_velocity.z", body=", turns: clockwise") == -2.0


@pytest.mark.parametrize(
    ("find", "named"),
    [
        ("rod.angular_velocity.x", "rod.angular_velocity.x"),
        ("rod.angular_acceleration.y", "rod.angular_acceleration.y"),
        ("rod.end.velocity.z", "rod.end.velocity.z"),
        ("rod.momentum.x about pin", "`about pin` says nothing of `momentum`"),
        ("rod.kinetic_energy along 30 deg", "`along 30 deg` says nothing of `kinetic_energy`"),
        ("pull.force.gravity", "pull.force.gravity"),
    ],
)
def test_what_says_nothing_of_a_question_is_refused(find: str, named: str) -> None:
    with pytest.raises((SceneError, Unsolvable)) as caught:
        rod(find)
    assert named in str(caught.value)


def test_a_component_out_of_the_plane_is_refused_in_a_state_too() -> None:
    with pytest.raises(Unsolvable, match=r"rod\.angular_velocity\.x"):
        solve(
            ROD.format(find="rod.kinetic_energy", body="", line="").replace(
                "rod.angular_velocity: w", "rod.angular_velocity.x: w"
            )
        )


def test_the_momentum_of_turns_about_several_axes_is_no_sum() -> None:
    two = "bodies: {a: {shape: rod, mass: 1 kg, length: 1 m}, b: {shape: rod, mass: 1 kg, length: 1 m}}\n"
    pins = "connections: {p: {hinge: a.start}, q: {hinge: b.start}}\n"
    said = "states: {now: {a.angle: 0, b.angle: 0, a.angular_velocity: 1 rad/s, b.angular_velocity: 1 rad/s}}\n"
    with pytest.raises(Unsolvable, match="no common axis"):
        solve(two + pins + said + "find: {L: angular_momentum}\n")
