"""Ball: certified numbers. Precision is doubled until the digits asked for are sure; what can't be is never printed.

A witness remembers which numbers a piece of work has asked for: with other numbers of the same signs it takes the same way.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from functools import partial
from math import floor
from typing import Any

from msgspec import Struct, field

from rotsolve.algebra.certified.balls import Ball, RealBalls, Undefined, Values, with_values
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.flints import arb, context
from rotsolve.algebra.formula import Formula, Integral, Number, Symbol, formula
from rotsolve.profile import of_kind


class Witness:
    """The formulas whose numbers were asked for; `by_size` where more of a number than its sign has decided something."""

    def __init__(self) -> None:
        self.asked: dict[Formula, None] = {}
        self.supposed: dict[Formula, int] = {}  # signs at the numbers of one case, of letters that have none
        self.needed: dict[
            Formula, tuple[int, object]
        ] = {}  # those of what the answers need to hold, and what is said where it fails
        self.by_size = False


OPEN: list[Witness] = []
MOST_DIGITS = 1000  # that can be asked for


@contextmanager
def witnessed() -> Iterator[Witness]:
    """Note all that numbers are asked for meanwhile."""
    witness = Witness()
    OPEN.append(witness)
    try:
        yield witness
    finally:
        OPEN.pop()


@contextmanager
def witnessed_apart() -> Iterator[Witness]:
    """Note all that numbers are asked for meanwhile, without a word to those who watch: `pass_on` tells them."""
    others, witness = OPEN[:], Witness()
    OPEN[:] = [witness]
    try:
        yield witness
    finally:
        OPEN[:] = others


def pass_on(noted: Witness) -> None:
    """Tell those who watch what has been noted apart."""
    for witness in OPEN:
        witness.asked.update(noted.asked)
        witness.by_size |= noted.by_size
        witness.supposed = {**noted.supposed, **witness.supposed}
        witness.needed = {**noted.needed, **witness.needed}


def watched() -> bool:
    """Whether anyone wants to know."""
    return bool(OPEN)


def note(value: Formula, *, by_size: bool = False) -> None:
    """The number of a formula is asked for."""
    for witness in OPEN:
        witness.asked[value] = None
        witness.by_size |= by_size


def need(value: Formula, sign: int, failing: object) -> None:
    """A formula of letters has this sign in the case that is looked at, and has to be positive for the answers to hold."""
    for witness in OPEN:
        witness.needed.setdefault(value, (sign, failing))


def suppose(value: Formula, sign: int) -> None:
    """A formula of letters has this sign at the numbers of the case that is looked at."""
    for witness in OPEN:
        witness.supposed.setdefault(value, sign)


def decided_by_size() -> None:
    """Something is decided by the size of a number, or by where the roots of an equation lie."""
    for witness in OPEN:
        witness.by_size = True


BITS_PER_DIGIT = 3.3219280948873626
INTEGRAL_LIMIT = 400  # bits: beyond this an integral costs more than it is worth
ROUNDS = 8  # times that the precision is doubled for the digits of one number
FINER = 40  # digits more, with which a number is told from another before exact algebra is asked
UNSURE = 3  # digits of a number of which none is certified
DECADES = 100_000  # of ten: a number of a size beyond is not written down
LARGEST, TINIEST = arb(10) ** DECADES, arb(10) ** -DECADES
EXACT_FROM = 256  # bits: from here on a value that may be zero is tested exactly


class Precision:
    """Context manager that sets flint's working precision in bits."""

    __slots__ = ("bits", "old")

    def __init__(self, bits: int) -> None:
        self.bits = bits

    def __enter__(self) -> None:
        self.old = context.prec
        context.prec = self.bits

    def __exit__(self, *_: object) -> None:
        context.prec = self.old


