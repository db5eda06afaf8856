"""Voice: how one format says words, formulas and quantities. What is said is decided here once, for all formats."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Number, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.quantities import in_unit
from rotsolve.core.derivation import Answer, Equality, Words
from rotsolve.render.layout import hold

if TYPE_CHECKING:
    from rotsolve.algebra.certified.ball import Certified
    from rotsolve.algebra.units.unit_table import Unit
    from rotsolve.language.problem import Given

WRITTEN = re.compile(r"[-+−]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?")
POWER = r"(.*\d)(?:[eE]|\s*[·×]\s*10\^?)([-+−⁺⁻]?[\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)"  # compiled where there is one
TIMES = frozenset("eE·×")  # before a power of ten
RAISED = str.maketrans("+-−0123456789", "⁺⁻⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
LOWERED = str.maketrans("⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "+-0123456789")
CLOSE = ("°", "′", "″", "%")  # units that stand next to their number


class Voice(Struct, frozen=True):
    """One format's way of setting a formula, a unit, a number, prose, and mathematics within prose."""

    formula: Callable[[Formula], str]
    unit: Callable[[Unit], str]
    number: Callable[[str, str], str]
    prose: Callable[[str], str]
    math: Callable[[str], str]
    blank: str
    relations: dict[str, str]

    def words(self, words: Words) -> str:
        """Prose with formulas in it."""
        return "".join(self.prose(word) if isinstance(word, str) else self.math(self.formula(word)) for word in words)

    def relation(self, sign: str) -> str:
        """The sign between two sides."""
        return self.relations.get(sign, sign)

    def sides(self, equality: Equality) -> tuple[str, str]:
        """The left side; and the sign with the right side."""
        return self.formula(equality.left), f"{self.relation(equality.relation)} {self.formula(equality.right)}"

    def equality(self, equality: Equality) -> str:
        return " ".join(self.sides(equality))

    def quantity(self, number: str, unit: Unit | None) -> str:
        """A number and its unit; `number` is plain decimal text, as `2`, `−0.5` or `1e-3`."""
        mantissa, exponent = in_powers_of_ten(number.strip())
        exponent = exponent.translate(LOWERED).replace("−", "-").lstrip("+")
        return self.measured(self.number(mantissa, exponent), unit)

    def measured(self, said: str, unit: Unit | None) -> str:
        """A number, as it is set, with its unit behind it."""
        if unit is None or unit.text in ("", "1"):
            return said
        return said + ("" if unit.text.startswith(CLOSE) else self.blank) + self.unit(unit)

    def given(self, given: Given) -> str:
        """A given as mathematics: `m = 2 kg`, `L = 2 R`, or its letter alone where it has no value."""
        name = self.formula(Symbol(given.name))
        if given.value is None:
            return name
        return f"{name} {self.relation('=')} {self.given_value(given)}"

    def given_value(self, given: Given) -> str:
        """The number as the scene writes it, in its unit; a formula of other givens as it stands; '' without a value."""
        value = given.value
        if value is None:
            return ""
        if value.symbols():
            return self.formula(value)
        number = value if given.unit is None else in_unit(value, given.unit)
        written = WRITTEN.match(given.text.strip())
        if written and number == Number(Fraction(written[0].replace("−", "-"))):
            return self.quantity(written[0], given.unit)
        plain = to_text(number)
        if in_powers_of_ten(plain)[1]:
            return self.quantity(plain, given.unit)
        return self.measured(self.formula(number), given.unit)

    def amount(self, answer: Answer, digits: int) -> str:
        """The certified value of an answer with its unit; '' without one."""
        text, _ = certified(answer, digits)
        return self.quantity(text, answer.unit) if text else ""

    def aside(self, answer: Answer, digits: int) -> str:
        """What is said behind an answer: its direction and its word, and in brackets its remark and what is not certain."""
        direction = ", at ".join(part for part in (answer.direction, slope(answer, digits)) if part)
        if direction and certified(answer, digits)[0].startswith("−"):
            direction = f"i.e. {direction}"  # what the minus says, not one more reversal
        said = "".join(f", {self.prose(text)}" for text in (direction, answer.word) if text)
        notes = (self.prose(certified(answer, digits)[1]), self.words(answer.remark))
        return said + "".join(f" ({note})" for note in notes if note)


def slope(answer: Answer, digits: int) -> str:
    """The angle of a slanted vector: "53.13° to the horizontal"."""
    return f"{figures(answer.angle, digits)[0]}° to the horizontal" if answer.angle is not None else ""


def shown_components(answer: Answer) -> tuple[Answer, ...]:
    """The parts of an answer that a reader should see."""
    return () if answer.brief else answer.components


def certified(answer: Answer, digits: int) -> tuple[str, str]:
    """The digits of an answer, and a note where fewer of them can be certified than were asked for."""
    return figures(answer.value, digits)


def figures(value: Certified | None, digits: int) -> tuple[str, str]:
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
        return "", f"≈ {text}, not certified: {within}"
    return text, "" if sure == digits else f"only {sure} {'digit' if sure == 1 else 'digits'} can be certified"


def exact(answer: Answer) -> Formula | None:
    """The exact form where it says more than the number: not for a mere number that has a unit."""
    unit = "" if answer.unit is None else answer.unit.text
    return None if isinstance(answer.formula, Number) and unit not in ("", "1") else answer.formula


def shown(givens: tuple[Given, ...]) -> Iterator[Given]:
    """The givens that a reader should see: not those asked for, nor letters that the scene never mentions."""
    for given in givens:
        if not given.asked and not (given.automatic and given.value is None):
            yield given


def lettered(words: tuple[Words, ...]) -> bool:
    """Whether every item is a mere formula, so that commas separate them well enough."""
    return all(len(item) == 1 and isinstance(item[0], Formula) for item in words)


def _text_number(mantissa: str, exponent: str) -> str:
    mantissa = mantissa.replace("-", "−")
    return f"{mantissa}×10{exponent.translate(RAISED)}" if exponent else mantissa


TEXT = Voice(to_text, lambda unit: unit.text, _text_number, str, hold, " ", {})


def machine_number(text: str) -> str:
    """A printed number as programs read it: `-4.5e-05` for `−4.5×10⁻⁵`."""
    mantissa, exponent = in_powers_of_ten(text)
    return (f"{mantissa}e{exponent.translate(LOWERED)}" if exponent else mantissa).replace("−", "-")


def in_powers_of_ten(number: str) -> tuple[str, str]:
    """A number in front of its power of ten, and the exponent; '' without one."""
    match = None if TIMES.isdisjoint(number) else re.fullmatch(POWER, number)
    return (match[1], match[2]) if match else (number, "")
