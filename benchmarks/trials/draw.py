"""Draw: exact decimal numbers at random, in the ways in which numbers are ordinary or nasty."""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction

from mpmath import mp, mpf

STYLES = ("plain", "long", "wide", "close")
FIGURES = 150  # of every independent number: what cancels 60 figures leaves 90
mp.dps = FIGURES


@dataclass(frozen=True)
class Value:
    """A number as a scene writes it, with its unit, and as it is."""

    text: str
    number: Fraction

    @property
    def x(self) -> mpf:
        return exactly(self.number)


def exactly(number: Fraction) -> mpf:
    return mpf(number.numerator) / number.denominator


def decimal(number: Fraction) -> str:
    """A number with a finite decimal expansion, written as a scene writes it."""
    digits = 0
    while (number * 10**digits).denominator != 1:
        digits += 1
    mantissa = str(abs(int(number * 10**digits)))
    if digits > 40 or len(mantissa) > digits + 25:
        shown = f"{mantissa}e{-digits}"
    elif digits:
        mantissa = mantissa.rjust(digits + 1, "0")
        shown = f"{mantissa[:-digits]}.{mantissa[-digits:]}"
    else:
        shown = mantissa
    return f"-{shown}" if number < 0 else shown


class Draw:
    """A source of values in one style: plain (2 figures), long (12 figures), wide (24 decades), close (nearly equal ones too)."""

    def __init__(self, seed: str, style: str) -> None:
        self.chance = random.Random(seed)
        self.style = style
        self.drawn: dict[str, list[Fraction]] = {}

    def pick(self, *options: str) -> str:
        return self.chance.choice(options)

    def often(self, share: float) -> bool:
        return self.chance.random() < share

    def size(self, unit: str, low: float = 0.2, high: float = 9.0) -> Value:
        """A positive number in a unit, near one that was drawn before where the style is close."""
        before = self.drawn.setdefault(unit, [])
        if self.style == "close" and before and self.often(0.7):
            near = Fraction(self.chance.choice((1, -1, 3)), 10 ** self.chance.randint(3, 24))
            return self._value(self.chance.choice(before) * (1 + near), unit)
        else:
            figures = 10 if self.style == "long" else 1
            number = Fraction(self.chance.randint(10**figures, 10 ** (figures + 1) - 1), 10**figures)
            number *= Fraction(10) ** self._decade(low, high)
        before.append(number)
        return self._value(number, unit)

    def _value(self, number: Fraction, unit: str) -> Value:
        return Value(f"{decimal(number)} {unit}", number)

    def _decade(self, low: float, high: float) -> int:
        if self.style == "wide":
            return self.chance.randint(-12, 12)
        bottom = next(k for k in range(-9, 9) if 10.0 ** (k + 1) > low)
        top = next(k for k in range(-9, 9) if 10.0 ** (k + 1) > high)
        return self.chance.randint(bottom, top)

    def share(self, top: int = 9) -> Value:
        """A pure number between 0 and 1, such as a coefficient of friction."""
        number = Fraction(self.chance.randint(1, top), 10)
        if self.style == "wide":
            number = number / 10 ** self.chance.randint(0, 12)
        if self.style == "close":
            number += Fraction(1, 10 ** self.chance.randint(5, 24))
        return Value(decimal(number), number)

    def angle(self, low: int = 5, high: int = 85) -> Value:
        """An angle in degrees; near its ends where the style is wide or close."""
        number = Fraction(self.chance.randint(low, high))
        if self.style == "long":
            number += Fraction(self.chance.randint(1, 10**9 - 1), 10**9)
        if self.style in ("wide", "close") and self.often(0.5):
            gap = Fraction(1, 10 ** self.chance.randint(2, 15))
            number = (low // 10 * 10 + gap) if self.often(0.5) else (-(-high // 10) * 10 - gap)
        return Value(f"{decimal(number)} deg", number)


def radians(angle: Value) -> mpf:
    return angle.x * mp.pi / 180
