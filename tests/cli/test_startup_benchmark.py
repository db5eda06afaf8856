"""The benchmark of the start-up: its table, and one short run."""

from __future__ import annotations

import subprocess
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "startup.py"


@pytest.fixture
def startup() -> ModuleType:
    spec = spec_from_file_location("startup", SCRIPT)
    assert spec is not None and spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_a_ratio_is_the_median_of_the_ratios_within_a_round(startup: ModuleType) -> None:
    times = {"slow": [2.0, 40.0, 3.0], "base": [1.0, 10.0, 1.0]}
    assert startup.ratio(times, "slow", "base") == 3.0


def test_the_commands_take_turns_and_the_first_round_does_not_count(
    startup: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    order: list[str] = []

    def seconds(command: list[str]) -> float:
        order.append(command[0])
        return float(len(order))

    monkeypatch.setattr(startup, "seconds", seconds)
    assert startup.measure({"a": ["a"], "b": ["b"]}, 2) == {"a": [3.0, 5.0], "b": [4.0, 6.0]}
    assert order == ["a", "b"] * 3


def test_the_table_is_aligned(startup: ModuleType) -> None:
    assert startup.table([("process", "ms"), ("a", "12")]) == "process  ms\na        12"


def test_a_short_run_prints_both_tables() -> None:
    done = subprocess.run([sys.executable, str(SCRIPT), "--rounds", "1"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "× import sympy" in done.stdout
    assert "equations written" in done.stdout
