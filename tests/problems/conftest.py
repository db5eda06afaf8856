"""Bundled problems: which there are, and `--regenerate` for their golden derivations."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROBLEMS = sorted((ROOT / "problems").rglob("*.yaml"))


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--regenerate", action="store_true", help="write the golden derivations anew instead of comparing")


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "problem_file" in metafunc.fixturenames:
        metafunc.parametrize("problem_file", PROBLEMS, ids=[file.stem for file in PROBLEMS])


@pytest.fixture
def regenerate(request: pytest.FixtureRequest) -> bool:
    return bool(request.config.getoption("--regenerate", default=False))
