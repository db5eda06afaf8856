"""Shapes that no table holds: a lamina by its limits, a solid of revolution by its profile, any shape of varying density."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cached_property

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Integral, Number, call
from rotsolve.core.derivation import Words
from rotsolve.core.limits import Limit
from rotsolve.core.slicing import Range, Slicing, coordinate, on_axis
from rotsolve.core.symbols import is_coordinate
from rotsolve.core.vectors.tensor import AXES, ENTRIES, InertiaTensor, displaced
from rotsolve.core.vectors.tensor import Place as Spot
from rotsolve.language.keys import key
from rotsolve.language.shape import Bow, Place, Shape

CARTESIAN, POLAR = ("x", "y"), ("r", "phi")
UNSHAPED = Shape()
Region = tuple[Range, ...]
SHARES = [
    Number(Fraction(part, 8)) for part in range(9)
]  # of the way along a coordinate, where limits and densities are looked at


class Integrated(Shape, frozen=True, dict=True):
    """A shape whose mass, centre of mass and second moments are integrals; `positive` are the letters that surely are."""

    tabled = False
    positive: frozenset[str] = frozenset()

    @cached_property
    def elements(self) -> Slicing:
        """The slicing, which such a shape always has."""
        found = self.slicing()
        assert found is not None
        return found

    def following(self, positive: frozenset[str]) -> Shape:
        return replace(self, positive=positive)

    def closed(self, integral: Formula) -> Formula:
        from rotsolve.algebra.calculus.integral import carried_out

        return carried_out(integral, self.positive)

    @cached_property
    def whole(self) -> Formula:
        """The length, area, volume or, of a varying density, the mass."""
        return self.closed(self.elements.total(ONE))

    @cached_property
    def centre(self) -> Spot:
        """The centre of mass from the origin of the slicing."""
        cut = self.elements
        x, y, z = (
            simplify(self.closed(cut.total(cut.first(axis))) / self.whole, positive=self.positive) for axis in AXES
        )
        return (x, y, z)

    @cached_property
    def central(self) -> InertiaTensor:
        """Second moments about the centre of mass, per mass."""
        cut = self.elements
        about = InertiaTensor(*(self.closed(cut.total(cut.second(entry))) / self.whole for entry in ENTRIES))
        less = displaced(ONE, self.centre)
        return InertiaTensor(
            *(simplify(about.entry(entry) - less.entry(entry), positive=self.positive) for entry in ENTRIES)
        )

    def moment(self, mass: Formula) -> Formula:
        """∫ (x² + y²) dm about the origin, less M d² of the centre of mass."""
        return mass * self.central.zz

    def tensor(self, mass: Formula) -> InertiaTensor:
        return self.central.times(mass)

    def centroid(self) -> Place:
        origin = self.elements.origin
        return (origin[0] + self.centre[0], origin[1] + self.centre[1])

    def rise(self, point: str = "cm") -> Formula:
        return self.elements.origin[2] + self.centre[2] if point == "cm" else ZERO

    def measure(self) -> Formula:
        return self.whole


class Lamina(Integrated, frozen=True):
    word = "lamina"
    about = "thin plate by the limits of its coordinates: `x` and `y`, or `r` and `phi`; one may depend on the other"
    spread = "surface"
    coordinates = (*CARTESIAN, *POLAR)
    region: Region = key(
        "region",
        "limits of x and y, or of r and phi",
        default=(),
        required=True,
        example="{x: [0, a], y: [0, b*sqrt(1 - x^2/a^2)]}",
    )

    def variables(self) -> tuple[str, ...]:
        return tuple(item.variable.name[1:] for item in self.region)

    def rooms(self) -> Iterator[Limit]:
        return enclosing(self.region)

    def slicing(self) -> Slicing:
        return self.layers(ONE)

    def bow(self) -> Bow | None:
        """Where r ends, from one end of φ to the other; None of what is told by x and y, or where that limit varies."""
        limits = {item.variable: item for item in self.region}
        if limits.keys() != {coordinate(name) for name in POLAR}:
            return None
        out, round_ = (limits[coordinate(name)] for name in POLAR)
        ends = (out.upper, round_.lower, round_.upper)
        return None if any(is_coordinate(name) for end in ends for name in end.symbols()) else Bow(*ends)

    def layers(self, density: Formula) -> Slicing:
        """Strips or rings where the density is the same all along them, else elements dx dy or r dr dφ."""
        outer, inner = self._ordered(density)
        if inner.variable.name not in density.symbols():
            strips = self._strips(outer, inner)
            if strips is not None:
                return strips
        centre, weight = self._place()
        x, y, _ = centre
        d: tuple[Words, Words] = ((" d", outer.variable), (" d", inner.variable))
        element: Words = ("elements", *((" ", weight) if weight != ONE else ()), *d[0], *d[1])
        return Slicing(element, (outer, inner), weight, centre, (x**2, y**2, ZERO, x * y, ZERO, ZERO))

    def _place(self) -> tuple[Spot, Formula]:
        """Where an element is in Cartesian coordinates, and its size beside dx dy or dr dφ."""
        if {item.variable for item in self.region} == {coordinate(name) for name in CARTESIAN}:
            x, y = (coordinate(name) for name in CARTESIAN)
            return (x, y, ZERO), ONE
        r, phi = (coordinate(name) for name in POLAR)
        return (r * call("cos", phi), r * call("sin", phi), ZERO), r

    def _ordered(self, density: Formula) -> Region:
        """The variable on which the limits of the other depend, else the one on which the density does, outermost."""
        one, other = self.region
        if one.variable.name in (other.lower - other.upper).symbols():
            return (one, other)
        if other.variable.name in (one.lower - one.upper).symbols() or other.variable.name in density.symbols():
            return (other, one)
        return (one, other)

    def _strips(self, outer: Range, inner: Range) -> Slicing | None:
        """The elements gathered along the inner variable; None where that has no closed form."""
        (x, y, _), weight = self._place()

        def gathered(part: Formula) -> Formula:
            return self.closed(Integral(simplify(part * weight), inner.variable.name, inner.lower, inner.upper))

        parts = [gathered(part) for part in (ONE, x, y, x**2, y**2, x * y)]
        if any(part.holds(Integral) for part in parts):
            return None
        size, *means = (parts[0], *(simplify(part / parts[0], positive=self.positive) for part in parts[1:]))
        return Slicing(
            self._named(outer, inner, size),
            (outer,),
            size,
            (means[0], means[1], ZERO),
            (means[2], means[3], ZERO, means[4], ZERO, ZERO),
        )

    def _named(self, outer: Range, inner: Range, size: Formula) -> Words:
        """What the strips are called."""
        if outer.variable == coordinate("r"):
            full = simplify(inner.upper - inner.lower - 2 * PI) == ZERO
            return ("rings" if full else "arcs", " of radius ", outer.variable, " and width d", outer.variable)
        if outer.variable == coordinate("phi"):
            return ("sectors of angle d", outer.variable)
        word = "height" if outer.variable == coordinate("x") else "length"
        return (f"strips of {word} ", size, " and width d", outer.variable)


def enclosing(ranges: Sequence[Range]) -> Iterator[Limit]:
    """What lies between two limits is something, wherever it is looked at along the other coordinate; an angle goes once round at most."""
    for one in ranges:
        gap, name = one.upper - one.lower, one.variable.name[1:]
        fixed = not any(map(is_coordinate, gap.symbols()))
        words = f"the limits of `{name}` {'enclose nothing' if fixed else 'cross'}"
        yield from (Limit(value, words, strict=fixed) for value in looked_at(gap, ranges))
        if one.variable == coordinate("phi"):
            yield from (
                Limit(2 * PI - value, f"`{name}` goes round more than once") for value in looked_at(gap, ranges)
            )
        if one.variable == coordinate("r"):
            yield from (Limit(value, "a radius can't be negative") for value in looked_at(one.lower, ranges))


def looked_at(value: Formula, ranges: Sequence[Range]) -> Iterator[Formula]:
    """What a formula is at both ends of the coordinates in it, and at places between."""
    one = next((item for item in ranges if item.variable.name in value.symbols()), None)
    if one is None:
        yield value
        return
    for share in SHARES:
        place = one.lower + share * (one.upper - one.lower)
        yield from looked_at(simplify(value.substitute({one.variable.name: place})), ranges)


class Revolution(Integrated, frozen=True):
    word = "solid of revolution"
    symmetry_axis = "z"
    about = "solid round the z axis by its profile: the limits of z, and the radius r there (or `[inner, outer]`)"
    spread = "volume"
    flat = False
    coordinates = ("z",)
    profile: Region = key(
        "profile", "limits of z, and the radius at z", default=(), required=True, example="{z: [0, h], r: R*z/h}"
    )

    def rooms(self) -> Iterator[Limit]:
        return enclosing(self.profile)

    def slicing(self) -> Slicing:
        """Discs, or discs with a hole, of thickness dz."""
        along, radius = self.profile
        inner, outer = radius.lower, radius.upper
        z = along.variable
        area = simplify(PI * (outer**2 - inner**2)) if inner != ZERO else PI * outer**2
        square = (outer**2 + inner**2) / 4 if inner != ZERO else outer**2 / 4
        shape: Words = ("discs of radius ", outer) if inner == ZERO else ("rings from radius ", inner, " to ", outer)
        return on_axis((*shape, " and thickness d", z), along, area, (square, square))

    def layers(self, density: Formula) -> Slicing:
        return self.slicing()


class Graded(Integrated, frozen=True):
    """A shape of varying density: its elements weigh density times their length, area or volume."""

    graded = True
    shape: Shape = UNSHAPED
    density: Formula = ONE

    @property
    def word(self) -> str:  # type: ignore[override]
        return self.shape.word

    @property
    def noun(self) -> str:  # type: ignore[override]
        return self.shape.noun

    @property
    def slender(self) -> bool:  # type: ignore[override]
        return self.shape.slender

    @property
    def backed(self) -> bool:  # type: ignore[override]
        return self.shape.backed

    @property
    def points(self) -> tuple[str, ...]:  # type: ignore[override]
        return self.shape.points

    @property
    def flat(self) -> bool:  # type: ignore[override]
        return self.shape.flat

    @property
    def spread(self) -> str:  # type: ignore[override]
        return self.shape.spread

    def rooms(self) -> Iterator[Limit]:
        """Those of the shape; its density is nowhere negative, wherever it is looked at."""
        yield from self.shape.rooms()
        cut = self.shape.layers(self.density)
        for value in looked_at(self.density, () if cut is None else cut.ranges):
            yield Limit(value, "its density would be negative somewhere")

    def slicing(self) -> Slicing:
        cut = self.shape.layers(self.density)
        assert cut is not None
        return replace(cut, weight=self.density * cut.weight)

    def bow(self) -> Bow | None:
        return self.shape.bow()

    def begin(self) -> Spot:
        return self.shape.begin()

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        return self.shape.locate(point, argument)

    def rise(self, point: str = "cm") -> Formula:
        return super().rise(point) if point == "cm" else self.shape.rise(point)

    @property
    def outer(self) -> Formula | None:
        return self.shape.outer
