"""Energy in the frame that turns with what is driven at a constant rate: K′ + U − ½ I Ω² stays the same (Jacobi's integral).

What drives it may do any work: in that frame it does none, as what it turns is at rest there. The Coriolis force is square to the motion,
and the centrifugal force has the potential energy −½ m Ω² r² (Goldstein, Poole & Safko, Classical Mechanics, §2.7).
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import HALF, Formula, negate, total
from rotsolve.core.drive import TURNING
from rotsolve.core.equation import TURNING_FRAME, Equation, frame_remark
from rotsolve.core.facts import BodyFacts, Facts, Force, square
from rotsolve.core.passage import Passage
from rotsolve.core.writing import moved, spoken
from rotsolve.laws.table import OverPhase


def energy_in_turning_frame(over: OverPhase) -> Iterator[Equation]:
    """K′₁ + U′₁ + W = K′₂ + U′₂ of a body along which something slides or is drawn, that is driven steadily and tied to nothing."""
    passage = over.passage
    for body in passage.midst.bodies:
        ends = [turned_steadily(body.name, facts) for facts in (passage.start, passage.end)]
        if (
            not body.changing
            or None in ends
            or frozenset((body.name,)) not in passage.groups
            or disturbed(body, passage)
        ):
            continue
        first, last = (
            frame_energy(one, facts) for one, facts in zip(ends, (passage.start, passage.end), strict=True) if one
        )
        works = [work.amount for work in passage.works if work.inner and body.name in work.bodies]
        name = spoken(body.name)
        sides, work = moved([*first, *works], last), " + W" if works else ""
        yield TURNING_FRAME.equation(*sides, over.section, (body.name,), frame_remark(name), driven=name, work=work)


def turned_steadily(name: str, facts: Facts) -> BodyFacts | None:
    """A body that is driven about a fixed axis at a rate that stays the same."""
    body, drives = facts.body(name), [item.drive for item in facts.given if item.drive.body == name]
    steady = [drive for drive in drives if drive.word in TURNING and is_zero(drive.rates()[TURNING[2]])]
    return body if body is not None and body.motion.kind == "axis" and steady else None


def disturbed(body: BodyFacts, passage: Passage) -> bool:
    """Whether more than inner forces and springs between its parts does work in the frame of a driven body, or its mass changes.

    What turns all of it moves nothing there; a force on it may push what slides, unless that is a support's or has a potential energy in
    the frame: its torque about the axis is nothing.
    """
    masses = {known.mass for facts in (passage.start, passage.end) if (known := facts.body(body.name)) is not None}
    by_owner: dict[str, list[Force]] = {}
    for force in body.forces:
        by_owner.setdefault(force.owner, []).append(force)
    turns = (total([force.torque for force in forces]) for forces in by_owner.values())
    idle = all(force.role.stores or force.internal or not force.works for force in body.forces)
    return len(masses) > 1 or not idle or not all(is_zero(simplify(torque)) for torque in turns)


def frame_energy(body: BodyFacts, facts: Facts) -> list[Formula]:
    """½ m v² along the body of all that slides on it, −½ I Ω², and the energy of springs on it, term by term."""
    terms = [HALF * item.mass * square(item.speed) for item in body.sliding]
    if body.inertia is not None:
        terms.append(negate(HALF * body.inertia.letter * square(body.motion.spin)))
    return [*terms, *(item.energy for item in facts.potentials if body.name in item.bodies)]
