"""Letter space: what letters without numbers may be: points of it, and the signs and conditions of formulas in it.

Letters stand for positive values, angles for those between 0 and 90°, and a place on a rod lies between its ends.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property, partial
from itertools import chain, islice
from random import Random

from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.certified.balls import RealBalls, Undefined
from rotsolve.algebra.certified.sign import SignOracle, sign_within
from rotsolve.algebra.exact.normal import Fractions, degree, is_zero, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ONE, Call, Formula, Integral, Number, Symbol, negate
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.units.dimension import NONE
from rotsolve.core.letters import Given
from rotsolve.core.limits import Limit
from rotsolve.language.problem import Find, Problem, references
from rotsolve.motion.positive import is_angle
from rotsolve.search.answers import unsolvable
from rotsolve.search.lettersigns import LetterSigns, Proviso

DOUBLINGS = 9  # up to which a letter is made larger or smaller
LONGEST = 150  # nodes of what a case hangs on from which on it is not told in letters
PATIENT = 1000  # nodes up to which it is tried whether it is shorter than it is written
BITS, MORE_BITS = 64, 2048  # of the balls by which points are looked for, and where those tell nothing
FURTHEST = 26  # doublings up to which an edge is looked for
CLOSER = 10  # halvings of the way to an edge
HALF = Fraction(1, 2)
FEW_SEEN = 3  # of them for a formula with an integral
SEEN = 12  # points at which it is seen first whether a formula has both signs
TRIES = 100  # points that are looked at beyond those
SHARES = ("1/8", "1/4", "1/2", "1", "3/2", "5/2", "5")
STEEP = Fraction(3, 2)  # rad: no acute angle is larger
BARS = "#size"  # what stands for what is between bars in a formula
Point = Mapping[str, Fraction]


def open_letters(problem: Problem) -> tuple[Given, ...]:
    """The letters without a value that stand for any: not what is asked, nor the places over which an extremum is sought."""
    ranging = {name for find in problem.finds for name in ranged_over(find)}
    return tuple(item for item in problem.givens if item.value is None and not item.asked and item.name not in ranging)


def ranged_over(find: Find) -> set[str]:
    """The letters of which a question seeks the value: `F where N = P`, and the places over which it seeks an extremum."""
    ranging = set[str]()
    if find.where is not None and find.where.phrase is not None and isinstance(find.formula, Symbol):
        ranging.add(find.formula.name)
    if find.extreme or (find.where is not None and find.where.word):
        arguments = [ref.argument for ref in references(find) if ref.argument is not None]
        ranging.update(name for argument in arguments for name in argument.symbols())
    return ranging


def at_point(problem: Problem, point: Mapping[str, Formula]) -> Problem:
    """The problem whose case is looked at with these numbers for its open letters."""
    return replace(problem, givens=tuple([replace(item, trial=point.get(item.name)) for item in problem.givens]))


def numbers_of(point: Point) -> dict[str, Formula]:
    """A point as values of letters."""
    return {name: Number(size) for name, size in point.items()}


def any_point(letters: Iterable[Given]) -> dict[str, Fraction]:
    """A point of no special kind: different numbers near 1, for angles near 35°, for what has no dimension near ⅓."""
    point: dict[str, Fraction] = {}
    for place, given in enumerate(letters):
        share = Fraction(1 + 37 * place % 89, 89)
        size = Fraction(9, 20) + share / 3 if is_angle(given) else Fraction(4, 5) + share / 2
        point[given.name] = size / 3 if given.dimension == NONE else size
    return point


class Glance:
    """Signs at one point, by balls of few bits: only those that are sure."""

    def __init__(self, space: LetterSpace, point: Point) -> None:
        self.balls = RealBalls({**space.oracle.values, **numbers_of(point)})
        self.told: dict[Formula, int | None] = {}
        self.implied: dict[tuple[Proviso, Proviso], bool] = {}  # whether the first holds wherever the second does

    def sign(self, value: Formula) -> int | None:
        """1 or −1 where it certainly is, 0 where the bits do not tell, None where the formula has no value."""
        if value not in self.told:
            sign = self.sign_by(BITS, value)
            closer = not sign and not value.holds(Integral)  # of which so many bits take seconds
            self.told[value] = self.sign_by(MORE_BITS, value) if closer else sign
        return self.told[value]

    def sign_by(self, bits: int, value: Formula) -> int | None:
        try:
            with Precision(bits):
                ball = self.balls(value)
            return bool(ball > 0) - bool(ball < 0)
        except (Undefined, ValueError, ZeroDivisionError):
            return None

    def positive(self, value: Formula) -> bool:
        return self.sign(value) == 1

    def fails(self, provisos: Iterable[Proviso]) -> bool:
        """Whether one of the conditions certainly does."""
        return any(self.sign(one.gap) in (-1, None) for one in provisos)


class LetterSpace(LetterSigns):
    """What the open letters of a problem may be, and what follows of signs for all that they may be."""

    def __init__(
        self, problem: Problem, oracle: SignOracle, order: Sequence[str], limits: Iterable[Limit] = ()
    ) -> None:
        self.letters = {given.name: given for given in open_letters(problem)}
        self.oracle, self.order, self.problem = oracle, order, problem
        self.acute = {name for name, given in self.letters.items() if is_angle(given)}
        self.positive = (oracle.positive | self.letters.keys()) - self.acute
        self.limited = self.provisos_of(limits)
        self.limits = tuple(one.gap for one in self.limited)
        self.assumed = set[str]()
        self.told = {}
        self.implied: dict[tuple[Proviso, Proviso], bool] = {}  # whether the first holds wherever the second does

    def provisos_of(self, limits: Iterable[Limit]) -> tuple[Proviso, ...]:
        """What the scene asks of its open letters beyond that they are positive, or acute."""
        known = self.letters.keys() | self.oracle.values.keys()
        found: dict[Formula, bool] = {}
        for limit in limits:
            names = limit.gap.symbols()
            if names <= known and names & self.letters.keys() and not isinstance(limit.gap, Symbol):
                gap = simplify(limit.gap, positive=self.positive)
                if sign_within(gap, {*self.positive, *self.acute}, self.acute) not in (0, 1):
                    found[gap] = found.get(gap, False) or limit.strict
        return tuple(Proviso(gap, strict) for gap, strict in found.items())

    # signs

    @cached_property
    def glances(self) -> tuple[Glance, ...]:
        """Points by which is seen at once that a formula has no sure sign."""
        point = any_point(self.letters.values())
        return tuple(Glance(self, place) for place in islice(filter(self.has, self.elsewhere(point)), SEEN))

    def has_both_signs(self, value: Formula) -> bool:
        """Whether a formula is positive at one point and negative at another."""
        found = set[int]()
        glances = self.glances[: FEW_SEEN if value.holds(Integral) else None]  # an integral takes long at each
        for glance in glances if value.symbols() & self.letters.keys() else ():
            found.add(glance.sign_by(BITS, value) or 0)
            if {1, -1} <= found:
                return True
        return False

    def assumptions(self) -> tuple[str, ...]:
        """What letters were taken to be, in words: "u, w > 0", "0 < β < 90°"."""
        names = [name for name in self.letters if name in self.assumed]
        positive = ", ".join(name_to_text(name) for name in names if name not in self.acute)
        acute = ", ".join(name_to_text(name) for name in names if name in self.acute)
        return (*([f"{positive} > 0"] if positive else []), *([f"0 < {acute} < 90°"] if acute else []))

    def provisos(self, signs: Mapping[Formula, int], point: Point) -> tuple[Proviso, ...]:
        """What has to hold for formulas to have these signs, each once."""
        return tuple(unlike(one for value, sign in signs.items() for one in self.factors(value, sign, point)))

    def factors(self, value: Formula, sign: int, point: Point) -> Iterator[Proviso]:
        """The conditions for a formula to have a sign: for all of its factors whose own is not sure.

        Unsolvable where it is longer than a page would hold.
        """
        if LONGEST < length(value) < PATIENT:
            value = simplify(value, positive=self.positive)
        if length(value) > LONGEST:
            help = f"give a number to {', '.join(f'`{name}`' for name in list(self.letters)[:3])}"
            raise unsolvable(self.problem, "on what the answers hang is too long to print in letters", None, help)
        if self.sure(value) is not None:
            return
        for node in value.walk("abs"):
            if isinstance(node, Call) and node.function == "abs":
                inner = self.side(node.arguments[0], point)
                yield from self.factors(node.arguments[0], inner, point)
        value = self.without_bars(value, point)
        if self.sure(value) is not None:
            return
        problem = Fractions([value], positive=self.positive)
        top, bottom = problem.field.cancel(problem.ratio())
        parts = [part for poly in (top, bottom) for part, power in problem.field.factor(poly)[1] if power % 2]
        for part in map(problem.shaper.poly, parts):
            beyond = (part,) if part.holds("abs") else self.beyond(part)
            if beyond:
                side = self.side(beyond[0], point)
                yield from self.factors(beyond[0], side, point)
                for under in beyond[1:] if side < 0 else ():
                    yield from (replace(one, strict=False) for one in self.factors(under, 1, point))
                continue
            side = self.side(part, point) if self.sure(part) is None else 0
            if side:
                yield Proviso(part if side > 0 else simplify(negate(part)), sign > 0)

    def beyond(self, value: Formula) -> tuple[Formula, ...]:
        """What has the sign of a logarithm ln u, u − 1, of atan2(y, x), y, and of a + b √c where a < 0 < b, b² c − a², with what is not
        negative then, c; nothing of anything else, nor where the value is told by one of its letters."""
        if isinstance(value, Call) and value.function == "log":
            return (value.arguments[0] - ONE,)
        if isinstance(value, Call) and value.function == "atan2":
            return (value.arguments[0],)
        parts = self.rooted(value)
        if parts is None or any(degree(value, name) == 1 for name in value.symbols() & self.letters.keys()):
            return ()
        free, slope, under = parts
        if self.sure(free) != -1 or self.sure(slope) != 1:
            return ()
        return simplify(slope**2 * under - free**2, positive=self.positive), under

    def both_ways(self, value: Formula, sign: int) -> tuple[Formula, ...]:
        """What together has a sign where a − b |x| is positive, or b |x| − a negative: the same of x and −x; of anything else itself."""
        bars = {node for node in value.walk("abs") if isinstance(node, Call) and node.function == "abs"}
        if len(bars) != 1:
            return (value,)
        size, inside = Symbol(BARS), next(iter(bars)).arguments[0]
        whole = value.transform(lambda node: size if node in bars else node, "abs")
        if degree(whole, BARS) != 1 or self.sure(simplify(differentiate(whole, BARS))) != -sign:
            return (value,)
        return tuple(whole.substitute({BARS: way}) for way in (inside, negate(inside)))

    def without_bars(self, value: Formula, point: Point) -> Formula:
        """The formula with x or −x for |x|, as it is at a point."""

        def unbarred(node: Formula) -> Formula:
            if not (isinstance(node, Call) and node.function == "abs"):
                return node
            inside = node.arguments[0]
            return inside if self.side(inside, point) >= 0 else negate(inside)

        return value.transform(unbarred)

    # points

    def side(self, value: Formula, point: Point) -> int:
        """The sign of a formula at a point."""
        return SignOracle({**self.oracle.values, **numbers_of(point)}).by_numbers(value) or 0

    def has(self, point: Point) -> bool:
        """Whether letters may be so."""
        if any(size > STEEP for name, size in point.items() if name in self.acute):
            return False
        return not self.limits or all(map(Glance(self, point).positive, self.limits))

    def first_point(self) -> Point:
        """A point of no special kind."""
        point = any_point(self.letters.values())
        return next(filter(self.has, chain((point,), self.elsewhere(point))), point)

    def elsewhere(self, point: Point) -> Iterator[Point]:
        """Points with letters larger or smaller by chance, always the same ones."""
        chance = Random(0)
        for _ in range(TRIES):
            yield {name: size * Fraction(chance.choice(SHARES)) for name, size in point.items()}

    def across(self, point: Point, gap: Formula) -> Iterator[Point]:
        """Points right across the edge of a region: with one letter as much larger or smaller as makes a gap negative."""
        for name in sorted(gap.symbols() & self.letters.keys()):
            for factor in (2, HALF):
                inside = point[name]
                outside = next(filter(partial(self.negative, point, gap, name), steps(inside, factor)), None)
                for _ in range(CLOSER if outside is not None else 0):
                    middle = (inside + outside) / 2  # type: ignore[operator]
                    negative = self.negative(point, gap, name, middle)
                    inside, outside = (inside, middle) if negative else (middle, outside)
                if outside is not None:
                    yield {**point, name: outside}

    def negative(self, point: Point, gap: Formula, name: str, size: Fraction) -> bool:
        """Whether a gap certainly is where one letter of a point is so large."""
        return Glance(self, {**point, name: size}).sign(gap) == -1

    def fails_somewhere(self, one: Proviso, point: Point) -> bool:
        """Whether a condition says anything: it fails where some letters are a few hundred times as large or as small, or at some edge."""
        if next(self.across(point, one.gap), None) is not None:
            return True
        names = sorted(one.gap.symbols() & self.letters.keys())
        points = filter(self.has, (*self.around(point, names), *self.elsewhere(point)))
        return any(Glance(self, place).fails((one,)) for place in points)

    def around(self, point: Point, names: Sequence[str]) -> Iterator[Point]:
        """Points with one letter larger or smaller."""
        for power in range(1, DOUBLINGS):
            for name in names:
                yield {**point, name: point[name] * 2**power}
                yield {**point, name: point[name] / 2**power}


def steps(size: Fraction, factor: int | Fraction) -> Iterator[Fraction]:
    """Sizes that are larger, or smaller, each time by a factor."""
    for power in range(1, FURTHEST):
        yield size * factor**power


def unlike(provisos: Iterable[Proviso]) -> Iterator[Proviso]:
    """Of conditions about the same formula the first."""
    found: list[Proviso] = []
    for one in provisos:
        if not any(one.gap == other.gap or is_zero(one.gap - other.gap) for other in found):
            found.append(one)
            yield one
