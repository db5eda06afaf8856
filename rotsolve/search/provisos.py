"""Provisos of a case as few as say the same: what follows from others is left out, and neighbouring regions become one.

Nothing is left out because no other case is known there: what holds under a condition holds only there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations

from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import degree, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import NONE
from rotsolve.core.derivation import Equality
from rotsolve.core.letters import Given
from rotsolve.motion.positive import is_angle
from rotsolve.search.lettersigns import Proviso, denominators
from rotsolve.search.letterspace import LetterSpace

LONG = 200  # nodes of conditions from which on nothing is proved of them
MIDDLING = 50  # from which on it is not looked at by the letters of another one
SHORT = 16  # nodes of conditions up to which two together are tried
SOLVED = 120  # nodes of a condition from which on it is not solved for a letter

Region = tuple[Proviso, ...]  # all of these hold


def needed(region: Region, space: LetterSpace) -> Region:
    """The conditions of a region without those that follow from the others, the longest first."""
    kept = list(each_once(region, ()))
    for one in sorted(kept, key=lambda item: -length(item.gap)):
        rest = [other for other in kept if other is not one]
        kept = rest if follows(one, rest, space) else kept
    return tuple(kept)


def limits_told(space: LetterSpace) -> tuple[str, ...]:
    """What the scene asks of its letters, in words, without what follows from the rest of it: "R > r"."""
    bare = LetterSpace(space.problem, space.oracle, space.order)  # which takes nothing for granted
    point = space.first_point()
    parts = [replace(part, strict=one.strict) for one in space.limited for part in bare.factors(one.gap, 1, point)]
    return tuple(dict.fromkeys(condition_line(shown(one, bare)) for one in needed(tuple(parts), bare)))


def each_once(provisos: Sequence[Proviso], more: Sequence[Proviso]) -> Region:
    """Conditions, each once."""
    kept: list[Proviso] = []
    for one in (*provisos, *more):
        kept += [] if any(map(one.same, kept)) else [one]
    return tuple(kept)


def follows(one: Proviso, others: Sequence[Proviso], space: LetterSpace) -> bool:
    """Whether a condition holds wherever one of the others does, or two of them do: gap ≥ k gap' + k' gap" for a k and k' > 0, whatever the
    letters are."""
    if refuted(one, others, space):
        return False
    return any(follows_from(one, other, space) for other in others) or follows_from_two(one, others, space)


def refuted(one: Proviso, others: Sequence[Proviso], space: LetterSpace) -> bool:
    """Whether a condition is seen to fail at a point at which all others hold."""
    return any(
        glance.sign(one.gap) == -1 and all(glance.sign(other.gap) == 1 for other in others) for glance in space.glances
    )


def follows_from_two(one: Proviso, others: Sequence[Proviso], space: LetterSpace) -> bool:
    """Whether a condition holds wherever two others do: what is left of it without the first follows from the second."""
    for first, second in permutations(others, 2) if length(one.gap) < SHORT else ():
        for ratio in ratios(one.gap, first.gap, space) if length(first.gap) < SHORT else ():
            left = simplify(one.gap - ratio * first.gap, positive=space.positive)
            if length(left) < SHORT and follows_from(Proviso(left, one.strict and not first.strict), second, space):
                return True
    return False


def follows_from(one: Proviso, other: Proviso, space: LetterSpace) -> bool:
    """Whether one condition holds wherever another does, worked out once."""
    if (one, other) not in space.implied:
        space.implied[one, other] = not refuted(one, (other,), space) and implied(one, other, space)
    return space.implied[one, other]


def implied(one: Proviso, other: Proviso, space: LetterSpace) -> bool:
    if one.same(other) or (not one.strict and one.gap == other.gap):
        return True
    if length(one.gap) + length(other.gap) > LONG:
        return False
    for ratio in ratios(one.gap, other.gap, space):
        left = space.sure(simplify(one.gap - ratio * other.gap, positive=space.positive))
        if left == 1 or (left == 0 and (other.strict or not one.strict)):
            return True
    if length(one.gap) + length(other.gap) > MIDDLING:
        return False
    return 1 in space.signs_where(one.gap, other, edges=one.strict and not other.strict)


def ratios(gap: Formula, other: Formula, space: LetterSpace) -> Iterator[Formula]:
    """Positive factors k for which gap − k gap' may have a sure sign: 1, and those with which a letter falls out."""
    yield ONE
    for name in sorted(gap.symbols() & other.symbols() & space.letters.keys()):
        if degree(gap, name) == 1 == degree(other, name):
            slopes = [simplify(differentiate(value, name)) for value in (gap, other)]
            signs = [space.sure(slope) for slope in slopes]
            if signs[0] and signs[0] == signs[1] and slopes[0] != slopes[1]:
                yield simplify(slopes[0] / slopes[1], positive=space.positive)


