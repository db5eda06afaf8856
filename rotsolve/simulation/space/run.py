"""Run in space: a motion in space that has been followed, and what its report says of it."""

from __future__ import annotations

from functools import cached_property
from typing import ClassVar

from rotsolve.simulation.balance import Drift
from rotsolve.simulation.run import Run
from rotsolve.simulation.space.keeping import drift_in_space


class SpaceRun(Run, dict=True):
    """A motion in space."""

    signs: ClassVar[str] = (
        "Rotation is positive about the axis that is named, positions count from where a centre of mass is at first; components are along "
        "the axes of space where no others are named."
    )
    shown: ClassVar[tuple[str, ...]] = (
        "angle",
        "tilt",
        "precession",
        "spin",
        "angular_velocity",
        "angular_momentum",
        "kinetic_energy",
        "position",
        "velocity",
    )

    @cached_property
    def drift(self) -> Drift:
        """How far energy and what is kept of angular momenta are from what they must be."""
        return drift_in_space(self.regimes)
