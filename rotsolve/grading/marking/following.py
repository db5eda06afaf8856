"""Following: whether an answer is right given the student's own earlier ones.

Two kinds of relations between answers are tried: the laws of the scene, with the student's values for the answers in them; and what an
answer is when a given is eliminated by an earlier one: a = 2 m g/(2 m + M) and T = m M g/(2 m + M) make T = ½ M a.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import cached_property
from itertools import combinations, islice, product
from math import floor, log10

from msgspec import Struct

from rotsolve.algebra.certified.balls import RealBalls, Undefined
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import Formula, Integral, Symbol
from rotsolve.core.derivation import Equality
from rotsolve.core.remembered import remembered
from rotsolve.grading.comparing.numbers import HALF, Typed, certified_number
from rotsolve.grading.comparing.scalars import Same
from rotsolve.grading.marking.target import SceneLetters
from rotsolve.language.marks import Tolerance

LONGEST = 32  # nodes of a closed form in which a given is eliminated
MOST_FORMS = 4  # ways in which a letter is told by others
MOST_EARLIER = 4  # answers of which two together are put in
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


class Following:
    """The relations between the answers of a scene, each found when it is first needed."""

    def __init__(self, letters: SceneLetters, same: Same) -> None:
        self.letters = letters
        self.same = same

    def follows(self, name: str, given: Own, earlier: Mapping[str, Own], tolerance: Tolerance) -> tuple[str, ...]:
        """The earlier answers from which an answer follows; nothing where it follows from none."""
        for relation in self.relations(name, earlier):
            own = {other: one for other, one in earlier.items() if other in relation_letters(relation)}
            if not own or self._holds(relation, name, given, {}, tolerance):
                continue  # it says nothing of what went wrong
            if self._holds(relation, name, given, own, tolerance):
                return tuple(own)
        return ()

    def relations(self, name: str, earlier: Mapping[str, Own]) -> Iterator[Equality]:
        """All relations that tell an answer by some of these, by fewer of them first."""
        yield from self.laws(name)
        for count in (1, 2):
            for others in combinations(islice(earlier, MOST_EARLIER), count):
                yield from (Equality(form, Symbol(name)) for form in self.eliminated(name, others))

    @remembered
    def laws(self, name: str) -> tuple[Equality, ...]:
        """The laws that speak of an answer, in letters of answers and givens."""
        letters = ((law, relation_letters(law) & self.letters.answers) for law in self.told)
        return tuple(dict.fromkeys(law for law, names in letters if name in names and len(names) > 1))

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

    @remembered
    def eliminated(self, name: str, others: tuple[str, ...]) -> tuple[Formula, ...]:
        """An answer by others and the rest of the givens, where that is half as long as its closed form: what is longer nobody uses."""
        closed = self.letters.closed
        whole = [closed[one] for one in (name, *others) if one in closed]
        if len(whole) != 1 + len(others) or any(length(form) > LONGEST for form in whole):
            return ()
        found = []
        for form in dict.fromkeys(self._eliminate(closed[name], [(other, closed[other]) for other in others])):
            try:
                short = simplify(form, positive=self.letters.positive)
            except (ValueError, ArithmeticError):
                continue
            if 2 * length(short) <= length(closed[name]) and short.symbols() >= set(others):
                found.append(short)
        return tuple(dict.fromkeys(found))

    def _eliminate(self, wanted: Formula, others: list[tuple[str, Formula]]) -> Iterator[Formula]:
        """A formula with a given eliminated for each of the others, whichever it can be."""
        if not others:
            yield wanted
            return
        (other, known), *rest = others
        if wanted.holds(Integral) or known.holds(Integral):
            return
        for given in sorted(wanted.symbols() & known.symbols()):
            value = self._solved(other, known, given)
            if value is not None:
                put = {given: value}
                yield from self._eliminate(wanted.substitute(put), [(one, form.substitute(put)) for one, form in rest])

    def _solved(self, other: str, known: Formula, given: str) -> Formula | None:
        """A given by an answer: of a speed by its square, since the given stands within a root."""
        tried = (linear_root(known**power - Symbol(other) ** power, given) for power in (1, 2))
        return next((value for value in tried if value is not None), None)

    # whether a relation holds with what the student wrote

    def _holds(
        self, relation: Equality, name: str, given: Own, earlier: Mapping[str, Own], tolerance: Tolerance
    ) -> bool:
        """Whether a relation is true of the student's own values, with the right ones for all else."""
        if given.numeric:
            return self._crosses(relation, name, given, earlier, tolerance)
        own = {other: one.value for other, one in earlier.items() if not one.numeric}
        if len(own) < len(earlier):
            return False
        put = {**own, name: given.value}
        left, right = (self._with_true(side, put) for side in (relation.left, relation.right))
        return bool(self.same(left, right))

    def _with_true(self, side: Formula, own: Mapping[str, Formula]) -> Formula:
        """A side with the student's formulas, and the closed forms of the answers that they do not tell."""
        return side.substitute({**{name: form for name, form in self.letters.closed.items() if name not in own}, **own})

    def _crosses(
        self, relation: Equality, name: str, given: Own, earlier: Mapping[str, Own], tolerance: Tolerance
    ) -> bool:
        """Whether left − right changes its sign within the tolerance round the number, and within the rounding of the earlier ones."""
        values = self.letters.values
        numbers = {other: certified_number(one.value, values) for other, one in earlier.items()}
        number = certified_number(given.value, {})
        if number is None or not number.float or None in numbers.values():
            return False
        margin = self._margin(tolerance, number.float)
        sides = [(number.float - margin, number.float + margin)]
        for other, one in earlier.items():
            half = certified_number(one.half, {}) if one.half is not None else None
            middle, reach = numbers[other].float, 0.0 if half is None else half.float  # type: ignore[union-attr]
            sides.append((middle - reach, middle + reach))
        own = {letter: Symbol(letter) for letter in (name, *earlier)}
        residue = self._with_true(relation.left - relation.right, own)
        signs = set()
        for corner in product(*sides):
            bound = dict(zip((name, *earlier), map(arb, corner), strict=True))
            try:
                gap = RealBalls(values, bound=bound)(residue)
            except (Undefined, ZeroDivisionError):
                return False
            if not gap.is_finite():
                return False  # the relation has a pole there, and says nothing
            signs.add(0 if gap.contains(0) else 1 if gap > 0 else -1)
        return 0 in signs or len(signs) > 1

    def _margin(self, tolerance: Tolerance, number: float) -> float:
        """How far the number may be off, in SI units."""
        if tolerance.share is not None:
            return abs(number) * float(tolerance.share)
        if tolerance.amount is not None:
            amount = certified_number(tolerance.amount, {})
            return 0.0 if amount is None else amount.float
        return float(HALF) * 10.0 ** (floor(log10(abs(number))) - (tolerance.figures or 1) + 1)


def linear_root(residue: Formula, letter: str) -> Formula | None:
    """The letter for which a residue is zero; None where it is not linear in it, or too hard."""
    try:
        return solve_linear(residue, letter)
    except (ValueError, ArithmeticError):
        return None


def relation_letters(relation: Equality) -> frozenset[str]:
    return relation.left.symbols() | relation.right.symbols()
