"""Turned: a scene in space turned by a quarter about the vertical, where all vectors along space axes must turn with it; and its judge."""

from __future__ import annotations

import copy
import random
from collections.abc import Iterator
from typing import Any

from compositions import freed
from compositions.judge import DIGITS, LETTERED, apart, differing, judged
from compositions.relations import RELATIONS
from compositions.space import drawn
from rotsolve.scene.read import read_text
from trials.outcome import OBJECTED, SOLVED, Outcome, Printed, outcome
from trials.scene import Scene, written
from trials.trial import Result

QUARTER = {"about": "z", "by": "90 deg"}
AXES = {"x": "y", "y": "-x", "-x": "-y", "-y": "x"}
SAME = ("each question alone", "in another order", "by other names", "in other units", "with forces as two halves")
LAWS = ("newton", "energy", "angular-momentum", "lagrange")
TURNED = "turned by 90° about the vertical"
FREE_VECTORS = ("one.velocity", "one.angular_velocity")  # that states tell along space axes


def run(seed: int, number: int) -> Result:
    """Compose the scene in space of a number, solve it, and judge."""
    choice, scene = drawn(seed, number)
    found = outcome(written(scene), DIGITS)
    verdict, why = judged(scene, found, random.Random(f"relations-{seed}-{number}"), differences)
    return Result(number, ", ".join(choice), verdict, found.seconds, (why,) if why else (), written(scene))


def differences(scene: Scene, found: Outcome, chance: random.Random) -> Iterator[str]:
    """How the scene said in other ways, by a law, in letters or turned, is answered otherwise: two ways, drawn at random."""
    for name in chance.sample((*SAME, *LAWS, LETTERED, TURNED, TURNED), 2):
        if name == LETTERED:
            lettered = freed.differences(read_text(written(scene) + "\n"))
            yield from (f"{name}: {text}\n{written(scene)}" for text in lettered if not text.startswith(freed.REFUSED))
        elif name == TURNED:
            other = turned(scene)
            yield from not_turned(found, outcome(written(other), DIGITS), other)
        elif name in LAWS:
            yield from differing(found, outcome(written(scene), DIGITS, law=name), f"by {name}", scene)
        else:
            for other in RELATIONS[name](scene, chance):
                yield from differing(found, outcome(written(other), DIGITS), name, other)


def turned(scene: Scene) -> Scene:
    """The scene with its bodies, and all that it tells along space axes, turned from x to y."""
    result = copy.deepcopy(scene)
    states = result["states"].values()
    leads = result["bodies"].get("frame", result["bodies"]["one"])  # a carried body turns with its frame
    if any("one.tilt" in state for state in states):
        for state in states:
            if "one.tilt" in state and state["one.tilt"] not in ("largest", "smallest"):
                state["one.precession_angle"] = "90 deg"
    else:
        before = leads.get("turned", [])
        leads["turned"] = [*(before if isinstance(before, list) else [before]), QUARTER]
    for part in (*result.get("actions", {}).values(), *result.get("events", {}).values(), *states):
        for word in part:
            if word in ("direction", "couple", *FREE_VECTORS) and part[word] != "any":
                part[word] = quarter(part[word])
    return result


def quarter(value: Any) -> Any:
    """A direction, or the components of a vector, turned from x to y; what counts about an axis of a joint stays."""
    if isinstance(value, str):
        return AXES.get(value, value)
    return [negative(value[1]), value[0], value[2]]


def negative(text: str) -> str:
    return text if text == "0" else text.removeprefix("-") if text.startswith("-") else f"-{text}"


def not_turned(one: Outcome, other: Outcome, scene: Scene) -> Iterator[str]:
    """Where the answers of the turned scene are not those of the first one, turned."""
    if other.kind not in (SOLVED, OBJECTED):
        yield f"{TURNED}: {other.message.splitlines()[0] if other.message else other.kind}\n{written(scene)}"
        return
    for name, value in turned_answers(one.answers, scene).items():
        if name in other.answers and apart(value, other.answers[name]):
            yield f"{TURNED}: {name} = {other.answers[name].text} instead of {value.text}\n{written(scene)}"


def turned_answers(answers: dict[str, Printed], scene: Scene) -> dict[str, Printed]:
    """The answers turned from x to y: vectors and tensors along space axes; what has a size only, or body axes, stays."""
    result = dict(answers)
    for name, question in scene["find"].items():
        if " axes" in question or "inertia" in question or "principal" in question or f"{name}.x" not in answers:
            continue
        result[f"{name}.x"], result[f"{name}.y"] = opposite(answers[f"{name}.y"]), answers[f"{name}.x"]
    return result


def opposite(value: Printed) -> Printed:
    return Printed(negative(value.text) if value.text else "", value.note)
