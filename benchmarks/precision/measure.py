"""Measure: every peer at every setting on a problem, in turns, each in whole processes of its own."""

from __future__ import annotations

import json
import os
import resource
import signal
import subprocess
import sys
from collections.abc import Iterator
from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path
from statistics import median
from time import perf_counter
from typing import NamedTuple

from .peers.ours import command, ways
from .problem import FLOATS, Problem, Way
from .worker import LIMIT

BENCHMARKS = Path(__file__).resolve().parent.parent
STUCK = 600.0  # seconds by the clock, after which a process that does not even calculate is ended
# An installed package has its bytecode; a checkout run with this variable set would be compiled anew in every process.
KEEPING_BYTECODE = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}


class Cost(NamedTuple):
    """Seconds of one process: by the clock, and of the processor (user and system)."""

    wall: float
    cpu: float


class Row(NamedTuple):
    """What a peer made of a problem at a setting."""

    problem: str
    peer: str
    setting: str
    failed: str = ""
    error: float = float("inf")  # of the worst of the asked quantities
    errors: tuple[float, ...] = ()
    bounds: tuple[float, ...] = ()  # claimed by ours
    drift: float | None = None  # of the energy, where it is conserved
    marginal: float = float("inf")  # seconds of the processor for one more solve in the process
    colds: tuple[Cost, ...] = ()  # whole processes

    @property
    def cpu(self) -> float:
        """Processor time of a whole process: the median."""
        return median(cost.cpu for cost in self.colds) if self.colds else float("inf")

    @property
    def wall(self) -> float:
        """Wall time of a whole process: the median."""
        return median(cost.wall for cost in self.colds) if self.colds else float("inf")


def used() -> float:
    """Processor time of all processes that this one has waited for."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def worker(row: Row, *more: str) -> list[str]:
    """A script in Python that solves with a peer."""
    return [sys.executable, "-m", "precision.worker", row.problem, row.peer, row.setting, *more]


def cold(problem: Problem, row: Row) -> list[str]:
    """The whole process that is timed: our own command, a script for a peer."""
    return command(problem, row.setting) if row.peer == "rotsolve" else worker(row)


def process(command: list[str]) -> tuple[Cost, str, str]:
    """One process: its cost, its output, and why it failed."""
    wall, cpu = perf_counter(), used()
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, check=False, timeout=STUCK, cwd=BENCHMARKS, env=KEEPING_BYTECODE
        )
    except subprocess.TimeoutExpired:
        return Cost(perf_counter() - wall, used() - cpu), "", "stuck"
    cost = Cost(perf_counter() - wall, used() - cpu)
    if done.returncode == -signal.SIGXCPU:
        return cost, "", f"given up after {LIMIT} s"
    # Of a traceback the line that names the error: what is indented says where.
    lines = [line for line in done.stderr.splitlines() if line.strip() and not line.startswith(" ")]
    return cost, done.stdout, (lines or [f"exit code {done.returncode}"])[-1] if done.returncode else ""


def installed(way: Way) -> bool:
    """Whether all that a way needs can be imported here."""
    return all(find_spec(package) is not None for package in way.packages)


def first_row(problem: Problem, reference: tuple[Fraction, ...], peer: str, setting: str) -> Row:
    """The answers of a peer and their errors, and what a further solve costs."""
    row = Row(problem.name, peer, setting)
    cost, output, failed = process(worker(row, "again"))
    if failed:
        return row._replace(failed=failed, colds=(cost,))
    told = json.loads(output)
    claims = [answer if isinstance(answer, list) else (answer, "0") for answer in told["answers"]]
    values, bounds = zip(*claims, strict=True)
    errors = [abs(exactly(value) - true) for value, true in zip(values, reference, strict=True)]
    sizes = [1 if problem.simulated else abs(true) for true in reference]
    relative = tuple(float(error / size) for error, size in zip(errors, sizes, strict=True))
    return row._replace(
        error=max(relative),
        errors=relative,
        bounds=tuple(float(Fraction(bound) / size) for bound, size in zip(bounds, sizes, strict=True))
        if peer == "rotsolve"
        else (),
        drift=drift(problem, values),
        marginal=told["marginal"],
        # A script that solved only once, since that took long, was a whole process already.
        colds=() if told["repeats"] or peer == "rotsolve" else (cost,),
    )


def exactly(value: str | float) -> Fraction:
    """An answer as the number that it is; what is none is infinitely far off."""
    try:
        return Fraction(value)
    except (ValueError, OverflowError):
        return Fraction(10) ** 300


def drift(problem: Problem, values: tuple[str | float, ...]) -> float | None:
    """How far the energy at the end is from that at the start."""
    if problem.energy is None or problem.motion is None:
        return None
    start = problem.motion.read(problem.motion.start(FLOATS), FLOATS.pi)
    return abs(problem.energy([float(value) for value in values]) - problem.energy(start))


def measure(problem: Problem, reference: tuple[Fraction, ...], rounds: int, least: bool) -> Iterator[Row]:
    """All rows of a problem; `least` takes the second setting of each peer alone. The cold runs take turns."""
    rows = []
    for peer, way in ways(problem).items():
        if installed(way):
            settings = way.settings[1:2] or way.settings if least else way.settings
            rows += [first_row(problem, reference, peer, setting) for setting in settings]
    timed = [index for index, row in enumerate(rows) if not row.colds]
    for _ in range(rounds):
        for index in timed:
            row = rows[index]
            rows[index] = row._replace(colds=(*row.colds, process(cold(problem, row))[0]))
    yield from rows
