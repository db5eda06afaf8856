"""Cases: letters without numbers, case by case. Each case is solved at numbers of its own, and holds where every sign is as it was there.

Letters stand for positive values, angles for those between 0 and 90°. What is sure for all of these is no condition. Another case is looked
for where a condition of one that is known fails: some letters are made larger or smaller until it does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Generic, TypeVar

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import witnessed
from rotsolve.algebra.certified.sign import SignOracle, sign_within
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import Fractions, degree, is_zero, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ZERO, Call, Formula, Number, Quotient, Symbol, negate
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.units.dimension import NONE
from rotsolve.core.derivation import Equality
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.core.letters import Given
from rotsolve.language.problem import Problem, references
from rotsolve.motion.positive import is_angle

MOST = 8  # cases that are solved
LARGEST = 12  # doublings and halvings of a letter
Found = TypeVar("Found")
Point = Mapping[str, Formula]


class Proviso(Struct, frozen=True):
    """gap > 0 (`strict`), or gap ≥ 0, where the gap is no product of others, and of no sure sign."""

    gap: Formula
    strict: bool

    def opposes(self, other: Proviso) -> bool:
        """Whether one holds exactly where the other does not."""
        return self.strict != other.strict and is_zero(self.gap + other.gap)

    def same(self, other: Proviso) -> bool:
        return self.strict == other.strict and is_zero(self.gap - other.gap)


class Case(Struct, Generic[Found], frozen=True):
    """What is found at a point, where it holds, and all signs that it took; without an answer, the fault that says why."""

    point: Point
    conditions: tuple[Proviso, ...]
    found: Found | None = None
    fault: Exception | None = None
    objected: bool = False  # whether its own checks object to it
    signs: Mapping[Formula, int] = field(default_factory=dict)


def open_letters(problem: Problem) -> tuple[Given, ...]:
    """The letters without a value that stand for any: not what is asked, nor the places over which an extremum is sought."""
    ranging = set[str]()
    for find in problem.finds:
        if find.where is not None and find.where.phrase is not None and isinstance(find.formula, Symbol):
            ranging.add(find.formula.name)
        if find.extreme or (find.where is not None and find.where.word):
            arguments = [ref.argument for ref in references(find) if ref.argument is not None]
            ranging.update(name for argument in arguments for name in argument.symbols())
    return tuple(item for item in problem.givens if item.value is None and not item.asked and item.name not in ranging)


def at_point(problem: Problem, point: Point) -> Problem:
    """The problem whose case is looked at with these numbers for its open letters."""
    return replace(problem, givens=tuple([replace(item, trial=point.get(item.name)) for item in problem.givens]))


def first_point(letters: Iterable[Given]) -> dict[str, Formula]:
    """A point of no special kind: different numbers near 1, for angles near 35°, for what has no dimension near ⅓."""
    point: dict[str, Formula] = {}
    for place, given in enumerate(letters):
        share = Fraction(1 + 37 * place % 89, 89)
        size = Fraction(9, 20) + share / 3 if is_angle(given) else Fraction(4, 5) + share / 2
        point[given.name] = Number(size / 3 if given.dimension == NONE else size)
    return point


class LetterSpace:
    """What open letters may be, and what follows of signs for all that they may be."""

    def __init__(self, letters: Sequence[Given], oracle: SignOracle, order: Sequence[str] = ()) -> None:
        self.order = order
        self.letters = {given.name: given for given in letters}
        self.oracle = oracle
        self.acute = {name for name, given in self.letters.items() if is_angle(given)}
        self.positive = (oracle.positive | self.letters.keys()) - self.acute
        self.assumed = set[
            str
        ]()  # letters of which it was needed that they are positive, or acute, though nothing else says so

    def sure(self, value: Formula) -> int | None:
        """The sign that a formula has wherever its letters may be."""
        sign = self.oracle.by_letters(value)
        if sign is None:
            own = simplify(value, positive=self.positive)
            sign = sign_within(own, {*self.positive, *self.acute}, self.acute)
            if sign is not None:
                self.assumed |= own.symbols() & self.letters.keys() - self.oracle.positive - self.oracle.limits().keys()
        return sign

    def assumptions(self) -> tuple[str, ...]:
        """What letters were taken to be, in words: "u, w > 0", "0 < β < 90°"."""
        names = [name for name in self.letters if name in self.assumed]
        positive = ", ".join(name_to_text(name) for name in names if name not in self.acute)
        acute = ", ".join(name_to_text(name) for name in names if name in self.acute)
        return (*([f"{positive} > 0"] if positive else []), *([f"0 < {acute} < 90°"] if acute else []))

    def conditions(self, signs: Mapping[Formula, int], point: Point) -> tuple[Proviso, ...]:
        """What has to hold for formulas to have these signs, each once."""
        found: list[Proviso] = []
        for value, sign in signs.items():
            for one in self.factors(value, sign, point):
                if not any(one.gap == other.gap or is_zero(one.gap - other.gap) for other in found):
                    found.append(one)
        return tuple(found)

    def factors(self, value: Formula, sign: int, point: Point) -> Iterator[Proviso]:
        """The conditions for a formula to have a sign: for all of its factors whose own is not sure."""
        if self.sure(value) is not None:
            return
        for node in value.walk("abs"):
            if isinstance(node, Call) and node.function == "abs":
                inner = self.side(node.arguments[0], point)
                yield from self.factors(node.arguments[0], inner, point)
        value = self.without_bars(value, point)
        if self.sure(value) is not None:
            return
        problem = Fractions([value], positive=self.positive)
        top, bottom = problem.field.cancel(problem.ratio())
        parts = [part for poly in (top, bottom) for part, power in problem.field.factor(poly)[1] if power % 2]
        shown = [problem.shaper.poly(part) for part in parts]
        doubtful = [part for part in shown if self.sure(part) is None]
        for part in doubtful:
            side = self.side(part, point)
            if side:
                yield Proviso(part if side > 0 else simplify(negate(part)), sign > 0)

    def without_bars(self, value: Formula, point: Point) -> Formula:
        """The formula with x or −x for |x|, as it is at a point."""

        def unbarred(node: Formula) -> Formula:
            if not (isinstance(node, Call) and node.function == "abs"):
                return node
            inside = node.arguments[0]
            return inside if self.side(inside, point) >= 0 else negate(inside)

        return value.transform(unbarred)

    def side(self, value: Formula, point: Point) -> int:
        """The sign of a formula at a point."""
        return SignOracle({**self.oracle.values, **point}).by_numbers(value) or 0

    def holds(self, conditions: Iterable[Proviso], point: Point) -> bool:
        """Whether conditions hold at a point."""
        return all(self.side(one.gap, point) > 0 for one in conditions)

    # other points

    def beyond(self, cases: Sequence[Case[Found]]) -> Point | None:
        """A point at which none of the cases holds; None where none is found."""
        for case in cases:
            for one in case.conditions:
                for point in self.around(case.point, sorted(one.gap.symbols() & self.letters.keys())):
                    if self.side(one.gap, point) < 0 and not any(
                        self.holds(other.conditions, point) for other in cases
                    ):
                        return point
        return None

    def around(self, point: Point, names: Sequence[str]) -> Iterator[Point]:
        """Points with one letter larger or smaller."""
        for power in range(1, LARGEST):
            for name in names:
                for factor in (Fraction(2) ** power, Fraction(1, 2) ** power):
                    value = point[name] * factor
                    size = simplify(value)
                    assert isinstance(size, Number)
                    if name not in self.acute or size.value < Fraction(3, 2):
                        yield {**point, name: size}


def cases_of(space: LetterSpace, solve: Callable[[Point], tuple[Found, bool]]) -> list[Case[Found]]:
    """All cases that are found, the first at a point of no special kind; `solve` says what is found at a point, and whether it objects."""
    cases: list[Case[Found]] = []
    point: Point | None = first_point(space.letters.values())
    while point is not None and len(cases) < MOST:
        found, objected, fault = None, False, None
        with witnessed() as witness:
            try:
                found, objected = solve(point)
            except (Unsolvable, SceneError) as error:
                fault = error
        signs = dict(witness.supposed)
        cases.append(Case(point, space.conditions(signs, point), found, fault, objected, signs))
        point = space.beyond(cases)
    return cases


# telling them apart


def separating(own: Sequence[Case[Found]], others: Sequence[Case[Found]]) -> tuple[Proviso, ...] | None:
    """The fewest conditions that all of some cases have and that each of the others contradicts; None where there are none such."""
    common = [one for one in own[0].conditions if all(any(map(one.same, case.conditions)) for case in own[1:])]

    def apart(conditions: Sequence[Proviso]) -> bool:
        return all(any(one.opposes(bar) for one in conditions for bar in case.conditions) for case in others)

    if not apart(common):
        return None
    for one in sorted(common, key=lambda item: -length(item.gap)):
        rest = [other for other in common if other is not one]
        common = rest if apart(rest) else common
    return tuple(common)


def shown(condition: Proviso, space: LetterSpace) -> Equality:
    """A condition as a page tells it: solved for a letter where that goes, with none below a line, a coefficient before others."""
    more, less = (">", "<") if condition.strict else ("≥", "≤")
    told: list[tuple[bool, int, int, str, Equality]] = []
    for name in sorted(condition.gap.symbols() & space.letters.keys()):
        if degree(condition.gap, name) != 1:
            continue
        limit = solve_linear(condition.gap, name, order=space.order, positive=space.positive)
        slope = space.sure(simplify(condition.gap.substitute({name: Symbol(name) + 1}) - condition.gap))
        if limit is not None and slope and space.sure(limit) == 1:
            line = Equality(Symbol(name), limit, more if slope > 0 else less)
            told.append((divides(limit), rank(space.letters[name]), length(limit), name, line))
    return min(told)[-1] if told else Equality(condition.gap, ZERO, more)


def divides(value: Formula) -> bool:
    """Whether a letter stands below a line."""
    quotients = (node for node in value.walk(Quotient) if isinstance(node, Quotient))
    return any(node.denominator.symbols() for node in quotients)


def rank(given: Given) -> int:
    """Coefficients first, angles last."""
    return 0 if given.dimension == NONE else 2 if is_angle(given) else 1
