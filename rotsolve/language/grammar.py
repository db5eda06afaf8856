"""Grammar: the keys of a scene and of its parts, and the words of `find`; reader, schema, help and docs read these tables."""

from __future__ import annotations

from rotsolve.language.keys import Key

SENSES = ("left", "right", "up", "down")
TURNS = ("clockwise", "counterclockwise")
LATER = {"later": True}

SECTIONS: dict[str, Key] = {
    "title": Key("text", "what the scene is, in one line", example="Block on a slope"),
    "source": Key("text", "where the problem comes from", example="Homework 3, problem 2"),
    "text": Key(
        "text",
        "the statement, for answer keys; `{m}` prints a given as m = 2 kg, `{value of m}` as 2 kg",
        example="A block of mass {m} slides down.",
    ),
    "given": Key("map", "letters with values (`m: 2 kg`), dimensions (`m: kg`), formulas (`L: 2*R`) or `unknown`"),
    "unknown": Key("names", "letters that are asked for, beside those given as `unknown`", example="[m]"),
    "gravity": Key(
        "gravity",
        "a value, a given, or `none`; 9.8 m/s^2 down when nothing is said; in space `{size: g, in: earth}` turns with a body",
        dimension="acceleration",
        letter="g",
    ),
    "plane": Key("choice", "`horizontal`: a table seen from above", choices=("vertical", "horizontal")),
    "up": Key("choice", "`z`: a scene in space", choices=("y", "z")),
    "surfaces": Key("map", "what bodies lie on: floors, slopes, walls"),
    "bodies": Key("map", "the rigid bodies; none where units are converted"),
    "connections": Key("map", "what touches what"),
    "actions": Key("map", "forces, couples and motors from outside"),
    "states": Key("map", "named instants, in the order of time"),
    "phases": Key("map", "what differs between two states"),
    "events": Key("map", "what happens in no time between two states"),
    "assume": Key(
        "texts",
        "approximations: `fast spin` (in space): the spin of a top is much faster than its precession; in the plane `m << M`: "
        "the leading term is told beside each answer",
        example="[fast spin]",
    ),
    "find": Key("map", "what is asked", required=True),
    "ask": Key(
        "map", "how a sheet asks for the answers, by the names of `find`: a wording each, in the order of the sheet"
    ),
    "answers": Key("map", "published answers, by the names of `find`"),
    "marking": Key("map", "how answers are marked, by the names of `find`, or `all`: points alone, or a map"),
    "vary": Key(
        "vary", "givens that vary: `m: 1 kg to 3 kg by 0.5 kg`, `theta: [30 deg, 45 deg]`; `where: M > m`, or a list"
    ),
}

BODY: dict[str, Key] = {
    "shape": Key(
        "shape", "one of the shapes; without it a particle, or a rotor where `inertia`, `radius` or `radii` is given"
    ),
    "mass": Key("quantity", "mass; 0 for a light body", dimension="mass", letter="m", limits="nonnegative"),
    "density": Key(
        "density",
        "mass per length, area or volume: a value, or a formula of the shape's coordinates "
        "(x of a rod from its start, r of a disc, those of a lamina)",
        letter="rho",
        example="2 kg/m",
    ),
    "inertia": Key(
        "inertia",
        "moment of inertia about `cm`, or `{value: I, about: POINT}`; in space `{principal: [I1, I2, I3], about: POINT}` "
        "or `{tensor: [[…], […], […]], about: POINT}`",
        dimension="moment of inertia",
        letter="I",
        limits="nonnegative",
    ),
    "gyration": Key("quantity", "radius of gyration about `cm`", dimension="length", letter="k", limits="positive"),
    "radius": Key("quantity", "radius", dimension="length", letter="R", limits="positive"),
    "radii": Key("radii", "named rims of a stepped drum", example="{big: 30 cm, small: 10 cm}"),
    "parts": Key("parts", "bodies that make up this one", example="{tip: {mass: 1 kg, at: [50 cm, 0]}}"),
    "holes": Key("parts", "what is cut out", example="{hole: {shape: disc, radius: 2 cm}}"),
    "points": Key(
        "points map", "named points `P: [x, y]` (or `[x, y, z]`) from the body's centre", example="{P: [10 cm, 0]}"
    ),
    "count": Key("count", "how many identical bodies stand for this one", example="2"),
    "moves": Key("choice", "positive direction of its motion (default right; up on a slope)", choices=SENSES),
    "turns": Key("choice", "positive sense of its rotation (default counterclockwise)", choices=TURNS),
    "axis": Key("axis", "symmetry axis: one of the body's own axes, `x`, `y` or `z`", space=True),
    "turned": Key(
        "turns",
        "how it is turned from how it is drawn: one rotation, or a list of such",
        space=True,
        example="{about: x, by: 30 deg}",
    ),
    "position": Key(
        "motion",
        "prescribed place of its centre of mass",
        dimension="length",
        letter="r",
        varies=True,
        example="[0, 2 m]",
    ),
    "velocity": Key(
        "motion", "prescribed velocity `[vx, vy]`", dimension="velocity", letter="v", varies=True, example="[2 m/s, 0]"
    ),
    "acceleration": Key(
        "motion",
        "prescribed acceleration `[ax, ay]`",
        dimension="acceleration",
        letter="a",
        varies=True,
        example="[2 m/s^2, 0]",
    ),
    "momentum": Key(
        "motion", "given momentum `[px, py]`", dimension="momentum", letter="p", varies=True, example="[3 kg m/s, 0]"
    ),
    "angle": Key("motion", "prescribed angle", dimension="angle", letter="theta", varies=True),
    "angular_velocity": Key(
        "motion", "prescribed angular velocity", dimension="angular velocity", letter="omega", varies=True
    ),
    "angular_acceleration": Key(
        "motion", "prescribed angular acceleration", dimension="angular acceleration", letter="alpha", varies=True
    ),
}

