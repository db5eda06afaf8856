"""Verify: a second law for every answer, dimensions, what strings and contacts can bear, and limits that a reader can check."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.exact.writing.shape import length
from rotsolve.algebra.formula import ZERO, Call, Formula, Symbol
from rotsolve.algebra.units.dimension import DimensionError, dimension_of
from rotsolve.core.derivation import Check, Words
from rotsolve.core.equation import ANGULAR_MOMENTUM, ENERGY, LAWS, NEWTON
from rotsolve.core.facts import Requirement
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.writing import spoken
from rotsolve.inquiry.answering import Inquiry, NoAnswer, families_for
from rotsolve.inquiry.answers import Answered
from rotsolve.inquiry.compose import Composer
from rotsolve.inquiry.consistency import runs
from rotsolve.inquiry.questions import NotYet
from rotsolve.motion.freebody import free_bodies
from rotsolve.solver.textbook import is_long_root

SAID = {ENERGY: "energy", NEWTON: "Newton's laws", ANGULAR_MOMENTUM: "angular momentum"}
SHORT = 3  # a limit is told when its value is no longer than this many nodes


def checks(inquiry: Inquiry, composer: Composer) -> tuple[Check, ...]:
    """All checks of a solved inquiry, the second law first."""
    return (
        *alone(inquiry),
        *second_law(inquiry, composer),
        *dimensions(inquiry),
        *limits(inquiry, composer),
        *requirements(inquiry, composer),
    )


def alone(inquiry: Inquiry) -> Iterator[Check]:
    """Which answers took more than the law that was asked for."""
    if inquiry.helped:
        names: list[str | Formula] = []
        for name in inquiry.helped:
            names += [", ", Symbol(name)] if names else [Symbol(name)]
        yield Check((f"{SAID[inquiry.families[0]]} alone does not give ", *names, ": Newton's laws were used as well"))


def second_law(inquiry: Inquiry, composer: Composer) -> Iterator[Check]:
    """Each answer again by a law that its plan did not use; one that disagrees is an objection."""
    pending = [
        answered
        for answered in inquiry.wholes()
        if answered.found.formula is not None
        and not is_long_root(answered.found.formula)
        and depends(answered, inquiry)
    ]
    for law in (ENERGY, ANGULAR_MOMENTUM, NEWTON):
        other = Inquiry(inquiry.history, families_for(law), spare=True)
        agreed = []
        for answered in list(pending):
            if law in families(answered, inquiry):
                continue
            formula = again(other, answered)
            if formula is None or not independent(other, law):
                continue
            if same(formula, answered.found.formula, inquiry):
                pending.remove(answered)
                agreed.append(answered)
            elif over_a_phase(other):
                pending.remove(answered)
                name = Symbol(answered.asked.find.name)
                yield Check((f"{SAID[law]} gives another ", name, ": ", formula.substitute(composer.letters)), False)
        if agreed:
            names: list[str | Formula] = []
            for answered in agreed:
                names += [", ", Symbol(answered.asked.find.name)] if names else [Symbol(answered.asked.find.name)]
            verb = "give" if SAID[law].endswith("s") else "gives"
            yield Check((f"{SAID[law]} {verb} the same ", *names))


def over_a_phase(other: Inquiry) -> bool:
    """Whether the other way sums over a phase; all that holds at single moments has been compared with the answers before."""
    return any(runs(other.planner.pool[index], other) for index in other.answered[-1].used)


def depends(answered: Answered, inquiry: Inquiry) -> bool:
    """Whether an answer rests on a law at all, and not on definitions alone."""
    return bool(families(answered, inquiry))


def families(answered: Answered, inquiry: Inquiry) -> set[str]:
    """The laws behind an answer: those of its own plan, and of the answers that it uses."""
    found: set[str] = set()
    by_letter = {item.asked.letter: item for item in inquiry.answered}
    pending, seen = [by_letter.get(answered.asked.letter, answered)], set()
    while pending:
        item = pending.pop()
        for index in item.used:
            equation = inquiry.planner.pool[index]
            if equation.family:
                found.add(equation.family)
            elif inquiry.refs.get(index, ("law", 0))[0] == "step":
                found |= {
                    equation.family
                    for other in inquiry.answered
                    for k in other.used
                    if (equation := inquiry.planner.pool[k]).family
                }
            for name in equation.symbols():
                if name in by_letter and name not in seen:
                    seen.add(name)
                    pending.append(by_letter[name])
    return found & set(LAWS)


def again(other: Inquiry, answered: Answered) -> Formula | None:
    """The answer by another inquiry's laws, None where they do not give it."""
    try:
        return other.answer(answered.asked).found.formula
    except (NoAnswer, NotYet):
        return None


def independent(other: Inquiry, law: str) -> bool:
    """Whether the other way really used its law for the last answer."""
    return law in families(other.answered[-1], other)


def same(one: Formula, other: Formula | None, inquiry: Inquiry) -> bool:
    """Exact equality, else agreement of the certified numbers."""
    if other is None:
        return False
    if equal(one, other, inquiry.solver.positive):
        return True
    try:
        gap = evaluate(one - other, inquiry.values, digits=12)
        size = evaluate(other, inquiry.values, digits=12)
    except (Undefined, ValueError):
        return False
    return abs(gap.float) <= 1e-9 * max(abs(size.float), 1e-300)


