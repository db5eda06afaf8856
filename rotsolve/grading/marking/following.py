"""Following: whether an answer is right given the student's own earlier ones.

The laws of the scene are solved for the answer, and the student's values put in: what is followed through can be printed with its numbers,
√(2·6.3·0.8) = 3.17, and is never found by fitting.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from itertools import combinations, islice, product
from math import floor, log10

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.certified.balls import RealBalls, Undefined
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import Formula, Integral, Number, Symbol, sqrt
from rotsolve.core.derivation import Equality
from rotsolve.core.remembered import remembered
from rotsolve.grading.comparing.numbers import HALF, Typed, certified_number
from rotsolve.grading.comparing.scalars import Same
from rotsolve.grading.marking.target import SceneLetters
from rotsolve.grading.verdict import listed_letters
from rotsolve.language.marks import Tolerance

SHOWN = 3  # figures of the numbers with which a derivation is printed
MOST_FORMS = 4  # ways in which a letter is told by others
LEAST = 2  # figures of an earlier number whose rounding is allowed for


class Own(Struct, frozen=True):
    """What a student gave as an answer, in SI units: a number with half a unit of its last figure, or a formula of the givens."""

    value: Formula
    half: Formula | None = None

    @property
    def numeric(self) -> bool:
        return not self.value.symbols()


def own_number(typed: Typed, factor: Formula) -> Own:
    """A typed number whose unit has this factor."""
    half = typed.half_unit if (typed.figures or 0) >= LEAST else None
    return Own(typed.value * factor, None if half is None else half * factor)


class FollowedBy(Struct, frozen=True):
    """How an answer follows from the student's own earlier ones: a formula that a law gives, and these."""

    form: Formula
    own: Mapping[str, Own]


