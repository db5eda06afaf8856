"""Formulas: one held against the closed form that is asked: equal, right with numbers put in, of another sign or dimension.

Numbers are put in for letters in `g/3` for ⅔ g sin θ with θ = 30°, or stand there as a rounded coefficient.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from itertools import combinations, islice, product

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import Call, Formula, Negative, Number, Sum, Symbol
from rotsolve.algebra.units.dimension import DimensionError, describe, dimension_of
from rotsolve.grading.comparing.numbers import HALF, Typed, certified_number, is_near
from rotsolve.grading.comparing.scalars import (
    Same,
    Scalar,
    is_turned_by,
    lacking_unit,
    of_its_way,
    pointing_judged,
    right_but_for_sign,
    too_few,
    turns_round,
    value_judged,
)
from rotsolve.grading.verdict import RIGHT, UNDECIDED, VALUELESS, WRONG, Finding, found, listed_letters
from rotsolve.language import marks

USUAL = 1 / 100  # the share by which a rounded coefficient may change a formula, where the tolerance is no share
ROUNDED = 1 / 400  # the share by which a number put in for a letter may differ from it
MOST_WAYS = 32  # in which the numbers of a formula may be letters
MOST_PLACES = 40  # of a decimal that may be rounded
LEAST = 2  # figures of a number that may be rounded
NEARLY = 1e-12  # the share by which equal numbers may differ in floats
MOST_BITS = 500  # of precision in which two formulas are told apart by their numbers
MOST_PUT_IN = 2  # letters of a formula that are named by trying which of them make it right
NUMBERS_ALONE = "numbers alone"  # the kind of a remark on what is equal for the scene's own numbers only
EXACTLY = Fraction(1, 10**15)  # the share within which formulas with numbers put in are equal


class Put(Struct, frozen=True):
    """A formula and its closed form, written in givens, both with the numbers of the letters that do not stand in the formula."""

    typed: Formula
    closed: Formula
    missing: tuple[str, ...]


def put_in(
    closed: Formula, typed: Formula, values: Mapping[str, Formula], answers: Mapping[str, Formula]
) -> Put | None:
    """The numbers that a formula has in place of letters put into both sides: T + (2 kg) a/2, where `answers` tell T and a by givens.

    None where a letter has no number.
    """
    written = typed.substitute({name: answers[name] for name in typed.symbols() - values.keys() if name in answers})
    missing = (written.symbols() | closed.symbols()) - typed.symbols()
    if not missing <= values.keys():
        return None
    put = {name: values[name] for name in missing}
    return Put(written.substitute(put), closed.substitute(put), tuple(sorted(missing)))


def numbers_stand(typed: Formula, missing: Iterable[str], numbers: Mapping[str, float]) -> bool:
    """Whether a formula that has lost its units can have the numbers of letters in it: they stand there, or are worked into a decimal."""
    found = numbers_in(typed)
    return has_decimal(typed) or all(
        any(letters_with_number(value, {name: numbers.get(name, 0)}, USUAL) for value in found) for name in missing
    )


def numbers_in(typed: Formula) -> frozenset[Fraction]:
    """The different numbers that stand in a formula."""
    return frozenset(node.value for node in typed.walk(Number) if isinstance(node, Number))


def has_decimal(typed: Formula) -> bool:
    """Whether a number of two figures or more, not a whole one, stands in a formula: 0.67, 9.81."""
    return any(decimal_places(value) for value in numbers_in(typed))


def rounding_share(typed: Formula) -> float:
    """The share by which a formula may be off because its decimals are rounded: a unit of the last figure of each."""
    places = {value: decimal_places(value) for value in numbers_in(typed)}
    return sum(float(Fraction(1, 10**count) / abs(value)) for value, count in places.items() if count)


def decimal_places(value: Fraction) -> int:
    """The decimal places of a decimal fraction of two figures or more; 0 for any other number."""
    if 10 ** (MOST_PLACES - 1) % value.denominator:
        return 0
    places = next(count for count in range(MOST_PLACES) if 10**count % value.denominator == 0)
    digits = abs(value.numerator) * 10**places // value.denominator
    return places if len(str(digits).rstrip("0")) >= LEAST else 0


def with_letters(typed: Formula, numbers: Mapping[str, float]) -> Iterator[tuple[Formula, tuple[str, ...]]]:
    """A formula with letters for the numbers that they have, m₁ (g + a) for m₁ (9.81 + a), in all ways, and which letters these are."""
    letters = {value: letters_with_number(abs(value), numbers) for value in sorted(numbers_in(typed))}
    choices = [[(value, ""), *((value, name) for name in names)] for value, names in letters.items() if names]
    for chosen in islice(product(*choices), MOST_WAYS):
        put = {value: Symbol(name) for value, name in chosen if name}
        if put:
            yield typed.transform(partial(letter_for, put), Number), tuple(symbol.name for symbol in put.values())


def letters_with_number(value: Fraction, numbers: Mapping[str, float], share: float = ROUNDED) -> list[str]:
    """The letters that have a number, perhaps rounded."""
    try:
        size = float(value)
    except OverflowError:
        return []
    return [name for name, number in numbers.items() if number and abs(size - number) <= share * abs(number)]


def letter_for(put: Mapping[Fraction, Symbol], node: Formula) -> Formula:
    """The letter for a number, with its sign."""
    if not isinstance(node, Number) or node.value not in put:
        return node
    letter = put[node.value]
    return Negative(letter) if node.value < 0 else letter


def formula_judged(formula: Formula, direction: str, asked: Scalar, *, measured: bool = False) -> Finding:
    """The finding for a formula with the direction that words behind it tell; `measured` says that units in it tell what it measures, and
    that this is what is asked for."""
    if not (direction and asked.direction):
        finding = undirected_judged(formula, asked, measured)
        return of_its_way(finding, direction, asked) if finding.right else finding
    other = pointing_judged(direction, asked)
    if other is not None:
        return other
    turned = is_turned_by(direction, asked)
    number = certified_number(formula, asked.values)
    if number is not None and asked.value is not None and turns_round(number.float < 0, asked.value, turned):
        formula = -formula
    finding = undirected_judged(formula, asked, measured)
    if turned and any(remark.kind == "sign" for remark in finding.remarks):
        return found(WRONG, "direction", f"it points the other way: {asked.direction}")
    return finding


def undirected_judged(formula: Formula, asked: Scalar, measured: bool) -> Finding:
    """The finding for a formula by itself."""
    if asked.closed is None:
        return worked_out(formula, asked)
    holds = asked.same(formula, asked.closed)
    if holds:
        if asked.marking.form == marks.NUMBER and asked.value is not None:
            return found(RIGHT, "form", "right, but a number is wanted", flaws=(marks.FORM,))
        return Finding(RIGHT)
    if holds is None and certified_number(formula, asked.values) is None and asked.value is not None:
        return found(UNDECIDED, VALUELESS, "it has no value for the numbers of the scene")
    if holds is None:
        return found(UNDECIDED, "equality", "it agrees wherever it was tried, but that is no proof")
    misfit = "" if measured else of_other_dimension(formula, asked)
    partly = partly_numeric(formula, asked, fits=not misfit, measured=measured)
    if partly is not None or misfit:
        return partly or found(WRONG, "dimension", misfit)
    multiple = multiple_judged(formula, asked)
    if multiple is not None:
        return multiple
    if asked.same(-formula, asked.closed) or partly_numeric(-formula, asked, fits=True) is not None:
        return right_but_for_sign(asked)
    worth = equal_by_numbers(formula, asked)
    if worth is None and equal_by_numbers(-formula, asked) is not None:
        return right_but_for_sign(asked)
    return worth or Finding(WRONG)


def partly_numeric(formula: Formula, asked: Scalar, *, fits: bool, measured: bool = False) -> Finding | None:
    """The finding for a formula that is right with numbers of letters put in, or but for a rounded coefficient; else None.

    One that does not measure what is asked (`fits`) has lost the units of its numbers.
    """
    if fits:
        return put_in_for_letters(formula, asked, fits, measured) or put_in_beside(formula, asked)
    beside = put_in_beside(formula, asked)  # m (9.81 − a): what stands for g says what it is
    finding = None if beside is not None else put_in_for_letters(formula, asked, fits, measured)
    return beside if finding is None else lacking_unit(finding, asked.unit, asked)


def put_in_for_letters(formula: Formula, asked: Scalar, fits: bool, measured: bool) -> Finding | None:
    """The finding where the numbers of the letters that a formula lacks make the closed form equal to it."""
    both = None if asked.closed is None else put_in(asked.closed, formula, asked.values, asked.answers)
    if both is None or not (fits or numbers_stand(formula, both.missing, asked.numbers)):
        return None
    if not (measured or formula.symbols() <= asked.values.keys() or numbers_in(formula)):
        return None  # made of other answers alone: no number stands in it
    holds = asked.same(both.typed, both.closed) if both.missing else False
    if holds is None:  # sin 35° and its like, which exact algebra does not know
        holds = asked.close(both.typed, both.closed, EXACTLY)
    if holds:
        return with_numbers(asked, both.missing)
    if has_decimal(formula):
        share = min(Fraction(rounding_share(formula)), asked.marking.tolerance.share or Fraction(USUAL))
        if asked.close(both.typed, both.closed, share) and is_near_answer(both.typed, asked, share):
            return with_numbers(asked, both.missing, rounded=True)
    return None


def is_near_answer(formula: Formula, asked: Scalar, share: Fraction) -> bool:
    """Whether a formula is within a share of the answer for the scene's own numbers, where it has one for them."""
    number = certified_number(formula, asked.values)
    if number is None or asked.value is None:
        return True
    value = asked.in_unit(asked.si)
    return abs(number.float - value.float) <= share * abs(value.float)


