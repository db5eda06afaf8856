"""Simulate: a scene from its first state on, as it moves in time."""

from __future__ import annotations

import math
import os
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from pathlib import Path

from msgspec import Struct, field

from rotsolve.algebra.certified.ball import Precision, evaluate
from rotsolve.algebra.flints import arb
from rotsolve.core.faults import Unsolvable
from rotsolve.inquiry.questions import NotYet
from rotsolve.motion.arranged import arranged
from rotsolve.motion.arrangement import Arrangement
from rotsolve.scene.model import Problem
from rotsolve.scene.moment import read_moment
from rotsolve.scene.read import read_file, read_text
from rotsolve.simulation.bounded import FLOAT_BITS, ROUNDING, Reading, Stretch, Tolerances, Unsettled
from rotsolve.simulation.following import Follower
from rotsolve.simulation.run import Run
from rotsolve.simulation.series import Scalar
from rotsolve.simulation.taylor import Unbounded

FINEST = 2e-17  # tolerance of a step in floats below which nothing is gained
AIM = 1e-3  # tolerance of a step, of the accuracy asked for
LEAST_ACCURACY, MOST_ACCURACY = 1e-2, 1e-60


def simulate(
    source: str | os.PathLike[str],
    until: str | float = "10 s",
    accuracy: float = 1e-9,
    settings: Mapping[str, str] | None = None,
) -> Run:
    """Follow a scene in time from its first state: a path, or YAML text (text with a line break).

    Raises SceneError for a scene that can't be read, Unsolvable for what can't be simulated.
    """
    if isinstance(source, str) and "\n" in source:
        problem = read_text(source, settings=settings or {})
    else:
        problem = read_file(Path(source), settings=settings or {})
    seconds = float(until) if isinstance(until, (int, float)) else seconds_of(until)
    return simulate_problem(problem, seconds, accuracy)


def seconds_of(text: str) -> float:
    return evaluate(read_moment(text).value, {}, digits=17).float


def simulate_problem(problem: Problem, until: float, accuracy: float) -> Run:
    """Follow a problem that has been read."""
    arrangement = arranged(problem)
    try:
        return followed(arrangement, until, accuracy)
    except NotYet as error:
        span, help = error.span, error.help
        raise Unsolvable(str(error), span=span, help=help, lines=problem.lines, file=problem.file) from None
    except (Unbounded, Unsettled) as error:
        raise Unsolvable(str(error), lines=problem.lines, file=problem.file) from None


def followed(arrangement: Arrangement, until: float, accuracy: float) -> Run:
    """Follow an arrangement; with a finer tolerance, or more bits, as long as the bounds are wider than what is asked."""
    tolerances = Tolerances(max(FINEST, AIM * accuracy))
    while True:
        found = Follower(arrangement, until, tolerances).followed()
        excess = worst(found.stretches) / accuracy
        if excess <= 1:
            return Run(arrangement.problem, until, accuracy, found.stretches, tuple(found.events), found.ended)
        tolerances = finer(tolerances, excess)


def worst(stretches: Sequence[Stretch]) -> float:
    """The widest bound of a number of the state, as a part of its largest size."""
    sizes: dict[str, float] = {}
    bounds: dict[str, float] = {}
    for part in stretches:
        for number, item in enumerate(part.course.variables):
            own = max(abs(float(piece.polynomials[number][0])) for piece in part.runs[0].pieces)
            sizes[item.name] = max(sizes.get(item.name, 0.0), own, abs(float(part.last[0][number])))
            bounds[item.name] = part.bounds[-1][number]
    return max((bounds[name] / size for name, size in sizes.items() if size), default=0.0)


def finer(tolerances: Tolerances, excess: float) -> Tolerances:
    """A finer tolerance; beyond what floats can carry, balls of as many bits as it takes."""
    main = tolerances.main / (10 * excess)
    if main >= FINEST and tolerances.bits == FLOAT_BITS:
        return Tolerances(main)
    return Tolerances(main, max(96, 32 + math.ceil(-math.log2(main))))
