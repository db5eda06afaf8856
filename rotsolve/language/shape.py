"""Shape: base of all shapes: how mass is spread. A size that the scene leaves out is None."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, ClassVar

from msgspec import Struct

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.limits import Limit
from rotsolve.core.vectors.tensor import ORIGIN, InertiaTensor
from rotsolve.core.vectors.tensor import Place as Spot
from rotsolve.language.keys import Element, amount

if TYPE_CHECKING:
    from rotsolve.core.slicing import Slicing

Place = tuple[Formula, Formula]
WHEEL: tuple[str, ...] = ("center", "rim", "top", "bottom")


def extent(help: str, letter: str) -> Formula | None:
    """The field of a length that a shape has."""
    declared: Formula | None = amount(help, "length", letter, "positive", default=None)
    return declared


class Bow(Struct, frozen=True):
    """The arc of a circle about the centre of a shape with which it rocks on a floor: |r| = radius, from one angle to another."""

    radius: Formula
    first: Formula
    last: Formula


class Shape(Element, frozen=True):
    """Base of all shapes. `points` are the names of its points, beside `cm` and those that the scene names."""

    about: ClassVar[str] = ""
    points: ClassVar[tuple[str, ...]] = ("center",)
    later: ClassVar[bool] = False
    spread: ClassVar[str] = "point"  # over what mass is spread: point, line, surface, volume
    flat: ClassVar[bool] = True  # all mass at one height
    tabled: ClassVar[bool] = True  # whether a table of moments of inertia holds it
    graded: ClassVar[bool] = False  # whether its density varies
    coordinates: ClassVar[tuple[str, ...]] = ()  # in which a density may vary
    wound: ClassVar[bool] = False  # whether a sheet can be rolled up to it, so that its mass is as its radius squared
    rigid: ClassVar[bool] = True  # whether it keeps its form, so that it has a moment of inertia
    pointlike: ClassVar[bool] = False  # whether all its mass is in one point
    slender: ClassVar[bool] = (
        False  # whether it runs straight from its start to its end, so that its angle is that of its direction
    )
    symmetry_axis: ClassVar[str] = ""  # its own axis about which it is symmetric, however large its sizes
    spherical: ClassVar[bool] = False  # whether it looks the same from all sides
    round: ClassVar[bool] = False  # whether it looks like a circle, or a ring between two
    backed: ClassVar[bool] = False  # whether its back is level as it is drawn, so that something can lie on it
    walled: ClassVar[bool] = False  # whether it is given by two radii
    closing: ClassVar[tuple[str, ...]] = ()  # the keys of which one says how its sides close
    seen: ClassVar[bool] = (
        False  # whether its measure is what is seen along its axis, and its content that times its length
    )
    regular: ClassVar[str] = ""  # its word where all its sides are alike, so that it is the same about all axes
    noun: ClassVar[str] = ""  # what it is called beside its moment of inertia, if not by its word

    def moment(self, mass: Formula) -> Formula:
        """Moment of inertia about the centre of mass, axis square to the plane."""
        return ZERO

    def tensor(self, mass: Formula) -> InertiaTensor:
        """All second moments about the centre of mass, along the body's own axes.

        The formulas of all shapes are those of J. L. Meriam & L. G. Kraige, Engineering Mechanics: Dynamics, table D/4.
        """
        return InertiaTensor(zz=self.moment(mass))

    def slicing(self) -> Slicing | None:
        """The elements by which a textbook integrates over the shape; None where it does not."""
        return None

    def layers(self, density: Formula) -> Slicing | None:
        """Elements on each of which a varying density is the same."""
        return self.slicing()

    def variables(self) -> tuple[str, ...]:
        """The coordinates in which its density may vary, as they are spoken of."""
        return self.coordinates

    def left_out(self) -> tuple[str, ...]:
        """The sizes that get letters, since the scene leaves them out: a length, and a radius of what has no `radii`."""
        sizes = (name for name, declared in self.declared.items() if declared.kind == "quantity")
        open_ = (name for name in sizes if name in ("radius", "length") and getattr(self, name) is None)
        return tuple(name for name in open_ if name != "radius" or not getattr(self, "radii", None))

    def reach(self) -> Formula | None:
        """Length of what is slender, where it is told."""
        return None

    def box(self) -> tuple[Formula, ...]:
        """Width and height of what looks like a rectangle."""
        return ()

    def bow(self) -> Bow | None:
        """The part of its edge that is round about its centre, beyond which nothing of it reaches; None of what has none, or is round all
        about."""
        return None

    def outline(self) -> tuple[Place, ...]:
        """The corners or ends with which it may stand on something, in its own axes; none of what is round or a point."""
        return ()

    def is_regular(self) -> bool:
        """Whether all its sides are alike, and it has a word for that."""
        return bool(self.regular) and len(set(getattr(self, "sides", ()))) == 1

    def rooms(self) -> Iterator[Limit]:
        """What has to be for its sizes to fit each other: of two radii the inner one is smaller."""
        radii = dict(getattr(self, "radii", ()))
        if {"inner", "outer"} <= radii.keys():
            yield Limit(radii["outer"] - radii["inner"], "`inner` must be smaller than `outer`", strict=True)

    def following(self, positive: frozenset[str]) -> Shape:
        """The shape with the letters that surely are positive, where its integrals need them."""
        return self

    def begin(self) -> Spot:
        """Where the coordinates begin in which the scene speaks of the shape, in its own axes."""
        return ORIGIN

    def rise(self, point: str = "cm") -> Formula:
        """Height of a point above the picture, z of the body's axes."""
        return ZERO

    def depth(self) -> Formula | None:
        """How deep a hole along z through all of it is; None where it is not as deep everywhere, or nothing tells."""
        return None

    def centroid(self) -> Place:
        """Centre of mass in the body's axes."""
        return (ZERO, ZERO)

    def measure(self) -> Formula:
        """Length, area or volume; of a cylinder what is seen along its axis."""
        raise NotImplementedError(f"a {self.word} has no extent")

    def content(self) -> Formula:
        """Length, area or volume, by which a uniform density is multiplied."""
        return self.measure()

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        """Place of a named point in the body's axes; a round body's rim points are directions in space, hence not here."""
        return (ZERO, ZERO)

    def face(self) -> tuple[Formula, Formula] | None:
        """Inner and outer radius of its flat face square to the z axis, with which it may rub on another; None of what has none."""
        return None

    @property
    def outer(self) -> Formula | None:
        """Radius of the rim of a shape that is round all about."""
        return None if self.bow() is not None else getattr(self, "radius", None)


def corners_of_box(width: Formula, height: Formula) -> tuple[Place, ...]:
    """Those of a rectangle about its centre, counterclockwise from the lower left."""
    x, y = width / 2, height / 2
    return ((-x, -y), (x, -y), (x, y), (-x, y))
