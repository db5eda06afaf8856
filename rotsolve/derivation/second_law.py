"""Second law: each answer by a law that its plan did not use: the answers are put into the equations that would settle it.

The equations of such a plan must hold at the answers, and tell what is asked by themselves: their derivatives by its unknowns are
independent there. Where a letter of them has no number, or one sums over a phase, they are solved instead.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from enum import Enum, auto
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import Precision, evaluate
from rotsolve.algebra.certified.balls import Ball, Undefined
from rotsolve.algebra.exact.normal import equal, is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import ZERO, Formula, Integral, Number, Symbol
from rotsolve.core.derivation import Check, Words
from rotsolve.core.equation import ANGULAR_MOMENTUM, ENERGY, FAMILIES, NEWTON, Equation
from rotsolve.core.symbols import has_quantities
from rotsolve.derivation.behind import families
from rotsolve.derivation.letters import Letters, listed
from rotsolve.paths.meaning import NotYet
from rotsolve.plan import Shortage
from rotsolve.search.answers import Answered, NoAnswer
from rotsolve.search.consistency import BITS, KnownBalls, runs
from rotsolve.search.planning import families_for
from rotsolve.search.search import FEW_TRIES, TURN, Search, whole_turns
from rotsolve.solver.textbook import is_long_root

LONGEST_TOLD = 40  # nodes of an equation that is told among the checks
SETS = 4  # of numbers for letters that have none
CLOSE = 1e-9  # up to which share of their size two numbers agree
NOTHING = arb(0)
Row = dict[int, Ball]  # of a matrix: what is not nothing, by columns


def second_law_checks(search: Search, letters: Letters, balls: KnownBalls) -> Iterator[Check]:
    """Each answer again by a law that its plan did not use; one that disagrees is an objection."""
    closed = [(answered, answered.found.formula) for answered in search.wholes()]
    laws_of = {
        answered.asked.letter: families(answered, search)
        for answered, formula in closed
        if formula is not None and not is_long_root(formula)
    }
    pending = [answered for answered, _ in closed if laws_of.get(answered.asked.letter)]  # not on definitions alone
    slopes: dict[tuple[int, str], Ball | None] = {}
    for law in (ENERGY, ANGULAR_MOMENTUM, NEWTON):
        unused = [answered for answered in pending if law not in laws_of[answered.asked.letter]]
        if not unused:
            continue
        other = search.another(families_for(law), spare=True, confirming=True)
        putting = PuttingIn(search, other, balls, slopes)
        agreed = []
        for answered in unused:
            outcome = putting.outcome(answered)
            formula = again(other, answered) if outcome is Confirmation.OPEN else answered.found.formula
            if outcome is Confirmation.NO_PLAN or formula is None or law not in families(other.answered[-1], other):
                continue
            forms = (formula, *other_forms(other, answered.asked.letter))
            if outcome is Confirmation.HOLDS or any(same(one, answered.found.formula, search, balls) for one in forms):
                pending.remove(answered)
                agreed.append(answered)
            elif over_a_phase(other) and not has_quantities(formula):  # what rests on an open letter is no other answer
                pending.remove(answered)
                name = Symbol(answered.asked.find.name)
                another = formula.substitute(letters.symbols)
                yield Check((f"{FAMILIES[law].words} gives another ", name, ": ", another), False)
        if agreed:
            names = listed(answered.asked.find.name for answered in agreed)
            said = (f"{FAMILIES[law].words} {FAMILIES[law].gives} the same ", *names)
            shown = equation_told(law, search, other, letters)
            yield Check((*said, *shown), law=law, bare=not shown)


def equation_told(law: str, search: Search, other: Search, letters: Letters) -> Words:
    """The equation of a law by which an answer comes out once more, ": m g R = m R a + I α", where all its letters are printed anyway, and
    no other law has said the same."""
    told = (search.planner.pool[index] for item in search.answered for index in item.used)
    same = {(one.left, one.right) for one in told if one.family}
    for equation in (other.planner.pool[index] for item in other.answered for index in item.used):
        if equation.family == law and (equation.left, equation.right) in same:
            return ()
        known = equation.symbols() <= letters.symbols.keys() | other.givens.keys()
        summed = equation.left.holds(Integral) or equation.right.holds(Integral)
        if equation.family == law and known and equation.relation == "=" and not summed:
            left, right = (side.substitute(letters.symbols) for side in (equation.left, equation.right))
            if length(left) + length(right) <= LONGEST_TOLD:
                return (": ", left, " = ", right)
    return ()


class Confirmation(Enum):
    """What comes of putting an answer into the equations of another law."""

    HOLDS = auto()  # they hold, and tell it
    NO_PLAN = auto()  # they do not lead to it
    OPEN = auto()  # it takes solving to say


class PuttingIn(Struct, frozen=True):
    """Puts the answers of a search into the plans of another one, by one law."""

    search: Search
    other: Search
    balls: KnownBalls
    slopes: dict[tuple[int, str], Ball | None]  # by the equation's identity and the letter

    def outcome(self, answered: Answered) -> Confirmation:
        """Whether the other law's equations for an answer hold at the answers; if they do, the other search knows it from now on."""
        asked, other = answered.asked, self.other
        if asked.swings or other.scene.observed or asked.letter in other.solver.solved or asked.formula == ZERO:
            return Confirmation.OPEN
        for part in answered.parts:
            if part.asked.letter not in other.known and (outcome := self.outcome(part)) is not Confirmation.HOLDS:
                return outcome
        return self._by_plans(answered)

    def _by_plans(self, answered: Answered) -> Confirmation:
        """The outcome with the cheapest plan; where its equations depend on each other, with the next one, if they all tell enough."""
        other, banned = self.other, set[int]()
        for _ in range(FEW_TRIES):
            plan = other.planned(answered.asked, banned)
            if isinstance(plan, Shortage):
                return Confirmation.NO_PLAN
            with Precision(BITS):
                order = sorted(plan.equations, key=lambda index: not other.planner.pool[index].family)
                laws = [other.planner.pool[index] for index in order]
                if not all(map(self.holds, laws)):
                    return Confirmation.OPEN
                rows = self.rows(laws, plan.unknowns)
                if rows is None:
                    return Confirmation.OPEN
                spare = dependent(rows)
                if spare is not None and not banned and not self.tells(answered.asked.letter):
                    return Confirmation.NO_PLAN
            if spare is None:
                other.accept(answered, plan)
                return Confirmation.HOLDS
            banned.add(order[spare])
        return Confirmation.OPEN

    def holds(self, equation: Equation) -> bool:
        """Whether both sides are surely the same: as numbers, or exactly where letters have none."""
        if runs(equation, self.other):
            return False
        gap = self.balls.gap(equation)
        if gap is None or not gap[0] <= CLOSE * gap[1]:
            return False
        if self.balls.free.isdisjoint(equation.symbols()):
            return True
        exact = self.search.solver.with_found(equation.left - equation.right)
        return not has_quantities(exact) and is_zero(exact, self.other.solver.positive)

    def tells(self, letter: str) -> bool:
        """Whether all equations of the law together tell a letter, or may do so: a combination of their derivatives is that by it alone."""
        other = self.other
        laws = [other.planner.pool[index] for index in other.allowed(letter)]
        names = sorted(frozenset[str]().union(*(law.symbols() for law in laws)) - other.known - {letter})
        rows = self.rows(laws, (*names, letter))
        if rows is None or any(runs(law, other) for law in laws):
            return True
        return any(surely(row.get(len(names), NOTHING)) for row in left_over_rows(rows, len(names)))

    def rows(self, laws: Sequence[Equation], names: Sequence[str]) -> list[Row] | None:
        """The derivatives of equations' gaps by some letters, at the answers; None where one is no number."""
        places, found = {name: place for place, name in enumerate(names)}, list[Row]()
        for law in laws:
            row = {places[name]: self.slope(law, name) for name in law.symbols() & places.keys()}
            told = {place: value for place, value in row.items() if value is not None}
            if len(told) < len(row):
                return None
            found.append(told)
        return found

    def slope(self, equation: Equation, name: str) -> Ball | None:
        """The derivative of an equation's gap by a letter, at the answers."""
        key = (id(equation), name)
        if key not in self.slopes:
            self.slopes[key] = self.balls.size(differentiate(equation.left - equation.right, name))
        return self.slopes[key]