class Certified(Struct, frozen=True, dict=True):
    """A real number known to be inside a ball, with the means to know it better, which are such as can be pickled."""

    ball: Ball
    refine: Callable[[int], Ball]  # digits -> a ball with that relative accuracy, or the best there is
    equals: Callable[[Fraction], bool]  # whether the number is exactly this

    @property
    def sign(self) -> int | None:
        """−1, 0 or 1; None where the ball does not tell."""
        if self.ball.is_zero():
            return 0
        return 1 if self.ball > 0 else -1 if self.ball < 0 else None

    @property
    def float(self) -> float:
        return float(self.ball.mid())

    @property
    def digits_certified(self) -> int:
        """The significant decimal digits that the ball settles."""
        if self.ball.is_exact():
            return 10**6
        return max(0, int(self.ball.rel_accuracy_bits() / BITS_PER_DIGIT))

    def text(self, digits: int = 4) -> str:
        """The number to so many significant digits, correctly rounded; short where it is exact: `4.9`, `4.900`.

        Undefined where the digits can not be certified.
        """
        text, sure = self.figures(digits)
        if sure < digits:
            raise Undefined(f"{digits} digits can not be certified")
        return text

    def figures(self, digits: int) -> tuple[str, int]:
        """The number to as many of these digits as can be certified, and how many these are; 0 with what is known of it, sure or not."""
        key = f"figures {digits}"  # a page prints a number in its step and among its answers
        if key not in self.__dict__:
            self.__dict__[key] = self._figures(digits)
        found: tuple[str, int] = self.__dict__[key]
        return found

    def _figures(self, digits: int) -> tuple[str, int]:
        ball, wanted = self.ball, max(digits + 6, 15)
        finest: list[Ball] = []

        def is_exactly(number: Fraction) -> bool:
            """Whether this is a number that lies in its ball: most are told apart by a finer one, where exact algebra may take minutes."""
            if not finest:
                finest.append(self._finer(digits + FINER))
            low, high = ends(finest[0])
            return low <= number <= high and self.equals(number)

        for _ in range(ROUNDS):
            text = agreed_text(ball, digits, is_exactly)
            if text is not None:
                return text, digits
            wanted *= 2
            finer = self._finer(wanted)
            if finer.rel_accuracy_bits() <= ball.rel_accuracy_bits():
                break  # it is known no better
            ball = finer
        for fewer in range(digits - 1, 0, -1):
            text = agreed_text(ball, fewer, is_exactly)
            if text is not None:
                return text, fewer
        return decimal_text(ball.mid(), digits=UNSURE), 0

    def _finer(self, digits: int) -> Ball:
        """A ball of so many digits; the one that is known where there is none."""
        try:
            return self.refine(digits)
        except Undefined:
            return self.ball


def agreed_text(ball: Ball, digits: int, is_exactly: Callable[[Fraction], bool]) -> str | None:
    """The text on which both ends of a ball agree, an exact tie rounded away from zero; None where they do not."""
    low, high = ends(ball)
    if low == high == 0:
        return "0"
    if low * high <= 0:
        return None
    first, last = rounded(low, digits), rounded(high, digits)
    if first == last:
        candidate = value_of(first, digits)
        return decimal_notation(*first, digits, low <= candidate <= high and is_exactly(candidate))
    tie = value_of(rounded((low + high) / 2, digits + 1), digits + 1)
    if low <= tie <= high and is_exactly(tie):
        return decimal_notation(*rounded(tie, digits), digits, False)
    return None


def ends(ball: Ball) -> tuple[Fraction, Fraction]:
    """Both ends of a ball as exact fractions; Undefined where they are too large or too small to be written down."""
    if ball.is_zero():
        return Fraction(0), Fraction(0)
    if not ball.is_finite() or not TINIEST < ball.abs_upper() < LARGEST:
        raise Undefined(f"its size is beyond 10^±{DECADES}")
    middle, radius = _exact(ball.mid()), _exact(ball.rad())
    return middle - radius, middle + radius


def _exact(point: Ball) -> Fraction:
    mantissa, exponent = (int(part) for part in point.man_exp())
    return Fraction(mantissa << exponent) if exponent >= 0 else Fraction(mantissa, 1 << -exponent)


def rounded(value: Fraction, digits: int) -> tuple[int, int]:
    """Signed mantissa of so many digits and the exponent of its first digit; a half is rounded away from zero."""
    top, bottom = abs(value.numerator), value.denominator
    if not top:
        return 0, 0
    exponent = floor((top.bit_length() - bottom.bit_length() + 1) / BITS_PER_DIGIT)
    while top * 10 ** max(0, -exponent) < bottom * 10 ** max(0, exponent):
        exponent -= 1
    places = digits - 1 - exponent
    top, bottom = top * 10 ** max(0, places), bottom * 10 ** max(0, -places)
    mantissa = (2 * top + bottom) // (2 * bottom)
    if mantissa == 10**digits:
        mantissa, exponent = mantissa // 10, exponent + 1
    return (-mantissa if value < 0 else mantissa), exponent


def value_of(mark: tuple[int, int], digits: int) -> Fraction:
    """The decimal number with this mantissa and exponent."""
    return mark[0] * Fraction(10) ** (mark[1] - digits + 1)


