"""Spans: quantities that belong to one or several phases: time, way, angle turned, work, impulse."""

from __future__ import annotations

from rotsolve.algebra.formula import PI, ZERO, Formula, total
from rotsolve.core.quantity import BY_WORD, DIMENSIONS
from rotsolve.core.vectors.heading import RIGHT, UP
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Path, PointRef, Term
from rotsolve.motion.timeline import Interval
from rotsolve.motion.travels import angle_turned
from rotsolve.paths import Meaning, NotYet, Unclear, label_of, size_of, spoken_point
from rotsolve.questions.transfers import blow, impulse, ways_of_blow, work


def spanned(term: Term, start: str | None, end: str | None, scene: SceneEquations) -> tuple[Meaning, str]:
    """A quantity of one or several phases: the sum over them."""
    timeline, path, kind = scene.configuration.timeline, term.path, BY_WORD[term.path.quantity]
    start, end = span(term, start, end, scene)
    intervals = timeline.between(start, end)
    if path.quantity == "displacement" and path.point is not None:
        return of_point(term, start, end, scene), intervals[-1].name
    if path.quantity == "time":
        duration = scene.instant(end).time() - scene.instant(start).time()
        if len(intervals) == 1 and intervals[0].name in scene.passages:
            duration = scene.passages[intervals[0].name].duration
        return Meaning(duration, kind.dimension), intervals[-1].name
    result = total([within(path, interval, scene) for interval in intervals])
    if path.quantity == "turns":
        result = result / (2 * PI)
    single = path.quantity == "impulse" and len(intervals) == 1
    vector = blow(path, intervals[0].name, scene) if single else None
    words = ways_of_blow(path, intervals[0].name, scene) if single and vector is None else ("", "")
    return Meaning(result, kind.dimension, vector, label=label_of(path, term), words=words), intervals[-1].name


def within(path: Path, interval: Interval, scene: SceneEquations) -> Formula:
    """What one phase or event adds to a quantity."""
    if path.quantity in ("impulse", "angular_impulse"):
        return impulse(path, interval.name, interval.start, scene)
    if path.quantity not in ("displacement", "rotation", "turns"):
        return work(path, interval.name, scene)
    if interval.event is not None:
        return ZERO  # an event moves nothing
    if path.quantity != "displacement":
        return angle_turned(path.owner, interval, scene.instant(interval.start))
    from rotsolve.questions.courses import way

    instant = scene.instant(interval.start)
    name = instant.host(path.owner) if path.owner in scene.configuration.bodies else path.owner
    return way(path, name, interval, instant)


def of_point(term: Term, start: str, end: str, scene: SceneEquations) -> Meaning:
    """Displacement of a point of a body on a fixed axis: where it is at the end less where it was."""
    path, dimension = term.path, DIMENSIONS["length"]
    ref = PointRef(path.owner, path.point, path.argument)
    instants = [scene.instant(state) for state in (start, end)]
    host = instants[0].host(path.owner)
    turning = all(item.motion(host).kind == "axis" and item.angle(host) is not None for item in instants)
    if not turning or any(item.host(path.owner) != host for item in instants):
        raise NotYet(
            f"the displacement of `{path.owner}.{path.point}` is not solved yet",
            help=f"solved is a point of a body on a fixed axis whose angle the states tell: `{host}.angle`",
        )
    way = instants[1].point(ref) - instants[0].point(ref)
    label = f"displacement of {spoken_point(path)}"
    if path.component in ("x", "y"):
        return Meaning(way.along(RIGHT if path.component == "x" else UP), dimension, label=label)
    if path.component is not None:
        raise NotYet(f"the {path.component} part of a displacement has no meaning", help="ask for `x` or `y`")
    return Meaning(size_of(way), dimension, way, label=label)


def span(term: Term, start: str | None, end: str | None, scene: SceneEquations) -> tuple[str, str]:
    """The states from and to which a quantity is asked; from the state before to one that is named, else over the whole scene."""
    names = list(scene.configuration.timeline.named)
    if term.at is not None and term.at in names:
        start, end = names[max(0, names.index(term.at) - 1)], term.at
    start, end = start or names[0], end or names[-1]
    if names.index(start) >= names.index(end):
        help = (
            f"say `from … to …` with two of: {', '.join(names)}"
            if len(names) > 1
            else "give `states`, at least two of them"
        )
        raise Unclear(f"`{term.path.quantity}` runs from one state to a later one", help=help)
    return start, end
