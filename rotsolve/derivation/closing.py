"""Closing: whether an answer holds on the edges of its region too: where it is the same beyond, or is what is found on the edge itself."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import equal, is_zero, simplify
from rotsolve.algebra.formula import Formula
from rotsolve.core.derivation import Answer, Derivation
from rotsolve.core.symbols import TIME
from rotsolve.search.cases import Case
from rotsolve.search.edges import Edge, Edges, same_edge
from rotsolve.search.lettersigns import Proviso, denominators
from rotsolve.search.letterspace import LetterSpace, numbers_of
from rotsolve.search.provisos import Region

NEARLY = 1e-12  # what two answers that are equal on an edge may differ by, beside their sizes or in SI units
Solved = Case[Derivation]


class Held(Struct, frozen=True):
    """Answers, in which cases they were found, and where they hold."""

    answers: tuple[Answer, ...]
    own: Sequence[Solved]
    region: Region

    def needs(self, one: Proviso) -> bool:
        """Whether a condition is not of a case, but of what its answers need."""
        return any(one.same(need.proviso) for case in self.own if not case.objected for need in case.needs)


class Closing:
    """Of answers side by side, each in its region, to which the edges between them belong; of all answers, or of one by its name."""

    def __init__(self, edges: Edges[Derivation], name: str = "") -> None:
        self.edges = edges
        self.name = name
        self.looked_at: list[Edge] = []  # edges over which no answer goes on
        self.untold: list[Proviso] = []  # conditions of which nothing is known where they are only just met

    def closed(self, told: Sequence[Held]) -> list[Region]:
        """The regions with those of their edges that belong to them."""
        return [
            tuple(one if held.needs(one) else replace(one, strict=self.open_at(one, held, told)) for one in held.region)
            for held in told
        ]

    def open_at(self, one: Proviso, held: Held, told: Sequence[Held]) -> bool:
        """Whether what is held does not hold on the edge of one of its conditions, or that edge is another's."""
        edge = self.edges.edge(one, held.region, [case.point for case in held.own])
        if edge is None and self.edges.untold(one.gap):
            self.untold += [] if any(same_edge(other.gap, one.gap) for other in self.untold) else [one]
            return True
        if edge is None:
            return one.strict or any(answer.word for answer in held.answers)
        beside = [
            (other, against)
            for other in told
            for against in other.region
            if other is not held and is_zero(against.gap + one.gap) and self.reaches(other, edge)
        ]
        stepping = any(answer.word for answer in held.answers)  # of options none goes over into another
        for other, against in beside if not stepping or self.holds_at(edge, held) else ():
            if self.agree(held.answers, other.answers, edge):
                return one.strict and (not against.strict or told.index(other) < told.index(held))
        return not self.holds_at(edge, held)

    def holds_at(self, edge: Edge, held: Held) -> bool:
        """Whether what is held is also what is found on an edge, wherever that is one of its region."""
        if edge not in self.looked_at:
            self.looked_at.append(edge)
        places = (place for place in self.edges.along(edge) if place == edge or self.reaches(held, place))
        return all(self.agree(held.answers, self.found_at(place), place) for place in places)

    def alone(
        self, told: Sequence[Held], closed: Sequence[Region]
    ) -> tuple[list[tuple[Edge, Solved, Answer]], list[Edge]]:
        """What is found on edges, where that is not what is held on a side to which they belong; and the edges on which no answer is known.

        `closed` are the regions of what is told, with the edges that belong to them.
        """
        found, bare = [], []
        for edge in (place for seen in self.looked_at for place in self.edges.along(seen)):
            case, own = self.edges.case(edge), self.found_at(edge)
            beside = [(held, region) for held, region in zip(told, closed, strict=True) if self.reaches(held, edge)]
            if not beside or (own and any(self.covers(held, region, own, edge) for held, region in beside)):
                continue
            if case is not None and own and self.edges.confirmed(edge, own[0].name):
                found.append((edge, case, own[0]))
            else:
                bare.append(edge)
        return found, bare

    def covers(self, held: Held, region: Region, own: Sequence[Answer], edge: Edge) -> bool:
        """Whether what is held is what is found on an edge, and that belongs to its region."""
        within = not any(one.strict and same_edge(one.gap, edge.gap) for one in region)
        return within and self.agree(held.answers, own, edge)

    def parted(self, answer: Answer, own: Sequence[Solved]) -> list[Solved]:
        """Cases with the same answer, kept apart where on the edge between them another option holds, or a formula has no value."""
        if not answer.word and not any(below_lines(answer)):
            return list(own)
        apart: list[Proviso] = []
        for case, other in combinations(own, 2):
            for one in case.bars:
                against = next((item for item in other.bars if is_zero(item.gap + one.gap)), None)
                edge = None if against is None else self.edges.edge(one, (*case.bars, *other.bars), [case.point])
                if edge is not None and against is not None and self.breaks(answer, edge):
                    self.looked_at += [] if edge in self.looked_at else [edge]
                    apart += [one, against]
        return [replace(case, conditions=tuple(self.strictly(apart, case.conditions))) for case in own]

    def breaks(self, answer: Answer, edge: Edge) -> bool:
        """Whether an option does not hold on an edge between cases, or a formula has no value there."""
        if not answer.word:
            return singular(answer, edge)
        found = self.found_at(edge)
        return bool(found) and not self.agree((answer,), found, edge)

    def strictly(self, apart: Sequence[Proviso], conditions: Sequence[Proviso]) -> Iterator[Proviso]:
        """Conditions, those that are kept apart without their edges."""
        return (replace(one, strict=one.strict or one in apart) for one in conditions)

    def reaches(self, held: Held, edge: Edge) -> bool:
        """Whether a region lies at an edge."""
        rest = [one for one in held.region if not is_zero(one.gap - edge.gap) and not is_zero(one.gap + edge.gap)]
        return not self.edges.fails(edge, rest)

    def found_at(self, edge: Edge) -> tuple[Answer, ...]:
        """The answers on an edge; none where there are none that hold. Where it starts from rest and nothing pushes or another check is
        in doubt, none that is not confirmed, nor any beside one without a value, on which it may hang: μ = f/N where N = 0."""
        case = self.edges.case(edge)
        if case is None or unanswered_in(case):
            return ()
        assert case.found is not None
        doubtful = any(check.holds is None for check in case.found.checks)
        if doubtful and any(singular(answer, edge) for answer in case.found.answers):
            return ()
        own = (answer for answer in case.found.answers if self.name in ("", answer.name))
        return tuple(answer for answer in own if not doubtful or self.edges.confirmed(edge, answer.name))

    def agree(self, some: Sequence[Answer], others: Sequence[Answer], edge: Edge) -> bool:
        """Whether answers are the same on an edge."""
        if len(some) != len(others):
            return False
        return all(self.same_on(edge, one, other) for one, other in zip(some, others, strict=True))

    def same_on(self, edge: Edge, one: Answer, other: Answer) -> bool:
        """Whether two answers are: the same option, or the same number, with its direction if it has one, for as long."""
        if (one.word, one.until) != (other.word, other.until):
            return False
        if not self.agree(one.components, other.components, edge):
            return False
        forms = (one.closed or one.formula, other.closed or other.formula)
        if forms[0] is None or forms[1] is None:
            return forms[0] is forms[1]
        senses = [(answer.direction, answer.positive) for answer in (one, other)]
        if TIME in forms[0].symbols() | forms[1].symbols():
            return equal(edge.put(forms[0]), edge.put(forms[1])) and senses[0] == senses[1]
        numbers = [self.number(form, edge) for form in forms if form is not None]
        sizes = [number.float for number in numbers if number is not None]
        if len(sizes) < len(forms) or abs(sizes[0] - sizes[1]) > NEARLY * max(1.0, *map(abs, sizes)):
            return False
        return abs(sizes[0]) <= NEARLY or senses[0] == senses[1]

    def number(self, form: Formula, edge: Edge) -> Certified | None:
        """The number of a formula at the point of an edge; None where it has none."""
        values = {**self.edges.space.oracle.values, **numbers_of(edge.point), edge.letter: edge.limit}
        try:
            return evaluate(form, values)
        except (Undefined, ValueError, ZeroDivisionError):
            return None


