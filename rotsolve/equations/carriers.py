"""Carriers: what is known of the accelerations of bodies that are tied to one whose motion is given: a lift, a cart."""

from __future__ import annotations

from rotsolve.algebra.formula import Symbol
from rotsolve.core.drive import TURNING
from rotsolve.core.facts import Facts
from rotsolve.core.symbols import CONSTANT
from rotsolve.equations.states import rates_of_body
from rotsolve.equations.swing import moving
from rotsolve.laws.modes import Carried
from rotsolve.motion.instant import Instant
from rotsolve.paths.meaning import NotYet

ONLY = "solved are swings on what goes straight on at a constant acceleration, and does not turn"


def carried_accelerations(instant: Instant, facts: Facts, group: frozenset[str]) -> Carried:
    """The letters of all accelerations of a group at a moment of its swings, and the values of those that are given."""
    letters, given = dict[str, str](), {}
    for body in facts.bodies:
        if body.name in group:
            rates = rates_of_body("velocity", moving(instant), body.name)
            for rate, change in zip(rates, rates_of_body("acceleration", instant, body.name), strict=True):
                if isinstance(rate, Symbol) and isinstance(change, Symbol):
                    letters[rate.name] = change.name
    for motion in facts.given:
        drive = motion.drive
        if drive.body not in group:
            continue
        functions, rate = drive.rates(), moving(instant).driven(drive, drive.kinds[1])
        change = functions[drive.kinds[2]]
        turns = drive.kinds == TURNING and not drive.holds_still
        if turns or drive.pace != CONSTANT:
            raise NotYet(f"`{drive.body}` carries what swings, and is led: {ONLY}")
        letter = instant.driven(drive, drive.kinds[2])
        if isinstance(rate, Symbol) and isinstance(letter, Symbol):
            given[rate.name] = change
            letters[rate.name] = letter.name
    return Carried(letters, given)
