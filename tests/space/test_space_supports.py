"""The sum of the forces of two balls that hold a body: told where each of them is not; everything that is not their sum stays refused.

By hand: of a plate on two balls the sum is M a less its weight and the pull P along the line, which nothing else holds.
"""

from __future__ import annotations

import pytest

from rotsolve import Solution, Unsolvable, solve

SCENE = """up: z
given: {M: 2 kg, a: 0.4 m, b: 0.3 m, P: 5 N}
bodies:
  pl:
    shape: rectangle
    mass: M
    sides: [a, b]
    points: {A: [-a/2, -b/2, 0], B: [a/2, TOP, 0], E: [a/2, b/2, 0]}
    turned: {about: x, by: 20 deg}
connections: {p: {ball: pl.A}, q: {ball: pl.B}}
actions: {pull: {force: P, on: pl.E, direction: [1, 0, 0]}}
states: {now: {pl.angle: 0 deg, pl.angular_velocity: 3 rad/s}}
find: {FIND}
"""


def solved(find: str, top: str = "-b/2") -> Solution:
    return solve(SCENE.replace("TOP", top).replace("FIND", find))


@pytest.mark.parametrize("top", ["-b/2", "b/2"])
def test_the_sum_of_both_is_all_that_acts_less_weight_and_pull(top: str) -> None:
    found = solved("S: p.force + q.force, N: pl.force.net", top)
    both, net = ([part.float or 0.0 for part in found.answers[name].components.values()] for name in "SN")
    assert both == pytest.approx([net[0] - 5, net[1], net[2] + 2 * 9.8])
    assert all(item.holds for item in found.derivation.confirmed) and len(found.derivation.confirmed) == 2


@pytest.mark.parametrize(
    ("asked", "value"),
    [
        ("q.force.x + p.force.x", -5.0),
        ("2*(p.force.x + q.force.x)/P", -2.0),
        ("p.force.x + q.force.x in body axes", -5.0),
    ],
)
def test_what_hangs_on_their_sum_alone_is_told(asked: str, value: float) -> None:
    found = solved(f"S: {asked}")
    assert found.answers["S"].float == pytest.approx(value)
    assert [item.holds for item in found.derivation.confirmed] == [True]


@pytest.mark.parametrize(
    "asked",
    ["p.force.x", "p.force.x - q.force.x", "2*p.force.x + q.force.x", "p.force.x * q.force.x", "p.force.x + q.force.y"],
)
def test_what_hangs_on_how_they_share_it_is_refused(asked: str) -> None:
    with pytest.raises(Unsolvable, match="is statically indeterminate"):
        solved(f"S: {asked}")
