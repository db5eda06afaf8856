"""Leading: the one place or rate with which the forces on a group of tied bodies vary in a phase; all else is told by it."""

from __future__ import annotations

from dataclasses import dataclass

from rotsolve.algebra.formula import Formula, Negative, Symbol, negate
from rotsolve.core.facts import Couple, Facts, Force, signed
from rotsolve.core.varying import PLACES, RATES, paths_in, running
from rotsolve.elements.actions import Action
from rotsolve.elements.connections import Connection
from rotsolve.elements.connections.drapes import Drapes
from rotsolve.motion.instant import Instant
from rotsolve.motion.running import letter_of
from rotsolve.scene.keys import varying


@dataclass(frozen=True)
class Lead:
    """A place that runs through a phase: its letter, its values at both ends, and the rate at which it grows."""

    body: str
    letter: Symbol
    start: Formula
    end: Formula
    rate: Formula
    said: str = ""


def leading_place(group: frozenset[str], first: Instant, last: Instant, middle: Instant) -> Lead | None:
    """The place that the values acting on a group speak of; where there are several, the rules tell the others by it."""
    arrangement, state = middle.arrangement, middle.state
    acting = [item for item in arrangement.acting(state) if any(ref.owner in group for ref in item.touches())]
    said = [path for item in acting for value in varying(item) for path in paths_in(value)]
    for word in PLACES:
        for _, owner, spoken in said:
            if spoken == word and middle.host(owner) in group:
                return place_of(middle.host(owner), word, first, last, middle)
    return next((lead for item in acting if (lead := hanging_part(item, first, last, middle)) is not None), None)


def hanging_part(item: Connection | Action, first: Instant, last: Instant, middle: Instant) -> Lead | None:
    """The length of a heavy rope that hangs down, with which its weight varies."""
    if not isinstance(item, Drapes):
        return None
    letter, start, end = (moment.ask("length", item.name, letter="x") for moment in (middle, first, last))
    motion = middle.motion(item.drapes[0].owner)
    if not isinstance(letter, Symbol) or motion.heading is None:
        return None
    rate, said = motion.velocity.along(motion.heading), "the hanging part grows by the displacement"
    return Lead(item.drapes[0].owner, letter, start, end, rate, said)


def place_of(name: str, word: str, first: Instant, last: Instant, middle: Instant) -> Lead | None:
    """Angle, rotation or displacement of a body as the leading place."""
    letter = letter_of(word, name, middle)
    if not isinstance(letter, Symbol):
        return None
    start, end = (letter_of(word, name, moment) for moment in (first, last))
    motion = middle.motion(name)
    rate = letter_of("velocity" if word == "displacement" else "angular_velocity", name, middle)
    return Lead(name, letter, start, end, signed(rate, motion.sense) if word == "angle" else rate)


def leading_rate(group: frozenset[str], facts: Facts) -> str:
    """The letter of the rate with which the forces on a group vary; '' where there is none."""
    bodies = [body for body in facts.bodies if body.name in group]
    spoken = {name for body in bodies for item in body.acting for name in effort_letters(item)}
    for given in facts.given:
        if given.drive.body in group:
            spoken |= given.letters[given.drive.word].symbols()
    for rule in facts.rules:
        if not rule.linear and set(rule.bodies) & group:
            spoken |= rule.velocity[0].symbols() | rule.velocity[1].symbols()
    return next(iter(running(spoken, RATES)), "")


def effort_letters(item: Force | Couple) -> frozenset[str]:
    return item.size.symbols() if isinstance(item, Force) else item.torque.symbols()


def share(rate: Formula, lead: Formula) -> Formula | int:
    """How fast something moves for each unit of the leading rate: ±1 for the leading body itself."""
    if rate == lead:
        return 1
    if rate == negate(lead) or (isinstance(lead, Negative) and lead.operand == rate):
        return -1
    return rate / lead
