"""Rewrite: formulas with every function call in canonical form, so that equal atoms are the same atom.

Calls of sin and cos stay compact (sin(θ − φ)) while their angles are independent; angles that depend on each other
(θ and 2 θ; θ, φ and θ − φ) are expanded to common base angles.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from fractions import Fraction
from math import lcm

from rotsolve.algebra.exact import angles
from rotsolve.algebra.exact.angles import SinCos, Vector
from rotsolve.algebra.exact.field import Field, is_integer_power
from rotsolve.algebra.exact.radicals import Radicals, exact_inverse, known_pair
from rotsolve.algebra.exact.shape import Shaper
from rotsolve.algebra.formula import (
    ELLIPTIC,
    ONE,
    PI,
    ZERO,
    Call,
    Formula,
    Integral,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
    add,
    call,
    divide,
    multiply,
    negate,
)

SIN_COS = ("sin", "cos")
TRIG = (*SIN_COS, "tan")
INVERSE = ("asin", "acos", "atan", "atan2")
MULTIPLE_LIMIT = 24  # multiples of an angle beyond which sin(37 x) stays as it is
CONSTANT_LIMIT = 12  # multiples of a base angle beyond which constants such as sin(37π/180) stay as they are
POWER_LIMIT = 1000  # powers of a base beyond which exp(4001 x/1000) stays as it is


class Rewriter:
    """Canonical calls for formulas that are handled together."""

    def __init__(
        self,
        formulas: Iterable[Formula],
        order: Sequence[str] = (),
        positive: Collection[str] = (),
        split_logs: bool = False,
        constants_apart: bool = False,
    ) -> None:
        self.order = order
        self.positive = positive
        self.split_logs = split_logs
        self.radicals = Radicals(order, positive)
        self.memo: dict[Formula, Formula] = {}
        self.known: dict[tuple[str, Formula], Formula] = {}
        self.shares: dict[Formula, int] = {}  # term -> denominator of its base angle, for terms to be expanded
        self.exp_shares: dict[Formula, int] = {}
        self.terms: list[Formula] = []  # of arguments, with roots in them, as they were written first
        self.constants_apart = constants_apart  # whether sin 25° and sin 35° are not written by sin 5°
        found = [node for f in formulas for node in f.walk(Call) if isinstance(node, Call)]
        self.plain = all(node.function in SIN_COS and isinstance(node.arguments[0], Symbol) for node in found)
        if not self.plain:
            self._plan(dict.fromkeys(found))

    # which angles to expand

    def _plan(self, calls: Iterable[Call]) -> None:
        vectors: list[tuple[Vector, Fraction]] = []  # with the multiple of π that goes with each
        turns: set[Fraction] = set()
        for node in calls:
            if node.function in TRIG and not node.arguments[0].holds(*TRIG):
                vector, rest, _ = angles.split_pi(self._linear(node.arguments[0]))
                if vector:
                    sign, vector = _signed(vector, self.order)
                    if (vector, sign * rest) not in vectors:
                        vectors.append((vector, sign * rest))
                elif angles.exact_angle(rest) is None:
                    turns.add(abs(rest))
            elif node.function == "exp" and not node.arguments[0].holds(*TRIG):
                for term, value in self._linear(node.arguments[0]).items():
                    self.exp_shares[term] = lcm(self.exp_shares.get(term, 1), value.denominator)
        for group in angles.coupled((vector for vector, _ in vectors), set):
            if angles.rank(group) < len(group) or any(_is_inverse(term) for vector in group for term in vector):
                for vector in group:
                    for term, value in vector.items():
                        self.shares[term] = lcm(self.shares.get(term, 1), value.denominator)
        share = lcm(*(t.denominator for t in turns)) if len(turns) > 1 else 1
        if len(turns) > 1 and all(t * share <= CONSTANT_LIMIT for t in turns) and not self.constants_apart:
            self.shares[PI] = share

    @property
    def constants_tied(self) -> bool:
        """Whether sines of several constants are written by those of their common base angle."""
        return PI in self.shares

    def _linear(self, argument: Formula) -> Vector:
        return self._terms_of(self(argument) if argument.holds("sqrt", "abs", *INVERSE) else argument)

    def _terms_of(self, argument: Formula) -> Vector:
        """An argument by its terms, each written as where it stood first: T w √x and T √x w are one."""
        return {self._as_before(term): value for term, value in angles.linear(argument, self.order).items()}

    def _as_before(self, term: Formula) -> Formula:
        """A term, or an equal one that stood in an argument before."""
        if not term.holds("sqrt"):
            return term
        before = (other for other in self.terms if other == term or self._zero(add(other, negate(term))))
        found = next(before, None)
        self.terms += [term] if found is None else []
        return term if found is None else found

    # rewriting

    def __call__(self, node: Formula) -> Formula:
        """The formula with all its calls canonical."""
        if self.plain and all(is_integer_power(power) for power in node.walk(Power) if isinstance(power, Power)):
            return node
        return self._rewrite(node)

    def _rewrite(self, node: Formula) -> Formula:
        if not node.children():
            return node
        if node not in self.memo:
            self.memo[node] = self._rewrite_inner(node)
        return self.memo[node]

    def _rewrite_inner(self, node: Formula) -> Formula:
        if isinstance(node, Integral):
            return node
        old = node.children()
        new = tuple(self._rewrite(child) for child in old)
        if isinstance(node, Call):
            return self._call(node.function, new)
        power = isinstance(node, Power)
        if any(a is not b for a, b in zip(old, new, strict=True)):
            node = node.with_children(new)  # x − 0 is the child x, which is canonical already
        if power and isinstance(node, Power) and not is_integer_power(node):
            return self._power(node)
        return node

    def _power(self, node: Power) -> Formula:
        exponent = self.tidy(node.exponent)
        if isinstance(exponent, Number):
            value = exponent.value
            if value.denominator == 1:
                return Power(node.base, exponent)
            if value.denominator == 2:
                return Power(self.radicals.sqrt(node.base), Number(Fraction(value.numerator)))
        return Power(self.tidy(node.base), exponent)

    def _call(self, function: str, arguments: tuple[Formula, ...]) -> Formula:
        first = arguments[0]
        if function in TRIG:
            s, c = self._sin_cos(first)
            return s if function == "sin" else c if function == "cos" else divide(s, c)
        if function == "sqrt":
            return self.radicals.sqrt(first)
        if function == "abs":
            return self.radicals.abs(first)
        if function == "exp":
            return self._exp(first)
        if function == "log":
            return self._log(first)
        if function == "ellipk":
            shown = self.tidy(first)
            return divide(PI, Number(Fraction(2))) if shown == ZERO else Call(function, (shown,))
        if function == "ellippi":
            return self._third_kind(*(self.tidy(argument) for argument in arguments))
        if function == "ellippiinc":
            return self._third_kind_up_to(*(self.tidy(argument) for argument in arguments))
        if function in ELLIPTIC:
            return self._elliptic(function, *(self.tidy(argument) for argument in arguments))
        return self._inverse(function, tuple(self.tidy(argument) for argument in arguments))

    def _third_kind(self, n: Formula, m: Formula) -> Formula:
        """Π(n, m), K(m) where n is nothing; π/(2 √(1 − n)) where m is."""
        if n == ZERO:
            return self._call("ellipk", (m,))
        if m == ZERO:
            return divide(PI, multiply(Number(Fraction(2)), self.radicals.sqrt(add(ONE, negate(n)))))
        return call("ellippi", n, m)

    def _third_kind_up_to(self, n: Formula, phi: Formula, m: Formula) -> Formula:
        """Π(n, φ, m) of a positive φ, F(φ, m) where n is nothing."""
        if n == ZERO:
            return self._elliptic("ellipf", phi, m)
        if phi == ZERO:
            return ZERO
        if isinstance(phi, Negative):
            return negate(call("ellippiinc", n, phi.operand, m))
        return call("ellippiinc", n, phi, m)

    def _elliptic(self, function: str, u: Formula, m: Formula) -> Formula:
        """sn, cn, dn, am and F of positive arguments; where u or m is nothing they are simpler."""
        if u == ZERO:
            return ONE if function in ("ellipcn", "ellipdn") else ZERO
        if m == ZERO:
            u = self._rewrite(u)  # its roots may have been written as √(a/b)
            plain = {"ellipsn": "sin", "ellipcn": "cos"}.get(function)
            return self._call(plain, (u,)) if plain else ONE if function == "ellipdn" else u
        if isinstance(u, Negative):
            found = self._elliptic(function, u.operand, m)
            return found if function in ("ellipcn", "ellipdn") else negate(found)
        return call(function, u, m)

    def tidy(self, node: Formula) -> Formula:
        """One written form for an argument whose calls are canonical already."""
        ring = Field([node])
        num, den = ring.convert(node)
        return Shaper(ring, self.order, self.positive).ratio(ring.cancel((ring.reduce(num), ring.reduce(den))))

    # sin and cos

    def _sin_cos(self, argument: Formula) -> SinCos:
        vector, turns, quarters = angles.split_pi(self._terms_of(argument))
        if not vector:
            return angles.turn(self._constant(turns), quarters)
        whole = len(vector) == 1 and all(abs(value) == 1 for value in vector.values())  # sin(arcsin(k sin x)) = k sin x
        if any(term in self.shares or _is_inverse(term) for term in vector) and (whole or not argument.holds(*TRIG)):
            shares = {term: lcm(self.shares.get(term, 1), value.denominator) for term, value in vector.items()}
            if all(abs(value * shares[term]) <= MULTIPLE_LIMIT for term, value in vector.items()):
                pair: SinCos = self._constant(turns)
                for term, value in vector.items():
                    base = self._base(term, shares[term])
                    pair = angles.add_angles(pair, angles.multiple(base, int(value * shares[term])))
                return angles.turn(pair, quarters)
        sign, vector = _signed(vector, self.order)
        if turns:
            vector = {**vector, PI: sign * turns}
        shown = angles.combination(vector)
        s, c = call("sin", shown), call("cos", shown)
        return angles.turn((negate(s) if sign < 0 else s, c), quarters)

    def _constant(self, turns: Fraction) -> SinCos:
        """sin and cos of turns · π."""
        exact = angles.exact_angle(turns)
        if exact is not None:
            return exact
        share = self.shares.get(PI)
        if share and (turns * share).denominator == 1:
            return angles.multiple(self._base(PI, share), int(turns * share))
        shown = angles.combination({PI: abs(turns)})
        s = call("sin", shown)
        return (negate(s) if turns < 0 else s, call("cos", shown))

    def _base(self, term: Formula, share: int) -> SinCos:
        """sin and cos of term/share as atoms, or as an algebraic value where the term is an inverse function."""
        if share == 1 and isinstance(term, Call) and term.function in INVERSE:
            return known_pair(Call(term.function, tuple(map(self, term.arguments))), self.radicals)
        shown = angles.combination({term: Fraction(1, share)})
        return call("sin", shown), call("cos", shown)

    # the others

    def _exp(self, argument: Formula) -> Formula:
        result: Formula = ONE
        for term, value in self._terms_of(argument).items():
            share = lcm(self.exp_shares.get(term, 1), value.denominator)
            n = int(value * share)
            if isinstance(term, Call) and term.function == "log" and share == 1:
                base = self._rewrite(term.arguments[0])  # its roots may have been written as √(a/b)
            elif abs(n) > POWER_LIMIT:
                base, n = call("exp", angles.combination({term: value})), 1
            else:
                base = call("exp", angles.combination({term: Fraction(1, share)}))
            result = multiply(result, base if n == 1 else Power(base, Number(Fraction(n))))
        return result

    def _log(self, argument: Formula) -> Formula:
        shown = self.tidy(argument)
        if shown == ONE:
            return ZERO
        if isinstance(shown, Call) and shown.function == "exp":
            return self._rewrite(shown.arguments[0])
        if isinstance(shown, Number) and 0 < shown.value < 1 and not self.split_logs:
            return negate(self._same("log", Number(1 / shown.value)))
        return self.radicals.log(argument) if self.split_logs else self._same("log", shown)

    def _inverse(self, function: str, arguments: tuple[Formula, ...]) -> Formula:
        exact = exact_inverse(function, arguments)
        if exact is not None:
            return exact
        first = arguments[0]
        if isinstance(first, Negative):
            if function == "acos":
                return add(PI, negate(self._inverse("acos", (first.operand,))))
            return negate(self._inverse(function, (first.operand, *arguments[1:])))
        if function == "acos" and self.split_logs:
            return add(divide(PI, Number(Fraction(2))), negate(self._same("asin", first)))
        if function == "atan2" and self._surely_positive(arguments[1]):
            return self._inverse("atan", (self.tidy(self._rewrite(divide(first, arguments[1]))),))
        return (
            self._same(function, first) if len(arguments) == 1 else call(function, *self._reduced(first, arguments[1]))
        )

    def _reduced(self, y: Formula, x: Formula) -> tuple[Formula, Formula]:
        """The arguments of atan2 without a common factor that is positive, (u, 2 w) for (¼ M R² u, ½ M R² w)."""
        calls = (node for side in (y, x) for node in side.walk(Call) if isinstance(node, Call))
        if x == ZERO or any(node.function not in TRIG for node in calls):
            return y, x
        ratio = self.tidy(divide(y, x))
        bare = ratio.operand if isinstance(ratio, Negative) else ratio
        if isinstance(bare, Quotient):
            above = negate(bare.numerator) if isinstance(ratio, Negative) else bare.numerator
            common = self.tidy(divide(x, bare.denominator))
            if self._surely_positive(common):
                return above, bare.denominator
            if isinstance(common, Negative) and self._surely_positive(common.operand):
                return negate(above), negate(bare.denominator)
        return y, x

    def _surely_positive(self, node: Formula) -> bool:
        """Whether a formula is made of positive letters and numbers alone."""
        if isinstance(node, Number):
            return node.value > 0
        if isinstance(node, Quotient):
            return self._surely_positive(node.numerator) and self._positive_below(node.denominator)
        if isinstance(node, (Sum, Product)):
            return all(self._surely_positive(child) for child in node.children())
        if isinstance(node, Power):
            return self._surely_positive(node.base)
        return isinstance(node, Symbol) and node.name in self.positive

    def _positive_below(self, node: Formula) -> bool:
        """Whether a denominator, which is not 0, is positive: even powers are, of whatever."""
        if isinstance(node, Product):
            return all(map(self._positive_below, node.children()))
        exponent = node.exponent if isinstance(node, Power) else None
        even = isinstance(exponent, Number) and exponent.value.denominator == 1 and exponent.value.numerator % 2 == 0
        return even or self._surely_positive(node)

    def _same(self, function: str, argument: Formula) -> Formula:
        """The call, or an earlier call of the function whose argument is equal though written in another way."""
        for (name, other), node in self.known.items():
            if name == function and (other == argument or self._zero(add(other, negate(argument)))):
                return node
        return self.known.setdefault((function, argument), call(function, argument))

    def _zero(self, node: Formula) -> bool:
        """Whether a sum of arguments vanishes; their roots are made canonical again, as they may have been written as √(a/b)."""
        node = self._rewrite(node)
        ring = Field([node])
        return not len(ring.reduce(ring.convert(node)[0]))


def _is_inverse(term: Formula) -> bool:
    return isinstance(term, Call) and term.function in INVERSE


def _signed(vector: Vector, order: Sequence[str]) -> tuple[int, Vector]:
    """Sign and vector with its terms in order and the first of them positive."""

    def place(term: Formula) -> tuple[int, int, str]:
        places = [order.index(name) for name in term.symbols() if name in order]
        return (min(places, default=len(order)), len(repr(term)), repr(term))

    terms = sorted(vector, key=place) if len(vector) > 1 else list(vector)
    sign = 1 if vector[terms[0]] > 0 else -1
    return sign, {term: sign * vector[term] for term in terms}
