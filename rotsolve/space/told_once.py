"""Told once: how a body goes and turns at a state is told in one way: a vector along one set of axes, its rotation by that vector or by the
rates of its Euler angles. What is told in two is refused by name, unless the tilt tells how the two hang together."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO
from rotsolve.core.faults import Contradicted, Unsolvable
from rotsolve.language.problem import Condition
from rotsolve.paths.meaning import path_text
from rotsolve.space.arrangement import RATES
from rotsolve.space.turned import TurnedMoment

VECTORS = ("position", "velocity", "acceleration", "angular_velocity", "angular_acceleration")
EULER_RATES = (*RATES, "axial_rate")
MOVES = ("velocity", "angular_velocity", *EULER_RATES)  # what is nothing of a body at rest


def refuse_told_twice(moment: TurnedMoment) -> None:
    """Refuse what a state tells twice of how a body goes or turns, or beside that it is at rest."""
    refuse_second_vector(moment)
    for name in moment.held.order:
        refuse_moving_at_rest(name, moment)
        if moment.nods(name):
            refuse_rate_beside_vector(name, moment)


def refuse_second_vector(moment: TurnedMoment) -> None:
    """Refuse a vector that is told along two sets of axes, or of which a component is told twice."""
    seen: dict[tuple[object, ...], dict[str, Condition]] = {}
    for line in moment.state.conditions:
        path = line.path
        if path is None or path.quantity not in VECTORS or not path.component:
            continue
        first = seen.setdefault((path.owner, path.point, path.quantity, line.relative), {})
        before = next((one for one in first.values() if one.axes != line.axes), None) or first.get(path.component)
        if before is not None:
            text = path_text(path).removesuffix(f".{path.component}")
            both = " and ".join(dict.fromkeys(f"along the axes of {one.axes or 'space'}" for one in (before, line)))
            both = f": {both}" if before.axes != line.axes else ""
            message = f"`{text}` is told twice at {moment.spoken_of()}{both}"
            raise Unsolvable(message, span=line.span, help=f"leave one of them out, or write `{text}: [x, y, z]` alone")
        first[path.component] = line


def refuse_rate_beside_vector(name: str, moment: TurnedMoment) -> None:
    """Refuse the angular velocity of a body as a vector and by rates of its Euler angles where nothing tells its tilt."""
    told = lines_about(name, ("angular_velocity",), moment)
    vector = next((line for line in told if line.path is not None and line.path.component), None)
    rate = next(lines_about(name, EULER_RATES, moment), None)
    by_time = moment.state.time_told is not None and not moment.first
    if vector is None or rate is None or rate.path is None or by_time or moment.stood(name, "tilt") is not None:
        return
    if moment.line(name, "tilt") is not None:  # the smallest or the largest
        return
    word = rate.path.quantity
    message = f"how `{name}` turns is told twice at {moment.spoken_of()}: by its `angular_velocity` and its `{word}`"
    help = f"leave one of them out, or tell `{name}.tilt`, by which they hang together"
    raise Unsolvable(message, span=max(rate, vector, key=place_of_line).span, help=help)


def refuse_moving_at_rest(name: str, moment: TurnedMoment) -> None:
    """Refuse a velocity or a rate of a body of which a state says that it is at rest."""
    if not moment.rests(name):
        return
    for line in lines_about(name, MOVES, moment):
        if line.path is not None and moment.held.signs.taken(line.value or ZERO) not in (0, None):
            message = f"`{name}` is at rest at {moment.spoken_of()}, and its `{line.path.quantity}` is told"
            raise Contradicted(message, span=line.span, help="leave one of them out")


def lines_about(name: str, words: tuple[str, ...], moment: TurnedMoment) -> Iterator[Condition]:
    """The lines of a state that tell one of some quantities of a body."""
    for line in moment.state.conditions:
        path = line.path
        if path is not None and path.owner == name and path.point is None and path.quantity in words:
            yield line


def place_of_line(line: Condition) -> tuple[int, int]:
    """Where a line stands in the file."""
    return (0, 0) if line.span is None else (line.span.line, line.span.column)
