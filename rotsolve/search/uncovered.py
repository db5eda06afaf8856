"""Uncovered: why the laws of one family alone do not tell what is asked: what each of them is about, by kinds of questions."""

from __future__ import annotations

from rotsolve.algebra.units.dimension import (
    ACCELERATION,
    ANGLE,
    ANGULAR_ACCELERATION,
    ANGULAR_VELOCITY,
    ENERGY,
    FORCE,
    LENGTH,
    TIME,
    VELOCITY,
    Dimension,
)
from rotsolve.core import equation
from rotsolve.core.quantity import QUANTITIES
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find, Term
from rotsolve.motion.timeline import Interval

BLOW, PUSH, RATE, SPEED, WHEN, WAY, STORED, ELSE = (
    "blow",
    "force",
    "acceleration",
    "speed",
    "time",
    "way",
    "energy",
    "else",
)
KINDS: dict[Dimension, str] = {
    FORCE: PUSH,
    ACCELERATION: RATE,
    ANGULAR_ACCELERATION: RATE,
    VELOCITY: SPEED,
    ANGULAR_VELOCITY: SPEED,
    TIME: WHEN,
    LENGTH: WAY,
    ANGLE: WAY,
}
AT_A_MOMENT = "they tell accelerations at a moment: {what} follows only where these stay the same"
REASONS: dict[str, dict[str, str]] = {  # by family and kind of question
    equation.NEWTON: {
        BLOW: "they do not cover the blow of `{event}`, whose forces last no time",
        PUSH: "they are not enough for all forces and accelerations that are unknown",
        RATE: "they are not enough for all forces and accelerations that are unknown",
        SPEED: AT_A_MOMENT.format(what="a speed"),
        WHEN: AT_A_MOMENT.format(what="a time"),
        WAY: AT_A_MOMENT.format(what="a way"),
        STORED: "an energy is not told by forces at a moment",
        ELSE: "it is not told by forces at a moment",
    },
    equation.ENERGY: {
        BLOW: "it does not cover the blow of `{event}`, in which some of it may be lost",
        PUSH: "it leaves out the forces that do no work",
        RATE: "it tells how fast bodies are, and an acceleration only where one motion is tied to all others",
        SPEED: "it is one equation, and more than that is unknown",
        WHEN: "it tells how fast bodies are at a place, not when they are there",
        WAY: "it is one equation, and more than that is unknown",
        STORED: "it is one equation, and more than that is unknown",
        ELSE: "it tells speeds and places",
    },
    equation.ANGULAR_MOMENTUM: {
        BLOW: "it does not settle all that the blow of `{event}` changes",
        PUSH: "it leaves out the forces that have no torque",
        RATE: "it tells how fast bodies turn at one state by another, not how that changes",
        SPEED: "an outside torque changes it, or more than one motion is unknown",
        WHEN: "it tells how fast bodies turn, not when",
        WAY: "it tells how fast bodies turn, not how far",
        STORED: "it is no energy, and does not tell all speeds",
        ELSE: "it tells how fast bodies turn",
    },
    equation.LAGRANGE: {
        BLOW: "they do not cover the blow of `{event}`, in which speeds change at once",
        PUSH: "they leave out the forces that do no work",
        RATE: "they are not enough for all accelerations that are unknown",
        SPEED: AT_A_MOMENT.format(what="a speed"),
        WHEN: AT_A_MOMENT.format(what="a time"),
        WAY: AT_A_MOMENT.format(what="a way"),
        STORED: "an energy is not told by accelerations at a moment",
        ELSE: "they tell accelerations",
    },
}


def why_uncovered(law: str, find: Find, scene: SceneEquations) -> str:
    """Why a family of laws does not tell by itself what a question asks, behind a colon; '' of one that is in no table."""
    reasons = REASONS.get(law)
    if reasons is None:
        return ""
    struck = blow_before(find, scene)
    return f": {reasons[BLOW].format(event=struck) if struck else reasons[kind_of_question(find)]}"


def kind_of_question(find: Find) -> str:
    """What is asked, by the quantity of which a question speaks first."""
    word = find.terms[0].path.quantity if find.terms else ""
    entry = QUANTITIES.get(word)
    if entry is None:
        return ELSE
    return STORED if entry.dimension == ENERGY else KINDS.get(entry.dimension, ELSE)


def blow_before(find: Find, scene: SceneEquations) -> str:
    """The event in which bodies strike each other, and in or behind which a question is; '' of one about what is before."""
    timeline, connections = scene.configuration.timeline, scene.configuration.problem.connections
    for interval in timeline.intervals:
        event = interval.event
        if event is None or not event.points(connections):
            continue
        after = timeline.order[interval.end]
        if any(asked_in(term, interval) or last_of(term, timeline.order) >= after for term in find.terms):
            return event.name or interval.name
    return ""


def asked_in(term: Term, interval: Interval) -> bool:
    """Whether a term is about an event: what happens during it, or one of its own quantities."""
    return term.during in interval.names or term.path.owner in interval.names


def last_of(term: Term, order: dict[str, int]) -> int:
    """The place in time of the last state of which a term speaks; before all where it names none."""
    return max((order.get(name, -1) for name in (term.at, term.start, term.end) if name is not None), default=-1)
