"""Angular momentum about a fixed point of the surface along which a body slides and rolls: friction, whatever it is, has no arm there."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.derivation import Words
from rotsolve.core.equation import COMMON_AXIS, Equation
from rotsolve.core.facts import BodyFacts, signed
from rotsolve.core.vectors.heading import Vector
from rotsolve.core.writing import flat, positive_first, spoken
from rotsolve.laws.groups import newton_about, one_contact
from rotsolve.laws.table import OverPhase


def about_points_of_surfaces(over: OverPhase) -> Iterator[Equation]:
    """I ω₁ + m v₁ R = I ω₂ + m v₂ R of a round body on a straight line, where all but what presses and rubs at its contact acts without an
    arm about that: weight and normal force balance then.
    """
    passage = over.passage
    for body in passage.midst.bodies:
        motion, point = body.motion, one_contact(body)
        first, last = passage.start.body(body.name), passage.end.body(body.name)
        if point is None or first is None or last is None or body.inertia is None or body.changing:
            continue
        if motion.kind != "line" or not motion.turns or motion.bend is not None or body.cm.parts:
            continue
        if not any(force.role.rubs and force.size != ZERO for force in body.forces) or newton_about(point, body)[0]:
            continue
        before, after = (momenta_about(point, body, item) for item in (first, last))
        if before and flat(after):
            words: Words = (
                f"About a fixed point of the surface friction on {spoken(body.name)} has no arm, whatever it is; weight and normal force"
                " balance along one line",
            )
            label = "angular momentum about a point of the surface is conserved"
            sides = positive_first(before), positive_first(after)
            yield COMMON_AXIS.equation(*sides, over.section, (body.name,), words, words=label)


def momenta_about(point: Vector, body: BodyFacts, moment: BodyFacts) -> list[Formula]:
    """I ω and r × m v at one end of a phase, r from the line of the surface to the centre."""
    assert body.inertia is not None
    sense = body.motion.sense
    orbital = signed((-point).cross(moment.motion.velocity.scaled(body.mass)), sense)
    spin = signed(moment.motion.spin, sense)
    return flat([term for term in (body.inertia.letter * spin, orbital) if term != ZERO])
