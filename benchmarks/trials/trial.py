"""Trial: one random scene with everything that is asked of it: right figures, true derivations, the same answers said otherwise."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from mpmath import mp

from trials.alike import Powers, Unscalable, exponent, mirrored, renamed, reordered, scaled
from trials.case import Case
from trials.draw import FIGURES, STYLES, Draw
from trials.elements import altered, built
from trials.figures import wrong
from trials.held import faults
from trials.kinds import KINDS
from trials.outcome import INTERNAL, OBJECTED, SOLVED, Outcome, Printed, outcome
from trials.scene import Scene, written

DIGITS = (6, 6, 6, 4, 12, 30)
LIMIT = 10.0  # seconds of CPU that any scene may take


@dataclass(frozen=True)
class Result:
    """What a trial found: the kind of scene, its outcome, the faults, and the scene as text."""

    number: int
    kind: str
    outcome: str
    seconds: float
    faults: tuple[str, ...]
    text: str
    checked: int = 0  # numbers held against an independent one


def drawn(seed: int, number: int) -> tuple[str, Case, Draw]:
    """The scene of a number: half from kinds with known answers, half from the tables and the project's own scenes."""
    chance = random.Random(f"{seed}-{number}")
    draw = Draw(f"{seed}-{number}-scene", chance.choice(STYLES))
    way = chance.random()
    if way < 0.5:
        kind = chance.choice(KINDS)
        return f"{kind.__module__.rpartition('.')[2]}: {kind.__name__}", kind(draw), draw
    return ("built", built(draw), draw) if way < 0.75 else ("altered", altered(draw), draw)


def run(seed: int, number: int) -> Result:
    """Make the scene, solve it, and find fault with it."""
    with mp.workdps(FIGURES):
        return judged_at(seed, number)


def judged_at(seed: int, number: int) -> Result:
    """The scene with everything that is wrong with it."""
    kind, case, draw = drawn(seed, number)
    digits = draw.chance.choice(DIGITS)
    text = written(case.scene)
    found = outcome(text, digits)
    wrongs = list(judged(case, found, digits, draw.chance))
    return Result(number, kind, found.kind, found.seconds, tuple(wrongs), text, len(case.expected))


def judged(case: Case, found: Outcome, digits: int, chance: random.Random) -> Iterator[str]:
    """Everything that is wrong with an outcome."""
    if found.seconds > LIMIT:
        yield f"it took {found.seconds:.1f} s"
    if found.kind == INTERNAL:
        yield found.message
    if found.solution is None:
        if case.expected:
            yield f"no answer: {found.message.splitlines()[0]}"
        return
    for name, true in case.expected.items():
        fault = wrong(found.answers[name], true, digits)
        if fault:
            yield f"{name}: {fault}"
    yield from faults(found.solution, found.answers, digits)
    if found.kind in (SOLVED, OBJECTED) and chance.random() < 0.5:
        yield from retold(case.scene, found, digits, chance)


def retold(scene: Scene, found: Outcome, digits: int, chance: random.Random) -> Iterator[str]:
    """The same scene said in another way must give the same answers."""
    way = chance.choice(("scaled", "scaled", "reordered", "renamed", "mirrored"))
    powers: Powers = (0, 0, 0)
    other: Scene | None = None
    if way == "scaled":
        powers = (chance.randint(-12, 12), chance.randint(-12, 12), chance.randint(-12, 12))
        try:
            other = scaled(scene, powers)
        except Unscalable:
            return
    elif way == "mirrored":
        other = mirrored(scene)
    else:
        other = (reordered if way == "reordered" else renamed)(scene, chance)
    if other is None:
        return
    again = outcome(written(other), digits)
    if again.kind != found.kind:
        yield f"{way} {powers if way == 'scaled' else ''}: {again.kind} instead of {found.kind}: {again.message[:300]}\n{written(other)}"
        return
    for name, one in found.answers.items():
        fault = differs(one, again.answers.get(name), powers, way)
        if fault:
            yield f"{way} {powers if way == 'scaled' else ''}: {name}: {fault}\n{written(other)}"


def differs(one: Printed, other: Printed | None, powers: Powers, way: str) -> str:
    """How an answer differs from that of the same scene said otherwise."""
    if other is None:
        return "no longer answered"
    power = exponent(one.dimension, powers)
    if power.denominator != 1:
        return ""
    expected = None if one.number is None else one.number * Fraction(10) ** int(power)
    if other.number != expected and not (one.note and other.note):
        return f"{other.text or other.note} instead of {one.text or one.note} (times 10^{power})"
    if way not in ("mirrored", "renamed") and other.said != one.said:
        return f"{other.said!r} instead of {one.said!r}"
    return ""
