"""A spring of next to no length turns quickly: small swings beside it are confirmed where steps tell them, else they are left open."""

from __future__ import annotations

import math

import pytest

from rotsolve.pipeline import solve

POLE = """
given: {M: 2 kg, L: 1 m, d: D m, k: 1e4 N/m, n: N m}
bodies: {pole: {shape: rod, mass: M, length: L}}
connections: {foot: {hinge: pole.start}, coil: {spring: [[0, d], pole.end], stiffness: k, rest_length: n}}
states: {up: {pole.angle: 90 deg, balance: true}}
find: {T: period of small swings about up}
"""


@pytest.mark.parametrize(("gap", "confirmed"), [(0.001, False), (0.5, True)])
def test_small_swings_beside_a_spring(gap: float, confirmed: bool) -> None:
    """I ω² = k d L (gap − n)/gap − M g L/2 with I = M L²/3."""
    text = POLE.replace("D m", f"{1 + gap} m").replace("N m}", f"{gap / 2} m}}")
    solution = solve(text)
    square = (1e4 * (1 + gap) * 0.5 - 9.8) / (2 / 3)
    assert solution.answers["T"].float == pytest.approx(2 * math.pi / math.sqrt(square), rel=1e-3)
    verdict = next(item for item in solution.derivation.confirmed if item.name == "T")
    assert verdict.holds is (True if confirmed else None)
