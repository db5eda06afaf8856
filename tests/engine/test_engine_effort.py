"""Effort: every scene ends, with what has been found by then or a refusal by name; leaving an equation out of a matching is exact."""

from random import Random

import pytest

from rotsolve import pipeline
from rotsolve.algebra.effort import Allowance, Exhausted, at_most, exert
from rotsolve.core.faults import Unsolvable
from rotsolve.matching import Matching

SCENE = """
title: A sledge is thrown on a board that lies on ice
given: {m: kg, M: kg, u: m/s, mu: number}
surfaces: {ice: level}
bodies: {board: {mass: M, moves: right}, sledge: {mass: m, moves: right}}
connections: {base: {contact: [board, ice]}, top: {contact: [sledge, board], friction: mu}}
states: {start: {sledge.velocity: u, board.velocity: 0}, together: {top: sticks}}
find: {t: time from start to together, v: board.velocity at together}
"""


def test_a_scene_that_takes_too_long_is_refused_by_name(monkeypatch):
    monkeypatch.setattr(pipeline, "STEPS", 5)
    with pytest.raises(Unsolvable, match="too long to work out in letters") as refused:
        pipeline.solve(SCENE)
    assert "`m`" in refused.value.fault.help
    with pytest.raises(Unsolvable, match="too long to work out"):
        pipeline.solve(SCENE, settings={"m": "1 kg", "M": "2 kg", "u": "3 m/s", "mu": "0.2"})


def test_what_is_worked_out_within_the_steps_is_answered():
    assert pipeline.solve(SCENE).derivation.answers


def test_steps_are_counted_within_and_given_back_around():
    with at_most(10):
        with pytest.raises(Exhausted), at_most(2):
            exert(3)
        exert(10)
        with pytest.raises(Exhausted):
            exert(1)
    exert(10**9)


def test_an_allowance_is_for_all_that_uses_it():
    allowance = Allowance(5)
    with allowance.used():
        exert(3)
    with pytest.raises(Exhausted), allowance.used():
        exert(3)
    with pytest.raises(Exhausted), allowance.used():
        exert(1)


@pytest.mark.parametrize("seed", range(200))
def test_a_matching_without_an_equation_is_the_matching_made_without_it(seed):
    chance = Random(seed)
    indices = list(range(chance.randint(1, 12)))
    chance.shuffle(indices)
    told = {index: tuple(sorted({f"x{chance.randint(0, 9)}" for _ in range(3)})) for index in indices}
    matching = Matching(told)
    for skipped in set(matching.owner.values()):
        anew = Matching({index: names for index, names in told.items() if index != skipped})
        assert set(matching.without(skipped).values()) == set(anew.owner.values())
