"""Newton's law for rotation, Σ τ = I α: about a fixed axis, or about the centre of mass; and what defines I."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.equation import NEWTON, Equation
from rotsolve.core.facts import BodyFacts, Facts, signed
from rotsolve.core.writing import law, spoken


def law_of_rotation(facts: Facts, section: str) -> Iterator[Equation]:
    """Σ τ = I α about the reference point of every body that turns and keeps its moment of inertia."""
    for body in facts.bodies:
        if body.motion.turns and not body.changing:
            left, right = law(torques(body), response(body))
            if (left, right) != (ZERO, ZERO):
                label = f"Newton's law for rotation, {spoken(body.name)}{about(body)}"
                yield Equation(left, right, label, section, NEWTON, 3, bodies=(body.name,))


def torques(body: BodyFacts) -> list[Formula]:
    """Torques about the reference, positive along the body's declared turn."""
    sense = body.motion.sense
    arms = [signed(force.torque, sense) for force in body.forces]
    return [torque for torque in (*arms, *(signed(couple.torque, sense) for couple in body.couples)) if torque != ZERO]


def response(body: BodyFacts) -> Formula:
    """I α along the declared turn."""
    if body.inertia is None or body.inertia.letter == ZERO:
        return ZERO
    return body.inertia.letter * signed(body.motion.spin_rate, body.motion.sense)


def about(body: BodyFacts) -> str:
    """About which point, where it is not plainly the axle of a wheel."""
    if body.motion.kind == "axis":
        return " about the pivot" if body.cm.parts else ""
    return " about the centre of mass"


def moments_of_inertia(facts: Facts, section: str) -> Iterator[Equation]:
    """I = …, for every body whose moment of inertia is not given as such."""
    for body in facts.bodies:
        inertia = body.inertia
        if inertia is not None and inertia.letter not in (ZERO, inertia.formula):
            defines = next(iter(inertia.letter.symbols()), "")
            yield Equation(
                inertia.letter,
                inertia.formula,
                inertia.label,
                section,
                "",
                1,
                inertia.remark,
                defines,
                bodies=(body.name,),
            )
