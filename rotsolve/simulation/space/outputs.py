"""Outputs: what is told of a scene in space at any moment: how bodies stand, turn and travel, what joints do to them.

With n the direction of a body's axis and s² = n_x² + n_y²: tan θ = s/n_z, θ̇ = −ṅ_z/s, φ̇ = ω_z − n_z (ω_x n_x + ω_y n_y)/s² and
ψ̇ = ω₃ − φ̇ n_z; at a tilt of 0° or 180° precession and spin alone have no meaning.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.formula import Formula, add, call, multiply, negate, sqrt
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Triple,
    cross_product,
    dot_product,
    rotated,
    square,
    vector_sum,
    way_between,
)
from rotsolve.language.bodies import PointRef
from rotsolve.language.problem import Path, Problem, Term
from rotsolve.paths.meaning import NotYet
from rotsolve.simulation.space.course import CourseMoment
from rotsolve.space.attitude import IN_SPACE
from rotsolve.space.energies import kinetic_energies
from rotsolve.space.inertia import CM
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.reader import SpaceReader

IN_BODY = " in body axes"
OWN_AXES = ("x_axis", "y_axis", "z_axis")
Told = tuple[str, Formula]


class Outputs(Struct):
    """What is told of a scene whose laws are `laws`, of a motion that begins as `first` says."""

    moment: CourseMoment
    laws: SpaceLaws
    first: SpaceMoment
    problem: Problem

    def all(self) -> Iterator[Told]:
        for name in self.moment.held.order:
            yield from self.of_body(name)
        for joint in self.moment.held.joints:
            yield from self.of_joint(joint.owner, joint.free or joint.rolls)

    def of_body(self, name: str) -> Iterator[Told]:
        """Its turning, its momentum and energy, its travel."""
        moment = self.moment
        yield from self.of_turning(name)
        if not moment.held.bodies[name].moved:
            if not moment.held.pointlike(name):
                yield from self.vector(Path(name, "angular_momentum"))
            yield f"{name}.kinetic_energy", add(*kinetic_energies(self.laws, name))
        yield from parts_of_vector(f"{name}.position", self.way(name))
        if moment.held.main(name) is None:
            yield from parts_of_vector(f"{name}.velocity", moment.of_centre(name, "velocity"))

    def of_turning(self, name: str) -> Iterator[Told]:
        moment, joint = self.moment, self.moment.held.main(name)
        if moment.held.pointlike(name):
            return
        if joint is not None and joint.turning and not moment.held.bodies[name].moved:
            word, rate, _ = moment.about_hinge(name, joint)
            yield f"{name}.angle", moment.hinge_angle(name, joint)
            yield f"{name}.{word}", rate
        own = moment.own_axes(name)
        if own.rate == NOTHING:
            return
        if joint is None or not joint.turning:
            yield from parts_of_vector(f"{name}.angular_velocity", own.rate, IN_BODY)
            yield from self.of_nodding(name)
        for axis, *column in zip(OWN_AXES, *own.rows, strict=True):
            yield from parts_of_vector(f"{name}.{axis}", (column[0], column[1], column[2]))

    def of_nodding(self, name: str) -> Iterator[Told]:
        """Tilt, precession, nutation and spin of a body of which the scene speaks so."""
        if name in self.moment.held.nodding and self.moment.held.axis(name) is not None:
            yield from Tilting(self.moment, name).told()

    def way(self, name: str) -> Triple:
        """How far the centre of mass has gone since the first state."""
        ref = PointRef(name, CM)
        return way_between(place_in_space(self.first, ref), place_in_space(self.moment, ref))

    def of_joint(self, owner: str, untwisted: bool) -> Iterator[Told]:
        """The force and the torque of a joint on the body that it holds."""
        for word in ("force",) if untwisted else ("force", "torque"):
            yield from self.vector(Path(owner, word))

    def vector(self, path: Path) -> Iterator[Told]:
        """A vector along the axes of space; nothing of one that the laws do not tell alone, as of two balls on a line."""
        try:
            found, axes = SpaceReader(self.laws, {}, self.problem).vector(path, Term(path))
        except NotYet:
            return
        yield from parts_of_vector(f"{path.owner}.{path.quantity}", axes.to(IN_SPACE, found))


class Tilting:
    """How the axis of a body stands to the vertical, and how it goes round that."""

    def __init__(self, moment: CourseMoment, name: str) -> None:
        own, self.name = moment.own_axes(name), name
        axis = moment.held.axis(name)
        assert axis is not None
        self.along = dot_product(own.rate, axis)  # ω₃
        self.axis, omega = rotated(own.rows, axis), rotated(own.rows, own.rate)
        x, y, self.height = self.axis
        across = add(square(x), square(y))
        self.sine = sqrt(across)
        self.sinking = negate(cross_product(omega, self.axis)[2])  # θ̇ sin θ
        level = add(multiply(omega[0], x), multiply(omega[1], y))
        self.precession = add(omega[2], negate(multiply(self.height, level) / across))

    def told(self) -> Iterator[Told]:
        yield f"{self.name}.tilt", call("atan2", self.sine, self.height)
        yield f"{self.name}.precession", self.precession
        yield f"{self.name}.nutation", self.sinking / self.sine
        yield f"{self.name}.spin", add(self.along, negate(multiply(self.precession, self.height)))
        yield f"{self.name}.axial_rate", self.along


def parts_of_vector(name: str, vector: Triple, axes: str = "") -> Iterator[Told]:
    """The three components of a vector, none of one that is nothing."""
    if vector != NOTHING:
        for axis, part in zip(AXES, vector, strict=True):
            yield f"{name}.{axis}{axes}", part


def place_in_space(moment: SpaceMoment, ref: PointRef) -> Triple:
    """Where a point is in space, from the point of the ground that holds its body, or from where the body's centre was at first."""
    joint = moment.held.main(ref.owner)
    base = NOTHING
    if joint is None and isinstance(moment, CourseMoment):
        x, y, z = (moment.own_letter("displacement", ref.owner, axis) for axis in AXES)
        base = (x, y, z)
    elif joint is not None and joint.carrier.owner in moment.held.bodies:
        base = place_in_space(moment, joint.carrier)
    return vector_sum(base, moment.axes(ref.owner).to(IN_SPACE, moment.arm(ref)))
