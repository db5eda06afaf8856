"""Motors on axles, and bodies that nothing holds: what was at rest together keeps no angular momentum, along any axes.

By hand, and by the assembly.
"""

from __future__ import annotations

import numpy as np
import pytest

from rotsolve import SceneError, Solution, Unsolvable, solve

START = """up: z
gravity: none
given: {m: 12 kg, a: 1 m, b: 0.6 m, c: 0.4 m, C: 0.4 kg m^2, k: 5 kg, d: 0.2 m, w: 30 rad/s, v: 20 rad/s, W: 2 rad/s}
bodies:
  sat: {shape: cuboid, mass: m, sides: [a, b, c], points: {P: [d, 0, 0], Q: [0, d, 0]}}
  wheel: {mass: k, inertia: {principal: [C/2, C/2, C]}, axis: z}
"""
ONE = "connections: {axle: {axle: [sat.P, wheel], along: ALONG}, motor: {drives: [sat, wheel]}}\n"
TOLD = "states: {before: at rest, after: {wheel.angular_velocity: w}}\n"
ASKED = "find: {O: sat.angular_velocity at after in body axes}\n"
OWN = 12 / 12 * np.diag([0.52, 1.16, 1.36])


def answered(scene: str) -> list[float]:
    """The components of the only answer, which is confirmed."""
    solution: Solution = solve(scene).complete()
    assert [item.holds for item in solution.derivation.confirmed] == [True]
    (answer,) = solution.derivation.answers
    return [part.value.float for part in answer.components or (answer,) if part.value is not None]


def about_common_centre(place: np.ndarray) -> np.ndarray:
    """The moments of a mass point and the satellite about their common centre beside their own: μ (d² − d d)."""
    return 12 * 5 / 17 * (place @ place * np.eye(3) - np.outer(place, place))


@pytest.mark.parametrize("way", [(1, 0, 0), (0, 1, 0), (1, 1, 0), (2, -1, 2)])
def test_a_wheel_that_is_started_turns_what_carries_it(way: tuple[int, int, int]) -> None:
    """(I + I_wheel + μ (d² − d d)) Ω = −C w n."""
    axis = np.array(way) / np.linalg.norm(way)
    wheel = 0.2 * (np.eye(3) + np.outer(axis, axis))
    whole = OWN + wheel + about_common_centre(np.array([0.2, 0, 0]))
    found = answered(START + ONE.replace("ALONG", str(list(way))) + TOLD + ASKED)
    assert found == pytest.approx(list(np.linalg.solve(whole, -0.4 * 30 * axis)), rel=1e-9, abs=1e-9)


def test_on_a_shaft_of_the_ground_the_rest_stays_too() -> None:
    """(I + C + k d²) (Ω − W) = −C w about the shaft."""
    connections = ONE.replace("{axle:", "{post: {hinge: sat.center, along: z}, axle:", 1).replace("ALONG", "z")
    states = TOLD.replace("before: at rest", "before: {sat.angular_velocity: W, wheel.angular_velocity: 0 rad/s}")
    asked = "find: {O: sat.angular_velocity.z at after}\n"
    assert answered(START + connections + states + asked) == pytest.approx([2 - 12 / (1.36 + 0.4 + 0.2)])


def test_without_a_motor_a_free_wheel_is_not_started() -> None:
    scene = START + ONE.replace("ALONG", "x").replace(", motor: {drives: [sat, wheel]}", "") + TOLD + ASKED
    with pytest.raises(Unsolvable) as caught:
        solve(scene)
    assert "`after` is never reached from `before`" in str(caught.value)


@pytest.mark.parametrize(
    ("along", "turned", "expected"),
    [("x", "", [-12 / 0.92, 0, 0]), ("x", ", turned: {about: z, by: 90 deg}", [0, -12 / 0.92, 0])],
)
def test_about_an_axis_that_stays_it_is_told_in_space(along: str, turned: str, expected: list[float]) -> None:
    """It turns about a principal axis of the whole alone, which stays in space: (I_x + C) Ω = −C w; where it then stands nothing tells."""
    scene = (START + ONE.replace("ALONG", along) + TOLD).replace("sides: [a, b, c]", f"sides: [a, b, c]{turned}")
    assert answered(scene + ASKED.replace(" in body axes", "")) == pytest.approx(expected, rel=1e-9, abs=1e-9)
    with pytest.raises(Unsolvable) as caught:
        solve(scene + "find: {o: sat.z_axis at after}\n")
    assert "hangs on how `sat` stands at `after`, which nothing tells" in str(caught.value)


def test_a_second_wheel_across_lets_nothing_in_space_be_told() -> None:
    """Started one after the other they turn it about axes that are not the same, so that the order counts."""
    body = "  w2: {mass: k, inertia: {principal: [C/2, C/2, C]}, axis: z}\n"
    both = ONE.replace("ALONG", "x").replace(
        "}}\n", "}, ax2: {axle: [sat.Q, w2], along: y}, m2: {drives: [sat, w2]}}\n"
    )
    told = TOLD.replace("angular_velocity: w}", "angular_velocity: w, w2.angular_velocity: v}")
    assert len(answered(START + body + both + told + ASKED)) == 3
    with pytest.raises(Unsolvable) as caught:
        solve(START + body + both + told + ASKED.replace(" in body axes", ""))
    assert "how `sat` stands at `after` nothing tells" in str(caught.value)


def test_an_angular_velocity_in_space_tells_none_of_a_body_that_stands_anyhow() -> None:
    told = "states: {before: at rest, after: {sat.angular_velocity: [1 rad/s, 0, 0]}}\n"
    scene = START + ONE.replace("ALONG", "[1, 2, 2]") + told + "find: {s: wheel.spin at after}\n"
    with pytest.raises(Unsolvable) as caught:
        solve(scene)
    assert "tell `sat.angular_velocity in body axes`" in str(caught.value)


def test_how_it_stands_in_space_nothing_tells() -> None:
    scene = START + ONE.replace("ALONG", "[1, 2, 2]") + TOLD
    with pytest.raises(Unsolvable) as caught:
        solve(scene + ASKED.replace(" in body axes", ""))
    assert "how `sat` stands at `after` nothing tells" in str(caught.value)
    assert "ask for it `in body axes`" in str(caught.value)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("axle: {axle: [sat.P, wheel], along: x}, ", "", "no hinge or axle is there about which it could"),
        ("along: x}", "along: x, angular_velocity: w}", "no hinge or axle is there about which it could"),
        ("[sat, wheel]}}", "[sat, wheel], couple: 3 N m}}", "drives with a `couple`, which is not solved in space"),
    ],
)
def test_motors_that_are_refused(old: str, new: str, words: str) -> None:
    connections = ONE.replace("ALONG", "x")
    assert old in connections
    with pytest.raises((Unsolvable, SceneError)) as caught:
        solve(START + connections.replace(old, new) + TOLD + ASKED)
    assert words in str(caught.value)


def test_a_told_couple_is_two_actions() -> None:
    connections = ONE.replace("ALONG", "x").replace("[sat, wheel]}}", "[sat, wheel], couple: 3 N m}}")
    with pytest.raises(Unsolvable) as caught:
        solve(START + connections + TOLD + ASKED)
    assert "[x, y, z] on `wheel`, [-x, -y, -z] on `sat`" in str(caught.value)


def test_lagrange_knows_no_work_of_a_motor() -> None:
    with pytest.raises(Unsolvable):
        solve(START + ONE.replace("ALONG", "x") + TOLD + ASKED, law="lagrange")
