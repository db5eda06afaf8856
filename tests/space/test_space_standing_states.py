"""States at which all stands still are cases of their own: no motion leads from one to the other, and nothing is conserved between them."""

from __future__ import annotations

from math import pi, sqrt

import pytest

from rotsolve import Unsolvable, solve

ON_A_HINGE = """up: z
given: {M: 2 kg, a: 0.4 m, b: 0.2 m}
bodies: {pl: {shape: rectangle, mass: M, sides: [a, b], points: {A: [-a/2, 0, 0]}}}
connections: {h: {hinge: pl.A, along: [0, 12/13, 5/13]}}
states: {up: {pl.angle: -90 deg, STANDS}, down: {pl.angle: LAST, STANDS}}
find: {l1: pl.stability at up, l2: pl.stability at down, T: period of small swings of pl about down}
"""
PENDULUM = """given: {m: 2 kg, L: 0.5 m}
bodies: {rod: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: rod.start}}
states: {up: {rod.angle: 90 deg, balance: true}, down: {rod.angle: LAST, balance: true}}
find: {T: period of small swings of rod about down, F: pin.force.y at up, G: pin.force.y at down}
"""


@pytest.mark.parametrize("stands", ["balance: true", "pl.angular_velocity: 0 rad/s, steady: true"])
def test_a_body_on_an_oblique_hinge_stands_up_and_hangs(stands: str) -> None:
    """I λ² = ± M g d cos 22.6° with d = a/2 and I = n·I n about the point held, I_y = M a²/3 and I_z = M (4 a² + b²)/12."""
    found = solve(ON_A_HINGE.replace("STANDS", stands).replace("LAST", "90 deg"))
    n, m = 12 / 13, 5 / 13
    square = (n * 9.8 * 0.2) / (n**2 * 0.4**2 / 3 + m**2 * (4 * 0.4**2 + 0.2**2) / 12)
    told = [found.answers[name].float for name in ("l1", "l2", "T")]
    assert told == pytest.approx([square, -square, 2 * pi / sqrt(square)])
    assert all(item.holds for item in found.derivation.confirmed)


def test_a_pendulum_stands_up_and_hangs() -> None:
    found = solve(PENDULUM.replace("LAST", "-90 deg"))
    told = [found.answers[name].float for name in "TFG"]
    assert told == pytest.approx([2 * pi * sqrt(2 * 0.5 / (3 * 9.8)), 19.6, 19.6])
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize(
    "scene",
    [
        ON_A_HINGE.replace("STANDS", "balance: true").replace("LAST", "60 deg"),
        PENDULUM.replace("LAST", "-60 deg"),
    ],
)
def test_a_place_that_is_none_of_balance_is_refused(scene: str) -> None:
    with pytest.raises(Unsolvable, match=r"not in equilibrium|contradict"):
        solve(scene)


def test_a_steady_state_on_a_hinge_without_a_rate_says_what_to_write() -> None:
    scene = ON_A_HINGE.replace("STANDS", "steady: true").replace("LAST", "90 deg")
    with pytest.raises(Unsolvable, match="write `balance: true` in place of `steady: true`"):
        solve(scene.partition(", l2:")[0] + "}\n")
