"""Scene equations: a scene in time: instants with their facts, what the states fix, and all equations that the laws write about it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.effort import exert
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Words
from rotsolve.core.equation import FAMILIES, Equation
from rotsolve.core.facts import Facts, Rule
from rotsolve.core.faults import Fault, Span
from rotsolve.core.quantity import DAMPINGS, OSCILLATING
from rotsolve.core.registry import Registry
from rotsolve.core.symbols import is_key, rub_of
from rotsolve.equations.states import Fixed, Statements
from rotsolve.language.problem import MODE, Condition, Find, Path, State, Term
from rotsolve.laws.table import (
    BETWEEN,
    EVENT,
    GROUP,
    HELD,
    MIDST,
    PHASE,
    RUNNING,
    STATE,
    AtMoment,
    OfGroup,
    OverPhase,
    ThroughEvent,
    equations_for,
)
from rotsolve.motion.configuration import Configuration, groups_of
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.paths.reader import PathReader
from rotsolve.profile import staged

if TYPE_CHECKING:
    from rotsolve.core.passage import Encounter, Passage, Travel
    from rotsolve.equations.swing import Swing

WRITTEN_A_STEP = 2  # equations that the laws write


class SceneEquations(Struct, dict=True):
    """One reading of a scene, with the ways in which contacts slip in `modes`."""

    configuration: Configuration
    modes: Mapping[str, str] = field(default_factory=dict)
    registry: Registry = field(default_factory=Registry)
    stated: list[tuple[Equation, Condition]] = field(default_factory=list)
    told: list[tuple[str, Condition]] = field(default_factory=list)  # the quantities that lines of states fix, by key
    told_by_facts: bool = False  # whether facts of bodies tell what some of them fix
    restated: dict[str, list[Equation]] = field(default_factory=dict)  # those that `--law` has asked for, by family
    not_restated: list[str] = field(default_factory=list)  # why that was not done for some bodies
    _instants: dict[tuple[str, bool, bool], Instant] = field(default_factory=dict)
    _facts: dict[tuple[str, bool, bool], Facts] = field(default_factory=dict)
    _moments: dict[object, list[Equation]] | None = None  # what is said of single states, by the modes there
    _like: SceneEquations | None = None  # the scene with nothing altered, whose moments it has

    def __post_init__(self) -> None:
        if self._moments is None:
            self._moments = {}
            statements = Statements(Fixed(self.configuration, self.registry, self.modes))
            self.stated += statements.take()
            self.told += statements.told
            self.told_by_facts = statements.told_by_facts

    def in_order(self, formula: Formula) -> Formula:
        """A formula with its products in the order in which its laws are written."""
        return formula

    def put_in_order(self, equation: Equation) -> Equation:
        """An equation with its products in that order."""
        return equation

    def conventions(self, used: Collection[Equation]) -> Iterator[Words]:
        """What is to be said of its axes before the equations that are used."""
        return iter(())

    def places(self) -> Iterator[Words]:
        """Where the points of bodies are of which it speaks, as far as that is not seen at once."""
        return iter(())

    def settled_first(self) -> Iterator[str]:
        """The letters that are worked out by themselves, since it is of them that the scene says which root is meant."""
        return iter(())

    def diagram_words(self, state: str) -> Iterator[Words]:
        """What acts on each body of a scene in space, in words; nothing in the plane, whose facts say it."""
        return iter(())

    def small_beside(self) -> Iterator[tuple[Formula, Formula]]:
        """What its approximations take to be small, each beside what it is small."""
        return iter(())

    def idle_assumptions(self, used: Collection[Equation]) -> Iterator[str]:
        """The assumptions of a scene that leave nothing out of the equations that are used: what is small stands in none of them."""
        letters = {name for equation in used for name in equation.symbols()}
        return (word for word in self.configuration.problem.assume if word.split()[0] not in letters)

    def unwritten_law(self) -> Fault | None:
        """Why a law of a body of a scene in space could not be written; None in the plane, where all are."""
        return None

    def unread_lines(self) -> Iterator[Condition]:
        """The lines of states of which nothing has asked what they fix."""
        return (line for key, line in self.told if key not in self.registry.spoken_of)

    def where(self, modes: Mapping[str, str]) -> SceneEquations:
        """The same scene with contacts in other modes: it shares all moments at which none of them acts, and what the laws say there.

        Where a state speaks of what rubs, what it fixes may depend on the modes, and is taken anew.
        """
        rubbing = {rub_of(key)[0] for key in {*modes, *self.modes}}
        states = self.configuration.timeline.states
        if any(line.path is not None and line.path.owner in rubbing for state in states for line in state.conditions):
            return SceneEquations(self.configuration, modes)
        shared = (self.registry, self.stated, self.told, self.told_by_facts)
        other = SceneEquations(self.configuration, modes, *shared, _moments=self._moments)
        same = {state.name for state in states if self.modes_at(state.name) == other.modes_at(state.name)}
        other._instants.update((key, instant) for key, instant in self._instants.items() if key[0] in same)
        other._facts.update((key, facts) for key, facts in self._facts.items() if key[0] in same)
        return other

    def rewritten_by(self, configuration: Configuration) -> SceneEquations:
        """The same scene with facts, laws or equations altered as a configuration says: it shares all that these leave as it is.

        Where what a state fixes is told by facts, or the place about which something swings, and these are altered, nothing is shared.
        """
        altered = configuration.alteration
        assert altered is not None
        if altered.facts is None:
            moments = self._moments
        elif self.told_by_facts or self.swings:
            return SceneEquations(configuration, self.modes)
        else:
            moments = {}
        shared = (self.registry, self.stated, self.told)
        return SceneEquations(configuration, self.modes, *shared, _moments=moments, _like=self)

    @property
    def _same_facts(self) -> SceneEquations | None:
        """The scene with nothing altered, where its facts are those of this one."""
        altered = self.configuration.alteration
        return self._like if altered is None or altered.facts is None else None

    def modes_at(self, state: str) -> tuple[tuple[str, str], ...]:
        """How what rubs at a state moves there, as far as it does not stick."""
        start = self.configuration.phase_start(state)
        return tuple(sorted(item for item in self.modes.items() if rub_of(item[0])[1] == start))

    def instant(self, state: str, *, generic: bool = False, virtual: bool = False) -> Instant:
        if self._like is not None:
            return self._like.instant(state, generic=generic, virtual=virtual)
        key = (state, generic, virtual)
        if key not in self._instants:
            self._instants[key] = Instant(self.configuration, self.registry, state, generic, self.modes, virtual)
        return self._instants[key]

    def facts(self, state: str, *, generic: bool = False, virtual: bool = False) -> Facts:
        key = (state, generic, virtual)
        if key not in self._facts:
            if self._like is None:
                self._facts[key] = free_bodies(self.instant(state, generic=generic, virtual=virtual))
            else:
                stated, altered = (
                    self._like.facts(state, generic=generic, virtual=virtual),
                    self.configuration.alteration,
                )
                self._facts[key] = stated if altered is None else altered.restated(stated)
        return self._facts[key]

    def reader(self, state: str, *, generic: bool = False) -> PathReader:
        return PathReader(self.instant(state, generic=generic), lambda: self.facts(state, generic=generic))

    @cached_property
    def passages(self) -> dict[str, Passage]:
        """All phases by name."""
        if self._same_facts is not None:
            return self._same_facts.passages
        result = {}
        for interval in self.configuration.timeline.intervals:
            if interval.event is None:
                from rotsolve.motion.passages import passage

                pair = [(self.instant(state), self.facts(state)) for state in (interval.start, interval.end)]
                midst = (self.instant(interval.start, generic=True), self.facts(interval.start, generic=True))
                result[interval.name] = passage(interval, pair[0], pair[1], midst)
        return result

    @cached_property
    def encounters(self) -> dict[str, Encounter]:
        """All events that change velocities, by name."""
        if self._same_facts is not None:
            return self._same_facts.encounters
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
        if self._same_facts is not None:
            return self._same_facts.swings
        states = self.configuration.timeline.states
        observations = [(line, term) for state in states for line, term in observed(state)]
        spoken_of = (*self._swings_asked(), *((term, line.span) for line, term in observations))
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
        for line, term in observations:
            letter = found[question_of(term)].letters[term.path.quantity]
            if isinstance(letter, Symbol) and line.value is not None:
                self.registry.known[letter.name] = line.value
        return found

    def _swings_asked(self) -> Iterator[tuple[Term, Span | None]]:
        for find in self.configuration.problem.finds:
            where = find.where if find.where is not None and find.where.word == "stable" else None
            for term in (*terms_of(find), *([term_of(where)] if where is not None else [])):
                if term.path.quantity in OSCILLATING:
                    yield term, find.span

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
        """All equations, none that says nothing, of equal ones of a family the cheapest; `stated` lines of the states first."""
        written: dict[tuple[Formula, Formula, str], Equation] = {}
        altered = self.configuration.alteration
        for equation in self.written if altered is None else altered.rewritten(self.written):
            key = (equation.left, equation.right, equation.family)
            twin = written.get(key)
            dearer = twin is not None and twin.cost <= equation.cost
            if not dearer and equation.left != equation.right and not self._empty(equation):
                written[key] = equation
        exert(len(written) // WRITTEN_A_STEP)
        return list(written.values())

    def with_asked(self, families: Collection[str]) -> list[Equation]:
        """All equations, with those of families that are written only where they are asked for."""
        asked = [name for name in families if name in FAMILIES and FAMILIES[name].only_asked]
        return [*self.equations, *(equation for name in asked for equation in self.asked_for(name))]

    def asked_for(self, family: str) -> list[Equation]:
        """The equations of such a family, written once."""
        if family not in self.restated:
            written = (one for one in self._restating() if one.family == family and not self._empty(one))
            self.restated[family] = list(written)
        return self.restated[family]

    def _restating(self) -> Iterator[Equation]:
        """Lagrange's equations, at each state, in the midst of phases, and what they keep over phases."""
        from rotsolve.equations.lagrangian import by_lagrange

        return by_lagrange(self)

    def _empty(self, equation: Equation) -> bool:
        """Whether an equation holds whatever happens (0 = 0 once rest is put in)."""
        return not any(map(is_key, equation.symbols())) and is_zero(equation.left - equation.right)

    @cached_property
    def written(self) -> list[Equation]:
        """All that the states say and the laws write, as it stands before single equations are altered."""
        altered, same = self.configuration.alteration, self._same_facts
        if same is not None and (altered is None or altered.event is None):
            return same.written
        return list(self._written())

    def _written(self) -> Iterator[Equation]:
        """All that the states say and the laws write, in the order of time within each kind."""
        yield from (equation for equation, _ in self.stated)
        if any(body.density is not None for body in self.configuration.problem.bodies):
            yield from self.reader(self.configuration.timeline.states[0].name).masses_told_twice()
        for state in self.configuration.timeline.states:
            yield from self._moment(state)
        for interval in self.configuration.timeline.intervals:
            if self.configuration.timeline.at_rest(interval):
                continue
            if interval.name in self.passages:
                yield from self._during(interval)
            elif interval.name in self.encounters:
                yield from self._through(self.encounters[interval.name], interval.name)
        for over in self._phases.values():
            yield from equations_for(BETWEEN, over)
        for state in self.configuration.timeline.states:
            facts = replace(self.facts(state.name), rules=tuple(self._held(state)))
            yield from equations_for(HELD, AtMoment(facts, state.name, state.name))
        for swing in self.swings.values():
            yield from swing.equations()

    def _held(self, state: State) -> Iterator[Rule]:
        """Contacts that a state says to roll or stick: their touching points are at rest then."""
        lines = [line for line in state.conditions if line.word in ("rolls", "sticks")]
        said = {line.path.owner for line in lines if line.path is not None}
        for item in self.configuration.connections(state.name):
            rule = item.grip_rule(self.instant(state.name)) if item.name in said else None
            if rule is not None:
                yield rule

    def section(self, state: str) -> str:
        """Where the laws at a state are written: with the whole phase while accelerations in it are constant."""
        spans = {self.configuration.span(body.name, state) for body in self.configuration.present(state)}
        return spans.pop() if len(spans) == 1 else state

    def _moment(self, state: State) -> list[Equation]:
        """What the laws say at a state, written once for all ways in which the contacts elsewhere move."""
        assert self._moments is not None
        key = (state.name, self.modes_at(state.name))
        if key not in self._moments:
            facts, virtual = self.facts(state.name), self.facts(state.name, virtual=True)
            section = self.section(state.name)
            written = self._moments[key] = list(equations_for(STATE, AtMoment(facts, section, state.name)))
            for group in groups_of(self.configuration, facts, state.name):  # of all tied bodies together
                written += equations_for(GROUP, OfGroup(facts, virtual, group, section))
        return self._moments[key]

    @cached_property
    def _phases(self) -> dict[str, OverPhase]:
        """All phases by name, as laws see them."""
        if self._same_facts is not None:
            return self._same_facts._phases
        found = {}
        for name, over in self.passages.items():
            start = over.start.state
            thought = self.facts(start, generic=True, virtual=True)
            lasts = {rate.name: travel.after for travel, rate in self.thought_rates(over)}
            end = self.configuration.timeline.state(over.end.state)
            before, held = tuple(self.leading_to(start)), tuple(self._held(end))
            found[name] = OverPhase(over, name, before, thought, self.changes(over), lasts, held)
        return found

    def _during(self, interval: Interval) -> Iterator[Equation]:
        """What they say over a phase, and at any moment in it where that matters."""
        over, runs = self._phases[interval.name], self.configuration.mentions.runs
        yield from equations_for(PHASE, over)
        if runs or self.varies(interval):
            yield from equations_for(MIDST, AtMoment(over.passage.midst, interval.name, interval.name))
        if runs:
            yield from equations_for(RUNNING, replace(over, changes=self.changes(over.passage, running=True)))

    def _through(self, encounter: Encounter, section: str) -> Iterator[Equation]:
        """What they say of an event, or what is said instead by mistake."""
        altered = self.configuration.alteration
        if altered is not None and altered.event is not None:
            return iter(altered.event(encounter, section))
        return equations_for(EVENT, ThroughEvent(encounter, section))

    def leading_to(self, state: str) -> list[Passage]:
        """The phases before a state, back to the last event."""
        timeline = self.configuration.timeline
        found: list[Passage] = []
        before = timeline.before(state)
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
        result = {}
        for travel, rate in self.thought_rates(passage):
            change = travel.running if running else travel.change
            if change is not None:
                result[rate.name] = change
        return result

    def thought_rates(self, passage: Passage) -> Iterator[tuple[Travel, Symbol]]:
        """The coordinates of a phase with the letters of their rates in a motion that is only thought of."""
        thought = self.instant(passage.start.state, generic=True, virtual=True)
        for travel in passage.travels:
            rate = coordinate_rate(travel, thought)
            if isinstance(rate, Symbol):
                yield travel, rate


