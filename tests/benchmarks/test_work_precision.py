"""The work-precision benchmark: its references, its records and what it makes of its rows."""

from __future__ import annotations

import re
import subprocess
import sys
from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path

import pytest
from mpmath import mp

from precision.measure import Cost, Row, installed
from precision.page import section
from precision.peers.ours import ROOT, ways
from precision.problem import Problem
from precision.problems import PROBLEMS
from precision.reach import best_of_scipy, bounds, energy_drift, figures
from precision.references.make import agreeing, references
from precision.references.routes import ROUTES
from rotsolve.scene.read import read_file

DEAR = {
    "two-hinged-rods",
    "driven-pulley",
    "free-asymmetric-book",
    "book-1e-10-off-its-middle-axis",
    "heavy-top",
    "rolling-coin",
}  # routes that take minutes
ALL = list(PROBLEMS.values())


def row(peer: str, setting: str, error: float, seconds: float, problem: str = "two-hinged-rods", **more: object) -> Row:
    """A row that was measured."""
    made = Row(problem, peer, setting, error=error, errors=(error,), marginal=seconds, colds=(Cost(seconds, seconds),))
    return made._replace(**more)


@pytest.mark.parametrize("name", sorted(set(PROBLEMS) - DEAR))
def test_two_routes_agree_with_the_kept_reference(name: str) -> None:
    kept = references()[name]
    for value, reference in zip(agreeing(name, 40), kept, strict=True):
        assert abs(Fraction(value) - reference) <= abs(reference) * Fraction(10) ** -39


@pytest.mark.parametrize(("name", "route"), [("driven-pulley", 0), ("heavy-top", 1), ("rolling-coin", 1)])
def test_a_closed_form_is_the_kept_reference(name: str, route: int) -> None:
    with mp.workdps(60):
        values = ROUTES[name][route](PROBLEMS[name])
        for value, reference in zip(values, references()[name], strict=True):
            assert abs(Fraction(mp.nstr(value, 55)) / reference - 1) < Fraction(10) ** -45


@pytest.mark.parametrize("problem", ALL, ids=list(PROBLEMS))
def test_a_record_is_whole(problem: Problem) -> None:
    assert read_file(ROOT / problem.scene).title
    assert len(references()[problem.name]) == len(problem.asks)
    assert problem.name in ROUTES
    assert all(way.settings for way in ways(problem).values())
    assert (problem.motion is not None and bool(problem.until)) or not problem.simulated


@pytest.mark.parametrize("problem", [item for item in ALL if not item.simulated], ids=lambda problem: problem.name)
def test_what_is_solved_is_the_reference_to_every_digit(problem: Problem) -> None:
    for value, bound in ways(problem)["rotsolve"].solve(problem, "30"):
        assert abs(Fraction(value) - references()[problem.name][0]) <= Fraction(bound)


@pytest.mark.parametrize(
    ("name", "peer"), [("period-from-60-degrees", "mpmath quad"), ("mass-ratio-1e12", "mpmath lu_solve")]
)
def test_a_peer_comes_close_to_the_reference(name: str, peer: str) -> None:
    with mp.workdps(15):
        (value,) = PROBLEMS[name].peers[peer].solve(PROBLEMS[name], "30")
    assert abs(Fraction(value) / references()[name][0] - 1) < Fraction(10) ** -25


@pytest.mark.parametrize("name", ["free-asymmetric-book", "heavy-top", "rolling-coin"])
def test_kane_and_mujoco_follow_the_same_body_in_space(name: str) -> None:
    """A hundredth of a second, in coordinates of their own; a wrong start or frame would be far off."""
    pytest.importorskip("scipy")
    problem = PROBLEMS[name]._replace(until="0.01")
    peers = {peer: way for peer, way in problem.peers.items() if peer.startswith(("scipy DOP853", "sympy", "MuJoCo"))}
    told = {peer: way.solve(problem, way.settings[-1]) for peer, way in peers.items() if installed(way)}
    for values in told.values():
        # what MuJoCo has for a contact gives way a little
        assert values == pytest.approx(told["scipy DOP853"], abs=2e-2 if name == "rolling-coin" else 1e-6)


