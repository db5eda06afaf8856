"""The contract of the words: for each key of each element, shape and body there is a scene in which the key changes an answer.

Left out, or changed, it is another scene: what the key says takes part. Nothing that is written so ends in an internal error.
"""

from __future__ import annotations

import copy
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.elements.tables import ACTIONS, CONNECTIONS, EVENTS, SHAPES, SURFACES
from rotsolve.language.grammar import BODY
from rotsolve.language.keys import keys_of
from rotsolve.pipeline import solve
from rotsolve.scene.idle import HARMLESS

ROOT = Path(__file__).resolve().parents[2]
TABLES: dict[str, tuple[Any, ...]] = {
    "surfaces": SURFACES,
    "connections": CONNECTIONS,
    "actions": ACTIONS,
    "events": EVENTS,
    "shapes": SHAPES,
}
ALWAYS_REFUSED: set[tuple[str, str]] = set()  # nothing goes by it yet: refused as a word that says nothing
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?![\w.])")
SEVERAL, FEW, ENOUGH = 6, 8, 10  # scenes with a key, changes of each, and refusals, that are looked at
ROD = "bodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}}\n"
WHEEL = "bodies: {wheel: {shape: disc, mass: 2 kg, radius: 20 cm}}\nconnections: {axle: {axle: wheel}}\n"
TIMES = "states: {a: {wheel.angular_velocity: 50 rad/s}, b: {time: 1 s}, c: {time: 1 s}}\nfind: {w: wheel.angular_velocity at c}\n"
SCENES = {  # for keys that no other scene of the tests has
    "stiff hinge": ROD
    + "connections: {pin: {hinge: rod.start, friction_torque: 3 N m}}\n"
    + "states: {a: {rod.angle: 0, at rest: all}}\nfind: {alpha: rod.angular_acceleration at a}\n",
    "driven hinge": ROD
    + "connections: {pin: {hinge: rod.start, angular_velocity: 2 rad/s}}\n"
    + "states: {a: {rod.angle: 0}}\nfind: {F: pin.force.x at a}\n",
    "brake for a while": WHEEL + "actions: {act: {press: 4 N, on: wheel.rim, friction: 0.3, from: a, to: b}}\n" + TIMES,
    "brake later on": WHEEL + "actions: {act: {press: 4 N, on: wheel.rim, friction: 0.3, from: b}}\n" + TIMES,
    "motor for a while": WHEEL + "actions: {act: {power: 10 W, on: wheel, from: a, to: b}}\n" + TIMES,
    "motor later on": WHEEL + "actions: {act: {power: 10 W, on: wheel, from: b}}\n" + TIMES,
    "couple for a while": WHEEL + "actions: {act: {couple: 0.1 N m, on: wheel, to: b}}\n" + TIMES,
    "couple later on": WHEEL + "actions: {act: {couple: 0.1 N m, on: wheel, from: b}}\n" + TIMES,
    "force for a while": WHEEL + "actions: {act: {force: 1 N, on: wheel.rim, direction: tangential, to: b}}\n" + TIMES,
    "sides": "bodies: {t: {shape: triangle, mass: 2 kg, sides: [3 m, 4 m, 5 m]}}\nfind: {I: t.inertia}\n",
    "corners": "bodies: {t: {shape: triangle, mass: 2 kg, corners: [[0, 0], [3 m, 0], [0, 4 m]]}}\nfind: {I: t.inertia}\n",
    "shell": "bodies: {t: {shape: spherical shell, mass: 2 kg, radii: {inner: 1 m, outer: 2 m}}}\nfind: {I: t.inertia}\n",
    "led": "bodies: {t: {shape: rod, mass: 2 kg, length: 1 m, angle: 3 rad/s^2*time^2, position: [1 m, 2 m]}}\n"
    + "find: {w: t.angular_velocity at any time}\n",
    "gyration": "bodies: {w: {mass: 2 kg, gyration: 20 cm}}\nconnections: {a: {axle: w}}\n"
    + "actions: {c: {couple: 2 N m, on: w}}\nfind: {alpha: w.angular_acceleration}\n",
    "place of a spring": ROD
    + "connections: {pin: {hinge: rod.start}, coil: {spring: [[0, 2 m], rod.end], stiffness: 50 N/m, rest_length: 30 cm}}\n"
    + "states: {now: {rod.angle: 0, at rest: all}}\nfind: {alpha: rod.angular_acceleration at now}\n",
}

Tree = dict[str, Any]
Place = tuple[str, str, str]  # a section, the name of what it declares, a key of that


@cache
def texts() -> dict[str, str]:
    """All scenes of the tests, the problems and the docs."""
    found = dict(SCENES)
    for folder in ("tests/engine/scenes", "problems"):
        found |= {file.stem: file.read_text(encoding="utf-8") for file in sorted((ROOT / folder).rglob("*.yaml"))}
    blocks = re.findall(r"```yaml\n(.*?)```", (ROOT / "docs/language.md").read_text(encoding="utf-8"), re.S)
    return found | {f"example {number}": block for number, block in enumerate(blocks) if "find:" in block}


@cache
def trees() -> dict[str, Tree]:
    """The scenes as nested maps of texts."""
    loaded = {name: yaml.load(text, yaml.BaseLoader) for name, text in texts().items()}
    return {name: tree for name, tree in loaded.items() if isinstance(tree, dict)}


