"""Isolation: one equation solved for one unknown: as it is written, in closed form, or as a certified root."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from rotsolve.algebra.calculus.derivative import differentiate, period_of, same_a_turn_on
from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.effort import exert
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import coefficients, degree, is_zero, monomials
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig, solve_unwrapped
from rotsolve.algebra.formula import PI, ZERO, Call, Formula, Integral, Number, Quotient, Sum, Symbol, total
from rotsolve.core.derivation import Equality, Words
from rotsolve.core.symbols import key_of
from rotsolve.solver.steps import (
    Chooser,
    Contradiction,
    Item,
    NoClosedForm,
    NoRealValue,
    PickedRoot,
    Redundant,
    Unprintable,
    holds_square,
    inner,
    isolated,
)
from rotsolve.solver.textbook import Textbook

Ranges = tuple[tuple[Formula | int, Formula | int], ...]
INVERSES = {"asin": "sin", "acos": "cos", "atan": "tan", "log": "exp"}
LONGEST = 800  # nodes of an equation beyond which nothing is solved in letters
MOST_TERMS = 60  # terms of a closed form beyond which it is left out
TOO_LONG = "too long to print in letters"
EVERYWHERE: Ranges = (
    (-10, 10),
    (-100, 100),
    (-1000, 1000),
    (-(10**6), 10**6),
)  # where roots are looked for, one after the other
RANGES: dict[str, Ranges] = {"tilt": ((ZERO, PI),)}  # of what has no others
TURN: Ranges = ((-PI, PI),)  # of an angle that comes round


class Isolation(Textbook, kw_only=True):
    """Solves single equations; `choose` tells which of several roots is meant."""

    choose: Chooser
    numeric: bool = False  # whether a root may be found numerically where there is no closed form
    once_round: str = ""  # a letter for an angle that a condition seeks

    def value_in(self, item: Item, name: str, *, alone: bool) -> tuple[Formula, Words] | None:
        """The value of an unknown from one equation: as written where it stands alone, else solved; and why it is this root."""
        explicit = isolated(item, name)
        if explicit is not None:
            explicit = self.carried_out(explicit)
            return (self.simplify(explicit) if item.sources else explicit), ()
        gap = item.left - item.right
        if name not in inner(item):
            gap = self.carried_out(item.left) - self.carried_out(item.right)
        self.check_length(gap, name)
        value = solve_linear(gap, name, order=self.order, positive=self.positive)
        if (value is not None or alone) and self.hollow(gap, name):
            raise Redundant(item.index)
        if value is not None and self.divides_by_nothing(value):
            if alone:
                raise Redundant(item.index)
            return None
        if value is None and alone:
            gap = gap if self.without_square(gap, name) is None else up_to_first(gap, name)
            return self.one_root(name, solve_polynomial(gap, name, order=self.order, positive=self.positive), gap)
        return None if value is None else (value, ())

    def divides_by_nothing(self, value: Formula) -> bool:
        """Whether a denominator is nothing by the numbers, though its letters do not show it: 2 x − L of the point in the middle."""
        below = [node.denominator for node in value.walk(Quotient) if isinstance(node, Quotient)]
        return any(one.holds(Sum) and self.signs.by_numbers(one) == 0 for one in below)

    def check_length(self, gap: Formula, name: str) -> None:
        """Refuses what no page can hold once it is solved for a letter, before it is written."""
        exert(1)
        if length(gap) > LONGEST or monomials(gap, name, order=self.order, positive=self.positive) > MOST_TERMS:
            raise Unprintable(TOO_LONG)

    def value_within(self, item: Item, name: str) -> tuple[Formula, Words] | None:
        """The value of an unknown that stands within a function: sin n t = 0, log(u) = 3."""
        gap = self.carried_out(item.left) - self.carried_out(item.right)
        if is_zero(gap, self.positive):
            raise Redundant(item.index)
        roots = solve_unwrapped(gap, name, order=self.order, positive=self.positive)
        roots = roots or solve_trig(gap, name, order=self.order, positive=self.positive)
        return self.one_root(name, roots, gap)

    def roots(self, item: Item, asked: str) -> tuple[list[Formula], list[Equality]]:
        """Closed forms of the asked unknown, with the line before the root where it is one."""
        left, right = self.carried_out(item.left), self.carried_out(item.right)
        gap = left - right
        written = isolated(item, asked)
        if written is not None:
            return [self.shortest(self.carried_out(written))], []
        self.check_length(gap, asked)
        power = degree(gap, asked, order=self.order, positive=self.positive)
        if power == 0:
            raise (
                Redundant(item.index) if is_zero(self.with_answers(gap), self.positive) else Contradiction(item.index)
            )
        if power in (1, 2):
            if self.hollow(gap, asked):
                raise Redundant(item.index)
            if power == 2 and (none := self.without_square(gap, asked)) is not None:
                lower = [self.simplify(up_to_first(side, asked)) for side in (left, right)]
                roots = solve_polynomial(lower[0] - lower[1], asked, order=self.order, positive=self.positive)
                return roots, [Equality(none, ZERO), Equality(lower[0], lower[1])]
            roots = solve_polynomial(gap, asked, order=self.order, positive=self.positive)
            square = self.square_in(gap, asked) if power == 2 else None
            told = [] if square is None else [Equality(Symbol(asked) ** 2, square)]
            return roots, [*self.bounds_put_in(item, asked), *told] or self.unfolded(item, Equality(left, right))
        if is_zero(self.with_answers(gap), self.positive):
            raise Redundant(item.index)
        for solve in (solve_polynomial, solve_unwrapped):
            for whole in dict.fromkeys((gap, self.with_answers(gap))):
                roots = solve(whole, asked, order=self.order, positive=self.positive)
                if roots:
                    return roots, self.bounds_put_in(item, asked) or self.unfolded(item, Equality(left, right))
        return solve_trig(self.with_answers(gap), asked, order=self.order, positive=self.positive), []

    def without_square(self, gap: Formula, name: str) -> Formula | None:
        """The coefficient before the square of an unknown where it is nothing, though its letters do not show it, as A − C for A = C; None
        where it is something, and of what is no quadratic."""
        parts = coefficients(gap, name, order=self.order, positive=self.positive) or ()
        if len(parts) != 3 or not parts[2].symbols():
            return None
        size = self.signs.at_trial(parts[2])
        return (
            self.simplify(parts[2]) if size is not None and size.sign == 0 and self.signs.taken(parts[2]) == 0 else None
        )

    def square_in(self, gap: Formula, name: str) -> Formula | None:
        """c of an equation x² = c, given as gap = 0; None for others."""
        parts = coefficients(gap, name, order=self.order, positive=self.positive) or ()
        pure = len(parts) == 3 and parts[1] == ZERO
        return self.simplify(-parts[0] / parts[2]) if pure else None

    def certified_root(self, item: Item, asked: str) -> tuple[Certified, Words]:
        """A certified root where there is no closed form, and why it is this one."""
        if not self.numeric:
            raise NoClosedForm("it has no closed form")
        gap = self.with_answers(self.carried_out(item.left) - self.carried_out(item.right))
        values = self.signs.values
        if gap.symbols() - values.keys() - {asked}:
            raise NoClosedForm("it has no closed form, and not every given has a number")
        from rotsolve.algebra.certified.rootfind import is_identity, real_roots

        doubtful: tuple[Certified, Words] | None = None
        for low, high in self.ranges(gap, asked):
            if is_identity(gap, asked, values, high if isinstance(high, int) else 3):
                raise Redundant(item.index)
            found = real_roots(gap, asked, values, low, high).roots
            if found:
                picked = self.choose(asked, [Number(Fraction(root.float)) for root in found], None)
                root = (found[picked.root], picked.words) if picked else (found[0], ())
                if (
                    doubtful is not None or picked is None or picked.fits
                ):  # else it may lie a little farther, on the other side
                    return root if picked is None or picked.fits else doubtful or root
                doubtful = root
        if doubtful is not None:
            return doubtful
        raise NoRealValue("no real value satisfies the equations")

    def ranges(self, gap: Formula, asked: str) -> Ranges:
        """Where roots are looked for, one after the other; an angle that is sought once round, and beyond if it does not come round."""
        if asked == self.once_round:
            return TURN if same_a_turn_on(gap, asked) else (*TURN, *EVERYWHERE)
        return RANGES.get(key_of(asked).kind, EVERYWHERE)

    def function_alone(self, item: Item, name: str, root: Formula) -> list[Equality]:
        """The line before a root of an unknown that stands within functions of one argument: cos φ = 10/17."""
        sides = [self.carried_out(side) for side in (item.left, item.right)]
        nodes = (node for side in sides for node in side.walk(Call))
        calls = [node for node in nodes if isinstance(node, Call) and name in node.symbols()]
        known = {node.function for node in calls} & set(INVERSES.values())
        inverses = {node.function for node in root.walk(Call) if isinstance(node, Call)} & set(INVERSES)
        functions = {INVERSES[inverse] for inverse in inverses} or known
        arguments = {node.arguments for node in calls}
        if len(arguments) != 1 or len(functions) != 1 or not known:
            return []
        whole = Call(functions.pop(), arguments.pop())
        value = self.simplify(whole.substitute({name: root}))
        wrapped = value.holds(*inverses)
        return [] if wrapped or {item.left, item.right} == {whole, value} else [Equality(whole, value)]

    def like_terms(self, item: Item, name: str) -> list[Equality]:
        """The equation with its terms in the square of an unknown put together: ½ m v² + ⅕ m r² (v/r)² as 7 m v²/10."""
        sides = [self._together(side, name) for side in (item.left, item.right)]
        return [] if sides == [item.left, item.right] or isolated(item, name) else [Equality(sides[0], sides[1])]

    def _together(self, side: Formula, name: str) -> Formula:
        terms: list[Formula] = []
        for term in side.terms if isinstance(side, Sum) else ():
            if name in term.symbols() and is_zero(term, self.positive):  # as ½ I (w − w)²
                continue
            alike = [
                other for other in terms if holds_square(term, name) and isinstance(self.simplify(term / other), Number)
            ]
            terms = [self.simplify(other + term) if other in alike else other for other in terms]
            terms += [] if alike else [term]
        return total(terms) if 0 < len(terms) < len(side.children()) else side

    def one_root(self, name: str, roots: Sequence[Formula], gap: Formula) -> tuple[Formula, Words] | None:
        """The root that is meant of several, and why it is."""
        choice = self.choice(name, roots, gap) if roots else None
        return (self.chosen(choice, roots), choice.words) if choice else None

    def choice(self, name: str, roots: Sequence[Formula], gap: Formula) -> PickedRoot | None:
        """The root that is meant, of the equation gap = 0."""
        period = period_of(self.with_answers(self.carried_out(gap)), name)
        if len(roots) == 1 and period is None:
            return PickedRoot(0)
        return self.choose(name, [self.with_answers(root) for root in roots], period)

    def chosen(self, choice: PickedRoot, roots: Sequence[Formula]) -> Formula:
        """The root itself, whole turns or periods beyond it."""
        return self.simplify(choice.of(roots)) if choice.turns else roots[choice.root]

    def hollow(self, gap: Formula, name: str) -> bool:
        """Whether an unknown drops out once the answers found before are put in: letters such as a₁ and a₂ are not independent."""
        whole = self.with_answers(gap)
        return whole != gap and is_zero(whole, self.positive)

    def bounds_put_in(self, item: Item, name: str, value: Formula | None = None) -> list[Equality]:
        """The lines between an equation with integrals and its result: inner integrals carried out, then the antiderivatives at their
        bounds; where the unknown stands alone only if its `value` is shorter than that."""
        if not item.left.holds(Integral) and not item.right.holds(Integral):
            return []
        alone = isolated(item, name)
        whole = Equality(item.left, item.right) if alone is None else Equality(Symbol(name), alone)
        inner = Equality(self.inner_carried_out(whole.left), self.inner_carried_out(whole.right))
        lines = [inner] if inner != whole else []
        left, right = self.at_bounds(inner.left), self.at_bounds(inner.right)
        if left is None or right is None or (alone and value and letters_of(right) <= letters_of(value)):
            return lines
        return [*lines, Equality(left, right)]

    def unfolded(self, item: Item, done: Equality) -> list[Equality]:
        """The equation with its integrals carried out, where that is not how it stands."""
        return [] if (done.left, done.right) == (item.left, item.right) else [done]


def up_to_first(value: Formula, name: str) -> Formula:
    """A polynomial in a letter without the terms beyond the first power."""
    none = {name: ZERO}
    return value.substitute(none) + differentiate(value, name).substitute(none) * Symbol(name)


def letters_of(value: Formula) -> int:
    """How many letters and functions are written in a formula."""
    return sum(isinstance(node, (Symbol, Call)) for node in value.walk())
