"""Second law: each answer again by a law that its plan did not use."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Check
from rotsolve.core.equation import ANGULAR_MOMENTUM, ENERGY, FAMILIES, NEWTON
from rotsolve.derivation.checks.consistency import runs
from rotsolve.derivation.compose import Letters
from rotsolve.paths import NotYet
from rotsolve.search.answers import Answered, NoAnswer
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search
from rotsolve.solver.textbook import is_long_root


def second_law(search: Search, letters: Letters) -> Iterator[Check]:
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
        other = Search(search.scene, families_for(law), spare=True, confirming=True)
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
