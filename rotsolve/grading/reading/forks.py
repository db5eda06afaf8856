"""Forks: the places where a line can be read in two ways; a line is read again for each way, the likeliest first."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TypeVar

from rotsolve.algebra.notation.tokens import FormulaError

MOST_READINGS = 8
MOST_TRIES, MOST_TOKENS = 24, 1500  # of a line, and of all its tries together

Found = TypeVar("Found")


class Forks:
    """One way through a line: at which forks it takes the unlikely branch."""

    def __init__(self, departures: tuple[bool, ...] = ()) -> None:
        self.departures = departures
        self.taken: list[bool] = []

    def choose(self, likely: bool) -> bool:
        """The answer to a question that the line leaves open: the likely one, or on some ways the other."""
        index = len(self.taken)
        departs = index < len(self.departures) and self.departures[index]
        self.taken.append(departs)
        return likely != departs


def all_ways(read: Callable[[Forks], Found], tokens: int) -> list[Found]:
    """What a line says, read in all ways that make sense, with fewest unlikely branches first; the first fault where none does.

    A line of many tokens is tried less often.
    """
    most = min(MOST_TRIES, 1 + MOST_TOKENS // max(tokens, 1))
    waiting: deque[tuple[bool, ...]] = deque([()])
    found: list[Found] = []
    fault: FormulaError | None = None
    tries = 0
    while waiting and tries < most and len(found) < MOST_READINGS:
        way = waiting.popleft()
        forks = Forks(way)
        tries += 1
        try:
            reading = read(forks)
        except FormulaError as error:
            fault = fault or error
        else:
            if reading not in found:
                found.append(reading)
        for index in range(len(way), len(forks.taken)):
            waiting.append((*forks.taken[:index], True))
    if fault is not None and not found:
        raise fault
    return found
