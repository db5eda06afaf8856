"""Natural components: tangential, along the path or the positive turn, and normal, towards the centre."""

from __future__ import annotations

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Formula, sqrt
from rotsolve.core.facts import signed
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.motion.rigid import tidy
from rotsolve.paths.meaning import absolute

NATURAL = ("tangential", "normal")


def length(arm: Vector) -> Formula:
    """|r|: the size of the only part, else √(x² + y²)."""
    arm = tidy(arm)
    if len(arm.parts) == 1:
        return arm.parts[0][0]
    x, y = arm.along(RIGHT), arm.along(UP)
    return simplify(sqrt(x**2 + y**2), positive=(x + y).symbols())


def about_centre(vector: Vector, arm: Vector, sense: int, component: str) -> Formula:
    """Component of a vector at `arm` from a centre: across the arm along the positive turn, or towards the centre."""
    arm = tidy(arm)
    if len(arm.parts) == 1:
        outward = arm.parts[0][1]
        return vector.along(outward.turned(180) if component == "normal" else outward.turned(90 * sense))
    part = signed(arm.cross(vector), sense) if component == "tangential" else (-arm).dot(vector)
    return simplify(part / length(arm))


def along_path(vector: Vector, velocity: Vector, component: str) -> Formula:
    """Component of a vector along the velocity of a point, or square to it: a·v/|v|, |v × a|/|v|."""
    velocity = tidy(velocity)
    if len(velocity.parts) == 1:
        onward = velocity.parts[0][1]
        return vector.along(onward) if component == "tangential" else absolute(vector.along(onward.turned(90)))
    speed = sqrt(velocity.along(RIGHT) ** 2 + velocity.along(UP) ** 2)
    part = velocity.dot(vector) if component == "tangential" else absolute(velocity.cross(vector))
    return part / speed
