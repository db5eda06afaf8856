"""The first and the last time after which a body is at an angle are confirmed: φ = ω₀ t − ½ α t² has two roots, or one later than 0."""

from __future__ import annotations

import math

import pytest

from rotsolve import solve

PLATE = """up: z
given: {M: 1 kg, a: 0.4 m, b: 0.2 m, tau: 0.1 N m, T: unknown}
bodies: {pl: {shape: rectangle, mass: M, sides: [a, b], points: {A: [-a/2, 0, 0]}}}
connections: {h: {hinge: pl.A, along: z}}
actions: {m: {couple: [0, 0, -tau], on: pl}}
states: {now: {pl.angle: 0 deg, pl.angular_velocity: 2 rad/s}, later: {time: TIME, pl.angle: ANGLE}}
find: {T: ASKED, W: pl.angular_velocity.z at later}
"""
SLOWER = 0.1 / ((0.4**2 + 0.2**2) / 12 + 0.2**2)


def when(angle: float, way: int) -> float:
    return (2 + way * math.sqrt(4 - 2 * SLOWER * angle)) / SLOWER


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("asked", "told", "degrees", "way"),
    [
        ("smallest T", "T", 50, -1),
        ("largest T", "T", 50, 1),
        ("smallest T", "2*T", 50, -1),
        ("T", "T", -50, 1),
        ("smallest T", "T", -50, 1),
        ("largest T", "T", 0, 1),
    ],
)
def test_the_first_and_the_last_time_are_confirmed(asked: str, told: str, degrees: float, way: int) -> None:
    found = solve(PLATE.replace("TIME", told).replace("ANGLE", f"{degrees} deg").replace("ASKED", asked))
    time = when(math.radians(degrees), way)
    assert found.answers["T"].float == pytest.approx(time / (2 if told == "2*T" else 1))
    assert found.answers["W"].float == pytest.approx(2 - SLOWER * time)
    assert [item.holds for item in found.derivation.confirmed] == [True, True]


def test_a_plain_time_of_two_is_not_confirmed() -> None:
    found = solve(PLATE.replace("TIME", "T").replace("ANGLE", "50 deg").replace("ASKED", "T"))
    assert [item.holds for item in found.derivation.confirmed] == [None, None]


@pytest.mark.parametrize(("word", "wrong"), [("smallest", 1), ("largest", -1)])
def test_the_wrong_one_is_seen(word: str, wrong: int) -> None:
    from rotsolve.confirm.course.samples import sets_of_numbers
    from rotsolve.confirm.space.first_times import farthest_time
    from rotsolve.confirm.space.hearing import Hearing
    from rotsolve.scene.read import read_text
    from rotsolve.space.complete import configured_in_space

    text = PLATE.replace("TIME", "T").replace("ANGLE", "50 deg").replace("ASKED", f"{word} T")
    problem = configured_in_space(read_text(text)).problem
    own = when(math.radians(50), wrong)
    hearing = Hearing(problem, {**next(iter(sets_of_numbers(problem))), "T": own}, {})
    assert not farthest_time(hearing, problem.finds[0], "T", own, ())
