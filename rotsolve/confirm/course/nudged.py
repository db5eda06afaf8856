"""Nudged: what rests on the verge of a surface and is to leave it sets out by the least push, along the way that counts as positive.

Where and how fast it leaves hangs on that push by its square alone; when it does, hangs on the push itself, and is not told.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.confirm.course.energy import rates_along
from rotsolve.confirm.course.node import Node, unpushed
from rotsolve.confirm.lines import placed_value
from rotsolve.elements.asked import is_touch
from rotsolve.language.problem import Condition, Path, State

if TYPE_CHECKING:
    from rotsolve.elements.connections.touch import Touch

LEAST = 1e-7  # metres per second


def barely_moving(first: Node, state: State) -> Node | None:
    """The same instant with the least speed; None where something drives it, or it is to go along no surface."""
    lines = {line.path.owner: line for line in state.conditions if line.path is not None}
    touches = (item for item in first.model.acting.connections if item.name in lines and is_touch(item))
    touch = next(touches, None)
    if touch is None or not unpushed(first):
        return None
    way = aside(touch, first) if touch.side is not None else forth(touch, lines[touch.name], first)
    if way is None:
        return None
    line = lines[touch.name]
    back = touch.side is not None and line.value is not None and heads_back(touch, line, first)
    speed = [part * (-LEAST if back else LEAST) for part in way]
    return Node(first.model, replace(first.placed, speed=speed), first.budget)


def forth(touch: Touch, line: Condition, first: Node) -> list[float] | None:
    """The rates with which a body that is to leave a surface goes along it as fast as one, the way that counts as positive."""
    along, seat, round_ = first.line(touch.lying()), first.model.seats[touch.lying()], Path(touch.name, "angle")
    if line.word != "leaves" or placed_value(round_, first.pose, first.model) is None:  # what is flat has no verge
        return None
    way = rates_along(first, first.placed.q, Condition(round_))
    if way is None or along is None:
        return None
    pace = way[seat.first] * along[0] + way[seat.first + 1] * along[1]
    return [part / pace for part in way] if pace else None


def aside(touch: Touch, first: Node) -> list[float] | None:
    """The same to the right over the top of a side of a body that is at rest meanwhile: the push sets hardly anything else going."""
    seat, under = (first.model.seats[ref.owner] for ref in touch.pair()[:2])
    still = range(under.first, under.turn + 1)
    way = rates_along(first, first.placed.q, Condition(Path(touch.name, "angle")), still)
    pace = 0.0 if way is None else math.hypot(way[seat.first], way[seat.first + 1])
    return [-part / pace for part in way] if way is not None and pace else None


def heads_back(touch: Touch, line: Condition, first: Node) -> bool:
    """Whether the place that a state tells is to the left over the top."""
    told = first.model.value(line.value) if line.value is not None else 0.0
    return math.remainder(told - first.touching_angle(touch), 2 * math.pi) > 0.0
