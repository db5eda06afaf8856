"""Space: a body in space of any kind, held, acted on, told of and asked at random; a scene for each choice of one entry of six tables.

What a state tells is drawn from what the joint leaves free, so that most scenes can be; what can not be is to be refused by name.
"""

from __future__ import annotations

import random

from compositions.body import Entry
from compositions.body_in_space import KINDS, ROUND
from compositions.compose import Choice, Unfit
from compositions.parts import Composition
from compositions.told_in_space import (
    BALL,
    CARRIED,
    DRIVEN,
    FREE,
    HINGE,
    NEXT,
    ROLLING,
    TOLD,
    direction,
    vector,
)
from trials.scene import Scene


def free(composition: Composition) -> str:
    return FREE


def ball(composition: Composition) -> str:
    composition.put("connections", "joint", {"ball": composition.place("one")})
    return BALL


def hinge(composition: Composition) -> str:
    entry = {"hinge": composition.place("one"), "along": direction(composition)}
    if composition.often(0.4):
        width = composition.letters.new("d", "m")
        entry["bearings"] = [f"-{width}", width]
    composition.put("connections", "joint", entry)
    return HINGE


def driven(composition: Composition) -> str:
    hinge(composition)
    drive(composition, composition.sections["connections"]["joint"])
    return DRIVEN


def drive(composition: Composition, joint: Entry) -> None:
    joint["angular_velocity"] = composition.letters.new("n", "rad/s")
    if composition.often(0.3):
        joint["angular_acceleration"] = composition.letters.new("e", "rad/s^2")


def carried(composition: Composition) -> str:
    """An axle or a hinge on a frame that turns as it is told, or is led round a hinge of its own."""
    turn = composition.letters.new("W", "rad/s")
    frame: Entry = {"mass": "0", "inertia": {"principal": ["0", "0", "0"]}}
    if composition.often(0.5):
        frame = {"mass": "0", "angular_velocity": ["0", "0", turn]}
    else:
        composition.put("connections", "post", {"hinge": "frame", "along": "z", "angular_velocity": turn})
    composition.bodies = {"frame": frame, **composition.bodies}
    word = "axle" if composition.kinds["one"].word in ROUND and composition.often(0.6) else "hinge"
    held = "one" if word == "axle" else composition.place("one")
    joint: Entry = {word: ["frame", held], "along": direction(composition)}
    drive(composition, joint)
    composition.put("connections", "joint", joint)
    return CARRIED


def rolling(composition: Composition) -> str | None:
    if composition.kinds["one"].word not in ("disc", "ring", "sphere"):
        return None
    composition.put("surfaces", "floor", "level")
    composition.put("connections", "joint", {"rolls": ["one", "floor"]})
    return ROLLING


def nothing(composition: Composition) -> None:
    return None


def force(composition: Composition) -> None:
    push = {"force": composition.letters.new("F", "N"), "on": composition.place("one")}
    composition.put("actions", "push", {**push, "direction": direction(composition)})


def couple(composition: Composition) -> None:
    composition.put("actions", "twist", {"couple": vector(composition, "tau", "N m"), "on": "one"})


def both(composition: Composition) -> None:
    force(composition)
    couple(composition)


def whatever(composition: Composition) -> None:
    """What keeps the motion as it is told."""
    composition.put("actions", "hands", {"couple": "any", "on": "one"})


HOLDS = {entry.__name__: entry for entry in (free, ball, hinge, driven, carried, rolling)}
ACTS = {entry.__name__: entry for entry in (nothing, force, couple, both, whatever)}
MOVES = (
    "angular_momentum", "torque.net", "kinetic_energy", "angular_velocity", "angular_acceleration", "velocity", "acceleration",
    "momentum", "z_axis", "energy",
)  # fmt: skip
EULER = ("precession", "nutation", "spin", "axial_rate", "tilt")
TENSORS = ("inertia_tensor", "principal_moments", "inertia along")
SCALARS = ("kinetic_energy", "energy", *EULER)
ASKED = (*MOVES, *EULER, "point", "joint", *TENSORS)
TABLES: dict[str, tuple[str, ...]] = {
    "body": tuple(kind.word for kind in KINDS),
    "held": tuple(HOLDS),
    "acted": tuple(ACTS),
    "told": tuple(TOLD),
    "next": tuple(NEXT),
    "asked": ASKED,
}


def has_meaning(composition: Composition, way: str, word: str) -> bool:
    """Whether a question can be asked: of a joint where there is one, of Euler angles where a state tells them."""
    told = "one.tilt" in composition.sections["states"]["start"]
    return way != FREE if word == "joint" else told or word not in EULER


def question(composition: Composition, word: str) -> str:
    """The text of a question, without its name; the first one is about the last state."""
    states = list(composition.sections["states"])
    state = composition.chance.choice(states) if "find" in composition.sections else states[-1]
    if word in TENSORS:
        point = composition.place("one")
        along = "inertia along [1, 2, 1]" if word == "inertia along" else word
        return f"one.{along} about {point}"
    if word in SCALARS:
        return f"one.{word} at {state}"
    path = f"one.{word}"
    if word == "point":
        path = f"{composition.place('one')}.{composition.pick('velocity', 'acceleration')}"
    if word == "joint":
        held = "joint" in composition.sections.get("connections", {})
        bearings = held and "bearings" in composition.sections["connections"]["joint"]
        path = f"joint.{composition.pick('bearing1.force', 'bearing2.force') if bearings else composition.pick('force', 'torque')}"
    size, axes = composition.pick("", "", "", "size of "), composition.pick("", "", " in body axes")
    axes = axes.replace("body", "one") if word == "joint" else axes
    return f"{size}{path} at {state}{'' if size else axes}"


def composed(choice: Choice, chance: random.Random) -> Scene:
    """The scene of one entry of each table; raises Unfit where they make none."""
    body, held, acted, told, after, asked = choice
    composition = Composition(chance)
    composition.add(next(kind for kind in KINDS if kind.word == body), "one")
    way = HOLDS[held](composition)
    if way is None:
        raise Unfit(choice)
    ACTS[acted](composition)
    lines = TOLD[told](composition, way)
    if lines is None:
        raise Unfit(choice)
    composition.put("states", "start", lines)
    if asked in TENSORS and (after != "only" or acted != "nothing"):  # of which nothing hangs on what is told
        raise Unfit(choice)
    if not NEXT[after](composition, way) or not has_meaning(composition, way, asked):
        raise Unfit(choice)
    more = [word for word in chance.sample(ASKED, 2) if has_meaning(composition, way, word)]
    for number, word in enumerate((asked, *more)):
        composition.put("find", f"x{number + 1}", question(composition, word))
    weightless = {"gravity": "none"} if composition.often(0.4) else {}
    return {**{"title": ", ".join(choice), "up": "z"}, **weightless, **composition.scene(", ".join(choice))}


def drawn(seed: int, number: int) -> tuple[Choice, Scene]:
    """The scene of a number: entries at random until they make one."""
    chance = random.Random(f"space-{seed}-{number}")
    while True:
        choice = tuple(chance.choice(table) for table in TABLES.values())
        try:
            return choice, composed(choice, chance)
        except Unfit:
            continue
