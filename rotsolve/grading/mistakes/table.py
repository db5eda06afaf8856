"""The table of mistakes that are recognised, the commonest first.

To add a mistake: a function from a scene to the words and changes with which it can be made there, and a row in MISTAKES, by how common it
is. docs/mistakes.md has the same rows; a test holds them together.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from msgspec import Struct

from rotsolve.grading.mistakes import energies, forces, impacts, in_space, inertias, misread
from rotsolve.grading.mistakes.mistake import Made, Mistake
from rotsolve.grading.mistakes.scene import Scene


class MistakeKind(Struct, frozen=True):
    """One entry: its name, what it is in general, and how it is made at each place of a scene where it can be."""

    name: str
    words: str
    made: Callable[[Scene], Made]

    def mistakes(self, scene: Scene) -> Iterator[Mistake]:
        """The mistakes of this kind in a scene: at one place after the other, then at all together."""
        return (Mistake(self.name, words, change) for words, change in self.made(scene))


MISTAKES = [
    MistakeKind(*row)
    for row in (
        ("pulley without inertia", "the moment of inertia of a wheel or pulley is left out", inertias.pulleys),
        ("equal tensions", "the tensions on both sides of a heavy pulley are taken as equal", forces.equal_tensions),
        ("tension as weight", "T = m g is put for the tension on a body that falls or rises", forces.tension_as_weight),
        ("no rotational energy", "the rotation of a rolling or unwinding body is left out", inertias.rotational_energy),
        (
            "wrong shape factor",
            "the moment of inertia of another shape is used: m R² for ½ m R²",
            inertias.shape_factors,
        ),
        ("no parallel axes", "I about the centre of mass is used for I about the axis", inertias.parallel_axes),
        ("sine for cosine", "sine and cosine of an angle are exchanged", misread.sine_for_cosine),
        ("degrees as radians", "30° is put in as 30 rad", misread.degrees_as_radians),
        (
            "revolutions as radians",
            "rev/min is put in as rad/s, or only its 2π or its 60 is left out",
            misread.revolutions_as_radians,
        ),
        ("hertz as radians", "Hz is put in as rad/s", misread.hertz_as_radians),
        ("diameter for radius", "the diameter is put for the radius, or the radius is halved", misread.diameters),
        ("sign of gravity", "the weight of a body has the wrong sign", forces.gravity_sign),
        ("sign of friction", "friction, or its torque, has the wrong sign", forces.friction_sign),
        ("point mass", "a hinged body is taken as a point mass at its centre of mass", inertias.point_masses),
        ("hinge left out", "the force of a hinge is left out of Newton's second law", forces.no_reaction),
        (
            "momentum kept",
            "momentum is taken as conserved in a blow though a support pushes too",
            energies.momentum_through_support,
        ),
        ("energy kept", "kinetic energy is taken as conserved in an event that loses some", energies.energy_kept),
        (
            "about the centre in a blow",
            "angular momentum is taken about the centre of mass of what a support holds, which pushes too",
            impacts.about_the_centre,
        ),
        (
            "centre held",
            "the centre of mass of a free body is taken as held in a blow",
            impacts.centre_held,
        ),
        (
            "restitution of the centres",
            "the speeds of the centres of mass are put into the coefficient of restitution",
            impacts.restitution_of_centres,
        ),
        ("work left out", "mechanical energy is taken as conserved though work is done", energies.no_work),
        ("friction left out", "friction is left out", forces.no_friction),
        ("normal force as weight", "the normal force is taken as m g, as on the level", forces.normal_as_weight),
        (
            "carrier at rest",
            "a wedge or the like is taken as at rest for what slides or rolls on it, N = m g cos β",
            forces.carrier_at_rest,
        ),
        ("mass for weight", "m is put for m g", forces.no_weight),
        ("half left out", "the half of ½ m v² or ½ I ω² is left out", energies.halves),
        ("half of the way left out", "the half of ½ a t² is left out", energies.half_of_way),
        ("weight at the end", "the weight of a hinged rod is taken to act at its end", forces.weight_at_end),
        ("mass at the end", "a hinged rod is taken as a point mass at its end", forces.mass_at_end),
        ("radius left out", "the radius is left out of a torque", forces.no_radius),
        ("sign of tension", "the tension on a hanging body has the wrong sign", forces.tension_sign),
        ("centripetal force left out", "m v²/r is left out of Newton's second law", forces.no_centripetal),
        ("centre at rest", "α r is left out of Newton's second law for the forces of a hinge", forces.centre_at_rest),
        (
            "rim as fast as the centre",
            "the velocity of the centre of a roller or a drum is put for that of its rim, on which something lies",
            forces.rim_as_centre,
        ),
        ("start from rest", "a velocity at the start is left out", misread.from_rest),
        ("letters exchanged", "m₁ is put for m₂, or one radius for another", misread.letters_exchanged),
        ("centre of mass counted twice", "½ m v² is added to ½ I ω² about a fixed axis", inertias.twice_moving),
        (
            "products of inertia",
            "the products of inertia have the wrong sign, +Σ m x y for −Σ m x y",
            in_space.opposite_products,
        ),
        ("Ω × L left out", "dL/dt is taken in axes that turn, as if they stayed in space", in_space.without_carrying),
        (
            "tensor not moved",
            "the inertia tensor about the centre of mass is used for that about another point",
            in_space.unmoved_tensors,
        ),
        (
            "momentum along ω",
            "L is taken along ω, with one moment of inertia for the tensor",
            in_space.momentum_along_rate,
        ),
        (
            "sense of the torque",
            "the torque has the wrong sense, that on the bearings for that on the body",
            in_space.opposite_torque,
        ),
        (
            "spin for ω₃",
            "the spin ψ̇ is put for ω₃ = ψ̇ + φ̇ cos θ, or the other way round",
            in_space.spin_for_axial_rate,
        ),
        ("fast top", "the formula of a fast top is used where the exact one is asked", in_space.fast_top),
        ("other root", "the fast precession is given for the slow one, or the other way round", in_space.other_root),
        (
            "moments exchanged",
            "the moment of inertia across the axis is used for that about it, and the other way round",
            in_space.exchanged_moments,
        ),
        (
            "parallel axes subtracted",
            "M d² is taken away where it has to be added to a tensor",
            in_space.moved_the_other_way,
        ),
        ("sense of a turn", "a body is turned the other way round", in_space.sense_of_turns),
        ("order of turns", "turns in space are made in the other order", in_space.order_of_turns),
        (
            "centre kept",
            "the acceleration of the centre of mass is left out of the forces in space",
            in_space.centre_kept,
        ),
        ("units not converted", "cm is put in as m, g as kg", misread.units_not_converted),
    )
]
