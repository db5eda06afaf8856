"""Laps: the steps of a motion from one state to the next, each with how what may slip behaves, and integrals over them."""

from __future__ import annotations

import math
from collections.abc import Callable

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.confirm.course.node import Node
from rotsolve.confirm.course.steps import TimeStep

LOBATTO = (
    (0.0, 16 / 45),
    (math.sqrt(3 / 7), 49 / 90),
    (1.0, 1 / 10),
)  # offsets from the middle, with weights on either side
FADED = 1e-3  # share of all it had at which a push is taken to fade away: where all stops, rounding decides on the rest of it


class Lap(Struct, frozen=True):
    """A step of what began at a node, with the modes of what may slip."""

    first: Node
    step: TimeStep
    modes: dict[str, str]

    def at(self, part: float) -> Node:
        """An instant within the step."""
        q, speed = self.step.at(part)
        placed = replace(self.first.placed, q=q, speed=speed, time=self.step.time + part * self.step.width)
        return Node(self.first.model, placed, self.first.budget, self.modes)


class FollowedPhase(Struct, frozen=True):
    """The motion from one state to the next: its steps, and the instant at which it ends."""

    laps: list[Lap]
    end: Node
    modes: dict[str, str]

    def creeping(self) -> str:
        """A body that has come to rest where what drives it has faded, as upright on its hinge; '' where none has.

        It takes for ever to come there, and where it goes on to is rounding.
        """
        steps = [lap.step for lap in self.laps]
        if len(steps[-1].pushes) == 1:
            return ""
        speeds = [speed for step in steps for speed in (step.speed, step.at(0.5)[1])]
        for name, seat in self.end.model.seats.items():
            fastest, most, left = 0.0, 0.0, 0.0
            for index in range(seat.first, seat.first + 3):
                fastest = max(fastest, *(abs(speed[index]) for speed in speeds))
                most = max(most, *(abs(push[index]) for step in steps for push in step.pushes))
                left = max(left, abs(steps[-1].push(1.0)[index]))
            places = self.end.placed.speed[seat.first : seat.first + 3]
            if max(map(abs, places)) <= FADED * fastest and fastest > 0.0 and left <= FADED * most:
                return name
        return ""

    def integral(self, rate: Callable[[Node], float]) -> tuple[float, float]:
        """∫ rate dt and ∫ |rate| dt, by Lobatto's rule, whose ends see a corner next to them, on halves where it takes more."""
        whole, size = 0.0, 0.0
        for lap in self.laps:
            value = panel(lap, rate, 0.0, 1.0)
            part, most = refined(lap, rate, 0.0, 1.0, value, 0)
            whole, size = whole + part, size + most
        return whole, size


def panel(lap: Lap, rate: Callable[[Node], float], low: float, high: float) -> tuple[float, float]:
    total, size, half = 0.0, 0.0, (high - low) / 2.0
    for offset, weight in LOBATTO:
        for sign in (-1.0, 1.0):
            value = rate(lap.at(low + half * (1.0 + sign * offset)))
            total += weight * value
            size += weight * abs(value)
    return total * half * lap.step.width, size * half * lap.step.width


def refined(
    lap: Lap,
    rate: Callable[[Node], float],
    low: float,
    high: float,
    value: tuple[float, float],
    depth: int,
) -> tuple[float, float]:
    """The integral of a panel, halved until halves add up to the whole; what is small is held no closer than it is compared (`number`)."""
    middle = (low + high) / 2.0
    halves = [panel(lap, rate, low, middle), panel(lap, rate, middle, high)]
    total, size = (halves[0][k] + halves[1][k] for k in range(2))
    apart = max(abs(total - value[0]), abs(size - value[1]))  # what turns back has a corner in its size alone
    if apart <= 1e-9 * max(size, 1e-4) or depth > 20:
        return total, size
    ends = ((low, middle), (middle, high))
    parts = [refined(lap, rate, *end, half, depth + 1) for end, half in zip(ends, halves, strict=True)]
    return parts[0][0] + parts[1][0], parts[0][1] + parts[1][1]
