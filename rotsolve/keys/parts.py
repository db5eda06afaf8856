"""Parts: what a problem asks, (a), (b), …, in the order of its sheet, with the points of each."""

from __future__ import annotations

from fractions import Fraction
from string import ascii_lowercase

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.language.marks import Deduction, Marking, marking_of
from rotsolve.language.problem import Problem


class SheetPart(Struct, frozen=True):
    """One answer of a problem: its label on the sheet, `a`; its name under `find`; and its points, exactly."""

    label: str
    name: str
    points: Fraction


def parts_of(problem: Problem) -> tuple[SheetPart, ...]:
    """The parts of a problem, with the points of its marking."""
    markings = scaled_marking(problem)
    return tuple(SheetPart(part_label(place), one.name, one.points) for place, one in enumerate(markings))


def scaled_marking(problem: Problem, points: Fraction | None = None) -> tuple[Marking, ...]:
    """How each answer is marked, in the order of the parts: as `ask` lists them where it words all, else as under `find`.

    Points are scaled to their wanted sum, and what flaws cost in marks with them; they are alike where all of them are nothing.
    """
    asked = dict.fromkeys(find.group for find in problem.finds)
    worded = [wording.name for wording in problem.ask]
    names = worded if asked.keys() == set(worded) else asked
    own = [marking_of(problem.marking, name) for name in names]
    whole = sum((one.points for one in own), Fraction(0))
    if points is None or points == whole:
        return tuple(own)
    if not whole:
        return tuple(replace(one, points=points / len(own)) for one in own)
    return tuple(marking_times(one, points / whole) for one in own)


def marking_times(marking: Marking, factor: Fraction) -> Marking:
    """The marking with so many times its points."""
    costs = tuple((flaw, cost if cost.share else Deduction(cost.amount * factor)) for flaw, cost in marking.deduct)
    return replace(marking, points=marking.points * factor, deduct=costs)


def part_label(place: int) -> str:
    """a, b, …, z, aa, ab, … for 0, 1, …"""
    before, letter = divmod(place, len(ascii_lowercase))
    return (part_label(before - 1) if before else "") + ascii_lowercase[letter]


def exact_points(points: Fraction) -> str:
    """Points as a sheet prints them, exactly: 3, 2.5, 8/3."""
    return f"{float(points):g}" if (points * 100).denominator == 1 and points < 10_000 else str(points)
