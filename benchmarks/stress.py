"""Whether every printed figure is right, and every scene ends soon: nasty parameters, and scenes made at random.

    python benchmarks/stress.py [--space] [--scenes N] [--seed S] [--jobs J] [--time-limit SECONDS] [--failures FOLDER] [--write]

Families of problems are solved at parameters over 24 decades, nearly equal masses, angles near the vertical, long chains; random scenes
are put together from the tables of the language. Each number is held against one worked out without rotsolve (mpmath, 150 figures),
each printed equation against the answers, and the answers against those of the same scene in other units, order, names, or in a mirror.
A scene with a fault is written into FOLDER, as small as leaving out lines makes it. `--write` puts the tables into docs/benchmarks.md.
`--space` solves the families in space alone, which have a section of their own: what is withheld there is a number that the confirmation
keeps back, and that is held against the independent one all the same.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from report import machine, write_section
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.pipeline import solve
from trials.crew import run_all
from trials.elements import files
from trials.families import FAMILIES, Row, tried
from trials.families_in_space import IN_SPACE
from trials.outcome import outcome
from trials.scene import Scene, read, written
from trials.shrink import shrunk
from trials.trial import Result, drawn, run

HEAD = "## Right figures: `python benchmarks/stress.py`"
HEAD_IN_SPACE = "## Right figures in space: `python benchmarks/stress.py --space`"
WITHHELD = (
    "Withheld is what `rotsolve solve` refuses since the assembly, which works in floats, contradicts it; without the confirmation it is "
    "printed, and was held against the independent number too."
)


@dataclass
class Tally:
    """What became of the random scenes."""

    seeds: dict[int, int] = field(default_factory=dict)  # scenes run, by seed
    outcomes: Counter[tuple[str, str]] = field(default_factory=Counter)
    numbers: int = 0
    faulty: int = 0
    hangs: int = 0
    times: list[float] = field(default_factory=list)

    def take(self, seed: int, result: Result) -> None:
        group = result.kind if result.kind in ("built", "altered") else "kinds with known answers"
        self.seeds[seed] = self.seeds.get(seed, 0) + 1
        self.outcomes[group, result.outcome] += 1
        self.numbers += result.checked
        self.faulty += bool(result.faults)
        self.hangs += result.outcome == "hang"
        self.times.append(result.seconds)


def random_scenes(options: argparse.Namespace, tally: Tally) -> None:
    """Run the random scenes; what is found is printed at once, and written as a scene."""
    started = time.monotonic()
    numbers = range(options.first, options.first + options.scenes)
    for result in run_all(run, options.seed, numbers, options.jobs, options.time_limit):
        tally.take(options.seed, result)
        if result.faults:
            report_fault(options, result)
        done = len(tally.times)
        if done % 1000 == 0:
            print(f"{done} scenes, {tally.faulty} with faults, {time.monotonic() - started:.0f} s", flush=True)


def report_fault(options: argparse.Namespace, result: Result) -> None:
    """Print what is wrong, and write a scene that shows it."""
    print(f"\nscene {result.number} of seed {options.seed}, {result.kind}: {result.outcome}", flush=True)
    for fault in result.faults[:4]:
        print(f"  {fault}")
    options.failures.mkdir(parents=True, exist_ok=True)
    text = result.text or written(drawn(options.seed, result.number)[1].scene)
    if result.outcome == "internal":
        cause = result.faults[-1].partition(":")[0]
        text = written(shrunk(read(text), lambda scene: fails(scene, cause)))
    file = options.failures / f"{options.seed}-{result.number}.yaml"
    file.write_text(
        "".join(f"# {line}\n" for fault in result.faults for line in fault.splitlines()) + text, encoding="utf-8"
    )
    print(f"  {file}", flush=True)


def fails(scene: Scene, cause: str) -> bool:
    found = outcome(written(scene))
    return found.kind == "internal" and found.message.startswith(cause)


def cost_of_answers() -> str:
    """What it costs to certify six digits of the closed forms of all problems: CPU time each."""
    times = []
    for file in files():
        if "problems" not in file.parts:
            continue
        solution = solve(file)
        values = {given.name: given.value for given in solution.derivation.givens if given.value is not None}
        for answer in solution.derivation.answers:
            formula = answer.formula
            if formula is None or answer.value is None or not formula.symbols() <= values.keys():
                continue
            start = time.process_time()
            for _ in range(5):
                evaluate(formula, values).figures(6)
            times.append((time.process_time() - start) / 5)
    middle, nine = sorted(times)[len(times) // 2], sorted(times)[len(times) * 9 // 10]
    return f"Six certified digits of a closed form: median {1e6 * middle:.0f} µs, nine of ten within {1e6 * nine:.0f} µs, of {len(times)}."


def family_table(rows: list[Row]) -> str:
    lines = [
        "| family | parameters | cases | numbers | wrong | withheld | slowest, CPU |",
        "| --- | --- | ---: | ---: | ---: | ---: | ---: |",
    ]
    for row in rows:
        counts = f"{row.cases} | {row.numbers} | {row.wrongs} | {row.withheld} | {1000 * row.slowest:.0f} ms"
        lines.append(f"| {row.family.name} | {row.family.parameters} | {counts} |")
    return "\n".join(lines)


def scene_table(tally: Tally) -> str:
    kinds = sorted({kind for kind, _ in tally.outcomes})
    names = [
        name
        for name in ("solved", "objected", "unsolvable", "not yet", "bad", "internal", "hang")
        if any(tally.outcomes[kind, name] for kind in kinds)
    ]
    lines = [f"| random scenes | {' | '.join(names)} |", f"| --- |{' ---: |' * len(names)}"]
    lines += [f"| {kind} | {' | '.join(str(tally.outcomes[kind, name]) for name in names)} |" for kind in kinds]
    return "\n".join(lines)


def summary(tally: Tally) -> str:
    """How many scenes of which seeds, and the slowest."""
    seeds = ", ".join(f"{count} of seed {seed}" for seed, count in tally.seeds.items())
    return (
        f"{len(tally.times)} random scenes ({seeds}), {tally.numbers} numbers held against an independent one: "
        f"{tally.faulty} with a fault, {tally.hangs} hung; the slowest took {max(tally.times, default=0):.1f} s of CPU."
    )


def families_in_space(write: bool) -> int:
    """Solve the families in space, print or write their table, and tell whether a figure was wrong."""
    rows = [tried(family) for family in IN_SPACE]
    page = "\n\n".join((HEAD_IN_SPACE, machine(), family_table(rows), WITHHELD))
    print(page)
    if write:
        write_section("stress_in_space", page)
    return int(any(row.wrongs for row in rows))


def main() -> None:
    """Run the families, then the random scenes, and print or write the tables."""
    parser = argparse.ArgumentParser(description="Whether every printed figure is right.")
    parser.add_argument("--scenes", type=int, default=2000, help="random scenes (2000)")
    parser.add_argument("--seed", type=int, default=1, help="of the random scenes (1)")
    parser.add_argument("--first", type=int, default=0, help="number of the first random scene (0)")
    parser.add_argument("--jobs", type=int, default=2, help="processes (2)")
    parser.add_argument("--time-limit", type=float, default=10.0, help="seconds that a scene may take (10)")
    parser.add_argument("--failures", type=Path, default=Path("stress-failures"), help="where scenes with faults go")
    parser.add_argument("--space", action="store_true", help="the families in space, and nothing else")
    parser.add_argument("--write", action="store_true", help="write the tables into docs/benchmarks.md")
    options = parser.parse_args()
    if options.space:
        sys.exit(families_in_space(options.write))
    rows = [tried(family) for family in FAMILIES]
    tally = Tally()
    random_scenes(options, tally)
    page = "\n\n".join((HEAD, machine(), family_table(rows), scene_table(tally), summary(tally), cost_of_answers()))
    print(page)
    if options.write:
        write_section("stress", page)
    sys.exit(1 if tally.faulty or any(row.wrongs for row in rows) else 0)


if __name__ == "__main__":
    main()
