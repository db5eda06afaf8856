"""Tables: all that a scene can be built of, by its word. A new element is a class and its row here."""

from __future__ import annotations

from rotsolve.language.bodies import Surface
from rotsolve.language.elements import Action, Connection, Event
from rotsolve.language.kinds import Kinds
from rotsolve.language.shape import Shape

SHAPES: Kinds[Shape] = Kinds(
    "rotsolve.elements.shapes",
    {
        "particle": "thin.Particle",
        "rod": "thin.Rod",
        "rope": "thin.Rope",
        "arc": "thin.Arc",
        "disc": "round.Disc",
        "ring": "round.Ring",
        "annulus": "round.Annulus",
        "rectangle": "flat.Rectangle",
        "triangle": "flat.Triangle",
        "polygon": "flat.Polygon",
        "cylinder": "round.Cylinder",
        "cylindrical shell": "round.CylindricalShell",
        "sphere": "round.Sphere",
        "spherical shell": "round.SphericalShell",
        "hemisphere": "half.Hemisphere",
        "hemispherical shell": "half.HemisphericalShell",
        "cone": "solid.Cone",
        "cuboid": "solid.Cuboid",
        "ellipsoid": "solid.Ellipsoid",
        "lamina": "integrated.Lamina",
        "solid of revolution": "integrated.Revolution",
    },
)
SURFACES: Kinds[Surface] = Kinds(
    "rotsolve.elements.surfaces",
    {
        "level": "Level",
        "slope": "Slope",
        "wall": "Wall",
        "corner": "Corner",
        "hollow": "Hollow",
        "wire": "Wire",
        "dome": "Dome",
        "post": "Post",
        "profile unknown": "Track",
    },
)
CONNECTIONS: Kinds[Connection] = Kinds(
    "rotsolve.elements.connections",
    {
        "hinge": "supports.Hinge",
        "axle": "supports.Axle",
        "shaft": "supports.Shaft",
        "ball": "pairs.Ball",
        "collar": "pairs.Collar",
        "clamp": "pairs.Clamp",
        "slide": "pairs.Slide",
        "sleeve": "pairs.Sleeve",
        "screw": "pairs.Screw",
        "universal": "pairs.Universal",
        "weld": "supports.Weld",
        "contact": "contact.Contact",
        "rolls": "contact.Rolls",
        "unrolls": "contact.Unrolls",
        "string": "strings.String",
        "drapes": "drapes.Drapes",
        "spring": "springs.Spring",
        "torsion": "springs.Torsion",
        "belt": "drives.Belt",
        "gear": "drives.Gear",
        "drives": "drives.MutualDrive",
        "clutch": "rubbing.Clutch",
        "rides": "supports.Rides",
        "slot": "slots.PinSlot",
    },
)
ACTIONS: Kinds[Action] = Kinds(
    "rotsolve.elements.actions",
    {
        "force": "AppliedForce",
        "couple": "AppliedCouple",
        "press": "Press",
        "band": "Band",
        "power": "AppliedPower",
    },
)
EVENTS: Kinds[Event] = Kinds(
    "rotsolve.elements",
    {
        "joins": "events.Joins",
        "collides": "collisions.Collides",
        "impulse": "events.Impulse",
        "cuts": "events.Cuts",
        "removes": "events.Removes",
        "fixes": "events.Fixes",
        "grips": "events.Grips",
    },
)
