"""The README: its set-up commands work in a fresh environment, and everything that it shows is what is printed.

The second set-up command runs the whole test suite, this file among it. Here it is run with one smoke test chosen, so that
it installs and runs, without running itself again; that all tests are collected in a fresh clone is seen where CI runs it.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
SMOKE = "tests/cli/test_cli_words.py::test_version_is_printed"
LEFT_OUT = shutil.ignore_patterns(".*_cache", ".git", ".venv", ".hypothesis", "__pycache__", "*.egg-info")
OFFLINE = ("Temporary failure in name resolution", "NewConnectionError", "Network is unreachable")


def blocks(language: str) -> list[str]:
    """The fenced blocks of one language, in order."""
    return re.findall(rf"^```{language}\n(.*?)^```$", README, flags=re.MULTILINE | re.DOTALL)


def shell(command: str, folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run a line of the README as a newcomer would, with python3 being this Python."""
    binaries = folder / "bin"
    binaries.mkdir(exist_ok=True)
    python3 = binaries / "python3"
    if not python3.exists():
        python3.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
        python3.chmod(0o755)
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("PYTEST", "VIRTUAL_ENV"))}
    path = f"{binaries}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["sh", "-c", command],
        cwd=folder / "clone",
        env={**kept, "PATH": path, "PIP_DISABLE_PIP_VERSION_CHECK": "1", **environment},
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    if any(sign in done.stderr for sign in OFFLINE) and not os.environ.get("CI"):
        pytest.skip("no package index can be reached")
    return done


def test_readme_has_two_set_up_commands() -> None:
    assert len(blocks("sh")) == 2


def test_the_commands_work_in_a_fresh_clone(tmp_path: Path) -> None:
    """One after the other, as a newcomer types them: the first prints the derivation that is shown, the second runs tests."""
    shutil.copytree(ROOT, tmp_path / "clone", ignore=LEFT_OUT)
    done = shell(blocks("sh")[0], tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout == blocks("text")[0]
    done = shell(blocks("sh")[1], tmp_path, PYTEST_ADDOPTS=SMOKE, PYTEST_XDIST_AUTO_NUM_WORKERS="1")
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"\b1 passed\b", done.stdout), done.stdout


def test_shown_derivation_is_what_is_printed() -> None:
    command = blocks("sh")[0].strip().rpartition("&& .venv/bin/rotsolve ")[2].split()
    done = subprocess.run(
        [sys.executable, "-m", "rotsolve", *command], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.stdout == blocks("text")[0], done.stderr


def test_shown_scene_is_the_bundled_one() -> None:
    """Its lines stand in the bundled file in this order; the file may say more, such as its source."""
    bundled = iter((ROOT / "problems" / "pulleys" / "block-on-disc.yaml").read_text(encoding="utf-8").splitlines())
    for line in blocks("yaml")[0].splitlines():
        assert line in bundled, f"not in problems/pulleys/block-on-disc.yaml, or out of order: {line}"


def test_shown_python_runs(tmp_path: Path) -> None:
    for number, block in enumerate(blocks("python")):
        script = tmp_path / f"block{number}.py"
        script.write_text(block, encoding="utf-8")
        done = subprocess.run([sys.executable, str(script)], cwd=ROOT, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


def test_every_link_leads_to_a_file() -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", README):
        assert "://" in target or (ROOT / target).exists(), target


def test_ci_runs_the_commands_of_the_readme() -> None:
    script = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    install, tests = (part.partition("bin/")[2] for part in blocks("sh")[1].strip().split(" && ")[1:])
    assert install.partition(" ")[2].removeprefix("install -q ") in script
    assert f"\n{tests}\n" in script
