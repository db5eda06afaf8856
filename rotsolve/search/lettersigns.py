"""Letter signs: the sign that a formula of letters without numbers has wherever they may be, as far as it is proved.

Letters stand for positive values, angles for those between 0 and 90°; a scene may ask more of them, which are its limits.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.sign import SignOracle, sign_within
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import degree, is_zero, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ONE, PI, ZERO, Call, Formula, Quotient, Symbol
from rotsolve.core.letters import Given

MOST_ANGLES = 3  # whose ends are looked at one by one
LONG = 120  # nodes of a condition from which on it is not solved for a letter
MORE = "#more"  # by how much a letter is more than its limit
ANGLE = "#angle"  # what stands for an angle whose cosine, sine or tangent is told
ROOT = "#root"  # what stands for a root in a formula
QUARTER: tuple[Formula, Formula] = (ZERO, PI / 2)
RANGES: dict[str, tuple[Formula, Formula]] = {
    "acos": (ZERO, PI),
    "asin": (-PI / 2, PI / 2),
    "atan": (-PI / 2, PI / 2),
}


class Proviso(Struct, frozen=True):
    """gap > 0 (`strict`), or gap ≥ 0, where the gap is no product of others, and of no sure sign."""

    gap: Formula
    strict: bool

    def opposes(self, other: Proviso) -> bool:
        """Whether one holds exactly where the other does not."""
        return self.strict != other.strict and is_zero(self.gap + other.gap)

    def same(self, other: Proviso) -> bool:
        """Whether both say the same."""
        return self.strict == other.strict and is_zero(self.gap - other.gap)


class LetterSigns:
    """Signs of formulas in letters, each proved once."""

    letters: dict[str, Given]
    oracle: SignOracle
    acute: set[str]
    positive: frozenset[str]
    limited: tuple[Proviso, ...]
    assumed: set[str]  # letters of which it was needed that they are positive, or acute, though nothing else says so
    told: dict[Formula, int | None]

    def has_both_signs(self, value: Formula) -> bool:
        """Whether a formula is seen to be positive at one point and negative at another."""
        raise NotImplementedError

    def sure(self, value: Formula) -> int | None:
        """The sign that a formula has wherever its letters may be."""
        if value not in self.told:
            self.told[value] = None if self.has_both_signs(value) else self.proved(value)
        return self.told[value]

    def proved(self, value: Formula) -> int | None:
        """The sign of a formula by what is known of its letters, or of its coefficients."""
        sign = self.oracle.by_letters(value)
        if sign is None:
            own = simplify(value, positive=self.positive)
            sign = sign_within(own, {*self.positive, *self.acute}, self.acute)
            if sign is not None:
                self.assumed |= own.symbols() & self.letters.keys() - self.oracle.positive - self.oracle.limits().keys()
        sign = self.within_limits(value) if sign is None else sign
        sign = self.of_angles(value) if sign is None else sign
        sign = self.of_coefficients(value) if sign is None else sign
        sign = self.of_square(value) if sign is None else sign
        sign = self.of_sines(value) if sign is None else sign
        return self.of_root(value) if sign is None else sign

    def of_sines(self, value: Formula) -> int | None:
        """The sign of what holds an acute angle beside its sine: that is less, x/(1 + δ) for an x."""
        beside: dict[Formula, Formula] = {
            Call("sin", (Symbol(name),)): Symbol(name) / (ONE + Symbol(MORE)) for name in sorted(self.acute)
        }
        whole = value.transform(lambda node: beside.get(node, node), "sin") if self.acute & value.symbols() else value
        if whole == value or whole.holds("sin", "cos", "tan"):
            return None
        return sign_within(whole, {*self.positive, *self.acute, MORE}, self.acute)

    def of_root(self, value: Formula) -> int | None:
        """The sign of a + b √c, where those of a and b are sure: where they differ, that of a times that of a² − b² c."""
        parts = self.rooted(value)
        if parts is None:
            return None
        free, slope, under = parts
        signs = [self.sure(part) for part in (free, slope)]
        if None in signs or 0 in signs or signs[0] == signs[1]:
            return signs[0] if signs[0] and signs[0] == signs[1] else None
        square = self.sure(simplify(free**2 - slope**2 * under, positive=self.positive))
        return None if square is None or signs[0] is None else signs[0] * square

    def rooted(self, value: Formula) -> tuple[Formula, Formula, Formula] | None:
        """The a, b and c of a + b √c; None of anything else."""
        roots = {root for root in roots_in(value) if root.symbols() & self.letters.keys()}
        if len(roots) != 1 or not value.symbols() & self.letters.keys() or length(value) > LONG:
            return None
        root = next(iter(roots))
        letter = Symbol(ROOT)
        whole = value.transform(lambda node: letter if node == root else node, "sqrt")
        if degree(whole, ROOT) != 1 or any(ROOT in below.symbols() for below in denominators(whole)):
            return None
        return whole.substitute({ROOT: ZERO}), differentiate(whole, ROOT), root.arguments[0]

    def of_angles(self, value: Formula) -> int | None:
        """The sign of what is linear in angles and hangs on nothing else, by its values where these are as small or large as they can be:
        acute letters, arccosines and their like."""
        if not (value.symbols() & self.acute or value.holds(*RANGES)):
            return None
        ranges = dict.fromkeys(value.symbols() & self.acute, QUARTER)
        stand_ins: dict[Formula, Symbol] = {}
        for number, node in enumerate(dict.fromkeys(value.walk(Call))):
            if isinstance(node, Call) and node.function in RANGES:
                stand_ins[node] = Symbol(f"{ANGLE}{number}")
                acute = self.sure(node.arguments[0]) in (0, 1)
                ranges[stand_ins[node].name] = QUARTER if acute else RANGES[node.function]
        value = value.transform(lambda node: stand_ins.get(node, node), *RANGES) if stand_ins else value
        names = sorted(value.symbols() - self.oracle.values.keys())
        if not 0 < len(names) <= MOST_ANGLES or not ranges.keys() >= set(names):
            return None
        if any(degree(value, name) != 1 for name in names):
            return None
        ends = (dict(zip(names, corner, strict=True)) for corner in product(*(ranges[name] for name in names)))
        signs = [self.oracle.by_numbers(value.substitute(end)) for end in ends]
        found = {sign for sign in signs if sign}
        return None if None in signs or len(found) > 1 else next(iter(found), 0)

    def of_coefficients(self, value: Formula) -> int | None:
        """The sign of a polynomial in an open letter whose coefficients all have it, by the numbers of the givens too."""
        open_ = sorted(value.symbols() & self.positive & self.letters.keys())
        for name in open_:
            parts = coefficients(value, name)
            found = set[int]()
            for part in parts:
                sign = self.sure(part)
                if sign is None or len(found := found | ({sign} - {0})) > 1:
                    break
            else:
                if parts:
                    return next(iter(found), 0)
        return None if open_ or value.symbols() & self.letters.keys() else self.oracle.by_numbers(value)

    def of_square(self, value: Formula) -> int | None:
        """The sign of a x² + b x + c, that of a where b² − 4 a c is surely negative."""
        for name in sorted(value.symbols() & self.letters.keys()):
            parts = coefficients(value, name)  # of which the last is 2 a
            if len(parts) == 3 and (sign := self.sure(parts[2])):
                least = simplify(parts[1] ** 2 - 2 * parts[2] * parts[0], positive=self.positive)
                if length(least) < LONG and self.sure(least) == -1:
                    return sign
        return None

    def within_limits(self, value: Formula) -> int | None:
        """The sign that a formula has within one of the limits."""
        signs = (sign for limit in self.limited for sign in self.signs_where(value, limit))
        return next(signs, None)

    def signs_where(self, value: Formula, limit: Proviso, *, edges: bool = False) -> Iterator[int]:
        """The signs that are told of a formula where a condition holds, on its edge too if that is asked, by one of its letters: y + δ
        stands there for an x that is at least y, y/(1 + δ) for one that is at most y."""
        within = {*self.positive, *self.acute}
        for name in sorted(limit.gap.symbols() & value.symbols() & self.letters.keys()):
            least = solve_linear(limit.gap, name, positive=self.positive)
            slope = None if least is None else sign_within(simplify(differentiate(limit.gap, name)), within, self.acute)
            if least is None or not slope or (slope < 0 and sign_within(least, within, self.acute) != 1):
                continue
            beyond = least + Symbol(MORE) if slope > 0 else least / (ONE + Symbol(MORE))
            whole = simplify(value.substitute({name: beyond}), positive={*self.positive, MORE})
            if whole.holds("log", "acos", "asin") or not all(
                sign_within(root.arguments[0], {*within, MORE}, self.acute) == 1 for root in roots_in(whole)
            ):
                continue  # it may have no value there
            sign = sign_within(whole, {*within, MORE}, self.acute)
            if sign is not None and (
                not edges or sign_within(value.substitute({name: least}), within, self.acute) == sign
            ):
                yield sign


def roots_in(value: Formula) -> Iterator[Call]:
    """All square roots in a formula."""
    return (node for node in value.walk(Call) if isinstance(node, Call) and node.function == "sqrt")


def coefficients(value: Formula, name: str) -> list[Formula]:
    """Those of a polynomial in a letter of degree 3 at most, up to positive factors; none of anything else."""
    power = degree(value, name) if length(value) < LONG else None
    if power is None or power > 3 or any(name in below.symbols() for below in denominators(value)):
        return []
    found = [value]
    for _ in range(power):
        found.append(differentiate(found[-1], name))
    try:
        return [simplify(part.substitute({name: ZERO})) for part in found]
    except (
        ZeroDivisionError
    ):  # it stands within a function too, as in arcsin(sin β + 1 − sin β), whose slope has no value
        return []


def denominators(value: Formula) -> Iterator[Formula]:
    """All that stands below a line."""
    return (node.denominator for node in value.walk(Quotient) if isinstance(node, Quotient))
