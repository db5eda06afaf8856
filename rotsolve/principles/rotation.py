"""Newton's law for rotation, Σ τ = I α: about a fixed axis, or about the centre of mass; and what defines I."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, add, negate, sqrt
from rotsolve.core.derivation import Words
from rotsolve.core.equation import NEWTON, Equation
from rotsolve.core.facts import BodyFacts, Facts, Force, signed, square
from rotsolve.core.vectors.heading import Vector
from rotsolve.core.writing import flat, is_negative, law, multiplied_out, positive_first, spoken
from rotsolve.motion.bodies.rigid import tidy


def law_of_rotation(facts: Facts, section: str) -> Iterator[Equation]:
    """Σ τ = I α about the reference point of every body that turns and keeps its moment of inertia."""
    for body in facts.bodies:
        if body.motion.turns and not body.changing:
            yield from rotation_of(body, section)


def rotation_of(body: BodyFacts, section: str) -> Iterator[Equation]:
    """Σ τ = I α of one body."""
    left, right = law(torques(body), response(body))
    if (left, right) != (ZERO, ZERO):
        label = f"Newton's law for rotation, {spoken(body.name)}{about(body)}"
        yield Equation(left, right, label, section, NEWTON, 3, carried(body), bodies=(body.name,))


def balance_of_torques(facts: Facts, section: str) -> Iterator[Equation]:
    """Σ τ = 0 of a free body in equilibrium about each point where a contact acts: its force then has no arm."""
    for body in facts.bodies:
        rates = [size for size, _ in body.centre_acceleration.parts]
        if (
            body.motion.kind == "axis"
            or not body.motion.turns
            or any(rate != ZERO for rate in (*rates, body.motion.spin_rate))
        ):
            continue
        points = dict.fromkeys((force.arm, force.owner) for force in body.forces if force.internal)
        if len({arm for arm, _ in points}) < 2:
            continue
        for point, owner in points:
            pushes = [torque_about(point, force) for force in body.forces]
            left, right = law([*pushes, *(couple.torque for couple in body.couples)], ZERO)
            label = f"balance of torques, {spoken(body.name)} about its point of contact at {spoken(owner)}"
            geometry = next(filter(None, (by_triangle(point, force) for force in body.forces)), ())
            yield Equation(left, right, label, section, NEWTON, 3, geometry, bodies=(body.name,))


def by_triangle(point: Vector, force: Force) -> Words:
    """Where the root in a lever comes from: it is a side of a right-angled triangle, √(R² − (R − h)²)."""
    arm = tidy(force.arm - point)
    if len(arm.parts) != 1:
        return ()
    size = arm.parts[0][0]
    lever, side = (
        simplify(part, positive=size.symbols()) for part in (arm.cross(force.direction), arm.dot(force.direction))
    )
    lever = negate(lever) if is_negative(lever) else lever
    if any(is_negative(term) and term.symbols() & size.symbols() for term in flat([side])):
        side = simplify(negate(side))
    if not has_any_root(lever) or has_any_root(side) or side == ZERO:
        return ()
    return ("arm ", sqrt(size**2 - side**2), " = ", lever)


def has_any_root(value: Formula) -> bool:
    return value.holds("sqrt")


def torque_about(point: Vector, force: Force) -> Formula:
    """F times its lever about a point, counterclockwise positive; the sizes of arms are positive."""
    arm = tidy(force.arm - point)
    lengths = {name for size, _ in arm.parts for name in size.symbols()}
    lever = arm.cross(force.direction)
    if all(is_negative(term) for term in flat([lever])):
        return negate(force.size * multiplied_out(negate(lever), lengths))
    return force.size * multiplied_out(positive_first([lever]), lengths)


def torques(body: BodyFacts) -> list[Formula]:
    """Torques about the reference, positive along the body's declared turn."""
    sense = body.motion.sense
    arms = [signed(force.torque, sense) for force in body.forces]
    return [torque for torque in (*arms, *(signed(couple.torque, sense) for couple in body.couples)) if torque != ZERO]


def response(body: BodyFacts) -> Formula:
    """I α along the declared turn; of a body that is carried round an upright axis also Ω² ∫ x y dm."""
    swept = ZERO if body.sweep is None else signed(body.sweep.moment, body.motion.sense)
    if body.inertia is None or body.inertia.letter == ZERO:
        return swept
    return add(body.inertia.letter * signed(body.motion.spin_rate, body.motion.sense), swept)


def carried(body: BodyFacts) -> Words:
    """Why Ω² ∫ x y dm stands in the law of a body on a turning shaft."""
    if body.sweep is None:
        return ()
    square_of_rate = square(body.sweep.rate)
    return (
        "every piece at x from the axis has the acceleration ",
        square_of_rate,
        " x towards it, together ",
        square_of_rate,
        " ∫ x y dm about the hinge",
    )


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
