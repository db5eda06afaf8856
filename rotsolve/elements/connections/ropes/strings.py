"""Strings over and round pulleys and drums: tensions, and the rate rules of a string that neither stretches nor slips.

A string is drawn from left to right in the order in which it is written. Each leg between two neighbours has a direction, from the
earlier to the later; the two ends of a leg move equally fast along it. Round a wheel it passes over the top (clockwise from left
to right) unless it is said to pass under.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import Force, Requirement, Rule
from rotsolve.core.vectors.heading import Vector
from rotsolve.core.writing import balance, spoken
from rotsolve.elements.connections.connection import Connection, Fact
from rotsolve.elements.connections.ropes.legs import Course, Leg
from rotsolve.elements.connections.ropes.told import said, told_along
from rotsolve.language.keys import key
from rotsolve.language.problem import Body, PointRef

if TYPE_CHECKING:
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.instant import Instant


class String(Connection, frozen=True):
    """A string over, round and under what it touches, named in order from its first end (on the left) to its last."""

    word = "string"
    about = "a string by what it touches, in order from its first end on the left to its last"
    quantities = ("tension", "force", "work", "power", "impulse", "length")
    words = ("slack", "taut")
    string: tuple[PointRef, ...] = key(
        "points", "what it touches, in order", count=(2, 200), required=True, example="[left, pulley, right]"
    )
    pulls: tuple[tuple[str, str], ...] = key(
        "map of directions",
        "direction in which it pulls a body",
        default=(),
        choices=("left", "right", "up", "down"),
        refers=("body",),
    )
    over: tuple[str, ...] = key(
        "names", "pulleys that it passes over, turning them clockwise (the default)", default=(), refers=("body",)
    )
    under: tuple[str, ...] = key(
        "names", "pulleys that it passes under, turning them counterclockwise", default=(), refers=("body",)
    )
    along: str | None = key("name", "the surface that it runs along", default=None, refers=("surface",))
    mass: Formula | None = key(
        "quantity",
        "mass of the string (a heavy rope is a body, `shape: rope`)",
        dimension="mass",
        limits="nonnegative",
        default=None,
        letter="m",
        later=True,
    )

    def hangs(self, body: Body) -> bool:
        """A body at an end of a string hangs from it where nothing else says how it travels."""
        ends = (self.string[0], self.string[-1])
        return any(ref.owner == body.name and ref.point in (None, "center") for ref in ends)

    def pace(self, configuration: Configuration, state: str) -> str:
        """Constant while all its legs keep their directions: bodies on lines and wheels turning about their centres."""
        for ref in self.string:
            if ref.owner in configuration.bodies and configuration.line(ref.owner, state) is None:
                pivot = configuration.pivot(ref.owner, state)
                if pivot is None or not configuration.balanced(ref.owner, state):
                    return "position"
        return "constant"

    def facts(self, instant: Instant) -> Iterator[Fact]:
        """A tension for each strand, its pulls on the bodies, and the rule that the strand keeps its length."""
        course = self.course(instant)
        for strand in course.strands():
            tension = self.tension(strand, course)
            yield Requirement(
                self.name, tension, ZERO, (tension, " ≥ 0: the string stays taut"), "the string goes slack"
            )
            for leg in strand:
                yield from self.pulls_of(leg, tension, instant)
            yield from self.rules(strand, instant)

    def course(self, instant: Instant) -> Course:
        """How it runs at a moment."""
        return Course(self.string, dict(self.pulls), self.under, self.along, instant)

    def tension_at(self, name: str, instant: Instant) -> Formula | None:
        """Tension of the part that leaves a body or support towards the next one named; at the last one, of the part that arrives."""
        index = next((k for k, ref in enumerate(self.string) if ref.owner == name), None)
        if index is None:
            return None
        course = self.course(instant)
        wanted = course.legs[min(index, len(course.legs) - 1)]
        return next(self.tension(strand, course) for strand in course.strands() if wanted in strand)

    def tension(self, strand: tuple[Leg, ...], course: Course) -> Formula:
        """The tension of a strand, named after the body that it ends at where the string has several."""
        instant = course.instant
        component = "" if len(strand) == len(course.legs) else course.end_of(strand)
        owner = next(ref.owner for ref in self.string if ref.owner in instant.configuration.bodies)
        return instant.ask("tension", self.name, when=instant.span(instant.host(owner)), component=component)

    def pulls_of(self, leg: Leg, tension: Formula, instant: Instant) -> Iterator[Force]:
        """The tension on the bodies at both ends of a leg."""
        for ref, arm, push in ((leg.first, leg.arms[0], leg.along), (leg.second, leg.arms[1], -leg.along)):
            if ref.owner in instant.configuration.bodies:
                words = (
                    "tension ",
                    tension,
                    told_along(push, ref.owner, instant) or said(push, arm, instant.motion(ref.owner).kind),
                )
                yield Force(self.name, "tension", instant.host(ref.owner), tension, push, arm, words, internal=True)

    def rules(self, strand: tuple[Leg, ...], instant: Instant) -> Iterator[Rule]:
        """Σ over the legs of (rate of the second end − rate of the first end) along the leg = 0."""
        sides = []
        for rates in (velocity_at, acceleration_at):
            terms = []
            for leg in strand:
                terms.append((rates(instant, leg.second, leg.arms[1]).dot(leg.along), 1))
                terms.append((rates(instant, leg.first, leg.arms[0]).dot(leg.along), -1))
            sides.append(balance([(value, sign) for value, sign in terms if value != ZERO]))
        bodies = tuple(
            {
                ref.owner: None
                for leg in strand
                for ref in (leg.first, leg.second)
                if ref.owner in instant.configuration.bodies
            }
        )
        turning = any(instant.motion(name).turns for name in bodies) and len(strand) == 1
        label = "the string does not slip" if turning else "the string does not stretch"
        others = [name for name in bodies if not instant.motion(name).turns] if len(self.string) > 2 else []
        label += f", {spoken(others[0])}" if len(others) == 1 else ""
        yield Rule(
            self.name,
            label,
            bodies,
            sides[0],
            sides[1],
            linear=self.pace(instant.configuration, instant.state) == "constant",
        )


def velocity_at(instant: Instant, ref: PointRef, arm: Vector) -> Vector:
    """Velocity of the point of a body at an arm from its reference; the ground is at rest."""
    return instant.motion(ref.owner).velocity_of(arm) if ref.owner in instant.configuration.bodies else Vector()


def acceleration_at(instant: Instant, ref: PointRef, arm: Vector) -> Vector:
    """Acceleration along a leg; a rim's centripetal part does not feed the string, which leaves it on a tangent."""
    return instant.motion(ref.owner).acceleration_of(arm) if ref.owner in instant.configuration.bodies else Vector()
