"""The benchmark of cold runs: its steps are those of a run, and make it up."""

from __future__ import annotations

from pathlib import Path

import startup

ROOT = Path(__file__).resolve().parents[2]


def test_the_steps_of_a_run_follow_each_other_and_make_it_up() -> None:
    taken = startup.steps(ROOT / "problems" / "pulleys" / "block-on-disc.yaml", 1)
    assert [step for step, _ in taken][-2:] == [startup.MODULES, "solving and printing, once all is loaded"]
    assert len(taken) == startup.STEPS.count("mark(") and all(time > 0 for _, time in taken)
