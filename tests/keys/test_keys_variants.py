"""Variants: reproducible, different, within the conditions; and their answers are those of a solution of their own."""

from __future__ import annotations

from functools import cache
from itertools import islice
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pages import FALL, PLAIN, ROOT, said
from rotsolve.algebra.units.quantities import parse_quantity
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.keys.variants import Variant, variants, worked_variants
from rotsolve.language.problem import Problem
from rotsolve.pipeline import solve, solve_problem
from rotsolve.scene.read import read_file, read_text

VARYING = [file for file in sorted((ROOT / "problems").rglob("*.yaml")) if "\nvary:" in file.read_text("utf-8")]
SPRING = """\
title: A block that may or may not move
given: {m: 2 kg, F: 30 N, mu: 0.5, d: 1 m}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: mu}}
actions: {push: {force: F, on: block, direction: right}}
states: {start: at rest, end: {block.displacement: d}}
find: {v: block.velocity at end}
vary: {F: 5 N to 60 N by 5 N, mu: [0.2, 0.5]}
"""


def problem_of(vary: str, text: str = FALL) -> Problem:
    return read_text(text[: text.index("vary:")] + f"vary: {vary}\n")


def test_the_first_variants_are_those_of_the_first_release() -> None:
    """A change here makes other sheets of the same seed."""
    assert list(variants(read_text(FALL), 3, 1)) == [
        Variant(1, {"m": "1.0 kg", "M": "6000 g"}),
        Variant(2, {"m": "2.5 kg", "M": "6000 g"}),
        Variant(3, {"m": "1.5 kg", "M": "5 kg"}),
    ]


def test_the_same_seed_gives_the_same_variants_however_many() -> None:
    problem = read_text(FALL)
    assert list(variants(problem, 9, 4))[:5] == list(variants(problem, 5, 4))
    assert list(variants(problem, 5, 4)) != list(variants(problem, 5, 5))


def test_variants_differ_while_there_are_such_and_then_come_again() -> None:
    """Of 15 pairs 9 have M > 2 m."""
    found = list(variants(read_text(FALL), 23, 1))
    different = {tuple(item.settings.items()) for item in found}
    assert len(different) == 9
    assert [item.number for item in found] == list(range(1, 24))
    assert all(item.repeats is None for item in found[:9])
    assert [item.repeats for item in found[9:]] == [*range(1, 10), 1, 2, 3, 4, 5]
    assert [item.settings for item in found[9:18]] == [item.settings for item in found[:9]]


@given(st.integers(0, 10**6))
@settings(max_examples=10, deadline=None)
def test_conditions_hold_in_every_variant(seed: int) -> None:
    for item in variants(read_text(FALL), 10, seed):
        m, M = (parse_quantity(item.settings[name]).value for name in ("m", "M"))
        assert M.value > 2 * m.value  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("where", "count"),
    [
        ("M >= 2*m", 12),
        ("M = 2*m", 3),
        ("M != 2*m", 12),
        ("M < 2*m", 3),
        ("[M > 2*m, m > 2 kg]", 1),
        ("4 kg < M < 6 kg", 5),
    ],
)
def test_comparisons_are_exact(where: str, count: int) -> None:
    problem = problem_of(f"{{m: 1.0 kg to 3.0 kg by 0.5 kg, M: [4 kg, 5 kg, 6000 g], where: {where}}}")
    assert sum(item.repeats is None for item in variants(problem, 20, 1)) == count


@cache
def problem_in(file: Path) -> Problem:
    return read_file(file)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("file", VARYING, ids=lambda file: file.stem)
@given(seed=st.integers(0, 10**6))
@settings(max_examples=1, deadline=None)
def test_every_number_is_that_of_a_solution_of_its_own(file: Path, seed: int) -> None:
    for variant, worked in worked_variants(problem_in(file), 4, seed):
        fresh = solve(file, settings=variant.settings, confirm=variant.number == 1)  # one of them is confirmed too
        assert [said(answer) for answer in worked.answers] == [said(answer) for answer in fresh.derivation.answers]
        assert all(check.holds is not False for check in fresh.checks)


def test_ten_problems_or_more_vary() -> None:
    assert len(VARYING) >= 10
    assert len({file.parent.name for file in VARYING}) >= 6


def test_answers_that_change_their_direction_are_told_so() -> None:
    text = (ROOT / "problems" / "pulleys" / "atwood.yaml").read_text("utf-8")
    problem = read_text(text[: text.index("vary:")] + "vary: {m1: 1 kg to 5 kg by 0.5 kg}\n")
    ways = set()
    for variant, worked in worked_variants(problem, 9, 1):
        fresh = solve_problem(read_text(text, settings=variant.settings))
        assert [said(answer) for answer in worked.answers] == [said(answer) for answer in fresh.derivation.answers]
        ways.add(worked.answers[0].direction)
    assert ways == {"up", "down", ""}


def test_values_for_which_the_scene_has_no_answer_are_not_used() -> None:
    """The block moves only where F > μ m g; v² = 2 d (F/m − μ g)."""
    for variant, worked in islice(worked_variants(read_text(SPRING), 24, 2), 24):
        force, mu = (float(variant.settings[name].removesuffix(" N")) for name in ("F", "mu"))
        assert force > mu * 2 * 9.8
        assert worked.answers[0].value is not None
        assert worked.answers[0].value.float == pytest.approx((2 * (force / 2 - mu * 9.8)) ** 0.5)


