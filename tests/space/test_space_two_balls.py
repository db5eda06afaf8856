"""A body on two balls of the ground: what each pushes across the line through both is told, along it only the sum.

Every component by Newton's and Euler's equations in numbers, worked out apart from the laws of rotsolve, for lines along an axis of the
body (by the numbers alone), oblique in one of its planes, and oblique to all of its axes.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from rotsolve import Unsolvable, solve

Vector = np.ndarray
SIDES, MASS, RATE, TURN, BLOW, GRAVITY = (0.4, 0.2, 0.1), 2.0, 4.0, math.radians(30), 0.5, 9.8
STRUCK, WAY = np.array([0.1, -0.1, 0.05]), np.array([0, 2, -1]) / math.sqrt(5)
LINES = {  # the points held, how the body is drawn turned about z, and the components along space that are told
    "along x by the numbers": ((-0.2, 0.05, 0), (0.2, 0.05, 0), "0 rad", "yz"),
    "along −x by the numbers": ((0.2, 0.05, 0.01), (-0.2, 0.05, 0.01), "0 rad", "yz"),
    "along y": ((0.1, -0.1, 0), (0.1, 0.1, 0), "0 rad", "xz"),
    "along z": ((0.1, 0.02, -0.05), (0.1, 0.02, 0.05), "0 rad", "xy"),
    "oblique in the plane of x and y": ((-0.2, 0.05, 0), (0.2, -0.1, 0), "0 rad", "z"),
    "the same, turned so that it lies along x": ((-0.2, 0.05, 0), (0.2, -0.1, 0), "atan(15/40)", "yz"),
    "oblique in the plane of y and z": ((0.02, 0.05, 0.05), (0.02, -0.1, -0.02), "0 rad", "x"),
    "oblique in the plane of x and z": ((-0.2, 0.05, 0.05), (0.2, 0.05, -0.02), "0 rad", "y"),
}


def scene(line: str) -> str:
    first, last, drawn, told = LINES[line]
    held = ", ".join(
        f"{name}: [{', '.join(f'{part} m' for part in place)}]" for name, place in (("A", first), ("B", last))
    )
    asked = [
        f"{ball}{kind[0]}{axis}: {ball}.{kind}.{axis} {when}"
        for ball in "lr"
        for axis in told
        for kind, when in (("force", "at now"), ("impulse", "during hit"))
    ]
    return f"""up: z
gravity: {GRAVITY} m/s^2
bodies:
  rot:
    {{shape: cuboid, mass: {MASS} kg, sides: [0.4 m, 0.2 m, 0.1 m], points: {{{held}, C: [0.1 m, -0.1 m, 0.05 m]}},
    turned: {{about: z, by: {drawn}}}}}
