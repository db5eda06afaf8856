"""Running: a value that varies, in the letters of one moment. Time, rotation and displacement count from the first state."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.registry import GENERIC, TIME
from rotsolve.core.varying import paths_in
from rotsolve.core.vectors.directions import TURNS, opposite

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant


def value_now(value: Formula, instant: Instant) -> Formula:
    """The value with letters of this moment for `time` and for paths of bodies."""
    if not value.symbols():
        return value
    letters = {name: letter_of(word, instant.host(owner), instant) for name, owner, word in paths_in(value)}
    return value.substitute({**letters, TIME: instant.time()})


def letter_of(word: str, name: str, instant: Instant) -> Formula:
    """Place or rate of a body at a moment, along its declared sense; even at a moment of a motion only thought of, the real rate."""
    match word:
        case "angle":
            return instant.ask("angle", name, words=TURNS)
        case "angular_velocity":
            return instant.ask(word, name, when=instant.when, words=instant.turn_words(name))
        case "velocity":
            return instant.ask(word, name, when=instant.when, words=line_words(name, instant))
        case _:
            return since_first(word, name, instant)


def since_first(word: str, name: str, instant: Instant) -> Formula:
    """Rotation or displacement since the first state: the sum over the phases gone by; in the midst of a phase a running letter."""
    words = instant.turn_words(name) if word == "rotation" else line_words(name, instant)
    timeline = instant.configuration.timeline
    if instant.generic:
        return instant.ask(word, name, when=GENERIC + timeline.states[0].name, words=words)
    result: Formula = ZERO
    for interval in timeline.between(timeline.states[0].name, instant.state):
        if interval.event is None:
            result = result + instant.ask(word, name, when=interval.name, words=words)
    return result


def line_words(name: str, instant: Instant) -> tuple[str, str]:
    """The words for the two senses in which a body travels along its line."""
    line = instant.line(name)
    return (line[1], opposite(line[1])) if line else ("", "")