def test_values_beyond_what_a_scene_may_say_are_not_used() -> None:
    problem = problem_of("{m: 0 kg to 1 kg by 0.5 kg, R: -10 cm to 10 cm by 10 cm}")
    assert {item.settings["R"] for item in variants(problem, 9, 1)} == {"10 cm"}


def test_a_problem_without_any_variant_is_refused_with_the_reason() -> None:
    problem = problem_of("{m: 1 kg to 3 kg by 1 kg, where: m > 3 kg}")
    with pytest.raises(Unsolvable, match="none of 3 sets of values can be used; of the last: `m > 3 kg` does not hold"):
        list(variants(problem, 3, 1))


def test_a_problem_that_does_not_vary_stays_as_it_is() -> None:
    found = list(worked_variants(read_text(PLAIN), 3, 1))
    assert [(variant.number, variant.settings) for variant, _ in found] == [(1, {}), (2, {}), (3, {})]
    assert len({tuple(map(said, worked.answers)) for _, worked in found}) == 1


def test_most_variants_are_not_solved_anew() -> None:
    problem = read_file(ROOT / "problems" / "pulleys" / "stepped-drum.yaml")
    found = [worked for _, worked in worked_variants(problem, 60, 1)]
    assert sum(worked.solution is not None for worked in found) <= 3


LIMITED = {
    "a slope is acute": (
        "surfaces: {ramp: {slope: q, down: right}}\nbodies: {b: {shape: cylinder, radius: 1 m, moves: down}}\n"
        "connections: {c: {rolls: [b, ramp]}}\nfind: {a: b.acceleration}\n",
        "30 deg",
        "10 deg to 130 deg by 20 deg",
    ),
    "a coefficient is from 0 to 1": (
        "bodies: {rod: {shape: rod, mass: 3 kg, length: 2 m}, b: {mass: 1 kg, moves: right}}\n"
        "connections: {pin: {hinge: rod.start}}\n"
        "states: {before: {rod.angle: -90 deg, rod.angular_velocity: 0, b.velocity: 4 m/s}, after: {}}\n"
        "events: {hit: {collides: [b, rod.end], restitution: q, from: before, to: after}}\nfind: {v: b.velocity at after}\n",
        "0.5",
        "-0.5 to 1.5 by 0.25",
    ),
    "a rim lies within another": (
        "bodies: {b: {shape: annulus, mass: 1 kg, radii: {inner: q, outer: 3 m}}}\nfind: {I: b.inertia}\n",
        "1 m",
        "-1 m to 5 m by 0.5 m",
    ),
    "a point lies on its rod": (
        "bodies: {b: {shape: rod, mass: 1 kg, length: 2 m}}\nconnections: {h: {hinge: b.at(q)}}\nfind: {I: b.inertia about h}\n",
        "1 m",
        "-1 m to 3 m by 0.25 m",
    ),
    "the sides make a triangle": (
        "bodies: {b: {shape: triangle, mass: 1 kg, sides: [q, 2 m, 3 m]}}\nfind: {I: b.inertia}\n",
        "2 m",
        "1 m to 6 m by 0.5 m",
    ),
    "nothing is divided by zero": (
        "bodies: {b: {shape: rod, mass: 1 kg, length: 1 m/(q - 1)}}\nfind: {I: b.inertia}\n",
        "2",
        "-1 to 3 by 0.5",
    ),
}


@pytest.mark.parametrize("name", LIMITED)
def test_a_variant_is_used_where_the_scene_with_its_values_can_be_solved(name: str) -> None:
    """Though the file is not read again for each of them."""
    scene, first, span = LIMITED[name]
    text = f"title: {name}\ngiven: {{q: {first}}}\n{scene}vary: {{q: {span}}}\n"
    problem = read_text(text)
    assert problem.vary is not None
    good = set()
    for value in problem.vary.letters[0].values:
        try:
            fresh = solve(text, settings={"q": value})
        except (SceneError, Unsolvable):
            continue
        if all(check.holds is not False for check in fresh.checks):
            good.add(value)
    assert 0 < len(good) < len(problem.vary.letters[0].values)
    assert {item.settings["q"] for item in variants(problem, 30, 1)} == good


CRATE = """\
title: A tall crate slides to rest
given: {M: 10 kg, b: 0.3 m, h: 1 m, u: 3 m/s, mu: MU}
surfaces: {floor: level}
bodies: {crate: {shape: rectangle, mass: M, sides: [b, h], moves: right}}
connections: {base: {contact: [crate, floor], friction: mu}}
states: {start: {crate.velocity: u}, end: {crate.velocity: 0}}
find: {d: crate.displacement from start to end}
"""


def test_values_that_the_assembly_contradicts_are_left_out() -> None:
    """It tips where μ > b/h: no key says how far it slides then, with `vary` or without."""
    problem = read_text(CRATE.replace("MU", "0.2") + "vary: {mu: [0.2, 0.25, 0.4, 0.5]}\n")
    drawn = [one for one in variants(problem, 6, 1) if one.repeats is None]
    assert sorted(one.settings["mu"] for one in drawn) == ["0.2", "0.25"]
    with pytest.raises(Unsolvable, match=r"tips over|a check objects"):
        list(worked_variants(read_text(CRATE.replace("MU", "0.4")), 1, 1))
