"""No module is imported that a scene does not use: what five typical runs load, held against what each should.

What all five load is the core. `expected/imports.txt` says what each loads beside it.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
EXPECTED = Path(__file__).parent / "expected" / "imports.txt"
RUNS = {  # by what is typical of it
    "block on a disc": ("pulleys/block-on-disc.yaml",),
    "rod from an angle": ("hinged/rod-30.yaml",),
    "small swings": ("swings/marble-swings-in-bowl.yaml",),
    "function of time, as JSON": ("kinematics/wheel-angle-polynomial.yaml", "--format", "json"),
    "inside a rod, as LaTeX": ("inside-a-body/whirled-rod.yaml", "--format", "latex"),
}
NEVER = {"sympy", "mpmath", "numpy", "scipy", "rich", "matplotlib", "pebble", "multiprocessing", "unittest", "asyncio"}
PACKAGES = {"flint", "msgspec", "yaml"}
WITHOUT = {  # what a block on a disc has no use for
    "rotsolve.equations.swing",
    "rotsolve.equations.equilibrium",
    "rotsolve.questions.functions_of_time",
    "rotsolve.search.extrema",
    "rotsolve.search.letterspace",
    "rotsolve.search.friction",
    "rotsolve.search.conditions",
    "rotsolve.search.swings",
    "rotsolve.search.choices",
    "rotsolve.motion.cuts",
    "rotsolve.laws.integration",
    "rotsolve.laws.oscillation",
    "rotsolve.laws.kinematics",
    "rotsolve.laws.momentum",
    "rotsolve.laws.inertia",
    "rotsolve.page.json",
    "rotsolve.page.latex",
    "rotsolve.page.markdown",
    "rotsolve.page.press",
    "rotsolve.page.terminal",
    "rotsolve.page.typst",
    "rotsolve.run.processes",
    "rotsolve.run.profiled",
}
TOLD = """\
import atexit, json, sys
atexit.register(lambda: print(json.dumps(sorted(sys.modules)), file=sys.stderr))
from rotsolve.cli import main
main(["solve", *sys.argv[1:]])
"""


@cache
def loaded(run: str) -> frozenset[str]:
    """The modules that a whole run has loaded at its end."""
    file, *options = RUNS[run]
    done = subprocess.run(
        [sys.executable, "-c", TOLD, str(PROBLEMS / file), *options],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "PYTHONIOENCODING": "utf-8"},
    )
    assert done.returncode == 0, done.stderr
    return frozenset(json.loads(done.stderr))


def own(run: str) -> set[str]:
    return {name for name in loaded(run) if name.startswith("rotsolve.")}


@pytest.mark.parametrize("run", RUNS)
def test_a_run_loads_no_package_that_it_does_not_use(run: str) -> None:
    packages = {name.partition(".")[0] for name in loaded(run)}
    assert not packages & NEVER
    assert packages >= PACKAGES


def test_a_plain_scene_loads_no_module_of_other_scenes() -> None:
    mine = own("block on a disc")
    assert not {name for name in mine for part in WITHOUT if name == part or name.startswith(f"{part}.")}
    for part in WITHOUT:
        path = Path(PROBLEMS.parent, *part.split("."))
        assert path.is_dir() or path.with_suffix(".py").is_file(), f"{part} is no module any more"


def test_each_run_loads_what_it_needs_beside_the_core(expected: Callable[[Path, str], None]) -> None:
    core = set.intersection(*map(own, RUNS))
    text = "\n".join(f"{run}\n" + "".join(f"  {name}\n" for name in sorted(own(run) - core)) for run in RUNS)
    expected(EXPECTED, text)
