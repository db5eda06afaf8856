"""Works: what the forces and couples on a body do in a phase: ∫ F · dr of the point on which a force acts, ∫ τ dθ of a couple."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Integral, total
from rotsolve.algebra.units.dimension import LENGTH
from rotsolve.core.facts import BodyFacts, Couple, Force, signed
from rotsolve.core.passage import Work
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import CONSTANT, RATES, TIME, at_any_time, running
from rotsolve.core.vectors.heading import RIGHT, UP, Heading
from rotsolve.motion.instant import Instant
from rotsolve.motion.places import carried_along, ends_of, place_along
from rotsolve.motion.timeline import Interval
from rotsolve.motion.travels import Lead, displacement, led_by, relative_rate, rotation


def works_on(body: BodyFacts, way: PhaseWorks, duration: Formula) -> Iterator[Work]:
    """Work of the forces and couples on a body that are neither weights, springs nor ideal connections."""
    name, interval, first = body.name, way.interval, way.first
    for force in body.forces:
        if not (force.internal or not force.works or force.role.stores):
            yield named_work(force.owner, way.of_force(force, body), (name,), interval, first)
    for couple in body.couples:
        if couple.role.powered:
            motors = first.configuration.actions(way.middle.state)
            power = next(item for item in motors if item.name == couple.owner).now(way.middle)
            summed = Integral(power, TIME, first.time(), way.last.time())
            amount = summed if TIME in power.symbols() else power * duration
            yield named_work(couple.owner, None if running(power.symbols()) else amount, (name,), interval, first)
        elif not (couple.internal or couple.role.stores or couple.role.inner or holds_at_rest(couple, body, first)):
            yield named_work(couple.owner, way.of_turn(couple.torque, body), (name,), interval, first)


def holds_at_rest(couple: Couple, body: BodyFacts, first: Instant) -> bool:
    """Whether a couple acts on what is held still all the time, as a wheel that is kept from turning, and nobody asks for its work."""
    asked = first.configuration.mentions.asks
    return body.motion.spin == ZERO and not (asked(couple.owner, "work") or asked(couple.owner, "power"))


class PhaseWorks(Struct, frozen=True):
    """A phase as works are summed over it."""

    interval: Interval
    first: Instant
    last: Instant
    middle: Instant
    lead: Lead | None

    def of_force(self, force: Force, body: BodyFacts) -> Formula | None:
        """∫ F · dr of the point on which a force acts; None where a part is not told.

        F · Δr where the force stays the same and places tell where its point is; else that of the body's reference, and r × F through
        the angle turned.
        """
        by_places = self.of_constant(force, body)
        if by_places is not None:
            return by_places
        vector, motion, name = force.vector, body.motion, body.name
        parts: list[Formula | None] = []
        if motion.bend is not None and motion.heading is not None:
            parts.append(self.work_round(vector.along(motion.heading), motion.velocity.along(motion.heading), name))
        elif motion.kind == "line" and motion.heading is not None:
            along, speed = (part.along(motion.heading) for part in (vector, motion.velocity))
            parts.append(self.work(along, displacement(name, self.interval, self.first), speed, name))
        elif motion.kind == "plane":
            sides = [(vector.along(axis), axis) for axis in (RIGHT, UP)]
            parts.extend(self.of_side(effort, axis, body) for effort, axis in sides if effort != ZERO)
        torque = force.arm.cross(vector)
        if motion.turns and torque != ZERO:
            parts.append(self.of_turn(torque, body))
        told = [part for part in parts if part is not None]
        return total(told) if len(told) == len(parts) else None

    def of_constant(self, force: Force, body: BodyFacts) -> Formula | None:
        """F · Δr of a force that keeps its size and direction, on a point that turns with its body."""
        letters = {name for size, own in force.vector.parts for name in (*size.symbols(), *own.formula().symbols())}
        if body.motion.heading is not None or len(force.vector.parts) != 1 or at_any_time(letters) or TIME in letters:
            return None
        way = force.vector.parts[0][1]
        ends = ends_of(body.name, way, self.interval, self.first, self.last)
        arms = carried_along(force.arm, body.name, self.middle, (self.first, self.last))
        if ends is None or arms is None:
            return None
        before, after = (end + arm.along(way) for end, arm in zip(ends, arms, strict=True))
        return force.vector.parts[0][0] * simplify(after - before, order=self.first.configuration.order)

    def of_side(self, effort: Formula, axis: Heading, body: BodyFacts) -> Formula | None:
        """∫ F dx of one component, of a body that no line and no pivot guides, through the way of its reference."""
        ends = ends_of(body.name, axis, self.interval, self.first, self.last)
        change = None if ends is None else ends[1] - ends[0]
        return self.work(
            effort, change, body.motion.velocity.along(axis), body.name, place_along(body.name, axis, self.middle)
        )

    def of_turn(self, torque: Formula, body: BodyFacts) -> Formula | None:
        """∫ τ dθ through the angle that a body turns."""
        turned = signed(rotation(body.name, self.interval, self.first), self.first.sense(body.name))
        return self.work(torque, turned, body.motion.spin, body.name)

    def work(
        self, effort: Formula, change: Formula | None, rate: Formula, name: str, midway: Formula | None = None
    ) -> Formula | None:
        """effort · change; ∫ effort · rate dt where the effort varies in time, ∫ effort dx where it varies with the place, and
        None where it varies with the speed, or in a way not told: then energy tells the work. What keeps still has none done on it.

        `midway` is what changes, at any moment, where places tell it.
        """
        if rate == ZERO:
            return ZERO
        letters = effort.symbols()
        if TIME in letters:
            return Integral(effort * rate, TIME, self.first.time(), self.last.time())
        if not running(letters):
            pace = self.first.configuration.pace(name, self.interval.start) if at_any_time(letters) else CONSTANT
            if pace == TIME:
                return Integral(effort * rate, TIME, self.first.time(), self.last.time())
            return effort * change if pace == CONSTANT and change is not None else None
        if running(letters, RATES):
            return None
        lead = self.lead if self.lead is not None else led_by(name, "angle", self.first, self.last, self.middle)
        if lead is None:
            return None
        ratio = relative_rate(rate, lead.rate)
        if midway is not None:
            if set(running(midway.symbols())) - {lead.letter.name}:
                return None
            ratio = differentiate(midway, lead.letter.name)
        return Integral(effort * ratio, lead.letter.name, lead.start, lead.end)

    def work_round(self, along: Formula, speed: Formula, name: str) -> Formula | None:
        """∫ F ρ dφ of the force along a circle that varies with the place on it alone; else as along a line."""
        circle = self.middle.orbit(name)
        midway = self.middle.place_on(circle).symbols() if circle is not None else frozenset[str]()
        letters = along.symbols()
        if circle is None or circle.radius is None or TIME in letters or not letters & midway:
            return self.work(along, displacement(name, self.interval, self.first), speed, name)
        if set(running(letters)) - midway:
            return None
        ends = (moment.place_on(circle) for moment in (self.first, self.last))
        return Integral(signed(along * circle.radius, circle.way), next(iter(midway)), *ends)


def named_work(owner: str, amount: Formula | None, bodies: tuple[str, ...], interval: Interval, first: Instant) -> Work:
    """The work under its own letter where the scene asks for it or fixes it, or where only energy tells it; else spelled out."""
    mentions = first.configuration.mentions
    if amount is None or mentions.asks(owner, "work") or mentions.asks(owner, "power"):
        letter = first.ask("work", owner, when=interval.name)
        slide = SceneQuantity("displacement", owner, interval.name, "", "s", LENGTH)
        return Work(owner, letter, owner, bodies, amount, slide=first.registry.ask(slide))
    return Work(owner, amount, owner, bodies)
