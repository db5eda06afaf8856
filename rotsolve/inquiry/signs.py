"""Signs: which givens are positive, which sign a quantity must have, and so which of several roots is meant."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import floor, pi

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import ONE, ZERO, Formula, Number, Symbol, negate
from rotsolve.core.derivation import Words
from rotsolve.core.passage import Travel
from rotsolve.core.quantity import DIMENSIONS, OSCILLATING
from rotsolve.core.registry import GENERIC, SEPARATOR, Quantity
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.connection import Orbit
from rotsolve.inquiry.history import History
from rotsolve.inquiry.swings.steady import OUTWARDS, STABLE, on_shaft, stable_roots
from rotsolve.motion.positive import is_angle
from rotsolve.principles.energy import one_motion
from rotsolve.scene.model import Given
from rotsolve.solver import Choice

TINY = 1e-14
TURN = 2 * pi
RATES = ("velocity|", "angular_velocity|")


@dataclass(frozen=True)
class Signs:
    """What a scene says of signs; `with_answers` puts in what is found, `aside` finds a letter without a derivation, `definition` tells
    what an asked letter stands for."""

    history: History
    givens: Mapping[str, Given]
    values: Mapping[str, Formula]
    with_answers: Callable[[Formula], Formula]
    aside: Callable[[str], Formula | None]
    definition: Callable[[str], Formula | None]

    def choose(self, name: str, roots: Sequence[Formula], period: Formula | None = None) -> Choice | None:
        """The root that is meant, with the reason; a `period` later the equation holds again."""
        outwards = [index for index, root in enumerate(roots) if root.symbols() - set(self.values)]
        if outwards and len(roots) > 1 and on_shaft(name, self.history):
            return Choice(outwards[0], OUTWARDS)
        real = [(index, number) for index, root in enumerate(roots) if (number := self.number(root)) is not None]
        if not real:
            return self._unnumbered(name, roots) if self._lacks_numbers(roots) else None
        later = self._first_moment(name, real, period)
        if later is not None:
            return later
        moved = [entry for entry in real if abs(entry[1]) > TINY]
        dropped: Words = ()
        if len(moved) < len(real) and moved and self._is_change(name):
            real, dropped = moved, ("the root 0 is the start itself",)
        if len(real) == 1:
            return Choice(real[0][0], dropped)
        stable = stable_roots(name, [roots[index] for index, _ in real], self.history, self.values)
        if stable:
            real = [real[place] for place in stable]
            return Choice(min(real, key=lambda entry: (entry[1] < 0, abs(entry[1])))[0], STABLE)
        reached = self._first_reached(name, real)
        if reached is not None:
            return reached
        sign, words = self.expected(name)
        if sign:
            fitting = [entry for entry in real if entry[1] * sign > 0]
            if fitting:
                return Choice(min(fitting, key=lambda entry: abs(entry[1]))[0], words)
        if self._is_angle(name):
            return Choice(min(real, key=lambda entry: abs(entry[1]))[0], ("the smallest angle",))
        return Choice(min(real, key=lambda entry: (entry[1] < 0, abs(entry[1])))[0], ("the positive root",))

    def _first_moment(self, name: str, roots: Sequence[tuple[int, float]], period: Formula | None) -> Choice | None:
        """Of times that come again the first one after the state before."""
        quantity = self.history.registry.quantities.get(name)
        step = self.number(period) if period is not None else None
        if quantity is None or quantity.kind != "time" or period is None or not step:
            return None
        begun = self._begun(quantity.when)
        if begun is None:
            return None
        turns = [(index, floor((begun - root) / step + TINY) + 1 if step > 0 else 0, root) for index, root in roots]
        index, count, _ = min(turns, key=lambda entry: entry[2] + entry[1] * step)
        return Choice(index, ("the first moment at which this holds",), Fraction(count), period)

    def _begun(self, when: str) -> float | None:
        """The time at the state before a state; 0 for the duration of a phase."""
        timeline = self.history.arrangement.timeline
        if timeline.interval(when) is not None:
            return 0.0
        before = timeline.before(when) if when in timeline.order else None
        return self.number(self.with_answers(self.history.instant(before.start).time())) if before else None

    def _first_reached(self, name: str, roots: Sequence[tuple[int, float]]) -> Choice | None:
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
            start = self.number(self.with_answers(travel.start))
            return None if start is None else (start * side, side * self._onset(travel))
        return None

    def _onset(self, travel: Travel) -> int:
        """Which way a coordinate sets out: as it moves at the start, else as it is pushed; 0 where nothing tells."""
        for value in (travel.before, self._push(travel.initial)):
            size = self.number(self.with_answers(value)) if value is not None else None
            if size:
                return 1 if size > 0 else -1
        return 0

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
            return self.number(self.with_answers(instant.place_on(circle)))
        return None if orbit is None else pi / 2 if circle.level == ZERO else -pi / 2

    def _place_behind(self, name: str) -> tuple[str, float, float]:
        """The angle that an asked letter stands for, with the letter = scale · angle + shift."""
        formula = self.definition(name)
        angles = [key for key in formula.symbols() if SEPARATOR in key] if formula is not None else []
        if formula is None or len(angles) != 1:
            return name, 1.0, 0.0
        at = [self.number(formula.substitute({angles[0]: Number(Fraction(value))})) for value in (0, 1, 2)]
        if at[0] is None or at[1] is None or at[2] is None or abs(at[2] + at[0] - 2 * at[1]) > TINY or at[1] == at[0]:
            return name, 1.0, 0.0
        return angles[0], at[1] - at[0], at[0]

    def _is_change(self, name: str) -> bool:
        """Whether a quantity is a change since the state before, or the time that it took."""
        quantity = self.history.registry.quantities.get(name)
        return quantity is not None and quantity.kind in ("displacement", "rotation", "time", "elongation")

    def _is_angle(self, name: str) -> bool:
        """Whether a letter is an angle."""
        given, quantity = self.givens.get(name), self.history.registry.quantities.get(name)
        if quantity is not None:
            return quantity.kind == "angle"
        return given is not None and (given.dimension is None or is_angle(given))

    def _unnumbered(self, name: str, roots: Sequence[Formula]) -> Choice:
        """Without numbers a root is chosen by the sign that the scene suggests: not negative unless said."""
        sign, words = self.expected(name)
        if sign < 0 and len(roots) > 1:
            return Choice(1, words)
        return Choice(0, words or ("the root along the positive sense",))

    def _lacks_numbers(self, roots: Sequence[Formula]) -> bool:
        """Whether a root holds a given without a number."""
        return any(root.symbols() - set(self.values) for root in roots)

    def number(self, value: Formula) -> float | None:
        """A rough value; None where it is not real or a given has no number."""
        try:
            return evaluate(value, self.values, digits=8).float
        except (Undefined, ValueError, ZeroDivisionError):
            return None

    def expected(self, name: str) -> tuple[int, Words]:
        """The sign that a quantity must have, and why: (+1, −1 or 0 where nothing tells)."""
        quantity = self.history.registry.quantities.get(name)
        if quantity is None:
            return (1, (Symbol(name), " > 0")) if self._is_size(name) else (0, ())
        if quantity.kind in ("velocity", "angular_velocity") and not quantity.component:
            return self._direction(quantity.kind, quantity.owner, quantity.when, name)
        if quantity.kind == "velocity" and quantity.component == "radial":
            return self._along_carrier(quantity.owner, quantity.when, name)
        if quantity.kind == "velocity" and quantity.when in self.history.arrangement.timeline.order:
            return self._by_turn(name, quantity)
        if quantity.kind in ("displacement", "rotation"):
            return self._onward(quantity.kind, quantity.owner, quantity.when)
        if quantity.kind in ("time", "tension", "mass", "normal_force", "period", *OSCILLATING):
            return 1, (Symbol(name), " > 0")
        return 0, ()

    def _is_size(self, name: str) -> bool:
        """Whether a given has a dimension, so that it is meant to be positive."""
        given = self.givens.get(name)
        return given is not None and given.dimension is not None and not given.dimension.matches(DIMENSIONS["angle"])

    def _direction(self, kind: str, owner: str, state: str, name: str) -> tuple[int, Words]:
        """Which way a body moves at a state: the way it has gone since the state before, else as it started or is pushed.

        After an event, or at the first state, it is the way to the angle of the next state.
        """
        timeline = self.history.arrangement.timeline
        midst = state.removeprefix(GENERIC)
        if midst != state and (phase := timeline.after(midst)) is not None:
            whole = "rotation" if kind == "angular_velocity" else "displacement"
            return self._onward(whole, owner, phase.name)
        if state not in timeline.order:
            return 0, ()
        before, after = timeline.before(state), timeline.after(state)
        first = before is None or before.event is not None
        passage = self.history.passages.get(
            after.name if first and after is not None else before.name if before else ""
        )
        wanted = "turn" if kind == "angular_velocity" else "line"
        travels = passage.travels if passage is not None else ()
        travel = next((item for item in travels if item.body == owner and item.kind == wanted), None)
        if travel is None:
            return 0, ()
        change = travel.end - travel.start if travel.start is not None and travel.end is not None else None
        rest = () if first else (travel.change if change is None else None, travel.before, self._push(travel.initial))
        for value in (change, *rest):
            size = self.number(self.with_answers(value)) if value is not None else None
            if size:
                return self._told(kind, owner, name, 1 if size > 0 else -1)
        return 0, ()

    def _told(self, kind: str, owner: str, name: str, sign: int) -> tuple[int, Words]:
        """A sign with the words for it: "rod turns clockwise: ω > 0"."""
        quantity = self.history.registry.quantities[name]
        verb = "turns" if kind == "angular_velocity" else "moves"
        words = quantity.positive if sign > 0 else quantity.negative
        return sign, (f"{spoken(owner)} {verb} {words}: ", Symbol(name), " > 0" if sign > 0 else " < 0")

    def _by_turn(self, name: str, quantity: Quantity) -> tuple[int, Words]:
        """Which way a part of a velocity points: as the rules tie it to the turn of the body."""
        rules = list(self.history.facts(quantity.when).rules)
        names = {letter for rule in rules for side in rule.velocity for letter in side.symbols()}
        rates = sorted(letter for letter in names if letter.startswith(RATES))
        tied = (one_motion(rates, rules) or {}).get(name)
        turns = [letter for letter in tied.symbols() if letter.startswith(RATES)] if tied is not None else []
        if tied is None or len(turns) != 1 or turns[0].split(SEPARATOR)[2]:
            return 0, ()
        share = self.number(self.with_answers(tied.substitute({turns[0]: ONE})))
        sign, words = self.expected(turns[0])
        return (0, ()) if not share else (sign if share > 0 else -sign, words)

    def _along_carrier(self, rider: str, state: str, name: str) -> tuple[int, Words]:
        """Which way a body slides along another: outwards where its distance from the axis has grown."""
        arrangement = self.history.arrangement
        before = arrangement.timeline.before(state) if state in arrangement.timeline.order else None
        if before is None:
            return 0, ()
        places = [getattr(arrangement.body(rider, when).shape, "radius", None) for when in (before.start, state)]
        grown = self.number(places[1] - places[0]) if places[0] is not None and places[1] is not None else None
        if not grown:
            return 0, ()
        way, relation = ("outwards", " > 0") if grown > 0 else ("inwards", " < 0")
        return (1 if grown > 0 else -1), (f"{spoken(rider)} slides {way}: ", Symbol(name), relation)

    def _onward(self, kind: str, owner: str, interval: str) -> tuple[int, Words]:
        """Which way a body goes in a phase: as it moves at the start, else as it is pushed."""
        passage = self.history.passages.get(interval)
        wanted = "line" if kind == "displacement" else "turn"
        travel = (
            next((item for item in passage.travels if item.body == owner and item.kind == wanted), None)
            if passage
            else None
        )
        if travel is None:
            return 0, ()
        for value in (travel.before, self._push(travel.initial), travel.after):
            size = self.number(self.with_answers(value)) if value is not None else None
            if size:
                return (1 if size > 0 else -1), ("the way in which it starts to move",)
        return 0, ()

    def _push(self, acceleration: Formula | None) -> Formula | None:
        """The acceleration that starts the motion, found aside."""
        if acceleration is None or not isinstance(acceleration, Symbol) or SEPARATOR not in acceleration.name:
            return acceleration
        return self.aside(acceleration.name)
