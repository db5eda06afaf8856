"""Running: quantities as functions of the running time."""

from __future__ import annotations

from rotsolve.algebra.formula import PI, Formula
from rotsolve.core.quantity import BY_WORD, SPANNED
from rotsolve.core.registry import TIME
from rotsolve.core.varying import CONSTANT
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Path, Term
from rotsolve.motion.instant import Instant
from rotsolve.motion.timeline import Interval
from rotsolve.motion.travels import displacement, so_far
from rotsolve.paths import Meaning, NotYet, Unclear, path_text


def phases_of(term: Term, scene: SceneEquations) -> tuple[Interval, ...]:
    """The phases in which a function of time is asked; several only where a given motion is one function throughout."""
    timeline = scene.configuration.timeline
    intervals = timeline.between(term.start, term.end) if term.start and term.end else timeline.intervals
    named = tuple(interval for interval in intervals if term.during in (None, interval.name) and interval.event is None)
    if not named:
        raise Unclear("a function of time is asked of a phase", help="say `at any time during PHASE`")
    if len(named) > 1 and not (
        term.path.owner in scene.configuration.bodies and one_function(term.path.owner, intervals, scene)
    ):
        names = ", ".join(f"`from {interval.start} to {interval.end}`" for interval in named)
        raise Unclear("the motion may be another function in each phase", help=f"say in which: {names}")
    return named


def at_any_time(term: Term, scene: SceneEquations) -> tuple[Meaning, str]:
    """The meaning at the running time, with its sign, in the phase that is named or in the only one."""
    named = phases_of(term, scene)
    if term.modifier not in ("", "size of"):
        raise NotYet(f"`{term.modifier}` of a function of time is not solved yet")
    check_pace(term.path, named[0], scene)
    start, path = named[0].start, term.path
    if path.quantity in SPANNED:
        middle = scene.instant(start, generic=True)
        return Meaning(run_up(path, middle), BY_WORD[path.quantity].dimension), named[0].name
    return scene.reader(start, generic=True).meaning(path, term), named[0].name


def check_pace(path: Path, interval: Interval, scene: SceneEquations) -> None:
    """A motion whose acceleration goes by the place or the speed is not written as a function of the running time."""
    name = scene.instant(interval.start).host(path.owner) if path.owner in scene.configuration.bodies else ""
    for travel in scene.passages[interval.name].travels:
        if travel.body == name and travel.pace not in (CONSTANT, TIME) and travel.given not in (0, 1):
            help = "ask for it at a state whose time is a letter: `end: {time: t1}`"
            raise NotYet(f"the motion of `{name}` as a function of time is not solved yet", help=help)


def one_function(name: str, intervals: tuple[Interval, ...], scene: SceneEquations) -> bool:
    """Whether a body moves by one given function through several phases, with no event between them."""
    drives = {scene.configuration.drives(name, interval.start) for interval in intervals}
    return len(drives) == 1 and drives != {()} and all(interval.event is None for interval in intervals)


def run_up(path: Path, middle: Instant) -> Formula:
    """What has come together from the start of a phase up to the running time."""
    name = middle.host(path.owner)
    if path.quantity == "displacement":
        return way(path, name, None, middle)
    if path.quantity in ("rotation", "turns"):
        turned = so_far("rotation", name, middle)
        return turned / (2 * PI) if path.quantity == "turns" else turned
    raise NotYet(f"`{path.quantity}` as a function of time is not solved yet")


def way(path: Path, name: str, interval: Interval | None, instant: Instant) -> Formula:
    """Displacement along a body's line or a component of it, over a phase, or up to any moment in it where none is named."""
    axis = path.component if path.component in ("x", "y") and instant.motion(name).kind == "plane" else ""
    if path.component and not axis:
        raise NotYet(f"`{path_text(path)}` is not solved yet", help="ask for the displacement along its line")
    if interval is None:
        return so_far("displacement", name, instant, axis)
    return displacement(name, interval, instant, axis)
