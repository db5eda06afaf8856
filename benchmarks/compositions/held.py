"""Held: the ways in which a body can be held."""

from __future__ import annotations

from collections.abc import Callable

from compositions.guided import flat_on_a_table, in_a_collar, in_two_slots, on_a_round, with_resistance
from compositions.parts import LINE, PLANE, ROLL, SWING, TURN, Composition

Hold = Callable[[Composition, str], bool | None]


def surface(composition: Composition) -> tuple[str, bool]:
    """A surface to lie on, and whether it is a slope."""
    if composition.often(0.5):
        composition.put("surfaces", "floor", "level")
        return "floor", False
    angle = composition.letters.new("beta", "deg")
    composition.put("surfaces", "ramp", {"slope": angle, "down": composition.pick("left", "right")})
    return "ramp", True


def free(composition: Composition, name: str) -> bool | None:
    composition.ways[name] = PLANE
    if composition.kinds[name].extended is False:
        composition.ways[name] = LINE
        composition.bodies[name]["moves"] = composition.pick("left", "right", "up", "down")
    return None


def table(composition: Composition, name: str) -> bool | None:
    composition.sections["plane"] = {"plane": "horizontal"}
    return free(composition, name)


def axle(composition: Composition, name: str) -> bool | None:
    kind = composition.kinds[name]
    if not kind.rims:
        return False
    rubs = {"friction_torque": composition.letters.new("tau", "N m")} if composition.often(0.25) else {}
    composition.put("connections", "axle", {"axle": name, **rubs})
    composition.bodies[name]["turns"] = composition.pick("clockwise", "counterclockwise")
    composition.ways[name] = TURN
    return None


def hinge(composition: Composition, name: str) -> bool | None:
    if not composition.kinds[name].extended:
        return False
    composition.put("connections", "pin", {"hinge": composition.place(name)})
    composition.ways[name] = SWING
    return None


def lies(composition: Composition, name: str) -> bool | None:
    on, slope = surface(composition)
    composition.bodies[name]["moves"] = composition.pick(*(("up", "down") if slope else ("left", "right")))
    friction = composition.friction()
    composition.put("connections", "base", {"contact": [name, on], "friction": friction})
    composition.ways[name] = ROLL if composition.kinds[name].rims else LINE
    if friction == "any":
        composition.holds_fast(name)
    return None


def rolls(composition: Composition, name: str) -> bool | None:
    kind = composition.kinds[name]
    if not kind.rims:
        return False
    on, slope = surface(composition)
    rim = composition.chance.choice(kind.rims)
    composition.bodies[name]["moves"] = composition.pick(*(("up", "down") if slope else ("left", "right")))
    composition.put("connections", "base", {"rolls": [f"{name}.{rim}" if rim else name, on]})
    composition.ways[name] = ROLL
    composition.holds_fast(name)
    return None


def hangs(composition: Composition, name: str) -> bool | None:
    """On a string that is wound on it, or tied to it."""
    kind = composition.kinds[name]
    rim = composition.chance.choice(kind.rims) if kind.rims else ""
    composition.bodies[name]["moves"] = composition.pick("up", "down")
    ends = ["ceiling", f"{name}.{rim}" if rim else name]
    composition.put("connections", "cord", {"string": ends if composition.often(0.5) else ends[::-1]})
    composition.ways[name] = ROLL if kind.rims else LINE
    composition.holds_fast(name)
    return None


def leans(composition: Composition, name: str) -> bool | None:
    if composition.kinds[name].word not in ("rod", "light rod"):
        return False
    composition.put("surfaces", "floor", "level")
    composition.put("surfaces", "side", {"wall": composition.pick("left", "right")})
    composition.put("connections", "foot", {"contact": [f"{name}.start", "floor"]})
    composition.put("connections", "head", {"contact": [f"{name}.end", "side"]})
    composition.ways[name] = SWING
    return None


def spring(composition: Composition, name: str) -> bool | None:
    composition.bodies[name]["moves"] = composition.pick("up", "down")
    stiffness = composition.letters.new("k", "N/m")
    composition.put("connections", "coil", {"spring": ["ceiling", name], "stiffness": stiffness})
    composition.ways[name] = ROLL if composition.kinds[name].rims else LINE  # what is round may turn on it
    return None


def on_truck(composition: Composition, name: str) -> bool | None:
    """On an axle or hinge of a truck that travels."""
    kind = composition.kinds[name]
    if not kind.extended:
        return False
    composition.bodies["truck"] = {
        "mass": composition.letters.new("m", "kg"),
        "moves": composition.pick("left", "right"),
    }
    composition.put("surfaces", "floor", "level")
    composition.put("connections", "under", {"contact": ["truck", "floor"]})
    held = {"axle": ["truck", name]} if kind.rims else {"hinge": ["truck", composition.place(name)]}
    composition.put("connections", "mount", held)
    composition.ways[name] = TURN if kind.rims else SWING
    composition.ways["truck"] = LINE
    return None


def shaft(composition: Composition, name: str) -> bool | None:
    if not composition.kinds[name].extended:
        return False
    turning = composition.letters.new("w", "rad/s")
    composition.put("connections", "mast", {"shaft": composition.place(name), "turning": turning})
    composition.ways[name] = SWING
    return None


HOLDS: dict[str, Hold] = {
    "free": free,
    "free on a table": table,
    "axle": axle,
    "hinge": hinge,
    "lies": lies,
    "rolls": rolls,
    "hangs": hangs,
    "leans": leans,
    "spring": spring,
    "on a truck": on_truck,
    "shaft": shaft,
    "on a round": on_a_round,
    "in two slots": in_two_slots,
    "rolls with resistance": with_resistance,
    "in a collar": in_a_collar,
    "flat on a table": flat_on_a_table,
}
