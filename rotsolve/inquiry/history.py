"""History: a whole scene in time: instants with their facts, what the states fix, and all equations that the laws write about it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.equation import Equation
from rotsolve.core.facts import Facts
from rotsolve.core.passage import Encounter, Passage
from rotsolve.core.registry import SEPARATOR, Registry
from rotsolve.elements.connections.contacts import Touch
from rotsolve.inquiry.questions import NotYet, Reader
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.encounters import encounter, participants
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.motion.passages import displacement, groups_of, passage, rotation
from rotsolve.motion.timeline import Interval
from rotsolve.principles import constraints, energy, kinematics, momentum, newton
from rotsolve.principles import rotation as turning
from rotsolve.scene.model import Condition, Path, State

RATE_OF = {  # what is zero where a quantity is largest or smallest
    "angle": "angular_velocity",
    "rotation": "angular_velocity",
    "angular_velocity": "angular_acceleration",
    "displacement": "velocity",
    "height": "velocity",
    "velocity": "acceleration",
}
RATES = ("velocity", "angular_velocity")


@dataclass
class History:
    """One reading of a scene, with the ways in which contacts slip in `modes`."""

    arrangement: Arrangement
    modes: Mapping[str, str] = field(default_factory=dict)
    registry: Registry = field(default_factory=Registry)
    stated: list[tuple[Equation, Condition]] = field(default_factory=list)
    _instants: dict[tuple[str, bool, bool], Instant] = field(default_factory=dict)
    _facts: dict[tuple[str, bool, bool], Facts] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for state in self.arrangement.timeline.states:
            self._carry_over(state)
            for condition in state.conditions:
                self._fix(state, condition)
            if state.balance:
                self._rest(state.name, "all")
                self._balance(state.name)
        self._driven()
        self._instants.clear()
        self._facts.clear()

    def instant(self, state: str, *, generic: bool = False, virtual: bool = False) -> Instant:
        key = (state, generic, virtual)
        if key not in self._instants:
            self._instants[key] = Instant(self.arrangement, self.registry, state, generic, self.modes, virtual)
        return self._instants[key]

    def facts(self, state: str, *, generic: bool = False, virtual: bool = False) -> Facts:
        key = (state, generic, virtual)
        if key not in self._facts:
            self._facts[key] = free_bodies(self.instant(state, generic=generic, virtual=virtual))
        return self._facts[key]

    def reader(self, state: str) -> Reader:
        return Reader(self.instant(state), lambda: self.facts(state))

    # what the states say

    def _carry_over(self, state: State) -> None:
        """The clock starts at the first state; an event takes no time, moves nothing, and leaves what it does not touch."""
        timeline, fresh = self.arrangement.timeline, self._fresh(state.name)
        before = timeline.before(state.name)
        if before is None:
            self._set(fresh.time(), ZERO)
        elif before.event is not None:
            last = self._fresh(before.start)
            self._set(fresh.time(), last.time())
            said = {line.path.owner for line in state.conditions if line.path and line.path.quantity in RATES}
            touched = self._touched(before) | said | ({"all"} if any(line.rest for line in state.conditions) else set())
            for item in self.arrangement.connections(state.name):
                if item.word == "spring":
                    self._set(fresh.ask("elongation", item.name), last.ask("elongation", item.name))
                    self._set(
                        fresh.ask("force", item.name, when=fresh.when), last.ask("force", item.name, when=last.when)
                    )
            for body in self.arrangement.present(state.name):
                old, new = last.angle(body.name), fresh.angle(body.name)
                if old is not None and new is not None:
                    self._set(new, old)
                if body.name not in touched and "all" not in touched:
                    for one, other in zip(self._rates(last, body.name), self._rates(fresh, body.name), strict=False):
                        self._set(other, one)

    def _touched(self, interval: Interval) -> frozenset[str]:
        """Bodies whose velocities an event changes."""
        found: frozenset[str] = frozenset()
        for ref in participants(interval.event):  # type: ignore[arg-type]
            for state in (interval.start, interval.end):
                found |= self.arrangement.component(ref.owner, state)
        return found

    def _fresh(self, state: str) -> Instant:
        return Instant(self.arrangement, self.registry, state, False, self.modes)

    def _rates(self, instant: Instant, name: str) -> list[Formula]:
        """The velocity letters of a body at an instant."""
        motion, line = instant.motion(name), instant.arrangement.line(name, instant.state)
        rates: list[Formula] = []
        if motion.kind == "line":
            rates.append(instant.travel("velocity", name, line[1] if line else ""))
        elif motion.kind == "plane":
            rates += [instant.component("velocity", name, axis) for axis in "xy"]
        if motion.turns:
            rates.append(instant.rate("angular_velocity", name))
        return rates

    def _set(self, letter: Formula, value: Formula) -> None:
        if isinstance(letter, Symbol) and SEPARATOR in letter.name and letter != value:
            self.registry.known[letter.name] = value

    def _fix(self, state: State, condition: Condition) -> None:
        """Take a line of a state; one that can not be worked out is refused at its place."""
        try:
            self._take(state, condition)
        except NotYet as error:
            raise NotYet(str(error), error.span or condition.span, error.help) from None

    def _take(self, state: State, condition: Condition) -> None:
        """Take rest, a quantity with a value, or a word."""
        if condition.rest:
            self._rest(state.name, condition.owner or "all")
        elif condition.path is not None and condition.word == "slack":
            self._set(self._letter(state.name, Path(condition.path.owner, "tension")), ZERO)
        elif condition.path is not None and condition.word in ("largest", "smallest"):
            rate = RATE_OF.get(condition.path.quantity)
            if rate is None:
                raise NotYet(f"`{condition.word}` of `{condition.path.quantity}` is not solved yet")
            self._set(self._letter(state.name, replace(condition.path, quantity=rate)), ZERO)
        elif condition.path is not None and condition.value is not None:
            letter = self._letter(state.name, condition.path)
            if isinstance(letter, Symbol) and SEPARATOR in letter.name:
                self._set(letter, condition.value)
            elif letter != condition.value:
                label = "stated" if letter.symbols() else "given"
                self.stated.append((Equation(letter, condition.value, label, state.name, "", 1), condition))

    def _letter(self, state: str, path: Path) -> Formula:
        """What a line of a state speaks of: a quantity of this moment, or of the phase that ends here."""
        instant = self._fresh(state)
        if path.quantity in ("displacement", "rotation"):
            before = self.arrangement.timeline.before(state)
            if before is None:
                return ZERO
            name = instant.host(path.owner)
            return (
                displacement(name, before, instant)
                if path.quantity == "displacement"
                else rotation(name, before, instant)
            )
        return Reader(instant, lambda: free_bodies(instant)).meaning(path).formula

    def _rest(self, state: str, owner: str) -> None:
        instant = self._fresh(state)
        for body in self.arrangement.present(state):
            if owner in ("all", body.name):
                for rate in self._rates(instant, body.name):
                    self._set(rate, ZERO)

    def _balance(self, state: str) -> None:
        """In equilibrium nothing accelerates."""
        instant = self._fresh(state)
        for body in self.arrangement.present(state):
            motion = instant.motion(body.name)
            rates = [size for size, _ in motion.acceleration.parts]
            if motion.turns:
                rates.append(instant.rate("angular_acceleration", body.name))
            for rate in rates:
                self._set(rate, ZERO)

    def _driven(self) -> None:
        """Rates that a drive prescribes."""
        for state in self.arrangement.timeline.states:
            instant = self._fresh(state.name)
            for item in self.arrangement.connections(state.name):
                for word in ("angle", "angular_velocity", "angular_acceleration"):
                    value = getattr(item, word, None)
                    if isinstance(value, Formula):
                        name = instant.host(item.touches()[-1].owner)
                        letter = instant.ask("angle", name) if word == "angle" else instant.rate(word, name)
                        self._set(letter, value.substitute({"time": instant.time()}))
                    if isinstance(value, Formula) and word == "angular_velocity" and "time" not in value.symbols():
                        self._set(instant.rate("angular_acceleration", name), ZERO)

    # what the laws write

    @cached_property
    def passages(self) -> dict[str, Passage]:
        """All phases by name."""
        result = {}
        for interval in self.arrangement.timeline.intervals:
            if interval.event is None:
                pair = [(self.instant(state), self.facts(state)) for state in (interval.start, interval.end)]
                midst = (self.instant(interval.start, generic=True), self.facts(interval.start, generic=True))
                result[interval.name] = passage(interval, pair[0], pair[1], midst)
        return result

    @cached_property
    def encounters(self) -> dict[str, Encounter]:
        """All events that change velocities, by name."""
        result = {}
        for interval in self.arrangement.timeline.intervals:
            if interval.event is not None:
                pair = [(self.instant(state), self.facts(state)) for state in (interval.start, interval.end)]
                found = encounter(interval, pair[0], pair[1])
                if found is not None:
                    result[interval.name] = found
        return result

    @cached_property
    def equations(self) -> list[Equation]:
        """All equations, each once, none that says nothing; `stated` lines of the states first."""
        written: dict[tuple[Formula, Formula, str], Equation] = {}
        for equation in self._written():
            key = (equation.left, equation.right, equation.family)
            if equation.left != equation.right and key not in written and not self._empty(equation):
                written[key] = equation
        return list(written.values())

    def _empty(self, equation: Equation) -> bool:
        """Whether an equation holds whatever happens (0 = 0 once rest is put in)."""
        names = equation.symbols()
        return not any(SEPARATOR in name for name in names) and is_zero(equation.left - equation.right)

    def _written(self) -> Iterator[Equation]:
        yield from (equation for equation, _ in self.stated)
        for state in self.arrangement.timeline.states:
            yield from self._at(state.name)
        for interval in self.arrangement.timeline.intervals:
            if interval.name in self.passages:
                yield from self._during(interval, self.passages[interval.name])
            elif interval.name in self.encounters:
                yield from momentum.through_event(self.encounters[interval.name], interval.name)
        yield from self._elongations()
        yield from self._grips()

    def _grips(self) -> Iterator[Equation]:
        """Contacts that a state says to roll or stick: their touching points are at rest then."""
        for state in self.arrangement.timeline.states:
            said = {
                line.path.owner
                for line in state.conditions
                if line.path is not None and line.word in ("rolls", "sticks")
            }
            for item in self.arrangement.connections(state.name):
                if item.name in said and isinstance(item, Touch):
                    rule = item.grip_rule(self.instant(state.name))
                    if rule is not None:
                        yield constraints.written(rule, rule.velocity, state.name)

    def section(self, state: str) -> str:
        """Where the laws at a state are written: with the whole phase while accelerations in it are constant."""
        spans = {self.arrangement.span(body.name, state) for body in self.arrangement.present(state)}
        return spans.pop() if len(spans) == 1 else state

    def _at(self, state: str) -> Iterator[Equation]:
        """Newton's laws, the rules and the definitions at a state, and the rates of energy and angular momentum."""
        facts, section = self.facts(state), self.section(state)
        yield from turning.moments_of_inertia(facts, section)
        yield from newton.second_law(facts, section)
        yield from turning.law_of_rotation(facts, section)
        yield from constraints.for_accelerations(facts, section)
        yield from constraints.for_velocities(facts, state)
        virtual = self.facts(state, virtual=True)
        for group in groups_of(self.arrangement, facts, state):
            yield from momentum.rate_of_angular_momentum(facts, group, section)
            yield from energy.power(virtual, group, section)

    def _during(self, interval: Interval, passage: Passage) -> Iterator[Equation]:
        """Energy, kinematics, impulses and rules over a phase, and the laws at any moment in it where they vary."""
        section = interval.name
        yield from energy.conservation(passage, section)
        yield from kinematics.kinematics(passage, section)
        yield from momentum.impulses_over(passage, section)
        yield from constraints.for_displacements(passage.midst, self.changes(passage), section)
        if self.varies(interval):
            yield from turning.moments_of_inertia(passage.midst, section)
            yield from newton.second_law(passage.midst, section)
            yield from turning.law_of_rotation(passage.midst, section)
            yield from constraints.for_accelerations(passage.midst, section)
            yield from constraints.for_velocities(passage.midst, section)

    def varies(self, interval: Interval) -> bool:
        """Whether accelerations vary in a phase."""
        return any(travel.pace != "constant" for travel in self.passages[interval.name].travels)

    def changes(self, passage: Passage) -> dict[str, Formula]:
        """Displacements and angles turned by the letters of the rates that they come from."""
        result = {}
        for travel in passage.travels:
            rate = travel.moving
            if isinstance(rate, Symbol):
                result[rate.name] = travel.change
        return result

    def _elongations(self) -> Iterator[Equation]:
        """A spring's elongation grows by what its ends move apart."""
        for name, phase in self.passages.items():
            for first, last, midst in zip(
                phase.start.potentials, phase.end.potentials, phase.midst.potentials, strict=False
            ):
                grown = midst.rate.substitute(self.changes(phase))
                left = last.elongation - first.elongation
                if left != grown:
                    yield Equation(
                        left, grown, "the spring stretches with the motion", name, "", 2, bodies=midst.bodies
                    )


__all__ = ["History", "NotYet"]
