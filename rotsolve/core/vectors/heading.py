"""Heading and Vector: directions in the plane as angles, so that components come out as a textbook writes them (m g sin β).

A heading is measured counterclockwise from the rightward horizontal. Vectors are sums of size × unit vector(heading).
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import (
    HALF,
    ONE,
    PI,
    ZERO,
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    add,
    negate,
    sqrt,
)

ANGLES = 360  # of which the cosines are remembered
WHOLE = [Fraction(degrees) for degrees in range(360)]
_COSINE: dict[int | Fraction, Formula] = {  # exact cosines of the first quadrant, degrees
    Fraction(0): ONE,
    Fraction(30): sqrt(Number(Fraction(3))) / 2,
    Fraction(45): sqrt(Number(Fraction(2))) / 2,
    Fraction(60): HALF,
    Fraction(90): ZERO,
}


class Heading(Struct, frozen=True):
    """degrees + Σ coefficient × angle, with the angles as formulas (mostly symbols)."""

    degrees: Fraction = Fraction(0)
    terms: tuple[tuple[Formula, Fraction], ...] = ()

    def __add__(self, other: Heading) -> Heading:
        degrees = self.degrees + other.degrees if other.degrees else self.degrees
        return _heading(degrees, (*self.terms, *other.terms)) if self.terms or other.terms else Heading(degrees)

    def __neg__(self) -> Heading:
        return Heading(-self.degrees, tuple((angle, -factor) for angle, factor in self.terms))

    def __sub__(self, other: Heading) -> Heading:
        return self + (-other)

    def turned(self, degrees: int | Fraction) -> Heading:
        if isinstance(degrees, int) and self.degrees.denominator == 1:
            return Heading(WHOLE[(self.degrees.numerator + degrees) % 360], self.terms)
        return Heading((self.degrees + degrees) % 360, self.terms)

    def cos(self) -> Formula:
        """cos of the heading: exact for the usual degrees, quarter turns turned into sin and signs."""
        return self._cosine(0)

    def sin(self) -> Formula:
        return self._cosine(-90)

    def _cosine(self, shift: int) -> Formula:
        if not self.terms:
            whole = self.degrees.denominator == 1
            return (_sine_of_degrees if shift else _cosine_of_degrees)(
                self.degrees.numerator if whole else self.degrees
            )
        degrees = (self.degrees + shift) % 360
        terms, quarter = self.terms, round(degrees / 90)
        rest = degrees - 90 * quarter
        flipped = terms[0][1] < 0
        if flipped:  # the sign of the leading angle is pulled out: cos(−x) = cos x, sin(−x) = −sin x
            terms, rest = tuple((angle, -factor) for angle, factor in terms), -rest
        exact = _of_slope(terms, rest, quarter)
        if exact is not None:
            return negate(exact) if flipped and quarter % 2 else exact
        only = terms[0] if len(terms) == 1 and not rest else None
        if only is not None and only[1] == 1 and isinstance(only[0], Call) and only[0].function == "asin":
            sine = only[0].arguments[0]  # sin(arcsin x) = x
            value = sine if quarter % 2 else sqrt(ONE - sine**2)
            minus = quarter % 4 in (1, 2)
            return negate(value) if minus != (flipped and quarter % 2 == 1) else value
        argument = Heading(rest, terms).formula()
        function = "cos" if quarter % 2 == 0 else "sin"
        # cos(x + 90°) = −sin x, cos(x + 180°) = −cos x, cos(x + 270°) = sin x
        minus = quarter % 4 in (1, 2)
        if flipped and function == "sin":
            minus = not minus
        value = Call(function, (argument,))
        return negate(value) if minus else value

    def formula(self) -> Formula:
        """The heading as a formula in radians."""
        result: Formula = ZERO
        for angle, factor in self.terms:
            result = add(result, Number(factor) * angle)
        if self.degrees:
            result = add(result, Number(self.degrees / 180) * PI)
        return result


RIGHT, UP, LEFT, DOWN = (Heading(Fraction(degrees)) for degrees in (0, 90, 180, 270))


def heading(angle: Formula) -> Heading:
    """The heading of a formula in radians: rational multiples of π become degrees, the rest stays as angles."""
    return _heading(Fraction(0), tuple(_linear(angle, Fraction(1))))


def _linear(angle: Formula, factor: Fraction) -> Iterable[tuple[Formula, Fraction]]:
    match angle:
        case Sum(terms):
            for term in terms:
                yield from _linear(term, factor)
        case Negative(operand):
            yield from _linear(operand, -factor)
        case Product((Number(value), *rest)):
            yield from _linear(rest[0] if len(rest) == 1 else Product(tuple(rest)), factor * value)
        case Quotient(numerator, Number(value)) if value:
            yield from _linear(numerator, factor / value)
        case Number(value) if value == 0:
            return
        case _:
            yield angle, factor


def _heading(degrees: Fraction, terms: Iterable[tuple[Formula, Fraction]]) -> Heading:
    collected: dict[Formula, Fraction] = {}
    for angle, factor in terms:
        if isinstance(angle, Constant):
            degrees += 180 * factor
        else:
            collected[angle] = collected[angle] + factor if angle in collected else factor
    return Heading(degrees, tuple((angle, factor) for angle, factor in collected.items() if factor))


def _of_slope(terms: tuple[tuple[Formula, Fraction], ...], rest: Fraction, quarter: int) -> Formula | None:
    """cos(atan2(y, x) + 90° quarter): x/√(x² + y²) and the like; None of all other angles."""
    (angle, factor), *others = terms
    if others or rest or factor != 1 or not isinstance(angle, Call) or angle.function != "atan2":
        return None
    y, x = angle.arguments
    side = x if quarter % 2 == 0 else y
    value = simplify(side / sqrt(x**2 + y**2))
    return negate(value) if quarter % 4 in (1, 2) else value


@lru_cache(ANGLES)
def _cosine_of_degrees(degrees: int | Fraction) -> Formula:
    folded = min(degrees % 360, 360 - degrees % 360)
    value = _of_acute("cos", min(folded, 180 - folded))
    return negate(value) if folded > 90 else value


@lru_cache(ANGLES)
def _sine_of_degrees(degrees: int | Fraction) -> Formula:
    folded = degrees % 180
    value = _of_acute("sin", min(folded, 180 - folded))
    return negate(value) if degrees % 360 > 180 else value


def _of_acute(function: str, degrees: int | Fraction) -> Formula:
    """The sine or cosine of an angle up to 90°: exact where it is a usual one."""
    value = _COSINE.get(90 - degrees if function == "sin" else degrees)
    return Call(function, (Number(Fraction(degrees) / 180) * PI,)) if value is None else value


class Vector(Struct, frozen=True):
    """Σ size × unit vector(heading), in the plane."""

    parts: tuple[tuple[Formula, Heading], ...] = ()

    def __add__(self, other: Vector) -> Vector:
        return Vector((*self.parts, *other.parts))

    def __neg__(self) -> Vector:
        return self.turned(180)

    def __sub__(self, other: Vector) -> Vector:
        return self + (-other)

    def times(self, factor: Formula) -> Vector:
        return Vector(tuple((size * factor, direction) for size, direction in self.parts if factor != ZERO))

    def scaled(self, factor: Formula) -> Vector:
        """The vector with a factor in front of its sizes: m v."""
        return Vector(tuple((factor * size, direction) for size, direction in self.parts if factor != ZERO))

    def rotated(self, by: Heading) -> Vector:
        return Vector(tuple((size, direction + by) for size, direction in self.parts))

    def turned(self, degrees: int) -> Vector:
        return Vector(tuple((size, direction.turned(degrees)) for size, direction in self.parts))

    def along(self, direction: Heading) -> Formula:
        """Component along a direction: Σ size cos(heading − direction)."""
        result: Formula = ZERO
        for size, own in self.parts:
            result = add(result, size * (own - direction).cos())
        return result

    def cross(self, other: Vector) -> Formula:
        """z component of self × other, counterclockwise positive: Σ other · size · sin(difference of headings)."""
        result: Formula = ZERO
        for size, own in self.parts:
            for other_size, other_own in other.parts:
                result = add(result, other_size * size * (other_own - own).sin())
        return result

    def dot(self, other: Vector) -> Formula:
        result: Formula = ZERO
        for size, own in self.parts:
            for other_size, other_own in other.parts:
                result = add(result, other_size * size * (other_own - own).cos())
        return result


def vector(size: Formula, direction: Heading) -> Vector:
    return Vector(((size, direction),)) if size != ZERO else NOWHERE


def cartesian(x: Formula, y: Formula) -> Vector:
    """The vector x right + y up."""
    return vector(x, RIGHT) + vector(y, UP)


def unit(direction: Heading) -> Vector:
    return vector(ONE, direction)


NOWHERE = Vector()


# in words

TURNS = ("counterclockwise", "clockwise")
WORDS = {"right": RIGHT, "up": UP, "left": LEFT, "down": DOWN}
OPPOSITE = {
    "right": "left",
    "left": "right",
    "up": "down",
    "down": "up",
    "forward": "back",
    "back": "forward",
    "clockwise": "counterclockwise",
    "counterclockwise": "clockwise",
}


def opposite(words: str) -> str:
    """The words for the other way along a line: "down the slope" -> "up the slope"."""
    first, _, rest = words.partition(" ")
    return " ".join(part for part in (OPPOSITE.get(first, first), rest) if part)


def along_text(direction: Heading) -> str:
    """A heading in words: right, up, left, down; nothing for one at an angle."""
    return next((word for word, way in WORDS.items() if way == direction.turned(0)), "")


Direction = str | Formula | tuple[Formula, Formula]  # as a scene writes it


def pointing(direction: Direction) -> Vector:
    """Unit vector of a direction: a word, an angle, or components."""
    if isinstance(direction, str):
        return unit(WORDS.get(direction, RIGHT))
    if isinstance(direction, tuple):
        x, y = direction
        length = sqrt(x**2 + y**2)
        return vector(x / length, RIGHT) + vector(y / length, UP)
    return unit(heading(direction))
