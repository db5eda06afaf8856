"""InertiaTensor: second moments of mass as a symmetric matrix; products of inertia carry their minus sign: xy = −Σ m x y.

Turning by the columns of a rotation (I' = R I Rᵀ) and the parallel-axes theorem for all entries,
I_P = I_cm + M (d² 1 − d dᵀ), are Goldstein, Poole & Safko, Classical Mechanics, §5.3.
"""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.formula import ONE, ZERO, Formula, add, multiply, negate

Place = tuple[Formula, Formula, Formula]
AXES = ("x", "y", "z")
ONE_AXIS = ("xx", "yy", "zz")  # the moments of inertia; the others are products
ENTRIES = ("xx", "yy", "zz", "xy", "yz", "zx")  # the six that differ
ROWS = (("xx", "xy", "zx"), ("xy", "yy", "yz"), ("zx", "yz", "zz"))
ORIGIN: Place = (ZERO, ZERO, ZERO)


class InertiaTensor(Struct, frozen=True):
    """xx = Σ m (y² + z²), …, xy = −Σ m x y, …, about some point, along some axes."""

    xx: Formula = ZERO
    yy: Formula = ZERO
    zz: Formula = ZERO
    xy: Formula = ZERO
    yz: Formula = ZERO
    zx: Formula = ZERO

    def entry(self, name: str) -> Formula:
        """An entry by its two axes, in either order."""
        value: Formula = getattr(self, name if name in ENTRIES else name[::-1])
        return value

    def times(self, factor: Formula) -> InertiaTensor:
        return InertiaTensor(*(multiply(factor, self.entry(name)) for name in ENTRIES))

    def plus(self, other: InertiaTensor) -> InertiaTensor:
        return InertiaTensor(*(add(self.entry(name), other.entry(name)) for name in ENTRIES))

    def turned(self, rotation: tuple[Place, Place, Place]) -> InertiaTensor:
        """R I Rᵀ, of a body turned by R; `rotation` holds the rows of R."""

        def entry(name: str) -> Formula:
            result: Formula = ZERO
            left, right = (rotation[AXES.index(axis)] for axis in name)
            for one, row in zip(left, ROWS, strict=True):
                for other, own in zip(right, row, strict=True) if one != ZERO else ():
                    if other != ZERO:
                        result = add(result, multiply(multiply(one, other), self.entry(own)))
            return result

        return InertiaTensor(*(entry(name) for name in ENTRIES))


def round_about(axis: str, along: Formula, across: Formula) -> InertiaTensor:
    """A body symmetric about one axis: one moment along it, one across it."""
    return InertiaTensor(*(along if name == axis else across for name in AXES))


def displaced(mass: Formula, arm: Place) -> InertiaTensor:
    """M (d² 1 − d dᵀ): what a particle at `arm` has, and what the parallel-axes theorem adds."""
    x, y, z = (ZERO if part == ZERO else part**2 for part in arm)
    squares = (add(y, z), add(x, z), add(x, y))
    products = (multiply(arm[0], arm[1]), multiply(arm[1], arm[2]), multiply(arm[2], arm[0]))
    return InertiaTensor(*squares, *(negate(part) for part in products)).times(mass)


def about_z(cos: Formula, sin: Formula) -> tuple[Place, Place, Place]:
    """The rows of a rotation about z."""
    return ((cos, negate(sin), ZERO), (sin, cos, ZERO), (ZERO, ZERO, ONE))
