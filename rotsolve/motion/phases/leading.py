"""Leading: the one place or rate with which the forces on a group of tied bodies vary in a phase; all else is told by it."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Formula, Negative, Symbol, negate
from rotsolve.core.facts import Couple, Facts, Force, signed
from rotsolve.core.registry import GENERIC
from rotsolve.core.varying import PLACES, RATES, paths_in, running
from rotsolve.language.keys import varying
from rotsolve.motion.instant import Instant
from rotsolve.motion.running import letter_of


class Lead(Struct, frozen=True):
    """A place that runs through a phase: its letter, its values at both ends, and the rate at which it grows; whether it is one with
    which energy is `stored`."""

    body: str
    letter: Symbol
    start: Formula
    end: Formula
    rate: Formula
    stored: bool = False


def leading_place(group: frozenset[str], first: Instant, last: Instant, middle: Instant) -> Lead | None:
    """The place that the values acting on a group speak of; where there are several, the rules tell the others by it."""
    configuration, state = middle.configuration, middle.state
    acting = [item for item in configuration.acting(state) if any(ref.owner in group for ref in item.touches())]
    said = [path for item in acting for value in varying(item) for path in paths_in(value)]
    for word in PLACES:
        for _, owner, spoken in said:
            if spoken == word and middle.host(owner) in group:
                return place_of(middle.host(owner), word, first, last, middle)
    return None


def stored_place(group: frozenset[str], first: Facts, last: Facts, middle: Facts) -> Lead | None:
    """How far the one spring of a group is stretched, or how much of its rope hangs down: with that its pull, or its weight, varies."""
    owners = [stored.owner for stored in middle.potentials if group & set(stored.bodies)]
    ends = [{item.owner: item.elongation for item in facts.potentials} for facts in (first, last)]
    if len(owners) != 1 or not all(owners[0] in end for end in ends):
        return None
    stored = next(item for item in middle.potentials if item.owner == owners[0])
    running_ = [name for name in stored.elongation.symbols() if GENERIC in name]
    if len(running_) != 1 or stored.placed:
        return None
    letter = Symbol(running_[0])
    rest = simplify(stored.elongation - letter)
    if letter.name in rest.symbols():
        return None
    start, end = (simplify(side[stored.owner] - rest) for side in ends)
    return Lead(stored.bodies[-1], letter, start, end, stored.rate, stored=True)


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
