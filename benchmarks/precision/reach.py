"""What was aimed at, and what came of it: each target with its figure, met or not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from .measure import Row
from .problem import Problem

LEVELS = {"1e-6": 1e-6, "1e-9": 1e-9, "1e-12": 1e-12}
TWO_RODS = 0.25  # seconds
HUNDRED = 100


class Figure(NamedTuple):
    """A target, what was measured, and what keeps it from being met where it is not."""

    target: str
    figure: str
    met: bool
    why: str = ""


def milliseconds(seconds: float) -> str:
    """A time with three digits: `0.12 ms`, `160 ms`, `9080 ms`."""
    return f"{1000 * seconds:.3g} ms" if seconds < 1 else f"{1000 * seconds:.0f} ms"


def told(row: Row) -> str:
    """`1.2e-9 in 160 ms (DOP853 at 1e-12)`."""
    return f"{row.error:.1e} in {milliseconds(row.cpu)} ({row.peer} at {row.setting})"


def best_of_scipy(rows: Sequence[Row], level: float) -> Row | None:
    """The fastest run of scipy that is as good as a level; where none is, the most accurate."""
    runs = [row for row in rows if row.peer.startswith("scipy") and not row.failed]
    good = [row for row in runs if row.error <= level]
    if good:
        return min(good, key=lambda row: row.cpu)
    return min(runs, key=lambda row: row.error, default=None)


def against_scipy(problem: Problem, rows: Sequence[Row]) -> Iterator[Figure]:
    """At each level: a run of ours with a smaller error in less time than the best of scipy."""
    ours = [row for row in rows if row.peer == "rotsolve" and not row.failed]
    for written, level in LEVELS.items():
        target = f"{problem.title}: smaller error in less time than the best of scipy at {written}"
        theirs = best_of_scipy(rows, level)
        if theirs is None:
            continue
        better = [row for row in ours if row.error < theirs.error and row.error <= level]
        if not better:
            yield Figure(target, f"none of ours has a smaller error of at most {written}; {told(theirs)}", False)
            continue
        mine = min(better, key=lambda row: row.cpu)
        yield Figure(target, f"{told(mine)}; {told(theirs)}", mine.cpu < theirs.cpu, by_its_parts(mine))


def by_its_parts(row: Row) -> str:
    """What a whole process of ours spends its time on."""
    start = max(0.0, row.cpu - row.marginal)
    return (
        f"{milliseconds(start)} go into starting, the other {milliseconds(row.marginal)} into compiling the laws and into more "
        "than one run, without which there would be no bound"
    )


def two_rods(rows: Sequence[Row]) -> Iterator[Figure]:
    """Two rods for 10 s to 1e-8 in 250 ms: as a whole process, and as one more motion in a process."""
    target = "two hinged rods for 10 s: an error of at most 1e-8 in a whole process of at most 250 ms"
    good = [row for row in rows if row.peer == "rotsolve" and row.error <= 1e-8]
    if not good:
        yield Figure(target, "no run of ours is so good", False)
        return
    best, warm = min(good, key=lambda row: row.cpu), min(good, key=lambda row: row.marginal)
    clock = f"{told(best)}, {milliseconds(best.wall)} by the clock"
    yield Figure(target, clock, best.cpu <= TWO_RODS, by_its_parts(best))
    figure = f"{warm.error:.1e} in {milliseconds(warm.marginal)} (at {warm.setting})"
    yield Figure("… and in at most 250 ms as one more motion in a process", figure, warm.marginal <= TWO_RODS)


def energy_drift(rows: Sequence[Row]) -> Figure:
    """The energy of the rod after 2000 s, against DOP853 at its tightest."""
    target = "a rod for 2000 s: energy drift at most 1e-14, in less time than DOP853 at its tightest"
    tightest = next((row for row in reversed(rows) if row.peer == "scipy DOP853" and not row.failed), None)
    good = [row for row in rows if row.peer == "rotsolve" and row.drift is not None and row.drift <= 1e-14]
    if tightest is None or not good:
        return Figure(target, "no run of ours drifts so little" if tightest else "scipy is not installed", False)
    best = min(good, key=lambda row: row.cpu)
    figure = (
        f"{best.drift:.1e} in {milliseconds(best.cpu)} (at {best.setting}, error {best.error:.1e}); DOP853: "
        f"{tightest.drift:.1e} in {milliseconds(tightest.cpu)} (error {tightest.error:.1e})"
    )
    return Figure(target, figure, best.cpu < tightest.cpu)


def bounds(rows: Sequence[Row]) -> Iterator[Figure]:
    """Every simulated number with the bound that it claims."""
    pairs = claims(rows)
    held = sum(error <= bound for error, bound in pairs)
    yield Figure("every simulated number's bound holds its true error", f"{held} of {len(pairs)}", held == len(pairs))
    # A number that happens to be exact has no ratio.
    ratios = sorted(bound / error for error, bound in pairs if error)
    if ratios:
        near = sum(ratio <= HUNDRED for ratio in ratios)
        figure = f"{near} of {len(ratios)}; median {ratios[len(ratios) // 2]:.0f} ×, largest {ratios[-1]:.0f} ×"
        why = (
            "a bound is six times the largest difference of the runs within a step of the moment asked; just there the true error may "
            "pass through nothing, or the compared run, whose data are rounded coarsely on purpose, is much farther off than the main one"
        )
        yield Figure("… and is at most 100 × the true error", figure, near == len(ratios), why)


def digits(rows: Sequence[Row]) -> Figure:
    """Every number that was solved for, to half a unit of its last digit."""
    pairs = claims(rows)
    right = sum(error <= bound for error, bound in pairs)
    return Figure(
        "every printed digit of what is solved is right", f"{right} of {len(pairs)} numbers", right == len(pairs)
    )


def claims(rows: Sequence[Row]) -> list[tuple[float, float]]:
    """The error and the bound of each number of ours."""
    return [pair for row in rows if row.peer == "rotsolve" for pair in zip(row.errors, row.bounds, strict=True)]


def figures(problems: Sequence[Problem], rows: Sequence[Row]) -> Iterator[Figure]:
    """All targets of the problems that were run."""
    simulated = [problem for problem in problems if problem.simulated]
    for problem in simulated:
        yield from against_scipy(problem, [row for row in rows if row.problem == problem.name])
    by_name = {name: [row for row in rows if row.problem == name] for name in ("two-hinged-rods", "rod-for-2000-s")}
    if own := by_name["two-hinged-rods"]:
        yield from two_rods(own)
    if own := by_name["rod-for-2000-s"]:
        yield energy_drift(own)
    names = {problem.name for problem in simulated}
    if names:
        yield from bounds([row for row in rows if row.problem in names])
    if len(names) < len(problems):
        yield digits([row for row in rows if row.problem not in names])
