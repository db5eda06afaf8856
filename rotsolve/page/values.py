"""Values: how givens and answers stand on a page: a given as the scene wrote it, an answer with its exact form and certified digits."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import takewhile
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Negative, Number, Quotient, Sum, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.quantities import number_in_unit
from rotsolve.core.derivation import Answer, Words
from rotsolve.page.blocks import Amount, AnswerRow, Math, Matrix, Phrase, equation, joined_phrases
from rotsolve.page.printer import LOWERED, in_powers_of_ten

if TYPE_CHECKING:
    from rotsolve.algebra.certified.ball import Certified
    from rotsolve.language.problem import Given

WRITTEN = frozenset("+-−.eE0123456789")  # letters of a decimal number


def given_equation(given: Given) -> Math:
    """A given as mathematics: m = 2 kg, L = 2 R, or its letter alone where it has no value."""
    value = given_value(given)
    return Math((Symbol(given.name),) if value is None else (Symbol(given.name), "=", value))


def given_value(given: Given) -> Formula | Amount | None:
    """The number as the scene writes it, in its unit; a formula of other givens as it stands; None without a value."""
    value = given.value
    if value is None or value.symbols():
        return value
    number = value if given.unit is None else number_in_unit(value, given.unit)
    written = _decimal_prefix(given.text.strip())
    if written and number == Number(Fraction(written.replace("−", "-"))):
        return Amount(written, given.unit)
    plain = to_text(number)
    return Amount(plain if in_powers_of_ten(plain)[1] else number, given.unit)


def _decimal_prefix(text: str) -> str:
    """The decimal number that a text begins with: `1e-3` of `1e-3 kg`; '' where it is none."""
    written = "".join(takewhile(WRITTEN.__contains__, text)).rstrip("+-−eE")
    try:
        Fraction(written.replace("−", "-"))
    except ValueError:
        return ""
    return written


def shown_givens(givens: tuple[Given, ...]) -> Iterator[Given]:
    """The givens that a reader should see: not those asked for, nor letters that the scene never mentions."""
    for given in givens:
        if not given.asked and not (given.automatic and given.value is None):
            yield given


def only_letters(phrases: tuple[Words, ...]) -> bool:
    """Whether every phrase is a mere formula, so that commas separate them well enough."""
    return all(len(phrase) == 1 and isinstance(phrase[0], Formula) for phrase in phrases)


def answer_row(answer: Answer, digits: int, alike: Sequence[Answer] = ()) -> AnswerRow:
    """An answer: its exact form, its certified number, where it points, what is not certain of it, and when it holds, as those `alike`."""
    number, note = certified_digits(answer.value, digits)
    pointing = () if answer.conditions else answer.pointing  # what holds in a case alone may tell it
    held = {name for one in answer.conditions for name in one.left.symbols() | one.right.symbols()}
    spoken_of = {name for part in answer.leading if isinstance(part, Formula) for name in part.symbols()}
    leading = () if held & spoken_of else answer.leading  # a case may be one in which nothing is small
    phrases = ((note,) if note else (), leading, answer.remark, pointing, holding_if(answer, *alike))
    notes = tuple(phrase for phrase in phrases if phrase)
    asides = tuple(text for text in (_pointing(answer, number, digits), answer.word) if text)
    if answer.rows:
        entries = [(part.symbol, part.formula) for part in answer.components if part.formula is not None]
        shown = tuple(AnswerRow(symbol, (formula,)) for symbol, formula in entries if formula != ZERO)
        notes = (*notes, *_unsure(answer, digits))
        return AnswerRow(answer.symbol, _matrices(answer, digits), asides, notes, shown, matrix=True)
    formula = _exact_form(answer)
    forms = (*((formula,) if formula is not None else ()), *((Amount(number, answer.unit),) if number else ()))
    components = () if answer.brief else tuple(answer_row(part, digits) for part in answer.components)
    return AnswerRow(answer.symbol, forms, asides, notes, components)


def answer_rows(answer: Answer, digits: int) -> Iterator[AnswerRow]:
    """An answer, and what it is in other cases; once where it is the same in several."""
    left = [answer, *answer.otherwise]
    while left:
        alike = [one for one in left if unconditional(one) == unconditional(left[0])]
        yield answer_row(left[0], digits, alike[1:])
        left = [one for one in left[1:] if not any(one is other for other in alike)]


def unconditional(answer: Answer) -> Answer:
    """An answer without what it holds under."""
    return replace(answer, conditions=(), otherwise=())


def holding_if(*answers: Answer) -> Phrase:
    """The conditions under which an answer holds, in one case or in another: "if P ≤ μ m g, or if M < m"."""
    cases = (joined_phrases(((equation(one),) for one in answer.conditions), " and ") for answer in answers)
    return ("if ", *joined_phrases(cases, ", or if ")) if all(answer.conditions for answer in answers) else ()


def _matrices(answer: Answer, digits: int) -> tuple[Matrix, ...]:
    """The exact entries of a matrix, unless they are mere numbers or one is missing, and its numbers, unless none has one."""
    exact = [[part.formula for part in row if part.formula is not None] for row in answer.rows]
    parts = [part for row in answer.rows for part in row]
    symbolic = any(part.formula is not None and part.formula.symbols() for part in parts)
    boxes: list[tuple[tuple[Formula | Amount, ...], ...]] = []
    if symbolic and sum(map(len, exact)) == len(parts):
        boxes.append(tuple(map(tuple, exact)))
    # nothing but a 0 has a number where all else stays in letters
    if any(part.value is not None and part.formula != ZERO for part in parts) or not boxes:
        boxes.append(tuple(tuple(_entry(part, digits) for part in row) for row in answer.rows))
    return tuple(Matrix(rows, answer.unit if rows is boxes[-1] else None) for rows in boxes)


def _entry(part: Answer, digits: int) -> Formula | Amount:
    """An entry of a matrix as a number: as far as it is known where no digit is certain, else its exact form."""
    number, note = certified_digits(part.value, digits)
    if not number and part.formula is not None and part.value is None:
        return part.formula
    return Amount(number or note.partition(",")[0] or "?")


def _unsure(answer: Answer, digits: int) -> Iterator[Phrase]:
    """What is not certain of the entries of a matrix."""
    for part in (part for row in answer.rows for part in row):
        note = certified_digits(part.value, digits)[1]
        if note:
            yield (part.symbol, " ", note)


def _pointing(answer: Answer, number: str, digits: int) -> str:
    """The direction of an answer, and of a slanted vector the angle: "up, at 53.13° to the horizontal"."""
    if not answer.direction and answer.angle is None:
        return ""
    angle = certified_digits(answer.angle, digits)[0]
    parts = (answer.direction, f"{angle}° to the horizontal" if answer.angle is not None else "")
    said = ", at ".join(filter(None, parts))
    less = number.startswith("−") or (not number and answer.formula is not None and begins_with_less(answer.formula))
    return f"({said})" if said and less else said  # what the minus says, not one more reversal


def begins_with_less(formula: Formula) -> bool:
    """Whether a minus stands before all else: −x, −x + y, −x/y."""
    first = formula.terms[0] if isinstance(formula, Sum) else formula
    first = first.numerator if isinstance(first, Quotient) else first
    return isinstance(first, Negative)


def _exact_form(answer: Answer) -> Formula | None:
    """The exact form where it says more than the number: not for a mere number that has a unit."""
    unit = "" if answer.unit is None else answer.unit.text
    return None if isinstance(answer.formula, Number) and unit not in ("", "1") else answer.formula


def certified_digits(value: Certified | None, digits: int) -> tuple[str, str]:
    """The certified digits of a number, and a note where fewer of them are sure than were asked for, or none."""
    from rotsolve.algebra.certified.balls import Undefined

    if value is None:
        return "", ""
    try:
        text, sure = value.figures(digits)
    except Undefined as reason:
        return "", f"no number: {reason}"
    if not sure:
        within = "nothing tells it from 0" if value.sign is None else "its bounds are too wide at the highest precision"
        return "", f"≈ {text if value.sign is not None else 0}, not certified: {within}"
    return text, "" if sure == digits else f"only {sure} {'digit' if sure == 1 else 'digits'} can be certified"


def machine_number(text: str) -> str:
    """A printed number as programs read it: `-4.5e-05` for `−4.5×10⁻⁵`."""
    mantissa, exponent = in_powers_of_ten(text)
    return (f"{mantissa}e{exponent.translate(LOWERED)}" if exponent else mantissa).replace("−", "-")
