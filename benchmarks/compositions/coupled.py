"""Coupled: second bodies on clutches, arms, posts, springs, tubes and slots, and bounces off what stands still."""

from __future__ import annotations

from compositions.parts import LINE, PLANE, ROLL, SWING, TURN, Composition


def clutched(composition: Composition) -> bool | None:
    """A second wheel on the same axle, pressed against the first."""
    if composition.ways["one"] != TURN or not composition.has("axle") or len(composition.bodies) > 1:
        return False
    composition.second("disc", "annulus")
    composition.sections["connections"]["axle"]["axle"] = ["one", "two"]
    composition.bodies["two"]["turns"] = composition.bodies["one"]["turns"]
    rubs = {"friction_torque": composition.letters.new("tau", "N m")}
    if composition.often(0.5):
        radius = composition.letters.new("a", "m")
        rubs = {
            "press": composition.letters.new("B", "N"),
            "friction": composition.letters.new("mu", ""),
            "radius": radius,
        }
    pair = ["one", "two"] if composition.often(0.5) else ["two", "one"]
    composition.put("connections", "clutch", {"clutch": pair, **rubs})
    composition.ways["two"] = TURN
    return None


def on_an_arm(composition: Composition) -> bool | None:
    """A planet wheel on the end of a rod, which meshes with a wheel that is held in the middle."""
    if composition.kinds["one"].word != "rod" or composition.ways["one"] != SWING or not composition.has("hinge"):
        return False
    composition.sections["connections"]["pin"] = {"hinge": "one.start"}
    length = composition.bodies["one"]["length"]
    composition.second("disc", "ring")
    composition.bodies["two"]["radius"] = f"{length}/4"
    mass = composition.letters.new("m", "kg")
    composition.bodies["sun"] = {"shape": "disc", "mass": mass, "radius": f"3*{length}/4"}
    held = {"axle": "sun", "angular_velocity": "0"} if composition.often(0.6) else {"axle": "sun"}
    composition.put("connections", "post", held)
    composition.put("connections", "spindle", {"hinge": ["one.end", "two.center"]})
    composition.put("connections", "teeth", {"gear": ["sun", "two"] if composition.often(0.5) else ["two", "sun"]})
    composition.ways["two"] = TURN
    composition.tied.append("two")
    return None


def round_a_post(composition: Composition) -> bool | None:
    """A load on a rope that runs round a rough post."""
    if composition.ways["one"] not in (LINE, ROLL) or "truck" in composition.bodies or composition.has("string"):
        return False
    composition.second("particle")
    composition.bodies["two"]["moves"] = composition.pick("up", "down")
    composition.ways["two"] = LINE
    composition.tied.append("two")
    composition.put("surfaces", "bollard", "post")
    end = "one.center" if composition.kinds["one"].rims else "one"
    friction, wrap = composition.letters.new("mu", ""), composition.pick("90 deg", "1/2 rev", "3/2 rev")
    composition.put("connections", "rope", {"string": [end, "bollard", "two"], "friction": friction, "wrap": wrap})
    return None


def on_a_spring_between(composition: Composition) -> bool | None:
    """A second body of the same way of moving, with a spring between the two."""
    way, kind = composition.ways["one"], composition.kinds["one"]
    if "truck" in composition.bodies or composition.has("shaft"):
        return False
    stiffness = composition.letters.new("k", "N/m")
    if way == LINE and composition.has("contact"):
        composition.second("particle")
        lies = composition.sections["connections"]["base"]["contact"]
        composition.bodies["two"]["moves"] = composition.bodies["one"]["moves"]
        composition.put("connections", "base2", {"contact": ["two", *lies[1:]], "friction": "none"})
        composition.put("connections", "coil3", {"spring": ["one", "two"], "stiffness": stiffness})
    elif way == SWING and kind.word == "rod" and composition.has("hinge"):
        composition.second("rod")
        composition.put("connections", "pin2", {"hinge": "two.start"})
        ends = ["one.end", "two.end"]
        composition.put("connections", "coil3", {"spring": ends, "stiffness": stiffness, "direction": "right"})
    else:
        return False
    composition.ways["two"] = way
    return None


def in_a_tube(composition: Composition) -> bool | None:
    """A bead that slides freely along the first body, a rod about its end, seen from above."""
    if composition.kinds["one"].word not in ("rod", "light rod") or not composition.has("hinge"):
        return False
    if len(composition.bodies) > 1 or composition.often(0.2):
        return False
    composition.sections["plane"] = {"plane": "horizontal"}
    composition.sections["connections"]["pin"] = {"hinge": "one.start"}
    if composition.often(0.5):
        composition.sections["connections"]["pin"]["angular_velocity"] = composition.letters.new("W", "rad/s")
        composition.tied.append("one")
    composition.second("particle")
    composition.put("connections", "tube", {"rides": ["two", "one"], "friction": "none"})
    composition.riders.append("two")
    return None


def in_a_slot(composition: Composition) -> bool | None:
    """A yoke with an upright slot, in which the end of a crank slides."""
    if composition.kinds["one"].word not in ("rod", "light rod") or not composition.has("hinge"):
        return False
    if len(composition.bodies) > 1:
        return False
    composition.sections["connections"]["pin"] = {"hinge": "one.start"}
    composition.second("particle")
    level = composition.often(0.5)
    composition.bodies["two"]["moves"] = composition.pick(*(("left", "right") if level else ("up", "down")))
    along = "up" if level else "right"
    composition.put("connections", "yoke", {"slot": ["one.end", "two"], "along": along})
    composition.tied.append("two")
    composition.ways["two"] = LINE
    return None


def bounced(composition: Composition) -> bool | None:
    """What flies strikes a floor, smooth or rough, or a peg."""
    if (
        composition.ways["one"] not in (PLANE, LINE)
        or composition.sections.get("connections")
        or len(composition.bodies) > 1
    ):
        return False
    kind = composition.kinds["one"]
    composition.put("surfaces", "floor", "level")
    at = "one" if kind.rims or not kind.extended else composition.place("one")
    against = composition.pick("floor", "floor", "ground")
    blow = {"collides": [at, against], "restitution": composition.letters.new("e", "")}
    if composition.often(0.4) and against == "floor":
        blow["friction"] = composition.letters.new("mu", "") if composition.often(0.6) else "any"
    composition.put("events", "hit", blow)
    return None
