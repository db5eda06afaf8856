"""Nudged: what rests on the verge of a surface and is to leave it sets out by the least push, along the way that counts as positive.

Where and how fast it leaves hangs on that push by its square alone; when it does, hangs on the push itself, and is not told.
"""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.confirm.course.energy import rates_along
from rotsolve.confirm.course.node import Node, unpushed
from rotsolve.confirm.lines import placed_value
from rotsolve.elements.connections.touch import Touch
from rotsolve.language.problem import Condition, Path, State

LEAST = 1e-7  # metres per second


def barely_moving(first: Node, state: State) -> Node | None:
    """The same instant with the least speed; None where something drives it, or it is not to leave a surface."""
    owners = [line.path.owner for line in state.conditions if line.word == "leaves" and line.path is not None]
    touch = next(
        (item for item in first.model.acting.connections if item.name in owners and isinstance(item, Touch)), None
    )
    if touch is None or not unpushed(first):
        return None
    along, seat, round_ = first.line(touch.lying()), first.model.seats[touch.lying()], Path(touch.name, "angle")
    if placed_value(round_, first.pose, first.model) is None:  # what is flat has no verge
        return None
    way = rates_along(first, first.placed.q, Condition(round_))
    if way is None or along is None:
        return None
    pace = way[seat.first] * along[0] + way[seat.first + 1] * along[1]
    if not pace:
        return None
    speed = [part * LEAST / pace for part in way]
    return Node(first.model, replace(first.placed, speed=speed), first.budget)
