"""Told in space: what the first state says of a body, from what its joint leaves free, and what the second one is."""

from __future__ import annotations

from typing import Any

from compositions.body_in_space import ROUND
from compositions.parts import Composition

FREE, BALL, HINGE, DRIVEN, CARRIED, ROLLING = "free", "ball", "hinge", "driven", "carried", "rolling"  # ways of moving
Lines = dict[str, Any]


def direction(composition: Composition) -> Any:
    """An axis, or a direction between them."""
    slanted = [composition.pick("1", "0", "-1", "2"), composition.pick("0", "1", "3"), "1"]
    return composition.chance.choice(("x", "y", "z", "-z", slanted, slanted))


def vector(composition: Composition, letter: str, unit: str) -> list[str]:
    """Three components, of which one or two may be 0."""
    kept = composition.chance.choice(((0,), (1,), (2,), (0, 2), (1, 2), (0, 1, 2)))
    sign = [composition.pick("", "", "-") for _ in range(3)]
    return [f"{sign[place]}{composition.letters.new(letter, unit)}" if place in kept else "0" for place in range(3)]


def at_rest(composition: Composition, way: str) -> Lines | None:
    return {"at rest": "one"} if way in (FREE, BALL) else {"one.angular_velocity": "0 rad/s"} if way == HINGE else None


def turning(composition: Composition, way: str) -> Lines | None:
    """Its angular velocity, along space or body axes, and how fast it travels; about a hinge its angle too."""
    letters = composition.letters
    if way == HINGE:
        angle = composition.pick("0 deg", letters.new("phi", "deg"))
        return {"one.angle": angle, "one.angular_velocity": letters.new("w", "rad/s")}
    if way not in (FREE, BALL):
        return None
    axes = composition.pick("", " in body axes")
    lines: Lines = {f"one.angular_velocity{axes}": vector(composition, "w", "rad/s")}
    return {**lines, "one.velocity": vector(composition, "v", "m/s")} if way == FREE else lines


def euler(composition: Composition, way: str) -> Lines | None:
    """The Euler angles and their rates."""
    if way not in (FREE, BALL, ROLLING):
        return None
    stands(composition)
    rates = {f"one.{word}": composition.letters.new("w", "rad/s") for word in ("precession", "nutation", "spin")}
    lines: Lines = {"one.tilt": tilt(composition), **rates}
    if composition.often(0.4) and composition.kinds["one"].word not in ROUND:
        lines["one.spin_angle"] = composition.letters.new("psi", "deg")
    return {**lines, "one.velocity": vector(composition, "v", "m/s")} if way == FREE else lines


def stands(composition: Composition, *, on_axis: bool = False) -> None:
    """The first body by its Euler angles: they say how it is turned; `on_axis` holds it below its centre of mass on its axis."""
    body = composition.bodies["one"]
    body.pop("turned", None)
    if composition.kinds["one"].word not in (*ROUND, "rod"):
        body["axis"] = "z"
    if on_axis:
        body["points"]["P"] = ["0 m", "0 m", f"-{composition.letters.new('l', 'm')}"]
        composition.put("connections", "joint", {"ball": "one.P"})


def tilt(composition: Composition) -> str:
    return composition.pick("90 deg", *[composition.letters.new("theta", "deg")] * 3)


def steady(composition: Composition, way: str) -> Lines | None:
    """Tilt and spin of what precesses steadily."""
    if way not in (BALL, ROLLING):
        return None
    if composition.kinds["one"].word not in ROUND and composition.often(0.8):
        return None
    stands(composition, on_axis=way == BALL and composition.often(0.9))
    spin = composition.pick("spin", "axial_rate")
    lines: Lines = {"one.tilt": tilt(composition), f"one.{spin}": composition.letters.new("s", "rad/s"), "steady": "true"}  # fmt: skip
    which = composition.pick("smallest", "largest", "")
    return {**lines, "one.precession": which} if which else lines


def let_go(composition: Composition, way: str) -> Lines | None:
    """A top that spins and does not yet precess."""
    if way != BALL:
        return None
    stands(composition, on_axis=composition.often(0.8))
    rates = {"one.precession": "0 rad/s", "one.nutation": "0 rad/s"}
    return {"one.tilt": tilt(composition), "one.axial_rate": composition.letters.new("s", "rad/s"), **rates}


def driven_on(composition: Composition, way: str) -> Lines | None:
    """What is driven has nothing more to tell but how it stands."""
    if way not in (DRIVEN, CARRIED):
        return None
    return {"one.angle": composition.pick("0 deg", composition.letters.new("phi", "deg"))}


def only(composition: Composition, way: str) -> bool:
    return True


def blow(composition: Composition, way: str) -> bool:
    if way not in (FREE, BALL, HINGE) or "actions" in composition.sections:
        return False
    hit = {"impulse": composition.letters.new("J", "N s"), "on": composition.place("one")}
    composition.put("events", "hit", {**hit, "direction": direction(composition), "from": "start", "to": "end"})
    composition.sections["states"]["end"] = {}
    return True


def later(composition: Composition, way: str) -> bool:
    """After a time: mostly what has a closed form, free or led, on a hinge or precessing steadily."""
    followed = {FREE: "actions" not in composition.sections, BALL: "steady" in composition.sections["states"]["start"]}
    if not followed.get(way, way != ROLLING) and composition.often(0.85):
        return False
    composition.sections["states"]["end"] = {"time": composition.letters.new("t", "s")}
    return True


def farther(composition: Composition, way: str) -> bool:
    """At its largest tilt, or at an angle on its hinge."""
    if way not in (BALL, HINGE) or (way == BALL and "one.tilt" not in composition.sections["states"]["start"]):
        return False
    if "actions" in composition.sections and composition.often(0.8):
        return False
    place = {"one.tilt": composition.pick("largest", "smallest")}
    composition.sections["states"]["end"] = place if way == BALL else {"one.angle": composition.letters.new("phi", "deg")}  # fmt: skip
    return True


TOLD = {entry.__name__: entry for entry in (at_rest, turning, euler, steady, let_go, driven_on)}
NEXT = {entry.__name__: entry for entry in (only, blow, later, farther)}
