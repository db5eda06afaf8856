"""Inserted: a formula with the numbers of its letters put in, as at the end of a stage: ω = √(g sin θ/L) = √(9.8·0.8660/4) rad/s."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate, multiple_of, rounded_once
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import (
    ELLIPTIC,
    ONE,
    Call,
    Decimal,
    Formula,
    Integral,
    Negative,
    Number,
    Product,
    Sum,
    Symbol,
)
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import ANGLE, NONE, Dimension, DimensionError, dimension_of, printed_dimension
from rotsolve.algebra.units.quantities import parse_unit, unit_for
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.numbers import value_of
from rotsolve.core.derivation import Answer, Derivation, Equality, Move
from rotsolve.core.equation import KINETIC_ENERGY_AT, LONG_ENTRY, PART_OF_ROOTS
from rotsolve.core.letters import Given, system_told
from rotsolve.page.blocks import WITH, Amount, Math, Phrase
from rotsolve.page.values import certified_digits, machine_number

LONGEST = 72  # columns of a formula with numbers that is worth reading
MORE = 3  # digits by which numbers put in may have to be finer than what they come to
SAME = 1e-9  # beside which two numbers differ
EXACT = 6  # digits of a given that is written as it is
SEEN_THROUGH = frozenset(("sqrt", "abs", "asin", "acos", "atan", "atan2"))  # functions whose arguments are shown


VALUED = {  # laws whose letters are told with their numbers, though nobody asks for them, and their units where they have a name
    KINETIC_ENERGY_AT.name: "J",
    PART_OF_ROOTS.name: "",
    LONG_ENTRY.name: "",
}


if TYPE_CHECKING:
    from rotsolve.algebra.units.systems import UnitSystem
    from rotsolve.page.abbreviations import Abbreviation


class NotShown(ValueError):
    """A letter has no number, or an integral would have to be worked out."""


class InsertedNumbers:
    """The numbers of the letters of a derivation, step by step, with so many digits."""

    def __init__(self, derivation: Derivation, shorts: Iterable[Abbreviation], digits: int) -> None:
        self.digits = digits
        self.givens = {given.name: given.value for given in derivation.givens if given.value is not None}
        self.answers = {to_text(answer.symbol): answer for answer in derivation.answers if answer.value is not None}
        self.dimensions = {given.name: given.dimension for given in derivation.givens if given.dimension is not None}
        self.coherent = coherent_units(derivation.givens)
        self.units = {given.name: given.unit for given in derivation.givens if given.unit is not None}
        self.roots: dict[str, Certified] = {}
        self.sought: set[str] = set()  # letters whose value is being worked out: a law tells nothing by itself
        self.steps: dict[str, Formula] = {short.letter.name: short.meaning for short in shorts}
        laws = [(law.equation.left, law) for section in derivation.sections for law in section.laws]
        # by the letter that each tells, if no step does
        self.laws = {left.name: law for left, law in laws if isinstance(left, Symbol)}

    def values(self, move: Move) -> tuple[int, tuple[Amount, ...]]:
        """What a step that gives an answer comes to: with numbers put in, and the number; and behind which of its lines that stands."""
        last = move.chain[-1]
        if not isinstance(last.left, Symbol) or last.relation != "=":
            return -1, ()
        if move.sources == WITH:
            return -1, self.worth(last)
        self.steps.setdefault(last.left.name, last.right)
        answer = self.answers.get(to_text(last.left))
        law = self.laws.get(last.left.name)
        if answer is None and law is not None:
            return -1, self.valued(law.name, last)
        if answer is None or answer.formula is None or isinstance(last.right, Number) or not last.right.symbols():
            return -1, ()
        number, note = certified_digits(answer.value, self.digits)
        if not number or note or not self.comes_to(last.right, answer):
            return -1, ()
        place = self.plainest(move.chain)
        return place, (*self.shown(move.chain[place].right, answer, number), Amount(number, answer.unit))

    def meaning(self, short: Abbreviation) -> Phrase:
        """D = m + M + … = 5 kg, of a letter that the page gives to a sum."""
        one = short.equality
        return (Math((one.left, "=", one.right, *(part for value in self.worth(one) for part in ("=", value)))),)

    def valued(self, law: str, one: Equality) -> tuple[Amount, ...]:
        """The number of a letter that a law tells, where that is worth telling."""
        unit = VALUED.get(law)
        worth = () if unit is None else self.worth(one)
        return tuple(replace(amount, unit=parse_unit(unit)) for amount in worth) if unit else worth

    def worth(self, one: Equality) -> tuple[Amount, ...]:
        """The number of a sum in givens, with its unit; nothing where letters have none."""
        try:
            self.learn_dimensions(one.right)
            dimension = printed_dimension(one.right, self.dimensions)
            number, note = certified_digits(self.coherent.number(self.number(one.right), dimension), self.digits)
        except (NotShown, Undefined, DimensionError):
            return ()
        return (Amount(number, self.coherent.unit(dimension)),) if number and not note else ()

    def learn_dimensions(self, formula: Formula) -> None:
        """Learn the dimensions of letters that laws tell by others."""
        for name in sorted(formula.symbols() - self.dimensions.keys()):
            law = self.laws.get(name)
            if law is not None and name not in law.equation.right.symbols():
                self.learn_dimensions(law.equation.right)
                self.dimensions[name] = printed_dimension(law.equation.right, self.dimensions)

    def comes_to(self, formula: Formula, answer: Answer) -> bool:
        """Whether a formula has a number by now, which is that of the answer: not where a letter has another meaning."""
        assert answer.value is not None
        try:
            found = self.size(formula)
        except (NotShown, Undefined):
            return False
        value = answer.value.float * factor_of(answer)
        return abs(found - value) <= SAME * abs(value)

    def size(self, formula: Formula) -> float:
        """The value of a formula as a float: ten times as fast as a ball, where nothing is printed of it."""
        if formula.holds(*ELLIPTIC):  # in floats these are far less sure
            return self.number(formula).float
        try:
            values = {name: self.givens.get(name) or self.root(name).float for name in formula.symbols()}
            return float(value_of(formula, values))
        except (NotConfirmed, ArithmeticError, ValueError):
            return self.number(formula).float

    def plainest(self, chain: tuple[Equality, ...]) -> int:
        """The line with the shortest right side of those that tell the letter of the last one by others."""
        letter = chain[-1].left
        told = [k for k, one in enumerate(chain) if one.left == letter and not letter.symbols() & one.right.symbols()]
        return told[0] if len(told) == 1 else min(told, key=lambda k: len(to_text(chain[k].right)))

    def shown(self, formula: Formula, answer: Answer, number: str) -> tuple[Amount, ...]:
        """The formula with numbers in coherent units, and their unit; nothing where that would be no help."""
        if isinstance(formula, (Symbol, Number, Negative)) and not formula.children():
            return ()
        own = self.of_its_unit(formula, answer)
        try:
            put_in = self.in_its_unit(formula, own) if own else self.reproducing(formula, answer)
        except (NotShown, Undefined):
            return ()
        lone = isinstance(put_in.operand if isinstance(put_in, Negative) else put_in, Decimal)
        if lone and answer.unit == self.coherent.of_answer(answer):  # the number itself, if with more digits
            return ()
        text = to_text(put_in)
        if len(text) > LONGEST or text == number or not any(isinstance(node, Decimal) for node in put_in.walk()):
            return ()
        unit = answer.unit if own else None if put_in.holds(*INVERSE) else self.coherent.of_answer(answer)
        return (Amount(Product((put_in,)) if isinstance(put_in, Sum) and unit is not None else put_in, unit),)

    def of_its_unit(self, formula: Formula, answer: Answer) -> frozenset[str]:
        """The givens in the unit of an answer that is none of coherent ones, where it is in proportion to them: ¼·600 rev/min."""
        if answer.unit is None or answer.unit == self.coherent.of_answer(answer):
            return frozenset()
        own = frozenset(name for name in formula.symbols() if self.units.get(name) == answer.unit)
        alike = {name for name in formula.symbols() if self.dimensions.get(name) == answer.dimension}
        doubled = formula.substitute({name: 2 * Symbol(name) for name in own})
        told = formula.symbols() <= self.dimensions.keys()  # what steps have told comes in coherent units
        return own if told and own == alike and is_zero(doubled - 2 * formula) else frozenset()

    def in_its_unit(self, formula: Formula, own: frozenset[str]) -> Formula:
        """The formula with numbers, those of some givens in their own unit."""
        numbers: dict[str, Formula] = {}
        for name in own:
            value = simplify(self.givens[name] / self.units[name].factor)
            text = exact_decimals(value.value) if isinstance(value, Number) else None
            if text is None:
                raise NotShown
            numbers[name] = self.decimal(text, value, self.digits, NONE)
        return self.put_in(formula, self.digits, numbers)

    def reproducing(self, formula: Formula, answer: Answer) -> Formula:
        """The formula with numbers of as many digits as it takes to come to the number that is printed of the answer; of a few more where
        none do."""
        assert answer.value is not None
        factor = factor_of(answer) / (1.0 if answer.dimension is None else self.coherent.scale(answer.dimension))
        printed = to_digits(answer.value.float, self.digits)
        for digits in range(self.digits, self.digits + MORE + 1):
            put_in = self.put_in(formula, digits)
            if to_digits(worth_of(put_in) / factor, self.digits) == printed:
                return put_in
        return self.put_in(formula, self.digits)

    def put_in(self, node: Formula, digits: int, own: Mapping[str, Formula] | None = None) -> Formula:
        """A formula with decimals for its letters, for some of them their `own`; a sine or an exponential of numbers is one number."""
        if isinstance(node, Symbol) and own and node.name in own:
            return own[node.name]
        if isinstance(node, Symbol):
            return self.decimal(self.exact_text(node.name) or "", node, digits, self.dimension(node.name))
        if isinstance(node, Integral):
            raise NotShown
        if isinstance(node, Call) and (node.function not in SEEN_THROUGH or node.function in ELLIPTIC):
            return self.decimal("", node, digits, NONE)
        children = node.children()
        return node.with_children(tuple(self.put_in(child, digits, own) for child in children)) if children else node

    def exact_text(self, name: str) -> str | None:
        """The decimals of a given that are short enough to be written as they are."""
        value = self.givens.get(name)
        if not isinstance(value, Number):
            return None
        return exact_decimals(value.value / self.coherent.scale(self.dimensions.get(name, NONE)))

    def dimension(self, name: str) -> Dimension:
        """What a letter measures, as far as it makes a difference: of one that a step has told, by what that is made of."""
        if self.coherent.system is None or name in self.dimensions:
            return self.dimensions.get(name, NONE)
        law = self.laws.get(name)
        told = self.steps.get(name, None if law is None else law.equation.right)
        if told is None:
            raise NotShown
        try:
            self.dimensions[name] = dimension_of(told, {one: self.dimension(one) for one in told.symbols() - {name}})
        except DimensionError:
            raise NotShown from None
        return self.dimensions[name]

    def decimal(self, text: str, node: Formula, digits: int, dimension: Dimension) -> Formula:
        """A number for a node, with so many certified digits where it is not written as it is."""
        if not text:
            text, note = certified_digits(self.coherent.number(self.number(node), dimension), digits)
            if not text or note:
                raise NotShown
        size = Decimal(text.lstrip("−-"))
        return Negative(size) if text[0] in "−-" else size

    def number(self, node: Formula) -> Certified:
        """The value of a formula in givens and in letters that steps have told."""
        told = node.symbols() - set(self.givens)
        return evaluate(node, self.givens, roots={name: self.root(name) for name in told})

    def root(self, name: str) -> Certified:
        """The value of a letter that a step has told, or else a law does by others."""
        if name in self.sought:
            raise NotShown
        if name not in self.roots:
            law = self.laws.get(name)
            told = self.steps.get(name, None if law is None else law.equation.right)
            if told is None:
                raise NotShown
            self.sought.add(name)
            try:
                self.roots[name] = rounded_once(self.number(told))
            finally:
                self.sought.discard(name)
        return self.roots[name]


def worth_of(put_in: Formula) -> float:
    """What a formula with numbers put in comes to as it is printed."""
    numbers = {node.name: float(machine_number(node.name)) for node in put_in.walk() if isinstance(node, Decimal)}
    try:
        return float(value_of(put_in, numbers))
    except (NotConfirmed, ArithmeticError, ValueError):
        raise NotShown from None


def factor_of(answer: Answer) -> float:
    """How many coherent units the unit of an answer is."""
    factor = ONE if answer.unit is None else answer.unit.factor
    return float(factor.value) if isinstance(factor, Number) else evaluate(factor, {}).float


def to_digits(value: float, digits: int) -> str:
    return f"{value:.{digits - 1}e}"


INVERSE = frozenset(("asin", "acos", "atan", "atan2"))


def exact_decimals(value: Fraction) -> str | None:
    """A rational number as a short exact decimal: 9.8, 0.05, 12; None where it has none."""
    sign, size = "−" if value < 0 else "", abs(value)
    for places in range(EXACT + 1):
        scaled = size * 10**places
        if scaled.denominator == 1:
            digits = str(scaled.numerator).rjust(places + 1, "0")
            if len(digits.strip("0")) > EXACT or len(digits) > EXACT + 1:
                return None
            return sign + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)
    return None


class CoherentUnits(Struct, frozen=True):
    """The units in which numbers are put in: those of SI, or of the system of all givens."""

    system: UnitSystem | None

    def unit(self, dimension: Dimension) -> Unit | None:
        """That for a dimension; None for a mere number."""
        found = None
        if self.system is not None:
            from rotsolve.algebra.units.systems import unit_in

            found = unit_in(self.system, dimension)
        return found or (None if dimension == NONE else unit_for(dimension))

    def scale(self, dimension: Dimension) -> Fraction:
        """How many SI units that is."""
        unit = None if self.system is None else self.unit(dimension)
        return Fraction(1) if unit is None else unit.scale

    def number(self, number: Certified, dimension: Dimension) -> Certified:
        """A number in SI as one in these units."""
        scale = self.scale(dimension)
        return number if scale == 1 else multiple_of(number, Number(1 / scale))

    def of_answer(self, answer: Answer) -> Unit | None:
        """That in which a formula with numbers put in comes: the unit of the answer where it is one."""
        scale = Fraction(1) if answer.dimension is None else self.scale(answer.dimension)
        if answer.unit is not None and answer.unit.factor == Number(scale):
            return answer.unit
        return None if answer.dimension is None else self.unit(answer.dimension)

    def value(self, given: Given, digits: int) -> Amount | None:
        """A given in these units, with which is calculated, where its own is another measure: 600 rev/min = 62.83 rad/s; None where it is
        a tenth, a hundredth, … of it, or an angle."""
        if given.value is None or given.value.symbols() or given.dimension in (None, ANGLE, NONE):
            return None
        assert given.dimension is not None
        factor = (given.unit.factor if given.unit is not None else ONE) / Number(self.scale(given.dimension))
        if decimal_power(simplify(factor)):
            return None
        number, note = certified_digits(self.number(evaluate(given.value, {}), given.dimension), digits)
        return None if note or not number else Amount(number, self.unit(given.dimension))


def coherent_units(givens: Sequence[Given]) -> CoherentUnits:
    """Those of the system of which all givens are, mass by its force where that is basic."""
    system = system_told(givens)
    if system is None:
        return CoherentUnits(None)
    from rotsolve.algebra.units.systems import coherent

    return CoherentUnits(coherent(system))


def decimal_power(factor: Formula) -> bool:
    """Whether a factor is a power of ten."""
    if not isinstance(factor, Number):
        return False
    top, bottom = factor.value.numerator, factor.value.denominator
    return str(top * bottom).strip("0") == "1"
