"""What rotsolve costs: whole processes, a problem more in one process, symbolic solving, growth, many sets of givens.

    python benchmarks/cost.py [--space] [--quick] [--rounds N] [--only PART ...] [--print]

It takes SymPy and NumPy (`pip install -e '.[test]'`), prints tables with the targets that are met and not met, and writes all of it into
its section of docs/benchmarks.md, unless it is quick, partial, or told to print alone. `--space` measures scenes in space beside those in
the plane, and writes that into a section of its own. All times are processor times.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable
from pathlib import Path

from costs import equations, growth, in_space, problems, processes, sets
from costs.tables import Part, Target, table
from report import machine, write_section

PROBLEMS = Path(__file__).resolve().parent.parent / "problems"
SAMPLE = 10  # problem files of a quick run
LIMIT = {True: 10.0, False: 60.0}  # seconds after which another solver is given up, quick or not
PARTS: dict[str, Callable[[argparse.Namespace], Part]] = {
    "processes": lambda told: processes.part(files(told.quick), PROBLEMS, told.rounds),
    "problems": lambda told: problems.part(files(told.quick), PROBLEMS, told.rounds),
    "equations": lambda told: equations.part(LIMIT[told.quick], 5 if told.quick else equations.RUNS),
    "growth": lambda told: growth.part(told.quick),
    "sets": lambda told: sets.part(PROBLEMS, 10**5 if told.quick else 10**6),
}


def files(quick: bool) -> list[Path]:
    """The problem files; a sample of them, the block on a disc first, where it is to be quick."""
    every = sorted(PROBLEMS.glob("*/*.yaml"))
    known = PROBLEMS / "pulleys" / "block-on-disc.yaml"
    return [known, *every[:: len(every) // SAMPLE]][:SAMPLE] if quick else every


def groups(quick: bool) -> dict[str, list[Path]]:
    """The problem files in the plane and in space; a sample of each where it is to be quick."""
    every = sorted(PROBLEMS.glob("*/*.yaml"))
    space = [file for file in every if file.parent.name == "space"]
    plane = [file for file in every if file.parent.name != "space"]
    step = len(space) // SAMPLE if quick else 1
    return {"in the plane": plane[::step], "in space": space[::step]}


def measured(words: list[str]) -> object:
    """What a process of its own measures for one of the parts."""
    kind, *rest = words
    return problems.measure([Path(word) for word in rest]) if kind == "problems" else growth.measure(kind, int(rest[0]))


def page(parts: list[Part], title: str = "Cost", option: str = "") -> str:
    """The section: the machine, the targets, then part by part."""
    targets = [target for part in parts for target in part.targets]
    missed = [f"- {target.what}: {target.why}." for target in targets if not target.met and target.why]
    blocks = [
        f"## {title}",
        f"`python benchmarks/cost.py{option}`, {machine()}",
        table(("target", "wanted", "reached", ""), [row(target) for target in targets]),
        *(["What keeps the others from being met:", "\n".join(missed)] if missed else []),
        *(block for part in parts for block in (f"### {part.title}", part.text)),
    ]
    return "\n\n".join(blocks)


def row(target: Target) -> tuple[str, str, str, str]:
    return target.what, target.wanted, target.reached, "met" if target.met else "not met"


def main() -> None:
    """Measure what is asked for, print it, and write the section of a whole run."""
    parser = argparse.ArgumentParser(description="What rotsolve costs.")
    parser.add_argument(
        "--space", action="store_true", help="scenes in space beside those in the plane, and nothing else"
    )
    parser.add_argument("--quick", action="store_true", help="a sample of the problems, smaller sizes, shorter limits")
    parser.add_argument("--rounds", type=int, default=3, help="how often each thing is measured (3)")
    parser.add_argument("--only", nargs="+", choices=PARTS, default=list(PARTS), metavar="PART", help=", ".join(PARTS))
    parser.add_argument("--print", action="store_true", help="leave docs/benchmarks.md as it is")
    parser.add_argument("--measure", nargs="+", help=argparse.SUPPRESS)
    told = parser.parse_args()
    if told.measure:
        print(json.dumps(measured(told.measure)))
        return
    if told.space:
        text = page([in_space.part(groups(told.quick), PROBLEMS, told.rounds)], "Cost in space", " --space")
        print(text)
        if not (told.quick or told.print):
            write_section("cost_in_space", text)
        return
    parts = []
    for name in told.only:
        print(f"measuring {name} …", file=sys.stderr, flush=True)
        parts.append(PARTS[name](told))
    text = page(parts)
    print(text)
    if not (told.quick or told.print) and told.only == list(PARTS):
        write_section("cost", text)


if __name__ == "__main__":
    main()
