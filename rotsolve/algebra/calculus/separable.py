"""Separable: the definite integrals that separation of variables leads to: ∫ (p + q x)/(a + b x + c x²) dx and ∫ dx/√(a + b x + c x²).

The real branch is chosen by the sign of the discriminant, so that every root and logarithm is real; a denominator that vanishes on the
way means that the end is approached for ever, or not reached at all.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from fractions import Fraction
from math import prod

from msgspec import Struct

from rotsolve.algebra.calculus.integral import integrate, integrate_by_hand
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import Fractions, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import (
    ONE,
    PI,
    ZERO,
    Call,
    Formula,
    Integral,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    add,
    call,
    negate,
    sqrt,
)

TWO, FOUR, HALF = Number(Fraction(2)), Number(Fraction(4)), Number(Fraction(1, 2))
SignOf = Callable[[Formula], "int | None"]


class Unending(ValueError):
    """The integral has no finite value: what it counts grows without end as the end is approached."""


class Stretch(Struct, frozen=True):
    """An integral d(name) from one end to another; `sign` tells the sign of a formula without the variable, where it is known."""

    name: str
    lower: Formula
    upper: Formula
    sign: SignOf
    order: Sequence[str] = ()
    positive: Collection[str] = ()

    def integral(self, f: Formula) -> Formula | None:
        """The integral of f in closed form; None where it is of another kind. Raises Unending where it has no finite value."""
        if self.lower == self.upper:
            return ZERO
        parts = self._fraction(f)
        if parts is not None:
            return self._quotient(*parts)
        halves = self._half_powers(f)
        if halves is not None:
            return halves
        square = self._fraction(self._tidy(f * f))
        if square is None or len(square[0]) != 1 or len(square[1]) > 3:
            return self._powers_beside_root(f)
        found = self._root([self._tidy(part / square[0][0]) for part in square[1]])
        return negate(found) if found is not None and self._negative(f) else found

    def _half_powers(self, f: Formula) -> Formula | None:
        """∫ p(x)/√x dx for a polynomial p, power by power: ∫ x^(n − ½) dx = x^n √x/(n + ½)."""
        problem = Fractions([self._tidy(f * sqrt(Symbol(self.name)))], self.order, self.positive, extra=(self.name,))
        ring = problem.field
        top, bottom = ring.cancel(problem.ratio())
        if any((top * bottom).degrees()[i] for i in range(len(ring.atoms)) if ring.mentions(i, self.name)):
            return None
        place = ring.index[Symbol(self.name)]
        if bottom.degrees()[place]:
            return None
        whole: Formula = ZERO
        for n, part in enumerate(ring.coefficients(top, place)):
            share = problem.shortest((part, bottom)) / Number(Fraction(2 * n + 1, 2))
            for end, side in ((self.upper, share), (self.lower, negate(share))):
                whole = add(whole, side * (end**n if n else ONE) * sqrt(end))
        return self._tidy(whole)

    def _tidy(self, f: Formula) -> Formula:
        return simplify(f, order=self.order, positive=self.positive)

    def _fraction(self, f: Formula) -> tuple[list[Formula], list[Formula]] | None:
        """Coefficients of the numerator and denominator by powers of the variable; None where it stands in a function."""
        problem = Fractions([f], self.order, self.positive, extra=(self.name,))
        ring = problem.field
        top, bottom = problem.ratio()
        top, bottom = ring.cancel((ring.reduce(top), ring.reduce(bottom)))
        inside = [i for i in range(len(ring.atoms)) if ring.mentions(i, self.name)]
        if any(poly.degrees()[i] for poly in (top, bottom) for i in inside):
            return None
        place = ring.index[Symbol(self.name)]
        above, below = (ring.coefficients(poly, place) for poly in (top, bottom))
        if not 2 <= len(below) <= 3 or len(above) > len(below):
            return None if len(below) > 1 or len(above) > 1 else ([problem.shortest((top, bottom))], [ONE])
        return tuple([problem.shortest((part, ring.one)) for part in side] for side in (above, below))  # type: ignore[return-value]

    def _quotient(self, above: list[Formula], below: list[Formula]) -> Formula | None:
        """∫ of a quotient of polynomials; the denominator of degree one or two, the numerator of no higher one."""
        if len(below) == 1:
            return self._tidy(above[0] / below[0] * (self.upper - self.lower))
        whole: Formula = ZERO
        if len(above) == len(below):
            share = self._tidy(above[-1] / below[-1])
            above = [self._tidy(one - share * other) for one, other in zip(above[:-1], below[:-1], strict=True)]
            whole = share * (self.upper - self.lower)
        above = [*above, ZERO, ZERO]
        if len(below) == 2:
            return self._tidy(add(whole, self._logarithm(self._tidy(above[0] / below[1]), self._at(below))))
        a, b, c = below
        result = whole
        if above[1] != ZERO:
            result = add(result, self._logarithm(self._tidy(above[1] / (TWO * c)), self._at(below)))
        rest = self._tidy(above[0] - above[1] * b / (TWO * c))
        return self._tidy(add(result, rest * self._plain(a, b, c))) if rest != ZERO else self._tidy(result)

    def _at(self, coefficients: list[Formula]) -> tuple[Formula, Formula]:
        """A polynomial at both ends."""
        line: Formula = ZERO
        for power, part in enumerate(coefficients):
            line = add(line, part * Symbol(self.name) ** power if power else part)
        first, last = (self._tidy(line.substitute({self.name: end})) for end in (self.lower, self.upper))
        return first, last

    def _logarithm(self, factor: Formula, ends: tuple[Formula, Formula]) -> Formula:
        """factor · log(last/first), turned over where that saves a minus sign."""
        self._same_side(*ends)
        first, last = ends
        if isinstance(factor, Negative):
            first, last, factor = last, first, factor.operand
        return factor * call("log", self._tidy(last / first))

    def _same_side(self, first: Formula, last: Formula) -> None:
        """What the integrand is divided by may not vanish at an end or between."""
        signs = self.sign(first), self.sign(last)
        if 0 in signs or (None not in signs and signs[0] != signs[1]):
            raise Unending("what is reached there is only approached: it would take for ever")

    def _plain(self, a: Formula, b: Formula, c: Formula) -> Formula:
        """∫ dx/(a + b x + c x²): a logarithm where the denominator has real roots, else an arc tangent."""
        inside = self._tidy(b**2 - FOUR * a * c)
        sign = self.sign(inside)
        slopes = [self._tidy(TWO * c * end + b) for end in (self.lower, self.upper)]
        if sign == 0:
            self._same_side(*slopes)
            return TWO / slopes[0] - TWO / slopes[1]
        root = self._tidy(sqrt(inside if sign != -1 else negate(inside)))
        if sign == -1:
            first, last = (call("atan", self._tidy(slope / root)) for slope in slopes)
            return TWO / root * add(last, negate(first))
        low, high = ([self._tidy(slope + shift) for slope in slopes] for shift in (negate(root), root))
        self._same_side(*low)
        self._same_side(*high)
        return call("log", self._tidy(low[1] * high[0] / (high[1] * low[0]))) / root

    def _root(self, below: list[Formula]) -> Formula | None:
        """∫ dx/√(a + b x + c x²): an arc sine where c < 0, a logarithm where c > 0."""
        first, last = self._at(below)
        a, b, c = [*below, ZERO, ZERO][:3]
        if c == ZERO:
            return self._tidy(TWO / b * (sqrt(last) - sqrt(first)))
        sign = self.sign(c)
        slopes = [self._tidy(TWO * c * end + b) for end in (self.lower, self.upper)]
        if sign == -1:
            size = self._tidy(sqrt(b**2 - FOUR * a * c))
            arcs = [self._arc(slope, size, at) for slope, at in zip(slopes, (first, last), strict=True)]
            return self._tidy(add(arcs[1], negate(arcs[0])) / sqrt(negate(c)))
        if sign != 1:
            return None
        tops = [add(slope, TWO * sqrt(c) * sqrt(end)) for slope, end in zip(slopes, (first, last), strict=True)]
        return self._tidy(call("log", self._tidy(tops[1] / tops[0])) / sqrt(c))

    def _powers_beside_root(self, f: Formula) -> Formula | None:
        """∫ p dx/√R and ∫ √R dx for R = a + b x + c x² and p of degree 2 at most: (A x + B) √R + C ∫ dx/√R."""
        problem = Fractions([self._tidy(f * f)], self.order, self.positive, extra=(self.name,))
        ring, place = problem.field, problem.field.index[Symbol(self.name)]
        sides = ring.cancel(problem.ratio())
        inside = [i for i in range(len(ring.atoms)) if ring.mentions(i, self.name)]
        if any(poly.degrees()[i] for poly in sides for i in inside):
            return None
        above, below = (
            [problem.shortest((part, ring.one)) for part in ring.coefficients(poly, place)] for poly in sides
        )
        if len(below) == 1 and len(above) == 3:
            below = [self._tidy(part / below[0]) for part in above]
            top: list[Formula] | None = below
        else:
            if self.sign(above[-1]) == -1:
                above, below = ([self._tidy(negate(part)) for part in side] for side in (above, below))
            top = self._square_root(above) if len(below) == 3 and len(above) in (3, 5) else None
        if top is None:
            return None
        (p, q, r), (a, b, c) = [*top, ZERO][:3], below
        first = self._tidy(r / (TWO * c))
        second = self._tidy((q - Number(Fraction(3, 2)) * first * b) / c)
        rest, ends = self._tidy(p - first * a - HALF * second * b), self._at(below)
        arc = self._root(below) if rest != ZERO else ZERO
        if arc is None:
            return None
        last, begun = (
            (first * end + second) * sqrt(root) for end, root in zip((self.upper, self.lower), ends[::-1], strict=True)
        )
        whole = self._tidy(add(add(last, negate(begun)), rest * arc))
        middle = {self.name: HALF * (self.lower + self.upper)}
        shape = (p + q * Symbol(self.name) + r * Symbol(self.name) ** 2).substitute(middle)
        signs = self.sign(self._tidy(f.substitute(middle))), self.sign(self._tidy(shape))
        return None if None in signs or 0 in signs else whole if signs[0] == signs[1] else negate(whole)

    def _square_root(self, above: list[Formula]) -> list[Formula] | None:
        """The polynomial of degree 1 or 2 whose square has these coefficients; None where there is none."""
        lead = self._tidy(sqrt(above[-1]))
        if len(above) == 3:
            root = [self._tidy(above[1] / (TWO * lead)), lead]
            return root if self._tidy(root[0] ** 2 - above[0]) == ZERO else None
        middle = self._tidy(above[3] / (TWO * lead))
        last = self._tidy((above[2] - middle**2) / (TWO * lead))
        fits = self._tidy(TWO * middle * last - above[1]) == ZERO and self._tidy(last**2 - above[0]) == ZERO
        return [last, middle, lead] if fits else None

    def _arc(self, slope: Formula, size: Formula, radicand: Formula) -> Formula:
        """arcsin(−slope/size): a quarter turn where the root vanishes at that end."""
        way = self.sign(slope) if radicand == ZERO or self.sign(radicand) == 0 else None
        return HALF * PI * -way if way else call("asin", self._tidy(negate(slope) / size))

    def _apparent(self, f: Formula) -> int | None:
        """The sign of ±c √…, whatever stands under the root; None where it can't be seen."""
        if self.name not in f.symbols():
            return self.sign(f)
        if isinstance(f, Call) and f.function == "sqrt":
            return 1
        if not isinstance(f, (Negative, Product, Quotient)):
            return None
        signs = [self._apparent(part) for part in f.children()]
        told = [sign for sign in signs if sign is not None]
        return prod(told) * (-1 if isinstance(f, Negative) else 1) if len(told) == len(signs) else None

    def _negative(self, f: Formula) -> bool:
        """Whether the integrand is negative on the way."""
        sign = self._apparent(f) or self.sign(f.substitute({self.name: HALF * (self.lower + self.upper)}))
        return sign == -1 if sign is not None else isinstance(f, Negative)


