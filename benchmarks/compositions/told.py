"""Told: what the states say: at rest or with speeds, and where or when the next one is."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from compositions.parts import ARC, LINE, PLANE, ROLL, SWING, TURN, Composition

Lines = dict[str, Any]
SPEED = {
    LINE: ("velocity", "m/s"),
    ROLL: ("velocity", "m/s"),
    ARC: ("velocity", "m/s"),
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
        if way == ARC:
            found["base.angle"] = composition.pick("90 deg", "60 deg", "-90 deg", "-30 deg", "200 deg")
        if way == ROLL and uneven(composition, name):
            found[f"{name}.angle"] = composition.pick("-90 deg", "-60 deg", "30 deg", "180 deg")
    return found


def uneven(composition: Composition, name: str) -> bool:
    """Whether the centre of mass of what rolls is off its middle, so that it matters how it stands."""
    return name in composition.kinds and composition.kinds[name].word in ("half ball", "loaded wheel")


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
        **riding(composition, moving=moving),
        **{f"{name}.elongation": composition.letters.new("x", "m") for name in composition.has("spring")[:1]},
    }
    if moving:
        return {**lines, **speeds(composition)}
    if composition.loose:
        rest = [name for name in composition.bodies if name not in composition.loose]
        told = {f"{name}.velocity": composition.letters.new("u", "m/s") for name in composition.loose}
        return {**lines, "at rest": rest, **told}
    return {**lines, "at rest": "all"}


def riding(composition: Composition, *, moving: bool) -> Lines:
    """Where beads are that slide along the first body, and how fast."""
    found: Lines = {}
    for name in composition.riders:
        found[f"{name}.radius"] = composition.letters.new("s", "m")
        if moving:
            found[f"{name}.velocity.radial"] = composition.letters.new("v", "m/s")
    return found


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
    if way == ARC:
        return states(composition, start, {"base.angle": composition.pick("0 deg", "45 deg", "-90 deg", "120 deg")})
    if composition.riders:
        return states(composition, start, {f"{composition.riders[0]}.radius": composition.letters.new("s", "m")})
    if way == PLANE:
        return states(composition, start, {"one.displacement.y": composition.pick("0", "-1 m", "0.2 m")})
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


def sticks(composition: Composition) -> bool | None:
    """Until what slips holds."""
    slipping = [*composition.has("clutch"), *composition.has("contact")]
    if not slipping or "one" in composition.tied:
        return False
    word = "rolls" if composition.ways["one"] == ROLL and composition.often(0.7) else "sticks"
    return states(composition, first(composition, moving=True), {slipping[0]: word})


def leaves(composition: Composition) -> bool | None:
    """Until it leaves a round track."""
    if composition.ways["one"] != ARC:
        return False
    return states(composition, first(composition, moving=composition.often(0.5)), {"base": "leaves"})


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
    "sticks": sticks,
    "leaves": leaves,
    "balanced": balanced,
    "swings": swings,
}
