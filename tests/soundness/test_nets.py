"""The three nets, each with a fault that it alone holds: words without a part, places and what follows of them, the assembly.

Of each net a scene, or an engine that is spoilt, which the two others let pass.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from rotsolve import pipeline
from rotsolve.algebra.formula import formula
from rotsolve.core.facts import Force
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.elements.actions import AppliedForce
from rotsolve.pipeline import solve

SCENES = Path(__file__).parent / "scenes"
UNSTRETCHED = """
title: Block on a spring, of which a length is told that nothing asks for
given: {m: 2 kg, k: 80 N/m, l: 30 cm, x: 5 cm}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor]}, coil: {spring: [ground, block], stiffness: k, rest_length: l}}
states: {now: {coil.elongation: x}}
find: {a: block.acceleration at now}
"""
DOOR = """
given: {M: 12 kg, b: 80 cm, F: 6 N}
plane: horizontal
bodies: {door: {shape: rod, mass: M, length: b}}
connections: {pin: {hinge: door.start}}
actions: {push: {force: F, on: door.end, direction: up}}
states: {now: {door.angle: 0, at rest: all}}
find: {alpha: door.angular_acceleration at now}
"""


def test_a_word_without_a_part_passes_places_and_assembly(monkeypatch: pytest.MonkeyPatch) -> None:
    """Someone who writes a length expects it to matter: nothing but the count of words says that it does not."""
    with pytest.raises(SceneError, match="rest_length"):
        solve(UNSTRETCHED)
    monkeypatch.setattr(pipeline, "refuse_idle", lambda solutions, problem: None)
    found = solve(UNSTRETCHED)
    assert found.answers["a"].float == pytest.approx(-2.0)
    assert [item.holds for item in found.derivation.confirmed] == [True]


def test_an_arm_that_is_wrong_passes_words_and_laws(monkeypatch: pytest.MonkeyPatch) -> None:
    """An engine that takes half of an arm everywhere agrees with itself, and every word has its part: the assembly contradicts."""
    facts = AppliedForce.facts

    def spoilt(self: Any, instant: Any) -> Iterator[Any]:
        for fact in facts(self, instant):
            yield replace(fact, arm=fact.arm.times(formula(1) / formula(2))) if isinstance(fact, Force) else fact

    monkeypatch.setattr(AppliedForce, "facts", spoilt)
    assert solve(DOOR, confirm=False).answers["alpha"].float == pytest.approx(3 * 6 / (12 * 0.8) / 2)
    with pytest.raises(Unsolvable, match="not confirmed"):
        solve(DOOR)


def test_places_are_right_where_the_assembly_does_not_follow() -> None:
    """A length that a period tells: no word is idle, the assembly has no answer, and the geometry of swings was what went wrong."""
    found = solve(SCENES / "thread-as-long-as-a-ruler-swings.yaml")
    assert {item.name: item.holds for item in found.derivation.confirmed}["l"] is None
    assert not found.refused
