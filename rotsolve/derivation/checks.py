"""Checks: all that is held against the answers: a second law, dimensions, limits, what strings and contacts bear, edges."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.exact.normal import is_zero, without_direction
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ONE, ZERO, Formula, Quotient, Symbol
from rotsolve.algebra.units.dimension import ANGLE, MASS, NONE, TIME, Dimension, DimensionError, dimension_of
from rotsolve.core.derivation import Check, Words
from rotsolve.core.equation import FAMILIES
from rotsolve.core.letters import Given
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.symbols import POSITION, has_quantities
from rotsolve.core.writing import spoken
from rotsolve.derivation.letters import Letters, listed
from rotsolve.derivation.ranges import in_proportion
from rotsolve.derivation.requirements import requirements
from rotsolve.derivation.second_law import second_law_checks
from rotsolve.language.problem import TimeValue
from rotsolve.motion.rubs import HOLDS, STICKS, rubs_at
from rotsolve.search.answers import Answered
from rotsolve.search.consistency import KnownBalls
from rotsolve.search.openings import stops
from rotsolve.search.search import Search, is_unreal


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


AT_CENTRE, FAR_OUT = "all mass at the centre", "all mass far out"
SHORT = 3  # a limit is told when its value is no longer than this many nodes
SHORT_FAR = 9  # and this one, ½ m v², of what lies ever further out
FEW, LONGEST = 6, 120  # nodes of a formula of which limits are looked at: shorter ones show them, longer ones take long


def limit_checks(search: Search) -> Iterator[Check]:
    """What becomes of an answer when a mass is left out, and when a pure number or an angle is nothing: of each the most telling one."""
    plain = not search.scene.modes  # else a body that slides may stick when an angle is small
    for dimensions, least in ((MASS,), 1), ((NONE, ANGLE), 0):
        found = [
            item
            for item in vanishing_letters(search, dimensions)
            if item[0] >= least and (least or plain or spreads(search.givens[item[1].vanishing], search))
        ]
        if found:
            _, check, answered = min(found, key=lambda item: item[0])
            yield check
            yield from as_mass_spreads(answered, check.vanishing, search)


def vanishing_letters(search: Search, dimensions: Sequence[Dimension]) -> Iterator[tuple[int, Check, Answered]]:
    """What the first answers come to without a letter of some dimensions, by how long that is: 0 is nothing, 1 a letter."""
    for answered in search.wholes()[:2]:
        formula = answered.found.formula
        if answered.asked.find.runs or formula is None or has_quantities(formula):
            continue
        if not FEW <= length(formula) <= LONGEST:
            continue
        letters = [given for given in search.givens.values() if given.name in formula.symbols()]
        for given in (given for given in letters if given.dimension in dimensions):
            value = limit(formula, given.name, search)
            if value is None or length(value) > SHORT or value == formula:
                continue
            if is_unreal(value, search):  # there is no such motion without it
                continue
            meant = f" → 0 ({AT_CENTRE}) gives " if spreads(given, search) else " → 0 gives "
            words: Words = (Symbol(given.name), meant, Symbol(answered.asked.find.name), " = ", value)
            yield length(value) if value != ZERO else 0, Check(words, vanishing=given.name), answered


def as_mass_spreads(answered: Answered, name: str, search: Search) -> Iterator[Check]:
    """What becomes of an answer as a pure number of moments of inertia grows, β in β m R²: the mass lies ever further out."""
    formula = answered.found.formula
    if formula is None or not spreads(search.givens[name], search):
        return
    far = limit(search.solver.simplify(formula.substitute({name: ONE / Symbol(name)})), name, search)
    if far is not None and length(far) <= SHORT_FAR:
        yield Check(
            (Symbol(name), f" → ∞ ({FAR_OUT}) gives ", Symbol(answered.asked.find.name), " = ", far), growing=name
        )


def spreads(given: Given, search: Search) -> bool:
    """Whether a letter is the pure number of a moment of inertia, which tells how far out the mass lies."""
    inertias = [body.inertia for body in search.scene.configuration.problem.bodies if body.inertia is not None]
    held = [inertia for inertia in inertias if given.name in inertia.symbols()]
    return given.dimension == NONE and bool(held) and all(in_proportion(inertia, given.name) for inertia in held)


def limit(formula: Formula, name: str, search: Search) -> Formula | None:
    """The formula with a letter set to zero, None where it has no value there, such as 0/0."""
    put = formula.substitute({name: ZERO})
    try:
        if any(is_zero(node.denominator) for node in put.walk() if isinstance(node, Quotient)):
            return None
        if without_direction(put):
            return None
        return search.solver.simplify(put)
    except (ZeroDivisionError, ValueError):
        return None


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
