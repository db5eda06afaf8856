"""Textbook form: what is found put in, integrals carried out, products in their usual order."""

from __future__ import annotations

from fractions import Fraction
from functools import partial, reduce
from math import prod

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import in_powers
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import Fractions, is_zero, simplify
from rotsolve.algebra.exact.order import length
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
    call,
    multiply,
    total,
)
from rotsolve.core.derivation import Equality
from rotsolve.core.symbols import TIME, at_any_time
from rotsolve.core.vectors.heading import heading
from rotsolve.solver.steps import Found

LONGEST = 1000  # nodes under a root, beyond which no form is one that a page would hold
SEEN_THROUGH = 200  # nodes of a formula with elliptic functions
IN_RATIOS = ("sin", "cos", "tan", "abs")  # functions beside which a common factor is looked for
LONGEST_INTEGRAL = 150  # nodes of an integral of which the antiderivative is written at its ends


def is_long_root(value: Formula) -> bool:
    """Whether a formula is a root, such as the size of a vector, of something so long that squaring it out leads nowhere."""
    return isinstance(value, Call) and value.function == "sqrt" and length(value) > LONGEST


def seen_through_no_more(value: Formula) -> bool:
    """Whether a formula holds elliptic functions, exponentials, or angles, of so much that it stays in the letters found before: no form
    would shorten it."""
    longest = SEEN_THROUGH if value.holds(*ELLIPTIC) else 3 * SEEN_THROUGH
    return length(value) > longest and value.holds(*ELLIPTIC, "exp", "acos", "atan2")


def is_size(value: Formula) -> bool:
    """Whether a formula is the root of a sum of squares, as the size of a vector is."""
    root = value.arguments[0] if isinstance(value, Call) and value.function == "sqrt" else value
    return isinstance(root, Sum) and all(isinstance(term, Power) for term in root.terms)


def part_of_whole(value: Formula) -> bool:
    """Whether a formula is a share as it is defined, (K − K′)/K, which to divide out would make hard to recognise."""
    return (
        isinstance(value, Quotient) and isinstance(value.numerator, Sum) and value.denominator in value.numerator.terms
    )


def quarters_turned(value: Formula) -> Formula:
    """A formula with quarter turns taken out of its sines and cosines: sin(φ + π/2) is cos φ."""

    def change(node: Formula) -> Formula:
        if not isinstance(node, Call) or node.function not in ("sin", "cos"):
            return node
        turn = heading(node.arguments[0])
        if not turn.degrees or turn.degrees % 90 or not turn.terms:
            return node
        return turn.sin() if node.function == "sin" else turn.cos()

    return value.transform(change, "sin", "cos")


def gathered(node: Formula) -> Formula:
    """(1/M) ∫ f dx as ∫ (1/M) f dx."""
    if not isinstance(node, Product) or not isinstance(node.factors[-1], Integral):
        return node
    summed = node.factors[-1]
    return Integral(reduce(multiply, node.factors[:-1], summed.integrand), summed.variable, summed.lower, summed.upper)


def with_constants_in_front(line: Equality) -> Equality:
    """∫ k f dx as k ∫ f dx, as it stands in a line that leads on."""
    if not (line.left.holds(Integral) or line.right.holds(Integral)):
        return line
    return replace(line, left=line.left.transform(_constant_in_front), right=line.right.transform(_constant_in_front))


def _constant_in_front(node: Formula) -> Formula:
    if not isinstance(node, Integral):
        return node
    from rotsolve.algebra.calculus.integral import split

    constant, varying = split(node.integrand, node.variable)
    return node if varying == ONE else multiply(constant, Integral(varying, node.variable, node.lower, node.upper))


