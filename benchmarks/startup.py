"""What a cold start costs: whole processes, as multiples of the bare interpreter and of `import sympy`, in one run.

    python benchmarks/startup.py [--rounds N] [SCENE ...]

The commands take turns (A B C A B C …), so that a machine that slows down slows all of them; each ratio is the median of the
ratios within a round. For every scene it also says how many equations were written and how many the plan used.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path
from statistics import median
from time import perf_counter

PROBLEMS = Path(__file__).resolve().parent.parent / "problems"
SCENES = ("pulleys/block-on-disc.yaml", "pulleys/atwood.yaml", "hinged/rod-30.yaml")
# An installed package has its bytecode; a checkout run with this variable set would be compiled anew in every process.
KEEPING_BYTECODE = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
BARE, SYMPY = "python -c pass", 'python -c "import sympy"'


def commands(scenes: list[Path]) -> dict[str, list[str]]:
    """What is timed, by the name under which it is printed."""
    rotsolve = [sys.executable, "-m", "rotsolve"]
    return {
        BARE: [sys.executable, "-c", "pass"],
        SYMPY: [sys.executable, "-c", "import sympy"],
        "rotsolve --help": [*rotsolve, "--help"],
        **{f"rotsolve solve {scene.name}": [*rotsolve, "solve", str(scene)] for scene in scenes},
    }


def seconds(command: list[str]) -> float:
    """Wall time of one whole process, which must succeed."""
    start = perf_counter()
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=False, env=KEEPING_BYTECODE)
    took = perf_counter() - start
    if done.returncode:
        sys.exit(f"{' '.join(command)} failed:\n{done.stderr.decode(errors='replace')}")
    return took


def measure(timed: dict[str, list[str]], rounds: int) -> dict[str, list[float]]:
    """The seconds of each command in each round; a first round, which fills the caches, does not count."""
    times: dict[str, list[float]] = {name: [] for name in timed}
    for number in range(rounds + 1):
        for name, command in timed.items():
            took = seconds(command)
            if number:
                times[name].append(took)
    return times


def ratio(times: dict[str, list[float]], name: str, base: str) -> float:
    """The median over the rounds of one command's time divided by another's."""
    return median(mine / other for mine, other in zip(times[name], times[base], strict=True))


def counts(scene: Path) -> tuple[int, int]:
    """How many equations the laws wrote for a scene, and how many the plan used."""
    command = [sys.executable, "-m", "rotsolve", "solve", str(scene), "--format", "json"]
    data = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)
    return data["equations_written"], data["equations_used"]


def table(rows: list[tuple[str, ...]]) -> str:
    """Rows as text, the first column left and the others right."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join(
        "  ".join(
            cell.ljust(width) if not index else cell.rjust(width)
            for index, (cell, width) in enumerate(zip(row, widths, strict=True))
        )
        for row in rows
    )


def main() -> None:
    """Measure and print both tables."""
    parser = argparse.ArgumentParser(description="What a cold start of rotsolve costs.")
    parser.add_argument("scenes", nargs="*", type=Path, help="scene files (three of problems/ where none is named)")
    parser.add_argument("--rounds", type=int, default=11, help="how often each command runs (11)")
    options = parser.parse_args()
    scenes: list[Path] = options.scenes or [PROBLEMS / name for name in SCENES]
    times = measure(commands(scenes), max(1, options.rounds))
    head: tuple[str, ...] = ("process", "ms", "× bare", "× import sympy")
    rows = [
        (name, f"{1000 * median(took):.0f}", f"{ratio(times, name, BARE):.1f}", f"{ratio(times, name, SYMPY):.2f}")
        for name, took in times.items()
    ]
    version = ".".join(map(str, sys.version_info[:3]))
    print(f"Python {version}, {os.cpu_count()} cores, {max(1, options.rounds)} rounds, medians\n")
    print(table([head, *rows]))
    print()
    print(
        table([("scene", "equations written", "used"), *[(scene.name, *map(str, counts(scene))) for scene in scenes]])
    )


if __name__ == "__main__":
    main()
