"""A letter that one question seeks is open in the others: their conditions stand, and what seeks it is refused where they hang on it."""

from __future__ import annotations

import pytest

import rotsolve

CRATE = """
title: Force on a crate, and a force for which the floor pushes so hard
given: {m: kg, F: N, P: N, phi: rad}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: right}}
connections: {base: {contact: [crate, floor]}}
actions: {pull: {force: F, on: crate, direction: phi}}
states: {start: {at rest: all}}
"""
ROD = """
title: Rod hung at any place
given: {m: kg, M: kg, L: m, x: m}
bodies: {rod: {shape: rod, mass: M, length: L}, lump: {mass: m}}
connections: {pin: {hinge: rod.at(x)}, bolt: {weld: [rod.end, lump]}}
states: {hang: {rod.angle: -90 deg, balance: true}}
"""
SEEKING = {
    "where": (CRATE, "N: base.normal_force at start", "F_1: F where base.normal_force = P at start"),
    "extremum": (ROD, "T: period of small swings of rod about hang", "x0: x where T is smallest"),
}


@pytest.mark.parametrize("kind", SEEKING)
def test_conditions_stand_beside_a_question_that_seeks_their_letter(kind: str) -> None:
    scene, other, seeking = SEEKING[kind]
    alone = rotsolve.solve(f"{scene}find: {{{other}}}")
    both = rotsolve.solve(f"{scene}find: {{{other}, {seeking}}}")
    (name,) = alone.answers
    assert alone.answers[name].conditions
    assert both.answers[name].conditions == alone.answers[name].conditions
    assert list(both.answers) == [name]
    (reason,) = both.refused.values()
    assert "of which this seeks one" in str(reason)


def test_what_hangs_on_nothing_is_answered_together() -> None:
    """No condition of I hangs on y: both are answered, y at the middle."""
    scene = """
title: Where a rod turns most easily
given: {M: kg, L: m, y: m}
bodies: {rod: {shape: rod, mass: M, length: L}}
find: {I: rod.inertia about rod.at(y), y_0: y where I is smallest}
"""
    solution = rotsolve.solve(scene)
    assert solution.answers["y_0"].exact == "½ L"
    assert not solution.refused
