"""Where the time of a cold run goes: `python benchmarks/startup.py [FILE …] [--rounds N]` writes a section of docs/benchmarks.md.

A whole process beside the bare interpreter and `import sympy`, in turns; then its steps one after the other, as `rotsolve solve` takes
them in a process of its own. Processor time, medians over the rounds.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from statistics import median

from costs.processes import ratios, run
from costs.tables import below, table
from report import machine, write_section

PROBLEMS = Path(__file__).resolve().parents[1] / "problems"
USUAL = ("pulleys/block-on-disc", "hinged/rod-30", "inertia/pencil", "rolling/ball-with-back-spin", "space/leaning-top")
OF_SYMPY, OF_BARE = 0.28, 9.0  # at most of these is wanted of the first file
COMMAND = [sys.executable, "-c", "from rotsolve.start import process; process()", "solve"]
STEPS = """\
import sys, time
marks = [("Python itself", time.process_time())]
def mark(step): marks.append((step, time.process_time()))
import gc; gc.set_threshold(100_000)
import re, typing, contextlib, fractions
mark("standard library: re, typing, fractions and what these load")
from rotsolve.lean import leave_out, take_together
leave_out()
import msgspec
mark("msgspec and PyYAML, as far as they are needed")
import rotsolve.algebra.flints
mark("the types of FLINT that are needed")
take_together()
mark("bytecode of what all runs load, in one piece")
from rotsolve.run import SolveRequest, solve_files
request = SolveRequest((sys.argv[1],), width=120)
solve_files(request)
mark("")
solve_files(request)
mark("solving and printing, once all is loaded")
import json
print(json.dumps(marks), file=sys.stderr)
"""
MODULES = "modules of rotsolve, and what the first solve takes longer"


def steps(file: Path, rounds: int) -> list[tuple[str, float]]:
    """The steps of a run with their milliseconds, medians over the rounds; what the second solve takes is none of the modules'."""
    taken: dict[str, list[float]] = {}
    for _ in range(rounds):
        marks = json.loads(run([sys.executable, "-c", STEPS, str(file)]).stderr.splitlines()[-1])
        times = [1000 * time for _, time in marks]
        spent = {step: now - last for (step, _), now, last in zip(marks, times, (0.0, *times), strict=False)}
        last, again = spent.popitem()
        spent |= {MODULES: spent.pop("") - again, last: again}
        for step, time in spent.items():
            taken.setdefault(step, []).append(time)
    return [(step, median(times)) for step, times in taken.items()]


def section(files: list[Path], rounds: int) -> str:
    """The section of the page."""
    found = ratios({file.stem: [*COMMAND, str(file)] for file in files}, rounds)
    first = found[files[0].stem]
    targets = (
        below(f"{files[0].stem}, × `import sympy`", first.sympy, OF_SYMPY),
        below(f"{files[0].stem}, × bare interpreter", first.bare, OF_BARE),
    )
    rows = [(name, f"{1000 * one.seconds:.1f}", f"{one.bare:.1f}", f"{one.sympy:.2f}") for name, one in found.items()]
    parts = steps(files[0], rounds)
    whole = sum(time for _, time in parts)
    lines = [(step, f"{time:.1f}", f"{time / whole:.0%}") for step, time in parts]
    wanted = [(name, bound, reached, "met" if met else "not met") for name, bound, reached, met, _ in targets]
    return "\n\n".join(
        (
            "## Cold runs",
            f"`python benchmarks/startup.py`, {machine()}",
            table(("target", "wanted", "reached", ""), wanted),
            table(("whole process", "ms", "× bare", "× sympy"), rows),
            f"The steps of {files[0].stem}:",
            table(("step", "ms", "share"), lines),
        )
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", type=Path, default=[PROBLEMS / f"{name}.yaml" for name in USUAL])
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--dry-run", action="store_true", help="print the section, and leave the page as it is")
    asked = parser.parse_args()
    text = section(asked.files, asked.rounds)
    print(text)
    if not asked.dry_run:
        write_section("cold_runs", text)


if __name__ == "__main__":
    main()