def observed(state: State) -> Iterator[tuple[Condition, Term]]:
    """The lines of a state that tell the period or frequency of small swings about it, or about the equilibrium that is found."""
    for line in state.conditions:
        if line.path is not None and line.path.quantity in OSCILLATING:
            yield line, Term(line.path, at=state.name if state.balance or state.steady else None)


def terms_of(find: Find) -> Iterator[Term]:
    """The terms of a question and of its condition."""
    yield from find.terms
    if find.where is not None and find.where.phrase is not None:
        yield from terms_of(find.where.phrase)


def term_of(condition: Condition) -> Term:
    """The small swings that `STATE is stable` speaks of."""
    return Term(condition.path or Path("", "swing_period"), at=condition.owner)


def question_of(term: Term) -> str:
    """What tells the swings of one question from those of another: the body and the state, a mode and what is compared in it."""
    mode = term.modifier if term.modifier.startswith(MODE) else "damped" if term.path.quantity in DAMPINGS else ""
    compared = "" if term.other is None else f" {path_text(term.other.path)} {path_text(term.path)}"
    return f"{term.path.owner} {term.at or ''} {term.start or ''} {mode}{compared}"


def coordinate_rate(travel: Travel, instant: Instant) -> Formula:
    """The rate of a coordinate at a moment."""
    if travel.kind == "turn":
        return instant.rate("angular_velocity", travel.body)
    if travel.axis:
        return instant.component("velocity", travel.body, travel.axis)
    return instant.travel("velocity", travel.body, "")
