"""Scene equations: a scene in time: instants with their facts, what the states fix, and all equations that the laws write about it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec import Struct, field

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.equation import STRETCH, Equation
from rotsolve.core.facts import Facts
from rotsolve.core.faults import Span
from rotsolve.core.passage import Encounter, Passage, Travel
from rotsolve.core.quantity import OSCILLATING
from rotsolve.core.registry import SEPARATOR, Registry
from rotsolve.elements.connections.rubbing import Rubbing
from rotsolve.elements.connections.touch import Touch
from rotsolve.equations.states import Fixed, Statements
from rotsolve.language.problem import Condition, Path, State, Term
from rotsolve.laws import energy, groups, newton, rules
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.motion.passages import groups_of, passage
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.paths.reader import PathReader
from rotsolve.profile import staged

if TYPE_CHECKING:
    from rotsolve.equations.swing import Swing


class SceneEquations(Struct, dict=True):
    """One reading of a scene, with the ways in which contacts slip in `modes`."""

    configuration: Configuration
    modes: Mapping[str, str] = field(default_factory=dict)
    registry: Registry = field(default_factory=Registry)
    stated: list[tuple[Equation, Condition]] = field(default_factory=list)
    _instants: dict[tuple[str, bool, bool], Instant] = field(default_factory=dict)
    _facts: dict[tuple[str, bool, bool], Facts] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.stated += Statements(Fixed(self.configuration, self.registry, self.modes)).take()

    def instant(self, state: str, *, generic: bool = False, virtual: bool = False) -> Instant:
        key = (state, generic, virtual)
        if key not in self._instants:
            self._instants[key] = Instant(self.configuration, self.registry, state, generic, self.modes, virtual)
        return self._instants[key]

    def facts(self, state: str, *, generic: bool = False, virtual: bool = False) -> Facts:
        key = (state, generic, virtual)
        if key not in self._facts:
            self._facts[key] = free_bodies(self.instant(state, generic=generic, virtual=virtual))
        return self._facts[key]

    def reader(self, state: str, *, generic: bool = False) -> PathReader:
        return PathReader(self.instant(state, generic=generic), lambda: self.facts(state, generic=generic))

    @cached_property
    def passages(self) -> dict[str, Passage]:
        """All phases by name."""
        result = {}
        for interval in self.configuration.timeline.intervals:
            if interval.event is None:
                pair = [(self.instant(state), self.facts(state)) for state in (interval.start, interval.end)]
                midst = (self.instant(interval.start, generic=True), self.facts(interval.start, generic=True))
                result[interval.name] = passage(interval, pair[0], pair[1], midst)
        return result

    @cached_property
    def encounters(self) -> dict[str, Encounter]:
        """All events that change velocities, by name."""
        result = {}
        for interval in self.configuration.timeline.intervals:
            if interval.event is not None:
                from rotsolve.motion.encounters import encounter

                pair = [(self.instant(state), self.facts(state)) for state in (interval.start, interval.end)]
                found = encounter(interval, pair[0], pair[1])
                if found is not None:
                    result[interval.name] = found
        return result

    @cached_property
    def swings(self) -> dict[str, Swing]:
        """The swings that questions speak of, by the section of the displaced bodies and the body that leads."""
        spoken_of = (*self._swings_asked(), *self._swings_observed())
        if not spoken_of:
            return {}
        from rotsolve.equations.equilibrium import Placing

        placing = Placing(self.configuration, self.registry, self.modes)
        found: dict[str, Swing] = {}
        for term, span in spoken_of:
            if question_of(term) not in found:
                try:
                    found[question_of(term)] = placing.swing(term)
                except NotYet as error:
                    raise NotYet(str(error), error.span or span, error.help) from None
        for state in self.configuration.timeline.states:
            for line, term in observed(state):
                letter = found[question_of(term)].letters[term.path.quantity]
                if isinstance(letter, Symbol) and line.value is not None:
                    self.registry.known[letter.name] = line.value
        return found

    def _swings_asked(self) -> Iterator[tuple[Term, Span | None]]:
        for find in self.configuration.problem.finds:
            where = find.where if find.where is not None and find.where.word == "stable" else None
            for term in (*find.terms, *([term_of(where)] if where is not None else [])):
                if term.path.quantity in OSCILLATING:
                    yield term, find.span

    def _swings_observed(self) -> Iterator[tuple[Term, Span | None]]:
        for state in self.configuration.timeline.states:
            for line, term in observed(state):
                yield term, line.span

    @property
    def observed(self) -> list[Swing]:
        """The swings of which a state tells the period."""
        return [self.swing(term) for state in self.configuration.timeline.states for _, term in observed(state)]

    def swing(self, term: Term) -> Swing:
        """The swing that a term speaks of."""
        return self.swings[question_of(term)]

    @cached_property
    @staged("laws")
    def equations(self) -> list[Equation]:
        """All equations, each once, none that says nothing; `stated` lines of the states first."""
        written: dict[tuple[Formula, Formula, str], Equation] = {}
        altered = self.configuration.alteration
        for equation in self._written() if altered is None else altered.rewritten(self._written()):
            key = (equation.left, equation.right, equation.family)
            if equation.left != equation.right and key not in written and not self._empty(equation):
                written[key] = equation
        return list(written.values())

    def _empty(self, equation: Equation) -> bool:
        """Whether an equation holds whatever happens (0 = 0 once rest is put in)."""
        names = equation.symbols()
        return not any(SEPARATOR in name for name in names) and is_zero(equation.left - equation.right)

    def _written(self) -> Iterator[Equation]:
        """All that the states say and the laws write, in the order of time within each kind."""
        yield from (equation for equation, _ in self.stated)
        for state in self.configuration.timeline.states:
            yield from self._at(state.name)
        for interval in self.configuration.timeline.intervals:
            if interval.name in self.passages:
                yield from self._during(interval, self.passages[interval.name])
            elif interval.name in self.encounters:
                from rotsolve.laws import momentum

                altered = self.configuration.alteration
                laws = momentum.through_event if altered is None or altered.event is None else altered.event
                yield from laws(self.encounters[interval.name], interval.name)
        yield from self._elongations()
        yield from self._grips()
        for swing in self.swings.values():
            yield from swing.equations()

    def _grips(self) -> Iterator[Equation]:
        """Contacts that a state says to roll or stick: their touching points are at rest then."""
        for state in self.configuration.timeline.states:
            said = {
                line.path.owner
                for line in state.conditions
                if line.path is not None and line.word in ("rolls", "sticks")
            }
            for item in self.configuration.connections(state.name):
                if item.name in said and isinstance(item, (Touch, Rubbing)):
                    rule = item.grip_rule(self.instant(state.name))
                    if rule is not None:
                        yield rules.rule_equation(rule, rule.velocity, state.name)

    def section(self, state: str) -> str:
        """Where the laws at a state are written: with the whole phase while accelerations in it are constant."""
        spans = {self.configuration.span(body.name, state) for body in self.configuration.present(state)}
        return spans.pop() if len(spans) == 1 else state

    def _at(self, state: str) -> Iterator[Equation]:
        """Newton's laws, the rules and the definitions at a state, and the rates of energy and angular momentum."""
        facts, section = self.facts(state), self.section(state)
        yield from newton.moments_of_inertia(facts, section)
        yield from newton.second_law(facts, section)
        yield from newton.law_of_rotation(facts, section)
        yield from newton.balance_of_torques(facts, section)
        if facts.cuts:
            yield from newton.of_pieces(facts, section)
        yield from rules.for_accelerations(facts, section)
        yield from rules.for_velocities(facts, state)
        yield from rules.rates(facts, state)
        yield from rules.steady_rotation(facts, state)
        virtual = self.facts(state, virtual=True)
        for group in groups_of(self.configuration, facts, state):
            yield from groups.rate_of_angular_momentum(facts, group, section)
            yield from groups.rate(virtual, group, section)

    def _during(self, interval: Interval, passage: Passage) -> Iterator[Equation]:
        """Energy, kinematics, impulses and rules over a phase, and the laws at any moment in it where they matter."""
        from rotsolve.laws import kinematics, momentum

        section = interval.name
        yield from energy.conservation(passage, section, self.leading_to(interval))
        yield from energy.works(passage, section)
        yield from kinematics.kinematics(passage, section)
        yield from kinematics.separation(passage, section)
        yield from momentum.impulses_over(passage, section)
        yield from momentum.kept_over(passage, section)
        yield from momentum.about_common_axes(passage, section)
        yield from rules.for_displacements(self.thought(interval.start), self.changes(passage), section)
        if self.varies(interval) or self.configuration.mentions.runs:
            yield from newton.moments_of_inertia(passage.midst, section)
            yield from newton.second_law(passage.midst, section)
            yield from newton.law_of_rotation(passage.midst, section)
            yield from rules.for_accelerations(passage.midst, section)
            yield from rules.for_velocities(passage.midst, section)
            yield from rules.rates(passage.midst, section)
        if self.configuration.mentions.runs:
            changes = self.changes(passage, running=True)
            yield from rules.for_displacements(self.thought(interval.start), changes, section)

    def leading_to(self, interval: Interval) -> list[Passage]:
        """The phases before one, back to the last event."""
        timeline, found = self.configuration.timeline, list[Passage]()
        before = timeline.before(interval.start)
        while before is not None and before.event is None:
            found.insert(0, self.passages[before.name])
            before = timeline.before(before.start)
        return found

    def varies(self, interval: Interval) -> bool:
        """Whether accelerations vary in a phase."""
        return any(travel.pace != "constant" for travel in self.passages[interval.name].travels)

    def changes(self, passage: Passage, *, running: bool = False) -> dict[str, Formula]:
        """Displacements and angles turned by the letters of the rates that they come from, at a moment that is only thought of
        (the real rates may be given, and then have no letters); those up to any moment where they are `running`."""
        thought = self.instant(passage.start.state, generic=True, virtual=True)
        result = {}
        for travel in passage.travels:
            change, rate = travel.running if running else travel.change, coordinate_rate(travel, thought)
            if change is not None and isinstance(rate, Symbol):
                result[rate.name] = change
        return result

    def thought(self, state: str) -> Facts:
        """Facts in the midst of the phase that starts at a state, with velocities that are only thought of."""
        return self.facts(state, generic=True, virtual=True)

    def _elongations(self) -> Iterator[Equation]:
        """A spring's elongation grows by what its ends move apart."""
        for name, phase in self.passages.items():
            thought = self.thought(phase.start.state).potentials
            for first, last, midst in zip(phase.start.potentials, phase.end.potentials, thought, strict=False):
                grown = midst.rate.substitute(self.changes(phase))
                left = last.elongation - first.elongation
                if left != grown and not midst.placed:
                    yield STRETCH.equation(left, grown, name, midst.bodies, words=midst.label)


def observed(state: State) -> Iterator[tuple[Condition, Term]]:
    """The lines of a state that tell the period or frequency of small swings about it, or about the equilibrium that is found."""
    for line in state.conditions:
        if line.path is not None and line.path.quantity in OSCILLATING:
            yield line, Term(line.path, at=state.name if state.balance or state.steady else None)


def term_of(condition: Condition) -> Term:
    """The small swings that `STATE is stable` speaks of."""
    return Term(condition.path or Path("", "swing_period"), at=condition.owner)


def question_of(term: Term) -> str:
    """What tells the swings of one question from those of another: the body and the state."""
    return SEPARATOR.join((term.path.owner, term.at or "", term.start or ""))


def coordinate_rate(travel: Travel, instant: Instant) -> Formula:
    """The rate of a coordinate at a moment."""
    if travel.kind == "turn":
        return instant.rate("angular_velocity", travel.body)
    if travel.axis:
        return instant.component("velocity", travel.body, travel.axis)
    return instant.travel("velocity", travel.body, "")
