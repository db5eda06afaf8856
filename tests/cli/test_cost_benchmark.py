"""The benchmark of costs: its arithmetic, and short runs of its parts."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "benchmarks"))

from costs import processes  # noqa: E402
from costs.machines import MACHINES, chain, page  # noqa: E402
from costs.tables import above, below, exponent, share, table  # noqa: E402
from rotsolve import solve  # noqa: E402


def test_the_table_is_markdown_in_even_columns() -> None:
    assert table(("what", "ms"), [("a", "12"), ("long", "3")]) == (
        "| what | ms |\n| ---- | -: |\n| a    | 12 |\n| long |  3 |"
    )


def test_targets_say_whether_they_are_met() -> None:
    assert below("a", 0.4, 0.4) == ("a", "≤ 0.40", "0.40", True, "")
    assert above("b", 9, 10, why="c is slow") == ("b", "≥ 10", "9", False, "c is slow")


def test_growth_is_the_power_and_a_share_of_values_lies_below() -> None:
    assert exponent([1, 10, 100], [3, 300, 30000]) == pytest.approx(2)
    assert (share(range(100), 0.5), share(range(100), 0.9), share([7], 0.9)) == (50, 90, 7)


def test_ratios_are_taken_within_a_batch(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine that becomes twice as slow from one batch to the next changes no ratio."""
    clock = {"slowness": 0.5}

    def seconds(command: list[str]) -> float:
        if command[-1] == "pass":
            clock["slowness"] *= 2
        return clock["slowness"] * {"pass": 1, "import sympy": 10}.get(command[-1], 4)

    monkeypatch.setattr(processes, "seconds", seconds)
    monkeypatch.setattr(processes, "run", lambda command: None)
    found = processes.ratios({str(number): ["solve"] for number in range(20)}, 2)
    assert {(row.bare, row.sympy) for row in found.values()} == {(4, 0.4)}


def test_the_stages_and_imports_of_a_process_are_read() -> None:
    file = ROOT / "problems" / "pulleys" / "block-on-disc.yaml"
    spent, packages = processes.stages(file), processes.imports(file)
    assert {*processes.OF_RUN} <= spent.keys()
    assert {"rotsolve", "flint", "yaml", "msgspec", "standard library"} <= packages.keys()
    assert all(value >= 0 for value in (*spent.values(), *packages.values()))


@pytest.mark.parametrize("machine", MACHINES[:3], ids=lambda machine: machine.name)
def test_solvers_agree_on_a_machine(machine: object) -> None:
    """SymPy's, Lagrange's and Kane's accelerations are those of the derivation."""
    pytest.importorskip("sympy")
    from costs import equations

    number = next(place for place, one in enumerate(MACHINES) if one is machine)
    made = equations.system(MACHINES[number])
    values = [equations.timed(solver, number, made, 1, sys.path)[1] for solver in equations.SOLVERS]
    assert values == pytest.approx([values[0]] * len(values), rel=1e-9)


def test_chains_and_pages_are_what_they_say() -> None:
    assert solve(chain(3)).answers["a"].exact == "g R² (m₂ − m₁)/(3 I₁ + m₁ R² + m₂ R²)"
    assert len(solve(chain(2, apart=True)).answers) == 7
    assert len(solve(page(4)).problem.bodies) == 8


@pytest.mark.parametrize("words", [["chain", "3"], ["page", "20"]])
def test_a_process_of_its_own_tells_what_it_measured(words: list[str]) -> None:
    command = [sys.executable, str(ROOT / "benchmarks" / "cost.py"), "--measure", *words]
    found = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)
    assert {"read", "solve", "render", "memory", "equations"} == found.keys()
    assert found["read"] > 0 and found["solve"] > 0


def test_a_quick_part_prints_its_targets_and_writes_nothing(tmp_path: Path) -> None:
    document = ROOT / "docs" / "benchmarks.md"
    before = document.read_bytes() if document.exists() else b""
    command = [sys.executable, str(ROOT / "benchmarks" / "cost.py"), "--quick", "--rounds", "1", "--only", "sets"]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=True)
    assert "### Many sets of givens" in done.stdout
    assert "| target " in done.stdout
    assert (document.read_bytes() if document.exists() else b"") == before
