"""Reached: of several places on a circle the one that a body comes to first on its way."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cmp_to_key

from msgspec import Struct

from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Number, Symbol, add, negate
from rotsolve.core.derivation import Words
from rotsolve.core.passage import Travel
from rotsolve.core.registry import SEPARATOR
from rotsolve.elements.connections.connection import Orbit
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.search.roots.numbers import Numbers
from rotsolve.solver import Choice

TURN = 2 * PI
SAME_PLACE = 1e-9  # rad: how far numerical roots may be apart that are one place, whole turns apart


class Way(Struct, frozen=True):
    """How far it is to a root, and the whole turns by which its angle must be changed to lie on the way."""

    root: int
    value: Formula
    gap: Formula
    turns: int = 0


class FirstReached(Struct, frozen=True):
    """Follows the ways of bodies; `definition` tells what an asked letter stands for."""

    scene: SceneEquations
    numbers: Numbers
    definition: Callable[[str], Formula | None]

    def choose(self, name: str, roots: Sequence[tuple[int, Formula]]) -> Choice | None:
        """Of several angles the one that a body comes to first on its way; None where nothing tells where it starts.

        The roots are all places in one turn at which the condition of the state holds, so that it holds at none before.
        """
        letter, scale, shift = self._place_behind(name)
        for interval, passage in self.scene.passages.items():
            for travel in passage.travels:
                begin = self._begin(travel, letter, interval)
                if begin is None:
                    continue
                ways = [self._way_to(k, root, (root - shift) / scale, *begin) for k, root in roots]
                first = min(ways, key=cmp_to_key(self._compared))
                words: Words = ("the first place on the way where this holds",)
                return Choice(
                    first.root, words, first.turns * Fraction(self.numbers.of(scale) or 1).limit_denominator(1000)
                )
        return None

    def _compared(self, one: Way, other: Way) -> int:
        """Which way is shorter; from a summit it may go to either side, equally far: the smaller angle is told."""
        nearer = self.numbers.side(one.gap - other.gap)
        if isinstance(one.value, Number) and isinstance(other.value, Number):  # found numerically, as floats
            nearer = nearer if abs(self.numbers.of(one.gap - other.gap) or 0.0) > SAME_PLACE else 0
        return nearer or (one.turns != 0) - (other.turns != 0) or self.numbers.side(one.value - other.value) or 0

    def _begin(self, travel: Travel, letter: str, interval: str) -> tuple[Formula, int] | None:
        """Where the angle `letter` of a body at the end of a phase starts, and which way it goes: +1 where it grows, 0 where nothing tells.

        What is only just nudged on a circle goes its positive way.
        """
        phase = self.scene.configuration.timeline.interval(interval)
        place = self.scene.registry.quantities.get(letter)
        if phase is None:
            return None
        if travel.kind == "line" and place is not None and place.kind == "angle" and place.when == phase.end:
            circle = self.scene.instant(phase.end).orbit(travel.body)
            start = self._entry(travel.body, circle, phase.start) if circle and circle.owner == place.owner else None
            return None if circle is None or start is None else (start, circle.way * (self._onset(travel) or 1))
        if (
            travel.kind == "turn"
            and travel.start is not None
            and travel.end in (Symbol(letter), negate(Symbol(letter)))
        ):
            side = 1 if travel.end == Symbol(letter) else -1
            start = self._known(travel.start)
            return None if start is None else (start * Number(Fraction(side)), side * self._onset(travel))
        return None

    def _onset(self, travel: Travel) -> int:
        """Which way a coordinate sets out: as it moves at the start, else as it is pushed; 0 where nothing tells."""
        return self.numbers.sign((travel.before, self.numbers.push(travel.initial)))

    def _known(self, value: Formula) -> Formula | None:
        """A value with the answers put in; None where that leaves it without a number."""
        known = self.numbers.with_answers(value)
        return None if self.numbers.of(known) is None else known

    def _way_to(self, root: int, value: Formula, place: Formula, start: Formula, way: int) -> Way:
        """The way to a place on a circle; a place at which it is already is a whole turn away."""
        if not way:
            ahead = self.numbers.side(place - start)
            return Way(root, value, start - place if ahead == -1 else place - start)
        gap = place - start if way > 0 else start - place
        turns = self.numbers.whole(gap / TURN) or 0
        if self.numbers.side(gap - turns * TURN) == 0:
            turns -= 1
        return Way(root, value, gap - turns * TURN, -way * turns)

    def _entry(self, body: str, circle: Orbit, state: str) -> Formula | None:
        """Where on its circle a body is at the start of its way; a track leads into a bowl at its bottom, over a hill at its top."""
        instant = self.scene.instant(state)
        orbit = instant.orbit(body)
        if orbit == circle:
            return self._known(instant.place_on(circle))
        return None if orbit is None else PI / 2 if circle.level == ZERO else -PI / 2

    def _place_behind(self, name: str) -> tuple[str, Formula, Formula]:
        """The angle that an asked letter stands for, with the letter = scale · angle + shift."""
        formula = self.definition(name)
        angles = [key for key in formula.symbols() if SEPARATOR in key] if formula is not None else []
        if formula is None or len(angles) != 1:
            return name, ONE, ZERO
        at = [formula.substitute({angles[0]: Number(Fraction(value))}) for value in range(3)]
        if self.numbers.side(add(at[2], at[0]) - 2 * at[1]) != 0 or not self.numbers.side(at[1] - at[0]):
            return name, ONE, ZERO
        return angles[0], at[1] - at[0], at[0]
