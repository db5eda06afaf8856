"""Told: what the states say: at rest or with speeds, and where or when the next one is."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from compositions.parts import LINE, PLANE, ROLL, SWING, TURN, Composition

Lines = dict[str, Any]
SPEED = {
    LINE: ("velocity", "m/s"),
    ROLL: ("velocity", "m/s"),
    TURN: ("angular_velocity", "rad/s"),
    SWING: ("angular_velocity", "rad/s"),
}
WAY = {LINE: ("displacement", "m"), ROLL: ("displacement", "m"), TURN: ("rotation", "deg")}


def angles(composition: Composition) -> Lines:
    """The angles of all that hangs, leans or swings; now and then a round number."""
    found: Lines = {}
    for name, way in composition.ways.items():
        rod = composition.kinds[name].word in ("rod", "light rod") if name in composition.kinds else False
        if way == SWING or (way == PLANE and rod):
            told = composition.pick("0", "30 deg", "-90 deg", "60 deg", "-40 deg", "120 deg")
            leaning = composition.pick("50 deg", "70 deg") if composition.has("contact") else told
            found[f"{name}.angle"] = leaning
    return found


def speeds(composition: Composition) -> Lines:
    """A speed of each body that no other one gives its own."""
    found: Lines = {}
    for name, way in composition.ways.items():
        if name in composition.tied:
            continue
        if way == PLANE:
            found[f"{name}.velocity"] = [composition.letters.new("u", "m/s"), composition.letters.new("v", "m/s")]
        if way in SPEED:
            word, unit = SPEED[way]
            found[f"{name}.{word}"] = f"{composition.pick('', '', '', '-')}{composition.letters.new(word[0], unit)}"
        slips = (
            way == ROLL
            and (composition.has("contact") or composition.has("spring"))
            and name not in composition.gripped
        )
        if way == PLANE or slips:
            found[f"{name}.angular_velocity"] = composition.letters.new("w", "rad/s")
    return found


def first(composition: Composition, *, moving: bool) -> Lines:
    """The lines of the first state."""
    lines = {
        **angles(composition),
        **{f"{name}.elongation": composition.letters.new("x", "m") for name in composition.has("spring")[:1]},
    }
    if moving:
        return {**lines, **speeds(composition)}
    if composition.loose:
        rest = [name for name in composition.bodies if name not in composition.loose]
        told = {f"{name}.velocity": composition.letters.new("u", "m/s") for name in composition.loose}
        return {**lines, "at rest": rest, **told}
    return {**lines, "at rest": "all"}


def states(composition: Composition, start: Lines, later: Lines | None) -> bool | None:
    """The states in order; an event leads to one of its own."""
    made: dict[str, Lines] = {"start": start}
    if "events" in composition.sections:
        made["after"] = {}
        composition.sections["events"]["hit"] |= {"from": "start", "to": "after"}
        if "pushed" in composition.sections.get("actions", {}):
            return False
    if later is not None:
        made["end"] = later
    elif "push" in composition.sections.get("actions", {}):
        return False
    composition.sections["states"] = made
    return None


def released(composition: Composition) -> bool | None:
    return states(composition, first(composition, moving=False), None)


def moving(composition: Composition) -> bool | None:
    return states(composition, first(composition, moving=True), None)


def later(composition: Composition) -> bool | None:
    """So long after; where a pendulum is then no closed form tells, so that it is not told so often."""
    if composition.ways["one"] == SWING and composition.often(0.8):
        return False
    return states(
        composition, first(composition, moving=composition.often(0.5)), {"time": composition.letters.new("t1", "s")}
    )


def farther(composition: Composition) -> bool | None:
    way = composition.ways["one"]
    if "one" in composition.tied:
        return False
    start = first(composition, moving=composition.often(0.4))
    if way == SWING:
        return states(composition, start, {"one.angle": composition.pick("-90 deg", "10 deg", "-20 deg", "45 deg")})
    if way not in WAY:
        return False
    word, unit = WAY[way]
    sign = "-" if composition.often(0.2) else ""
    return states(composition, start, {f"one.{word}": f"{sign}{composition.letters.new('d', unit)}"})


def stops(composition: Composition) -> bool | None:
    way = composition.ways["one"]
    if way not in SPEED or "one" in composition.tied:
        return False
    return states(composition, first(composition, moving=True), {f"one.{SPEED[way][0]}": "0"})


def balanced(composition: Composition) -> bool | None:
    """Held by a force or a couple that is asked for."""
    if "events" in composition.sections or composition.loose:
        return False
    kind, way = composition.kinds["one"], composition.ways["one"]
    if way == PLANE or (way == ROLL and (kind.word == "loaded wheel" or not composition.has("rolls"))):
        return False
    if SWING in [other for name, other in composition.ways.items() if name != "one"] or composition.has("shaft"):
        return False
    held = {"couple": "unknown", "on": "one"}
    if way in (LINE, ROLL):
        held = {"force": "unknown", "on": "one", "direction": composition.bodies["one"].get("moves", "right")}
    composition.put("actions", "hold", held)
    return states(composition, {**angles(composition), "balance": "true"}, None)


def swings(composition: Composition) -> bool | None:
    pushed = "push" in composition.sections.get("actions", {})
    return False if pushed or "events" in composition.sections or composition.has("shaft") else None


TOLD: dict[str, Callable[[Composition], bool | None]] = {
    "released": released,
    "moving": moving,
    "later": later,
    "farther": farther,
    "stops": stops,
    "balanced": balanced,
    "swings": swings,
}
