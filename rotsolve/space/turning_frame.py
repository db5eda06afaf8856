"""Energy in the frame that turns with what is driven at a constant rate: T₂ − T₀ + V of all that it carries stays the same.

With places and rates told against the driven body the energy function Σ q̇ ∂L/∂q̇ − L is that: T₂ is the kinetic energy in the frame, −T₀
the potential energy −½ m Ω² ρ² of the centrifugal force (Goldstein, Poole & Safko, Classical Mechanics, §2.7 and §4.10).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.core.equation import TURNING_FRAME, Equation, frame_remark
from rotsolve.core.writing import flat, moved, spoken
from rotsolve.space.lagrangian import motions_in_space

if TYPE_CHECKING:
    from rotsolve.motion.timeline import Interval
    from rotsolve.space.scene import SpaceEquations


def energy_in_frame(scene: SpaceEquations, interval: Interval) -> Iterator[Equation]:
    """T₂ − T₀ + V at both ends of a phase, of each group of bodies that one of them turns at a constant rate."""
    before, after = scene.dynamics[interval.start], scene.dynamics[interval.end]
    for motions in motions_in_space(scene, before):
        drives = [joint for joint in scene.held.joints if joint.drive and joint.body.owner in motions.names]
        led = any(scene.held.bodies[name].moved for name in motions.names)
        grounded = [joint for joint in drives if joint.carrier.owner not in scene.held.bodies]
        if len(drives) != 1 or led or not grounded or not scene.held.driven_evenly(drives[0]):
            continue
        motion, terms = motions.motion, motions.motion.energy
        pushed = any(not is_zero(differentiate(power, q.rate)) for power in motion.given for q in motion.coordinates)
        if not terms or pushed:
            continue
        ends = [[now(term) for term in terms] for now in map(motions.putting_in, (before, after))]
        left, right = moved(*map(flat, ends))
        if not is_zero(left - right):
            name = spoken(drives[0].body.owner)
            remark = frame_remark(name)
            yield TURNING_FRAME.equation(left, right, interval.name, motions.names, remark, driven=name, work="")
