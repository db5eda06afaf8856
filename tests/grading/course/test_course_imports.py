"""What marking one answer imports: nothing that a class, another format or the command line's parser needs, and no SymPy."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
EXPECTED = Path(__file__).parent / "expected" / "imports.txt"
SCENE = str(ROOT / "problems" / "pulleys" / "block-on-disc.yaml")
NEVER = {
    "sympy",
    "mpmath",
    "numpy",
    "scipy",
    "rich",
    "matplotlib",
    "pebble",
    "multiprocessing",
    "typer",
    "click",
    "csv",
}
WITHOUT = (  # what one right answer has no use for
    "rotsolve.cli",
    "rotsolve.keys",
    "rotsolve.simulation",
    "rotsolve.grading.mistakes",
    "rotsolve.grading.course.many",
    "rotsolve.grading.course.report.folder",
    "rotsolve.grading.course.report.summary",
    "rotsolve.grading.course.table",
    "rotsolve.page.html",
    "rotsolve.page.json",
    "rotsolve.page.latex",
    "rotsolve.page.markdown",
    "rotsolve.page.terminal",
)
TOLD = """\
import atexit, json, sys
atexit.register(lambda: print(json.dumps(sorted(sys.modules)), file=sys.stderr))
from rotsolve.start import main
main()
"""


def loaded(*words: str) -> set[str]:
    """The modules that a run has loaded at its end."""
    code = TOLD.replace("import atexit", f"import sys; sys.argv[1:] = {list(words)!r}\nimport atexit", 1)
    env = {**os.environ, "PYTHONIOENCODING": "utf-8", "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, env=env)
    assert done.returncode == 0, done.stderr
    return set(json.loads(done.stderr))


@pytest.fixture(scope="module")
def checked() -> set[str]:
    return loaded("check", SCENE, "--answer", "a = 2mg/(2m+M)")


def test_one_answer_loads_no_package_that_it_does_not_use(checked: set[str]) -> None:
    assert not {name.partition(".")[0] for name in checked} & NEVER


def test_one_answer_loads_no_module_of_other_commands(checked: set[str]) -> None:
    assert not {name for name in checked for part in WITHOUT if name == part or name.startswith(f"{part}.")}
    for part in WITHOUT:
        path = Path(ROOT, *part.split("."))
        assert path.is_dir() or path.with_suffix(".py").is_file(), f"{part} is no module any more"


def test_one_answer_loads_this_beside_what_solves_the_scene(
    checked: set[str], expected: Callable[[Path, str], None]
) -> None:
    found = sorted(name for name in checked - loaded("solve", SCENE) if name.startswith("rotsolve."))
    expected(EXPECTED, "".join(f"{name}\n" for name in found))


def test_a_paper_in_a_file_takes_the_same_way(tmp_path: Path) -> None:
    (tmp_path / "ada.txt").write_text("a = 2mg/(2m+M)\nα = a/R\nT = mMg/(2m+M)\n", encoding="utf-8")
    found = loaded("check", SCENE, str(tmp_path / "ada.txt"))
    assert not {name.partition(".")[0] for name in found} & NEVER