class Following:
    """The derivations between the answers of a scene, each found when it is first needed."""

    def __init__(self, letters: SceneLetters, same: Same) -> None:
        self.letters = letters
        self.same = same

    def follows(self, name: str, given: Own, earlier: Mapping[str, Own], tolerance: Tolerance) -> FollowedBy | None:
        """How an answer follows from earlier ones: by a law of the scene that tells it, with the student's values in it."""
        for form in self.derivations(name):
            own = {other: one for other, one in earlier.items() if other in form.symbols()}
            if not own or self._gives(form, given, {}, tolerance):
                continue  # it says nothing of what went wrong
            if self._gives(form, given, own, tolerance):
                return FollowedBy(form, own)
        return None

    @remembered
    def derivations(self, name: str) -> tuple[Formula, ...]:
        """What the laws say that an answer is, in letters of other answers and givens."""
        letters = ((law, relation_letters(law) & self.letters.answers) for law in self.told)
        laws = dict.fromkeys(law for law, names in letters if name in names and len(names) > 1)
        forms = (form for law in laws for form in solved_for(law, name))
        return tuple(dict.fromkeys((*forms, *self.differences(name))))

    def differences(self, name: str) -> Iterator[Formula]:
        """The sum or difference of two other answers that an answer is: ΔK = K₂ − K₁."""
        closed = self.letters.closed
        for one, other in combinations(closed.keys() - {name} if name in closed else (), 2):
            first, second = Symbol(one), Symbol(other)
            for form in (first - second, second - first, first + second):
                if self.same(form.substitute(closed), closed[name]):
                    yield form

    @cached_property
    def told(self) -> tuple[Equality, ...]:
        """All laws with their other letters put in: what constants stand for, and what other laws say of them by answers."""
        meanings = self.letters.meanings
        laws = [law for law in meanings.laws if not (law.left.holds(Integral) or law.right.holds(Integral))]
        answers = self.letters.answers | self.letters.givens
        inner = {letter for law in laws for letter in relation_letters(law) - answers if letter in meanings.keys}
        forms: dict[str, list[Formula]] = {}
        for known in (self.letters.givens, answers):  # constants, such as I = ½ M R², before what answers tell
            for letter in inner - forms.keys():
                found = [self._by(law, letter, known, forms) for law in laws if letter in relation_letters(law)]
                short = dict.fromkeys(form for form in found if form is not None)
                if short:
                    forms[letter] = list(short)[:MOST_FORMS]
        return tuple(relation for law in laws for relation in self._put(law, relation_letters(law) - answers, forms))

    def _by(
        self, law: Equality, letter: str, known: Collection[str], forms: Mapping[str, list[Formula]]
    ) -> Formula | None:
        """A letter by one law, where that holds nothing else but known letters and constants."""
        constants = {name: found[0] for name, found in forms.items() if name != letter}
        side = (law.left - law.right).substitute(constants)
        if not side.symbols() - {letter} <= set(known):
            return None
        return linear_root(side, letter)

    def _put(self, law: Equality, inner: Collection[str], forms: Mapping[str, list[Formula]]) -> Iterator[Equality]:
        """A law with every choice of forms for its inner letters; nothing where one has none."""
        names = sorted(inner)
        if all(name in forms for name in names):
            for chosen in islice(product(*(forms[name] for name in names)), MOST_FORMS):
                put = dict(zip(names, chosen, strict=True))
                yield Equality(law.left.substitute(put), law.right.substitute(put))

    # whether a derivation gives what the student wrote

    def _gives(self, form: Formula, given: Own, earlier: Mapping[str, Own], tolerance: Tolerance) -> bool:
        """Whether a derivation with the student's own values, and the right ones for all else, gives the answer."""
        if given.numeric:
            return self._gives_number(form, given, earlier, tolerance)
        if any(one.numeric for one in earlier.values()):
            return False
        own = {other: one.value for other, one in earlier.items()}
        return bool(self.same(given.value, self._with_true(form, own)))

    def _with_true(self, form: Formula, own: Mapping[str, Formula]) -> Formula:
        """A derivation with the student's values, and the closed forms of the answers that they do not tell."""
        return form.substitute({**{name: true for name, true in self.letters.closed.items() if name not in own}, **own})

    def _gives_number(self, form: Formula, given: Own, earlier: Mapping[str, Own], tolerance: Tolerance) -> bool:
        """Whether a derivation comes within the tolerance of the number, the earlier ones being rounded as they are written."""
        values = self.letters.values
        number = certified_number(given.value, {})
        if number is None or not number.float:
            return False
        sides = []
        for one in earlier.values():
            middle = certified_number(one.value, values)
            half = certified_number(one.half, {}) if one.half is not None else None
            if middle is None:
                return False
            reach = 0.0 if half is None else half.float
            sides.append((middle.float - reach, middle.float + reach))
        wanted = self._with_true(form, {letter: Symbol(letter) for letter in earlier})
        found = []
        for corner in product(*sides):
            try:
                ball = RealBalls(values, bound=dict(zip(earlier, map(arb, corner), strict=True)))(wanted)
            except (Undefined, ZeroDivisionError):
                return False
            if not ball.is_finite():
                return False  # it has a pole there, and says nothing
            found.append(float(ball.mid()))
        margin = self._margin(tolerance, number.float)
        return min(found) - margin <= number.float <= max(found) + margin

    def _margin(self, tolerance: Tolerance, number: float) -> float:
        """How far the number may be off, in SI units."""
        if tolerance.share is not None:
            return abs(number) * float(tolerance.share)
        if tolerance.amount is not None:
            amount = certified_number(tolerance.amount, {})
            return 0.0 if amount is None else amount.float
        return float(HALF) * 10.0 ** (floor(log10(abs(number))) - (tolerance.figures or 1) + 1)

    # what is printed of it

    def words(self, name: str, derivation: FollowedBy) -> tuple[str | Formula, ...]:
        """right with your own a: v = √(2 a d) = √(2·6.3·0.8) = 3.17."""
        form, own = derivation.form, derivation.own
        said = ("right with your own ", *listed_letters(own), ": ", Symbol(name), " = ", form)
        values = {letter: self.number(letter, own) for letter in form.symbols()}
        numbers = {letter: short(value.float) for letter, value in values.items() if value is not None}
        if len(numbers) < len(values) or not all(one.numeric for one in own.values()):
            return said
        put = with_numbers_in(form, numbers)
        result = certified_number(form.substitute(numbers), {})
        return said if result is None else (*said, " = ", put, " = ", f"{result.float:.{SHOWN}g}".replace("-", "−"))

    def number(self, letter: str, own: Mapping[str, Own]) -> Certified | None:
        """The number of a letter of a derivation: the student's own, else the right one."""
        value = own[letter].value if letter in own else self.letters.closed.get(letter, Symbol(letter))
        return certified_number(value, self.letters.values)


def with_numbers_in(form: Formula, numbers: Mapping[str, Formula]) -> Formula:
    """A formula with numbers for its letters, nothing worked out: √(2·6.3·0.8)."""
    if isinstance(form, Symbol):
        return numbers.get(form.name, form)
    parts = {name: getattr(form, name) for name in form.__struct_fields__}
    put = {
        name: tuple(with_numbers_in(one, numbers) for one in part)
        if isinstance(part, tuple)
        else with_numbers_in(part, numbers)
        for name, part in parts.items()
        if isinstance(part, (Formula, tuple))
    }
    return replace(form, **put) if put else form


def short(value: float) -> Number:
    """A number of so many figures as a student would put in."""
    return Number(Fraction(f"{value:.{SHOWN}g}"))


def solved_for(relation: Equality, name: str) -> Iterator[Formula]:
    """What a relation says that a letter is; of one that is squared, both roots."""
    residue = relation.left - relation.right
    root = linear_root(residue, name)
    if root is not None:
        yield root
        return
    square = linear_root(residue.substitute({name: sqrt(Symbol(name))}), name)
    if square is not None:
        yield from (sqrt(square), -sqrt(square))


def linear_root(residue: Formula, letter: str) -> Formula | None:
    """The letter for which a residue is zero; None where it is not linear in it, or too hard."""
    try:
        return solve_linear(residue, letter)
    except (ValueError, ArithmeticError):
        return None


def relation_letters(relation: Equality) -> frozenset[str]:
    return relation.left.symbols() | relation.right.symbols()
