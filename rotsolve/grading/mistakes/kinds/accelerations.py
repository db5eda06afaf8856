"""Mistakes with accelerations: that towards the centre of a circle, or that of the centre of mass, left out."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Power, Symbol
from rotsolve.core.alteration import Alteration
from rotsolve.core.equation import Equation
from rotsolve.core.facts import BodyFacts
from rotsolve.grading.mistakes.kinds.places import Made
from rotsolve.grading.mistakes.mistake import Change

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene


def at_rest(scene: Scene) -> Made:
    """0 for α r in Newton's second law of what turns about an axis, as if its centre of mass stood still."""
    rates = frozenset(
        Symbol(letter)
        for facts in scene.moments
        for body in facts.bodies
        if body.motion.kind == "axis" and body.cm.parts
        for letter in body.motion.spin_rate.symbols()
    )
    if rates:
        altered = Alteration(equation=lambda equation: unmoving(equation, rates))
        yield "the acceleration of the centre of mass was left out", Change(altered=altered)


def unmoving(equation: Equation, rates: Collection[Formula]) -> Equation:
    """Newton's second law without angular accelerations."""
    if not equation.label.startswith("Newton's second law"):
        return equation
    sides = (side.transform(lambda node: ZERO if node in rates else node) for side in (equation.left, equation.right))
    left, right = sides
    return replace(equation, left=left, right=right)


def no_centripetal(scene: Scene) -> Made:
    """0 for m v²/r and m r ω² in Newton's second law."""
    speeds = frozenset(speed for facts in scene.moments for body in facts.bodies for speed in speeds_of(body))
    if speeds:
        altered = Alteration(equation=lambda equation: uncurved(equation, speeds))
        yield "the acceleration towards the centre of the circle was left out", Change(altered=altered)


def speeds_of(body: BodyFacts) -> Iterator[Formula]:
    """The letters of its speeds, where its centre of mass goes round in a circle."""
    if body.cm.parts or body.motion.bend is not None:
        rates = [body.motion.spin, *(size for size, _ in body.motion.velocity.parts)]
        yield from (Symbol(name) for rate in rates for name in rate.symbols())


def uncurved(equation: Equation, speeds: Collection[Formula]) -> Equation:
    """Newton's second law without the squares of speeds."""
    if not equation.label.startswith("Newton's second law"):
        return equation

    def change(node: Formula) -> Formula:
        return ZERO if isinstance(node, Power) and node.base in speeds else node

    return replace(equation, left=equation.left.transform(change), right=equation.right.transform(change))
