"""Sharing: of reactions that the equations leave open, as those of several contacts that stick, how far they may be from their limits.

What holds with more than it takes holds as long as it can share that out in one way or another: the limits are linear in what is open.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from msgspec import Struct

from rotsolve.confirm.linear import solved

Key = tuple[str, str]
Line = tuple[float, Mapping[int, float]]  # a constant, and the factors of reactions: what must not be negative
SMALL = 1e-12


class Shared(Struct, frozen=True):
    """How far a limit is from being reached where all is shared out as well as it may be, and the limits that are reached with it."""

    room: float
    together: frozenset[Key]


class LimitSum(Struct, frozen=True):
    """constant + Σ factors · ways − weight · room ≥ 0, a sum of some limits."""

    constant: float
    factors: tuple[float, ...]
    weight: float
    of: frozenset[Key]


def rooms(
    lines: Mapping[Key, Line], values: Sequence[float], laws: Sequence[Mapping[int, float]], open_: Collection[int]
) -> dict[Key, Shared]:
    """By limit: the most room that it may have together with those that stand against it."""
    ways = free_ways(laws, open_)
    bounds = []
    for key, (constant, parts) in lines.items():
        own = constant + sum([part * values[index] for index, part in parts.items()])
        factors = tuple(sum([part * way[index] for index, part in parts.items()]) for way in ways)
        bounds.append(LimitSum(own, factors, 1.0, frozenset({key})))
    size = max([abs(value) for value in values], default=0.0) + 1.0
    for number in range(len(ways)):
        bounds = without_way(bounds, number)
    found: dict[Key, Shared] = {}
    for key in lines:
        least = min(
            (bound for bound in bounds if key in bound.of),
            key=lambda bound: bound.constant / bound.weight,
            default=None,
        )
        found[key] = (
            Shared(size, frozenset({key})) if least is None else Shared(least.constant / least.weight, least.of)
        )
    return found


def free_ways(laws: Sequence[Mapping[int, float]], open_: Collection[int]) -> list[list[float]]:
    """Changes of the unknowns that change nothing in the laws, one for each reaction that may be chosen freely."""
    size = max((index for law in laws for index in law), default=-1) + 1
    size = max(size, max(open_, default=-1) + 1)
    ways: list[list[float]] = []
    chosen: list[dict[int, float]] = []
    for index in sorted(open_):
        lefts = [*(dict(law) for law in laws), *chosen, {index: 1.0}]
        answer = solved(lefts, [0.0] * (len(lefts) - 1) + [1.0], size)
        if answer.clash < 1e-9:
            ways.append(answer.values)
            chosen.append({index: 1.0})
    return ways


def without_way(bounds: Sequence[LimitSum], number: int) -> list[LimitSum]:
    """What follows for all choices of one way (Fourier and Motzkin): each bound that it helps with each that it harms."""
    signs = [0 if abs(bound.factors[number]) <= SMALL else 1 if bound.factors[number] > 0 else -1 for bound in bounds]
    found = [bound for bound, sign in zip(bounds, signs, strict=True) if not sign]
    helped = [bound for bound, sign in zip(bounds, signs, strict=True) if sign > 0]
    harmed = [bound for bound, sign in zip(bounds, signs, strict=True) if sign < 0]
    for one in helped:
        for other in harmed:
            a, b = -other.factors[number], one.factors[number]
            factors = tuple(a * x + b * y for x, y in zip(one.factors, other.factors, strict=True))
            weight = a * one.weight + b * other.weight
            found.append(LimitSum(a * one.constant + b * other.constant, factors, weight, one.of | other.of))
    return found
