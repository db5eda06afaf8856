"""Joined: the ways in which a second body belongs to the first."""

from __future__ import annotations

from collections.abc import Callable

from compositions.body import KINDS
from compositions.coupled import (
    bounced,
    clutched,
    in_a_slot,
    in_a_tube,
    on_a_spring_between,
    on_an_arm,
    round_a_post,
)
from compositions.parts import LINE, ROLL, SWING, TURN, Composition

Join = Callable[[Composition], bool | None]


def alone(composition: Composition) -> bool | None:
    return None


def welded(composition: Composition) -> bool | None:
    composition.second("particle", "rod", "disc", "loaded wheel")
    ends = [composition.place("one"), composition.place("two")]
    composition.put("connections", "bolt", {"weld": ends if composition.often(0.7) else ends[::-1]})
    return None


def hinged(composition: Composition) -> bool | None:
    composition.second("rod", "hammer", "disc", "plate")
    composition.put("connections", "joint", {"hinge": [composition.place("one"), composition.place("two")]})
    composition.ways["two"] = SWING
    return None


def hung(composition: Composition) -> bool | None:
    """A weight on a string from a rim, or from a body over a pulley."""
    kind = composition.kinds["one"]
    way = composition.ways["one"]
    if "truck" in composition.bodies or (way == TURN and not kind.rims):
        return False
    composition.second("particle", "plate")
    composition.bodies["two"]["moves"] = composition.pick("up", "down")
    composition.ways["two"] = LINE
    composition.tied += ["two", "pulley"]
    if way == TURN:
        rim = composition.chance.choice(kind.rims)
        at = f"one.{rim}" if rim else "one"
        composition.put("connections", "rope", {"string": [at, "two"] if composition.often(0.5) else ["two", at]})
        return None
    if way not in (LINE, ROLL):
        return False
    word = composition.pick("disc", "ring")
    composition.add(next(kind for kind in KINDS if kind.word == word), "pulley")
    composition.bodies["pulley"]["turns"] = composition.pick("clockwise", "counterclockwise")
    composition.ways["pulley"] = TURN
    composition.put("connections", "stud", {"axle": "pulley"})
    composition.put("connections", "rope", {"string": ["one.center" if kind.rims else "one", "pulley", "two"]})
    return None


def geared(composition: Composition) -> bool | None:
    if composition.ways["one"] != TURN or "truck" in composition.bodies or not composition.kinds["one"].rims:
        return False
    composition.second("disc", "ring", "annulus")
    rim = composition.chance.choice(composition.kinds["one"].rims)
    ends = [f"one.{rim}" if rim else "one", "two"]
    word = composition.pick("gear", "belt")
    composition.put("connections", "stub", {"axle": "two"})
    composition.put("connections", "mesh", {word: ends if composition.often(0.5) else ends[::-1]})
    composition.ways["two"] = TURN
    composition.tied.append("two")
    return None


def sprung(composition: Composition) -> bool | None:
    if composition.ways["one"] not in (LINE, ROLL):
        return False
    stiffness = composition.letters.new("k", "N/m")
    composition.put("connections", "coil2", {"spring": ["ground", "one"], "stiffness": stiffness})
    return None


def wired(composition: Composition) -> bool | None:
    if composition.ways["one"] not in (TURN, SWING):
        return False
    composition.put("connections", "wire", {"torsion": "one", "stiffness": composition.letters.new("k", "N m/rad")})
    return None


def ridden(composition: Composition) -> bool | None:
    """A block or a roller on the back of the first body."""
    if composition.ways["one"] != LINE or composition.bodies["one"].get("moves") in ("up", "down"):
        return False
    composition.second("particle", "disc", "ring")
    composition.bodies["two"]["moves"] = composition.pick("left", "right")
    composition.ways["two"] = ROLL if composition.kinds["two"].rims else LINE
    composition.put("connections", "touch", {"contact": ["two", "one"], "friction": composition.friction()})
    return None


def mounted(composition: Composition) -> bool | None:
    """A wheel on an axle that the first body carries or shares, or on a pin of one that turns."""
    composition.second("disc", "ring", "loaded wheel")
    shared = composition.ways["one"] in (LINE, ROLL) or (composition.has("axle") and "truck" not in composition.bodies)
    carried = {"axle": ["one", "two"]} if shared else {"hinge": [composition.place("one"), "two.center"]}
    composition.put("connections", "spindle", carried)
    composition.ways["two"] = TURN
    return None


def struck(composition: Composition) -> bool | None:
    """A particle that flies at the first body, and sticks to it or bounces off."""
    composition.second("particle")
    upright = composition.bodies["one"].get("moves") in ("up", "down") and not composition.has("contact")
    ways = (
        ("up", "down") if upright else ("left", "right", "up", "down")
    )  # along a line to which only its word holds the first
    composition.bodies["two"]["moves"] = composition.pick(*ways)
    composition.ways["two"] = LINE
    composition.loose.append("two")
    at = composition.place("one")
    sticks = {"joins": ["two", at]}
    bounces = {"collides": ["two", at], "restitution": composition.letters.new("e", "")}
    composition.put("events", "hit", sticks if composition.often(0.5) else bounces)
    return None


JOINS: dict[str, Join] = {
    "alone": alone,
    "welded": welded,
    "hinged": hinged,
    "hung": hung,
    "geared": geared,
    "sprung": sprung,
    "wired": wired,
    "ridden": ridden,
    "mounted": mounted,
    "struck": struck,
    "clutched": clutched,
    "on an arm": on_an_arm,
    "round a post": round_a_post,
    "on a spring between": on_a_spring_between,
    "in a tube": in_a_tube,
    "in a slot": in_a_slot,
    "bounced": bounced,
}
