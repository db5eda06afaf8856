"""How long the pictures of all bundled problems take: `python benchmarks/draw.py [--times N]`.

Each is drawn as SVG in one warm process, with what a page needs for it (places, marks, labels, text of the file); the least of N runs
counts, in milliseconds of processor time.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

from rotsolve.core.faults import Unsolvable
from rotsolve.draw.paper.svg import svg
from rotsolve.draw.pictures import free_body_picture, scene_picture
from rotsolve.language.problem import Problem
from rotsolve.scene.read import read_file

MOST = 30  # milliseconds of a picture
PROBLEMS = Path(__file__).parents[1] / "problems"


def least(draw: Callable[[], object], times: int) -> float | None:
    """The least time of several runs; None of what can not be drawn."""
    found = []
    for _ in range(times):
        start = time.process_time()
        try:
            draw()
        except Unsolvable:
            return None
        found.append(1000 * (time.process_time() - start))
    return min(found)


def report(kind: str, draw: Callable[[Problem], str], problems: dict[str, Problem], times: int) -> None:
    """The median and the slowest of one kind of picture."""
    found = {name: least(partial(draw, problem), times) for name, problem in problems.items()}
    taken = {name: ms for name, ms in found.items() if ms is not None}
    slow = sorted(taken.items(), key=lambda item: -item[1])[:3]
    above = sum(ms > MOST for ms in taken.values())
    print(f"{kind}: {len(taken)} pictures, median {statistics.median(taken.values()):.1f} ms, above {MOST} ms: {above}")
    print("  slowest: " + ", ".join(f"{name} {ms:.0f} ms" for name, ms in slow))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--times", type=int, default=3)
    times = parser.parse_args().times
    files = sorted(PROBLEMS.glob("*/*.yaml"))
    problems = {f"{file.parent.name}/{file.stem}": read_file(file) for file in files}
    report("scenes", lambda problem: svg(scene_picture(problem)), problems, times)
    report("free bodies", lambda problem: svg(free_body_picture(problem)), problems, times)


if __name__ == "__main__":
    main()