def decimal_notation(mantissa: int, exponent: int, digits: int, exact: bool) -> str:
    """A decimal as text: plain between 10⁻⁴ and 10⁶, else with a power of ten; trailing zeros go where it is exact."""
    sign = "−" if mantissa < 0 else ""
    figures = str(abs(mantissa))
    if exact:
        figures = figures.rstrip("0") or "0"
    if exponent >= 6 or exponent < -4:
        power = str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        shown = figures if len(figures) == 1 else f"{figures[0]}.{figures[1:]}"
        return f"{sign}{shown}×10{power}"
    if exponent < 0:
        return f"{sign}0.{'0' * (-exponent - 1)}{figures}"
    if len(figures) <= exponent + 1:
        return sign + figures + "0" * (exponent + 1 - len(figures))
    return f"{sign}{figures[: exponent + 1]}.{figures[exponent + 1 :]}"


def evaluate(
    f: Formula,
    values: Values,
    *,
    roots: Mapping[str, Certified] | None = None,
    digits: int = 15,
    max_precision: int = 20000,
) -> Certified:
    """The value of the formula with that many certified digits, or the best ball within the highest precision.

    `roots` are letters without a closed form, known as closely as it takes.
    """
    note(f, by_size=bool(roots))
    known = {name: value if isinstance(value, Formula) else formula(value) for name, value in values.items()}
    found = roots or {}
    ball = _enclose(f, known, digits, max_precision, found)
    refine = partial(_enclose, f, known, max_precision=max_precision, roots=found)
    return Certified(ball, refine, partial(_is_number, f, known))


def _is_number(f: Formula, values: Mapping[str, Formula], number: Fraction) -> bool:
    """Whether a formula is worth exactly this."""
    return is_zero(with_values(f, values) - number)


class Remembered(Struct):
    """What refines a number, which works each accuracy out once."""

    refine: Callable[[int], Ball]
    found: dict[int, Ball] = field(default_factory=dict)

    def __call__(self, digits: int) -> Ball:
        if digits not in self.found:
            self.found[digits] = self.refine(digits)
        return self.found[digits]


def rounded_once(number: Certified) -> Certified:
    """A certified number that works each accuracy out once: what many others are made of."""
    return Certified(number.ball, Remembered(number.refine), number.equals)


def multiple_of(number: Certified, factor: Formula) -> Certified:
    """A certified number times a factor without letters, as closely as the number is known."""
    letter = Symbol("#number")
    return evaluate(letter * factor, {}, roots={letter.name: number})


def _zero(f: Formula, values: Values) -> bool:
    """Whether the value is exactly zero."""
    from rotsolve.algebra.exact.cyclotomic import vanishes_by_turns

    try:
        value = with_values(f, values)
        return is_zero(value) or vanishes_by_turns(value)
    except ZeroDivisionError as error:
        raise Undefined("division by zero") from error


@of_kind("certification")
def _enclose(
    f: Formula, values: Mapping[str, Formula], digits: int, max_precision: int, roots: Mapping[str, Certified]
) -> Ball:
    needed = int(digits * BITS_PER_DIGIT) + 3
    bits = needed + 24
    asked = False
    best: Ball = None
    while True:
        settle = (lambda node: _zero(node, values)) if bits >= EXACT_FROM else None
        bound = {name: root.refine(int(bits / BITS_PER_DIGIT)) for name, root in roots.items()}
        with Precision(bits):
            ball = RealBalls(values, bound=bound, is_zero=settle)(f)
        if ball.is_zero() or (ball.is_finite() and ball.rel_accuracy_bits() >= needed):
            return ball
        best = ball if ball.is_finite() else best
        if not asked and bits >= EXACT_FROM and ball.contains(0):
            asked = True
            if _zero(f, values):
                return arb(0)
        bits *= 2
        if bits > max_precision or (
            bits > INTEGRAL_LIMIT + 2 * needed and any(g.holds(Integral) for g in (f, *values.values()))
        ):
            if best is None:
                raise Undefined("no finite value was found within the highest precision")
            return best


def decimal_text(value: Any, values: Values | None = None, digits: int = 4) -> str:
    """A formula, certified number or ball in decimals: `4.356`, `0.45`, `7.272×10⁻⁵`."""
    if isinstance(value, (int, Fraction)):
        value = Number(Fraction(value))
    if isinstance(value, Formula):
        value = evaluate(value, values or {}, digits=max(digits + 6, 15))
    if isinstance(value, Certified):
        return value.text(digits)
    ball = value
    number = _exact(ball) if ball.is_exact() else None
    return Certified(ball, lambda _: ball, lambda other: number == other).text(digits)


def refuse_digits(digits: int) -> None:
    """TypeError or ValueError for what is no number of digits."""
    if not isinstance(digits, int):
        raise TypeError(f"digits are a whole number, not {digits!r}")
    if not 1 <= digits <= MOST_DIGITS:
        raise ValueError(f"from 1 to {MOST_DIGITS} digits can be asked for, not {digits}")
