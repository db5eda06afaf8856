"""Second ways: an answer by a law that its plan did not use: a rate about the point of contact, a force by Newton's second law."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import Formula, Negative, Sum, Symbol, negate
from rotsolve.algebra.units.dimension import ACCELERATION, ANGULAR_ACCELERATION, FORCE
from rotsolve.core.derivation import Words
from rotsolve.core.equation import ABOUT_CONTACT, FAMILIES, ROTATION, SECOND_LAW
from rotsolve.core.symbols import ACCELERATIONS, is_key, of_kinds
from rotsolve.derivation.behind import behind
from rotsolve.search.answers import Answered
from rotsolve.search.planning import FORCES
from rotsolve.search.search import Search

SHORT = 15  # nodes of what an acceleration comes to that is told beside a law


def called(item: Answered) -> Formula:
    """What an answer is called."""
    return Symbol(item.asked.find.name)


def by_point_of_contact(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """The same rate by Newton's law for rotation about the point of contact, where that took those about the centre of mass."""
    for item in told:
        laws = list(behind(item, search))
        printed, sections = {name for law in laws for name in law.symbols()}, {law.section for law in laws}
        used = {law.law for law in laws}
        rates = item.asked.dimension in (ACCELERATION, ANGULAR_ACCELERATION)
        if not rates or ROTATION not in used or ABOUT_CONTACT in used:
            continue
        for law in search.planner.pool:
            if law.law != ABOUT_CONTACT or law.section not in sections or not law.symbols() <= printed:
                continue
            alone = len(of_kinds(law.symbols(), (*ACCELERATIONS, *FORCES))) == 1
            if alone and is_zero(search.solver.with_found(law.left - law.right)):
                inertias = of_kinds(law.right.symbols(), ("inertia",))
                summed = search.solver.simplify(
                    law.right.substitute({name: found_for(name, search) for name in inertias})
                )
                short = (" = ", summed) if inertias and not isinstance(summed, Sum) else ()
                told_at_once = (law.left, " = ", law.right, *short, " gives the same ", called(item), " at once")
                yield ("a second way: about the point of contact ", *told_at_once, " (", *law.remark, ")")
                return


def by_another_law(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """The same force by a law that its plan did not use, where one relation of what moves is all that it takes besides."""
    for item in told:
        laws = list(behind(item, search))
        sections, letter = {law.section for law in laws if law.family}, item.asked.letter
        moved = {name for law in laws for name in law.symbols() if is_key(name)}
        if (
            item.asked.dimension != FORCE
            or len(sections) > 1
            or all(law.law == SECOND_LAW for law in laws if law.family)
        ):
            continue
        for law in search.planner.pool:
            if law.law != SECOND_LAW or law in laws or law.section not in sections or letter not in law.symbols():
                continue
            more = [name for name in law.symbols() - moved - {letter} if is_key(name)]
            tied = told_by_relation(more[0], moved, law.section, search) if len(more) == 1 else None
            if tied is None:
                continue
            left, right = (side.substitute({more[0]: tied}) for side in (law.left, law.right))
            if is_zero(search.solver.with_found(left - right)):
                if isinstance(right, Negative):
                    left, right = search.solver.simplify(negate(left)), right.operand
                yield (
                    "a second way: ",
                    law.label,
                    ", ",
                    left,
                    " = ",
                    right,
                    *told_with(right, search),
                    ", gives the same ",
                    called(item),
                )
                return


def told_with(side: Formula, search: Search) -> Words:
    """ ", with α = 3 g/(2 l)", of the accelerations in a formula that a line can hold."""
    values = [(name, found_for(name, search)) for name in of_kinds(side.symbols(), ACCELERATIONS)]
    told = [
        (", with ", Symbol(name), " = ", value)
        for name, value in values
        if Symbol(name) != value and length(value) <= SHORT
    ]
    return told[0] if len(told) == 1 else ()


def found_for(name: str, search: Search) -> Formula:
    """What has been found for a letter, in givens; itself where nothing has."""
    return search.solver.simplify(search.solver.with_found(Symbol(name)))


def told_by_relation(name: str, known: set[str], section: str, search: Search) -> Formula | None:
    """What a relation of the motion tells an acceleration to be, in what the page speaks of already."""
    if not of_kinds([name], ACCELERATIONS):
        return None
    for law in search.planner.pool:
        if (
            law.section == section
            and law.family not in FAMILIES
            and law.left == Symbol(name)
            and {one for one in law.right.symbols() if is_key(one)} <= known
        ):
            return law.right
    return None
