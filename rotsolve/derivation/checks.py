"""Checks: all that is held against the answers: a second law, dimensions, limits, what strings and contacts bear, edges."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Symbol
from rotsolve.algebra.units.dimension import TIME, DimensionError, dimension_of
from rotsolve.core.derivation import Check
from rotsolve.core.equation import FAMILIES
from rotsolve.core.symbols import POSITION
from rotsolve.core.writing import spoken
from rotsolve.derivation.letters import Letters, listed
from rotsolve.derivation.limits import limit_checks
from rotsolve.derivation.requirements import requirements
from rotsolve.derivation.second_law import second_law_checks
from rotsolve.language.problem import TimeValue
from rotsolve.motion.rubs import HOLDS, STICKS, rubs_at
from rotsolve.search.consistency import KnownBalls
from rotsolve.search.search import Search

if TYPE_CHECKING:
    from rotsolve.core.passage import Passage, Travel


def dimensions(search: Search) -> Iterator[Check]:
    """Whether every closed form has the dimension of what was asked."""
    known = {given.name: given.dimension for given in search.givens.values() if given.dimension is not None}
    checked = 0
    for answered in search.answered:
        formula, wanted = answered.found.formula, answered.asked.dimension
        if formula is None or wanted is None or formula == ZERO or not formula.symbols() <= set(known) | {"time"}:
            continue
        try:
            if not dimension_of(formula, {**known, "time": TIME}).matches(wanted):
                yield Check(("the dimension of ", Symbol(answered.asked.find.name), " is wrong"), False)
            checked += 1
        except DimensionError as error:
            yield Check((f"the dimensions of an answer do not agree: {error}",), False)
    if checked:
        yield Check(("dimensions agree",))


def nudged(search: Search) -> Iterator[Check]:
    """Motions, driven by their place, that start from rest where nothing pushes: a nudge starts them, and decides which way they go."""
    scene, pool = search.scene, search.planner.pool
    used = {pool[index].section for answered in search.answered for index in answered.used}
    for name, passage in scene.passages.items():
        interval = scene.configuration.timeline.interval(name)
        if name not in used or interval is None:
            continue
        for travel in passage.travels:
            if travel.before != ZERO or travel.pace != POSITION:
                continue
            push = search.numbers.push(travel.initial)
            if push is not None and search.numbers.side(push) == 0 and not held_or_taken_along(travel, passage, search):
                state = spoken(interval.start) or "the start"
                words = f"nothing moves {spoken(travel.body)} from rest at {state}: the least push decides which way it goes"
                yield Check((words,), None)
                break


FEW_PERCENT = 0.1  # up to which share of something a quantity is small beside it


def beside_each_other(search: Search, letters: Letters) -> Iterator[Check]:
    """What an approximation takes to be small beside what, in numbers: "ω = 3.1 rad/s is small beside s = 126 rad/s"."""
    for pair in dict.fromkeys(search.scene.small_beside()):
        small, large = (search.apart().certified(value) for value in pair)
        if small is None or large is None or not large.float or not all(isinstance(value, Symbol) for value in pair):
            continue
        words = " is small beside " if abs(small.float) <= FEW_PERCENT * abs(large.float) else " is not small beside "
        less, more = (letters.printed(value) for value in pair)
        told = (less, f" = {small.text(4)} rad/s", words, more, f" = {large.text(4)} rad/s")
        yield Check(told, None, "approximation:")


def held_or_taken_along(travel: Travel, passage: Passage, search: Search) -> bool:
    """Whether friction holds a body that nothing moves from rest, or what moves or is pushed takes it along."""
    from rotsolve.search.openings import stops

    scene, state = search.scene, passage.start.state
    own = [rub for rub in rubs_at(scene.configuration, state) if rub.body == travel.body]
    modes = [(rub, scene.modes.get(rub.key, STICKS if rub.item is not None else "")) for rub in own]
    if any(mode in (STICKS, HOLDS) and stops(rub, search) for rub, mode in modes):
        return True
    group = next((names for names in passage.groups if travel.body in names), frozenset[str]())
    others = [other for other in passage.travels if other.body in group and other is not travel]
    rates = [rate for other in others for rate in (other.before, search.numbers.push(other.initial))]
    pushed = [body.motion.acceleration for body in passage.start.bodies if body.name in group]
    rates += [search.numbers.push(size) for acceleration in pushed for size, _ in acceleration.parts]
    return any(rate is not None and search.numbers.side(search.numbers.with_answers(rate)) for rate in rates)


def checks(search: Search, letters: Letters, balls: KnownBalls, at: TimeValue | None) -> tuple[Check, ...]:
    """All checks of a solved search, the second law first; `balls` are the answers, and what follows from them, as numbers; functions of
    time are evaluated `at` a time."""
    return (
        *alone(search),
        *second_law_checks(search, letters, balls),
        *dimensions(search),
        *limit_checks(search),
        *requirements(search, letters, at),
        *nudged(search),
        *beside_each_other(search, letters),
    )


def alone(search: Search) -> Iterator[Check]:
    """Which answers took more than the law that was asked for."""
    if search.helped:
        law = FAMILIES[search.families[0]]
        yield Check(
            (f"{law.words} alone {law.does} not give ", *listed(search.helped), ": Newton's laws were used as well")
        )
