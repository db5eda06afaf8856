"""Course: a scene as it moves: a tape, the numbers of its state with their rates, and all that can be told of it."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from rotsolve.core.facts import Facts
from rotsolve.motion.instant import Instant
from rotsolve.simulation.tape.tape import Exact, Tape


class Variable(Struct, frozen=True):
    """One number of the state of motion: its name, its letter, its first value, and the place of its rate on the tape.

    An angle is counted from `origin` right angles, so that close to the vertical or level no digits are lost.
    """

    name: str
    letter: str
    start: Exact
    rate: int
    origin: int = 0


class Course(Struct, frozen=True):
    """A scene as it moves: a tape, the numbers of its state, and all that can be told of it by the state.

    `outputs` are places on the tape by names; `letters` those of all letters of the laws.
    """

    tape: Tape
    variables: tuple[Variable, ...]
    outputs: Mapping[str, int]
    letters: Mapping[str, int]
    facts: Facts
    moment: Instant
