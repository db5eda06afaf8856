"""Steady rotation: one turn in a period, T = 2π/ω, with no angular acceleration."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import PI, ZERO, Call, Formula, Symbol
from rotsolve.core.equation import KINEMATICS, Equation
from rotsolve.core.facts import Facts, signed
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.writing import spoken


def steady_rotation(facts: Facts, section: str) -> Iterator[Equation]:
    """T = 2π/ω of every body whose period is spoken of; where it is given, the body turns along its positive sense."""
    for body in facts.bodies:
        period, motion = body.period, body.motion
        if period is None:
            continue
        spin = signed(motion.spin, motion.sense)
        asked = isinstance(period, Symbol) and SEPARATOR in period.name
        rate: Formula = Call("abs", (spin,)) if asked else spin
        name = spoken(body.name)
        yield Equation(
            period, 2 * PI / rate, f"period of {name}, T = 2π/ω", section, KINEMATICS, 1, bodies=(body.name,)
        )
        yield Equation(motion.spin_rate, ZERO, f"{name} turns steadily", section, KINEMATICS, 1, bodies=(body.name,))
