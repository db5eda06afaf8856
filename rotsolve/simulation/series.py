"""Series: the values of a tape as power series in time, order by order, over floats or over balls.

Each operation appends the next coefficient to its own list: z = x y has zₖ = Σ xⱼ yₖ₋ⱼ, and s = sin x has k sₖ = Σ j xⱼ cₖ₋ⱼ with
c = cos x. All that a coefficient costs is a few sums of products, which run in C."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from operator import mul

from msgspec import Struct

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import arb
from rotsolve.algebra.tape import ZERO, Exact, Operation
from rotsolve.simulation.tape import Scalar, SeriesTape

Series = list[Scalar]
Lists = Mapping[int, Series]  # by the places of their values on the tape
# what begins a series, and appends to it; None for a constant's
Made = tuple[Callable[[], None], Callable[[int], None] | None]
Functions = Mapping[str, Callable[..., Scalar]]
NAMES = ("sin", "cos", "exp", "log", "atan", "atan2", "asin", "acos", "abs")
OF_FLOAT: Functions = {name: getattr(math, name, abs) for name in NAMES}
OF_BALL: Functions = {name: getattr(arb, name, abs) for name in NAMES}
COARSE = 2.0**-51  # the relative error of what is rounded more coarsely on purpose
EXACTLY = 256  # bits that tell whether a constant is a float


class Arithmetic(Struct, frozen=True):
    """Numbers to calculate with: how constants enter, and what functions give."""

    number: Callable[[Exact], Scalar]
    functions: Functions


def nearest_float(number: Exact) -> float:
    """The float nearest to a constant."""
    return float(arb(number).mid())


def coarse(number: Exact) -> float:
    """A float some roundings beyond a constant that is none itself."""
    return beside(number, lambda close, beyond: beyond)


def mixed(number: Exact) -> float:
    """A float some roundings to one side of a constant that is none itself: to which, its digits decide as if by chance."""
    return beside(number, lambda close, beyond: close.as_integer_ratio()[0].bit_count() % 2 == 1)


def beside(number: Exact, upwards: Callable[[float, bool], bool]) -> float:
    """A float next to a constant, away from zero or towards it; told where the constant is: whether beyond the nearest float."""
    with Precision(EXACTLY):
        middle = arb(number).mid()
    close = float(middle)
    if middle == close:
        return close
    return close * (1 + COARSE if upwards(close, (middle > close) == (close > 0)) else 1 - COARSE)


FLOATS = Arithmetic(nearest_float, OF_FLOAT)
COARSE_FLOATS = Arithmetic(coarse, OF_FLOAT)
MIXED_FLOATS = Arithmetic(mixed, OF_FLOAT)
BALLS = Arithmetic(arb, OF_BALL)


class Expansion:
    """The operations that some values of a tape need, ready to be worked out at a moment and expanded from there."""

    __slots__ = ("lists", "order", "places", "starts", "steps", "tape", "varying")

    def __init__(self, tape: SeriesTape, wanted: Sequence[int], arithmetic: Arithmetic) -> None:
        self.tape = tape
        self.places = tape.needed(wanted)
        self.lists: dict[int, Series] = {place: [] for place in self.places}
        self.starts: list[Callable[[], None]] = []
        self.steps: list[Callable[[int], None]] = []
        solved: set[str] = set()
        for place in self.places:
            operation = tape.operations[place]
            if operation.kind in ("letter", "cos"):  # a cosine comes with its sine
                continue
            if operation.kind == "unknown":
                if operation.name not in solved:
                    solved.add(operation.name)
                    self._enter(solver_of(tape, operation.name, self.lists))
                continue
            self._enter(OPERATIONS[operation.kind](operation, place, self.lists, arithmetic))

    def _enter(self, made: Made) -> None:
        self.starts.append(made[0])
        if made[1] is not None:
            self.steps.append(made[1])

    def begin(self, letters: Mapping[int, Scalar]) -> None:
        """The values at a moment, from those of the letters."""
        for place, values in self.lists.items():
            values.clear()
            if place in letters:
                values.append(letters[place])
        for start in self.starts:
            start()

    def extend(self, order: int) -> None:
        """The coefficients of one more order; those of the letters have been appended."""
        for step in self.steps:
            step(order)


def number_series(operation: Operation, place: int, lists: Lists, arithmetic: Arithmetic) -> Made:
    value = arithmetic.number(operation.numbers[0])
    own = lists[place]
    return (lambda: own.append(value)), None


def sum_series(operation: Operation, place: int, lists: Lists, arithmetic: Arithmetic) -> Made:
    """c + Σ cᵢ xᵢ; the commonest forms by themselves."""
    own, first = lists[place], arithmetic.number(operation.numbers[0])
    factors = [arithmetic.number(number) for number in operation.numbers[1:]]
    sources = [lists[value] for value in operation.values]
    pairs = list(zip(factors, sources, strict=True))

    def start() -> None:
        total = first
        for factor, source in pairs:
            total = total + factor * source[0]
        own.append(total)

    append = own.append
    if len(pairs) == 1:
        ((factor, source),) = pairs
        return start, lambda order: append(factor * source[order])
    if len(pairs) == 2:
        (one, left), (two, right) = pairs
        return start, lambda order: append(one * left[order] + two * right[order])

    def step(order: int) -> None:
        append(sum([factor * source[order] for factor, source in pairs]))

    return start, step


def product_series(operation: Operation, place: int, lists: Lists, arithmetic: Arithmetic) -> Made:
    own, left, right = lists[place], lists[operation.values[0]], lists[operation.values[1]]

    def start() -> None:
        own.append(left[0] * right[0])

    append = own.append
    if left is not right:
        return start, lambda order: append(sum(map(mul, left, reversed(right))))

    def square(order: int) -> None:
        half = (order + 1) // 2
        total = 2 * sum(map(mul, left[:half], reversed(left)))
        append(total if order % 2 else total + left[half] * left[half])

    return start, square


def quotient_series(operation: Operation, place: int, lists: Lists, arithmetic: Arithmetic) -> Made:
    """z = x/y: zₖ = (xₖ − Σ yⱼ zₖ₋ⱼ, j from 1)/y₀."""
    own, above, below = lists[place], lists[operation.values[0]], lists[operation.values[1]]

    def step(order: int) -> None:
        top = above[order] if order < len(above) else 0  # nothing of a constant
        own.append((top - sum(map(mul, own, reversed(below)))) / below[0])

    return (lambda: own.append(above[0] / below[0])), step


def power_series(operation: Operation, place: int, lists: Lists, arithmetic: Arithmetic) -> Made:
    """z = x^c: k x₀ zₖ = Σ (c (k − j) − j) xₖ₋ⱼ zⱼ, j below k."""
    own, base, exponent = lists[place], lists[operation.values[0]], arithmetic.number(operation.numbers[0])

    def step(order: int) -> None:
        terms = [(exponent * (order - j) - j) * base[order - j] * own[j] for j in range(order)]
        own.append(sum(terms) / (order * base[0]))

    return (lambda: own.append(base[0] ** exponent)), step


def sine_series(operation: Operation, place: int, lists: Lists, arithmetic: Arithmetic) -> Made:
    """s = sin x and c = cos x, the next place, together: k sₖ = Σ j xⱼ cₖ₋ⱼ, k cₖ = −Σ j xⱼ sₖ₋ⱼ."""
    argument, sine, cosine = lists[operation.values[0]], lists[place], lists[place + 1]
    slopes: Series = []  # j xⱼ from j = 1
    steeper, rise, fall = slopes.append, sine.append, cosine.append

    def start() -> None:
        slopes.clear()
        sine.append(arithmetic.functions["sin"](argument[0]))
        cosine.append(arithmetic.functions["cos"](argument[0]))

    def step(order: int) -> None:
        steeper(order * argument[order])
        rising, falling = sum(map(mul, slopes, reversed(cosine))), sum(map(mul, slopes, reversed(sine)))
        rise(rising / order)
        fall(-falling / order)

    return start, step


def chained_series(operation: Operation, place: int, lists: Lists, arithmetic: Arithmetic) -> Made:
    """z with dz = g dx, g the second value (of exp x itself): k zₖ = Σ j xⱼ gₖ₋ⱼ."""
    function = arithmetic.functions[operation.kind]
    own, argument = lists[place], lists[operation.values[0]]
    rate = own if operation.kind == "exp" else lists[operation.values[1]]
    slopes: Series = []

    def start() -> None:
        slopes.clear()
        own.append(function(argument[0]))

    def step(order: int) -> None:
        slopes.append(order * argument[order])
        own.append(sum(map(mul, slopes, rate[order - 1 :: -1])) / order)

    return start, step


def angle_series(operation: Operation, place: int, lists: Lists, arithmetic: Arithmetic) -> Made:
    """z = atan2(y, x): k r₀ zₖ = Σ j (yⱼ xₖ₋ⱼ − xⱼ yₖ₋ⱼ) − Σ j zⱼ rₖ₋ⱼ, j below k in the last, with r = x² + y²."""
    own = lists[place]
    y, x, r = (lists[value] for value in operation.values)

    def step(order: int) -> None:
        gained = sum(j * (y[j] * x[order - j] - x[j] * y[order - j]) for j in range(1, order + 1))
        total = gained - sum(j * own[j] * r[order - j] for j in range(1, order))
        own.append(total / (order * r[0]))

    return (lambda: own.append(arithmetic.functions["atan2"](y[0], x[0]))), step


def size_series(operation: Operation, place: int, lists: Lists, arithmetic: Arithmetic) -> Made:
    """|x| as long as x keeps its sign; where it begins at zero, that which it comes to."""
    own, argument = lists[place], lists[operation.values[0]]

    def step(order: int) -> None:
        first = next((term for term in argument if term != 0), 0)
        own.append(argument[order] if first > 0 else -argument[order])

    def start() -> None:
        own.append(abs(argument[0]))

    return start, step


OPERATIONS: Mapping[str, Callable[..., Made]] = {
    "number": number_series,
    "sum": sum_series,
    "times": product_series,
    "over": quotient_series,
    "power": power_series,
    "sin": sine_series,
    **dict.fromkeys(("exp", "log", "atan", "asin", "acos"), chained_series),
    "atan2": angle_series,
    "abs": size_series,
}


def rough_value(tape: SeriesTape, place: int, letters: Mapping[str, Exact]) -> float:
    """About how large a value is where the letters have these values."""
    expansion = Expansion(tape, [place], FLOATS)
    found = [(where, tape.operations[where]) for where in expansion.places]
    starts = {where: letters.get(item.name, ZERO) for where, item in found if item.kind == "letter"}
    expansion.begin({where: nearest_float(start) for where, start in starts.items()})
    return float(expansion.lists[place][0])


def solver_of(tape: SeriesTape, name: str, lists: Lists) -> Made:
    """Linear equations A x = b: A₀ xₖ = bₖ − Σ Aⱼ xₖ₋ⱼ, j from 1, with A₀ factored once; what is constant in A drops out of the sum."""
    block = tape.blocks[int(name)]
    owns = [lists[place] for place in tape.unknowns_of(name)]
    rows = [[lists[value] for value in row] for row in block.rows]
    right = [lists[value] for value in block.right]
    moving = [tape.constant(value) is None for value in block.right]
    changing = [
        [(own, lists[value]) for own, value in zip(owns, row, strict=True) if tape.constant(value) is None]
        for row in block.rows
    ]
    lines = list(zip(right, moving, changing, strict=True))
    ends = [own.append for own in owns]
    solve: Callable[[list[Scalar]], Sequence[Scalar]] = list

    def start() -> None:
        nonlocal solve
        solve = factored([[series[0] for series in row] for row in rows])
        for append, value in zip(ends, solve([series[0] for series in right]), strict=True):
            append(value)

    def step(order: int) -> None:
        rest = []
        for series, moves, pairs in lines:
            total = series[order] if moves else 0
            for own, coefficient in pairs:
                total -= sum(map(mul, own, reversed(coefficient)))
            rest.append(total)
        for append, value in zip(ends, solve(rest)):  # noqa: B905
            append(value)

    return start, step


def factored(table: list[list[Scalar]]) -> Callable[[list[Scalar]], Sequence[Scalar]]:
    """What solves A x = b for this A: by elimination with the largest pivot of each column."""
    size = len(table)
    order = list(range(size))
    for k in range(size):
        best = max(range(k, size), key=lambda i: abs(float(table[i][k])))
        table[k], table[best] = table[best], table[k]
        order[k], order[best] = order[best], order[k]
        for i in range(k + 1, size):
            table[i][k] = table[i][k] / table[k][k]
            for j in range(k + 1, size):
                table[i][j] = table[i][j] - table[i][k] * table[k][j]

    if size == 2:
        return solver_of_two(table, order[0] == 1)

    def solve(right: list[Scalar]) -> list[Scalar]:
        found = [right[i] for i in order]
        for i in range(size):
            for j in range(i):
                found[i] = found[i] - table[i][j] * found[j]
        for i in reversed(range(size)):
            for j in range(i + 1, size):
                found[i] = found[i] - table[i][j] * found[j]
            found[i] = found[i] / table[i][i]
        return found

    return solve


def solver_of_two(table: list[list[Scalar]], turned: bool) -> Callable[[list[Scalar]], Sequence[Scalar]]:
    """The same for two unknowns, the commonest case, written out; `turned` where the rows have been exchanged."""
    (a, b), (factor, d) = table

    def solve(right: list[Scalar]) -> Sequence[Scalar]:
        first, second = (right[1], right[0]) if turned else right
        y = (second - factor * first) / d
        return (first - b * y) / a, y

    return solve