@cache
def written_in() -> dict[tuple[str, str], list[tuple[str, Place]]]:
    """By word of an element, shape or body and key: where scenes have it."""
    found: dict[tuple[str, str], list[tuple[str, Place]]] = defaultdict(list)
    for scene, tree in trees().items():
        for section in ("surfaces", "connections", "actions", "events", "bodies"):
            for name, item in (tree.get(section) or {}).items() if isinstance(tree.get(section), dict) else ():
                for key in item if isinstance(item, dict) else ():
                    found[word_of(section, item, key), key].append((scene, (section, name, key)))
    return found


def word_of(section: str, item: Tree, key: str) -> str:
    """The word of the class that has a key."""
    if section != "bodies":
        return next((kind.word for kind in TABLES[section] if kind.word in item), "")
    shape = next((kind for kind in SHAPES if kind.word == item.get("shape")), None)
    return shape.word if shape is not None and key in dict(keys_of(shape)) else "body"


def said(tree: Tree) -> object:
    """What a scene answers; None where it is refused."""
    try:
        solution = solve(yaml.dump(tree, sort_keys=False, allow_unicode=True, width=10**6), confirm=False)
    except (SceneError, Unsolvable):
        return None
    answers = solution.answers.values()
    return [
        (one.exact, one.value, one.word, [(part.exact, part.value) for part in one.components.values()])
        for one in answers
    ]


@cache
def said_by(scene: str) -> object:
    """What one of the scenes answers as it stands."""
    return said(trees()[scene])


def changes(value: Any, choices: tuple[str, ...]) -> Iterator[Any]:
    """Other things that a key might say."""
    if isinstance(value, str):
        yield from (other for other in choices if other != value)
        yield {"true": "false", "false": "true"}.get(value, NUMBER.sub(lambda found: f"{found[0]}1", value, count=1))
        yield f"1.3*({value})"
    elif isinstance(value, list):
        yield value[::-1]
        yield value[:-1]
        for place, item in enumerate(value):
            yield from ([*value[:place], other, *value[place + 1 :]] for other in changes(item, choices))
    elif isinstance(value, dict):
        yield from ({name: other for name, other in value.items() if name != left} for left in value)
        for name, item in value.items():
            yield from (value | {name: other} for other in changes(item, choices))


def variants(tree: Tree, place: Place, choices: tuple[str, ...]) -> Iterator[Tree]:
    """The scene without a key, then with other values of it."""
    section, name, key = place
    without = copy.deepcopy(tree)
    del without[section][name][key]
    yield without
    for other in changes(tree[section][name][key], choices):
        varied = copy.deepcopy(tree)
        varied[section][name][key] = other
        yield varied


def contract() -> list[Any]:
    """Each key that is solved, with its word."""
    keys = [
        (kind.word, word, key)
        for table in TABLES.values()
        for kind in table
        if not kind.later
        for word, key in keys_of(kind)
    ]
    keys += [("body", word, key) for word, key in BODY.items() if word != "shape"]
    return [pytest.param(word, name, key, id=f"{word} {name}") for word, name, key in keys if not key.later]


@pytest.mark.parametrize(("word", "name", "key"), contract())
def test_each_key_takes_part(word: str, name: str, key: Any) -> None:
    """In some scene it changes an answer; where every change of it is refused, it decides whether there is one."""
    if (word, name) in ALWAYS_REFUSED:
        assert not written_in()[word, name]
        return
    places = written_in()[word, name]
    assert places, f"no scene has `{name}` of `{word}`"
    refused = 0
    for scene, place in sorted(places, key=lambda one: len(texts()[one[0]]))[:SEVERAL]:  # short ones are soon solved
        right = said_by(scene)
        for number, varied in enumerate(variants(trees()[scene], place, key.choices) if right is not None else ()):
            found = said(varied)
            if found is not None and found != right:
                return
            refused += found is None
            if number >= FEW or refused >= ENOUGH:
                break
        if refused >= ENOUGH:
            break
    assert refused or name in HARMLESS, f"`{name}` of `{word}` changes nothing"


def test_a_component_may_be_a_number() -> None:
    scene = "up: z\nbodies: {b: {shape: cuboid, mass: 3 kg, sides: [60 cm, 40 cm, 20 cm]}}\nfind: {p: FIND}\n"
    third, first = (solve(scene.replace("FIND", f"b.principal_moments.{k}")).derivation.answers[0] for k in (3, 1))
    gap = solve(scene.replace("FIND", "b.principal_moments.3 - b.principal_moments.1")).derivation.answers[0]
    assert [item.value.float for item in (third, first, gap) if item.value] == pytest.approx([0.13, 0.05, 0.08])


@pytest.mark.parametrize("find", ["b.mass.5", "b.inertia_tensor.2", "a.5", "2*a.25"])
def test_a_number_behind_a_point_is_no_factor(find: str) -> None:
    scene = "up: z\ngiven: {a: 1 kg}\nbodies: {b: {shape: cuboid, mass: a, sides: [60 cm, 40 cm, 20 cm]}}\nfind: {p: FIND}\n"
    with pytest.raises(SceneError):
        solve(scene.replace("FIND", find))
