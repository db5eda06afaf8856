"""Whole processes, cold: as multiples of the bare interpreter and of `import sympy`, with where their time goes.

Processor time of the process and all that it starts; the commands take turns in short batches, each with its own bare interpreter
and its own `import sympy`, so that a machine that slows down slows all of them.
"""

from __future__ import annotations

import os
import re
import resource
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from statistics import mean, median
from typing import NamedTuple

from costs.tables import Part, below, share, table

BATCH = 8  # commands between two measurements of the bare interpreter
# An installed package has its bytecode; a checkout run with this variable set would be compiled anew in every process.
KEEPING_BYTECODE = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
BARE, SYMPY, HELP = "python -c pass", 'python -c "import sympy"', "rotsolve --help"
ROTSOLVE = [sys.executable, "-m", "rotsolve"]
STAGE = re.compile(r"^  (\w+) +(-?[\d.]+) ms +-?\d+%", re.MULTILINE)
IMPORTED = re.compile(r"^import time: +(\d+) \| +\d+ \| +(\S+)$", re.MULTILINE)
OF_RUN = ("start", "import", "read", "laws", "plan", "solve", "verify", "compose", "confirm", "render")
ASSEMBLY = "loading twenty modules of the assembly takes two thirds of it, what is worked out for an ordinary scene less than 1 ms"


class Ratios(NamedTuple):
    """Seconds of a process, as a multiple of the bare interpreter, and of `import sympy`."""

    seconds: float
    bare: float
    sympy: float


def seconds(command: Sequence[str]) -> float:
    """Processor time of one whole process, which must succeed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run(command)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def run(command: Sequence[str]) -> subprocess.CompletedProcess[str]:
    """The process, with what it printed; it must succeed, or say why it does not solve a scene."""
    done = subprocess.run(
        command, stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8", check=False, env=KEEPING_BYTECODE
    )
    if done.returncode:
        sys.exit(f"{' '.join(command)} failed:\n{done.stderr}")
    return done


def ratios(commands: Mapping[str, Sequence[str]], rounds: int) -> dict[str, Ratios]:
    """By name, medians over the rounds; what is run once before fills the caches."""
    found: dict[str, list[Ratios]] = {name: [] for name in commands}
    names = list(commands)
    for name in (*names[:BATCH], *names[::BATCH]):
        run(commands[name])
    for _ in range(rounds):
        for start in range(0, len(names), BATCH):
            bare = seconds([sys.executable, "-c", "pass"])
            sympy = seconds([sys.executable, "-c", "import sympy"])
            for name in names[start : start + BATCH]:
                took = seconds(commands[name])
                found[name].append(Ratios(took, took / bare, took / sympy))
    return {name: Ratios(*map(median, zip(*rows, strict=True))) for name, rows in found.items()}


def confirming(files: Sequence[Path], rounds: int) -> list[tuple[float, float]]:
    """By file, the milliseconds by which the confirmation makes a cold run longer, and the ratio: medians of pairs of runs in turns."""
    found = []
    for file in files:
        commands = [[*ROTSOLVE, "solve", str(file)], [*ROTSOLVE, "solve", "--no-confirm", str(file)]]
        pairs = [[seconds(command) for command in commands] for _ in range(rounds)]
        found.append((1000 * median(a - b for a, b in pairs), median(a / b for a, b in pairs)))
    return found


def stages(file: Path) -> dict[str, float]:
    """Milliseconds by stage, as `--profile` tells them."""
    told = run([*ROTSOLVE, "solve", str(file), "--profile"]).stderr
    return {name: float(spent) for name, spent in STAGE.findall(told)}


def imports(file: Path) -> Counter[str]:
    """Milliseconds of imports by package, as `-X importtime` tells them; that itself makes them slower."""
    told = run([sys.executable, "-X", "importtime", "-m", "rotsolve", "solve", str(file)]).stderr
    found: Counter[str] = Counter()
    for spent, module in IMPORTED.findall(told):
        package = module.partition(".")[0]
        found["standard library" if package in sys.stdlib_module_names else package] += int(spent) / 1000  # type: ignore[assignment]
    return found


def part(files: Sequence[Path], folder: Path, rounds: int) -> Part:
    """The tables of all files, and the targets."""
    commands = {str(file.relative_to(folder)): [*ROTSOLVE, "solve", str(file)] for file in files}
    found = ratios({BARE: [sys.executable, "-c", "pass"], HELP: [*ROTSOLVE, "--help"], **commands}, rounds)
    solved = [found[name] for name in commands]
    spent = {name: stages(folder / name) for name in commands}
    packages = [imports(folder / name) for name in commands]
    before = before_work(list(spent.values()))
    confirmed = confirming(files, rounds)
    longer, ratio = (median(column) for column in zip(*confirmed, strict=True))
    text = "\n\n".join(
        [
            f"Processor time, medians of {rounds} rounds. {len(files)} problem files: "
            f"median {median(row.bare for row in solved):.1f} × the bare interpreter ({1000 * found[BARE].seconds:.0f} ms) and "
            f"{median(row.sympy for row in solved):.2f} × `import sympy`, 90 % below {share([row.bare for row in solved], 0.9):.1f} × and "
            f"{share([row.sympy for row in solved], 0.9):.2f} ×; `--help` {found[HELP].bare:.1f} × and {found[HELP].sympy:.2f} ×.",
            f"The assembly that confirms answers, against `--no-confirm`: median {longer:.1f} ms, {ratio:.3f} ×; "
            f"90 % below {share([ms for ms, _ in confirmed], 0.9):.1f} ms.",
            "Imports by package, mean over the files, in ms with the cost of `-X importtime` itself:",
            table(("package", "ms"), list(by_package(packages))),
            f"{before[0].upper()}{before[1:]}.",
            "Stages by `--profile` in ms, `start` being the interpreter and the command line:",
            table(("file", "× bare", "× sympy", *OF_RUN), [row(name, found[name], spent[name]) for name in commands]),
        ]
    )
    return Part(
        "Whole processes, cold",
        text,
        (
            below("cold solve, × `import sympy` (median file)", median(row.sympy for row in solved), 0.4, why=before),
            below(
                "cold solve, × bare interpreter (median file)", median(row.bare for row in solved), 13, "{:.1f}", before
            ),
            below("confirmation, ms of a cold solve (median file)", longer, 2, "{:.1f}", ASSEMBLY),
            below("`--help`, × bare interpreter", found[HELP].bare, 8, "{:.1f}"),
        ),
    )


def before_work(spent: Sequence[Mapping[str, float]]) -> str:
    """How much of a cold solve is not solving."""
    shares = [(one["start"] + one["import"]) / sum(one.values()) for one in spent]
    return f"starting and importing take {median(shares):.0%} of the processor time of a file (median)"


def by_package(packages: Sequence[Counter[str]]) -> Iterator[tuple[str, str]]:
    names = {name for found in packages for name in found}
    means = {name: mean(found[name] for found in packages) for name in names}
    yield from (
        (name, f"{spent:.1f}") for name, spent in sorted(means.items(), key=lambda item: -item[1]) if spent >= 0.1
    )


def row(name: str, ratio: Ratios, spent: Mapping[str, float]) -> list[str]:
    return [name, f"{ratio.bare:.1f}", f"{ratio.sympy:.2f}", *(f"{spent.get(stage, 0):.1f}" for stage in OF_RUN)]