def united(regions: Sequence[Region], space: LetterSpace) -> list[Region]:
    """Regions that together are the same, in as few as are found: two that touch where a condition turns round become one."""
    found = [needed(region, space) for region in regions]
    while (pair := next(joinable(found, space), None)) is not None:
        first, second, joined = pair
        found[first] = joined
        del found[second]
    return found


def joinable(regions: Sequence[Region], space: LetterSpace) -> Iterator[tuple[int, int, Region]]:
    """Two regions, by their places, and the one that they are together."""
    for second in range(1, len(regions)):
        for first in range(second):
            joined = together(regions[first], regions[second], space)
            if joined is not None:
                yield first, second, joined


def together(one: Region, other: Region, space: LetterSpace) -> Region | None:
    """The region that two make up; None where that is not the region of some conditions, or not known to be."""
    for small, large in ((one, other), (other, one)):
        if all(follows(proviso, small, space) for proviso in large):
            return large
    for proviso in one:
        for against in other:
            if not proviso.opposes(against):
                continue
            own = else_asked(proviso, one, space)
            rest = else_asked(against, other, space)
            covered = all(follows(item, (*own, proviso), space) for item in rest)
            if covered and all(follows(item, (*rest, against), space) for item in own):
                return each_once(own, rest)
    return None


def else_asked(proviso: Proviso, region: Region, space: LetterSpace) -> Region:
    """What else a region asks for than a condition and what follows from it."""
    return tuple(item for item in region if item is not proviso and not follows_from(item, proviso, space))


def shown(proviso: Proviso, space: LetterSpace) -> Equality:
    """A condition as a page tells it: solved for a letter where that goes, with none below a line, a coefficient before others."""
    more, less = (">", "<") if proviso.strict else ("≥", "≤")
    told: list[tuple[bool, int, int, str, Equality]] = []
    for name in sorted(proviso.gap.symbols() & space.letters.keys()) if length(proviso.gap) < SOLVED else ():
        if degree(proviso.gap, name) != 1:
            continue
        limit = solve_linear(proviso.gap, name, order=space.order, positive=space.positive)
        slope = space.sure(simplify(differentiate(proviso.gap, name)))
        if limit is not None and slope and space.sure(limit) == 1:
            line = Equality(Symbol(name), limit, more if slope > 0 else less)
            told.append((divides(limit), letter_rank(space.letters[name]), length(limit), name, line))
    return min(told)[-1] if told else Equality(proviso.gap, ZERO, more)


def condition_line(line: Equality) -> str:
    """A condition in a line of text."""
    return f"{to_text(line.left)} {line.relation} {to_text(line.right)}"


def divides(value: Formula) -> bool:
    """Whether a letter stands below a line."""
    return any(below.symbols() for below in denominators(value))


def letter_rank(given: Given) -> int:
    """Coefficients first, angles last."""
    return 0 if given.dimension == NONE else 2 if is_angle(given) else 1
