"""Tempting: errors that an answer invites, and what they come to: the work of friction by the way of the centre of a body that turns."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.certified.sign import sign_within
from rotsolve.algebra.formula import Formula, Product, Symbol
from rotsolve.core.derivation import Words
from rotsolve.core.symbols import has_quantities
from rotsolve.laws.works import ByItsPoint, by_way_of_its_point
from rotsolve.search.answers import Answered
from rotsolve.search.search import Search


def by_way_of_the_centre(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """What the friction on a body that slips takes from the motion of its centre, F s, and what its torque gives to the turning: the work
    that is asked for is the sum of both."""
    letters = {item.asked.letter: item for item in told}
    for work in (work for passage in search.scene.passages.values() for work in passage.works):
        if work.slide is None or work.spelled is None or not isinstance(work.amount, Symbol):
            continue
        item, apart = letters.get(work.amount.name), by_way_of_its_point(work.spelled)
        if item is not None and apart is not None and item.found.formula is not None:
            yield from given_back(Symbol(item.asked.find.name), item.found.formula, apart, search)


def given_back(name: Formula, work: Formula, apart: ByItsPoint, search: Search) -> Iterator[Words]:
    """The sentence about both parts of a work, where the first is taken and the second given back."""
    tempting = apart.force * apart.along
    taken = search.solver.simplify(search.solver.with_found(tempting))
    given = search.solver.simplify(work - taken)
    if not has_quantities(taken) and surely_signed(taken, search) == -1 and surely_signed(given, search) == 1:
        yield (
            "a mistake that is often made: ",
            name,
            " is not ",
            tempting,
            " = ",
            taken,
            ", which is what friction takes from the motion of the centre alone, and its torque gives ",
            given,
            " of it back to the turning",
        )


def surely_signed(value: Formula, search: Search) -> int | None:
    """The sign of a formula; the pure numbers of moments of inertia are positive."""
    inertias = (body.inertia for body in search.scene.configuration.problem.bodies if body.inertia is not None)
    names = frozenset[str]().union(
        *(inertia.symbols() for inertia in inertias if isinstance(inertia, (Product, Symbol)))
    )
    sign = search.signs.sign(value)
    return sign_within(value, {*search.signs.positive, *names}) if sign is None else sign
