"""Guided: bodies on round tracks and wires, in slots and tubes, on faces and bearings that rub, and rounds that are not uniform."""

from __future__ import annotations

from compositions.parts import ARC, ROLL, SWING, TURN, Composition


def on_a_round(composition: Composition, name: str) -> bool | None:
    """A bead or a round body on a dome, in a hollow or on a wire; smooth, or rolling."""
    kind = composition.kinds[name]
    word = composition.pick("dome", "hollow", "wire")
    if kind.word not in ("particle", "disc", "ring", "sphere") or (word == "wire" and kind.extended):
        return False
    radius = composition.letters.new("R", "m")
    if kind.extended:  # a small one, which fits into the hollow
        composition.bodies[name]["radius"] = f"{radius}/5"
    composition.put("surfaces", "track", {word: radius})
    composition.bodies[name]["moves"] = composition.pick("left", "right")
    composition.put("connections", "base", {"rolls" if kind.extended else "contact": [name, "track"]})
    composition.ways[name] = ARC
    return None


def in_two_slots(composition: Composition, name: str) -> bool | None:
    """A rod whose ends slide in a level slot and an upright one."""
    if composition.kinds[name].word not in ("rod", "light rod"):
        return False
    ends = ["start", "end"] if composition.often(0.5) else ["end", "start"]
    composition.put("connections", "lower", {"slot": f"{name}.{ends[0]}", "along": composition.pick("right", "left")})
    composition.put("connections", "upper", {"slot": f"{name}.{ends[1]}", "along": composition.pick("up", "down")})
    composition.ways[name] = SWING
    return None


def with_resistance(composition: Composition, name: str) -> bool | None:
    """Rolling with the ground pressing ahead of the middle."""
    if composition.kinds[name].word not in ("disc", "ring", "sphere", "annulus"):
        return False
    composition.put("surfaces", "floor", "level")
    composition.bodies[name]["moves"] = composition.pick("left", "right")
    lever = composition.letters.new("b", "mm")
    composition.put("connections", "base", {"rolls": [name, "floor"], "rolling_friction": lever})
    composition.ways[name] = ROLL
    composition.holds_fast(name)
    return None


def in_a_collar(composition: Composition, name: str) -> bool | None:
    """On a shaft with a collar or a foot that rubs on its bearing, seen from above."""
    if not composition.kinds[name].rims:
        return False
    composition.sections["plane"] = {"plane": "horizontal"}
    inner = composition.letters.new("a", "m")
    face = {"radius": inner} if composition.often(0.5) else {"radii": {"inner": inner, "outer": f"2*{inner}"}}
    rubs = {"press": composition.letters.new("F", "N"), "friction": composition.letters.new("mu", ""), **face}
    if composition.often(0.3):
        rubs["uniform"] = "wear"
    if composition.often(0.3):
        rubs["cone"] = composition.letters.new("beta", "deg")
    composition.put("connections", "axle", {"axle": name, **rubs})
    composition.bodies[name]["turns"] = composition.pick("clockwise", "counterclockwise")
    composition.ways[name] = TURN
    return None


def flat_on_a_table(composition: Composition, name: str) -> bool | None:
    """A disc, ring or rod that lies on a rough table, seen from above, alone or about a pin."""
    kind = composition.kinds[name]
    if kind.word not in ("disc", "ring", "rod", "annulus"):
        return False
    composition.sections["plane"] = {"plane": "horizontal"}
    composition.put("surfaces", "floor", "level")
    friction = composition.letters.new("mu", "")
    composition.put("connections", "face", {"contact": [name, "floor"], "friction": friction})
    if composition.often(0.5):
        pin = f"{name}.start" if kind.word == "rod" else f"{name}.center"
        composition.put("connections", "pin", {"hinge": pin})
    composition.ways[name] = TURN
    return None