connections: {{l: {{ball: rot.A}}, r: {{ball: rot.B}}}}
states: {{now: {{rot.angle: {TURN} rad, rot.angular_velocity: {RATE} rad/s}}, b: {{}}}}
events: {{hit: {{impulse: {BLOW} N s, on: rot.C, direction: [0, 2, -1], from: now, to: b}}}}
find: {{{", ".join(asked)}}}
"""


def turned(about: Vector, by: float) -> Vector:
    """The rotation about a unit vector."""
    cross = np.cross(np.eye(3), about)
    return np.eye(3) + math.sin(by) * cross + (1 - math.cos(by)) * cross @ cross


def by_hand(line: str) -> dict[str, Vector]:
    """The forces and impulses of both balls across the line, in space: τ_A = I α + ω × I ω and m a; r × J = I Δω and m Δv."""
    first, last, drawn, _ = LINES[line]
    rows = turned(np.array([0, 0, 1.0]), math.atan(15 / 40) if "atan" in drawn else 0.0)
    start, end = np.array(first), np.array(last)
    way = rows @ (end - start) / np.linalg.norm(end - start)
    rows = turned(way, TURN) @ rows
    centre, apart, struck = rows @ -start, rows @ (end - start), rows @ (STRUCK - start)
    a, b, c = (side**2 for side in SIDES)
    own = rows @ np.diag([b + c, c + a, a + b]) @ rows.T * MASS / 12
    tensor = own + MASS * (centre @ centre * np.eye(3) - np.outer(centre, centre))
    weight, omega = np.array([0, 0, -MASS * GRAVITY]), RATE * way
    faster = way @ np.cross(centre, weight) / (way @ tensor @ way)
    torque = tensor @ (faster * way) + np.cross(omega, tensor @ omega) - np.cross(centre, weight)
    whole = MASS * (faster * np.cross(way, centre) + np.cross(omega, np.cross(omega, centre))) - weight
    gained = way @ np.cross(struck, BLOW * WAY) / (way @ tensor @ way)
    twist = tensor @ (gained * way) - np.cross(struck, BLOW * WAY)
    pushed = MASS * gained * np.cross(way, centre) - BLOW * WAY
    reach = np.linalg.norm(apart)
    second, second_blow = (np.cross(part, way) / reach for part in (torque, twist))
    return {"rf": second, "lf": whole - second, "ri": second_blow, "li": pushed - second_blow}


@pytest.mark.parametrize("line", LINES)
def test_what_each_ball_pushes_across_the_line_is_told(line: str) -> None:
    derivation = solve(scene(line)).complete().derivation
    known = by_hand(line)
    assert derivation.answers
    for answer in derivation.answers:
        expected = known[answer.name[:2]]["xyz".index(answer.name[2])]
        assert answer.value is not None
        assert answer.value.float == pytest.approx(expected, rel=1e-8, abs=1e-9), answer.name
    assert all(item.holds is True for item in derivation.confirmed), [
        (item.name, item.why) for item in derivation.confirmed
    ]


def test_a_line_oblique_to_all_axes_leaves_how_it_turns() -> None:
    """ω′ = ω + n · (r × J)/(n · I n) along n."""
    text = scene("along x by the numbers").replace("A: [-0.2 m, 0.05 m, 0 m]", "A: [-0.2 m, 0.05 m, 0.03 m]")
    text = text[: text.index("find:")] + "find: {w: rot.angular_velocity at b, F: rot.force at now}\n"
    derivation = solve(text).complete().derivation
    assert [item.holds for item in derivation.confirmed] == [True, True]


@pytest.mark.parametrize(
    "asked", ["r.force.x at now", "l.force at now", "size of r.force at now", "r.impulse.x during hit"]
)
def test_along_the_line_a_single_ball_is_statically_indeterminate(asked: str) -> None:
    text = scene("along x by the numbers")
    with pytest.raises(
        Unsolvable, match=r"along the line through `l` and `r` only the sum of their (force|impulse)s is told"
    ):
        solve(text[: text.index("find:")] + f"find: {{F: {asked}}}\n")


def test_a_sum_of_components_across_is_told() -> None:
    text = scene("along x by the numbers")
    found = (
        solve(text[: text.index("find:")] + "find: {F: (r.force.z at now) + (l.force.z at now)}\n")
        .complete()
        .derivation
    )
    known = by_hand("along x by the numbers")
    assert found.answers[0].value is not None
    assert found.answers[0].value.float == pytest.approx(known["rf"][2] + known["lf"][2])


@pytest.mark.parametrize(
    ("place", "turned"), [("[0, 7 m, 0]", "0 deg"), ("[0, 1 m, 0]", "0 deg"), ("[1 m, 0, 0]", "90 deg")]
)
def test_places_at_which_the_points_are_not(place: str, turned: str) -> None:
    """Both balls may be told places, which go with how the body is drawn."""
    body = f"gate: {{shape: rectangle, mass: 1 kg, sides: [1 m, 2 m], turned: {{about: z, by: {turned}}}, "
    points = "points: {A: [-0.5 m, -1 m, 0], B: [0.5 m, -1 m, 0]}}"
    text = f"""up: z
bodies: {{{body}{points}}}
connections: {{l: {{ball: [[0, 0, 0], gate.A]}}, r: {{ball: [{place}, gate.B]}}}}
states: {{now: {{at rest: all}}}}
find: {{a: size of gate.angular_acceleration}}
"""
    with pytest.raises(Unsolvable, match="at which the points of `gate` are not"):
        solve(text)
    fits = text.replace(place, "[1 m, 0, 0]" if turned == "0 deg" else "[0, 1 m, 0]")
    assert float(solve(fits).answers["a"].value) == pytest.approx(1.5 * 9.8 / 2)