def equal_by_numbers(formula: Formula, asked: Scalar) -> Finding | None:
    """The finding for a formula of givens that is another in letters, but worth exactly what is asked: 5/4 M g where M = 2 m; else None.

    Other answers may not stand in it: T = m a can be true of the numbers, and says something else than that they were put in.
    """
    closed = asked.closed
    if closed is None or not formula.symbols() or not worth_the_same(formula, closed, asked.values):
        return None
    lacks = closed.symbols() - formula.symbols()
    said = with_numbers(asked, letters_put_in(formula, closed, lacks, asked.values, asked.same))
    return replace(said, remarks=tuple(replace(one, kind=NUMBERS_ALONE) for one in said.remarks))


def worth_the_same(left: Formula, right: Formula, values: Mapping[str, Formula]) -> bool:
    """Whether both sides have one value for the scene's own numbers: the same, or none that differs in some hundred digits."""
    one, other = certified_number(left, values), certified_number(right, values)
    if one is None or other is None or abs(one.float - other.float) > NEARLY * abs(other.float):
        return False
    try:
        return bool(evaluate(left - right, values, max_precision=MOST_BITS).ball.contains(0))
    except (Undefined, ZeroDivisionError):
        return False


def letters_put_in(
    left: Formula, right: Formula, lacks: Iterable[str], values: Mapping[str, Formula], same: Same
) -> tuple[str, ...]:
    """The fewest letters with whose numbers, and those of what one side lacks, both sides are equal in all others."""
    lacks, names = frozenset(lacks), sorted(left.symbols() & right.symbols())
    for count in range(min(len(names), MOST_PUT_IN) + 1):
        for chosen in combinations(names, count):
            put = {name: values[name] for name in lacks.union(chosen)}
            if put and same(left.substitute(put), right.substitute(put)):
                return tuple(sorted(put))
    return tuple(sorted(lacks.union(names)))


