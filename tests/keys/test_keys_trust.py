"""What is evaluated and not solved anew is what a new solution says: bundled problems with their numbers a little changed, at random."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from random import Random

import pytest

from pages import ROOT, said
from rotsolve.algebra.formula import Number
from rotsolve.algebra.units.quantities import number_in_unit
from rotsolve.algebra.units.unit_table import ONE_UNIT
from rotsolve.keys.working import Unsuited, VariantSolver
from rotsolve.language.problem import Problem
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_file

PROBLEMS = sorted((ROOT / "problems").rglob("*.yaml"))
FACTORS = [Fraction(text) for text in ("1/2", "0.8", "0.9", "1.1", "1.3", "2")]
TRIES, MOST_TRIES = 8, 40  # most sets of numbers of some problems belong to no body, or to another case


def changed(problem: Problem, random: Random) -> dict[str, str]:
    """Settings with some givens a little larger or smaller."""
    settings = {}
    for given in problem.givens:
        if given.automatic or given.asked or given.value is None or given.value.symbols() or random.random() < 0.4:
            continue
        unit = given.unit or ONE_UNIT
        number = number_in_unit(given.value, unit)
        if isinstance(number, Number) and number.value:
            settings[given.name] = unit.after(str(number.value * random.choice(FACTORS)))
    return settings


@pytest.mark.sampled(24)
@pytest.mark.parametrize("file", PROBLEMS, ids=lambda file: file.stem)
def test_what_is_evaluated_is_what_is_solved(file: Path) -> None:
    problem = read_file(file)
    working = VariantSolver(problem)
    if not working.branches[0].trusted:
        pytest.skip("every variant of it is solved anew")
    random, evaluated = Random(file.stem), 0
    for tried in range(MOST_TRIES):
        if tried >= TRIES and evaluated:
            break
        settings = changed(problem, random)
        try:
            worked = working.work(settings)
        except Unsuited:
            continue
        if worked.solution is None:
            fresh = solve(file, settings=settings, confirm=evaluated == 0)  # one of them is confirmed too
            assert [said(answer) for answer in worked.answers] == [said(answer) for answer in fresh.derivation.answers]
            assert all(check.holds is not False for check in fresh.checks)
            evaluated += 1
    assert evaluated or not [given for given in problem.givens if not given.automatic and not given.asked]
