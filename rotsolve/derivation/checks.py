"""Checks: all that is held against the answers: a second law, dimensions, limits, what strings and contacts bear, edges."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.algebra.units.dimension import DimensionError, dimension_of
from rotsolve.core.derivation import Check, Words
from rotsolve.core.equation import ANGULAR_MOMENTUM, ENERGY, FAMILIES, NEWTON
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.core.varying import POSITION
from rotsolve.core.writing import spoken
from rotsolve.derivation.consistency import runs
from rotsolve.derivation.letters import Letters
from rotsolve.derivation.requirements import requirements
from rotsolve.paths.meaning import NotYet
from rotsolve.search.answers import Answered, NoAnswer
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search
from rotsolve.solver.textbook import is_long_root


def dimensions(search: Search) -> Iterator[Check]:
    """Whether every closed form has the dimension of what was asked."""
    known = {given.name: given.dimension for given in search.givens.values() if given.dimension is not None}
    checked = 0
    for answered in search.answered:
        formula, wanted = answered.found.formula, answered.asked.dimension
        if formula is None or wanted is None or formula == ZERO or not formula.symbols() <= set(known) | {"time"}:
            continue
        try:
            if not dimension_of(formula, {**known, "time": DIMENSIONS["time"]}).matches(wanted):
                yield Check(("the dimension of ", Symbol(answered.asked.find.name), " is wrong"), False)
            checked += 1
        except DimensionError as error:
            yield Check((f"the dimensions of an answer do not agree: {error}",), False)
    if checked:
        yield Check(("dimensions agree",))


SHORT = 3  # a limit is told when its value is no longer than this many nodes


def limit_checks(search: Search) -> Iterator[Check]:
    """What becomes of an answer when a mass is left out or an angle is square: the most telling one."""
    best: tuple[int, Words] | None = None
    for answered in search.wholes()[:2]:
        formula = answered.found.formula
        if answered.asked.find.runs or formula is None or formula.symbols() == frozenset():
            continue
        for given in search.givens.values():
            if given.name not in formula.symbols() or given.dimension != DIMENSIONS["mass"]:
                continue
            value = limit(formula, given.name, search)
            if value is None or length(value) > SHORT or value == formula or length(formula) < 6:
                continue
            words: Words = (Symbol(given.name), " → 0 gives ", Symbol(answered.asked.find.name), " = ", value)
            if value != ZERO and (best is None or length(value) < best[0]):
                best = (length(value), words)
    if best is not None:
        yield Check(best[1])


def limit(formula: Formula, name: str, search: Search) -> Formula | None:
    """The formula with a letter set to zero, None where it has no value there."""
    try:
        return search.solver.simplify(formula.substitute({name: ZERO}))
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
            if push is not None and search.numbers.side(push) == 0:
                state = spoken(interval.start) or "the start"
                words = f"nothing moves {spoken(travel.body)} from rest at {state}: the least push decides which way it goes"
                yield Check((words,), None)
                break


def second_law_checks(search: Search, letters: Letters) -> Iterator[Check]:
    """Each answer again by a law that its plan did not use; one that disagrees is an objection."""
    pending = [
        answered
        for answered in search.wholes()
        if answered.found.formula is not None and not is_long_root(answered.found.formula) and depends(answered, search)
    ]
    for law in (ENERGY, ANGULAR_MOMENTUM, NEWTON):
        unused = [answered for answered in pending if law not in families(answered, search)]
        if not unused:
            continue
        other = search.another(families_for(law), spare=True, confirming=True)
        agreed = []
        for answered in unused:
            formula = again(other, answered)
            if formula is None or not independent(other, law):
                continue
            if same(formula, answered.found.formula, search):
                pending.remove(answered)
                agreed.append(answered)
            elif over_a_phase(other):
                pending.remove(answered)
                name = Symbol(answered.asked.find.name)
                yield Check(
                    (f"{FAMILIES[law].words} gives another ", name, ": ", formula.substitute(letters.symbols)), False
                )
        if agreed:
            names: list[str | Formula] = []
            for answered in agreed:
                names += [", ", Symbol(answered.asked.find.name)] if names else [Symbol(answered.asked.find.name)]
            yield Check((f"{FAMILIES[law].words} {FAMILIES[law].gives} the same ", *names))


def over_a_phase(other: Search) -> bool:
    """Whether the other way sums over a phase; all that holds at single moments has been compared with the answers before."""
    return any(runs(other.planner.pool[index], other) for index in other.answered[-1].used)


def depends(answered: Answered, search: Search) -> bool:
    """Whether an answer rests on a law at all, and not on definitions alone."""
    return bool(families(answered, search))


def families(answered: Answered, search: Search) -> set[str]:
    """The laws behind an answer: those of its own plan, and of the answers that it uses."""
    found: set[str] = set()
    by_letter = {item.asked.letter: item for item in search.answered}
    pending, seen = [by_letter.get(answered.asked.letter, answered)], set()
    while pending:
        item = pending.pop()
        for index in item.used:
            equation = search.planner.pool[index]
            if equation.family:
                found.add(equation.family)
            elif search.refs.get(index, ("law", 0))[0] == "step":
                found |= {
                    equation.family
                    for other in search.answered
                    for k in other.used
                    if (equation := search.planner.pool[k]).family
                }
            for name in equation.symbols():
                if name in by_letter and name not in seen:
                    seen.add(name)
                    pending.append(by_letter[name])
    return found & FAMILIES.keys()


def again(other: Search, answered: Answered) -> Formula | None:
    """The answer by another search's laws, None where they do not give it."""
    try:
        return other.answer(answered.asked).found.formula
    except (NoAnswer, NotYet):
        return None


def independent(other: Search, law: str) -> bool:
    """Whether the other way really used its law for the last answer."""
    return law in families(other.answered[-1], other)


def same(one: Formula, other: Formula | None, search: Search) -> bool:
    """Exact equality, else agreement of the certified numbers."""
    if other is None:
        return False
    if equal(one, other, search.solver.positive):
        return True
    try:
        gap = evaluate(one - other, search.values, digits=12)
        size = evaluate(other, search.values, digits=12)
    except (Undefined, ValueError):
        return False
    return abs(gap.float) <= 1e-9 * max(abs(size.float), 1e-300)


def checks(search: Search, letters: Letters) -> tuple[Check, ...]:
    """All checks of a solved search, the second law first."""
    return (
        *alone(search),
        *second_law_checks(search, letters),
        *dimensions(search),
        *limit_checks(search),
        *requirements(search, letters),
        *nudged(search),
    )


def alone(search: Search) -> Iterator[Check]:
    """Which answers took more than the law that was asked for."""
    if search.helped:
        names: list[str | Formula] = []
        for name in search.helped:
            names += [", ", Symbol(name)] if names else [Symbol(name)]
        yield Check(
            (f"{FAMILIES[search.families[0]].words} alone does not give ", *names, ": Newton's laws were used as well")
        )
