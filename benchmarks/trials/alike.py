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

from rotsolve.algebra.units.quantities import UnitError, parse_quantity
from rotsolve.algebra.units.dimension import Dimension
from trials.scene import Scene, changed, named

Powers = tuple[int, int, int]  # of ten, for masses, lengths and times
UNIT = r"(?:kg|g|mg|t|km|cm|mm|dm|m|min|ms|s|h|day|d|kN|mN|N|kJ|MJ|J|kW|MW|W|Hz|Pa|rad|deg|rev|rpm|L)"
POWER = r"(?:\^(?:-?\d|\(\d/\d\))|[²³])?"
QUANTITY = re.compile(
    rf"(?<![\w.^])(?P<number>\d+(?:/\d+|\.\d+)?(?:e[-+]?\d+)?)(?P<pi>\s*\*?\s*pi)?\s*"
    rf"(?P<unit>(?:1?/)?\(?{UNIT}{POWER}(?:[ */·]+\(?{UNIT}{POWER}\)?)*)(?![\w.(])"
)


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
