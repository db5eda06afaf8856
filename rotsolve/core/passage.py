"""Passage and Encounter: what laws read about a phase of motion, and about an event that takes no time; and what may be altered in them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from msgspec import Struct

from rotsolve.algebra.formula import ONE, Formula
from rotsolve.core.equation import Equation
from rotsolve.core.facts import BodyFacts, Couple, Facts, Force, Requirement, Rule
from rotsolve.core.vectors.heading import Vector


class Travel(Struct, frozen=True):
    """One coordinate of a body over a phase: rate at both ends, its acceleration, and the change of the coordinate.

    `pace` is as in core.symbols; for varying paces `acceleration` is that at any moment and `moving` the rate then; `coordinate`
    is the angle or position symbol that it may depend on.
    """

    body: str
    kind: str  # 'line' or 'turn'
    before: Formula
    after: Formula
    acceleration: Formula
    change: Formula
    pace: str
    moving: Formula
    start: Formula | None = None  # value of the coordinate at both ends, where the scene has one
    end: Formula | None = None
    coordinate: Formula | None = None  # the coordinate at any moment between
    initial: Formula | None = None  # the acceleration at the start of the phase
    sense: int = 1  # +1 where the positive way is counterclockwise, as the coordinate counts it
    axis: str = ""  # x or y, where it is one component of the way of a body that is moved in the plane
    given: int | None = None  # what a drive gives: 0 the coordinate, 1 its rate, 2 its acceleration
    running: Formula | None = None  # the change of the coordinate up to any moment, where a function of time is asked
    leads: bool = False  # whether the forces of its group vary with this coordinate, or with this rate
    told: bool = False  # whether another rule tells by how much the coordinate grows
    arm: Formula = ONE  # way per unit of the coordinate: the radius of a circle, where that is an angle


class Work(Struct, frozen=True):
    """Work of one force or couple over a phase that is not stored as potential energy; counted positive when it gives energy."""

    owner: str
    amount: Formula
    words: str
    bodies: tuple[str, ...]
    spelled: Formula | None = None  # what `amount` stands for, where it is a letter
    inner: bool = False  # done by forces between the parts of the system
    slide: Formula | None = None  # the letter for how far its touching point slides, where `amount` is one


class Passage(Struct, frozen=True):
    """A phase: facts at both ends and in its midst, the travels of all bodies, the work done, the heights, the time."""

    name: str
    start: Facts
    end: Facts
    midst: Facts
    travels: tuple[Travel, ...]
    works: tuple[Work, ...]
    heights: Mapping[str, tuple[Formula, Formula] | None]
    duration: Formula
    times: tuple[Formula, Formula]
    groups: tuple[frozenset[str], ...]
    idle: tuple[str, ...] = ()  # connections that do no work, for the sentence that says why energy is conserved
    linked: tuple[
        tuple[str, Formula, Formula], ...
    ] = ()  # bodies, their ways along lines, and these by the angles of what leads them
    ways: Mapping[
        str, tuple[Formula | None, Formula | None]
    ] = {}  # of what moves freely with others: to the right and up


class Meeting(Struct, frozen=True):
    """One body through an event: mass, inertia about its reference, the velocities before and after, and the impulses on it.

    `place` is the body's reference from the event's common point, where that is told; vectors hold at the instant of the event, before
    anything has moved. Of a body that is `guided` along a line nothing tells what keeps it there.
    """

    body: BodyFacts
    inertia: Formula
    before: Vector  # velocity of the centre of mass
    after: Vector
    spin_before: Formula
    spin_after: Formula
    place: Vector | None
    blows: tuple[Force, ...]  # impulses on it, as forces with impulse for size, arms from its reference
    twists: tuple[Couple, ...] = ()  # angular impulses on it beside those of its blows, as couples
    held: Formula | None = (
        None  # moment of inertia about the common point, where the event holds the body there from then on
    )
    guided: bool = False

    @property
    def impulses(self) -> tuple[Force | Couple, ...]:
        """All that changes its momentum and angular momentum."""
        return (*self.blows, *self.twists)


class Approach(Struct, frozen=True):
    """Two that meet and do not stay together: the event, the bodies, how fast they come together before and part after; `told` by an e."""

    event: str
    pair: tuple[str, ...]
    approach: Formula
    parting: Formula
    told: bool

    @property
    def speeds(self) -> tuple[Formula, Formula]:
        return self.approach, self.parting


class Encounter(Struct, frozen=True):
    """An event: the bodies that take part, all that is tied to them among them.

    `about` is what the point is called at which they are held ('' where they meet freely): their places count from there. `requirements`
    are what the impulses of strings and surfaces obey.
    """

    name: str
    words: str
    meetings: tuple[Meeting, ...]
    about: str
    requirements: tuple[Requirement, ...] = ()
    bounces: tuple[tuple[Formula, Formula, Formula], ...] = ()  # e, approach speed, separation speed
    closings: tuple[Approach, ...] = ()
    rules: tuple[Rule, ...] = ()  # of what sticks through the event, though it slips from then on
    joined: tuple[tuple[frozenset[str], BodyFacts], ...] = ()  # who turns about the common point as one body afterwards
    armless: str = ""  # why what acts at the common point does not turn them
    givers: tuple[str, ...] = ()  # the events that it is, several at once

    def gives(self, impulse: Force | Couple) -> bool:
        """Whether an impulse is the event's own, from outside the scene."""
        return impulse.owner in self.givers and not impulse.internal


class Alteration(Struct, frozen=True):
    """Other facts at every moment, other laws through an event, and another equation for each one (None leaves it out).

    `in_space` makes, in place of `SpaceLaws` and from the same, what writes the laws of each moment of a scene in space.
    """

    facts: Callable[[Facts], Facts] | None = None
    event: Callable[[Encounter, str], Iterable[Equation]] | None = None
    equation: Callable[[Equation], Equation | None] | None = None
    in_space: Callable[..., Any] | None = None

    def restated(self, facts: Facts) -> Facts:
        """The facts as they are changed."""
        return facts if self.facts is None else self.facts(facts)

    def rewritten(self, equations: Iterable[Equation]) -> list[Equation]:
        """The equations as they are changed, without those that are left out."""
        if self.equation is None:
            return list(equations)
        return [changed for one in equations if (changed := self.equation(one)) is not None]
