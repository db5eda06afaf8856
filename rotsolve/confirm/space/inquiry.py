"""Inquiry: what a question is in all ways in which a scene in space may move, and whether they tell one number."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import pairwise

from msgspec.structs import replace

from rotsolve.algebra.formula import Symbol
from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.space.arriving import gaps_at
from rotsolve.confirm.space.arrows import arrow_length
from rotsolve.confirm.space.freedoms import freedoms
from rotsolve.confirm.space.motions import (
    AGREE,
    CHANGE,
    HANGING,
    LOST,
    OF_MASS,
    PATHS,
    READ,
    SEVERAL,
    SIZE_OF_CHANGE,
    LeftOpen,
    WaysOfMoving,
    told_by,
)
from rotsolve.confirm.space.readings import Reading, angle_from
from rotsolve.confirm.space.rig import AXES, NOW, Lines, Rig
from rotsolve.confirm.space.rigs import OPEN, time_after
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.worlds import Manner, Moving, manners_of
from rotsolve.core.quantity import DIRECTED, OSCILLATING
from rotsolve.core.symbols import TIME
from rotsolve.language.grammar import ANGLE_OF
from rotsolve.language.problem import ANY_TIME, EXTREMES, Condition, Find, State, Term


class Inquiry(WaysOfMoving):
    """Answers questions at one set of numbers."""

    def numbers(self, find: Find, part: str) -> list[float]:
        """What a question, or a part of it, is in each way; one number where all are the same."""
        if find.where is not None or find.choice is not None:
            raise NotConfirmed("a question with a condition")
        try:
            terms = [self.of_term(for_part(term, part)) for term in find.terms]
            whole = find.formula == Symbol("#0") and len(terms) == 1
            found = terms[0] if whole else [self.combined(find, row) for row in way_by_way(terms)]
        except LeftOpen:
            found = self.in_all_worlds(find, part)
        if find.modifier in EXTREMES and not find.terms:
            raise NotConfirmed("an extreme over a letter")
        if find.modifier in EXTREMES:
            return [min(found) if find.modifier == "smallest" else max(found)]
        if find.modifier not in ("", "size of"):
            raise NotConfirmed(f"`{find.modifier}` in space")
        return [abs(value) for value in found] if find.modifier == "size of" else found

    def in_all_worlds(self, find: Find, part: str) -> list[float]:
        """What a question is whose terms are left open at one state, where it is the same however they are; LeftOpen where it is not."""
        terms = [for_part(term, part) for term in find.terms]
        states = {(term.at, term.start, term.during, term.by) for term in terms}
        if len(terms) < 2 or states != {(terms[0].at, None, None, None)} or terms[0].at == ANY_TIME:
            raise LeftOpen(OPEN)
        return [self.alike_in_worlds(find, terms, way) for way in self.ways(terms[0].at)]

    def alike_in_worlds(self, find: Find, terms: Sequence[Term], way: Manner) -> float:
        """What a question is in all worlds of a way, which differ in all that nothing tells; LeftOpen where they differ in it too."""
        readings = [Reading(world) for world in way.worlds]
        numbers = [self.combined(find, [reading.number(term) for term in terms]) for reading in readings]
        size = max(reading.size(term) for reading in readings for term in terms)
        if max(numbers) - min(numbers) > AGREE * size:
            raise LeftOpen(OPEN)
        return numbers[0]

    def tells(self, find: Find) -> bool:
        """Whether there is one number for a question, or one for each component of a vector."""
        return all(len(self.numbers(find, part)) == 1 for part in components_asked(find))

    def parts(self, find: Find) -> list[float]:
        """The number of a question, or those of the components of a vector, where there is one."""
        return [only_one(self.numbers(find, part)) for part in components_asked(find)]

    def one(self, find: Find) -> float:
        """What a question is, where all ways give the same."""
        return only_one(self.numbers(find, ""))

    def combined(self, find: Find, values: Sequence[float]) -> float:
        letters = {**self.rig.numbers, **{f"#{index}": value for index, value in enumerate(values)}}
        for name in find.formula.symbols() - letters.keys():
            other = next((item for item in self.problem.finds if item.name == name and item is not find), None)
            if other is not None:
                letters[name] = only_one(self.numbers(other, ""))
        return float(value_of(find.formula, letters))

    def of_term(self, term: Term) -> list[float]:
        if term.path.quantity in OSCILLATING:
            return self.swinging(term)
        blow = term.path.quantity in ("impulse", "angular_impulse")
        named = (
            term.path.owner if blow and term.during is None else term.during
        )  # an event's own impulse needs no `during`
        event = next((item for item in self.problem.events if item.name == named), None)
        if event is not None and blow:
            return self.at(term, event.to)
        if event is not None and term.modifier in (CHANGE, LOST, SIZE_OF_CHANGE):
            term = replace(term, during=None, start=event.from_, end=event.to)
        if term.other is not None and term.other.at not in (None, term.at):
            return [self.angle_between(replace(term, modifier="", other=None), term.other)]
        if term.at == ANY_TIME:
            return self.at(term, ANY_TIME)
        if term.during is not None or term.by is not None:
            raise NotConfirmed(PATHS)
        if term.start is None:
            return self.at(term, term.at)
        if term.path.quantity == "time" and term.end is not None:
            return [self.lasting(term.start, term.end)]
        if term.path.quantity == "precession_angle" and term.modifier == CHANGE and term.end is not None:
            found = self.gone_round(term.start, term.end, term.path.owner)
            if found is not None:
                return [found]
        if term.modifier == SIZE_OF_CHANGE:
            plain = replace(term, modifier=CHANGE)
            if term.path.quantity not in DIRECTED or (term.path.component or "").split()[-1:] in (
                [axis] for axis in AXES
            ):
                return [abs(only_one(self.of_term(plain)))]
            return [math.hypot(*(only_one(self.of_term(for_part(plain, axis))) for axis in AXES))]
        if term.modifier not in (CHANGE, LOST):
            raise NotConfirmed(PATHS)
        one, two = (only_one(self.at(term, name)) for name in (term.start, term.end))
        return [two - one if term.modifier == CHANGE else one - two]

    def angle_between(self, one: Term, two: Term) -> float:
        """The angle of a vector at one state from one at another, by their components along the axes that are named."""
        x, y = ([only_one(self.of_term(for_part(term, axis))) for axis in AXES] for term in (one, two))
        a, b = (x[0], x[1], x[2]), (y[0], y[1], y[2])
        return angle_from(a, b)

    def at(self, term: Term, name: str | None) -> list[float]:
        if term.path.quantity == "freedoms":
            return [freedoms(self.rig, term.path)]
        if name is None and len(self.problem.states) > 1 and self.of_mass(term):
            return self.of_body(term)
        if term.path.quantity == "period" and name != ANY_TIME:
            return [self.period(name, term)]
        if name == ANY_TIME:
            return self.at_any_time(term)
        led = self.by_time(name) or self.tells_in_time(name)
        ways = self.followed if led else self.steady_ways if term.modifier in EXTREMES else self.ways
        try:
            found = distinct([told_by(way, term) for way in ways(name)])
        except LeftOpen:
            found = self.by_motion(name, term)
        except Unfit:
            if not self.of_mass(term):
                raise
            return self.of_body(term)
        return self.modified(found, term)

    def by_motion(self, name: str | None, term: Term) -> list[float]:
        """The numbers to which the motion leads; where what stays on the way leaves them open, NotConfirmed by why that is not followed."""
        try:
            return distinct([told_by(way, term) for way in self.followed(name)])
        except LeftOpen:
            why = self._kept.get(f"{name} by motion")
            if isinstance(why, NotConfirmed):
                raise why from None
            raise

    def of_mass(self, term: Term) -> bool:
        """Whether a question is of what a body has however it moves."""
        return term.path.quantity in OF_MASS and term.axes in (None, "", "body")

    def of_body(self, term: Term) -> list[float]:
        """What a body has however it moves."""
        return self.modified(distinct([told_by(way, term) for way in manners_of(self.rig, None, self.put)]), term)

    def period(self, name: str | None, term: Term) -> float:
        """That of a steady rotation; of a free body the time from one zero of a component of ω in its own axes to the next but one."""
        ways, key = self.ways(name), f"{name} {term.path.owner} comes round"
        try:
            return only_one(distinct([told_by(way, term) for way in ways]))
        except NotConfirmed:
            from rotsolve.confirm.space.flight import Flight

            world, name = ways[0].worlds[0], term.path.owner
            flight, joint = Flight(self.rig, world, State(ANY_TIME)), self.rig.on_ground(name)
            heavy = joint is not None and self.rig.gravity * arrow_length(world.stance.arm(joint.body)) > 0.0
            nods = heavy and world.stance.lines.nods(name)
            return float(self.kept(key, lambda: flight.comes_round(name, nods=nods)))

    def swinging(self, term: Term) -> list[float]:
        """Small swings about the steady motion of a state, the only one where none is named, else about an equilibrium."""
        from rotsolve.confirm.space.swings import rate_of_swings

        steady = [state.name for state in self.problem.states if state.steady]
        name = term.at or next(iter(steady), None) or next((state.name for state in self.problem.states), None)
        own = term.path.owner or next(body for body in self.rig.bodies if not self.rig.bodies[body].moved)
        told = bool(term.at or steady)
        ways = self.ways(name)
        worlds = (world for way in ways for world in way.worlds)
        return distinct([rate_of_swings(world, own, term, told=told) for world in worlds])

    def at_any_time(self, term: Term) -> list[float]:
        """A function of time at the moment at which it is looked at: as all is driven then, else as the motion leads to it."""
        if self.driven:
            ways = manners_of(Rig(self.problem, {**self.rig.numbers, TIME: NOW}), State(ANY_TIME), self.put)
            with suppress(LeftOpen):  # how far something is turned hangs on the motion that leads to it
                return self.modified(distinct([told_by(way, term) for way in ways]), term)
        ways = self.running(term.during)
        return self.modified(distinct([told_by(way, term) for way in ways]), term)

    def modified(self, found: Sequence[float], term: Term) -> list[float]:
        """The numbers that a modifier makes of those in all ways."""
        if term.modifier in EXTREMES:
            return [min(found) if term.modifier == "smallest" else max(found)]
        if term.modifier not in ("", "size of", ANGLE_OF, CHANGE, LOST):
            raise NotConfirmed(f"`{term.modifier}` in space")
        return [abs(value) for value in found] if term.modifier == "size of" else list(found)

    # what answers that are put in leave over

    def left_over(self) -> list[float]:
        """What is left of all equations of all states, as far as these are told, and of the ways between them: nothing where the answers
        that are put in are right."""
        left: list[float] = []
        untold = ""
        for state in self.problem.states or (None,):
            standing = self.moving_at(state)
            why = OPEN if standing.stance.open else HANGING if standing.hangs_on_rates() else ""
            told_in_time = state is not None and self.tells_in_time(state.name)
            left += self.off_in_time(state) if state is not None and told_in_time else ()
            if why and state is not None and (told_in_time or self.only_later(state) or self.steadily_told(state)):
                continue
            if why:
                untold = why
                continue
            left += (*standing.apart, *standing.moving.left)
            left += standing.over([0.0] * len(standing.moving.free))
            left += self.off_lines(standing, state)
        ways = [pair for pair in pairwise(self.problem.states) if self.event_to(pair[1].name) is None]
        arrivals = [gap for before, state in ways for gap in self.off_arrival(before, state)]
        if untold and not arrivals:
            raise NotConfirmed(untold)
        return left + arrivals

    def only_later(self, state: State) -> bool:
        """Whether a state tells nothing but how much later it is: the motion leads to it, so that none of its lines tests anything."""
        told = all(line.path is not None and line.path.quantity == "time" for line in state.conditions)
        return told and not (state is self.problem.states[0] or state.steady or self.event_to(state.name))

    def steadily_told(self, state: State) -> bool:
        """Whether a state chooses one of several steady motions by itself, so that no answer that is put in is tested by it."""
        sought = self.problem.sought
        told = (line.value for line in state.conditions if line.value is not None)
        return state.steady and not any(value.symbols() & sought for value in told) and len(self.ways(state.name)) == 1

    def off_in_time(self, state: State) -> Iterator[float]:
        """By how much the lines of a state do not hold where the time leads that it tells."""
        names, told = [item.name for item in self.problem.states], time_after(state)
        before = self.state(names[names.index(state.name) - 1])
        assert before is not None
        passed = None if told is None else self.rig.value(told)
        for world in self.led_on(before.name, state, passed).worlds:
            for line, gap, _ in gaps_at(self.rig_since(before.name), world, state):
                yield gap if passed is None else self.whole_turns(before, line, gap, passed)

    def moving_at(self, state: State | None) -> Moving:
        """How all can move at a state: as it tells, or as a blow leaves it."""
        from rotsolve.confirm.space.passing import moving_after

        event = None if state is None else self.event_to(state.name)
        if event is None:
            rig = self.rig if state is None else self.rig_since(state.name)
            return Moving(Stance(rig, Lines(rig, state, self.put)))
        worlds = [world for way in self.ways(event.from_) for world in way.worlds]
        if any(world.now is not worlds[0].now for world in worlds):
            raise NotConfirmed(OPEN)
        return moving_after(self.rig_since(event.to or ""), event, worlds[0], state, self.put)

    def off_arrival(self, before: State, state: State) -> Iterator[float]:
        """By how much a body on a hinge comes to the angle of a state at another rate than that tells, where it passes through it, and by
        how much it has that rate at another angle the first time."""
        asked = self.problem.sought
        for line, paced in self.places_with_rates(state):
            flights = self.flights_as_told(before, state), self.flights_as_told(before, state)
            for there, paced_there in zip(*flights, strict=True):
                if there.rate_of(line) is None:
                    continue
                if paced.value is not None and self.rig.value(
                    paced.value
                ):  # else it turns back there, and does not pass
                    yield there.gap_of(paced)(there.arrival(signs=True))
                if line.value is not None and line.value.symbols() & asked:
                    yield paced_there.gap_of(line)(paced_there.arrival(paced))

    def places_with_rates(self, state: State) -> Iterator[tuple[Condition, Condition]]:
        """The lines of a state about an angle, or about a place on what turns where that or its rate is sought, each with that about how
        fast it changes there."""
        lines, asked, placed = Lines(self.rig, state, {}), self.problem.sought, set[str]()
        for line in state.conditions:
            path, paced = line.path, None
            if path is None or line.value is None or path.owner in placed:  # one component tells when it is there
                continue
            if path.quantity == "angle":
                paced = lines.line(path.owner, "angular_velocity")
            elif path.quantity == "position" and line.relative:
                paced = lines.line(path.owner, "velocity", path.component or "", path.point)
                told = (line.value, None if paced is None or paced.relative != line.relative else paced.value)
                if told[1] is None or not any(part is not None and part.symbols() & asked for part in told):
                    continue
            if paced is not None and paced.value is not None:
                placed.add(path.owner)
                yield line, paced

    def off_lines(self, standing: Moving, state: State | None) -> Iterator[float]:
        """By how much lines that are no ties do not hold."""
        for line in () if state is None else state.conditions:
            if line.path is not None and line.path.quantity in READ and line.value is not None:
                way = standing.way([[0.0] * len(standing.moving.free)])
                yield told_by(way, Term(line.path, axes=line.axes or None)) - self.rig.value(line.value)


def for_part(term: Term, part: str) -> Term:
    """A term for one part of a vector or tensor that is asked as a whole."""
    if not part:
        return term
    whole = term.path.component
    return replace(term, path=replace(term.path, component=part if whole is None else f"{whole} {part}"))


def distinct(numbers: Sequence[float]) -> list[float]:
    found: list[float] = []
    for value in numbers:
        if all(abs(value - other) > 1e-9 * max(abs(value), abs(other), 1e-9) for other in found):
            found.append(value)
    return found


def only_one(numbers: Sequence[float]) -> float:
    if len(numbers) != 1:
        raise NotConfirmed(SEVERAL)
    return numbers[0]


def way_by_way(terms: Sequence[Sequence[float]]) -> list[list[float]]:
    """One value of each term: terms with several go together way by way."""
    count = max(map(len, terms), default=1)
    if any(len(values) not in (1, count) for values in terms):
        raise NotConfirmed(SEVERAL)
    return [[values[number if len(values) > 1 else 0] for values in terms] for number in range(count)]


def components_asked(find: Find) -> Sequence[str]:
    """The components of a question that is a vector; itself of another one."""
    vector = len(find.terms) == 1 and find.terms[0].path.quantity in DIRECTED and not find.terms[0].modifier
    return AXES if vector and find.formula == Symbol("#0") else ("",)
