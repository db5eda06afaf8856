"""One solve in a process of its own: `python -m precision.worker PROBLEM PEER SETTING [again]`, answered as JSON."""

from __future__ import annotations

import json
import resource
import sys
from time import process_time

from .peers.ours import ways
from .problems import PROBLEMS

LIMIT = 15  # seconds of the processor, after which the system ends the process
SLOW = 1.5  # seconds, from which on a solve is not repeated
ENOUGH, MOST = 0.3, 1000  # seconds, and further solves, after which their mean time is known well enough


def main(name: str, peer: str, setting: str, again: str = "") -> None:
    """Solve and print the answers; where `again` is said also what a further solve takes, and how many were made."""
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 1))
    problem = PROBLEMS[name]
    solve = ways(problem)[peer].solve
    begin = process_time()
    answers = solve(problem, setting)
    marginal, repeats = process_time() - begin, 0
    if again and marginal < SLOW:
        begin = process_time()
        while process_time() - begin < ENOUGH and repeats < MOST:
            solve(problem, setting)
            repeats += 1
        marginal = (process_time() - begin) / repeats
    print(json.dumps({"answers": answers, "marginal": marginal, "repeats": repeats}))


if __name__ == "__main__":
    main(*sys.argv[1:])
