"""Reached: of several places on a circle the one that a body comes to first on its way."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import pi

from msgspec import Struct

from rotsolve.algebra.formula import ZERO, Formula, Number, Symbol, negate
from rotsolve.core.derivation import Words
from rotsolve.core.passage import Travel
from rotsolve.core.registry import SEPARATOR
from rotsolve.elements.connections.connection import Orbit
from rotsolve.inquiry.history import History
from rotsolve.inquiry.roots.numbers import Numbers
from rotsolve.solver import Choice

TINY = 1e-14
TURN = 2 * pi


class FirstReached(Struct, frozen=True):
    """Follows the ways of bodies; `definition` tells what an asked letter stands for."""

    history: History
    numbers: Numbers
    definition: Callable[[str], Formula | None]

    def choose(self, name: str, roots: Sequence[tuple[int, float]]) -> Choice | None:
        """Of several angles the one that a body comes to first on its way; None where nothing tells where it starts.

        The roots are all places in one turn at which the condition of the state holds, so that it holds at none before.
        """
        letter, scale, shift = self._place_behind(name)
        for interval, passage in self.history.passages.items():
            for travel in passage.travels:
                begin = self._begin(travel, letter, interval)
                if begin is None:
                    continue
                ways = [(k, *self._way_to((root - shift) / scale, *begin), root) for k, root in roots]
                # from a summit it may go to either side, equally far: the smaller angle is told
                index, _, turns, _ = min(ways, key=lambda item: (item[1], item[2] != 0, item[3]))
                words: Words = ("the first place on the way where this holds",)
                return Choice(index, words, turns * Fraction(scale).limit_denominator(1000))
        return None

    def _begin(self, travel: Travel, letter: str, interval: str) -> tuple[float, int] | None:
        """Where the angle `letter` of a body at the end of a phase starts, and which way it goes: +1 where it grows, 0 where nothing tells.

        What is only just nudged on a circle goes its positive way.
        """
        phase = self.history.arrangement.timeline.interval(interval)
        place = self.history.registry.quantities.get(letter)
        if phase is None:
            return None
        if travel.kind == "line" and place is not None and place.kind == "angle" and place.when == phase.end:
            circle = self.history.instant(phase.end).orbit(travel.body)
            start = self._entry(travel.body, circle, phase.start) if circle and circle.owner == place.owner else None
            return None if circle is None or start is None else (start, circle.way * (self._onset(travel) or 1))
        if (
            travel.kind == "turn"
            and travel.start is not None
            and travel.end in (Symbol(letter), negate(Symbol(letter)))
        ):
            side = 1 if travel.end == Symbol(letter) else -1
            start = self.numbers.found(travel.start)
            return None if start is None else (start * side, side * self._onset(travel))
        return None

    def _onset(self, travel: Travel) -> int:
        """Which way a coordinate sets out: as it moves at the start, else as it is pushed; 0 where nothing tells."""
        return self.numbers.sign((travel.before, self.numbers.push(travel.initial)))

    def _way_to(self, place: float, start: float, way: int) -> tuple[float, int]:
        """How far it is to a place on a circle, and the whole turns that its angle must be changed by to lie on the way."""
        if not way:
            return round(abs(place - start), 9), 0
        gap = round(way * (place - start) % TURN, 9) or TURN
        return gap, round((start + way * gap - place) / TURN)

    def _entry(self, body: str, circle: Orbit, state: str) -> float | None:
        """Where on its circle a body is at the start of its way; a track leads into a bowl at its bottom, over a hill at its top."""
        instant = self.history.instant(state)
        orbit = instant.orbit(body)
        if orbit == circle:
            return self.numbers.found(instant.place_on(circle))
        return None if orbit is None else pi / 2 if circle.level == ZERO else -pi / 2

    def _place_behind(self, name: str) -> tuple[str, float, float]:
        """The angle that an asked letter stands for, with the letter = scale · angle + shift."""
        formula = self.definition(name)
        angles = [key for key in formula.symbols() if SEPARATOR in key] if formula is not None else []
        if formula is None or len(angles) != 1:
            return name, 1.0, 0.0
        at = [self.numbers.of(formula.substitute({angles[0]: Number(Fraction(value))})) for value in (0, 1, 2)]
        if at[0] is None or at[1] is None or at[2] is None or abs(at[2] + at[0] - 2 * at[1]) > TINY or at[1] == at[0]:
            return name, 1.0, 0.0
        return angles[0], at[1] - at[0], at[0]
