"""Bodies on which no torque acts, followed by power series of Euler's equations and of Ṙ = R ω× in 50 digits, from the moments and the
start alone."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import ceil
from operator import mul

import mpmath

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import arb

UNIT = 10**60  # numbers are whole multiples of 10⁻⁶⁰
TERMS = 50  # of a power series
STEP = 4  # of it: so often the largest rate goes into one
Numbers = list[mpmath.mpf]


def fixed(value: str) -> int:
    return int(Fraction(value) * UNIT)


def carried(moments: Sequence[str], start: Sequence[str], time: str) -> tuple[Numbers, list[Numbers]]:
    """ω in body axes, and the rows that turn the body's axes into those of space, some time after they were the same."""
    inertia, omega = [Fraction(value) for value in moments], [fixed(value) for value in start]
    share = [(inertia[(i + 1) % 3] - inertia[(i + 2) % 3]) / inertia[i] for i in range(3)]
    rows = [[UNIT * (i == j) for j in range(3)] for i in range(3)]
    most = sum(map(abs, omega)) * max(1, *(abs(ceil(part)) for part in share)) // UNIT + 1
    count = ceil(Fraction(time) * most * STEP)
    step = fixed(time) // count
    for number in range(count):
        last = fixed(time) - step * (count - 1) if number == count - 1 else step
        omega, rows = series(share, omega, rows, last)
    with mpmath.workdps(70):
        return [mpmath.mpf(w) / UNIT for w in omega], [[mpmath.mpf(part) / UNIT for part in row] for row in rows]


def series(
    share: list[Fraction], omega: list[int], rows: list[list[int]], step: int
) -> tuple[list[int], list[list[int]]]:
    """One step: ω̇ᵢ = sᵢ ωⱼ ωₖ and Ṙ = R Ω with Ω v = ω × v, term by term, each times a power of the step."""
    w = [[value] for value in omega]
    r = [[[value] for value in row] for row in rows]

    def product(a: list[int], b: list[int]) -> int:
        return sum(map(mul, a, reversed(b))) // UNIT * step // UNIT

    for n in range(1, TERMS):
        new = [int(share[i] * product(w[(i + 1) % 3], w[(i + 2) % 3])) // n for i in range(3)]
        turned = [
            [
                (product(row[(j + 1) % 3], w[(j + 2) % 3]) - product(row[(j + 2) % 3], w[(j + 1) % 3])) // n
                for j in range(3)
            ]
            for row in r
        ]
        for i in range(3):
            w[i].append(new[i])
            for j in range(3):
                r[i][j].append(turned[i][j])
    return [sum(terms) for terms in w], [[sum(terms) for terms in row] for row in r]


def agree(found: Sequence[arb], true: Sequence[mpmath.mpf], digits: int = 24) -> None:
    """All digits that are certified are right, and so many are."""
    with Precision(300):
        for ball, number in zip(found, true, strict=True):
            gap = abs(ball - arb(mpmath.nstr(number, 60)))
            assert gap < arb(10) ** -digits * max(1, abs(float(number)))
