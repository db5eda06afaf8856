"""Rate of angular momentum: dL/dt = τ at an instant, of a wheel with what hangs from it, or of what rolls or unwinds."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.equation import ANGULAR_MOMENTUM, Equation
from rotsolve.core.facts import BodyFacts, Facts, Force, signed
from rotsolve.core.vectors.heading import Vector
from rotsolve.core.writing import positive_first, spoken
from rotsolve.principles.rotation import response


def rate_of_angular_momentum(facts: Facts, group: frozenset[str], section: str) -> Iterator[Equation]:
    """dL/dt = τ of a group: about the axis of its one wheel, or about the point where a rolling or unwinding body is held."""
    bodies = [body for body in facts.bodies if body.name in group]
    if any(body.changing for body in bodies):
        return
    turning = [body for body in bodies if body.motion.kind == "axis"]
    if len(turning) == 1:
        yield from about_axis(turning[0], [body for body in bodies if body is not turning[0]], section)
    elif len(bodies) == 1 and bodies[0].motion.kind == "line" and bodies[0].motion.turns:
        yield from about_contact(bodies[0], section)


def about_axis(wheel: BodyFacts, others: list[BodyFacts], section: str) -> Iterator[Equation]:
    """I α + Σ R m a = τ: a body on a string that runs off the wheel has the rim's radius for its arm."""
    sense, rates = wheel.motion.sense, [response(wheel)]
    pushes: list[Formula] = []
    between: set[tuple[str, Formula]] = set()  # tensions between the wheel and what hangs from it
    for body in others:
        held = string_between(body, wheel)
        if held is None or body.motion.kind != "line" or body.motion.turns or body.motion.heading is None:
            return
        between.add((held.owner, held.size))
        rates.append(signed(held.arm.cross(body.motion.acceleration.scaled(body.mass)), sense))
        for force in body.forces:
            if (force.owner, force.size) not in between:
                pull = Vector(((force.vector.along(body.motion.heading), body.motion.heading),))
                pushes.append(signed(held.arm.cross(pull), sense))
    pushes += [signed(force.torque, sense) for force in wheel.forces if (force.owner, force.size) not in between]
    pushes += [signed(couple.torque, sense) for couple in wheel.couples]
    label = f"angular momentum about the {'pivot' if wheel.cm.parts else 'axle'}: its rate is the torque"
    yield Equation(
        positive_first(pushes), positive_first(rates), label, section, ANGULAR_MOMENTUM, 5, bodies=(wheel.name,)
    )


def string_between(body: BodyFacts, wheel: BodyFacts) -> Force | None:
    """The pull on the wheel of the string that holds a body: the same tension the other way, at the rim's arm."""
    for force in body.forces:
        for other in wheel.forces:
            same = force.role == "tension" and (force.owner, force.size) == (other.owner, other.size)
            if same and force.direction == -other.direction:
                return other
    return None


def about_contact(body: BodyFacts, section: str) -> Iterator[Equation]:
    """Rolling or unwinding: about the point held by the surface or string, whose forces then have no arm."""
    held = {force.arm for force in body.forces if force.internal}
    if len(held) != 1:
        return
    point, sense = held.pop(), body.motion.sense
    pushes = [signed((force.arm - point).cross(force.vector), sense) for force in body.forces if not force.internal]
    pushes += [signed(couple.torque, sense) for couple in body.couples]
    orbital = signed((-point).cross(body.motion.acceleration.scaled(body.mass)), sense)
    rates = [term for term in (response(body), orbital) if term != ZERO]
    label = f"angular momentum about the point of contact of {spoken(body.name)}: its rate is the torque"
    yield Equation(
        positive_first(pushes), positive_first(rates), label, section, ANGULAR_MOMENTUM, 5, bodies=(body.name,)
    )