class Textbook(Struct, kw_only=True):
    """Formulas as a textbook writes them, by the order of the letters, the signs of the givens and the answers found so far."""

    order: tuple[str, ...]
    signs: SignOracle
    solved: dict[str, Found] = field(default_factory=dict)

    @property
    def positive(self) -> frozenset[str]:
        return self.signs.positive

    def simplify(self, value: Formula) -> Formula:
        """Textbook form; bars round a value whose sign the numbers tell are taken off. A root of long squares stays as it is."""
        if is_long_root(value):
            return value
        value = simplify(value, order=self.order, positive=self.positive)
        if value.holds("abs"):
            value = simplify(value.transform(self.without_bars, "abs"), order=self.order, positive=self.positive)
        if value.holds("atan2"):
            value = simplify(value.transform(self.angle_of_ratio, "atan2"), order=self.order, positive=self.positive)
            turned = value.transform(self.within_half_a_turn, "atan2")
            value = value if turned == value else simplify(turned, order=self.order, positive=self.positive)
        value = value.transform(self.angle_of_sine, "asin")
        value = value.transform(self.of_one_root, "sin", "cos").transform(self._exponential, "exp", "log")
        return in_powers(value, TIME, order=self.order, positive=self.positive)

    def shortest(self, value: Formula) -> Formula:
        """Textbook form, unless it is what a power of a sum comes to when it is multiplied out."""
        value = self.roots_of_givens(value)
        final = self.simplify(value)
        bare = value.arguments[0] if isinstance(value, Call) and value.function == "abs" else None
        if bare is not None and length(bare) < length(final) and is_zero(bare - final, self.positive):
            return bare
        roots = [node.arguments[0] for node in value.walk("sqrt") if isinstance(node, Call) and node.function == "sqrt"]
        sums = all(isinstance(root, Sum) for root in roots)
        much = 1 if is_size(value) else Fraction(3, 2)
        return value if sums and much * length(value) < length(final) else final

    def roots_of_givens(self, value: Formula) -> Formula:
        """A formula with R for √(l² − r²) where the scene says l = √(R² + r²): roots that what givens are made of makes whole."""
        made = {name: given for name, given in self.signs.values.items() if given.symbols()}
        if not made or value.symbols().isdisjoint(made):
            return value

        def change(node: Formula) -> Formula:
            if not (isinstance(node, Call) and node.function == "sqrt") or node.symbols().isdisjoint(made):
                return node
            root = self.simplify(node.substitute(made))
            if root.holds("sqrt"):
                return node
            self.signs.decided[node.arguments[0] - root**2] = 0  # other numbers of l hang on it
            return root

        return value.transform(change, "sqrt")

    def of_one_root(self, node: Formula) -> Formula:
        """A sine with its angle in textbook form: sin(w √(2 h/g)) for sin(w √(2 h) √g/g)."""
        if not isinstance(node, Call) or node.function not in ("sin", "cos") or not node.arguments[0].holds("sqrt"):
            return node
        return Call(node.function, (simplify(node.arguments[0], order=self.order, positive=self.positive),))

    def _exponential(self, node: Formula) -> Formula:
        """An exponential with its exponent in textbook form, 1 − exp(−x) where there is a choice; ln(a b) for ln a + ln b."""
        tidy = partial(simplify, order=self.order, positive=self.positive)
        if isinstance(node, Call) and node.function == "exp":
            return Call("exp", (tidy(node.arguments[0]),))
        from rotsolve.algebra.exact.exponentials import one_logarithm, with_fewest_exponentials

        return with_fewest_exponentials(one_logarithm(node, tidy), tidy)

    def unrooted(self, value: Formula) -> Formula:
        """A formula with |x|, or x where it is positive, for √(x²), as it comes about where the other components of a vector vanish."""

        def change(node: Formula) -> Formula:
            inside = node.arguments[0] if isinstance(node, Call) and node.function == "sqrt" else None
            return (
                call("abs", inside.base)
                if isinstance(inside, Power) and inside.exponent == Number(Fraction(2))
                else node
            )

        return self.signs.unbarred(value.transform(change, "sqrt"))

    def without_bars(self, node: Formula) -> Formula:
        """|x| as x or −x where the numbers tell its sign, or that letters without one stand for positive values."""
        if not (isinstance(node, Call) and node.function == "abs"):
            return node
        inside = self.with_answers(node.arguments[0])
        sign = self.signs.decide(inside)
        sign = self.signs.as_meant(inside) if sign is None else sign
        return node.arguments[0] * sign if sign is not None else node

    def angle_of_ratio(self, node: Formula) -> Formula:
        """atan2(y, x) without a common factor whose sign is told: atan2(sin α, cos α) for (m sin α, m cos α)."""
        if not (isinstance(node, Call) and node.function == "atan2"):
            return node
        y, x = node.arguments
        if ZERO in (y, x):
            return self.angle_along_axis(node)
        calls = (inner for side in (y, x) for inner in side.walk(Call))
        if any(isinstance(inner, Call) and inner.function not in IN_RATIOS for inner in calls):
            return node
        ratio = Fractions([y / x], order=self.order, positive=self.positive)
        above, below = map(ratio.shaper.poly, ratio.field.cancel(ratio.ratio()))
        sign = self.sign_of_factors(self.simplify(x / below))
        shorter = call("atan2", above * sign, below * sign) if sign else node
        return shorter if length(shorter) < length(node) else node

    def angle_along_axis(self, node: Call) -> Formula:
        """atan2(y, 0) by the sign of y, ±π/2, and 0 for atan2(0, x) with x > 0; with x < 0 it is π or −π, as y comes to 0."""
        y, x = node.arguments
        sign = self.sign_of_factors(y if x == ZERO else x) if y != x else 0
        if not sign:
            return node
        return sign * (PI / 2) if x == ZERO else ZERO if sign > 0 else node

    def sign_of_factors(self, value: Formula) -> int | None:
        """The sign of a product by those of its factors: by their numbers, or that letters without one stand for positive values."""
        if isinstance(value, (Product, Quotient, Negative)):
            signs = [self.sign_of_factors(child) for child in value.children()]
            known = None if None in signs else prod(sign for sign in signs if sign is not None)
            return -known if known is not None and isinstance(value, Negative) else known
        if isinstance(value, Power):
            base, exponent = self.sign_of_factors(value.base), value.exponent
            even = isinstance(exponent, Number) and exponent.value % 2 == 0
            return base if base in (0, 1) else 1 if base and even else None
        inside = self.with_answers(value)
        sign = self.signs.decide(inside)
        return self.signs.as_meant(inside) if sign is None else sign

    def within_half_a_turn(self, node: Formula) -> Formula:
        """α for atan2(sin α, cos α) where that is told to lie between −π and π."""
        match node:
            case Call("atan2", (Call("sin", (angle,)), Call("cos", (same,)))) if angle == same:
                inside = all(self.signs.decide(self.with_answers(gap)) == 1 for gap in (PI - angle, PI + angle))
                return angle if inside else node
        return node

    def angle_of_sine(self, node: Formula) -> Formula:
        """α for arcsin(sin α) where that is taken to lie between −π/2 and π/2."""
        match node:
            case Call("asin", (Call("sin", (angle,)),)) if all(
                self.signs.taken(self.with_answers(gap)) == 1 for gap in (PI / 2 - angle, PI / 2 + angle)
            ):
                return angle
        return node

    def with_answers(self, value: Formula) -> Formula:
        """Answers found before put in."""
        known = {name: found.formula for name, found in self.solved.items() if found.formula is not None}
        used = {name: known[name] for name in value.symbols() if name in known}
        return value.substitute(used) if used else value

    def drawn_together(self, value: Formula) -> Formula | None:
        """A sum with its terms made of answers put together where that makes one term: in K − ½ I₁ ω² − ½ I₂ ω² the energy left."""
        terms = value.terms if isinstance(value, Sum) else ()
        found = [term for term in terms if not term.symbols().isdisjoint(self.solved)]
        others = [term for term in terms if term.symbols().isdisjoint(self.solved)]
        whole = self.with_answers(total(found))
        if len(found) < 2 or not others or seen_through_no_more(whole):
            return None
        together = self.simplify(whole)
        bare = together.operand if isinstance(together, Negative) else together
        above = bare.numerator if isinstance(bare, Quotient) else bare
        return None if any(isinstance(node, Sum) for node in above.walk()) else total([*others, together])

    def tidied(self, value: Formula) -> Formula:
        """What is integrated in its shortest form."""

        def change(node: Formula) -> Formula:
            if not isinstance(node, Integral):
                return node
            integrand, lower, upper = map(self.simplify, node.children())
            return Integral(integrand, node.variable, lower, upper)

        return value.transform(change, Integral)

    def carried_out(self, value: Formula) -> Formula:
        """All integrals in closed form where there is one."""

        def change(node: Formula) -> Formula:
            if not isinstance(node, Integral) or self._open(node):
                return node
            done = self._carried_out(node)
            return node if done is None else done

        return value.transform(change, Integral)

    def _carried_out(self, node: Integral) -> Formula | None:
        """An integral in closed form, kept for the next that needs it; None where it has none."""
        from rotsolve.algebra.calculus.separable import in_closed_form

        found = tuple([self.solved[name].formula for name in sorted(node.symbols()) if name in self.solved])
        key, known = (node, self.order, found), self.signs.integrals
        if key not in known:
            done = in_closed_form(node, self.sign, self.order, self.positive)
            known[key] = None if done is None else self.simplify(done)
        return known[key]

    def inner_carried_out(self, value: Formula) -> Formula:
        """Integrals within integrals in closed form."""

        def change(node: Formula) -> Formula:
            if not isinstance(node, Integral):
                return node
            return Integral(self.carried_out(node.integrand), node.variable, node.lower, node.upper)

        return value.transform(change)

    def at_bounds(self, value: Formula) -> Formula | None:
        """All integrals as the antiderivative at both ends; None where one has no antiderivative that a page would hold."""
        from rotsolve.algebra.calculus.integral import at_bounds

        value = value.transform(gathered)
        ends: dict[Formula, Formula] = {}
        for node in value.walk():
            if isinstance(node, Integral):
                shown = not self._open(node) and length(node) <= LONGEST_INTEGRAL
                put_in = at_bounds(node, self.simplify) if shown else None
                if put_in is None or not is_zero(put_in - self.carried_out(node), self.positive):
                    return None
                ends[node] = put_in
        return value.transform(lambda node: ends.get(node, node))

    def _open(self, node: Integral) -> bool:
        """Whether something within an integral runs with its variable in a way that is not known yet."""
        return at_any_time(node.integrand.symbols() - {node.variable})

    def sign(self, value: Formula) -> int | None:
        """The sign of a formula with the answers put in."""
        return self.signs.decide(self.with_answers(value))
