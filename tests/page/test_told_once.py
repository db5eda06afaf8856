"""A page tells nothing twice, and tells what happens and where points are."""

from __future__ import annotations

from pathlib import Path

import pytest

from rotsolve.algebra.formula import Symbol
from rotsolve.core.derivation import Derivation, Equality
from rotsolve.derivation.results import without_reordered
from rotsolve.page.text import plain_text
from rotsolve.pipeline import solve

ROOT = Path(__file__).resolve().parents[2]
A, B, C, X = map(Symbol, "abcx")
IN_SPACE = sorted((ROOT / "problems/space").glob("*.yaml"))


def derivation(problem: str) -> Derivation:
    return solve(ROOT / f"problems/{problem}.yaml").derivation


def test_a_product_in_another_order_is_no_step() -> None:
    assert without_reordered([Equality(X, A * B / C), Equality(X, B * A / C)]) == (Equality(X, B * A / C),)
    assert len(without_reordered([Equality(X, A * B / C), Equality(X, B * A / (C * C))])) == 2
    assert len(without_reordered([Equality(X, A * A * B), Equality(X, A * B)])) == 2
    assert len(without_reordered([Equality(A, A * B), Equality(X, B * A)])) == 2


@pytest.mark.parametrize("problem", IN_SPACE, ids=lambda path: path.stem)
def test_no_law_stands_twice_on_a_page_but_for_another_letter_on_its_left(problem: Path) -> None:
    for section in solve(problem).derivation.sections:
        laws = [(law.law, law.equation) for law in section.laws]
        assert len(laws) == len(set(laws))
        numbers = [law.number for law in section.laws]
        assert numbers == list(range(numbers[0], numbers[0] + len(numbers))) if numbers else True


def test_two_roots_of_one_equation_are_told_by_it_once() -> None:
    (section,) = derivation("space/leaning-top").sections
    assert [law.number for law in section.laws] == [1, 2]
    first, second = section.moves
    assert not first.another
    assert second.another and second.into == "(1)" and second.put == ()
    assert [line.left for line in second.chain] == [Symbol("fast")]
    assert first.chain[-1].right != second.chain[-1].right


def test_equal_entries_of_a_vector_are_told_together() -> None:
    (section,) = derivation("space/cube-corner").sections
    axes = [law for law in section.laws if law.law.startswith("principal axis")]
    assert len(axes) == 1
    assert plain_text(axes[0].remark).endswith("the same for e_y, e_z")


def test_the_size_of_a_vector_is_told_by_a_component_that_was_asked() -> None:
    (section,) = derivation("space/ball-on-a-turntable").sections
    size = next(law.equation for law in section.laws if law.equation.left == Symbol("n"))
    assert "a" in size.right.symbols() and "u" not in size.right.symbols()


@pytest.mark.parametrize(
    ("problem", "told"),
    [
        ("angular-momentum/blow-on-rod-on-ice", "blow: impulse J on rod's end, up"),
        ("angular-momentum/disc-drop", "drop: record and turntable stay together"),
        ("space/blow-on-a-plate-at-a-corner", "hit: impulse J on plate's Q, along z"),
    ],
)
def test_events_are_told(problem: str, told: str) -> None:
    assert [plain_text(words) for words in derivation(problem).events] == [told]


def test_every_event_of_a_bundled_problem_is_told() -> None:
    for problem in ROOT.glob("problems/*/*.yaml"):
        if "\nevents:" in problem.read_text():
            solution = solve(problem)
            assert len(solution.derivation.events) == len(solution.problem.events), problem


def test_places_are_those_of_the_points_from_the_centre_of_mass() -> None:
    (told,) = derivation("space/blow-on-a-plate-at-a-corner").places
    assert plain_text(told) == "on plate, from its centre of mass along its own axes: O (½ a, ½ a, 0), Q (½ a, −½ a, 0)"
    assert [plain_text(words) for words in derivation("space/turbine-of-a-ship").places] == [
        "bearings of shaft at −b/2, b/2 along x"
    ]
