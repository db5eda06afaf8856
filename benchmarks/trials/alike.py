"""Alike: scenes that say the same in another way, and what their answers must be then.

- *scaled*: every mass 10^a, every length 10^b and every time 10^c times as large (gravity with them): each answer changes by the power of
  ten of its dimension, and not one of its figures;
- *reordered*: bodies, connections, givens and questions in another order;
- *renamed*: bodies, connections and states by other names;
- *mirrored*: left for right, clockwise for counterclockwise.
"""

from __future__ import annotations

import random
import re
from fractions import Fraction

from rotsolve.algebra.units.dimension import Dimension
from rotsolve.algebra.units.quantities import UnitError, parse_quantity
from rotsolve.core.quantity import QUANTITIES
from rotsolve.elements.tables import ACTIONS, CONNECTIONS, EVENTS, SHAPES, SURFACES
from rotsolve.language.keys import keys_of
from trials.scene import Scene, changed, named

Powers = tuple[int, int, int]  # of ten, for masses, lengths and times
UNIT = r"(?:kg|g|mg|t|km|cm|mm|dm|m|min|ms|s|h|day|d|kN|mN|N|kJ|MJ|J|kW|MW|W|Hz|Pa|rad|deg|rev|rpm|L)"
POWER = r"(?:\^(?:-?\d|\(\d/\d\))|[²³])?"
QUANTITY = re.compile(
    rf"(?<![\w.^])(?P<number>\d+(?:/\d+|\.\d+)?(?:e[-+]?\d+)?)(?P<pi>\s*\*?\s*pi)?\s*"
    rf"(?P<unit>(?:1?/)?\(?{UNIT}{POWER}(?:[ */·]+\(?{UNIT}{POWER}\)?)*)(?![\w.(])"
)
NAMED = ("bodies", "surfaces", "connections", "actions", "states", "events", "phases")
MIRRORED = {"axle", "string", "contact", "rolls", "friction", "hinge", "gear", "belt", "crossed", "inside"}
SAID = """
start end center rim top bottom cm level slope wall left right up down all any none at rest time turns moves
ground ceiling mean total size of about along by integration where which is in from to during on unknown
lost change largest smallest above below mass inertia gyration count parts points holes balance steady true false
clockwise counterclockwise tangential normal radial net gravity sticks slips slack taut leaves x y z r phi
"""
TABLES = (SHAPES, CONNECTIONS, ACTIONS, EVENTS, SURFACES)
WORDS = {
    *SAID.split(),
    *(word for table in TABLES for item in table for word in item.word.split()),
    *(word for table in TABLES for item in table for word, _ in keys_of(item)),
    *(kind.word for kind in QUANTITIES.values()),
}


class Unscalable(ValueError):
    """A scene in which numbers stand that can not be scaled."""


def exponent(dimension: Dimension, powers: Powers) -> Fraction:
    """The power of ten by which a quantity of this dimension changes."""
    sizes = Fraction(dimension.mass), Fraction(dimension.length), Fraction(dimension.time)
    return sum((size * power for size, power in zip(sizes, powers, strict=True)), Fraction(0))


def scaled(scene: Scene, powers: Powers) -> Scene:
    """The scene with its masses, lengths and times so many powers of ten larger."""

    def larger(match: re.Match[str]) -> str:
        try:
            power = exponent(parse_quantity(match[0]).dimension, powers)
        except UnitError:
            raise Unscalable(match[0]) from None
        if power.denominator != 1:
            raise Unscalable(match[0])
        number = times_ten(match["number"], int(power))
        return f"{number}{match['pi'] or ''} {match['unit']}"

    def change(text: str) -> str:
        return QUANTITY.sub(larger, text)

    if "given" in scene and "g" not in scene["given"] and "gravity" not in scene:
        scene = {**scene, "given": {**scene["given"], "g": "9.8 m/s^2"}}
    elif "given" not in scene and "gravity" not in scene:
        scene = {"title": scene.get("title", ""), "given": {"g": "9.8 m/s^2"}, **scene}
    return {key: value if key == "title" else changed(value, change) for key, value in scene.items()}


def times_ten(number: str, power: int) -> str:
    """A written number times a power of ten, exactly."""
    if "/" in number:
        top, bottom = number.split("/")
        return f"{top}{'0' * power}/{bottom}" if power >= 0 else f"{top}/{bottom}{'0' * -power}"
    mantissa, _, own = number.partition("e")
    return f"{mantissa}e{int(own or 0) + power}" if power else number


def reordered(scene: Scene, chance: random.Random) -> Scene:
    """The scene with its letters, bodies, surfaces, connections and actions in another order."""
    result: Scene = {}
    for key, part in scene.items():
        if key in ("given", "bodies", "surfaces", "connections", "actions"):
            names = list(part)
            chance.shuffle(names)
            part = {name: part[name] for name in names}
        result[key] = part
    return result


def renamed(scene: Scene, chance: random.Random) -> Scene:
    """The scene with other names for what it consists of, in another alphabetical order; words of the language stay."""
    names = [
        name for key in NAMED for name in scene.get(key, {}) if name not in WORDS and name not in scene.get("given", {})
    ]
    fresh = [
        f"{letter}{chance.choice('uvw')}thing{number}"
        for number, letter in enumerate(chance.sample("abcdefghijklmnopqrstuvwxyz", min(26, len(names))))
    ]
    table = dict(zip(names, fresh, strict=False))
    return {key: part if key in ("title", "given") else named(part, table) for key, part in scene.items()}


SIDES = {"left": "right", "right": "left", "clockwise": "counterclockwise", "counterclockwise": "clockwise"}


def mirrored(scene: Scene) -> Scene | None:
    """The scene in a mirror: left for right, and strings drawn the other way; None where angles or places stand in it."""
    connections = scene.get("connections", {})
    kinds = {word for item in connections.values() for word in item}
    text = str([part for key, part in scene.items() if key not in ("title", "given", "surfaces")])
    if not kinds <= MIRRORED or re.search(r"\.x\b|angle|deg|\[-|at\(|torque|couple", text) or not scene.get("bodies"):
        return None
    for body in scene["bodies"].values():
        if "parts" in body or "points" in body or str(body.get("shape", "")).startswith("hemispher"):
            return None  # drawn with a left and a right
        turns = "shape" in body or "inertia" in body
        if ("turns" if turns else "moves") not in body:
            return None  # which way is positive follows from the connections then
    for action in scene.get("actions", {}).values():
        if action.get("direction") not in SIDES:
            return None
    if any(name in SIDES for key in NAMED for name in scene.get(key, {})):
        return None
    wheels = {name for name, body in scene["bodies"].items() if "shape" in body or "inertia" in body}
    if any(word in wheels for word in re.findall(r"\.(\w+)\.tension", str(scene.get("find", {})))):
        return None  # the part that leaves a wheel is another one where the string is drawn the other way
    result = {key: part if key in ("title", "given", "find") else named(part, SIDES) for key, part in scene.items()}
    for item in result.get("connections", {}).values():
        if "string" in item:
            item["string"] = item["string"][::-1]
    return result
