"""Many sets of givens against solving each: the same number, or both refuse, with the reason; also in pieces, as dask has them."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rotsolve import ManyAnswers, RotsolveError, Solution, solve
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.units.dimension import base_unit_text
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.arrays import NotForMany, single_answers

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
FILES = sorted(PROBLEMS.glob("*/*.yaml"))
QUICK = (  # of all kinds: limits of keys, what slips, roots, strings, states, vectors, mechanisms that have to close, cuts, units of pounds
    "four-bar-linkage",
    "geneva-mechanism",
    "scotch-yoke",
    "incline-pulley-rest",
    "rod-on-ice-blow",
    "door",
    "belt-drive",
    "leaning-top",
    "bullet-in-a-bar-in-pounds",
    "block-on-disc",
    "atwood",
    "rod-30",
    "plate-caught-at-corner",
)
FACTORS = st.one_of(
    st.floats(0.5, 2), st.floats(0.1, 10), st.floats(-3, 3), st.sampled_from((-1.0, 0.0, 1.0)), st.floats(0.98, 1.02)
)


@cache
def numbered(path: Path) -> tuple[Solution, dict[str, float]]:
    """A problem, solved, and the numbers in SI units of the givens that its file tells."""
    solution = solve(path)
    told = [item for item in solution.problem.givens if item.value is not None and not item.automatic]
    return solution, {
        item.name: evaluate(item.value, {}).float for item in told if item.value and not item.value.symbols()
    }


def in_si(answer: Any) -> float | str | None:
    if answer.value is None:
        return answer.word or None
    return answer.value.float * (1.0 if answer.unit is None else evaluate(answer.unit.factor, {}).float)


def solved_alone(solution: Solution, row: dict[str, float]) -> dict[str, float | str | None]:
    """What solving gives for one set; nothing where it refuses, or a check objects."""
    units = {item.name: base_unit_text(item.dimension) if item.dimension else "" for item in solution.problem.givens}
    try:
        found = solve(
            solution.problem, settings={name: f"{size!r} {units[name]}".strip() for name, size in row.items()}
        )
    except RotsolveError:
        return {}
    if any(check.holds is False for check in found.checks):
        return {}
    return {name: in_si(answer) for name, answer in single_answers(found.derivation.answers)}


def agree(path: Path, data: st.DataObject, sets: int) -> None:
    solution, numbers = numbered(path)
    names = data.draw(st.lists(st.sampled_from(sorted(numbers)), min_size=1, max_size=3, unique=True))
    rows = [{name: float(f"{numbers[name] * data.draw(FACTORS):.3g}") for name in names} for _ in range(sets)]
    try:
        many = solution.evaluate_many({name: np.array([row[name] for row in rows]) for name in names})
    except NotForMany:
        many = ManyAnswers({}, {}, {})
    for place, row in enumerate(rows):
        alone = solved_alone(solution, row)
        for name in alone.keys() | many.keys():
            own, found, reason = alone.get(name), None, "refused"
            if name in many:
                found, reason = many[name][place], many.reasons[name][place]
            if isinstance(own, str):
                assert (found, reason) == (own, ""), (name, row)
            elif own is None:
                assert reason and (found is None or found == "" or math.isnan(found)), (name, row, found)
            else:
                assert not reason and found is not None, (name, row, own, reason)
                factor = evaluate(parse_unit(many.units[name]).factor, {}).float if many.units[name] else 1.0
                assert float(found) * factor == pytest.approx(own, rel=1e-7, abs=1e-9), (name, row)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("path", [path for path in FILES if path.stem in QUICK], ids=lambda path: path.stem)
@settings(max_examples=2, deadline=None, derandomize=True)
@given(data=st.data())
def test_each_set_is_as_solving_it_says(path: Path, data: st.DataObject) -> None:
    agree(path, data, 3)


@pytest.mark.exhaustive
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
@settings(max_examples=3, deadline=None)
@given(data=st.data())
def test_each_set_of_every_problem_is_as_solving_it_says(path: Path, data: st.DataObject) -> None:
    if numbered(path)[1]:
        agree(path, data, 4)


def test_there_are_quick_ones() -> None:
    assert {path.stem for path in FILES} >= set(QUICK)


def test_what_solving_refuses_has_no_number_and_says_why() -> None:
    """b = 47.6 cm: the linkage does not close; a mass below nothing; what is no number at all."""
    linkage = solve(path_of("four-bar-linkage"))
    many = linkage.evaluate_many({"b": np.array([0.5, 0.476, math.nan, -0.5])})
    assert list(many.valid) == [True, False, False, False]
    assert "do not close" in many.reasons["w4"][1] and many.reasons["w4"][2] == "`b` is no number"
    assert not math.isnan(many["w4"][0]) and np.isnan(many["w4"][1:]).all()


def path_of(stem: str) -> Path:
    return next(path for path in FILES if path.stem == stem)


def test_sets_that_get_the_reason_of_another_name_it() -> None:
    many = solve(path_of("block-on-disc")).evaluate_many({"m": np.array([-1.0, -2.0, 2.0, -1.5])})
    assert many.reasons["a"][0].startswith("`mass` can't be negative, but this is `m = -1.0 kg`")
    assert many.reasons["a"][1] == many.reasons["a"][3] == f"as for m = -1: {many.reasons['a'][0]}"
    with pytest.raises(NotForMany, match="none of the sets has an answer: `mass` can't be negative"):
        solve(path_of("block-on-disc")).evaluate_many({"m": [-1.0, -2.0]})


def test_a_word_is_answered_for_each_set() -> None:
    stability = solve(path_of("stability-of-three-axes"))
    name = next(item.name for item in stability.problem.givens if not item.automatic)
    value = numbered(path_of("stability-of-three-axes"))[1][name]
    many = stability.evaluate_many({name: np.array([value, 1.001 * value])})
    assert list(many["unstable"]) == [stability["unstable"].word] * 2


def test_bounds_hold_what_solving_gives() -> None:
    solution = solve(path_of("block-on-disc"))
    masses = np.array([0.3, 1.7, 2.0])
    values, bounds = solution.evaluate_many({"m": masses}, certified=True)["a"]
    for place, mass in enumerate(masses):
        exact = 2 * Fraction(float(mass)) * Fraction(49, 5) / (2 * Fraction(float(mass)) + 5)
        assert abs(exact - Fraction(float(values[place]))) <= bounds[place] < 1e-15


def test_arrays_of_dask_are_worked_out_piece_by_piece() -> None:
    array = pytest.importorskip("dask.array")
    solution = solve(path_of("block-on-disc"))
    masses = np.linspace(-1, 5, 50)
    lazy = solution.evaluate_many({"m": array.from_array(masses, chunks=20), "R": 0.3})
    assert lazy["a"].shape == (50,) and lazy["a"].chunks == ((20, 20, 10),)
    plain = solution.evaluate_many({"m": masses, "R": 0.3})
    for name in plain:
        np.testing.assert_allclose(lazy[name].compute(scheduler="threads"), plain[name], equal_nan=True)
        assert ((lazy.reasons[name].compute() == "") == (plain.reasons[name] == "")).all()
    assert (lazy.valid.compute(scheduler="synchronous") == plain.valid).all()
    values, bounds = solution.evaluate_many({"m": array.from_array(masses[30:], chunks=10)}, certified=True)["T"]
    assert values.compute().shape == bounds.compute().shape == (20,)
    with pytest.raises(NotForMany, match="no given `q`"):
        solution.evaluate_many({"q": array.ones(3)})


def test_a_question_without_an_answer_takes_no_other_with_it() -> None:
    """What is asked of a state that is never reached has no answer; what is asked before it has the one that solving gives."""
    file = PROBLEMS / "angular-momentum" / "projectile-into-rod.yaml"
    many = solve(file).evaluate_many({"v": [100, 70]})
    alone = solve(file, settings={"v": "70 m/s"})
    assert list(alone.refused) == ["omega_top"]
    for name, answer in alone.items():
        assert many[name][1] == pytest.approx(answer.float) and many.reasons[name][1] == ""
    assert np.isnan(many["omega_top"][1]) and "never reached" in many.reasons["omega_top"][1]
    assert np.isfinite([column[0] for column in many.values()]).all()


def test_tables_and_arrays_of_other_kinds() -> None:
    pandas = pytest.importorskip("pandas")
    solution = solve(PROBLEMS / "pulleys" / "block-on-disc.yaml")
    plain = solution.evaluate_many({"m": [1.0, 2.0], "M": [3.0, 4.0]})["a"]
    assert (solution.evaluate_many(pandas.DataFrame({"m": [1, 2], "M": [3, 4]}))["a"] == plain).all()
    masked = solution.evaluate_many({"m": np.ma.array([1, 2], mask=[False, True])})["a"]
    assert np.isfinite(masked[0]) and np.isnan(masked[1])
    with pytest.raises(NotForMany, match="`m` has complex numbers"):
        solution.evaluate_many({"m": np.array([1 + 2j])})
