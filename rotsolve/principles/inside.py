"""Inside a rod: Newton's laws for the piece on one side of a cut, which moves with the whole."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.equation import NEWTON, Equation
from rotsolve.core.facts import Cut, Facts, Inertia, signed
from rotsolve.core.writing import law, spoken
from rotsolve.principles.newton import along
from rotsolve.principles.rotation import rotation_of, torque_about

COST = 4  # above the laws for the whole rod, so that what is found at a cut stands where its diagram is


def of_pieces(facts: Facts, section: str) -> Iterator[Equation]:
    """m and I of every piece, Σ F = m a along and across the rod, and Σ τ = I α."""
    for cut in facts.cuts:
        body = cut.body
        definitions = [cut.mass] if body.inertia is None else [cut.mass, body.inertia]
        yield from (
            definition(item, body.name, section) for item in definitions if item.letter not in (ZERO, item.formula)
        )
        for axis in body.axes:
            equation = along(body, axis, section)
            if equation is not None:
                yield replace(equation, cost=COST)
        turning = about_cut(cut, section) if still(cut) else rotation_of(body, section)
        yield from (replace(equation, cost=COST) for equation in turning)


def definition(item: Inertia, name: str, section: str) -> Equation:
    defines = next(iter(item.letter.symbols()), "")
    return Equation(item.letter, item.formula, item.label, section, "", 1, item.remark, defines, bodies=(name,))


def still(cut: Cut) -> bool:
    """Whether the rod does not accelerate."""
    motion = cut.body.motion
    return motion.spin_rate == ZERO and not any(size != ZERO for size, _ in motion.acceleration.parts)


def about_cut(cut: Cut, section: str) -> Iterator[Equation]:
    """Στ = 0 of a rod in equilibrium, about the cut, where compression and shear have no arm."""
    body, sense = cut.body, cut.body.motion.sense
    away = [force for force in body.forces if force.arm != cut.at]
    torques: list[Formula] = [signed(torque_about(cut.at, force), sense) for force in away]
    torques += [signed(couple.torque, sense) for couple in body.couples]
    label = f"balance of torques about the cut, {spoken(body.name)}"
    yield Equation(*law(torques, ZERO), label, section, NEWTON, 3, bodies=(body.name,))
