"""Extremes: the largest or smallest value that a quantity takes in some phases, within one of them or at an end."""

from __future__ import annotations

from functools import cmp_to_key

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.writing.powers import in_powers
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.equation import REVERSAL
from rotsolve.core.quantity import BY_WORD, SPANNED
from rotsolve.core.registry import TIME
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Term
from rotsolve.motion.timeline import Interval
from rotsolve.paths import Meaning, NotYet
from rotsolve.questions.courses.beside import Beside, straight


class Candidate(Struct, frozen=True):
    """A value that may be the greatest, where it is taken, and the moment within the phase if it is no end."""

    value: Formula
    interval: Interval
    state: str
    moment: Formula | None = None
    function: Formula = ZERO


def extreme(term: Term, start: str, end: str, scene: SceneEquations, beside: Beside | None) -> tuple[Meaning, str]:
    """Ends of the phases against the moments between them at which the rate of the quantity vanishes."""
    if beside is None or term.path.quantity in SPANNED:
        raise NotYet(f"`{term.modifier} {term.path.quantity}` is not solved yet")
    found: list[Candidate] = []
    for interval in scene.configuration.timeline.between(start, end):
        if interval.event is None:
            found += candidates(term, interval, scene, beside)
    sense = 1 if term.modifier == "largest" else -1

    def order(one: Candidate, other: Candidate) -> int:
        return sense * beside.side(one.value - other.value)

    best = max(found, key=cmp_to_key(order))
    name = f"{term.modifier} {spoken(term.path.quantity)}"
    if best.moment is None:
        meaning = scene.reader(best.state).meaning(term.path, term)
        others = any(candidate.moment is not None for candidate in found)
        why = "more than anywhere between" if term.modifier == "largest" else "less than anywhere between"
        remark = f"at {spoken(best.state)}: {why if others else 'its rate vanishes nowhere between'}"
        return replace(meaning, label=f"{name} of {spoken(term.path.owner)}", remark=remark), best.state
    return within(term, best, name, scene)


def candidates(term: Term, interval: Interval, scene: SceneEquations, beside: Beside) -> list[Candidate]:
    """Both ends of a phase, and every moment between at which the rate changes its sign."""
    meaning = scene.reader(interval.start, generic=True).meaning(term.path, term)
    function = beside.settled(meaning.formula, term.path.quantity)
    times = [beside.settled(scene.instant(state).time(), "time") for state in (interval.start, interval.end)]
    ends = [
        Candidate(function.substitute({TIME: time}), interval, state)
        for state, time in zip((interval.start, interval.end), times, strict=True)
    ]
    slope = simplify(differentiate(function, TIME))
    inside = beside.zeros(slope, times[0], times[1])
    return [*ends, *(Candidate(function.substitute({TIME: at}), interval, "", at, function) for at in inside)]


def within(term: Term, best: Candidate, name: str, scene: SceneEquations) -> tuple[Meaning, str]:
    """The value at the moment at which the rate vanishes, with that moment as a letter of its own."""
    first = scene.instant(best.interval.start)
    owner = spoken(term.path.owner)
    when = " ".join(filter(None, (best.interval.name, name, term.path.point, term.path.component)))
    time = first.ask("time", term.path.owner, when=when, letter="t_m")
    assert best.moment is not None
    slope = in_powers(simplify(differentiate(best.function, TIME)), TIME)
    zero: tuple[Formula, Formula] = (slope.substitute({TIME: time}), ZERO)
    if not straight(slope):
        zero = (time, best.moment)
    law = REVERSAL.equation(*zero, best.interval.name, words=f"{name}, {owner}: its rate is zero")
    value = best.function.substitute({TIME: time})
    meaning = scene.reader(best.interval.start, generic=True).meaning(term.path, term)
    label = f"{name} of {owner}"
    result = Meaning(
        value, BY_WORD[term.path.quantity].dimension, label=label, law=meaning.law, words=meaning.words, laws=(law,)
    )
    return result, best.interval.name
