"""Growth: how time and memory grow with a chain of pulleys, one of hinged rods, and what stands beside the scene that is asked."""

from __future__ import annotations

import json
import re
import resource
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from time import process_time

from costs.clock import best
from costs.machines import chain, page, rods
from costs.processes import run
from costs.tables import Part, below, exponent, table

CHAINS, PAGES, RODS = (1, 2, 5, 10, 20, 50, 100), (1, 10, 100, 1000), (1, 2, 3, 5, 10, 20)
TEN = RODS.index(10)
ASYMPTOTIC = 10  # sizes from here on count for the power
SCENES: dict[str, Callable[[int], str]] = {"chain": chain, "page": page, "rods": rods}

WHOLE = "each part of the page is looked at for faults before what is asked is cut out of it"


def measure(kind: str, size: int) -> dict[str, float]:
    """Milliseconds and MiB of one scene, in this process, which must be fresh."""
    from rotsolve import solve
    from rotsolve.pipeline import solve_problem
    from rotsolve.scene.read import read_text

    solve(page(1)).to("text")  # all that has to be imported
    before = peak()
    text = SCENES[kind](size)
    start = process_time()
    problem = read_text(text)
    read = process_time() - start
    start = process_time()
    solution = solve_problem(problem)
    first = process_time() - start
    start = process_time()
    solution.to("text")
    render = process_time() - start
    solved = best(lambda: solve_problem(problem), 5) if kind == "page" else first
    return {
        "read": 1000 * read,
        "solve": 1000 * solved,
        "render": 1000 * render,
        "memory": peak() - before,
        "equations": solution.derivation.equations_written,
    }


def peak() -> float:
    """The most memory that this process has had, in MiB; the system's own count begins with what the process was started from."""
    status = Path("/proc/self/status")
    if status.exists():
        return int(re.findall(r"^VmHWM:\s+(\d+) kB$", status.read_text(encoding="ascii"), re.MULTILINE)[0]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (1024 if sys.platform != "darwin" else 1024**2)


def grown(kind: str, sizes: Sequence[int]) -> list[dict[str, float]]:
    """The measurements of each size, each in a process of its own."""
    command = [sys.executable, sys.argv[0], "--measure"]
    return [json.loads(run([*command, kind, str(size)]).stdout) for size in sizes]


def part(quick: bool) -> Part:
    """The tables with the powers fitted, and the targets."""
    chains, pages = (CHAINS[:5], PAGES[:3]) if quick else (CHAINS, PAGES)
    long, linked, wide = grown("chain", chains), grown("rods", RODS), grown("page", pages)
    late = [index for index, size in enumerate(chains) if size >= ASYMPTOTIC]
    power = exponent([chains[index] for index in late], [long[index]["solve"] for index in late])
    memory = exponent([chains[index] for index in late], [long[index]["memory"] for index in late])
    reading = exponent(pages[1:], [one["read"] for one in wide[1:]])
    ratio = wide[-1]["solve"] / wide[1]["solve"]
    text = "\n\n".join(
        [
            "Two blocks on one string over a chain of pulleys, the acceleration asked; processor time in ms, memory in MiB above "
            "that of a small scene.",
            table(("pulleys", "read", "solve", "render", "memory", "equations"), rows(chains, long)),
            f"From {ASYMPTOTIC} pulleys on the time to solve grows with the power {power:.2f} of their number, memory with {memory:.2f}.",
            "A chain of hinged rods, all different and turning; all accelerations and all joint forces asked. What no page holds in "
            "letters is solved together with the numbers.",
            table(("rods", "read", "solve", "render", "memory", "equations"), rows(RODS, linked)),
            "A page of independent scenes (a block on a disc), the acceleration in the first asked; `solve` is the best of 5 once read.",
            table(("scenes", "read", "solve", "render", "memory", "equations"), rows(pages, wide)),
            f"Reading grows with the power {reading:.2f}; solving takes {ratio:.1f} × as long for {pages[-1]} scenes as for {pages[1]}.",
        ]
    )
    return Part(
        "Growth",
        text,
        (
            below("chain of n pulleys: the power with which time grows", power, 2),
            below("ten hinged rods, all joint forces, ms", linked[TEN]["solve"], 1000, "{:.0f}"),
            below(f"page of {pages[-1]} scenes, × a page of {pages[1]}, once read", ratio, 3, "{:.1f}", WHOLE),
        ),
    )


def rows(sizes: Sequence[int], found: Sequence[dict[str, float]]) -> list[list[str]]:
    return [
        [str(size), *(f"{one[name]:.1f}" for name in ("read", "solve", "render", "memory")), f"{one['equations']:.0f}"]
        for size, one in zip(sizes, found, strict=True)
    ]
