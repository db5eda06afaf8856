"""Newton's second law, Σ F = m a, for every body along its line of travel and across, or right and up."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Sum, multiply
from rotsolve.core.equation import NEWTON, Equation
from rotsolve.core.facts import BodyFacts, Facts
from rotsolve.core.vectors.heading import Heading
from rotsolve.core.writing import law, spoken


def second_law(facts: Facts, section: str) -> Iterator[Equation]:
    """Σ F = m a of the centre of mass, component by component; equilibrium where it does not accelerate."""
    for body in facts.bodies:
        for axis in body.axes if not body.changing else ():  # what moves within it has an acceleration of its own
            equation = along(body, axis, section)
            if equation is not None:
                yield equation


def along(body: BodyFacts, axis: Heading, section: str) -> Equation | None:
    """The component along one axis; None where nothing acts along it."""
    if (
        body.motion.kind == "line"
        and axis != body.motion.heading
        and not any(force.role == "normal" for force in body.forces)
    ):
        return None  # whatever holds it on its line takes what acts across
    forces = [force.vector.along(axis) for force in body.forces]
    acceleration = body.centre_acceleration.along(axis)
    response = multiply(body.mass, acceleration) if body.mass != ZERO else ZERO
    if isinstance(body.mass, Sum):
        response = simplify(response)  # of joined bodies the common mass cancels in the place of the centre of mass
    if all(force == ZERO for force in forces) and response == ZERO:
        return None
    left, right = law(forces, response)
    return Equation(
        left,
        right,
        f"Newton's second law, {spoken(body.name)}{axis_words(body, axis)}",
        section,
        NEWTON,
        3,
        bodies=(body.name,),
    )


def axis_words(body: BodyFacts, axis: Heading) -> str:
    """Which component is meant, where the law has more than one."""
    if body.along:
        return f", {body.along[body.axes.index(axis)]}"
    if body.motion.bend is not None:
        return ", along the circle" if axis == body.motion.heading else ", towards the centre"
    names = {0: ", horizontally", 90: ", vertically"}
    upright = names.get(int(axis.degrees % 360), "") if not axis.terms else ""
    if body.motion.kind == "line" and not (upright and in_a_corner(body)):
        path = "slope" if body.positive.partition(",")[0].endswith("slope") else "surface"
        if axis == body.motion.heading:
            across = [force for force in body.forces if force.role == "normal"]
            return f", along the {path}" if across else ""
        return f", across the {path}"
    return upright


def in_a_corner(body: BodyFacts) -> bool:
    """Whether a body touches surfaces that face different ways, so that no one of them is the surface."""
    normals = [force.vector for force in body.forces if force.role == "normal"]
    return any(not is_zero(normals[0].cross(other)) for other in normals[1:])


def net_force(body: BodyFacts, axis: Heading) -> Formula:
    """m a along an axis."""
    return multiply(body.mass, body.centre_acceleration.along(axis))
