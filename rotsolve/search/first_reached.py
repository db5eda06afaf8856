"""First reached: of several places at which a condition of a state holds the one to which a motion comes first."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from fractions import Fraction
from functools import cmp_to_key

from msgspec import Struct

from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Number, Symbol, add, negate
from rotsolve.core.derivation import Words
from rotsolve.core.passage import Travel
from rotsolve.core.symbols import POSITION, is_key, is_quantity
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.bodies import Orbit, PointRef
from rotsolve.search.expected import Expected
from rotsolve.search.numbers import Numbers
from rotsolve.solver.steps import PickedRoot

TURN = 2 * PI
FIRST: Words = ("the first place on the way where this holds",)
SAME_PLACE = 1e-9  # rad: how far numerical roots may be apart that are one place, whole turns apart


class WayToRoot(Struct, frozen=True):
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

    def choose(
        self, name: str, roots: Sequence[tuple[int, Formula]], period: Formula | None = None
    ) -> PickedRoot | None:
        """Of several angles the one that a body comes to first on its way; None where nothing tells where it starts.

        The roots are all places in one turn at which the condition of the state holds, so that it holds at none before. Where what drives
        goes by the angle itself, as a wire does, it does not hold again a `period` later, and whole turns are no way to come to one.
        """
        letter, scale, shift = self.place_behind(name)
        for interval, passage in self.scene.passages.items():
            for travel in passage.travels:
                begin, along = self._begin(travel, letter, interval), self._along(travel, letter)
                if begin is None and along is None:
                    continue
                turned_back = period is None and not all(isinstance(root, Number) for _, root in roots)
                turned_back |= travel.kind == "turn" and self.scene.instant(passage.end.state).wound(travel.body)
                turned_back |= begin is None
                places: Sequence[tuple[int, Formula, Formula]] = [
                    (k, root, (root - shift) / scale) for k, root in roots
                ]
                start, way = begin or along or (ZERO, 0)
                if begin is not None and not way:
                    places = self._in_front(places, letter, passage.end.state)
                return self.first_of(places, start, way, scale, again=not turned_back)
        return self._on_ride(letter, roots)

    def first_of(
        self, places: Sequence[tuple[int, Formula, Formula]], start: Formula, way: int, scale: Formula, *, again: bool
    ) -> PickedRoot:
        """Of places, each with its root and that, the first one on the way from a start; whether it holds `again` a turn later."""
        ways = self._round(places, start, way) if again else self._there_and_back(places, start, way)
        first = min(ways, key=cmp_to_key(self._compared))
        turns = first.turns * Fraction(self.numbers.of(scale) or 1).limit_denominator(1000)
        return PickedRoot(first.root, FIRST, turns, reached=True)

    def _compared(self, one: WayToRoot, other: WayToRoot) -> int:
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
        if travel.kind != "turn" or travel.start is None or travel.end is None or letter not in travel.end.symbols():
            return None
        found = self._linear(travel.end, letter)
        start = self._known(travel.start)
        if found is None or start is None:
            return None
        slope, rest = found
        if self.numbers.side(slope**2 - 1) != 0:
            return None
        return (start - rest) / slope, (self.numbers.side(slope) or 0) * self._onset(travel)

    def _along(self, travel: Travel, letter: str) -> tuple[Formula, int] | None:
        """Where the way of a body that a letter tells starts, and which way it goes; None where nothing tells that."""
        if travel.pace != POSITION:
            return None
        end, start = (
            (travel.change, ZERO) if travel.end is None or travel.kind == "turn" else (travel.end, travel.start)
        )
        found = self._linear(end, letter) if letter in end.symbols() and start is not None else None
        begun = None if found is None or start is None else self._known((start - found[1]) / found[0])
        way = 0 if found is None else (self.numbers.side(found[0]) or 0) * self._onset(travel)
        return (begun, way) if begun is not None and way else None

    def _on_ride(self, letter: str, roots: Sequence[tuple[int, Formula]]) -> PickedRoot | None:
        """Of several distances from the axis the one to which a body first comes that slides along another; None where nothing tells which
        way it goes."""
        timeline, body = self.scene.configuration.timeline, self.scene.configuration.body
        for interval in timeline.intervals:
            for ride in self.scene.configuration.rides(interval.start) if interval.event is None else ():
                name = ride.rider.owner
                start, end = (getattr(body(name, at).shape, "radius", None) for at in (interval.start, interval.end))
                if start is None or end != Symbol(letter):
                    continue
                begun, way = self._known(start), self._way(self.scene.instant(interval.start).outward(name))
                places = [(k, root, root) for k, root in roots if self.numbers.side(root) in (0, 1)]
                return self.first_of(places, begun, way, ONE, again=False) if begun and way and places else None
        return None

    def _in_front(
        self, places: Sequence[tuple[int, Formula, Formula]], letter: str, state: str
    ) -> Sequence[tuple[int, Formula, Formula]]:
        """The places at which all bodies lie in front of the surfaces that they touch, where the way there is not told; else all."""
        from rotsolve.search.swings import bodies_standing

        bodies = {body.name for body, _, _ in bodies_standing(letter, [state], self.scene)}
        gaps = list(gaps_to_surfaces(bodies, state, self.scene)) if bodies else []
        front = [
            one for one in places if all(self.numbers.side(gap.substitute({letter: one[2]})) != -1 for gap in gaps)
        ]
        return front or places

    def _linear(self, value: Formula, letter: str) -> tuple[Formula, Formula] | None:
        """Slope and rest of a value that is slope · letter + rest; None of any other."""
        at = [value.substitute({letter: Number(Fraction(number))}) for number in range(3)]
        if self.numbers.side(add(at[2], at[0]) - 2 * at[1]) != 0 or not self.numbers.side(at[1] - at[0]):
            return None
        return at[1] - at[0], at[0]

    def _onset(self, travel: Travel) -> int:
        """Which way a coordinate sets out: as it moves at the start, else as it is pushed; 0 where nothing tells."""
        return self.numbers.onset(travel) or self._way(travel.before)

    def _way(self, rate: Formula) -> int:
        """The sign of a rate at a state, as numbers tell it, else as it has moved there; 0 where nothing tells."""
        known = self.numbers.sign((rate,))
        return known or (Expected(self.scene, {}, self.numbers).sign(rate.name)[0] if is_quantity(rate) else 0)

    def _known(self, value: Formula) -> Formula | None:
        """A value with the answers put in; None where that leaves it without a number."""
        known = self.numbers.with_answers(value)
        return None if self.numbers.of(known) is None else known

    def _way_to(self, root: int, value: Formula, place: Formula, start: Formula, way: int) -> WayToRoot:
        """The way to a place on a circle; a place at which it is already is a whole turn away."""
        if not way:
            ahead = self.numbers.side(place - start)
            return WayToRoot(root, value, start - place if ahead == -1 else place - start if ahead else TURN)
        gap = place - start if way > 0 else start - place
        turns = self.numbers.whole(gap / TURN) or 0
        rest = gap - turns * TURN
        found = isinstance(value, Number) and abs(self.numbers.of(rest) or 0.0) < SAME_PLACE  # numerically, as a float
        if found or self.numbers.side(rest) == 0:
            turns -= 1
        return WayToRoot(root, value, gap - turns * TURN, -way * turns)

    def _elsewhere(
        self, places: Sequence[tuple[int, Formula, Formula]], start: Formula
    ) -> Sequence[tuple[int, Formula, Formula]]:
        """The places without that at which it starts, which a float misses by its rounding; that alone where there is no other."""
        gaps = [self.numbers.of(place - start) if isinstance(root, Number) else None for _, root, place in places]
        others = [item for item, gap in zip(places, gaps, strict=True) if gap is None or abs(gap) > SAME_PLACE]
        return others or places

    def _round(self, places: Sequence[tuple[int, Formula, Formula]], start: Formula, way: int) -> list[WayToRoot]:
        """The ways to places on a circle. Of those found numerically all are told, so that one ahead needs no whole turns: with friction
        or a couple they do not come again a turn later.
        """
        told = way and all(isinstance(root, Number) for _, root, _ in places)
        gaps = [(k, root, place - start if way > 0 else start - place) for k, root, place in places] if told else []
        ahead = [WayToRoot(k, root, gap) for k, root, gap in gaps if (self.numbers.of(gap) or 0.0) > SAME_PLACE]
        return ahead or [self._way_to(*place, start, way) for place in places]

    def _there_and_back(
        self, places: Sequence[tuple[int, Formula, Formula]], start: Formula, way: int
    ) -> list[WayToRoot]:
        """The ways to places none of which comes again a turn later: those ahead, else back to those behind."""
        places = self._elsewhere(places, start)
        if not way:
            return [self._way_to(*place, start, way) for place in places]
        gaps = [(k, root, place - start if way > 0 else start - place) for k, root, place in places]
        ahead = [WayToRoot(k, root, gap) for k, root, gap in gaps if self.numbers.side(gap) == 1]
        return ahead or [WayToRoot(k, root, negate(gap)) for k, root, gap in gaps]

    def _entry(self, body: str, circle: Orbit, state: str) -> Formula | None:
        """Where on its circle a body is at the start of its way; a track leads into a bowl at its bottom, over a hill at its top."""
        instant = self.scene.instant(state)
        orbit = instant.orbit(body)
        if orbit == circle:
            return self._known(instant.place_on(circle))
        return None if orbit is None else PI / 2 if circle.level == ZERO else -PI / 2

    def place_behind(self, name: str) -> tuple[str, Formula, Formula]:
        """The angle that an asked letter stands for, with the letter = scale · angle + shift."""
        formula = self.definition(name)
        angles = [key for key in formula.symbols() if is_key(key)] if formula is not None else []
        if formula is None or len(angles) != 1:
            return name, ONE, ZERO
        found = self._linear(formula, angles[0])
        return (name, ONE, ZERO) if found is None else (angles[0], *found)


def gaps_to_surfaces(bodies: Collection[str], state: str, scene: SceneEquations) -> Iterator[Formula]:
    """How far in front of each surface that they touch the centres of mass of some bodies lie at a state."""
    instant = scene.instant(state)
    for item in scene.configuration.connections(state):
        away = item.away(instant)
        if away is not None and (name := item.slider().owner) in bodies:
            yield (instant.point(PointRef(name, "cm")) - item.touching_arm(instant)).along(away)