def test_a_quick_run_prints_rows_and_targets_and_says_what_is_not_installed() -> None:
    command = [sys.executable, str(ROOT / "benchmarks" / "work_precision.py"), "--quick", "mass-ratio-1e12"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert re.search(r"mpmath lu_solve +30 +error 1.2e-37", done.stdout)
    assert "| every printed digit of what is solved is right | 1 of 1 numbers | yes |" in done.stdout
    assert ("scipy not installed" in done.stdout) == (find_spec("scipy") is None)


def test_the_best_of_scipy_is_the_fastest_that_is_good_enough() -> None:
    slow, fast, rough = (
        row("scipy Radau", "1e-9", 1e-9, 2),
        row("scipy RK45", "1e-9", 5e-7, 1),
        row("scipy RK45", "1e-6", 1e-3, 0.5),
    )
    assert best_of_scipy([slow, fast, rough], 1e-6) is fast
    assert best_of_scipy([slow, fast, rough], 1e-12) is slow
    assert best_of_scipy([row("mpmath odefun", "15", 0, 1)], 1e-6) is None


def test_a_target_is_met_only_by_a_smaller_error_in_less_time() -> None:
    problem = PROBLEMS["two-hinged-rods"]
    theirs = row("scipy DOP853", "1e-12", 1e-10, 0.5)

    def met(*ours: Row) -> list[bool]:
        return [figure.met for figure in figures([problem], [*ours, theirs]) if "scipy" in figure.target]

    assert met(row("rotsolve", "1e-12", 1e-13, 0.2, bounds=(1e-12,))) == [True, True, True]
    assert met(row("rotsolve", "1e-9", 1e-11, 0.2, bounds=(1e-9,))) == [True, True, False]
    assert met(row("rotsolve", "1e-12", 1e-13, 0.6, bounds=(1e-12,))) == [False, False, False]


def test_bounds_must_hold_and_be_close() -> None:
    good, wide, wrong = (row("rotsolve", "1e-9", 1e-12, 1, bounds=(bound,)) for bound in (2e-12, 1e-9, 1e-13))
    assert [figure.met for figure in bounds([good])] == [True, True]
    assert [figure.met for figure in bounds([good, wide])] == [True, False]
    assert [figure.met for figure in bounds([good, wrong])] == [False, True]


def test_the_drift_is_compared_with_the_tightest_run() -> None:
    theirs = [row("scipy DOP853", setting, 1e-9, 1.0, drift=1e-12) for setting in ("1e-9", "2.3e-14")]
    assert energy_drift([row("rotsolve", "1e-9", 1e-12, 0.5, drift=1e-15), *theirs]).met
    assert not energy_drift([row("rotsolve", "1e-9", 1e-12, 0.5, drift=1e-13), *theirs]).met


def test_the_page_has_every_row_and_those_that_failed(tmp_path: Path) -> None:
    problem = PROBLEMS["two-hinged-rods"]
    rows = [
        row("rotsolve", "1e-9", 1e-11, 0.2, bounds=(1e-9,)),
        Row(problem.name, "mpmath odefun", "30", failed="given up"),
    ]
    text = section([problem], rows, 3, ["picture.svg"])
    assert "| rotsolve | accuracy 1e-9 | 1.0e-11 | 1.0e-09 | 200 ms |" in text
    assert "| mpmath odefun | digits 30 | given up |" in text


def test_problems_in_space_have_a_section_of_their_own() -> None:
    problem = PROBLEMS["rolling-coin"]
    rows = [row("MuJoCo RK4", "1e-3", 1e-2, 0.3, problem.name)]
    text = section([problem], rows, 3, ["picture.svg"])
    assert text.startswith("## Run time against error in space")
    assert "Of 4 problems 1 were run." in text
    assert "Not here: pymunk is planar" in text
