"""Rivals: other values that a letter of the scene may have as well as that of its answer.

What a letter has to fulfil may have several roots. The other roots of its equation, and those that an assembly finds with numbers over the
range of the letter, are put into the scene like the answer itself, as far as the scene lets it be such; where every line then holds, the
question has several answers, of which one alone is half of the truth.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import pairwise

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.confirm import NotConfirmed, OverBudget
from rotsolve.confirm.course.following import Course
from rotsolve.confirm.course.node import Budget
from rotsolve.confirm.course.samples import Fits, Numbers, holding
from rotsolve.confirm.course.scan import Scan, places_beside
from rotsolve.confirm.course.sizes import letters_open, natural_units
from rotsolve.confirm.course.sought import place_told, reach_of, stands_at
from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.verdicts import SAME, not_so, said_of
from rotsolve.core.derivation import Answer, AnswerConfirmation
from rotsolve.language.problem import Find, Given, Problem

Said = dict[str, float | str]
Judge = Callable[
    [Find, Said, Numbers], AnswerConfirmation
]  # what the assembly says of an answer, at numbers for all letters
ASK = {
    "where": ": ask for the `smallest` or the `largest` one",
    "smallest": ", and is smaller",
    "largest": ", and is larger",
}
NEAR = 1e-3  # share of a number within which what is found over a range is that number
HALVINGS = 20  # towards an end of the range of a letter
SCANS = 2  # sets of numbers at which each case is looked at over the range of its letter
SCAN_BUDGET = 5000  # instants of one body for all of them
ENOUGH = 0.75  # share of these that has to be left where it is looked once more
NOT_LOOKED = "its other values were not all looked for: the motion takes too long to follow"
NOT_LOOKED_ON_THE_WAY = (
    "other values of `{letter}`, on which it may hang, were not all looked for: the motion takes too long to follow"
)
UNTOLD = " was not looked for: the motion takes too long to follow"


class Rivals:
    """The other values of the letters that answers tell, looked for at one set of numbers after the other.

    Sizes are taken to be positive: of those that do against that sense `against` has the words, by answers.
    """

    def __init__(
        self,
        answers: Sequence[Answer],
        problem: Problem,
        fits: Fits,
        judge: Judge,
        others: Callable[[str], tuple[Formula, ...]],
    ) -> None:
        self.answers, self.problem, self.fits, self.judge = answers, problem, fits, judge
        self.others = others
        self.finds = {find.group: find for find in problem.finds}
        self.givens: dict[Formula, Given] = {Symbol(given.name): given for given in problem.givens}
        sought = {find.formula for find in problem.finds}
        self.open = [given for given in letters_open(problem) if Symbol(given.name) not in sought]
        self.in_numbers = all(given.automatic for given in self.open)
        self.budget = Budget(SCAN_BUDGET)
        self.scans: dict[str, int] = {}  # how often each case has been looked at
        self.against: dict[str, str] = {}

    def tried(self, verdicts: Mapping[str, AnswerConfirmation], known: Numbers) -> dict[str, AnswerConfirmation]:
        """The verdicts at some numbers, where a letter with several values that all do is not confirmed, nor what hangs on it."""
        found = dict(verdicts)
        for sought in self.letters(found, known):
            try:
                value = next(self.rivals(sought), None)
            except OverBudget:
                why = NOT_LOOKED_ON_THE_WAY.format(letter=sought.given.name) if sought.on_the_way else NOT_LOOKED
                names = self.may_hang_on(sought, found) if self.scans[sought.case] == 1 else ()
                found |= {name: AnswerConfirmation(name, None, why, astray=True) for name in names}
                continue
            if value is not None:
                found |= self.rivalled(sought, value)
        return found

    def letters(self, verdicts: Mapping[str, AnswerConfirmation], known: Numbers) -> Iterator[SoughtLetter]:
        """The letters that answers tell, as far as these hold; and those on the way to answers for which no question asks."""
        for several in self.answers:
            find, verdict = self.finds[several.name], verdicts[several.name]
            answer, given = holding(several, known), self.givens.get(find.formula)
            if given is not None and given.value is not None and find.where is None:
                continue  # a number that the scene tells, in another unit
            if verdict.holds and answer is not None and given is not None:
                yield SoughtLetter(find, given, known, verdict.answered[0], f"{find.group} {id(answer)}", answer.rivals)
        told = {find.formula for find in self.finds.values()}
        for letter, given in self.givens.items():
            if (
                given.asked
                and letter not in told
                and given.name in known
                and any(map(stands_confirmed, verdicts.values()))
            ):
                find = Find(given.name, letter, ())
                name, roots = given.name, self.others(given.name)
                yield SoughtLetter(find, given, known, known[name], name, roots, on_the_way=True)

    def may_hang_on(self, sought: SoughtLetter, found: Mapping[str, AnswerConfirmation]) -> list[str]:
        """The answers that a letter tells: its own, or where no question asks for it and it may be several all that are confirmed."""
        if sought.on_the_way and not sought.roots:
            return []
        if sought.on_the_way:
            return [name for name, verdict in found.items() if stands_confirmed(verdict)]
        return [sought.find.group] if sought.find.group in found else []

    def rivals(self, sought: SoughtLetter) -> Iterator[float]:
        """The values with which all holds as well, those of the equation's other roots first; others of a size stay `against` it."""
        yield from filter(partial(self.does, sought), sought.other_roots())
        count = self.scans.get(sought.case, 0) + 1
        again = not self.in_numbers and count <= SCANS and self.budget.left > ENOUGH * SCAN_BUDGET
        if not self.fits(sought.known) or (count > 1 and not again):
            return
        self.scans[sought.case] = count
        places = places_beside(
            sought.said, natural_units(self.problem).of(sought.given.dimension), sought.given.dimension
        )
        yield from filter(partial(self.does, sought), (0.0,) if sought.said else ())  # beside which no sign changes
        yield from filter(partial(self.does, sought), self.roots(sought, places, self.budget))
        if sought.sized and sought.find.group not in self.against:
            self.look_against(sought.find.group, sought, [-place for place in places])

    def look_against(self, name: str, sought: SoughtLetter, places: Sequence[float]) -> None:
        """Note the first value against the sense of a size with which all holds as well."""
        try:
            for value in self.roots(sought, places, self.budget):
                if self.does(sought, value, sized=False):
                    self.against |= dict.fromkeys(self.others_with(sought, value), self.equal_to(sought, value))
                    break
        except OverBudget:
            letter = f": {sought.given.name}" if sought.on_the_way else ""
            names = [one.name for one in self.answers if sought.roots] if sought.on_the_way else [name]
            self.against |= dict.fromkeys(names, f"{letter}{UNTOLD}")

    def others_with(self, sought: SoughtLetter, value: float) -> list[str]:
        """The answers that are others with another value: that of the letter, or where no question asks for it all that hang on it."""
        if not sought.on_the_way:
            return [sought.find.group]
        return [one.name for one in self.answers if self.changes_with(one, sought.known, sought.numbers(value))]

    def equal_to(self, sought: SoughtLetter, value: float) -> str:
        """That another value does as well, with the numbers of open letters."""
        letter = f": {sought.given.name}" if sought.on_the_way else ""
        return f"{letter}{sought.equal_to(value)}{self.numbers_of(sought)}"

    def roots(self, sought: SoughtLetter, places: Sequence[float], budget: Budget) -> Iterator[float]:
        """What fulfils what is asked or told of the letter, between places that the scene lets it be, while other letters stay."""
        letter = sought.given.name
        allowed = list(places_allowed(places, lambda at: self.fits(sought.numbers(at))))
        reach = reach_of(sought.find, letter, self.problem, sought.known, budget) if allowed else None
        for value in Scan(reach, sought.said).roots(allowed) if reach is not None else ():
            if abs(value - sought.said) > NEAR * max(abs(value), abs(sought.said)):
                yield value

    def does(self, sought: SoughtLetter, value: float, *, sized: bool = True) -> bool:
        """Whether all holds with another value."""
        if not sought.may_be(value, sized=sized) or not self.fits(sought.numbers(value)):
            return False
        holds = self.judge(sought.find, {"": value}, sought.numbers(value)).holds is True
        return holds and not self.later(sought, value) and not self.unstable(sought, value)

    def later(self, sought: SoughtLetter, value: float) -> bool:
        """Whether another value is a place to which the same motion comes later: a state is the first time at which its lines hold."""
        state = place_told(self.problem, sought.given.name)
        if state is None or sought.find.modifier or sought.find.where is not None:
            return False
        courses = (Course(self.problem, sought.numbers(at), self.budget) for at in (sought.said, value))
        try:
            own, other = (course.time(self.problem.states[0].name, state.name) for course in courses)
        except (NotConfirmed, ArithmeticError, ValueError):
            return False
        return other > own

    def unstable(self, sought: SoughtLetter, value: float) -> bool:
        """Whether another value is a place at which what stands steadily does not stay, while it does at the answer."""
        if not stands_at(self.problem, sought.given.name):
            return False
        steady = [state.name for state in self.problem.states if state.steady]
        said = sought.said
        return any(self.bend(sought, said, name) < 0.0 < self.bend(sought, value, name) for name in steady)

    def bend(self, sought: SoughtLetter, value: float, state: str) -> float:
        """How fast what pushes grows with the place at a state; 0 where nothing tells."""
        from rotsolve.confirm.course.swings import Small

        try:
            small = Small(Course(self.problem, sought.numbers(value), self.budget).node(state), "")
            return small.slope(small.first.placed.q[small.index])
        except (NotConfirmed, ArithmeticError, ValueError):
            return 0.0

    def numbers_of(self, sought: SoughtLetter) -> str:
        """With which numbers of the open letters."""
        told = ", ".join(f"{one.name} = {sought.known[one.name]:g}" for one in self.open if not one.automatic)
        return f" with {told}" if told else ""

    def rivalled(self, sought: SoughtLetter, value: float) -> dict[str, AnswerConfirmation]:
        """What is said where another value does as well: of its answer, and of what is another with it."""
        find, given, known = sought.find, sought.given, sought.known
        why = sought.said_beside(value)
        told = {one.name for one in self.answers if one.name == find.group}
        if given.asked:
            told |= {one.name for one in self.answers if self.changes_with(one, known, sought.numbers(value))}
        if self.in_numbers:  # a place in balance is said to be one of several
            holds = None if stands_at(self.problem, given.name) else False
            return {name: AnswerConfirmation(name, holds, why, rivalled=True) for name in told}
        letters = {one.name: known[one.name] for one in self.open}
        return {name: not_so(name, why, self.problem, letters) for name in told}

    def changes_with(self, answer: Answer, known: Numbers, numbers: Numbers) -> bool:
        """Whether an answer is another with other numbers."""
        own = holding(answer, known)
        said = {} if own is None else said_of(own, known)
        return bool(said) and self.judge(self.finds[answer.name], said, numbers).holds is not True


