"""Weight that turns with a body: falls and throws on what turns steadily, against r̈ = −g ẑ − 2 ω × v − ω × (ω × r) followed in steps."""

from __future__ import annotations

import numpy as np
import pytest

from rotsolve import SceneError, Solution, Unsolvable, solve
from second_route.turning_frames import Numbers, fallen_on_the_earth

SCENE = """up: z
gravity: GRAVITY
given: {w: 0.3 rad/s, g: 9.8 m/s^2, la: 0.7 rad, T: 1.5 s}
bodies:
  earth: {mass: 0, points: {P: [0, 0, 0], Q: [3 m, 0, 0]}}
  stone: {shape: particle, mass: 1 kg}
connections: {pole: {hinge: earth.P, along: ALONG, angular_velocity: w}MORE}
states:
  fired: {earth.angle: ANGLE, stone.position relative to earth: [1 m, 2 m, 20 m], stone.velocity relative to earth: [3 m/s, -1 m/s, 2 m/s]}
  LATER
find: {FIND}
"""
OURS = {
    "GRAVITY": "{size: g, in: earth}",
    "ALONG": "[0, cos(la), sin(la)]",
    "MORE": "",
    "ANGLE": "0 deg",
    "LATER": "down: {time: T}",
    "FIND": "d: stone.position in earth axes at down",
}
LEANING = np.array([0, np.cos(0.7), np.sin(0.7)])


def scene(**changes: str) -> str:
    text = SCENE
    for word, written in (OURS | changes).items():
        text = text.replace(word, written)
    return text


def confirmed(solution: Solution) -> bool:
    return all(item.holds for item in solution.derivation.confirmed)


def signs(solution: Solution) -> str:
    return solution.to("text").split("Plan")[0]


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"ANGLE": "40 deg"},
        {"ALONG": "z"},
        {"LATER": "mid: {time: 0.4 s}\n  down: {time: 1.1 s}"},
        {"ALONG": "[2, -1, 2]"},
    ],
)
def test_it_falls_as_it_does_seen_from_there(changes: dict[str, str]) -> None:
    solution = solve(scene(**changes))
    axis = {"z": np.array([0.0, 0, 1]), "[2, -1, 2]": np.array([2.0, -1, 2]) / 3}.get(changes.get("ALONG", ""), LEANING)
    start = np.array([1, 2, 20, 3, -1, 2.0])
    expected = fallen_on_the_earth(start, axis, Numbers(w=0.3, g=9.8), 1.5)
    found = [part.float for part in solution.answers["d"].components.values()]
    assert found == pytest.approx(list(expected), rel=1e-9)
    assert confirmed(solution)
    assert "the weight goes along −z of earth, and turns with it" in " ".join(signs(solution).split())


def test_where_it_does_not_turn_the_page_says_so() -> None:
    """g t²/2 down in space, and the stone from a tower then half as far again to the east."""
    solution = solve(scene(GRAVITY="g"))
    assert "does not turn with earth (gravity: {in: earth} turns it)" in " ".join(signs(solution).split())
    assert "does not turn" not in signs(solve(scene(GRAVITY="g", ALONG="z")))  # upright it is the same
    assert "does not turn" not in signs(solve(scene(GRAVITY="none")))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"FIND": "E: stone.energy at down"}, "no potential energy of the place alone"),
        ({"FIND": "U: stone.potential_energy at down"}, "no potential energy of the place alone"),
        ({"GRAVITY": "{size: g, in: stone}"}, "no hinge on the ground turns that at a steady `angular_velocity`"),
        ({"MORE": ", nail: {ball: [earth.Q, stone.cm]}"}, "`nail` holds `stone`, whose weight turns with `earth`"),
    ],
)
def test_what_is_not_solved_with_it_is_refused_by_name(changes: dict[str, str], message: str) -> None:
    with pytest.raises(Unsolvable, match=message):
        solve(scene(**changes))


@pytest.mark.parametrize(
    ("written", "message"),
    [
        ("{size: g}", "`gravity` needs `in`"),
        ("{size: g, in: moon}", "unknown body `moon`"),
        ("{in: earth, by: 2}", "by"),
    ],
)
def test_a_fault_in_it_has_its_place(written: str, message: str) -> None:
    with pytest.raises(SceneError, match=message) as caught:
        solve(scene(GRAVITY=written))
    assert caught.value.faults[0].span.line == 2


def test_a_body_may_name_the_letter_of_gravity_that_is_not_given() -> None:
    text = "given: {W: 10 N, R: 1 m}\nbodies: {disc: {shape: disc, mass: W/g, radius: R}}\nconnections: {pin: {axle: disc.center}}\n"
    solution = solve(text + "actions: {pull: {couple: 3 N m, on: disc}}\nfind: {a: disc.angular_acceleration}\n")
    assert solution.answers["a"].float == pytest.approx(2 * 3 * 9.8 / 10)