def put_in_beside(formula: Formula, asked: Scalar) -> Finding | None:
    """The finding where a formula is right with letters in place of their numbers."""
    for meant, names in with_letters(formula, asked.numbers):
        if asked.closed is not None and not of_other_dimension(meant, asked) and asked.same(meant, asked.closed):
            return with_numbers(asked, names)
    return None


def multiple_judged(formula: Formula, asked: Scalar) -> Finding | None:
    """The finding for a decimal times letters, 0.343 g, that is the answer for the scene's own numbers: it is a number; else None."""
    decimals = [value for value in numbers_in(formula) if decimal_places(value)]
    if asked.value is None or len(decimals) != 1 or formula.holds(Sum, Call) or not formula.symbols():
        return None
    if not formula.symbols() <= asked.values.keys():
        return None
    decimal, places = decimals[0], decimal_places(decimals[0])
    figures = len(str(int(abs(decimal) * 10**places)))
    typed = Typed(formula.substitute(asked.values), figures)
    finding = value_judged(typed, asked.si, "", asked)
    margin = abs(HALF / (10**places * decimal)) * typed.value
    if finding is None and is_near(typed, asked.in_unit(asked.si), margin=margin):
        finding = too_few(figures)
    said = found(RIGHT, "numbers", "a number for the scene's own values").remarks
    return None if finding is None else replace(finding, remarks=(*said, *finding.remarks))


def with_numbers(asked: Scalar, names: Iterable[str], *, rounded: bool = False) -> Finding:
    """What is said of a right formula in which there are numbers of these letters."""
    listed = listed_letters(sorted(names))
    put: tuple[str | Formula, ...] = ("right with the number of ", *listed, " put in") if listed else ("right",)
    said = (*put, ", but a number in it is rounded") if rounded else put
    return found(RIGHT, "numbers", *said, flaws=(marks.FORM,) if asked.marking.form == marks.EXACT else ())


def worked_out(formula: Formula, asked: Scalar) -> Finding:
    """The finding for a formula where there is no closed form: its number is held against the one that is sought."""
    number = certified_number(formula, asked.values)
    if asked.value is None or number is None:
        return found(UNDECIDED, "equality", "there is no closed form to compare it with")
    value = Typed(formula.substitute(asked.values))
    return value_judged(value, asked.si, "", asked) or Finding(WRONG)


def of_other_dimension(formula: Formula, asked: Scalar) -> str:
    """What is said of a formula that measures something else; '' where it does not, or where that is not known."""
    if not formula.symbols() <= asked.dimensions.keys():
        return ""
    try:
        found_dimension = dimension_of(formula, asked.dimensions)
    except DimensionError as error:
        return f"its parts do not fit together: {error.message}"
    if found_dimension.matches(asked.dimension):
        return ""
    here, wanted = describe(found_dimension, article=True), describe(asked.dimension, article=True)
    return f"it measures {here}, but {wanted} is asked for"
