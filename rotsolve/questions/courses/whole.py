"""Whole ways: the whole angle turned, or the whole way gone, split where the motion reverses."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from msgspec import Struct

from rotsolve.algebra.formula import PI, ZERO, Formula, add
from rotsolve.core.derivation import Words
from rotsolve.core.equation import REVERSAL, Equation
from rotsolve.core.quantity import BY_WORD
from rotsolve.core.registry import TIME
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Path, PointRef, Term
from rotsolve.motion.instant import Instant
from rotsolve.motion.timeline import Interval
from rotsolve.motion.travels import rotation, so_far
from rotsolve.paths import Meaning, NotYet
from rotsolve.paths.meaning import size_of
from rotsolve.questions.courses.beside import Beside, straight
from rotsolve.questions.courses.running import way

RATE = {"rotation": "angular_velocity", "displacement": "velocity"}


def whole_way(term: Term, start: str, end: str, scene: SceneEquations, beside: Beside | None) -> tuple[Meaning, str]:
    """∫|ω| dt or ∫|v| dt: the sizes of the parts between the moments of reversal, added up."""
    path, first = term.path, scene.instant(start)
    name = first.host(path.owner)
    arm: Formula | None = None
    word = {"distance": "displacement", "turns": "rotation"}.get(path.quantity, path.quantity)
    if path.quantity == "distance" and first.motion(name).kind == "axis":
        reach = first.point(PointRef(path.owner, path.point or "cm", path.argument))
        word, arm = "rotation", reach.parts[0][0] if len(reach.parts) == 1 else size_of(reach)
    if word not in RATE or beside is None:
        raise NotYet(f"the total of `{path.quantity}` is not solved yet")
    result: Formula = ZERO
    laws: list[Equation] = []
    intervals = scene.configuration.timeline.between(start, end)
    for interval in intervals:
        if interval.event is None:
            pieces, found = parts(word, name, path, interval, scene, beside)
            laws += found
            for piece in pieces:
                result = add(result, piece)
    whole = "angle turned" if word == "rotation" else "way"
    label = f"whole {whole} of {spoken(name)}" + (", both ways added" if laws else "")
    if arm is not None:
        result, label = arm * result, f"way of a point on {spoken(name)}, s = r φ"
    if path.quantity == "turns":
        result = result / (2 * PI)
    return Meaning(result, BY_WORD[path.quantity].dimension, label=label, laws=tuple(laws)), intervals[-1].name


def parts(
    word: str, name: str, path: Path, interval: Interval, scene: SceneEquations, beside: Beside
) -> tuple[list[Formula], list[Equation]]:
    """The parts of one phase, each counted positive, with what tells when the motion reverses and how far it has come then."""
    first, middle = scene.instant(interval.start), scene.instant(interval.start, generic=True)
    times = [beside.settled(scene.instant(state).time(), "time") for state in (interval.start, interval.end)]
    speed = beside.settled(rate_of(word, name, middle), RATE[word])
    change = rotation(name, interval, first) if word == "rotation" else way(path, name, interval, first)
    turns = beside.zeros(speed, times[0], times[1])
    marks: list[Formula] = [ZERO]
    laws: list[Equation] = []
    for number, moment in enumerate(turns, 1):
        come = beside.settled(so_far(word, name, middle), word)
        turn = Reversal(word, name, interval, str(number) if len(turns) > 1 else "", speed, moment, come)
        marks.append(turn.until(first))
        laws += turn.laws(first)
    marks.append(change)
    moments = [times[0], *turns, times[1]]
    result = []
    for number, (before, after) in enumerate(pairwise(marks)):
        middle_of = (moments[number] + moments[number + 1]) / 2
        forward = beside.number(speed, middle_of) >= 0
        result.append(after - before if forward else before - after)
    return result, laws


def rate_of(word: str, name: str, middle: Instant) -> Formula:
    """ω or v along the line, at any moment."""
    if word == "rotation":
        return middle.rate("angular_velocity", name)
    if middle.motion(name).kind != "line":
        raise NotYet(f"`{name}` does not move along a line", help="the whole way is known of bodies on a line")
    line = middle.configuration.line(name, middle.state)
    return middle.travel("velocity", name, line[1] if line else "")


class Reversal(Struct, frozen=True):
    """A moment of a phase at which a body reverses: the functions of time of its rate and of its way, and when the rate vanishes."""

    word: str
    name: str
    interval: Interval
    number: str
    speed: Formula
    moment: Formula
    come: Formula

    def time(self, first: Instant) -> Formula:
        when = f"{self.interval.name} reversal {self.number}".strip()
        return first.ask("time", self.name, when=when, letter=f"t_r{self.number}")

    def until(self, first: Instant) -> Formula:
        """The letter for the angle turned, or the way gone, until then."""
        when = f"{self.interval.name} reversal {self.number}".strip()
        letter = ("phi" if self.word == "rotation" else "s") + self.number
        return first.ask(self.word, self.name, when=when, letter=letter)

    def laws(self, first: Instant) -> Iterator[Equation]:
        """The rate vanishes, and how far the body has come by then."""
        letter, way_ = ("ω", "angle turned") if self.word == "rotation" else ("v", "way")
        body, time = spoken(self.name), self.time(first)
        plain = straight(self.speed)
        zero = (self.speed.substitute({TIME: time}), ZERO) if plain else (time, self.moment)
        remark = () if plain else (f"a zero of {letter} = ", self.speed)
        yield self._law(zero, f"{body} reverses where {letter} = 0", remark)
        yield self._law((self.until(first), self.come.substitute({TIME: time})), f"{way_} until {body} reverses", ())

    def _law(self, sides: tuple[Formula, Formula], label: str, remark: Words) -> Equation:
        return REVERSAL.equation(*sides, self.interval.name, (), remark, words=label)
