"""Sets: one solved problem for a million sets of givens, over floats and over certified balls, against what memory can deliver."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from costs.clock import best
from costs.tables import Part, above, below, table

PROBLEMS = ("pulleys/block-on-disc.yaml", "pulleys/atwood.yaml", "pulleys/double-atwood.yaml")
TWICE = "all that has been asked for the sign of is read set by set, and once more with other inputs to see whether it is sure"
CERTIFIED = 50  # times fewer sets by balls


def part(folder: Path, sets: int) -> Part:
    """The table and the targets, which speak of the first of the problems."""
    import numpy

    import rotsolve

    copied = numpy.random.default_rng(1).uniform(size=sets)
    into = numpy.empty_like(copied)
    bandwidth = 16 * sets / best(lambda: numpy.copyto(into, copied), 20)
    rows, fast, sure, held = [], [], [], []
    for name in PROBLEMS:
        solution = rotsolve.solve(folder / name)
        values = drawn(solution, sets)
        few = {letter: column[: sets // CERTIFIED] for letter, column in values.items()}
        floats = sets / best(lambda: solution.evaluate_many(values, as_decided=True), 3)  # noqa: B023
        balls = sets // CERTIFIED / best(lambda: solution.evaluate_many(few, certified=True, as_decided=True), 2)  # noqa: B023
        solution.evaluate_many(values)  # the cases that there are are solved once
        judged = sets / best(lambda: solution.evaluate_many(values), 3)  # noqa: B023
        moved = 8 * (len(values) + len(solution.answers))
        errors = certified_error(solution.evaluate_many(few, certified=True, as_decided=True))
        rows.append(
            [
                name,
                f"{len(values)} → {len(solution.answers)}",
                f"{floats:.1e}",
                f"{moved * floats / bandwidth:.0%}",
                f"{judged:.1e}",
                f"{balls:.1e}",
                f"{errors:.0e}",
            ]
        )
        fast.append(floats)
        sure.append(balls)
        held.append(floats / judged)
    head = (
        "problem",
        "givens → answers",
        "sets a second, NumPy",
        "of a copy",
        "each as solving it says",
        "sets a second, certified",
        "largest relative error",
    )
    text = (
        f"{sets:.0e} sets of givens, all answers; a copy moves {bandwidth / 1e9:.1f} GB/s, "
        f"the share is of what is read and written once.\n\n{table(head, rows)}"
    )
    return Part(
        "Many sets of givens",
        text,
        (
            above("sets a second, NumPy, block on a disc", fast[0], 1e7, "{:.1e}"),
            above("sets a second, certified, block on a disc", sure[0], 1e5, "{:.1e}"),
            below(
                "each set as solving it says, × the closed forms alone, block on a disc", held[0], 2, "{:.1f}", TWICE
            ),
        ),
    )


def drawn(solution: Any, sets: int) -> dict[str, Any]:
    """Values of all masses and lengths within a fifth of the scene's own."""
    import numpy

    from rotsolve.algebra.certified.ball import evaluate

    rng = numpy.random.default_rng(2)
    own = {
        given.name: given.value for given in solution.problem.givens if given.value is not None and given.name != "g"
    }
    return {name: evaluate(value, own).float * rng.uniform(0.8, 1.2, sets) for name, value in own.items()}


def certified_error(found: Mapping[str, Any]) -> float:
    """The largest bound on an error against its value."""
    import numpy

    return float(max(numpy.nanmax(errors / numpy.abs(values)) for values, errors in found.values()))
