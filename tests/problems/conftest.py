"""Bundled problems: which there are."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROBLEMS = sorted((ROOT / "problems").rglob("*.yaml"))


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "problem_file" in metafunc.fixturenames:
        metafunc.parametrize("problem_file", PROBLEMS, ids=[file.stem for file in PROBLEMS])