def surely(value: Ball) -> bool:
    """Whether a number is surely not 0."""
    return bool(abs(value) > 0)


def dependent(rows: Sequence[Row]) -> int | None:
    """Which row of a square matrix is no more than a sum of those before it, as far as numbers tell; None where it has an inverse."""
    done: list[tuple[int, Row]] = []
    for place, row in enumerate(rows):
        for column, other in done:
            row = without(column, row, other)
        column = max(row, key=lambda k: float(abs(row[k]).lower()), default=0)
        if not surely(row.get(column, NOTHING)):
            return place
        done.append((column, row))
    return None


def left_over_rows(rows: list[Row], columns: int) -> list[Row]:
    """The rows that are left when the first columns have been eliminated."""
    for column in range(columns):
        pivot = next((row for row in rows if surely(row.get(column, NOTHING))), None)
        if pivot is not None:
            rows = [without(column, row, pivot) for row in rows if row is not pivot]
    return rows


def without(column: int, row: Row, pivot: Row) -> Row:
    """A row less the multiple of another one with which nothing of a column is left."""
    if column not in row:
        return row
    share = row[column] / pivot[column]
    left = {place: value for place, value in row.items() if place != column}
    for place, value in pivot.items():
        if place != column:
            left[place] = left.get(place, NOTHING) - share * value
    return left


def over_a_phase(other: Search) -> bool:
    """Whether the other way sums over a phase; all that holds at single moments has been compared with the answers before."""
    return any(runs(other.planner.pool[index], other) for index in other.answered[-1].used)


def again(other: Search, answered: Answered) -> Formula | None:
    """The answer by another search's laws, None where they do not give it."""
    try:
        return other.answer(answered.asked).found.formula
    except (NoAnswer, NotYet):
        return None


def other_forms(other: Search, letter: str) -> Iterator[Formula]:
    """The other roots that another search knows for a letter of the scene, of an angle those within half a turn: which is meant is told by
    more than its law."""
    for root in other.rivals.get(letter, ()):
        found = other.solver.with_found(root)
        yield found + whole_turns(found, other) * TURN if other.may_be_angle(letter) else found


def same(one: Formula, other: Formula | None, search: Search, balls: KnownBalls) -> bool:
    """Exact equality, else agreement of the certified numbers; of letters without one, of those of their case and some near."""
    if other is None:
        return False
    if equal(one, other, search.solver.positive):
        return True
    free = sorted((one.symbols() | other.symbols()) & balls.free)
    sets = [near(balls.values, free, step) for step in range(SETS if free else 1)]
    try:
        gaps = [(evaluate(one - other, values, digits=12), evaluate(other, values, digits=12)) for values in sets]
    except (Undefined, ValueError):
        return False
    return all(abs(gap.float) <= CLOSE * max(abs(size.float), 1e-300) for gap, size in gaps)


def near(values: Mapping[str, Formula], names: Sequence[str], step: int) -> dict[str, Formula]:
    """Numbers in which some letters are a little larger, each by another share."""
    grown = {name: values[name] * Number(1 + Fraction(step * place, 10_000)) for place, name in enumerate(names, 2)}
    return {**values, **grown}
