"""Slicing: the thin elements into which a textbook cuts a shape to integrate over it. Coordinates begin at `origin` in the body's axes."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Symbol, add, multiply, negate
from rotsolve.core.derivation import Words
from rotsolve.core.symbols import coordinate_name
from rotsolve.core.vectors.tensor import AXES, ENTRIES, ORIGIN, Place

SQUARES = {"xx": ("yy", "zz"), "yy": ("xx", "zz"), "zz": ("xx", "yy")}  # Σ m (y² + z²), …


def coordinate(name: str) -> Symbol:
    """The symbol of a coordinate, which no letter of a scene can be."""
    return Symbol(coordinate_name(name))


class Range(Struct, frozen=True):
    """One variable of integration with its limits."""

    variable: Symbol
    lower: Formula
    upper: Formula


class Slicing(Struct, frozen=True):
    """Elements of length, area or volume `weight` d(variables), outermost variable first.

    `centre` is where an element's centre of mass is, `squares` are the means of xx, yy, zz, xy, yz, zx over an element;
    `at` is the name of the point of the body where the coordinates begin.
    """

    element: Words
    ranges: tuple[Range, ...]
    weight: Formula
    centre: Place = ORIGIN
    squares: tuple[Formula, ...] = (ZERO,) * 6
    origin: Place = ORIGIN
    at: str = "center"

    def total(self, integrand: Formula, tidied: Callable[[Formula], Formula] = simplify) -> Formula:
        """∫ integrand · weight over all elements."""
        result = tidied(multiply(integrand, self.weight))
        for item in reversed(self.ranges):
            result = Integral(result, item.variable.name, item.lower, item.upper)
        return result

    def first(self, axis: str) -> Formula:
        """x, y or z of an element, from the origin."""
        return self.centre[AXES.index(axis)]

    def second(self, entry: str) -> Formula:
        """Entry of the inertia tensor about the origin, per mass of the element: x² + y² for zz, −x y for xy."""
        squares = dict(zip(ENTRIES, self.squares, strict=True))
        if entry not in SQUARES:
            return negate(squares[entry])
        return simplify(add(*(squares[name] for name in SQUARES[entry])))

    def renamed(self, letters: dict[str, Symbol]) -> Slicing:
        """The slicing with other letters for its coordinates."""
        names: dict[str, Formula] = dict(letters)

        def put(parts: tuple[Formula, ...]) -> tuple[Formula, ...]:
            return tuple(part.substitute(names) for part in parts)

        x, y, z = put(self.centre)
        ranges = (Range(letters[item.variable.name], *put((item.lower, item.upper))) for item in self.ranges)
        return replace(
            self,
            element=tuple(part.substitute(names) if isinstance(part, Formula) else part for part in self.element),
            ranges=tuple(ranges),
            weight=self.weight.substitute(names),
            centre=(x, y, z),
            squares=put(self.squares),
        )

    def measured_from(self, place: Place) -> Slicing | None:
        """The same elements with their coordinates counted from a place; None where a variable is no such coordinate."""
        moved = self
        for axis, (new, old) in enumerate(zip(place, self.origin, strict=True)):
            step = simplify(new - old)
            if step != ZERO:
                if len(self.ranges) != 1 or self.ranges[0].variable != self.centre[axis]:
                    return None
                moved = moved.shifted(step, axis)
        return moved

    def shifted(self, step: Formula, axis: int) -> Slicing:
        """The slicing with its only variable, the coordinate along `axis`, counted from a place `step` further on."""
        (item,) = self.ranges
        x, name = item.variable, AXES[axis]
        put = {x.name: x + step}
        squares = dict(zip(ENTRIES, (part.substitute(put) for part in self.squares), strict=True))
        centre = [part.substitute(put) for part in self.centre]
        for entry in ENTRIES:  # the mean of (x − s) y is that of x y less s times that of y
            if name in entry:
                other = centre[AXES.index(entry.replace(name, "", 1))]
                less = step * step if entry == name * 2 else ZERO
                twice = 2 * step * other if entry == name * 2 else step * other
                squares[entry] = simplify(squares[entry] - twice + less)
        centre[axis] = x
        return replace(
            self,
            ranges=(Range(x, simplify(item.lower - step), simplify(item.upper - step)),),
            weight=self.weight.substitute(put),
            centre=(centre[0], centre[1], centre[2]),
            squares=tuple(squares[entry] for entry in ENTRIES),
            origin=tuple(part + step if k == axis else part for k, part in enumerate(self.origin)),
        )


def on_line(
    element: Words, item: Range, weight: Formula = ONE, across: tuple[Formula, Formula] = (ZERO, ZERO)
) -> Slicing:
    """Elements along x whose other two dimensions have the mean squares `across`."""
    x = item.variable
    return Slicing(element, (item,), weight, (x, ZERO, ZERO), (x**2, *across, ZERO, ZERO, ZERO))


def on_axis(element: Words, item: Range, weight: Formula, across: tuple[Formula, Formula]) -> Slicing:
    """Slices along z, each with its centre of mass on that axis and mean squares `across` of x and y."""
    z = item.variable
    return Slicing(element, (item,), weight, (ZERO, ZERO, z), (*across, z**2, ZERO, ZERO, ZERO))


def round_axis(element: Words, item: Range, weight: Formula, square: Formula, height: Formula = ZERO) -> Slicing:
    """Rings or shells round the z axis, all at one distance from it, with the mean square `height` of z."""
    return Slicing(element, (item,), weight, ORIGIN, (square / 2, square / 2, height, ZERO, ZERO, ZERO))
