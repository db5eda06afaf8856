"""One solve in a process of its own: `python -m precision.worker PROBLEM PEER SETTING [again]`, answered as JSON."""

from __future__ import annotations

import json
import resource
import sys
from time import process_time

from .peers.ours import ways
from .problems import PROBLEMS

LIMIT = 30  # seconds of the processor, after which the system ends the process
ENOUGH, MOST = (
    0.3,
    20,
)  # seconds, and solves, after which the marginal time is known well enough: a slow solve is not repeated


def main(name: str, peer: str, setting: str, again: str = "") -> None:
    """Solve, print the answers, and where `again` is said the least time of further solves."""
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 1))
    problem = PROBLEMS[name]
    solve = ways(problem)[peer].solve
    begin = process_time()
    answers = solve(problem, setting)
    times = [process_time() - begin]
    while again and sum(times) < ENOUGH and len(times) < MOST:
        begin = process_time()
        solve(problem, setting)
        times.append(process_time() - begin)
    print(json.dumps({"answers": answers, "marginal": min(times)}))


if __name__ == "__main__":
    main(*sys.argv[1:])
