"""Reflect: a scene as a mirror shows it, with its angles and places too, and what its answers must be then: as large, the other way round.

Left and right, clockwise and counterclockwise change places, x becomes −x, an angle of a rod 180° less itself; strings and springs are
drawn the other way. Which way is positive changes with it: answers are compared by their sizes and by the words for their directions.
"""

from __future__ import annotations

import copy
import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from trials.outcome import OBJECTED, SOLVED, Outcome, Printed
from trials.scene import Scene

SIDES = {"left": "right", "right": "left", "clockwise": "counterclockwise", "counterclockwise": "clockwise"}
CORNERS = {"corner1": "corner2", "corner2": "corner1", "corner3": "corner4", "corner4": "corner3"}
WAYS = ("right", "left", "up", "down", "tangential", "clockwise", "counterclockwise")
DRAWN = ("triangle", "polygon", "lamina", "arc", "hemisphere", "rope")  # shapes that are no mirror images of themselves
SIDED = ("corners", "holes", "parts", "region", "velocity", "angle", "angular_velocity", "position", "acceleration")
ASYMMETRIC = ("shaft", "drapes", "press", "weld", "angle", "rides")  # connections that know left from right
AT_A_POINT = ("hinge", "spring")  # connections for which a rim is the place on its right
ASKED_OF_A_SIDE = re.compile(r"\.\w+\.tension|\.(shear|bending_moment)")
RELATIVE = Fraction(1, 10**5)


class Asymmetric(ValueError):
    """A scene in which something stands that has no mirror image in the language."""


def reflected(scene: Scene) -> Scene | None:
    """The scene in a mirror; None where it has no mirror image in the language."""
    result = copy.deepcopy(scene)
    names = [name for key in ("bodies", "connections", "states", "actions") for name in scene.get(key, {})]
    asked = str(scene.get("find", {}))
    if (
        not scene.get("bodies")
        or any(name in SIDES for name in names)
        or ASKED_OF_A_SIDE.search(asked)
        or on_a_rim(asked, scene)
    ):
        return None
    try:
        for name, body in result.get("bodies", {}).items():
            result["bodies"][name] = body_reflected(name, body, scene)
        for surface in result.get("surfaces", {}).values():
            surface_reflected(surface)
        for item in result.get("connections", {}).values():
            connection_reflected(item, scene)
            if on_a_rim(str(item), scene) and any(word in item for word in AT_A_POINT):
                raise Asymmetric(str(item))
        for item in (*result.get("actions", {}).values(), *result.get("events", {}).values()):
            push_reflected(item, scene)
        for state in result.get("states", {}).values():
            if isinstance(state, dict):
                state.update({line: line_reflected(line, value, scene) for line, value in state.items()})
    except Asymmetric:
        return None
    flat = {name for name, body in result["bodies"].items() if body.get("shape") in ("rectangle", "cuboid")}
    return {key: part if key in ("title", "given") else with_corners(part, flat) for key, part in result.items()}


def on_a_rim(text: str, scene: Scene) -> bool:
    """Whether a text speaks of a place on a rim, which is the one on the right, in a mirror too."""
    bodies = [body for body in scene["bodies"].values() if isinstance(body, dict)]
    rims = {"rim", "inner", "outer", *(rim for body in bodies for rim in body.get("radii", ()))}
    return re.search(rf"\.({'|'.join(rims)})\b", text) is not None


def lying(scene: Scene) -> set[str]:
    """The bodies that lie or roll on something."""
    if scene.get("plane") == "horizontal":  # on a table, on which it may turn
        return set()
    pairs = [item.get("rolls") or item.get("contact") for item in scene.get("connections", {}).values()]
    return {pair[0] for pair in pairs if pair}


def body_reflected(name: str, body: Any, scene: Scene) -> Scene:
    """A body with the opposite positive ways, and its points on the other side."""
    body = body if isinstance(body, dict) else {"shape": body}
    shape, lies = body.get("shape"), name in lying(scene)
    if shape in DRAWN or any(word in body for word in SIDED) or (shape == "rod" and "points" in body):
        raise Asymmetric(name)
    points = {point: [minus(place[0]), *place[1:]] for point, place in body.get("points", {}).items()}
    moves = SIDES.get(body["moves"], body["moves"]) if "moves" in body else "left" if lies else None
    turning = not lies and "moves" not in body and (shape != "particle" or "radius" in body)
    turns = SIDES[body["turns"]] if "turns" in body else "clockwise" if turning else None
    changes = {"points": points or None, "moves": moves, "turns": turns}
    return {**body, **{word: value for word, value in changes.items() if value is not None}}


def surface_reflected(surface: Any) -> None:
    """A slope that falls the other way, a wall or an edge on the other side."""
    if isinstance(surface, dict):
        if "slope" in surface:
            surface["down"] = SIDES[surface.get("down", "left")]
        surface.update({word: SIDES.get(surface[word], surface[word]) for word in ("wall", "side") if word in surface})