PART: dict[str, Key] = {
    "at": Key(
        "spot",
        "where its centre is, from the body's centre: `[x, y]`, or `[x, y, z]` with its height",
        example="[10 cm, 0]",
    ),
    "start": Key("place", "where a rod begins", example="[0, 0]"),
    "end": Key("place", "where a rod ends", example="[30 cm, 0]"),
    "angle": Key("quantity", "how far it is turned, counterclockwise", dimension="angle", letter="theta"),
    "turned": Key("turns", "how it is turned in the body's axes: `{about: x, by: 30 deg}`", space=True),
}

STATE: dict[str, Key] = {  # beside paths with their values, and connections with their words
    "at rest": Key("names", "`all`, or the bodies that do not move", refers=("body",), example="all"),
    "balance": Key("true", "statics: nothing accelerates, and all that is held or pushed is at rest"),
    "steady": Key("true", "the motion goes on as it is: on a turning shaft, or of a body in space"),
}

PHASE: dict[str, Key] = {
    "from": Key("name", "the state before", refers=("state",), required=True, example="start"),
    "to": Key("name", "the state after", refers=("state",), required=True, example="end"),
    "without": Key("names", "connections that do not act in it", refers=("connection", "action"), example="[cord]"),
}

MARKING: dict[str, Key] = {
    "points": Key("marks", "marks for the answer (default 1)", example="2"),
    "tolerance": Key(
        "tolerance",
        "how far a number may be off: a share `2 %`, an amount `0.05 m/s^2`, or half a unit of the last of `3 figures` "
        "(default 1 %)",
        example="2 %",
    ),
    "form": Key("choice", "whether a formula or a number is wanted (default any)", choices=("any", "exact", "number")),
    "unit": Key("choice", "whether a number needs its unit (default wanted)", choices=("wanted", "optional")),
    "sign": Key(
        "choice",
        "of an answer that is right up to the declared positive direction (default strict: it is wrong)",
        choices=("strict", "lenient"),
    ),
    "deduct": Key(
        "deductions",
        "what flaws cost: one value for all, or a map; a share of the points, or marks",
        example="{unit: 25 %, rounding: 0.5}",
    ),
}

DEDUCT: dict[str, Key] = {
    "unit": Key("deduction", "the unit is missing (default 25 %)"),
    "rounding": Key("deduction", "rounded too early, or to too few figures (default 25 %)"),
    "form": Key("deduction", "a number where a formula is wanted, or the other way round (default 25 %)"),
    "followed": Key("deduction", "right by the student's own earlier answers alone (default 25 %)"),
    "case": Key(
        "deduction", "in letters right in some of the cases alone, not in the first or but for the sign (default 50 %)"
    ),
}

CLAUSES = ("about", "along", "by", "relative", "at", "during", "from", "to", "where", "in")
SPREAD = ("inertia", "gyration", "inertia_tensor", "principal_moments", "principal_axis")
SAID_OF = {  # the quantities of which a clause says something
    "about": (*SPREAD, "cm", "angular_momentum", "torque"),
    "along": ("inertia", "gyration"),
    "by": (*SPREAD, "cm", "mass"),
}
NAMED_AXES = ("space", "body", "node")  # in which components may be asked, beside those of a body that is named
APPROXIMATIONS = ("fast spin",)
RESERVED_WORDS = (*CLAUSES, "on", "across", "is", "of", "unknown", "number")
SWINGS = {"period of": "swing_period", "frequency of": "frequency", "angular_frequency of": "angular_frequency"}
DAMPED = {
    "damping_ratio of": "damping_ratio",
    "time_constant of": "time_constant",
    "logarithmic_decrement of": "logarithmic_decrement",
}
SWINGS |= DAMPED
RATIO_OF = "ratio of"  # of two amplitudes in a mode
WHICH, IS = "which of", "is"  # of several options: `{which of: {a: PHRASE, b: PHRASE}, is: largest}`
ALONE = ("lost", "total", "mean", "largest", "smallest")  # modifiers without `of`
ANGLE_OF = "angle of"  # of two vectors in space: `angle of A from B`
MODIFIERS = ("size of", "change of", *ALONE, *SWINGS, ANGLE_OF, WHICH)
