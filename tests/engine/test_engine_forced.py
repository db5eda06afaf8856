"""Forced swings are refused by that name, however they are asked; what is driven in time alone is not among them."""

from __future__ import annotations

from math import isclose, sin

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

DRIVEN = """
title: a collar that a force drives in time
gravity: none
given: {m: 4 kg, k: 450 N/m, P: 13 N, w: 5 rad/s}
bodies: {collar: {mass: m, moves: right}}
connections: {coil: {spring: [ground, collar], stiffness: k}}
actions: {drive: {force: P*sin(w*time), on: collar, direction: right}}
states: {start: {collar.displacement: 0, collar.velocity: 0}, end: {END}}
find: {x: ASKED}
"""


@pytest.mark.parametrize(
    ("end", "asked"),
    [
        ("time: 10 s", "largest collar.displacement from start to end"),
        ("time: 10 s", "collar.displacement from start to end"),
        ("collar.displacement: 1 cm", "collar.velocity at end"),
    ],
)
def test_forced_swings_are_refused_by_name(end: str, asked: str) -> None:
    with pytest.raises(Unsolvable, match="`drive` forces swings on `collar` in time"):
        solve(DRIVEN.replace("END", end).replace("ASKED", asked))


def test_without_a_spring_it_is_solved() -> None:
    """v = (P/(m w)) (1 − cos wT), so that x = (P/(m w)) (T − sin(wT)/w)."""
    found = solve(
        DRIVEN.replace("END", "time: 2 s")
        .replace("ASKED", "collar.displacement from start to end")
        .replace("connections: {coil: {spring: [ground, collar], stiffness: k}}\n", "")
        .replace("k: 450 N/m, ", "")
    )
    assert isclose(found.answers["x"].float, 13 / 20 * (2 - sin(10) / 5), rel_tol=1e-6)