def connection_reflected(item: Scene, scene: Scene) -> None:
    """Strings and springs drawn the other way, wires wound the other way."""
    if any(word in item for word in ASYMMETRIC):
        raise Asymmetric(str(item))
    if "string" in item:
        item["string"] = item["string"][::-1]
    if "spring" in item:
        places = [[minus(end[0]), end[1]] if isinstance(end, list) else end for end in item["spring"]]
        item["spring"] = places if any(isinstance(end, list) for end in places) else places[::-1]
    if "torsion" in item:
        wire_reflected(item, scene)
    if "pulls" in item:
        item["pulls"] = {name: SIDES.get(way, way) for name, way in item["pulls"].items()}


def wire_reflected(item: Scene, scene: Scene) -> None:
    """A wire without torque where it has none in the scene: the angles of rods, where they are told, are counted from the other side."""
    refs = item["torsion"] if isinstance(item["torsion"], list) else [item["torsion"]]
    owners = [ref.partition(".")[0] for ref in refs]
    shapes = [body.get("shape") if isinstance(body := scene["bodies"].get(name), dict) else body for name in owners]
    told = [f"{name}.angle" in str(scene.get("states")) for name in owners]
    turned = [shape == "rod" and known for shape, known in zip(shapes, told, strict=True)]
    half_turns = turned[-1] - (turned[0] if len(turned) > 1 else 0)
    if half_turns or "rest_angle" in item:
        item["rest_angle"] = f"{180 * half_turns} deg - ({item.get('rest_angle', '0')})"


def push_reflected(item: Scene, scene: Scene) -> None:
    """A force, couple or blow in the mirrored direction; a rod on which it acts has to be told how it stands."""
    way, owner = item.get("direction"), str(item.get("on")).partition(".")[0]
    body = scene["bodies"].get(owner)
    if isinstance(body, dict) and body.get("shape") == "rod" and f"{owner}.angle" not in str(scene.get("states")):
        raise Asymmetric(owner)
    spins = isinstance(body, dict) and "moves" in body and owner not in lying(scene)
    if "couple" in item and spins and "turns" not in body:
        raise Asymmetric(owner)  # what its positive turn is, `moves` does not say
    sided = way not in (None, "tangential") or "joins" in item or "collides" in item
    pressed = "press" in item and ".force" in str(scene.get("find", {}))  # what holds a wheel against a brake block
    if ".angle" in str(item) or ((sided or pressed) and on_a_rim(str(item), scene)):
        raise Asymmetric(str(item))
    if isinstance(way, list):
        item["direction"] = [minus(way[0]), way[1]]
    elif way is not None:
        item["direction"] = SIDES.get(way, way) if way in WAYS else f"180 deg - ({way})"


def line_reflected(line: str, value: Any, scene: Scene) -> Any:
    """A line of a state: angles of rods from the other side, parts along x the other way."""
    if isinstance(value, list) and line.endswith((".velocity", ".acceleration", ".position")):
        return [minus(value[0]), *value[1:]]
    if not isinstance(value, str):
        return value
    owner, _, word = line.rpartition(".")
    if word == "angle":
        body = scene["bodies"].get(owner)
        if not isinstance(body, dict) or body.get("shape") != "rod" or value in ("largest", "smallest"):
            raise Asymmetric(line)
        return f"180 deg - ({value})"
    if ".angle" in value:
        raise Asymmetric(line)
    return minus(value) if word == "x" else value


def minus(value: str) -> str:
    return value if value == "0" else f"-({value})"


def with_corners(node: Any, flat: set[str]) -> Any:
    """The same with the corners of rectangles named from the other side."""
    if isinstance(node, dict):
        return {with_corners(key, flat): with_corners(value, flat) for key, value in node.items()}
    if isinstance(node, list):
        return [with_corners(value, flat) for value in node]
    names = re.compile(r"\b(\w+)\.(corner[1-4])\b")
    return names.sub(lambda found: f"{found[1]}.{CORNERS[found[2]]}" if found[1] in flat else found[0], node)


def not_mirrored(one: Outcome, other: Outcome, scene: Scene) -> Iterator[str]:
    """Answers of a scene that are not the mirror images of those of the reflected one; angles are left out."""
    if one.kind not in (SOLVED, OBJECTED):
        return
    if other.kind not in (SOLVED, OBJECTED):
        yield f"in the mirror: {other.message}"
        return
    for name in sorted(one.answers.keys() & other.answers.keys()):
        question = str(scene["find"].get(name.partition(".")[0], "angle"))
        if "angle" not in question and unlike(one.answers[name], other.answers[name]):
            yield f"{name} = {other.answers[name]} in the mirror of {one.answers[name]}"


def unlike(one: Printed, other: Printed) -> bool:
    """Whether two answers differ in size, or say that they point the same way where they should point the other."""
    if one.number is None or other.number is None:
        return False
    largest = max(abs(one.number), abs(other.number), Fraction(1, 10**9))
    if abs(abs(one.number) - abs(other.number)) > RELATIVE * largest:
        return True
    said = [re.sub(r"[^a-z ]", "", words.said) for words in (one, other)]
    return all(said) and " ".join(SIDES.get(word, word) for word in said[0].split()) != " ".join(said[1].split())
