"""Swings: the period of small ones by how the accelerations change beside the equilibrium, of large ones from rest to rest."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.constraints import held_by
from rotsolve.confirm.course.following import Course
from rotsolve.confirm.course.node import Node
from rotsolve.confirm.course.phase import followed
from rotsolve.confirm.course.reading import Reckoned, number
from rotsolve.confirm.instant import Dynamics, Placed, gathered, moment, split
from rotsolve.confirm.linear import solved
from rotsolve.core.quantity import DAMPINGS
from rotsolve.elements.asked import is_spring
from rotsolve.language.problem import MODE, Condition, State, Term

STEP = 1e-4  # of the coordinate, on both sides of the equilibrium
ROUGH = 1e-4  # share of a slope by which two steps may tell it otherwise
NEARLY = 1e-3  # share of gravity, in SI units, with which swings have to start to be followed
STARTS = (0.0, 1.0, -1.0, 2.0, -2.0, 0.3, -0.3)


def swing_time(course: Course, term: Term) -> float:
    """The time of one swing to and fro."""
    if term.modifier == "swings":
        return rest_to_rest(course, term)
    return about_equilibrium(course, term, lambda small, told: small.period(told=told))


def about_equilibrium(course: Course, term: Term, asked: Callable[[Small, bool], float]) -> float:
    """What is asked of small swings, about the state that is named, or an equilibrium that is found."""
    name = term.at or course.names[0]
    state = course.states[course.names.index(name)]
    return asked(Small(course.node(name), term.path.owner), term.at is not None and state.balance)


def rest_to_rest(course: Course, term: Term) -> float:
    """From rest to rest and back, as long each way."""
    start = course.timed(term.start or course.names[0])
    if any(abs(part) > 1e-12 for part in start.placed.speed):
        raise NotConfirmed("swings that do not start from rest")
    if max(map(abs, start.pushes), default=0.0) < NEARLY * max(start.model.gravity, 1.0):
        raise NotConfirmed("swings that start where next to nothing pushes, so that rounding tells how long they take")
    owner = term.path.owner or "all"
    rest = State("the other side", (Condition(None, rest=True, owner=owner),))
    return 2.0 * (followed(start, rest).end.time - start.time)


class SeveralWays(NotConfirmed):
    """More than one coordinate is free, so that it is one of several modes that is asked."""


class Neighbourhood:
    """Places near those of an instant, at which all is held that is held there; a spring of which nothing is told begins without force."""

    def __init__(self, first: Node) -> None:
        self.first, self.model = first, first.model
        self.offsets = dict(first.placed.offsets)
        springs = [item for item in self.model.acting.connections if is_spring(item)]
        for item in springs:
            if item.name not in self.offsets:
                from rotsolve.confirm.forces import spring_length

                self.offsets[item.name] = spring_length(item, first.pose, self.model).value
        self.before = [gap for _, gap in self.rows(first.placed.q)]

    def rows(self, q: list[float]) -> list[tuple[dict[int, float], float]]:
        pose = replace(self.first.placed, q=q, speed=[0.0] * len(q)).pose(self.model)
        rows, grips = split(held_by(self.model, pose))
        return [(row.slope, row.gap) for row in (*rows, *(grip.row for grip in grips))]

    def beside(self, owner: str) -> list[str]:
        """The bodies that are tied to one, or pulled by the same springs and wires; all where none is named."""
        names = list(self.model.seats)
        found, more = {owner} if owner else set(names), True
        groups = [{ref.owner for ref in item.touches() if ref.owner in names} for item in self.model.acting.connections]
        while more:
            wider = found.union(*(group for group in groups if group & found))
            more, found = wider != found, wider
        return [name for name in names if name in found]

    def free(self, owner: str = "") -> list[int]:
        """Coordinates that can be told independently, of the bodies beside one: turns first, then ways."""
        rows = [slope for slope, _ in self.rows(self.first.placed.q)]
        wanted = [self.model.seats[name].first + k for k in (2, 0, 1) for name in self.beside(owner)]
        found: list[int] = []
        for index in wanted:
            fixed = [*rows, *({other: 1.0} for other in found)]
            if index in solved(fixed, [0.0] * len(fixed), self.model.size).open:
                alone = solved([*fixed, {index: 1.0}], [*[0.0] * len(fixed), 1.0], self.model.size).values
                if weighed(self.model.masses, alone, alone) > 0.0:  # a particle that turns is no motion
                    found.append(index)
        return found

    def at_all(self, values: Mapping[int, float]) -> list[float]:
        """The places where some coordinates have values."""
        q = list(self.first.placed.q)
        for _ in range(30):
            self.first.budget.spend(self.model)
            rows = self.rows(q)
            gaps = [old - gap for (_, gap), old in zip(rows, self.before, strict=True)]
            gaps += [value - q[index] for index, value in values.items()]
            if max(map(abs, gaps)) < 1e-12:
                break
            found = solved([*[slope for slope, _ in rows], *({index: 1.0} for index in values)], gaps, len(q))
            q = [old + change for old, change in zip(q, found.values, strict=True)]
        return q

    def moment_at(self, q: list[float], rates: Mapping[int, float] | None = None) -> Dynamics:
        """The accelerations at places, at rest but for the rates of some coordinates."""
        self.first.budget.spend(self.model)
        rows, given = self.rows(q), rates or {}
        told = [*[slope for slope, _ in rows], *({index: 1.0} for index in given)]
        speed = solved(told, [*[0.0 for _ in rows], *given.values()], len(q)).values
        placed = Placed(q, speed, self.first.time, self.offsets, self.first.placed.origin)
        grips = gathered(self.model, placed.pose(self.model))[1]
        if any(grip.normal is None for grip in grips):
            raise NotConfirmed("dry friction, by which small swings stick")
        return moment(self.model, placed, {grip.name: "sticks" for grip in grips})


def weighed(masses: Sequence[float], one: Sequence[float], other: Sequence[float]) -> float:
    """Σ m u v."""
    return math.fsum(mass * a * b for mass, a, b in zip(masses, one, other, strict=True))


class Small(Neighbourhood):
    """Small swings of the bodies that move with one: their coordinate s is the only one that is free."""

    def __init__(self, first: Node, owner: str) -> None:
        super().__init__(first)
        self.index = self.free_index(owner)

    def free_index(self, owner: str) -> int:
        """The coordinate that swings: the only one that nothing holds, of what moves with the body that is named if one is."""
        free = self.free(owner)
        if len(free) > 1:
            raise SeveralWays("more than one body may swing")
        if not free:
            raise NotConfirmed("nothing of it can swing")
        return free[0]

    def push(self, value: float, rate: float = 0.0) -> float:
        """The second rate of the coordinate at a place and a rate."""
        return self.moment_at(self.at_all({self.index: value}), {self.index: rate}).rates[self.index]

    def bend(self, value: float, step: float = STEP) -> float:
        """How fast the push grows with the place, by a step to both sides."""
        return (self.push(value + step) - self.push(value - step)) / (2.0 * step)

    def slope(self, value: float) -> float:
        """The same by two steps, of which the smaller one errs by a fourth; NotConfirmed where they tell it otherwise."""
        wide, near = self.bend(value), self.bend(value, STEP / 2.0)
        if abs(wide - near) > ROUGH * abs(near):
            raise NotConfirmed("swings beside which a push bends sharply: a spring of next to no length")
        return (4.0 * near - wide) / 3.0

    def equilibrium(self, start: float) -> float | None:
        """Where nothing pushes, by Newton's way from a start; where pushes lead away from their zero, the way that they push."""
        value = start
        for _ in range(40):
            push, slope = self.push(value), self.bend(value)
            if slope == 0.0:
                return None
            change = -push / slope if slope < 0.0 or not push else math.copysign(0.5, push)
            value += max(-0.5, min(0.5, change))
            if abs(change) < 1e-11 * max(1.0, abs(value)):
                return value
        return None

    def oscillator(self, *, told: bool) -> tuple[float, float]:
        """ω₀² and γ: −ω₀² is the slope of the push by the place and −2 γ that by the rate, where the equilibrium is stable."""
        start = self.first.placed.q[self.index]
        for value in [start] if told else (self.equilibrium(start + part) for part in STARTS):
            slope = 0.0 if value is None else self.slope(value)
            if value is None or slope >= 0.0:
                continue
            return -slope, -(self.push(value, STEP) - self.push(value, -STEP)) / (4.0 * STEP)
        raise NotConfirmed("no stable equilibrium was found")

    def period(self, *, told: bool) -> float:
        """2π/√(ω₀² − γ²)."""
        free, damping = self.oscillator(told=told)
        square = free - damping * damping
        if square <= 0.0:
            raise NotConfirmed("swings that die out without a turn")
        return 2.0 * math.pi / math.sqrt(square)

    def damped(self, word: str, *, told: bool) -> float:
        """What is asked of damped swings: γ/ω₀, the time in which the slower part of them dies down to 1/e, or γ T."""
        free, damping = self.oscillator(told=told)
        if damping <= 0.0:
            raise NotConfirmed("swings that nothing damps")
        if word == "damping_ratio":
            return damping / math.sqrt(free)
        if word == "logarithmic_decrement":
            return damping * self.period(told=told)
        return 1.0 / (damping - math.sqrt(max(damping * damping - free, 0.0)))


def swinging(course: Course, term: Term) -> Reckoned:
    """The period of swings, or their frequency, or 2π times that; in one of several modes too."""
    word = term.path.quantity
    if word in DAMPINGS:
        return number(about_equilibrium(course, term, lambda small, told: small.damped(word, told=told)))
    if not term.modifier.startswith(MODE):
        try:
            return period_as_asked(swing_time(course, term), term.path.quantity)
        except SeveralWays:
            pass
    from rotsolve.confirm.course.modes import in_mode

    return in_mode(course, term)


def period_as_asked(time: float, quantity: str) -> Reckoned:
    """A period, the frequency that belongs to it, or 2π times that."""
    return number({"swing_period": time, "frequency": 1.0 / time}.get(quantity, 2.0 * math.pi / time))
