"""The suite of compositions covers its tables, and finds what differs; `python benchmarks/soundness.py` is the long run."""

from __future__ import annotations

import random
from dataclasses import replace
from itertools import islice

import pytest

from compositions.compose import TABLES, covering, drawn, pairs
from compositions.judge import RIGHT, SILENT, VERDICTS, apart, differing, judged, run
from compositions.relations import RELATIONS
from trials.outcome import SOLVED, Printed, outcome
from trials.scene import read, written

PLAIN = """
title: Block on a slope
given: {m: 2 kg, beta: 30 deg, F: 3 N}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {block: {mass: m, moves: down}}
connections: {base: {contact: [block, ramp]}}
actions: {pull: {force: F, on: block, direction: left}}
states: {start: {at rest: all}}
find: {a: block.acceleration at start, N: base.normal_force at start}
"""


@pytest.mark.exhaustive
def test_every_entry_comes_soon_and_pairs_come_early() -> None:
    choices = [choice for choice, _ in islice(covering(1), 150)]
    for place, table in enumerate(TABLES.values()):
        assert {choice[place] for choice in choices} == set(table)
    covered = set().union(*(pairs(choice) for choice in choices))
    plain = set().union(*(pairs(drawn(1, number)[0]) for number in range(150)))
    assert len(covered) > len(plain)


def test_a_number_names_one_scene() -> None:
    assert drawn(5, 17) == drawn(5, 17)
    assert drawn(5, 17) != drawn(5, 18)


def test_a_sound_scene_is_right_in_all_ways() -> None:
    scene = read(PLAIN)
    found = outcome(written(scene), 7)
    assert found.kind == SOLVED
    for name, relation in RELATIONS.items():
        for other in relation(scene, random.Random(1)):
            assert written(other) != written(scene), name
            assert not list(differing(found, outcome(written(other), 7), name, other))


def test_another_answer_is_found() -> None:
    """An answer that hangs on the way in which the scene is said is wrong and silent, whichever way is drawn."""
    scene = read(PLAIN)
    found = outcome(written(scene), 7)
    wrong = replace(found, answers={**found.answers, "a": Printed("1.234567"), "N": Printed("1.234567")})
    verdicts = {judged(scene, wrong, random.Random(seed))[0] for seed in range(30)}
    assert SILENT in verdicts
    assert apart(Printed("1.000000"), Printed("1.000100")) and not apart(Printed("1.000000"), Printed("1.000001"))


def test_a_run_gives_a_verdict() -> None:
    results = [run(7, number) for number in range(4)]
    assert all(result.outcome in VERDICTS for result in results)
    assert any(result.outcome == RIGHT for result in (run(1, number) for number in range(3)))