def dimensions(inquiry: Inquiry) -> Iterator[Check]:
    """Whether every closed form has the dimension of what was asked."""
    known = {given.name: given.dimension for given in inquiry.givens.values() if given.dimension is not None}
    checked = 0
    for answered in inquiry.answered:
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


def limits(inquiry: Inquiry, composer: Composer) -> Iterator[Check]:
    """What becomes of an answer when a mass is left out or an angle is square: the most telling one."""
    best: tuple[int, Words] | None = None
    for answered in inquiry.wholes()[:2]:
        formula = answered.found.formula
        if answered.asked.find.runs or formula is None or formula.symbols() == frozenset():
            continue
        for given in inquiry.givens.values():
            if given.name not in formula.symbols() or given.dimension != DIMENSIONS["mass"]:
                continue
            value = limit(formula, given.name, inquiry)
            if value is None or length(value) > SHORT or value == formula or length(formula) < 6:
                continue
            words: Words = (Symbol(given.name), " → 0 gives ", Symbol(answered.asked.find.name), " = ", value)
            if value != ZERO and (best is None or length(value) < best[0]):
                best = (length(value), words)
    if best is not None:
        yield Check(best[1])


def limit(formula: Formula, name: str, inquiry: Inquiry) -> Formula | None:
    """The formula with a letter set to zero, None where it has no value there."""
    try:
        return inquiry.solver.simplify(formula.substitute({name: ZERO}))
    except (ZeroDivisionError, ValueError):
        return None


def requirements(inquiry: Inquiry, composer: Composer) -> Iterator[Check]:
    """Strings pull, surfaces push, friction stays below its limit: at every state that the derivation speaks of."""
    aside = Inquiry(inquiry.history, families_for(NEWTON))
    told: set[str] = set()
    spoken_of: list[str | Formula] = []
    for place, needs in needed(inquiry):
        for need in needs:
            key = f"{need.owner}{need.otherwise}{inquiry.history.section(place)}"
            if key in told or not concerns(need, inquiry):
                continue
            judge, gap = aside, aside.settled(need.left - need.right)
            if gap is None:
                judge = inquiry.apart()
                gap = judge.settled(need.left - need.right)
            sign = sign_of(gap, inquiry) if gap is not None else None
            if sign is None:
                continue
            told.add(key)
            words = said(need, inquiry, composer, judge) if sign > 0 else ()
            if words and words[-1] not in spoken_of and len(spoken_of) < 3:
                spoken_of.append(words[-1])
                yield Check(words)
            elif sign < 0:
                yield Check(objection(need, place, inquiry, composer), False)


def needed(inquiry: Inquiry) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """What strings and contacts have to obey, state by state, and in the equilibria that were worked out."""
    history = inquiry.history
    for state in history.arrangement.timeline.states:
        yield state.name, history.facts(state.name).requirements
    for swing in history.swings.values():
        if swing.found:
            yield swing.near.state, free_bodies(swing.rest).requirements


def concerns(need: Requirement, inquiry: Inquiry) -> bool:
    """Whether the body that the requirement is about takes part in the derivation."""
    used = {
        name for answered in inquiry.answered for index in answered.used for name in inquiry.planner.pool[index].bodies
    }
    item = next((item for item in inquiry.history.arrangement.problem.connections if item.name == need.owner), None)
    return item is None or any(ref.owner in used for ref in item.touches())


def sign_of(value: Formula, inquiry: Inquiry) -> int | None:
    try:
        return evaluate(value, inquiry.values, digits=6).sign
    except (Undefined, ValueError):
        return None


def objection(need: Requirement, state: str, inquiry: Inquiry, composer: Composer) -> Words:
    """A requirement that fails, in words: "T > 0 for cord at end: the string goes slack"."""
    letters = lettered(need, inquiry, composer)
    left, right = (side.substitute(letters) for side in (need.left, need.right))
    relation: Words = (right, " ≤ ", left) if isinstance(need.right, Call) else (left, " > 0")
    moment = f" at {spoken(state)}" if state else ""
    return (*relation, f" for {spoken(need.owner)}{moment}: {need.otherwise}")


def lettered(need: Requirement, inquiry: Inquiry, composer: Composer) -> dict[str, Formula]:
    """Printed letters of what a requirement is about, the plain textbook letter where the derivation has none."""
    names = [name for name in (need.left - need.right).symbols() if SEPARATOR in name]
    plain = {name: Symbol(inquiry.history.registry.quantities[name].letter) for name in names}
    return {**plain, **composer.letters}


def said(need: Requirement, inquiry: Inquiry, composer: Composer, aside: Inquiry) -> Words:
    """A requirement that holds, in words: "T > 0: the string stays taut"; without a letter that the derivation does not have."""
    if isinstance(need.right, Call):
        size, limit_ = (decimal(aside.settled(side), inquiry) for side in (need.right, need.left))
        return (f"friction needed {size} N ≤ μₛ N = {limit_} N: {spoken(need.owner)} does not slip",)
    told = str(need.words[-1]).partition(": ")[2]
    what = f"{spoken(need.owner)} keeps contact" if "leaves" in need.otherwise else told
    letters = {name for name in need.left.symbols() if SEPARATOR in name}
    return (composer.printed(need.left), " > 0: ", what) if letters <= set(composer.names) else (what,)


def decimal(value: Formula | None, inquiry: Inquiry) -> str:
    if value is None:
        return "?"
    try:
        return evaluate(value, inquiry.values).text(4)
    except (Undefined, ValueError):
        return "?"
