"""Cases of arrays: one set of givens is solved, and other sets get the same where each number that was asked for has the same sign.

So a set gets a number only where solving the scene for it gives that too, and else the reason that solving it gives.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
from msgspec import Struct

from rotsolve.algebra.certified.ball import Certified, multiple_of
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ONE, Formula, Integral, Number
from rotsolve.arrays import NotForMany, program, single_answers
from rotsolve.arrays.balls import ball_results, nearest_double
from rotsolve.arrays.floats import float_results
from rotsolve.core.derivation import Answer
from rotsolve.page.text import plain_text

if TYPE_CHECKING:
    from rotsolve.algebra.units.unit_table import Unit
    from rotsolve.solution import Resolved, Solution

SIGNS_AT_A_TIME = 32_768  # sets of which signs are read
UNSURE = 1000  # signs that floats do not tell, which are worked out one by one
SHIFT, FAR = (
    1e-11,
    0.5,
)  # by what inputs are shifted to see whether a sign is sure, and the part of a number that may change then
ALIKE, NOTHING = 1e-7, 1e-12  # floats may lose half of their digits
Row = dict[str, float]
Resolving = Callable[[Row], "Resolved"]


class GivenSets(Struct):
    """The values of some givens set by set, those of the others, and the letters that have none."""

    size: int
    columns: dict[str, Any]
    known: dict[str, Formula]
    open: Collection[str] = ()

    def row(self, place: int) -> Row:
        return {name: float(column[place]) for name, column in self.columns.items()}

    def part(self, rows: Any) -> dict[str, Any]:
        return {name: column[rows] for name, column in self.columns.items()}

    def values(self, place: int) -> dict[str, Formula]:
        """The values of all givens in one set: 0.6 as it is typed, so that 0.6² + 0.8² = 1."""
        own = {name: Number(Fraction(repr(size))) for name, size in self.row(place).items()}
        return {**self.known, **own}

    def only(self, place: int) -> Any:
        """The set at a place alone."""
        rows = np.zeros(self.size, dtype=bool)
        rows[place] = True
        return rows


class SetCase(Struct):
    """What one set of givens got, in SI units: numbers or words and their closed forms, else `reasons`, by the answers' names.

    Where the whole set has no answer `why` says why. Where it is `general`, sets with the same `signs` get the same. `at` tells the set.
    """

    at: str
    why: str
    signs: dict[Formula, int | None]
    general: bool
    numbers: dict[str, Certified | str] = {}
    forms: dict[str, Formula] = {}
    units: dict[str, Unit | None] = {}
    reasons: dict[str, str] = {}
    solution: Solution | None = None

    def reason(self, name: str) -> str:
        """Why an answer of the set that was solved has no number; '' where it has one."""
        return "" if name in self.numbers else self.why or self.reasons.get(name, "these numbers have no such answer")


def case_of_set(solve: Resolving, given: GivenSets, place: int, limits: Iterable[Formula]) -> SetCase:
    """The scene solved for one set, with the signs on which it hangs what that gives."""
    found = solve(given.row(place))
    letters = given.known.keys() | given.columns.keys()
    oracle = SignOracle(given.values(place))
    asked = [item for item in dict.fromkeys((*found.asked, *limits)) if not item.symbols().isdisjoint(given.columns)]
    signs = {item: oracle.by_numbers(item) for item in asked if item.symbols() <= letters}
    told = not found.by_size and all(item.symbols().isdisjoint(given.open) for item in found.asked)
    at = ", ".join(f"{name} = {size:.4g}" for name, size in given.row(place).items())
    case = SetCase(at, found.why, signs, told, solution=found.solution)
    if found.solution is None:
        return case
    derivation = found.solution.derivation
    objections = (check for check in derivation.checks if check.holds is False and not check.beyond)
    case.why = "; ".join(plain_text(check.words) for check in objections)
    case.reasons.update({item.name: item.fault.message for item in derivation.refused})
    if not case.why:
        for name, answer in single_answers(derivation.answers):
            enter(case, name, answer, letters)
    return case


def enter(case: SetCase, name: str, answer: Answer, letters: Collection[str]) -> None:
    """Enter an answer, with its closed form where that is one in the givens."""
    closed = answer.closed if answer.closed is not None and answer.closed.symbols() <= set(letters) else None
    case.units[name] = answer.unit
    if answer.word:
        case.numbers[name] = answer.word
    elif answer.value is None:
        missing = sorted(answer.closed.symbols() - set(letters)) if answer.closed is not None else ()
        case.reasons[name] = f"`{missing[0]}` has no value" if missing else "it has no value for these numbers"
    else:
        case.numbers[name] = answer.value if answer.unit is None else multiple_of(answer.value, answer.unit.factor)
        if closed is None or answer.conditions or closed.holds(Integral):
            case.general = False
        else:
            case.forms[name] = closed


def sets_like(case: SetCase, given: GivenSets, rows: Any) -> Any:
    """Which sets among some have the signs on which a case hangs."""
    signs = {item: sign for item, sign in case.signs.items() if not (sign == 0 and nothing_whatever(item))}
    columns, places = given.part(picking(rows)), np.flatnonzero(rows)
    found, unsure = np.ones(len(places), dtype=bool), UNSURE if signs else 0
    read = read_signs(signs, columns, given.known, len(places))
    for item, (here, sure) in read.items():
        for number in np.flatnonzero(found & ~sure)[:unsure]:
            here[number] = SignOracle(given.values(int(places[number]))).by_numbers(item) == signs[item]
            sure[number], unsure = True, unsure - 1
        found &= here & sure
    whole = np.zeros(given.size, dtype=bool)
    whole[places[found]] = True
    return whole


def read_signs(
    signs: Mapping[Formula, int | None], columns: Mapping[str, Any], known: Mapping[str, Formula], size: int
) -> dict[Formula, tuple[Any, Any]]:
    """By formulas, set by set: whether each has its sign, and whether that is sure: inputs shifted by a little give it too.

    In pieces of which all that is worked out on the way fits into the processor's cache.
    """
    work = program(signs, columns, known)
    found = {item: (np.empty(size, dtype=bool), np.empty(size, dtype=bool)) for item in signs}
    for start in range(0, size if signs else 0, SIGNS_AT_A_TIME):
        piece = slice(start, start + SIGNS_AT_A_TIME)
        own = {name: column[piece] for name, column in columns.items()}
        shifted = {name: column * (1 + SHIFT * (1 + number)) for number, (name, column) in enumerate(own.items())}
        results = float_results(work, own, 0), float_results(work, shifted, 0)
        for (item, sign), values, others in zip(signs.items(), *results, strict=True):
            here, sure = found[item]
            here[piece], sure[piece] = signs_read(values, others, sign)
    return found


def signs_read(values: Any, others: Any, sign: int | None) -> tuple[Any, Any]:
    """Which of some numbers have a sign, None being no number, and of which that is sure beside `others`."""
    finite = np.isfinite(values)
    with np.errstate(invalid="ignore"):
        near = np.abs(others - values) <= FAR * np.abs(values)
        here = ~finite if sign is None else finite & (np.sign(values) == sign)
    return here, near if finite.all() else np.where(finite, near, ~np.isfinite(others))


def nothing_whatever(item: Formula) -> bool:
    """Whether a formula is nothing whatever its letters are."""
    try:
        return is_zero(item)
    except ZeroDivisionError:
        return False


def picking(chosen: Any) -> Any:
    """What picks the chosen sets from an array; all of them without a copy of it."""
    return slice(None) if chosen.all() else chosen


def numbers_of_forms(
    forms: Mapping[str, Formula], given: GivenSets, rows: Any, certified: bool
) -> dict[str, tuple[Any, ...]]:
    """The numbers of several formulas for some sets, with bounds on their errors where `certified`: what they share is worked out once."""
    columns = given.part(rows)
    try:
        work = program(forms.values(), columns, given.known)
        found = [(one,) for one in float_results(work, columns, 0)] if not certified else ball_results(work, columns, 0)
    except NotForMany:  # functions that NumPy does not have
        found = [form_numbers(form, given, rows, certified) for form in forms.values()]
    return dict(zip(forms, found, strict=True))


def form_numbers(form: Formula, given: GivenSets, rows: Any, certified: bool) -> tuple[Any, ...]:
    """The numbers of a formula for some sets; with bounds on their errors where `certified`."""
    columns = given.part(rows)
    work = program([form], columns, given.known)
    if certified:
        return ball_results(work, columns, 0)[0]
    try:
        return (float_results(work, columns, 0)[0],)
    except NotForMany:  # functions that NumPy does not have
        return ball_results(work, columns, 0)[0][:1]


def number_in_unit_of(number: Certified, unit: Unit | None) -> tuple[float, float]:
    """The number of a set that was solved, in a unit, with a bound on its error."""
    return nearest_double((number if unit is None else multiple_of(number, ONE / unit.factor)).ball)


def says_the_same(case: SetCase, other: SetCase, given: GivenSets, place: int) -> bool:
    """Whether a set that was solved by itself got what a case says of it."""
    if case.numbers.keys() != other.numbers.keys():
        return False
    for name, number in other.numbers.items():
        if isinstance(number, str) or name not in case.forms:
            if number != case.numbers[name]:
                return False
            continue
        value = float(form_numbers(case.forms[name], given, given.only(place), False)[0][0])
        if not math.isclose(value, number.float, rel_tol=ALIKE, abs_tol=NOTHING):
            return False
    return True
