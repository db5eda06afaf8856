"""Simulate: a scene from its first state on, as it moves in time."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from time import monotonic

from msgspec import Struct

from rotsolve.core.faults import Unsolvable
from rotsolve.language.problem import Problem
from rotsolve.motion.complete import configured
from rotsolve.motion.configuration import Configuration
from rotsolve.paths.meaning import NotYet
from rotsolve.scene.read import Source, read_source
from rotsolve.scene.values import read_seconds
from rotsolve.simulation.bounded import ALONE, FLOAT_BITS, Regime, Tolerances, Unsettled
from rotsolve.simulation.enclosing import enclosed
from rotsolve.simulation.following import Follower
from rotsolve.simulation.run import Run
from rotsolve.simulation.taylor import Unbounded

FINEST = 2e-17  # tolerance of a step in floats below which nothing is gained
OF_FLOATS = 1e-14  # accuracy that floats can give: their roundings alone come to a fifth of it
AIM = 5e-8  # tolerance of a step, of the accuracy asked for: ten times finer is a tenth dearer, one more try costs all again
LOOSER = 5  # times it may be if that spares the third run, which is half as dear again
LEAST_ACCURACY, MOST_ACCURACY = 1e-2, 1e-60
FIRST_BITS = 128  # beyond those of the accuracy, with which a proof is tried first
IDLE = 3  # finer tries that did not help, after which the bounds stay as they are: times of events are floats
PATIENCE = 60.0  # seconds after which it is not tried any finer


def simulate(
    source: Source,
    until: str | float = "10 s",
    accuracy: float = 1e-9,
    settings: Mapping[str, object] | None = None,
    tell: Callable[[float], None] | None = None,
    *,
    certified: bool = False,
) -> Run:
    """Follow a scene in time from its first state: a path, YAML text (text with a line break), or a dict.

    `accuracy` is what the bound of each coordinate and speed may be, as a part of its largest size; `tell` is told how much is done.
    `certified` bounds are proved, at a price in time; such a motion ends where something may happen.
    Raises SceneError for a scene that can't be read, Unsolvable for what can't be simulated, ValueError for a time or accuracy that
    is none.
    """
    if not isinstance(until, (str, int, float)) or not isinstance(accuracy, (int, float)):
        raise TypeError(
            f"a motion is followed until a time such as '2 s', to an accuracy such as 1e-8, not {until!r} and {accuracy!r}"
        )
    seconds = read_seconds(until) if isinstance(until, str) else float(until)
    if not 0 < seconds < math.inf:
        raise ValueError("the time to simulate must be above zero")
    if not MOST_ACCURACY <= accuracy <= LEAST_ACCURACY:
        raise ValueError(f"the accuracy must be between {MOST_ACCURACY:g} and {LEAST_ACCURACY:g}")
    return simulate_problem(read_source(source, settings), seconds, accuracy, tell, certified)


def simulate_problem(
    problem: Problem,
    until: float,
    accuracy: float,
    tell: Callable[[float], None] | None = None,
    certified: bool = False,
) -> Run:
    """Follow a problem that has been read."""
    pursuit = in_space(problem) if problem.space else Pursuit(configured(problem), Follower, Run)
    try:
        return (proved if certified else follow)(pursuit, until, accuracy, tell)
    except Unsolvable as error:
        fault = error.fault
        raise Unsolvable(
            fault.message, span=fault.span, help=fault.help, lines=problem.lines, file=problem.file
        ) from None
    except NotYet as error:
        span, help = error.span, error.help
        raise Unsolvable(str(error), span=span, help=help, lines=problem.lines, file=problem.file) from None
    except (Unbounded, Unsettled) as error:
        raise Unsolvable(str(error), lines=problem.lines, file=problem.file) from None


class Pursuit(Struct, frozen=True):
    """A scene made ready for the laws, what follows it, and what its motion is told by."""

    configuration: Configuration
    follower: type[Follower]
    run: type[Run]


def in_space(problem: Problem) -> Pursuit:
    """A scene in space, with the room that is loaded for these alone."""
    from rotsolve.scene.idle import noted
    from rotsolve.simulation.space.following import SpaceFollower
    from rotsolve.simulation.space.run import SpaceRun
    from rotsolve.space.complete import configured_in_space

    return Pursuit(Configuration(noted(configured_in_space(problem).problem)), SpaceFollower, SpaceRun)


def follow(pursuit: Pursuit, until: float, accuracy: float, tell: Callable[[float], None] | None) -> Run:
    """Follow a scene; with a finer tolerance, or more bits, as long as the bounds are wider than what is asked.

    When the time for that is over, as of chaotic motion, the run ends where its bounds still are as asked.
    """
    tolerances, best, going_on = first_tolerances(accuracy), None, patient(tell)
    excess, idle = math.inf, 0
    while True:
        try:
            found = pursuit.follower(pursuit.configuration, until, tolerances, going_on).followed()
        except (Unsettled, TimeoutError) as error:
            if isinstance(error, Unsettled) and tolerances.main > FINEST * FINEST:
                tolerances = finer(tolerances, 1e6)
                continue
            if best is None:
                raise Unsettled(getattr(error, "time", 0.0)) from None
            settled = settled_until(best.regimes, accuracy)
            why = f"beyond that its numbers are not settled to {accuracy:g} within {PATIENCE:g} s of calculation"
            events = tuple(event for event in best.events if event.time <= settled)
            return pursuit.run(
                pursuit.configuration.problem, until, accuracy, best.regimes, events, why, settled, best.sought
            )
        before, excess = excess, worst(found.regimes) / accuracy
        idle += excess > before / 2
        if excess <= 1 or idle == IDLE:
            events, ended = tuple(found.events), found.ended
            return pursuit.run(
                pursuit.configuration.problem, until, accuracy, found.regimes, events, ended, sought=found.sought
            )
        tolerances, best = finer(tolerances, excess), found


def first_tolerances(accuracy: float) -> Tolerances:
    """With what an accuracy is tried first."""
    aim = AIM * accuracy
    if accuracy < OF_FLOATS:
        return in_balls(aim)
    return Tolerances(ALONE if aim < ALONE <= LOOSER * aim else max(FINEST, aim))


def proved(pursuit: Pursuit, until: float, accuracy: float, tell: Callable[[float], None] | None) -> Run:
    """Follow a scene in balls that surely hold its motion, with twice the bits as long as they are wider than asked."""
    follower, going_on = pursuit.follower(pursuit.configuration, until, Tolerances(accuracy)), patient(tell)
    system = follower.begun()
    watched = follower.looked_for(system, None, {})
    bits = FIRST_BITS + math.ceil(-math.log2(accuracy))
    while True:
        with suppress(Unbounded):
            try:
                part, why = enclosed(system, until, bits, watched, going_on)
            except TimeoutError:
                said = f"its numbers are not certified to {accuracy:g} within {PATIENCE:g} s of calculation"
                raise NotYet(said, help="follow it for a shorter time, or without --certified") from None
            sizes = sizes_of([part])
            if excess_of(part, [float(number.rad()) for number in part.last[0]], sizes) <= accuracy:
                return pursuit.run(pursuit.configuration.problem, until, accuracy, [part], (), why)
        bits *= 2


def patient(tell: Callable[[float], None] | None) -> Callable[[float], None]:
    """What is told how much is done; it ends the work when patience is over."""
    start = monotonic()

    def going_on(part: float) -> None:
        if monotonic() - start > PATIENCE:
            raise TimeoutError
        if tell is not None:
            tell(part)

    return going_on


def in_balls(tolerance: float) -> Tolerances:
    """A tolerance, with as many bits as it takes."""
    return Tolerances(tolerance, max(96, 40 + math.ceil(-math.log2(tolerance))))


def sizes_of(regimes: Sequence[Regime]) -> dict[str, float]:
    """The largest size of each number of the state, of the components of a vector together."""
    sizes: dict[str, float] = {}
    for part in regimes:
        for number, item in enumerate(part.system.variables):
            own = max(abs(float(piece.polynomials[number][0])) for piece in part.runs[0].pieces)
            whole = item.vector or item.name
            sizes[whole] = max(sizes.get(whole, 0.0), own, abs(float(part.last[0][number])))
    return sizes


def excess_of(part: Regime, bounds: Sequence[float], sizes: Mapping[str, float]) -> float:
    """The widest of some bounds of the state, as a part of the size of its number."""
    pairs = zip((sizes[item.vector or item.name] for item in part.system.variables), bounds, strict=True)
    return max((bound / size for size, bound in pairs if size), default=0.0)


def worst(regimes: Sequence[Regime]) -> float:
    """The widest bound of a number of the state at any time."""
    sizes = sizes_of(regimes)
    return max(excess_of(part, bounds, sizes) for part in regimes for bounds in part.bounds)


def settled_until(regimes: Sequence[Regime], accuracy: float) -> float:
    """The time up to which all bounds are as asked."""
    sizes = sizes_of(regimes)
    for part in regimes:
        for piece, bounds in zip(part.runs[0].pieces, part.bounds, strict=True):
            if excess_of(part, bounds, sizes) > accuracy:
                return piece.start
    return regimes[-1].ends[0]


def finer(tolerances: Tolerances, excess: float) -> Tolerances:
    """A finer tolerance; beyond what floats can carry, balls of as many bits as it takes."""
    main = tolerances.main / (10 * excess)
    return Tolerances(main) if main >= FINEST and tolerances.bits == FLOAT_BITS else in_balls(main)
