"""The suite in space draws from all its tables, and finds what does not turn with the scene; `soundness.py --space` is the long run."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest

from compositions.judge import BROKEN, RIGHT, SILENT, VERDICTS, judged
from compositions.relations import RELATIONS
from compositions.space import TABLES, drawn
from compositions.turned import SAME, TURNED, differences, not_turned, quarter, run, turned
from trials.outcome import SOLVED, Printed, outcome
from trials.scene import read, written

STRUCK = """
title: Box on a ball joint, turned, pushed and turning
up: z
given: {M: 2 kg, a: 30 cm, b: 20 cm, c: 10 cm, F: 3 N, w: 2 rad/s, beta: 30 deg}
bodies: {one: {shape: cuboid, mass: M, sides: [a, b, c], points: {P: [a/2, b/2, -c/2]}, turned: {about: y, by: beta}}}
connections: {joint: {ball: one.P}}
actions: {push: {force: F, on: one.center, direction: x}}
states: {start: {one.angular_velocity: [w, -w, 0]}}
find: {L: one.angular_momentum at start, N: joint.force at start, B: one.angular_acceleration at start in body axes}
"""
TOP = """
title: Top that precesses
up: z
given: {M: 150 g, l: 4 cm, A: 5e-4 kg m^2, C: 6e-5 kg m^2, s: 300 rad/s, theta: 25 deg}
bodies: {one: {mass: M, inertia: {about: P, principal: [A, A, C]}, axis: z, points: {P: [0, 0, -l]}}}
connections: {joint: {ball: one.P}}
states: {start: {one.tilt: theta, one.axial_rate: s, one.precession: smallest, steady: true}}
find: {L: one.angular_momentum at start, N: joint.force at start, p: one.precession at start}
"""


def test_every_entry_of_each_table_comes() -> None:
    choices = [drawn(1, number)[0] for number in range(400)]
    for place, table in enumerate(TABLES.values()):
        assert {choice[place] for choice in choices} == set(table)


def test_a_number_names_one_scene() -> None:
    assert drawn(5, 17) == drawn(5, 17)
    assert drawn(5, 17) != drawn(5, 18)


def test_a_quarter_turns_x_to_y() -> None:
    assert quarter(["a", "-b", "0"]) == ["b", "a", "0"]
    assert [quarter(axis) for axis in ("x", "y", "-x", "-y", "z")] == ["y", "-x", "-y", "x", "z"]


@pytest.mark.parametrize("text", [STRUCK, TOP])
def test_a_sound_scene_is_right_in_all_ways(text: str) -> None:
    scene = read(text)
    found = outcome(written(scene), 7)
    assert found.kind == SOLVED
    assert any(found.answers[f"L.{axis}"].number for axis in "xy")
    other = outcome(written(turned(scene)), 7)
    assert other.answers["L.x"].number != found.answers["L.x"].number
    assert not list(not_turned(found, other, scene))
    assert set(SAME) <= set(RELATIONS)
    assert judged(scene, found, random.Random(1), differences) == (RIGHT, "")


def test_what_does_not_turn_is_found() -> None:
    """A component along a space axis that stays where it was is wrong, and silent."""
    scene = read(STRUCK)
    found = outcome(written(scene), 7)
    wrong = replace(found, answers={**found.answers, "L.x": Printed("1.234567")})
    assert next(not_turned(wrong, outcome(written(turned(scene)), 7), scene)).startswith(TURNED)
    verdicts = {judged(scene, wrong, random.Random(seed), differences)[0] for seed in range(6)}
    assert SILENT in verdicts


def test_scenes_of_a_seed_have_verdicts() -> None:
    results = [run(7, number) for number in range(10)]
    assert {result.outcome for result in results} <= set(VERDICTS) - {SILENT, BROKEN}
    assert sum(result.outcome == RIGHT for result in results) >= 2
