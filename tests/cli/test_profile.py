"""`--profile`: where the time of a run went, and what was skipped."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from rotsolve import cli, profile
from rotsolve.profile import IMPORT, of_kind, recording, stage, staged
from rotsolve.run.profiled import STAGES, modules

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
PAGE = """\
given: {m: 2 kg, M: 5 kg, R: 0.2 m}
bodies:
  block: {mass: m, moves: down}
  disc: {shape: disc, mass: M, radius: R}
  wheel: {shape: ring, mass: M, radius: R}
connections: {axle: {axle: disc}, string: {string: [disc, block]}, pin: {axle: wheel}}
actions: {motor: {couple: 2 N m, on: wheel}}
find: {a: block.acceleration}
"""


class Clock:
    """A processor whose time passes when it is told to."""

    now = 0.0

    def __call__(self) -> float:
        return self.now

    def passes(self, seconds: float) -> None:
        self.now += seconds


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(profile, "process_time", clock)
    return clock


def test_a_stage_within_another_takes_its_time_from_it(clock: Clock) -> None:
    with recording() as seen, stage("outer"):
        clock.passes(1)
        with stage("inner"):
            clock.passes(2)
        clock.passes(4)
    assert seen.spent == {"outer": 5, "inner": 2}


def test_what_is_whole_keeps_the_stages_within_it_save_imports(clock: Clock) -> None:
    with recording() as seen, stage("verify", whole=True):
        clock.passes(1)
        with stage("plan"), stage("laws"):
            clock.passes(2)
        with seen.stage(IMPORT, True):
            clock.passes(4)
    assert seen.spent == {"verify": 3, IMPORT: 4}


def test_a_kind_of_work_counts_once_and_beside_the_stages(clock: Clock) -> None:
    @of_kind("certification")
    def certify(depth: int) -> None:
        clock.passes(1)
        if depth:
            certify(depth - 1)

    @staged("solve")
    def work() -> None:
        clock.passes(8)
        certify(2)

    with recording() as seen:
        work()
    work()
    assert (seen.spent, seen.within) == ({"solve": 11}, {"certification": 3})


def test_nothing_is_kept_while_nobody_asks() -> None:
    assert stage("read") is profile.NOTHING
    before = __import__
    with recording():
        assert __import__ is not before
    assert __import__ is before


def told(*arguments: str, folder: Path) -> tuple[str, str]:
    done = subprocess.run(
        [sys.executable, "-m", "rotsolve", "solve", *arguments, "--profile"],
        cwd=folder,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout, done.stderr


def test_the_stages_add_up_to_the_whole(tmp_path: Path) -> None:
    out, err = told(str(PROBLEMS / "pulleys" / "block-on-disc.yaml"), folder=tmp_path)
    assert out.startswith("Block hanging")
    whole = float(re.findall(r"^Processor time of 1 file: ([\d.]+) ms$", err, re.M)[0])
    rows = re.findall(r"^  (\w+) +(-?[\d.]+) ms +-?\d+%  ", err, re.M)
    assert [name for name, _ in rows] == [name for name, _ in STAGES]
    assert sum(float(spent) for _, spent in rows) == pytest.approx(whole, rel=0.01, abs=1)
    assert all(float(spent) >= 0 for _, spent in rows)
    assert re.search(r"^  of which [\d.]+ ms certification$", err, re.M)


def test_what_was_skipped_is_said(tmp_path: Path) -> None:
    (tmp_path / "page.yaml").write_text(PAGE, encoding="utf-8")
    _, err = told("page.yaml", folder=tmp_path)
    skipped = err.partition("Skipped\n")[2]
    assert "  bodies: wheel\n" in skipped
    assert re.search(r"^  equations: \d+ of \d+ serve as checks alone$", skipped, re.M)
    assert "rotsolve.arrays" in skipped
    assert "  packages: sympy, numpy, rich, matplotlib, pebble\n" in skipped


def test_all_modules_are_known() -> None:
    loaded, there = modules()
    assert {"rotsolve", "rotsolve.cli", "rotsolve.run.profiled"} <= set(loaded) <= set(there)


def test_it_looks_at_one_process(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        cli.main(["solve", "a.yaml", "--profile", "--jobs", "2"])
    assert left.value.code == 2
    assert "it looks at one process" in " ".join(capsys.readouterr().err.split())
