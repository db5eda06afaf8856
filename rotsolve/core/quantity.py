"""Quantities that a scene can ask for or state: the path words, their dimension, textbook letter and owners."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.units.dimension import DIMENSIONS, NONE, Dimension

NUMBER = NONE
PLANE = ("x", "y")
SPACE = ("x", "y", "z")
MOTION = ("x", "y", "z", "tangential", "normal")
BODY, POINT, LINK, ACTION, EVENT, SYSTEM = "body", "point", "connection", "action", "event", "system"


class QuantityKind(Struct, frozen=True):
    """A word of a path. `letter` is the textbook symbol as an ASCII name; `owners` are the kinds of things that have it.

    `measures` names its kind in the table of kinds (algebra/units/dimension); `nonnegative` says that a scene gives it no negative value,
    `space` that only scenes in space have it.

    A connection, action or event has only those words that its class lists in `quantities`.
    """

    word: str
    dimension: Dimension
    letter: str
    owners: tuple[str, ...]
    components: tuple[str, ...] = ()
    help: str = ""
    later: bool = False
    measures: str = ""
    nonnegative: bool = False
    space: bool = False


def kind(
    word: str,
    measures: str,
    letter: str,
    owners: tuple[str, ...],
    help: str,
    components: tuple[str, ...] = (),
    later: bool = False,
    nonnegative: bool = False,
    space: bool = False,
) -> QuantityKind:
    return QuantityKind(
        word, DIMENSIONS[measures], letter, owners, components, help, later, measures, nonnegative, space
    )


QUANTITIES: dict[str, QuantityKind] = {
    entry.word: entry
    for entry in (
        kind("angle", "angle", "theta", (BODY, LINK), "from the rightward horizontal, counterclockwise, unwrapped"),
        kind("rotation", "angle", "theta", (BODY, LINK), "signed change of the angle since the state before"),
        kind(
            "angular_velocity",
            "angular velocity",
            "omega",
            (BODY, LINK),
            "rate of the angle along the declared sense",
            SPACE,
        ),
        kind(
            "angular_acceleration", "angular acceleration", "alpha", (BODY, LINK), "rate of the angular velocity", SPACE
        ),
        kind("period", "time", "T", (BODY,), "time of one turn of a steady rotation"),
        kind(
            "instantaneous_centre",
            "length",
            "x",
            (BODY,),
            "the point of a body in the plane that is at rest for a moment, from its centre of mass",
            PLANE,
        ),
        kind("position", "length", "r", (BODY, POINT), "place in the scene's coordinates", SPACE),
        kind(
            "displacement",
            "length",
            "x",
            (BODY, POINT, LINK),
            "signed change of position along the declared sense; of a contact with a side of a body, down that",
            MOTION,
        ),
        kind("distance", "length", "d", (BODY, POINT), "length of the way covered", nonnegative=True),
        kind("height", "length", "h", (BODY, POINT), "height above the lowest place or the floor"),
        kind(
            "velocity",
            "velocity",
            "v",
            (BODY, POINT, LINK),
            "signed along the declared sense; of a contact with a side of a body, down that and relative to it",
            (*MOTION, "radial"),
        ),
        kind("speed", "velocity", "v", (BODY, POINT), "size of the velocity", nonnegative=True),
        kind(
            "acceleration",
            "acceleration",
            "a",
            (BODY, POINT, LINK),
            "signed along the declared sense; of a point, its size; of a contact as its velocity",
            MOTION,
        ),
        kind(
            "force",
            "force",
            "F",
            (BODY, LINK, ACTION, EVENT),
            "force on the last-named body",
            (*MOTION, "net", "gravity"),
        ),
        kind("tension", "force", "T", (LINK,), "pull of a string, at one of its ends where a pulley is heavy"),
        kind("normal_force", "force", "N", (LINK,), "push of a surface across itself"),
        kind(
            "friction_force",
            "force",
            "f",
            (LINK,),
            "friction along the surface, on the body that its contact names first",
        ),
        kind("friction", "number", "mu", (LINK,), "coefficient of friction of a contact"),
        kind(
            "torque",
            "torque",
            "tau",
            (BODY, LINK, ACTION),
            "torque about the axis; `about` names another point",
            (*SPACE, "net", "gravity"),
        ),
        kind("impulse", "impulse", "J", (BODY, LINK, ACTION, EVENT), "force summed over time", PLANE),
        kind("angular_impulse", "angular impulse", "H", (BODY, LINK, ACTION, EVENT), "torque summed over time"),
        kind("work", "energy", "W", (BODY, LINK, ACTION), "work done in a phase", ("net", "gravity")),
        kind("power", "power", "P", (BODY, LINK, ACTION), "rate of work", ("net", "gravity")),
        kind(
            "kinetic_energy",
            "energy",
            "K",
            (BODY, SYSTEM),
            "of a body, or of the whole scene; about a fixed axis or point all of it is rotational",
            ("rotational", "translational"),
        ),
        kind(
            "potential_energy",
            "energy",
            "U",
            (BODY, LINK, SYSTEM),
            "of a spring or wire; of gravity and of all, as `change of` or `lost`",
        ),
        kind(
            "energy", "energy", "E", (BODY, SYSTEM), "kinetic and potential energy together, as `change of` or `lost`"
        ),
        kind("momentum", "momentum", "p", (BODY, SYSTEM), "mass times velocity of the centre of mass", PLANE),
        kind(
            "angular_momentum",
            "angular momentum",
            "L",
            (BODY, POINT, SYSTEM),
            "about the axis; `about` names another point; `body.PART.angular_momentum` is a part's share",
            SPACE,
        ),
        kind(
            "inertia",
            "moment of inertia",
            "I",
            (BODY, SYSTEM),
            "moment of inertia about `cm`, or `about` a point",
            nonnegative=True,
        ),
        kind("gyration", "length", "k", (BODY,), "radius of gyration", nonnegative=True),
        kind("cm", "length", "x", (BODY, SYSTEM), "place of the centre of mass in the body's coordinates", SPACE),
        kind("mass", "mass", "m", (BODY, SYSTEM), "mass", nonnegative=True),
        kind(
            "radius",
            "length",
            "R",
            (BODY,),
            "radius; of a body that rides on another, its distance from the axis",
            nonnegative=True,
        ),
        kind("length", "length", "L", (BODY, LINK), "length", nonnegative=True),
        kind("elongation", "length", "x", (LINK,), "stretch of a spring beyond its rest length"),
        kind("stiffness", "stiffness", "k", (LINK,), "stiffness of a spring", nonnegative=True),
        kind("turns", "number", "n", (BODY,), "number of turns since the state before"),
        kind("time", "time", "t", (SYSTEM,), "time: `time from A to B`", nonnegative=True),
        kind("swing_period", "time", "T", (), "`period of small swings`: time of one swing to and fro"),
        kind("frequency", "frequency", "f", (), "`frequency of small swings`: swings in a unit of time"),
        kind(
            "angular_frequency",
            "angular velocity",
            "omega0",
            (),
            "`angular_frequency of small swings`: 2π times the frequency",
        ),
        kind(
            "amplitude_ratio",
            "number",
            "r",
            (),
            "`ratio of A to B in mode 1`: of two displacements or rotations in a mode",
        ),
        kind("damping_ratio", "number", "zeta", (), "`damping_ratio of small swings`: γ/ω₀ of damped ones"),
        kind(
            "time_constant", "time", "tau", (), "`time_constant of small swings`: in which damped ones die down to 1/e"
        ),
        kind(
            "logarithmic_decrement",
            "number",
            "Lambda",
            (),
            "`logarithmic_decrement of small swings`: γ T of damped ones",
        ),
        kind("bending_moment", "torque", "M", (POINT,), "inside a rod at a point; positive where it sags"),
        kind("shear", "force", "V", (POINT,), "across a rod at a point, from the part before it on the part beyond"),
        kind("compression", "force", "C", (POINT,), "along a rod at a point; negative where it is pulled"),
        kind("tilt", "angle", "theta", (BODY,), "angle of the body's axis from the vertical", space=True),
        kind(
            "precession_angle",
            "angle",
            "phi",
            (BODY,),
            "angle about the vertical, of the line of nodes from x",
            space=True,
        ),
        kind(
            "spin_angle",
            "angle",
            "psi",
            (BODY,),
            "angle about the body's axis, of its own x from the line of nodes",
            space=True,
        ),
        kind(
            "precession",
            "angular velocity",
            "Omega",
            (BODY,),
            "rate at which the body's axis goes round the vertical; of a free body round its angular momentum",
            space=True,
        ),
        kind("nutation", "angular velocity", "nu", (BODY,), "rate of the tilt", space=True),
        kind(
            "spin",
            "angular velocity",
            "s",
            (BODY,),
            "rate about the body's axis, relative to the axes of the line of nodes, or to what carries it",
            space=True,
        ),
        kind(
            "axial_rate",
            "angular velocity",
            "omega3",
            (BODY,),
            "component of the angular velocity along the body's axis, spin + precession · cos tilt",
            space=True,
        ),
        kind(
            "inertia_tensor",
            "moment of inertia",
            "I",
            (BODY,),
            "tensor about `cm`, or `about` a point; its products are −Σ m x y",
            ("xx", "yy", "zz", "xy", "yz", "zx"),
        ),
        kind(
            "principal_moments",
            "moment of inertia",
            "I",
            (BODY,),
            "eigenvalues of the inertia tensor, from the smallest on, about `cm` or `about` a point",
            ("1", "2", "3"),
            space=True,
        ),
        kind(
            "principal_axis",
            "number",
            "e",
            (BODY,),
            "direction of the axis of the one principal moment that differs from two equal ones; `principal_axis.1`, `.2`, `.3` those of "
            "the moments from the smallest on; of its two senses either is right",
            ("1", "2", "3"),
            space=True,
        ),
        kind(
            "vertical",
            "number",
            "n",
            (BODY,),
            "the upward vertical in the body's own axes, as a state tells it",
            SPACE,
            space=True,
        ),
        kind("x_axis", "number", "e", (BODY,), "direction of the body's own x axis", SPACE, space=True),
        kind("y_axis", "number", "e", (BODY,), "direction of the body's own y axis", SPACE, space=True),
        kind("z_axis", "number", "e", (BODY,), "direction of the body's own z axis", SPACE, space=True),
        kind(
            "rotation_angle",
            "angle",
            "theta",
            (BODY,),
            "angle of the one rotation that all its turns come to, 0 to 180°",
            space=True,
        ),
        kind("rotation_axis", "number", "n", (BODY,), "axis of that rotation", SPACE, space=True),
        kind(
            "freedoms",
            "number",
            "f",
            (BODY, LINK),
            "how many independent ways it can move, or a connection lets its body move",
            ("translations", "rotations"),
            space=True,
        ),
        kind(
            "stability",
            "squared rate",
            "lambda2",
            (BODY,),
            "λ² of a small disturbance that goes as exp(λ t): the motion is stable where it is negative",
            space=True,
        ),
    )
}
INSIDE = ("bending_moment", "shear", "compression")  # what acts at a cut through a rod
SPANNED = ("displacement", "rotation", "turns", "work", "impulse", "angular_impulse", "time", "distance")  # of a phase
MEAN_OF = {  # what the mean of a quantity is the mean of, over time
    "power": "work",
    "angular_velocity": "rotation",
    "velocity": "displacement",
    "speed": "distance",
    "acceleration": "velocity",
    "angular_acceleration": "angular_velocity",
    "force": "impulse",
    "torque": "angular_impulse",
}
VECTORS = (  # what has three components in space
    "position",
    "displacement",
    "velocity",
    "acceleration",
    "angular_velocity",
    "angular_acceleration",
    "force",
    "torque",
    "impulse",
    "angular_impulse",
    "momentum",
    "angular_momentum",
)
DIRECTED = (
    *VECTORS,
    "vertical",
    "x_axis",
    "y_axis",
    "z_axis",
    "rotation_axis",
    "principal_axis",
)  # between which there are angles
EITHER_WAY = ("principal_axis",)  # directions that have no sense: the angle of one from a vector is the acute one
INERTIAL = ("centrifugal", "euler", "coriolis")  # forces in a frame that turns
FELT = {"force": INERTIAL}  # components that a quantity has beside its three in space
BEARINGS = {"bearing1": "bearing 1", "bearing2": "bearing 2"}  # of a hinge in space, and how they are spoken of
OF_BEARINGS = ("force", "impulse")  # what is told of each bearing of a hinge
DAMPINGS = ("damping_ratio", "time_constant", "logarithmic_decrement")  # of damped swings
FREQUENCIES = ("swing_period", "frequency", "angular_frequency")  # of swings, and of each of their modes
OSCILLATING = {  # what is asked of swings, and how it is said
    "swing_period": "period",
    "frequency": "frequency",
    "angular_frequency": "angular frequency",
    "amplitude_ratio": "ratio of amplitudes",
    "damping_ratio": "damping ratio",
    "time_constant": "time constant",
    "logarithmic_decrement": "logarithmic decrement",
}
