"""Asked: the questions about a composition."""

from __future__ import annotations

from compositions.parts import ARC, LINE, PLANE, ROLL, SWING, TURN, Composition

SPINS = (TURN, SWING, ROLL, PLANE)
OF_CONNECTIONS = {
    "string": ("tension",),
    "contact": ("normal_force", "friction_force"),
    "rolls": ("normal_force", "friction_force"),
    "hinge": ("force.x", "force.y"),
    "axle": ("force.x", "force.y"),
    "spring": ("force", "elongation"),
    "torsion": ("torque",),
    "shaft": ("force.x", "force.y"),
    "gear": ("force",),
    "clutch": ("torque",),
    "slot": ("force.x", "force.y"),
    "rides": ("normal_force",),
    "weld": ("force.x", "torque"),
}
ASKED: dict[
    str, tuple[str, ...]
] = {  # a quantity with where it is asked: of a moving body, a point, a connection, the scene, a span
    "acceleration": ("acceleration",),
    "velocity": ("velocity",),
    "point acceleration": ("acceleration.x", "acceleration.y"),
    "point velocity": ("velocity.x", "velocity.y", "speed"),
    "kinetic energy": ("kinetic_energy",),
    "momentum": ("momentum.x", "momentum.y"),
    "angular momentum": ("angular_momentum",),
    "force": ("force",),
    "work": ("work",),
    "time": ("time",),
    "lost energy": ("lost kinetic_energy", "change of potential_energy"),
    "period": ("period",),
    "modes": (
        "angular_frequency of mode 1",
        "angular_frequency of mode 2",
        "ratio of two.rotation to one.rotation in mode 2",
    ),
    "damping": ("damping_ratio", "time_constant", "logarithmic_decrement"),
    "mean": ("kinetic_energy", "angular_velocity", "velocity"),
    "inertia": ("inertia",),
}

SWINGS, SPANS = ("period", "modes", "damping"), ("time", "work", "lost energy", "mean")


def rates(composition: Composition, name: str, word: str) -> list[str]:
    """Velocity or acceleration of a body, as fits its way of moving."""
    way = composition.ways.get(name, "")
    found = []
    if way in (LINE, ROLL, ARC):
        found.append(f"{name}.{word}")
    if way in SPINS:
        found.append(f"{name}.angular_{word}")
    if way == PLANE:
        found += [f"{name}.{word}.x", f"{name}.{word}.y"]
    return found


def options(composition: Composition, question: str) -> list[str]:
    """All that the question can mean here, without its clause."""
    names, words = list(composition.bodies), ASKED[question]
    points = [place for name in composition.kinds for place in composition.places(name)]
    match question:
        case "acceleration" | "velocity":
            return [path for name in names for path in rates(composition, name, question)]
        case "point acceleration" | "point velocity":
            return [f"{point}.{word}" for point in points for word in words]
        case "kinetic energy":
            return ["kinetic_energy", *(f"{name}.kinetic_energy" for name in names)]
        case "momentum":
            return [f"{name}.{word}" for name in names for word in words]
        case "angular momentum":
            return [
                f"{name}.angular_momentum about {point}" for name in names for point in points if point.startswith(name)
            ]
        case "force":
            links = composition.sections.get("connections", {}).items()
            return [f"{name}.{word}" for name, link in links for key in link for word in OF_CONNECTIONS.get(key, ())]
        case "inertia":
            return [
                f"{name}.inertia about {point}"
                for name in composition.kinds
                for point in points
                if point.startswith(name)
            ]
    return []


def over(composition: Composition, question: str) -> list[str]:
    """What the question can mean between two states."""
    states = list(composition.sections.get("states", {}))
    if len(states) < 2:
        return []
    span = f" from {states[0]} to {states[-1]}"
    if question == "time":
        return [f"time{span}"] if states[-1] != "after" else []
    if question == "lost energy":
        return [f"{word}{span}" for word in ASKED[question]]
    if question == "mean":
        return [f"mean {name}.{word}{span}" for name in composition.kinds for word in ASKED[question]]
    acting = [*composition.sections.get("actions", {}), *composition.has("contact"), *composition.has("string")]
    return [f"{name}.work{span}" for name in acting]


def asked(composition: Composition, question: str) -> bool:
    """Put the question, and often a second one, into the scene; False where it can't be asked."""
    states = list(composition.sections.get("states", {}))
    if question in SWINGS:
        if states or (question == "modes" and len(composition.bodies) < 2):
            return False
        word = composition.chance.choice(ASKED[question])
        if "two." in word and "two" not in composition.bodies:
            return False
        composition.put("find", "x1", word if question == "modes" else f"{word} of small swings")
        return True
    if not states and question != "inertia":
        return False
    spans = over(composition, question) if question in SPANS else []
    at = f" at {composition.chance.choice(states)}" if states and question != "inertia" else ""
    found = spans or [f"{text}{at}" for text in options(composition, question)]
    if not found:
        return False
    composition.put("find", "x1", composition.chance.choice(found))
    if states and composition.often(0.5):
        more = [
            f"{text} at {states[-1]}"
            for kind in ("acceleration", "velocity", "force")
            for text in options(composition, kind)
        ]
        if more:
            composition.put("find", "x2", composition.chance.choice(more))
    return True
