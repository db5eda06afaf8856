"""The bytecode of what every run loads, kept in one piece: it says what the sources say, and holds no more than runs need."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import rotsolve

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
IN_THE_PLANE, IN_SPACE = PROBLEMS / "pulleys" / "block-on-disc.yaml", PROBLEMS / "space" / "leaning-top.yaml"
LIST = "from rotsolve.together import KEPT\nprint(*(file for file, marks, code in KEPT), sep='\\n')"
Run = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package that nobody has run."""
    folder = tmp_path_factory.mktemp("copy")
    source = Path(rotsolve.__file__).parent
    shutil.copytree(source, folder / "rotsolve", ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def python(copy: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    given = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    command, at = [sys.executable, *arguments], {**given, "PYTHONPATH": str(copy)}
    return subprocess.run(command, cwd=copy, env=at, capture_output=True, text=True, check=False)


def solved(copy: Path, *files: Path) -> subprocess.CompletedProcess[str]:
    return python(copy, "-c", "from rotsolve.start import process; process()", "solve", *map(str, files))


def kept(copy: Path) -> set[str]:
    """The modules in the piece."""
    found = python(copy, "-c", LIST)
    assert found.returncode == 0, found.stderr
    return {Path(file).relative_to(copy).as_posix() for file in found.stdout.split()}


def test_what_runs_load_is_kept_in_one_piece_and_follows_the_sources(copy: Path, tmp_path: Path) -> None:
    assert kept(copy) == set(), "of the source alone nothing is kept"
    wrong = tmp_path / "wrong.yaml"
    wrong.write_text("title: nothing\n")
    assert solved(copy, wrong).returncode == 2 and kept(copy) == set(), "a run that solves nothing keeps nothing"

    first = solved(copy, IN_SPACE)
    begun = kept(copy)
    assert first.returncode == 0 and any("space" in name for name in begun)
    plane = solved(copy, IN_THE_PLANE)
    common = kept(copy)
    assert common < begun and not any(name.startswith("rotsolve/space/") for name in common)
    assert (solved(copy, IN_SPACE).stdout, solved(copy, IN_THE_PLANE).stdout) == (first.stdout, plane.stdout)
    assert kept(copy) == common, "what all runs need stays"
    assert "rotsolve/together.py" not in begun | common, "the piece is no part of itself"

    source = copy / "rotsolve" / "plan.py"
    source.write_text(source.read_text(encoding="utf-8") + "\nprint('changed')\n", encoding="utf-8")
    assert solved(copy, IN_THE_PLANE).stdout == "changed\n" + plane.stdout
    assert "rotsolve/plan.py" in kept(copy), "a source that has changed begins a new piece"
    moved = copy.parent / "moved"
    shutil.move(copy, moved)
    assert solved(moved, IN_THE_PLANE).stdout == "changed\n" + plane.stdout, (
        "a piece that was moved is of no use, and does no harm"
    )
