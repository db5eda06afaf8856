"""Edges of cases: what is found where a condition is only just met, as a case of its own, in which one letter is what makes it so."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Generic

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.effort import Allowance, Exhausted
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import degree, is_zero, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ZERO, Call, Formula, Symbol, call
from rotsolve.core.derivation import Equality
from rotsolve.search.cases import Case, Found, Solving, case_at
from rotsolve.search.lettersigns import LONG, Proviso
from rotsolve.search.letterspace import Glance, LetterSpace, Point, numbers_of
from rotsolve.search.provisos import divides, letter_rank, shown

INVERSES = {"cos": "acos", "sin": "asin", "tan": "atan"}
INSIDE = "#inside"  # a function in whose argument a letter stands
MOST = 12  # edges on which a case is solved
STEPS = 4_000  # of work for all of them


Confirming = Callable[
    [Found, Mapping[str, float]], Collection[str]
]  # the answers that an assembly gives too with these numbers


class Edge(Struct, frozen=True):
    """Where a gap is zero since a letter is `limit`, told as an `equality`; at a point of it that is of no special kind."""

    gap: Formula
    letter: str
    limit: Formula
    equality: Equality
    point: Point

    def put(self, value: Formula) -> Formula:
        """A formula as it is there."""
        return value.substitute({self.letter: self.limit})


class Edges(Generic[Found]):
    """The edges of the cases of some letters, each found and solved once."""

    def __init__(self, space: LetterSpace, solve: Solving[Found], confirming: Confirming[Found]) -> None:
        self.space = space
        self.solve = solve
        self.confirming = confirming
        self.allowance = Allowance(STEPS)
        self.known: list[Edge] = []
        self.seen: dict[int, Collection[str]] = {}  # the answers that are confirmed on them
        self.cases: dict[int, Case[Found]] = {}  # by the place of their edge among those known

    def edge(self, one: Proviso, rest: Sequence[Proviso], starts: Iterable[Point]) -> Edge | None:
        """The edge of a condition within those of the rest; None where it is met nowhere, or no letter can be put in for it."""
        known = self.known_at(one, rest)
        if known is not None:
            return known
        rest = [other for other in rest if not same_edge(other.gap, one.gap)]
        for edge in self.edges_near(one.gap, starts) if length(one.gap) < LONG else ():
            if self.space.has(edge.point) and not self.fails(edge, rest):
                self.known.append(edge)
                return edge
        return None

    def untold(self, gap: Formula) -> bool:
        """Whether nothing can be said of where a gap is zero: it is long, or no letter is told by it."""
        return length(gap) >= LONG or not any(True for _ in self.limits(gap))

    def known_at(self, one: Proviso, rest: Sequence[Proviso]) -> Edge | None:
        """The edge of a condition within those of the rest, if it has been looked at."""
        rest = [other for other in rest if not same_edge(other.gap, one.gap)]
        found = (edge for edge in self.known if same_edge(edge.gap, one.gap) or is_zero_there(edge.put(one.gap)))
        return next((edge for edge in found if not self.fails(edge, rest)), None)

    def along(self, edge: Edge) -> Iterator[Edge]:
        """An edge, and each place on it where nothing holds of what has been found there."""
        cases: list[Case[Found]] = []
        place: Edge | None = edge
        while place is not None:
            yield place
            case = self.case(place)
            if case is None or not case.conditions:
                return
            cases.append(case)
            apart = (other for other in self.edges_near(edge.gap, [edge.point]) if self.space.has(other.point))
            place = next((other for other in apart if self.fails_all(other, cases)), None)
            self.known += [] if place is None else [place]

    def fails_all(self, edge: Edge, cases: Iterable[Case[Found]]) -> bool:
        """Whether none of some cases holds at an edge's point."""
        return all(self.fails(edge, case.conditions) for case in cases)

    def fails(self, edge: Edge, provisos: Iterable[Proviso]) -> bool:
        """Whether one of some conditions certainly does on an edge, where others may be only just met too."""
        glance = Glance(self.space, edge.point)
        return any(glance.sign(edge.put(one.gap)) in (-1, None) for one in provisos)

    def edges_near(self, gap: Formula, starts: Iterable[Point]) -> Iterator[Edge]:
        """The edge by each of its letters, at points with the other letters as they are near the starts."""
        equality = replace(shown(Proviso(gap, strict=True), self.space), relation="=")
        limits = dict(self.limits(gap))
        for start in starts:
            for point in (start, *self.space.elsewhere(start)):
                for name, limit in limits.items():
                    size = self.size(limit, point)
                    if size is not None and size > 0:
                        yield Edge(gap, name, limit, equality, {**point, name: size})

    def limit(self, gap: Formula, name: str) -> Formula | None:
        """What a letter is where a gap is zero, if it stands in it to the first power, as a square alone, or in one cosine or its like."""
        if degree(gap, name) == 1:
            return self.solved(gap, name)
        functions = {node for node in gap.walk(*INVERSES) if isinstance(node, Call) and name in node.symbols()}
        if len(functions) == 1 and (function := functions.pop()).function in INVERSES:
            return self.limit_inside(gap, function, name)
        slope = differentiate(gap, name)
        if degree(gap, name) != 2 or not is_zero(slope.substitute({name: ZERO})):
            return None
        curve = differentiate(slope, name)
        return simplify(
            call("sqrt", -2 * gap.substitute({name: ZERO}) / curve),
            order=self.space.order,
            positive=self.space.positive,
        )

    def limit_inside(self, gap: Formula, function: Call, name: str) -> Formula | None:
        """What a letter is that stands in a function of an angle to the first power, and nowhere else: cos 2 α = 0 at α = π/4."""
        plain, (angle,) = gap.transform(lambda node: Symbol(INSIDE) if node == function else node), function.arguments
        if name in plain.symbols() or degree(plain, INSIDE) != 1 or degree(angle, name) != 1:
            return None
        value = self.solved(plain, INSIDE)
        return None if value is None else self.solved(angle - call(INVERSES[function.function], value), name)

    def solved(self, gap: Formula, name: str) -> Formula | None:
        """The root of what is linear in a letter."""
        return solve_linear(gap, name, order=self.space.order, positive=self.space.positive)

    def limits(self, gap: Formula) -> Iterator[tuple[str, Formula]]:
        """What each letter is that stands in a gap to the first power, as a page would have it first."""
        letters = sorted(gap.symbols() & self.space.letters.keys())
        found = []
        for name in letters:
            limit = self.limit(gap, name)
            if limit is not None:
                found.append((divides(limit), letter_rank(self.space.letters[name]), length(limit), name, limit))
        yield from ((name, limit) for *_, name, limit in sorted(found, key=lambda item: item[:4]))

    def size(self, limit: Formula, point: Point) -> Fraction | None:
        """The number of a limit at a point, nearly."""
        try:
            return Fraction(evaluate(limit, {**self.space.oracle.values, **numbers_of(point)}, digits=15).float)
        except (Undefined, ValueError, ZeroDivisionError, OverflowError):
            return None

    def solved_at(self, edge: Edge) -> Case[Found] | None:
        """What has been found there, if it has been asked for."""
        return self.cases.get(self.known.index(edge))

    def confirmed(self, edge: Edge, name: str) -> bool:
        """Whether an answer that is that of the edge alone is confirmed there."""
        place, case = self.known.index(edge), self.cases[self.known.index(edge)]
        if place not in self.seen and case.found is not None:
            numbers = {letter: float(size) for letter, size in edge.point.items()}
            self.seen[place] = self.confirming(case.found, numbers)
        return name in self.seen.get(place, ())

    def case(self, edge: Edge) -> Case[Found] | None:
        """What is found there; None where too many have been solved, or it takes too long."""
        place = self.known.index(edge)
        if place not in self.cases:
            if len(self.cases) == MOST:
                return None
            try:
                with self.allowance.used():
                    self.cases[place] = case_at(edge.point, self.space, self.solve, {edge.letter: edge.limit})
            except Exhausted:
                return None
        return self.cases[place]


def is_zero_there(value: Formula) -> bool:
    """Whether a formula is exactly zero; not where it has no value at all."""
    try:
        return is_zero(value)
    except ZeroDivisionError:
        return False


def same_edge(one: Formula, other: Formula) -> bool:
    """Whether two gaps are zero at the same places since they are equal or opposite."""
    return one == other or is_zero(one - other) or is_zero(one + other)
