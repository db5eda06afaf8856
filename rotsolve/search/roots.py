"""Roots: which of several roots is meant: the first moment, the stable place, the first place reached, the expected sign."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cmp_to_key

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import decided_by_size
from rotsolve.algebra.exact.linear import NotLinear, Singular, solve_all
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Number, Symbol, add, call, negate, sqrt
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.core.derivation import Words
from rotsolve.core.facts import signed
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.quantity import OSCILLATING
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import POSITION, RATES, is_key, key_of, of_kinds, phase_midst
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.bodies import Orbit
from rotsolve.language.problem import Given
from rotsolve.laws.groups import one_motion
from rotsolve.motion.positive import is_angle
from rotsolve.search.numbers import Numbers
from rotsolve.solver.steps import PickedRoot


class Expected(Struct, frozen=True):
    """What the motion of a scene tells of signs."""

    scene: SceneEquations
    givens: Mapping[str, Given]
    numbers: Numbers

    def sign(self, name: str) -> tuple[int, Words]:
        """The sign that a quantity must have, and why: (+1, −1 or 0 where nothing tells)."""
        quantity = self.scene.registry.quantities.get(name)
        if quantity is None:
            return (1, (Symbol(name), " > 0")) if self._is_size(name) else (0, ())
        if quantity.kind in ("velocity", "angular_velocity") and not quantity.component:
            return self._direction(quantity.kind, quantity.owner, quantity.when, name)
        if quantity.kind == "velocity" and quantity.component == "radial":
            return self._along_carrier(quantity.owner, quantity.when, name)
        if quantity.kind == "velocity" and quantity.when in self.scene.configuration.timeline.order:
            return self._by_turn(name, quantity)
        if quantity.kind in ("displacement", "rotation"):
            return self._onward(quantity.kind, quantity.owner, quantity.when)
        if quantity.kind in ("time", "tension", "mass", "normal_force", "period", *OSCILLATING):
            return 1, (Symbol(name), " > 0")
        return 0, ()

    def _is_size(self, name: str) -> bool:
        """Whether a given has a dimension, so that it is meant to be positive."""
        given = self.givens.get(name)
        return given is not None and given.dimension is not None and not given.dimension.matches(ANGLE)

    def _direction(self, kind: str, owner: str, state: str, name: str) -> tuple[int, Words]:
        """Which way a body moves at a state: the way it has gone since the state before, else as it started or is pushed.

        After an event, or at the first state, it is the way to the angle of the next state.
        """
        timeline = self.scene.configuration.timeline
        midst = phase_midst(state)
        if midst and (around := timeline.after(midst)) is not None:
            whole = "rotation" if kind == "angular_velocity" else "displacement"
            return self._onward(whole, owner, around.name)
        if state not in timeline.order:
            return 0, ()
        before, after = timeline.before(state), timeline.after(state)
        first = before is None or before.event is not None
        phase = after if first and after is not None else before
        wanted = "turn" if kind == "angular_velocity" else "line"
        travel = self._travel(phase.name, owner, wanted) if phase is not None else None
        if travel is None or phase is None:
            return 0, ()
        timed = 0 if first else self._in_time(travel, self.scene.passages[phase.name])
        if timed:
            return self._told(kind, owner, name, timed)
        change = travel.end - travel.start if travel.start is not None and travel.end is not None else None
        told = [change]
        gone = travel.change if change is None else change
        if not first and self.numbers.found(gone) == 0.0:  # it has come back
            told = [negate(travel.before)]
        elif not first:
            told += [gone, travel.before, self.numbers.push(travel.initial)]
        sign = self.numbers.sign(told)
        return self._told(kind, owner, name, sign) if sign else (0, ())

    def _in_time(self, travel: Travel, passage: Passage) -> int:
        """Which way a body moves after a known time where the push changes evenly with the place: v₀ cos ω t + (a₀/ω) sin ω t."""
        lead = next((one for one in passage.travels if one.leads and one.pace == POSITION), None)
        if lead is None or not isinstance(lead.coordinate, Symbol) or self.numbers.found(passage.duration) is None:
            return 0
        rate, start = self.numbers.push(lead.acceleration), self.numbers.push(travel.initial)
        slope = differentiate(rate, lead.coordinate.name) if rate is not None else None
        if (
            start is None and rate is not None and lead.start is not None and lead is travel
        ):  # the push at its first place
            start = rate.substitute({lead.coordinate.name: signed(lead.start, lead.sense)})
        if slope is None or start is None or lead.coordinate.name in slope.symbols():
            return 0
        square = -(self.numbers.with_answers(slope) * lead.sense / lead.arm)
        side, time = self.numbers.side(square), passage.duration
        if side == 0:
            return self.numbers.sign([travel.before + start * time])
        omega = sqrt(square if side == 1 else -square)
        grown, turned = call("exp", omega * time), [call(word, omega * time) for word in ("cos", "sin")]
        if side == -1:
            turned = [(grown + 1 / grown) / 2, (grown - 1 / grown) / 2]
        return self.numbers.sign([travel.before * turned[0] + start / omega * turned[1]])

    def _travel(self, interval: str, owner: str, kind: str) -> Travel | None:
        """How a body goes along its line, or turns, in a phase."""
        passage = self.scene.passages.get(interval)
        travels = passage.travels if passage is not None else ()
        return next((item for item in travels if item.body == owner and item.kind == kind), None)

    def _told(self, kind: str, owner: str, name: str, sign: int) -> tuple[int, Words]:
        """A sign with the words for it: "rod turns clockwise: ω > 0"."""
        quantity = self.scene.registry.quantities[name]
        verb = "turns" if kind == "angular_velocity" else "moves"
        words = quantity.positive if sign > 0 else quantity.negative
        return sign, (f"{spoken(owner)} {verb} {words}: ", Symbol(name), " > 0" if sign > 0 else " < 0")

    def _by_turn(self, name: str, quantity: SceneQuantity) -> tuple[int, Words]:
        """Which way a part of a velocity points: as the rules tie it to the turn of the body."""
        rules = list(self.scene.facts(quantity.when).rules)
        names = {letter for rule in rules for side in rule.velocity for letter in side.symbols()}
        rates = of_kinds(names, RATES)
        tied = (one_motion(rates, rules) or {}).get(name)
        turns = of_kinds(tied.symbols(), RATES) if tied is not None else []
        if tied is None or len(turns) != 1 or key_of(turns[0]).component:
            return 0, ()
        share = self.numbers.found(tied.substitute({turns[0]: ONE}))
        sign, words = self.sign(turns[0])
        return (0, ()) if not share else (sign if share > 0 else -sign, words)

    def _along_carrier(self, rider: str, state: str, name: str) -> tuple[int, Words]:
        """Which way a body slides along another: outwards where its distance from the axis has grown."""
        configuration = self.scene.configuration
        before = configuration.timeline.before(state) if state in configuration.timeline.order else None
        if before is None:
            return 0, ()
        places = [getattr(configuration.body(rider, when).shape, "radius", None) for when in (before.start, state)]
        grown = self.numbers.of(places[1] - places[0]) if places[0] is not None and places[1] is not None else None
        if not grown:
            return 0, ()
        way, relation = ("outwards", " > 0") if grown > 0 else ("inwards", " < 0")
        return (1 if grown > 0 else -1), (f"{spoken(rider)} slides {way}: ", Symbol(name), relation)

    def _onward(self, kind: str, owner: str, interval: str) -> tuple[int, Words]:
        """Which way a body goes in a phase: as it moves at the start, else as it is pushed."""
        travel = self._travel(interval, owner, "line" if kind == "displacement" else "turn")
        if travel is None:
            return 0, ()
        sign = self.numbers.sign((travel.before, self.numbers.push(travel.initial), travel.after))
        return (sign, ("the way in which it starts to move",)) if sign else (0, ())


TURN = 2 * PI
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

    def choose(self, name: str, roots: Sequence[tuple[int, Formula]]) -> PickedRoot | None:
        """Of several angles the one that a body comes to first on its way; None where nothing tells where it starts.

        The roots are all places in one turn at which the condition of the state holds, so that it holds at none before; of what a wire
        turns back, whole turns are no way to come to one.
        """
        letter, scale, shift = self.place_behind(name)
        for interval, passage in self.scene.passages.items():
            for travel in passage.travels:
                begin = self._begin(travel, letter, interval)
                if begin is None:
                    continue
                places = [(k, root, (root - shift) / scale) for k, root in roots]
                wound = travel.kind == "turn" and self.scene.instant(passage.end.state).wound(travel.body)
                ways = self._along_wire(places, *begin) if wound else self._round(places, *begin)
                first = min(ways, key=cmp_to_key(self._compared))
                words: Words = ("the first place on the way where this holds",)
                turns = first.turns * Fraction(self.numbers.of(scale) or 1).limit_denominator(1000)
                return PickedRoot(first.root, words, turns)
        return None

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

    def _linear(self, value: Formula, letter: str) -> tuple[Formula, Formula] | None:
        """Slope and rest of a value that is slope · letter + rest; None of any other."""
        at = [value.substitute({letter: Number(Fraction(number))}) for number in range(3)]
        if self.numbers.side(add(at[2], at[0]) - 2 * at[1]) != 0 or not self.numbers.side(at[1] - at[0]):
            return None
        return at[1] - at[0], at[0]

    def _onset(self, travel: Travel) -> int:
        """Which way a coordinate sets out: as it moves at the start, else as it is pushed; 0 where nothing tells."""
        return self.numbers.sign((travel.before, self.numbers.push(travel.initial)))

    def _known(self, value: Formula) -> Formula | None:
        """A value with the answers put in; None where that leaves it without a number."""
        known = self.numbers.with_answers(value)
        return None if self.numbers.of(known) is None else known

    def _way_to(self, root: int, value: Formula, place: Formula, start: Formula, way: int) -> WayToRoot:
        """The way to a place on a circle; a place at which it is already is a whole turn away."""
        if not way:
            ahead = self.numbers.side(place - start)
            return WayToRoot(root, value, start - place if ahead == -1 else place - start)
        gap = place - start if way > 0 else start - place
        turns = self.numbers.whole(gap / TURN) or 0
        rest = gap - turns * TURN
        found = isinstance(value, Number) and abs(self.numbers.of(rest) or 0.0) < SAME_PLACE  # numerically, as a float
        if found or self.numbers.side(rest) == 0:
            turns -= 1
        return WayToRoot(root, value, gap - turns * TURN, -way * turns)

    def _round(self, places: Sequence[tuple[int, Formula, Formula]], start: Formula, way: int) -> list[WayToRoot]:
        """The ways to places on a circle. Of those found numerically all are told, so that one ahead needs no whole turns: with friction
        or a couple they do not come again a turn later.
        """
        told = way and all(isinstance(root, Number) for _, root, _ in places)
        gaps = [(k, root, place - start if way > 0 else start - place) for k, root, place in places] if told else []
        ahead = [WayToRoot(k, root, gap) for k, root, gap in gaps if (self.numbers.of(gap) or 0.0) > SAME_PLACE]
        return ahead or [self._way_to(*place, start, way) for place in places]

    def _along_wire(self, places: Sequence[tuple[int, Formula, Formula]], start: Formula, way: int) -> list[WayToRoot]:
        """The ways to places none of which comes again a turn later: those ahead, else back to those behind."""
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


SAME = 1e-9  # relative difference up to which two places lie equally far to either side


class RootChoice(Struct, frozen=True):
    """Chooses between the roots of an equation; `definition` tells what an asked letter stands for."""

    scene: SceneEquations
    givens: Mapping[str, Given]
    numbers: Numbers
    definition: Callable[[str], Formula | None]

    def choose(self, name: str, roots: Sequence[Formula], period: Formula | None = None) -> PickedRoot | None:
        """The root that is meant, with the reason; a `period` later the equation holds again."""
        outwards = [index for index, root in enumerate(roots) if self._lacks_numbers(root)]
        if outwards and len(roots) > 1 and self._on_shaft(name):
            return PickedRoot(outwards[0], ("out from the axis, where the shaft turns fast enough for it",))
        real = [(index, number) for index, root in enumerate(roots) if (number := self.numbers.of(root)) is not None]
        if not real:
            return self._unnumbered(name, roots) if any(map(self._lacks_numbers, roots)) else None
        numbered = [(index, roots[index]) for index, _ in real]
        later = self._first_moment(name, numbered, period)
        if later is not None:
            return later
        moved = [entry for entry in real if entry[1]]
        dropped: Words = ()
        if len(moved) < len(real) and moved and self._is_change(name):
            real, dropped = moved, ("the root 0 is the start itself",)
            numbered = [(index, roots[index]) for index, _ in real]
        if not dropped and len(real) > 1 and len(left := self._left(name, real, roots)) < len(real):
            real, dropped = left, ("the other root is the start itself",)
            numbered = [(index, roots[index]) for index, _ in real]
        if len(real) == 1:
            index, number = real[0]
            opposed = isinstance(roots[index], Number) and number * self._expected(name)[0] < 0
            return PickedRoot(index, dropped, fits=not opposed)
        return self._of_several(name, real, numbered, roots)

    def _of_several(
        self, name: str, real: list[tuple[int, float]], numbered: list[tuple[int, Formula]], roots: Sequence[Formula]
    ) -> PickedRoot:
        """Of several roots that have numbers the one that is meant: a double one, the stable one, the first reached, the expected sign."""
        if all(self.numbers.side(root - numbered[0][1]) == 0 for _, root in numbered[1:]):
            return PickedRoot(real[0][0], ("the roots coincide: it is only just reached",))
        stable = self._stable(name, [root for _, root in numbered])
        if stable:
            found = sorted([real[place] for place in stable], key=lambda entry: entry[1] < 0)
            return PickedRoot(self._smallest(found, roots), ("the stable one: a body displaced from it comes back",))
        reached = FirstReached(self.scene, self.numbers, self.definition).choose(name, numbered)
        if reached is not None:
            return reached
        sign, words = self._expected(name)
        fitting = [entry for entry in real if entry[1] * sign > 0]
        if fitting:
            return PickedRoot(self._smallest(fitting, roots), words)
        if self._is_angle(name):
            return PickedRoot(self._smallest(real, roots), ("the smallest angle",))
        positive = [entry for entry in real if entry[1] >= 0]
        return PickedRoot(self._smallest(positive or real, roots), ("the positive root",))

    def _left(self, name: str, real: list[tuple[int, float]], roots: Sequence[Formula]) -> list[tuple[int, float]]:
        """Without the place from which a motion along a line sets out from rest, where it is looked for at rest again."""
        for passage in self.scene.passages.values():
            for travel in passage.travels:
                asked = travel.pace == POSITION and isinstance(travel.end, Symbol) and travel.end.name == name
                if asked and travel.kind == "line" and travel.before == ZERO and self._rests(travel.after, passage):
                    start = travel.start and self.numbers.with_answers(travel.start)
                    left = [(k, number) for k, number in real if not start or self.numbers.side(roots[k] - start) != 0]
                    return left or real
        return real

    def _rests(self, rate: Formula, passage: Passage) -> bool:
        """Whether a rate at the end of a phase is zero, as told or by what ties it to others."""
        if not isinstance(rate, Symbol):
            return rate == ZERO
        ties = [rule.velocity[0] - rule.velocity[1] for rule in self.scene.facts(passage.end.state).rules]
        names = {rate.name}
        while len(more := names.union(*(tie.symbols() for tie in ties if tie.symbols() & names))) > len(names):
            names = more
        rates = of_kinds(names, RATES)
        try:
            found = solve_all([tie for tie in ties if tie.symbols() & names], rates)
        except (NotLinear, Singular):
            return False
        return is_zero(found.get(rate.name, rate))

    def _expected(self, name: str) -> tuple[int, Words]:
        """The sign that a letter must have, also one that is a multiple of another, as a momentum is of a velocity, a work of a way."""
        expected = Expected(self.scene, self.givens, self.numbers)
        sign, words = expected.sign(name)
        formula = None if sign else self.definition(name) or self._spelled(name)
        letters = [key for key in formula.symbols() if is_key(key)] if formula is not None else []
        if formula is None or len(letters) != 1 or self.numbers.found(formula.substitute({letters[0]: ZERO})) != 0.0:
            return sign, words
        share = self.numbers.sign([formula.substitute({letters[0]: ONE})])
        sign, words = expected.sign(letters[0])
        return share * sign, words

    def _spelled(self, name: str) -> Formula | None:
        """What the letter of a work stands for."""
        works = (work for passage in self.scene.passages.values() for work in passage.works)
        return next((work.spelled for work in works if work.amount == Symbol(name)), None)

    def _smallest(self, entries: Sequence[tuple[int, float]], roots: Sequence[Formula]) -> int:
        """The root nearest to zero, of two that are equally far the first."""
        chosen = [roots[index] for index, _ in entries]
        if len(entries) < 2 or not any(map(self.numbers.signs.lacking, chosen)):
            return nearest_to_zero(entries)
        return entries[self.numbers.least([call("abs", root) for root in chosen])][0]

    def _on_shaft(self, name: str) -> bool:
        """Whether a letter tells the angle at which a body stands steadily on a turning shaft."""
        if not any(state.steady for state in self.scene.configuration.timeline.states):
            return False
        from rotsolve.search.swings import on_shaft

        return bool(on_shaft(name, self.scene))

    def _stable(self, name: str, roots: Sequence[Formula]) -> list[int]:
        """Places of the roots at which a body that stands somewhere comes back when it is displaced."""
        if not any(state.balance or state.steady for state in self.scene.configuration.timeline.states):
            return []
        from rotsolve.search.swings import stable_roots

        letter, scale, shift = FirstReached(self.scene, self.numbers, self.definition).place_behind(name)
        return stable_roots(letter, [(root - shift) / scale for root in roots], self.scene, self.numbers.signs)

    def _first_moment(
        self, name: str, roots: Sequence[tuple[int, Formula]], period: Formula | None
    ) -> PickedRoot | None:
        """Of times that come again the first one after the state before."""
        quantity = self.scene.registry.quantities.get(name)
        side = self.numbers.side(period) if period is not None else None
        if quantity is None or quantity.kind != "time" or period is None or not side:
            return None
        period = period if side > 0 else -period
        begun = self._begun(quantity.when)
        counts = [] if begun is None else [(k, self.numbers.whole((begun - root) / period), root) for k, root in roots]
        moments = [(k, count + 1, root + (count + 1) * period) for k, count, root in counts if count is not None]
        if not moments:
            return None
        index, count, _ = moments[self.numbers.least([moment for _, _, moment in moments])]
        return PickedRoot(index, ("the first moment at which this holds",), Fraction(count), period)

    def _begun(self, when: str) -> Formula | None:
        """The time at the state before a state; 0 for the duration of a phase."""
        timeline = self.scene.configuration.timeline
        if timeline.interval(when) is not None:
            return ZERO
        before = timeline.before(when) if when in timeline.order else None
        return self.numbers.with_answers(self.scene.instant(before.start).time()) if before else None

    def _is_change(self, name: str) -> bool:
        """Whether a quantity is a change since the state before, or the time that it took."""
        quantity = self.scene.registry.quantities.get(name)
        return quantity is not None and quantity.kind in ("displacement", "rotation", "time", "elongation")

    def _is_angle(self, name: str) -> bool:
        """Whether a letter is an angle."""
        given, quantity = self.givens.get(name), self.scene.registry.quantities.get(name)
        if quantity is not None:
            return quantity.kind == "angle"
        return given is not None and (given.dimension is None or is_angle(given))

    def _unnumbered(self, name: str, roots: Sequence[Formula]) -> PickedRoot:
        """Without numbers a root is chosen by the sign that the scene suggests: not negative unless said."""
        sign, words = Expected(self.scene, self.givens, self.numbers).sign(name)
        if sign < 0 and len(roots) > 1:
            return PickedRoot(1, words)
        return PickedRoot(0, words or ("the root along the positive sense",))

    def _lacks_numbers(self, root: Formula) -> bool:
        """Whether a root holds a given without a number."""
        signs = self.numbers.signs
        return not signs.trials.keys() >= set(signs.lacking(root))


def nearest_to_zero(entries: Sequence[tuple[int, float]]) -> int:
    """The root nearest to zero, of two that are equally far the first; its size is compared only where there are several."""
    least = abs(min(entries, key=lambda entry: abs(entry[1]))[1])
    near = [entry for entry in entries if abs(entry[1]) <= least * (1 + SAME)]
    if len(entries) > 1:
        decided_by_size()
    return near[0][0]
