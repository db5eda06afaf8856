"""Signs: which givens are positive, which sign a quantity must have, and so which of several roots is meant."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Words
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.writing import spoken
from rotsolve.inquiry.history import History
from rotsolve.scene.model import Given
from rotsolve.solver import Choice

TINY = 1e-14
POSITIVE = ("mass", "length", "moment of inertia", "stiffness", "torsional stiffness", "time", "acceleration")


@dataclass(frozen=True)
class Signs:
    """What a scene says of signs; `with_answers` puts in what is found, `aside` finds a letter without a derivation."""

    history: History
    givens: Mapping[str, Given]
    values: Mapping[str, Formula]
    with_answers: Callable[[Formula], Formula]
    aside: Callable[[str], Formula | None]

    def choose(self, name: str, roots: Sequence[Formula]) -> Choice | None:
        """The root that is meant, with the reason."""
        real = [(index, number) for index, root in enumerate(roots) if (number := self.number(root)) is not None]
        if not real:
            return self._unnumbered(name, roots) if self._lacks_numbers(roots) else None
        moved = [entry for entry in real if abs(entry[1]) > TINY]
        if len(moved) < len(real) and moved and self._is_change(name):
            real = moved  # the root 0 is the start itself
        if len(real) == 1:
            return real[0][0], ()
        sign, words = self.expected(name)
        if sign:
            fitting = [entry for entry in real if entry[1] * sign > 0]
            if fitting:
                return min(fitting, key=lambda entry: abs(entry[1]))[0], words
        if self._is_angle(name):
            return min(real, key=lambda entry: abs(entry[1]))[0], ("the smallest angle",)
        return min(real, key=lambda entry: (entry[1] < 0, abs(entry[1])))[0], ("the positive root",)

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
            return 1, words
        return 0, words or ("the root along the positive sense",)

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
        if quantity.kind in ("displacement", "rotation"):
            return self._onward(quantity.kind, quantity.owner, quantity.when)
        if quantity.kind in ("time", "tension", "mass", "normal_force"):
            return 1, (Symbol(name), " > 0")
        return 0, ()

    def _is_size(self, name: str) -> bool:
        """Whether a given has a dimension, so that it is meant to be positive."""
        given = self.givens.get(name)
        return given is not None and given.dimension is not None and not given.dimension.matches(DIMENSIONS["angle"])

    def _direction(self, kind: str, owner: str, state: str, name: str) -> tuple[int, Words]:
        """Which way a body moves at a state: the way it has gone since the state before, else as it started or is pushed."""
        timeline = self.history.arrangement.timeline
        if state not in timeline.order:
            return 0, ()
        before = timeline.before(state)
        quantity = self.history.registry.quantities[name]
        if before is None or before.event is not None:
            return 0, ()
        passage = self.history.passages[before.name]
        travel = next(
            (
                item
                for item in passage.travels
                if item.body == owner and (item.kind == "turn") == (kind == "angular_velocity")
            ),
            None,
        )
        if travel is None:
            return 0, ()
        change = travel.end - travel.start if travel.start is not None and travel.end is not None else travel.change
        for value in (change, travel.before, self._push(travel.initial)):
            size = self.number(self.with_answers(value)) if value is not None else None
            if size:
                sign = 1 if size > 0 else -1
                verb = "turns" if kind == "angular_velocity" else "moves"
                words = quantity.positive if sign > 0 else quantity.negative
                relation = " > 0" if sign > 0 else " < 0"
                return sign, (f"{spoken(owner)} {verb} {words}: ", Symbol(name), relation)
        return 0, ()

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


def positive_letters(givens: Sequence[Given]) -> frozenset[str]:
    """Givens that are positive: masses, lengths, times and the like, and every number that is."""
    result = set()
    values = {given.name: given.value for given in givens if given.value is not None}
    for given in givens:
        sized = given.dimension is not None and any(DIMENSIONS[word] == given.dimension for word in POSITIVE)
        if sized and not given.asked:
            result.add(given.name)
        elif given.value is not None and not given.asked and not is_angle(given):
            try:
                if (evaluate(given.value, values, digits=3).sign or 0) > 0:
                    result.add(given.name)
            except (Undefined, ValueError):
                continue
    return frozenset(result)


def is_angle(given: Given) -> bool:
    """Whether a given is an angle, which may be negative."""
    return given.dimension is not None and given.dimension == DIMENSIONS["angle"]
