"""Together: many equations that are linear in their unknowns, solved at once with the numbers of the scene, as certified balls.

A closed form grows with every body that is linked to others; the elimination of numbers grows like the links. A letter that one equation
tells alone (a moment of inertia) comes first, then the linear block, A x = b, then what is made of its unknowns (the size of a force).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction
from functools import partial, reduce
from operator import mul

from msgspec import Struct

from rotsolve.algebra.certified.ball import BITS_PER_DIGIT, Certified, Precision, decided_by_size
from rotsolve.algebra.certified.balls import Ball, RealBalls
from rotsolve.algebra.exact.linear import NotLinear
from rotsolve.algebra.flints import arb, fmpq
from rotsolve.algebra.formula import ONE, ZERO, Formula, Negative, Product, Quotient, Sum, Symbol, add, negate, total
from rotsolve.core.equation import Equation
from rotsolve.solver.steps import Contradiction, NoClosedForm, Redundant

GUARD = 64  # bits beyond those asked for
MOST_BITS = 8000
TOLD = 2000  # bits at which a number that can not be told from another one is taken for it
PIVOT = 0.01  # share of the greatest coefficient of its equation that a pivot has at least

Parts = tuple[dict[str, Formula], Formula]  # coefficients of the unknowns, and the rest


class Stage(Struct, frozen=True):
    """Equations that tell as many unknowns; one that stands alone on a side, or a linear system."""

    indices: tuple[int, ...]
    names: tuple[str, ...]
    value: Formula | None = None
    rows: tuple[Parts, ...] = ()


def linear_parts(f: Formula, names: Collection[str]) -> Parts:
    """f as Σ coefficient · unknown + rest, as it is written; NotLinear where it is not."""
    if f.symbols().isdisjoint(names):
        return {}, f
    match f:
        case Symbol(name):
            return {name: ONE}, ZERO
        case Negative(operand):
            parts, rest = linear_parts(operand, names)
            return {name: negate(part) for name, part in parts.items()}, negate(rest)
        case Sum(terms):
            found, rests = dict[str, Formula](), list[Formula]()
            for term in terms:
                parts, rest = linear_parts(term, names)
                rests.append(rest)
                for name, part in parts.items():
                    found[name] = add(found[name], part) if name in found else part
            return found, total(rests)
        case Quotient(numerator, denominator) if denominator.symbols().isdisjoint(names):
            parts, rest = linear_parts(numerator, names)
            return {name: part / denominator for name, part in parts.items()}, rest / denominator
        case Product(factors):
            held = [factor for factor in factors if not factor.symbols().isdisjoint(names)]
            if len(held) == 1:
                parts, rest = linear_parts(held[0], names)
                scale = reduce(mul, (factor for factor in factors if factor is not held[0]), ONE)
                return {name: scale * part for name, part in parts.items()}, scale * rest
    raise NotLinear("an unknown is within a product, a power or a function")


def staged(equations: Mapping[int, Equation], unknowns: Collection[str]) -> list[Stage]:
    """The order in which equations tell their unknowns; NoClosedForm where they can not so."""
    pending, open_, stages = dict(equations), set(unknowns), list[Stage]()
    while pending:
        stage = single(pending, open_) or block(pending, open_)
        if stage is None:
            raise NoClosedForm("the equations are too long to print in letters, and not linear in their unknowns")
        stages.append(stage)
        open_ -= set(stage.names)
        for index in stage.indices:
            del pending[index]
    return stages


def single(pending: Mapping[int, Equation], open_: Collection[str]) -> Stage | None:
    """An equation with one unknown that stands alone on a side."""
    for index, law in pending.items():
        names = law.symbols() & set(open_)
        for letter, value in ((law.left, law.right), (law.right, law.left)) if len(names) == 1 else ():
            if isinstance(letter, Symbol) and letter.name in names and letter.name not in value.symbols():
                return Stage((index,), (letter.name,), value)
    return None


def block(pending: Mapping[int, Equation], open_: Collection[str]) -> Stage | None:
    """All equations that are linear in what is open, where they are as many as their unknowns; of one unknown one alone."""
    rows: dict[int, Parts] = {}
    for index, law in pending.items():
        try:
            rows[index] = linear_parts(law.left - law.right, open_)
        except NotLinear:
            continue
        if len(rows[index][0]) == 1:
            return Stage((index,), tuple(rows[index][0]), None, (rows[index],))
    names = {name for parts, _ in rows.values() for name in parts}
    return Stage(tuple(rows), tuple(sorted(names)), None, tuple(rows.values())) if len(names) == len(rows) > 0 else None


class Together:
    """The unknowns of a plan as numbers, at any precision; `known` are the letters found before."""

    def __init__(self, stages: Sequence[Stage], values: Mapping[str, Formula], known: Mapping[str, Certified]) -> None:
        self.stages, self.values, self.known = stages, values, known
        self.found: dict[int, dict[str, Ball]] = {}

    def numbers(self) -> dict[str, Certified]:
        """All unknowns, each with the means to know it better."""
        decided_by_size()
        return {name: self._certified(name) for name in self.at(128)}

    def at(self, bits: int) -> dict[str, Ball]:
        """All unknowns at a working precision."""
        if bits not in self.found:
            with Precision(bits):
                bound = {name: number.refine(int(bits / BITS_PER_DIGIT)) for name, number in self.known.items()}
                balls, found = RealBalls(self.values, bound=bound), dict[str, Ball]()
                for stage in self.stages:
                    told = {stage.names[0]: balls(stage.value)} if stage.value is not None else solved(stage, balls)
                    balls.memo.update(told)
                    found |= told
            self.found[bits] = found
        return self.found[bits]

    def _certified(self, name: str) -> Certified:
        return Certified(self._refined(name, 15), partial(self._refined, name), partial(self._equals, name))

    def _refined(self, name: str, digits: int) -> Ball:
        """The number to so many digits."""
        needed = int(digits * BITS_PER_DIGIT) + 4
        bits = 1 << (needed + GUARD - 1).bit_length()
        while True:
            ball = self.at(bits)[name]
            if ball.rel_accuracy_bits() >= needed or bits > MOST_BITS:
                return ball
            if ball.contains(0) and self._equals(name, Fraction(0)):
                return arb(0)
            bits *= 2

    def _equals(self, name: str, value: Fraction) -> bool:
        """Whether it is a number: some hundred digits do not tell it from that."""
        ball = self.at(TOLD)[name]
        return bool(ball.contains(fmpq(value.numerator, value.denominator)) and ball.rad() < arb(2) ** (-TOLD // 2))


def solved(stage: Stage, balls: RealBalls) -> dict[str, Ball]:
    """A x = b by elimination, the sparsest pivot first that is not small in its equation."""
    rows = [{name: balls(part) for name, part in parts.items()} for parts, _ in stage.rows]
    rests = [-balls(rest) for _, rest in stage.rows]
    order, left = list[tuple[int, str]](), set(range(len(rows)))
    while left:
        k, name = pivot(rows, left, stage, rests)
        left.discard(k)
        order.append((k, name))
        for other in left:
            if name in rows[other]:
                factor = rows[other].pop(name) / rows[k][name]
                for column, entry in rows[k].items():
                    if column != name:
                        rows[other][column] = rows[other].get(column, arb(0)) - factor * entry
                rests[other] = rests[other] - factor * rests[k]
    found: dict[str, Ball] = {}
    for k, name in reversed(order):
        rest = sum((-entry * found[column] for column, entry in rows[k].items() if column != name), rests[k])
        found[name] = rest / rows[k][name]
    return found


def pivot(
    rows: Sequence[Mapping[str, Ball]], left: Collection[int], stage: Stage, rests: Sequence[Ball]
) -> tuple[int, str]:
    """The equation and unknown to eliminate next: few entries to clear. An equation that has none left says nothing, or something false."""
    held: dict[str, int] = {}
    for k in left:
        for name in rows[k]:
            held[name] = held.get(name, 0) + 1
    best: tuple[int, int, str] | None = None
    for k in sorted(left):
        entries = {name: abs(entry) for name, entry in rows[k].items() if not entry.contains(0)}
        if not entries:
            index = stage.indices[k]
            raise Redundant(index) if rests[k].contains(0) else Contradiction(index)
        least = PIVOT * max(float(entry.mid()) for entry in entries.values())
        for name, entry in entries.items():
            cost = (held[name] - 1) * (len(rows[k]) - 1)
            if float(entry.mid()) >= least and (best is None or cost < best[0]):
                best = (cost, k, name)
    assert best is not None
    return best[1], best[2]


def lacking(stages: Sequence[Stage], told: Collection[str]) -> list[str]:
    """Letters in the equations that have no number."""
    formulas = [stage.value for stage in stages if stage.value is not None]
    formulas += [part for stage in stages for parts, rest in stage.rows for part in (*parts.values(), rest)]
    own = {name for stage in stages for name in stage.names}
    return sorted({name for f in formulas for name in f.symbols()} - own - set(told))
