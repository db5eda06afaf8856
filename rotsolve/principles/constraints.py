"""Rate rules: how strings, contacts, joints and drives tie the motions of bodies together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, negate
from rotsolve.core.equation import KINEMATICS, Equation
from rotsolve.core.facts import Facts, Rule
from rotsolve.core.writing import flat, is_negative


def for_accelerations(facts: Facts, section: str) -> Iterator[Equation]:
    """The rules for accelerations."""
    for rule in facts.rules:
        if rule.acceleration is not None:
            yield written(rule, rule.acceleration, section)


def for_velocities(facts: Facts, section: str) -> Iterator[Equation]:
    """The rules for velocities."""
    for rule in facts.rules:
        yield written(rule, rule.velocity, section)


def for_displacements(facts: Facts, changes: Mapping[str, Formula], section: str) -> Iterator[Equation]:
    """The rules for displacements and angles turned, with `changes` put in for the rates; only where their coefficients never change."""
    for rule in facts.rules:
        if rule.linear:
            left, right = (side.substitute(dict(changes)) for side in rule.velocity)
            yield replace(written(rule, (left, right), section), family=KINEMATICS)


def written(rule: Rule, sides: tuple[Formula, Formula], section: str) -> Equation:
    """A rule as an equation; two sides that are both negative are turned round."""
    if all(is_negative(term) for side in sides for term in flat([side])):
        sides = negate(sides[0]), negate(sides[1])
    return Equation(sides[0], sides[1], rule.label, section, "", 2, rule.remark, bodies=rule.bodies)
