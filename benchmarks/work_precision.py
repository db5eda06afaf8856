"""Run time against error: rotsolve beside scipy, mpmath, sympy, heyoka, MuJoCo and pymunk, against references of 60 digits.

    pip install -e '.[bench]'
    python benchmarks/work_precision.py [--space] [--quick] [--rounds N] [--write] [--references] [PROBLEM ...]

A whole run, of all problems in the plane or with `--space` of all in space, writes its section of docs/benchmarks.md and two pictures
beside it; a quick one, with one setting for each peer, or one of chosen problems, only prints, unless `--write` is said. `--references`
makes the references anew, by two routes that must agree.
"""

from __future__ import annotations

import argparse

from precision.measure import Row, measure
from precision.page import in_space, section, targets, versions
from precision.picture import draw
from precision.problem import Problem
from precision.problems import IN_PLANE, IN_SPACE, PROBLEMS
from precision.reach import milliseconds
from precision.references.make import make, references
from report import DOCS, machine, write_section

PICTURES = {"": True, "-warm": False}  # by the end of their names: whole processes, or one more solve


def run(problems: list[Problem], rounds: int, quick: bool) -> list[Row]:
    """Measure the problems, and print each row when its problem is done."""
    rows: list[Row] = []
    kept = references()
    for problem in problems:
        print(f"\n{problem.title}", flush=True)
        for row in measure(problem, kept[problem.name], rounds, quick):
            rows.append(row)
            told = (
                row.failed
                or f"error {row.error:.1e}  whole process {milliseconds(row.cpu)}  one more {milliseconds(row.marginal)}"
            )
            print(f"  {row.peer:16} {row.setting:8} {told}", flush=True)
    return rows


def main() -> None:
    """Measure, print, and write what a whole run found."""
    parser = argparse.ArgumentParser(description="Run time against error.")
    parser.add_argument("problems", nargs="*", metavar="PROBLEM", help=f"of {', '.join(PROBLEMS)} (all)")
    parser.add_argument("--space", action="store_true", help="the problems in space, which have a section of their own")
    parser.add_argument("--quick", action="store_true", help="one setting for each peer, one round")
    parser.add_argument("--rounds", type=int, default=2, help="how often each whole process runs (2)")
    parser.add_argument("--write", action="store_true", help="write the section of docs/benchmarks.md after any run")
    parser.add_argument("--references", action="store_true", help="make the references anew, and stop")
    options = parser.parse_args()
    if unknown := [name for name in options.problems if name not in PROBLEMS]:
        parser.error(f"no problem {', '.join(unknown)}; there are {', '.join(PROBLEMS)}")
    if options.references:
        make(options.problems or PROBLEMS)
        return
    chosen = [PROBLEMS[name] for name in options.problems] or list(IN_SPACE if options.space else IN_PLANE)
    rounds = 1 if options.quick else max(1, options.rounds)
    print(f"{machine()}; {versions()}")
    rows = run(chosen, rounds, options.quick)
    print("\n" + "\n".join(targets(chosen, rows)))
    if options.write or not (options.quick or options.problems):
        name = "work-precision-in-space" if in_space(chosen) else "work-precision"
        pictures = {f"{name}{end}.svg": whole for end, whole in PICTURES.items()}
        for picture, whole in pictures.items():
            draw(chosen, rows, DOCS / picture, whole)
        write_section(name.replace("-", "_"), section(chosen, rows, rounds, list(pictures)))


if __name__ == "__main__":
    main()
