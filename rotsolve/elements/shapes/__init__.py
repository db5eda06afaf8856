"""Shapes of bodies: how mass is spread. A size that the scene leaves out is None."""

from rotsolve.elements.shapes.flat import Polygon, Rectangle, Triangle
from rotsolve.elements.shapes.integrated import Graded, Integrated, Lamina, Revolution
from rotsolve.elements.shapes.round import Annulus, Cylinder, CylindricalShell, Disc, Ring, Sphere, SphericalShell
from rotsolve.elements.shapes.shape import WHEEL, Place, Shape
from rotsolve.elements.shapes.solid import Cone, Cuboid, Ellipsoid
from rotsolve.elements.shapes.thin import Arc, Particle, Rod, Rope

SHAPES: tuple[type[Shape], ...] = (
    Particle,
    Rod,
    Rope,
    Arc,
    Disc,
    Ring,
    Annulus,
    Rectangle,
    Triangle,
    Polygon,
    Cylinder,
    CylindricalShell,
    Sphere,
    SphericalShell,
    Cone,
    Cuboid,
    Ellipsoid,
    Lamina,
    Revolution,
)

__all__ = ["SHAPES", "WHEEL", "Graded", "Integrated", "Particle", "Place", "Rod", "Rope", "Shape"]