def places_allowed(places: Sequence[float], fits: Callable[[float], bool]) -> Iterator[float]:
    """The places that a scene lets a letter be, and beside each end of these the last place before it, with one on the way there."""
    ordered = sorted(places)
    yield from filter(fits, ordered)
    for one, other in pairwise(ordered):
        inner, outer = (one, other) if fits(one) else (other, one)
        if fits(inner) and not fits(outer):
            last, beyond = inner, outer
            for _ in range(HALVINGS):
                middle = 0.5 * (last + beyond)
                last, beyond = (middle, beyond) if fits(middle) else (last, middle)
            yield from (0.5 * (inner + last), last)


class SoughtLetter(Struct, frozen=True):
    """A letter that a question tells, with the number that is said of it at the known ones of all letters, by a case of its answer."""

    find: Find
    given: Given
    known: Numbers
    said: float
    case: str
    roots: tuple[Formula, ...] = ()  # others of its equation
    signed: bool = False  # whether it goes by value: a rate in space
    on_the_way: bool = False  # whether no question asks for it: then it is told of no angle to which side it is

    @property
    def turned_round(self) -> bool:
        """Whether a condition seeks an angle and one is said beyond half a turn: one within it, whole turns from that, may do as well."""
        return (
            self.find.where is not None
            and self.given.dimension in (None, ANGLE)
            and abs(self.said) > math.pi * (1.0 + SAME)
        )

    def other_roots(self) -> Iterator[float]:
        """The numbers of the other roots of its equation, and of an angle that within half a turn."""
        if self.turned_round:
            yield math.remainder(self.said, math.tau)
        for root in self.roots:
            try:
                value = float(value_of(root, self.known))
            except (NotConfirmed, ArithmeticError, ValueError, TypeError):
                continue
            yield math.remainder(value, math.tau) if self.given.dimension == ANGLE and abs(value) > math.pi else value

    @property
    def sized(self) -> bool:
        """Whether it is a size, of a kind that has a sense, as said: one that is positive, or none; an angle to one side, as a size is."""
        return self.given.dimension is not None and self.said >= 0.0 and not self.signed

    def said_beside(self, value: float) -> str:
        """What is said where another value does as well."""
        if self.turned_round:
            return f"{self.given.name}{self.equal_to(value)}, within half a turn"
        ask = ASK.get(self.find.modifier, ASK["where"] if self.find.where is not None else ": tell more of it")
        return f"{self.given.name}{self.equal_to(value)}{ask}"

    def equal_to(self, value: float) -> str:
        """That another value does as well, in degrees where it is known to be an angle."""
        shown = (
            f"{math.degrees(value):.6g}°".replace("-", "−")
            if self.given.dimension == ANGLE
            else f"{value:g} in SI units"
        )
        return f" = {shown} makes it so too"

    def numbers(self, value: float) -> Numbers:
        """The numbers of all letters, of this one another."""
        return {**self.known, self.given.name: value, self.find.name: value}

    def may_be(self, value: float, *, sized: bool = True) -> bool:
        """Whether a value is another one that the letter can have: of the sign of a size, an angle like that of the answer, or
        within half a turn; beyond the answer where the largest or the smallest is asked for."""
        angle, said = self.given.dimension == ANGLE, self.said
        if self.turned_round and abs(value) <= math.pi:
            return math.isfinite(value)
        apart = abs(math.remainder(value - said, math.tau) if angle else value - said)
        if not math.isfinite(value) or apart <= SAME * max(abs(value), abs(said)):
            return False
        mirrored = sized and said > 0.0 and abs(value + said) <= SAME * said and not self.on_the_way
        if angle and (abs(value) > math.pi or mirrored):
            return False  # an angle to one side is that to the other, seen in a mirror
        inside = {"largest": value < said, "smallest": value > said}.get(self.find.modifier, False)
        return (angle or value >= 0.0 or said < 0.0 or not sized or self.signed) and not inside


def stands_confirmed(verdict: AnswerConfirmation) -> bool:
    return verdict.holds is True
