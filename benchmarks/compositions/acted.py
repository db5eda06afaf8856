"""Acted: what acts on the first body from outside."""

from __future__ import annotations

from collections.abc import Callable

from compositions.parts import LINE, PLANE, ROLL, SWING, TURN, Composition

Act = Callable[[Composition], bool | None]
TURNS = (TURN, SWING, PLANE, ROLL)


def nothing(composition: Composition) -> bool | None:
    return None


def pulled(composition: Composition) -> bool | None:
    direction = composition.pick("left", "right", "up", "down")
    if composition.often(0.3):
        direction = composition.letters.new("gamma", "deg")
    force = composition.letters.new("F", "N")
    composition.put("actions", "pull", {"force": force, "on": composition.place("one"), "direction": direction})
    return None


def twisted(composition: Composition) -> bool | None:
    if composition.ways["one"] not in TURNS or not composition.kinds["one"].extended:
        return False
    composition.put("actions", "twist", {"couple": composition.letters.new("Q", "N m"), "on": "one"})
    return None


def damped(composition: Composition) -> bool | None:
    if composition.ways["one"] not in (TURN, SWING):
        return False
    letter = composition.letters.new("c", "N m s")
    composition.put("actions", "oil", {"couple": f"-{letter}*one.angular_velocity", "on": "one"})
    return None


def braked(composition: Composition) -> bool | None:
    rim = "rim" in composition.kinds["one"].points
    if composition.ways["one"] != TURN or not rim or "truck" in composition.bodies:
        return False
    press, friction = composition.letters.new("B", "N"), composition.letters.new("mu", "")
    composition.put("actions", "brake", {"press": press, "on": "one.rim", "friction": friction})
    return None


def banded(composition: Composition) -> bool | None:
    """A band brake round the rim."""
    if composition.ways["one"] != TURN or composition.kinds["one"].word not in ("disc", "ring", "annulus"):
        return False
    pull, friction = composition.letters.new("B", "N"), composition.letters.new("mu", "")
    band = {"band": pull, "on": "one.rim", "friction": friction, "wrap": composition.pick("90 deg", "1/2 rev")}
    composition.put("actions", "band", {**band, "direction": composition.pick("clockwise", "counterclockwise")})
    return None


def dragged(composition: Composition) -> bool | None:
    """A drag in proportion to the speed, on what goes along a line."""
    if composition.ways["one"] not in (LINE, ROLL):
        return False
    drag = f"-{composition.letters.new('c', 'N s/m')}*one.velocity"
    moves = composition.bodies["one"].get("moves", "right")
    composition.put("actions", "drag", {"force": drag, "on": composition.middle("one"), "direction": moves})
    return None


def knocked(composition: Composition) -> bool | None:
    """A given blow, as an event of its own."""
    if "events" in composition.sections:
        return False
    direction = composition.pick("left", "right", "up", "down")
    impulse = composition.letters.new("J", "N s")
    composition.put("events", "hit", {"impulse": impulse, "on": composition.place("one"), "direction": direction})
    return None


def pushed_while(composition: Composition) -> bool | None:
    """A force that acts between the two states alone, on a body that travels."""
    if composition.ways["one"] not in (LINE, ROLL):
        return False
    direction = composition.pick("left", "right")
    entry = {"force": composition.letters.new("F", "N"), "on": "one", "direction": direction}
    composition.put("actions", "push", {**entry, "from": "start", "to": "end"})
    return None


ACTS: dict[str, Act] = {
    "nothing": nothing,
    "pulled": pulled,
    "twisted": twisted,
    "damped": damped,
    "braked": braked,
    "banded": banded,
    "dragged": dragged,
    "knocked": knocked,
    "pushed for a while": pushed_while,
}