def singular(answer: Answer, edge: Edge) -> bool:
    """Whether what is below a line of an answer vanishes on an edge."""
    return any(is_zero_or_undefined(edge.put(part)) for part in below_lines(answer))


def below_lines(answer: Answer) -> Iterator[Formula]:
    """What is below the lines of an answer and has letters."""
    return (part for form in forms_of(answer) for part in denominators(form) if part.symbols())


def is_zero_or_undefined(value: Formula) -> bool:
    """Whether what is below a line is zero, or has no value itself."""
    try:
        return is_zero(value)
    except ZeroDivisionError:
        return True


def forms_of(answer: Answer) -> Iterator[Formula]:
    """The formulas of an answer, of its components too."""
    form = answer.closed or answer.formula
    yield from () if form is None else (form,)
    for part in answer.components:
        yield from forms_of(part)


def unanswered_in(case: Solved) -> bool:
    """Whether there is no answer in a case that holds."""
    return case.found is None or case.objected


def answer_put(answer: Answer, edge: Edge, space: LetterSpace) -> Answer:
    """An answer as it is on an edge."""

    def put(form: Formula | None) -> Formula | None:
        return None if form is None else simplify(edge.put(form), order=space.order, positive=space.positive)

    parts = tuple(answer_put(part, edge, space) for part in answer.components)
    form = put(answer.closed or answer.formula)
    value = space.oracle.number(form) if form is not None and answer.value is None else answer.value
    return replace(answer, formula=form, closed=put(answer.closed), value=value, components=parts)
