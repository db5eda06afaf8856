"""Equation: one law or rule, as a textbook writes it, with its reason and the place in the derivation where it belongs."""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Integral
from rotsolve.core.derivation import Words

NEWTON, ENERGY, ANGULAR_MOMENTUM = "newton", "energy", "angular-momentum"
KINEMATICS = "kinematics"  # motion in time: used with every law, but not where only one moment is looked at
LAWS = (NEWTON, ENERGY, ANGULAR_MOMENTUM)  # what `--law` may name; an equation without a law serves them all

DERIVATIVE = "derivative of the energy"  # the label of what may stand in for one of Newton's laws of its bodies


class Equation(Struct, frozen=True):
    """left = right.

    `family` is one of LAWS, or '' for rules and definitions; `label` names the law and the body; `section` the state, phase or event
    where it is written; `cost` orders plans (a textbook's first choice costs least). `defines` names the symbol that a
    definition introduces, which the solver puts in first. `relation` is ≈ where small quantities have been left out.
    """

    left: Formula
    right: Formula
    label: str
    section: str
    family: str = ""
    cost: int = 2
    remark: Words = ()
    defines: str = ""
    bodies: tuple[str, ...] = ()
    relation: str = "="

    def symbols(self) -> frozenset[str]:
        return self.left.symbols() | self.right.symbols()

    def summed(self) -> frozenset[str]:
        """Letters within its integrals, which it can not be solved for."""
        if not (self.left.holds(Integral) or self.right.holds(Integral)):
            return frozenset()
        integrals = [
            node for side in (self.left, self.right) for node in side.walk(Integral) if isinstance(node, Integral)
        ]
        return frozenset(name for node in integrals for name in node.integrand.symbols())

    def renamed(self, names: dict[str, Formula]) -> Equation:
        remark = tuple(part.substitute(names) if isinstance(part, Formula) else part for part in self.remark)
        return replace(self, left=self.left.substitute(names), right=self.right.substitute(names), remark=remark)