def has_root(f: Formula, name: str) -> bool:
    """Whether the variable stands under a root."""
    return any(isinstance(node, Call) and node.function == "sqrt" and name in node.symbols() for node in f.walk("sqrt"))


LONG = 60  # nodes of an integral whose constants are letters while it is carried out


def in_closed_form(node: Integral, sign: SignOf, order: tuple[str, ...], positive: frozenset[str]) -> Formula | None:
    """An integral in closed form; None where it has none that a page would hold. Of a long one the constants are letters meanwhile."""
    if length(node) <= LONG or node.integrand.holds(Integral):
        return closed(node, sign, order, positive)
    told: dict[str, Formula] = {}
    f = with_letters(node.integrand, node.variable, told)
    ends = [with_letters(end, node.variable, told) for end in (node.lower, node.upper)]

    def sign_of(value: Formula) -> int | None:
        return sign(value.substitute(told))

    above = positive | {name for name, value in told.items() if sign(value) == 1}
    done = closed(Integral(f, node.variable, *ends), sign_of, (*order, *told), above)
    return None if done is None else done.substitute(told)


def with_letters(f: Formula, variable: str, told: dict[str, Formula]) -> Formula:
    """A formula with a letter for each part without the variable; `told` has what they stand for, the same parts the same letter."""
    if isinstance(f, (Number, Symbol)):
        return f
    if variable not in f.symbols():
        found = next((name for name, value in told.items() if value == f), f"constant {len(told) + 1}")
        told[found] = f
        return Symbol(found)
    parts = f.children()
    if isinstance(f, (Sum, Product)):
        fixed = tuple([part for part in parts if variable not in part.symbols()])
        parts = tuple([part for part in parts if variable in part.symbols()])
        parts += (f.with_children(fixed),) if fixed else ()
    return f.with_children(tuple([with_letters(part, variable, told) for part in parts]))


def closed(node: Integral, sign: SignOf, order: tuple[str, ...], positive: frozenset[str]) -> Formula | None:
    """An integral in closed form; None where it has none."""
    f, name = node.integrand, node.variable
    rooted = has_root(f, name)
    if rooted or any(isinstance(part, Quotient) and name in part.denominator.symbols() for part in f.walk(Quotient)):
        try:
            done = Stretch(name, node.lower, node.upper, sign, order, positive).integral(f)
        except Unending as error:
            raise Undefined(str(error)) from None
        if done is not None:
            return done
    return (integrate_by_hand if rooted else integrate)(f, name, node.lower, node.upper, positive=positive)
