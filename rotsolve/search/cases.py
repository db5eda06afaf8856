"""Cases: letters without numbers, case by case. Each case is solved at numbers of its own, and holds where every sign is as it was there.

What is sure wherever the letters may be is no condition. Another case is looked for where a condition of one that is known fails.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Generic, TypeVar, cast

from msgspec import Struct

from rotsolve.algebra.certified.ball import witnessed
from rotsolve.algebra.effort import Exhausted
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import Call, Formula, Integral
from rotsolve.core.derivation import Words
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.search.answers import unsolvable
from rotsolve.search.lettersigns import Proviso
from rotsolve.search.letterspace import Glance, LetterSpace, Point, numbers_of, unlike

MOST = 12  # cases that are solved
AN_INTEGRAL = 20_000  # nodes that take as long to look at
LOOKED_AT = 500_000  # nodes of conditions that are looked at for one more case
Found = TypeVar("Found")
Solving = Callable[[Mapping[str, Formula]], tuple[Found, bool]]


class Needed(Struct, frozen=True):
    """What the answers of a case need to hold beside its conditions, and what is said where it fails."""

    proviso: Proviso
    failing: Words


class Case(Struct, Generic[Found], frozen=True):
    """What is found at a point, where it holds, and what it needs there; without an answer, the fault that says why."""

    point: Point
    conditions: tuple[Proviso, ...]
    needs: tuple[Needed, ...] = ()
    found: Found | None = None
    fault: Exception | None = None
    objected: bool = False  # whether its own checks object to it: one of its needs fails

    @property
    def provisos(self) -> tuple[Proviso, ...]:
        """All that holds in it."""
        return self.conditions + tuple(need.proviso for need in self.needs)

    @property
    def bars(self) -> tuple[Proviso, ...]:
        """What keeps its region from others: where a need fails, that too."""
        return self.provisos if self.objected else self.conditions


def cases_of(space: LetterSpace, solve: Solving[Found]) -> tuple[list[Case[Found]], bool]:
    """All cases that are found, the first at a point of no special kind, and whether there are more of them than are solved, none where
    the first takes too long.

    `solve` says what is found where letters are tried to be so, and whether it objects.
    """
    cases: list[Case[Found]] = []
    edges: list[Point] = []
    point: Point | None = space.first_point()
    sure = True
    while point is not None and len(cases) < MOST:
        try:
            cases.append(case_at(point, space, solve))
        except Exhausted:
            return cases, True
        edges += (place for one in cases[-1].bars for place in space.across(point, one.gap))
        point, sure = beyond(cases, edges, space)
    return cases, point is not None or not sure


def case_at(point: Point, space: LetterSpace, solve: Solving[Found], put: Mapping[str, Formula] = {}) -> Case[Found]:
    """What is found at a point, and the conditions for that; with letters that are `put` in by others."""
    found, objected, fault = None, False, None
    with witnessed() as witness:
        try:
            found, objected = solve({**numbers_of(point), **put})
        except (Unsolvable, SceneError) as error:
            fault = error
    try:
        supposed = {with_put(value, put, space): sign for value, sign in witness.supposed.items()}
        needed = {with_put(value, put, space): told for value, told in witness.needed.items()}
        told = [*space.provisos(supposed, point), *signs_of_parts(needed, space, point)]
        conditions = tuple(one for one in unlike(told) if space.fails_somewhere(one, point))
        needs = tuple(needs_noted(needed, conditions, space, point))
    except ZeroDivisionError:  # with these letters put in, what was supposed has no value: nothing is known there
        return Case(point, (), fault=unsolvable(space.problem, "what it hangs on has no value there", None))
    except Unsolvable as error:  # too long to print: on an edge nothing is known then
        if not put:
            raise
        return Case(point, (), fault=error)
    return Case(point, conditions, needs, found, fault, objected)


def with_put(value: Formula, put: Mapping[str, Formula], space: LetterSpace) -> Formula:
    """A formula with letters put in; its roots then written anew: √(4 m² u²) is 2 m u, without which no fraction with it can be reduced."""
    if not put:
        return value
    roots = partial(simplify, positive=space.positive)
    return value.substitute(put).transform(lambda node: roots(node) if isinstance(node, Call) else node, "sqrt")


def signs_of_parts(needed: Mapping[Formula, tuple[int, object]], space: LetterSpace, point: Point) -> Iterator[Proviso]:
    """The signs of the parts of what is needed where it has several: two that are both negative make it positive as well, in a case of its
    own."""
    for value, (sign, _) in needed.items():
        for whole in space.both_ways(value, sign):
            parts = tuple(space.factors(whole, sign, point))
            yield from parts if len(parts) > 1 else ()


def needs_noted(
    needed: Mapping[Formula, tuple[int, object]], known: Sequence[Proviso], space: LetterSpace, point: Point
) -> Iterator[Needed]:
    """What the answers need beside conditions that are known."""
    for value, (sign, failing) in needed.items():
        wholes = space.both_ways(value, sign)  # |f| ≤ μ N of a friction of either sign
        for one in (one for whole in wholes for one in space.factors(whole, sign, point)):
            if not any(is_zero(one.gap - other.gap) for other in known):
                yield Needed(one, cast("Words", failing))


def beyond(cases: Sequence[Case[Found]], edges: Sequence[Point], space: LetterSpace) -> tuple[Point | None, bool]:
    """A point at which none of the cases holds, None where none is found; and whether that is sure enough for conditions of their size."""
    gaps = [one.gap for case in cases for one in case.bars]
    size = sum(length(gap) + AN_INTEGRAL * sum(1 for _ in gap.walk(Integral)) for gap in gaps)
    if not size:
        return None, True
    for points, place in enumerate(places(cases, edges, space)):
        if points * size > LOOKED_AT:
            return None, False
        glance = Glance(space, place)
        if space.has(place) and all(glance.fails(case.bars) for case in cases):
            return place, True
    return None, True


def places(cases: Sequence[Case[Found]], edges: Sequence[Point], space: LetterSpace) -> Iterator[Point]:
    """Points at which another case may be: right across the edges of those known, with one letter larger or smaller, then by chance."""
    yield from edges
    for case in cases:
        names = {name for one in case.bars for name in one.gap.symbols() & space.letters.keys()}
        yield from space.around(case.point, sorted(names))
    yield from space.elsewhere(cases[0].point)
