"""The stress suite finds what is wrong, and a short run of it finds nothing: `python benchmarks/stress.py` is the long one."""

from __future__ import annotations

import random
import time
from dataclasses import replace
from itertools import islice
from pathlib import Path

import pytest
from mpmath import mp, mpf
from msgspec.structs import replace as changed

from rotsolve.algebra.notation.parse import parse
from rotsolve.pipeline import solve
from rotsolve.solution import Solution
from trials.alike import mirrored, renamed, reordered, scaled
from trials.case import Family
from trials.crew import run_all
from trials.evaluate import Unknown, value
from trials.families import FAMILIES, Row, judged, tried
from trials.families_in_space import IN_SPACE
from trials.figures import wrong
from trials.held import faults
from trials.outcome import Printed, outcome, printed_answers
from trials.scene import read, written
from trials.shrink import shrunk
from trials.trial import Result, run

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
ATWOOD = (PROBLEMS / "pulleys" / "atwood.yaml").read_text(encoding="utf-8")
CASES = 2  # of each family


@pytest.mark.parametrize("number", range(20))
def test_random_scenes_have_no_fault(number: int) -> None:
    result = run(20, number)
    assert not result.faults, "\n".join((*result.faults, result.text))


@pytest.mark.sampled(4)
@pytest.mark.parametrize("family", (*FAMILIES, *IN_SPACE), ids=lambda family: family.name)
def test_families_have_no_wrong_figure(family: Family) -> None:
    row = tried(replace(family, cases=lambda: islice(family.cases(), 0, 2 * CASES, 2)))
    assert row.numbers and not row.wrongs


def test_what_the_confirmation_withholds_is_told_and_judged_all_the_same() -> None:
    """The assembly follows a top that spins with 10¹² rad/s in floats, and contradicts its period, which is right."""
    name = "top let go, slow and fast"
    family = next(family for family in IN_SPACE if family.name == name)
    (case,) = islice(family.cases(), 12, 13)
    row = Row(family)
    assert not list(judged(row, case, written(case.scene), 6))
    assert (row.numbers, row.withheld > 0) == (4, True)
    case.expected["T"] *= 2
    assert [fault.partition(":")[0] for fault in judged(row, case, written(case.scene), 6)] == ["T"]


def test_a_wrong_figure_is_found() -> None:
    assert not wrong(Printed("4.356"), mpf("4.35555555"), 4)
    assert wrong(Printed("4.355"), mpf("4.35555555"), 4)
    assert wrong(Printed("4.5"), mpf("4.500001"), 4), "4.5 is not 4.500: it says that the number ends there"
    assert wrong(Printed("0"), mpf("1e-30"), 4)
    assert not wrong(Printed("", "no number: division by zero"), mpf(1), 4)


def test_a_false_equation_is_found() -> None:
    solution = solve(PROBLEMS / "pulleys" / "block-on-disc.yaml")
    answers = printed_answers(solution, 4)
    assert not list(faults(solution, answers, 4))
    found = list(faults(turned(solution), answers, 4))
    assert any("does not hold" in fault for fault in found), found


def turned(solution: Solution) -> Solution:
    """The solution with the sign of one side of its laws turned."""
    section, *others = solution.derivation.sections
    laws = tuple(changed(law, equation=changed(law.equation, left=-law.equation.left)) for law in section.laws)
    return changed(solution, derivation=changed(solution.derivation, sections=(changed(section, laws=laws), *others)))


def test_what_cancels_down_to_its_roundings_is_nothing() -> None:
    """M − c ω of a flywheel that has turned for ever is no number to take the logarithm of; a difference of 10⁻²⁴ is one."""
    rest = parse("log(M - c*omega)")
    with mp.workdps(150):
        omega = mpf(1) / 3
        with pytest.raises(Unknown):
            value(rest, {"M": mpf(1), "c": mpf(3), "omega": omega * (1 - mpf(10) ** -140)})
        assert abs(value(rest, {"M": mpf(1), "c": mpf(3), "omega": omega * (1 - mpf(10) ** -24)}) + 24 * mp.log(10)) < 1


def test_a_scene_said_otherwise_is_the_same_scene() -> None:
    scene, chance = read(ATWOOD), random.Random(1)
    base = outcome(written(scene)).answers
    for other in (reordered(scene, chance), renamed(scene, chance)):
        again = outcome(written(other)).answers
        assert {name: item.text for name, item in again.items()} == {name: item.text for name, item in base.items()}
    larger = outcome(written(scaled(scene, (6, -3, 2)))).answers  # masses, lengths, times
    assert base["a"].number and larger["a"].number == base["a"].number / 10**7
    sliding = read((PROBLEMS / "rolling" / "ball-on-incline.yaml").read_text(encoding="utf-8"))
    assert mirrored(sliding) is None or mirrored(sliding) != sliding


def test_a_scene_is_shrunk_to_what_shows_the_fault() -> None:
    small = shrunk(read(ATWOOD), lambda scene: "connections" in scene and len(scene["connections"]) > 0)
    assert set(small) <= {"title", "connections"}


def stuck(seed: int, number: int) -> Result:
    if number == 1:
        time.sleep(60)
    return Result(number, "kind", "solved", 0.0, (), "")


def test_a_trial_that_hangs_is_ended_and_the_rest_goes_on() -> None:
    results = {result.number: result.outcome for result in run_all(stuck, 0, range(4), jobs=2, limit=1.0)}
    assert results == {0: "solved", 1: "hang", 2: "solved", 3: "solved"}
