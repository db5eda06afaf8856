"""Relations: the same scene said in another way, and what its answers must be then.

Each takes a scene and gives others with the same answers under the same names; nothing where it does not apply.
"""

from __future__ import annotations

import copy
import random
import re
from collections.abc import Callable, Iterator

from trials.alike import mirrored, renamed, reordered
from trials.scene import Scene, changed

Relation = Callable[[Scene, random.Random], Iterator[Scene]]
IN_OTHERS = {
    "kg": ("g", 3),
    "m": ("cm", 2),
    "m/s": ("cm/s", 2),
    "N": ("mN", 3),
    "s": ("ms", 3),
    "N/m": ("N/cm", -2),
    "kg m^2": ("g m^2", 3),
    "N m": ("N cm", 2),
}
WRITTEN = re.compile(r"(?P<number>\d+(?:\.\d+)?) (?P<unit>[a-zA-Z/^2 ]+)")


def other_units(scene: Scene, chance: random.Random) -> Iterator[Scene]:
    """Every given in a smaller or larger unit."""

    def other(text: str) -> str:
        found = WRITTEN.fullmatch(text)
        if not found or found["unit"] not in IN_OTHERS:
            return text
        unit, power = IN_OTHERS[found["unit"]]
        return f"{found['number']}e{power} {unit}"

    yield {**scene, "given": changed(scene.get("given", {}), other)}


def alone(scene: Scene, chance: random.Random) -> Iterator[Scene]:
    """Each question by itself."""
    if len(scene["find"]) > 1:
        for name, question in scene["find"].items():
            yield {**scene, "find": {name: question}}


def in_another_order(scene: Scene, chance: random.Random) -> Iterator[Scene]:
    found = reordered(scene, chance)
    questions = list(found["find"].items())
    yield {**found, "find": dict(questions[::-1])}


def by_other_names(scene: Scene, chance: random.Random) -> Iterator[Scene]:
    yield renamed(scene, chance)


def in_a_mirror(scene: Scene, chance: random.Random) -> Iterator[Scene]:
    found = mirrored(scene)
    if found is not None:
        yield found


def with_nothing_welded_on(scene: Scene, chance: random.Random) -> Iterator[Scene]:
    """A particle of mass 0 somewhere on a body with an extent."""
    names = [name for name, body in scene["bodies"].items() if "shape" in body or "parts" in body]
    if not names or any("inertia" in str(question) for question in scene["find"].values()):
        return
    result = copy.deepcopy(scene)
    name = chance.choice(names)
    point = {"rod": "end", "rectangle": "corner3"}.get(scene["bodies"][name].get("shape", ""), "center")
    if "points" in scene["bodies"][name] and "parts" in scene["bodies"][name]:
        point = next(iter(scene["bodies"][name]["points"]))
    result["bodies"]["speck"] = {"mass": "0"}
    result.setdefault("connections", {})["glue"] = {"weld": [f"{name}.{point}", "speck"]}
    yield result


def with_forces_halved(scene: Scene, chance: random.Random) -> Iterator[Scene]:
    """Each given force as two of half its size; nothing where its own work is asked."""
    result = copy.deepcopy(scene)
    asked = str(scene["find"])
    for name, action in list(scene.get("actions", {}).items()):
        word = next((word for word in ("force", "couple") if word in action), "")
        if word and action[word] not in ("unknown", "any") and name not in asked:
            half = {**action, word: changed(action[word], halved)}
            result["actions"][name] = half
            result["actions"][f"{name}_again"] = copy.deepcopy(half)
    if result != scene:
        yield result


def halved(text: str) -> str:
    return text if text == "0" else f"({text})/2"


RELATIONS: dict[str, Relation] = {
    "each question alone": alone,
    "in another order": in_another_order,
    "by other names": by_other_names,
    "in other units": other_units,
    "in a mirror": in_a_mirror,
    "with a speck of no mass": with_nothing_welded_on,
    "with forces as two halves": with_forces_halved,
}
LAWS = ("newton", "energy", "angular-momentum")
