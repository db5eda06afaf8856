"""Papers in a stream: how many are marked in a second by this process and by so many workers, and what the command holds of them."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

from msgspec import Struct

from costs.tables import table
from report import machine

PROBLEM = Path(__file__).resolve().parents[2] / "problems" / "pulleys" / "block-on-disc.yaml"
ANSWERS = ("2mg/(2m+M)", "g/(1+M/(2m))", "m g/(m+M)", "9.8 m/s²", "2mg/(2m+M")
TENSIONS = ("m(g-a)", "10.9 N", "m g", "12 N")
WORKERS = (1, 2)


class Measured(Struct, frozen=True):
    """A run of the command: its papers, its seconds, and the most memory that it had, in MB."""

    papers: int
    seconds: float
    memory: float

    @property
    def rate(self) -> str:
        return f"{self.papers / self.seconds:.0f}"


def write_papers(file: Path, count: int) -> None:
    """Papers with right and wrong answers, of which hardly two are alike."""
    random = Random(count)
    with file.open("w", encoding="utf-8") as stream:
        stream.write("name,a,alpha,T,working\n")
        for number in range(count):
            alpha = f"{random.uniform(1, 40):.5f} rad/s²"
            working = "m g - T = m a" if number % 4 == 0 else ""
            stream.write(f"S{number},{random.choice(ANSWERS)},{alpha},{random.choice(TENSIONS)},{working}\n")


def marked_stream(papers: Path, count: int, *words: str) -> Measured:
    """The command for these papers, measured from its start to its end."""
    command = [sys.executable, "-m", "rotsolve", "check", str(PROBLEM), str(papers), "-o", f"{papers}.marks.csv"]
    start = time.perf_counter()
    process = subprocess.Popen([*command, *words], stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode > 1:
        raise RuntimeError(f"the command ended with {process.returncode}")
    kilobytes = used.ru_maxrss / 1024 if sys.platform == "darwin" else used.ru_maxrss
    return Measured(count, time.perf_counter() - start, kilobytes / 1024)


def by_workers(files: Mapping[int, Path], workers: int) -> list[Measured]:
    """The same by so many workers of this machine, which have solved the problem before."""
    from distributed import LocalCluster

    options = {"n_workers": workers, "threads_per_worker": 1, "processes": True, "dashboard_address": ":0"}
    with LocalCluster(**options, silence_logs=50) as cluster:
        there = ("--cluster", cluster.scheduler_address)
        marked_stream(files[min(files)], min(files), *there)
        return [marked_stream(file, count, *there) for count, file in files.items()]


def stream_page(*counts: int) -> str:
    """The section with its table."""
    with TemporaryDirectory() as folder:
        files = {count: Path(folder, f"{count}.csv") for count in counts}
        for count, file in files.items():
            write_papers(file, count)
        found = {"this process": [marked_stream(file, count) for count, file in files.items()]}
        for workers in WORKERS:
            found[f"{workers} {'worker' if workers == 1 else 'workers'}"] = by_workers(files, workers)
    rows = [
        (by, str(run.papers), f"{run.seconds:.1f}", run.rate, f"{run.memory:.0f}")
        for by, runs in found.items()
        for run in runs
    ]
    return "\n\n".join(
        (
            "## Papers in a stream",
            f"`python benchmarks/checking.py --papers {max(counts)}`, {machine()}",
            "Papers of which hardly two are alike, marked into a table of marks, from the start of the command to its end, "
            "and the most memory that the command itself had. Workers are processes of the same machine.",
            table(("marked by", "papers", "seconds", "papers a second", "MB"), rows),
        )
    )
