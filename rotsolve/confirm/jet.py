"""Jet: a number that carries along how it changes: with each coordinate, and with time along the motion."""

from __future__ import annotations

import math
from collections.abc import Mapping

Real = "Jet | float"
Slope = dict[int, float]
NO_SLOPE: Slope = {}


class Jet:
    """A value f(q, t), its `rate` ḟ and its `bend` f̈ − ∂f/∂q · q̈ along the motion, and its `slope` ∂f/∂q by coordinate.

    So that f̈ = slope · q̈ + bend. Each operation is the chain rule.
    """

    __slots__ = ("bend", "rate", "slope", "value")

    def __init__(self, value: float, rate: float = 0.0, bend: float = 0.0, slope: Slope = NO_SLOPE) -> None:
        self.value, self.rate, self.bend, self.slope = value, rate, bend, slope

    def __add__(self, other: Jet | float) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value + other, self.rate, self.bend, self.slope)
        slope = merged(self.slope, 1.0, other.slope, 1.0)
        return Jet(self.value + other.value, self.rate + other.rate, self.bend + other.bend, slope)

    __radd__ = __add__

    def __neg__(self) -> Jet:
        return self * -1.0

    def __sub__(self, other: Jet | float) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value - other, self.rate, self.bend, self.slope)
        slope = merged(self.slope, 1.0, other.slope, -1.0)
        return Jet(self.value - other.value, self.rate - other.rate, self.bend - other.bend, slope)

    def __rsub__(self, other: float) -> Jet:
        return self * -1.0 + other

    def __mul__(self, other: Jet | float) -> Jet:
        if not isinstance(other, Jet):
            slope = {key: part * other for key, part in self.slope.items()}
            return Jet(self.value * other, self.rate * other, self.bend * other, slope)
        a, b = self.value, other.value
        slope = merged(self.slope, b, other.slope, a)
        bend = self.bend * b + 2.0 * self.rate * other.rate + a * other.bend
        return Jet(a * b, self.rate * b + a * other.rate, bend, slope)

    __rmul__ = __mul__

    def of(self, value: float, first: float, second: float) -> Jet:
        """f(self), by the value of f and of its first and second derivative."""
        slope = {key: part * first for key, part in self.slope.items()}
        return Jet(value, first * self.rate, first * self.bend + second * self.rate * self.rate, slope)

    def __truediv__(self, other: Jet | float) -> Jet:
        return self * (1.0 / other)

    def __rtruediv__(self, other: float) -> Jet:
        x = self.value
        return self.of(1.0 / x, -1.0 / x**2, 2.0 / x**3) * other

    def __pow__(self, n: float) -> Jet:
        x = self.value
        if n == 2.0:
            return self * self
        first = n * x ** (n - 1.0) if n else 0.0
        return self.of(x**n, first, n * (n - 1.0) * x ** (n - 2.0) if n not in (0.0, 1.0) else 0.0)


def merged(a: Mapping[int, float], p: float, b: Mapping[int, float], q: float) -> Slope:
    """p a + q b."""
    result = {key: part * p for key, part in a.items()} if p != 1.0 else dict(a)
    for key, part in b.items():
        result[key] = result.get(key, 0.0) + part * q
    return result


def sine(x: Jet) -> Jet:
    s, c = math.sin(x.value), math.cos(x.value)
    return x.of(s, c, -s)


def cosine(x: Jet) -> Jet:
    s, c = math.sin(x.value), math.cos(x.value)
    return x.of(c, -s, -c)


def root(x: Jet) -> Jet:
    r = math.sqrt(x.value)
    return x.of(r, 0.5 / r, -0.25 / (r * x.value))


def exponential(x: Jet) -> Jet:
    e = math.exp(x.value)
    return x.of(e, e, e)


def logarithm(x: Jet) -> Jet:
    return x.of(math.log(x.value), 1.0 / x.value, -1.0 / x.value**2)


def arctangent(y: Jet, x: Jet) -> Jet:
    """The angle of (x, y), by which r² φ̇ = x ẏ − y ẋ."""
    r2 = x.value**2 + y.value**2
    slope = merged(y.slope, x.value / r2, x.slope, -y.value / r2)
    rate = (x.value * y.rate - y.value * x.rate) / r2
    swing = 2.0 * rate * (x.value * x.rate + y.value * y.rate)
    bend = (x.value * y.bend - y.value * x.bend - swing) / r2
    return Jet(math.atan2(y.value, x.value), rate, bend, slope)


def distance(x: Jet, y: Jet) -> Jet:
    return root(x * x + y * y)
