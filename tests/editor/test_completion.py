"""What is offered where: keys by the level, names, points, quantities, choices, units; and that what is offered may stand there."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from rotsolve.core.faults import SceneError
from rotsolve.core.quantity import QUANTITIES
from rotsolve.editor.completion import offers_at
from rotsolve.editor.offers import Offer
from rotsolve.editor.scene_text import SceneText
from rotsolve.elements.tables import SHAPES
from rotsolve.language.grammar import SECTIONS
from rotsolve.language.keys import keys_of
from rotsolve.scene.elements import TABLES
from rotsolve.scene.read import read_text

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
BASE = """given: {m: 2 kg, R: 20 cm, beta: 30 deg}
surfaces: {floor: level}
bodies:
  block: {mass: m}
  rod: {shape: rod, mass: 2 kg, length: R}
connections:
  cord: {string: [rod.end, block]}
  base: {contact: [block, floor], friction: 0.3}
states:
  start: at rest
  end: {time: 2 s}
"""
SPACE = "up: z\nbodies:\n  top: {shape: cone, mass: 1 kg, radius: 1 m, length: 1 m}\nconnections:\n  joint: {ball: top.tip}\n"


def offered(marked: str) -> list[Offer]:
    """What is offered at the mark `|` of a text."""
    before, _, after = marked.partition("|")
    line, column = before.count("\n"), len(before) - before.rfind("\n") - 1
    return offers_at(SceneText(before + after), line, column)[0]


def labels(marked: str) -> set[str]:
    return {item.word for item in offered(marked)}


@pytest.mark.parametrize(
    ("marked", "there", "not_there"),
    [
        ("|", {*SECTIONS}, {"mass"}),
        ("given: {m: 2 kg}\n|", {"bodies", "find"}, {"given"}),
        ("gi|ven: {m: 2 kg}", {"given"}, {"mass"}),
        ("bodies:\n  a: |", {shape.word for shape in SHAPES}, {"rodd"}),
        ("bodies:\n  a: {|", {"shape", "mass", "radius", "parts", "moves"}, {"length", "axis"}),
        ("bodies:\n  a: {shape: rod, |", {"length", "mass"}, {"shape", "radius", "sides"}),
        ("bodies:\n  a:\n    shape: disc\n    |", {"radius", "mass"}, {"shape", "length"}),
        ("up: z\nbodies:\n  a: {|", {"axis", "turned"}, set()),
        ("bodies: {a: {parts: {b: {shape: rod, |", {"start", "end", "at", "length"}, {"radius"}),
        ("bodies: {a: {shape: annulus, radii: {|", {"inner", "outer"}, {"big"}),
        ("bodies: {a: {inertia: {|", {"value", "about"}, {"mass"}),
        ("bodies: {a: {moves: |", {"left", "right", "up", "down"}, {"clockwise", "m"}),
        ("up: |", {"y", "z"}, {"unknown"}),
        ("surfaces:\n  s: |", {"level", "slope"}, {"string"}),
        (BASE + "actions:\n  F: |", {"force", "couple"}, {"string"}),
        (BASE + "actions:\n  F: {|", {"force", "couple"}, {"on"}),
        (BASE + "actions:\n  F: {force: 3 N, |", {"on", "direction"}, {"force", "couple"}),
        (BASE + "actions:\n  F: {force: 3 N, on: |", {"block", "rod", "floor"}, {"cord"}),
        (BASE + "actions:\n  F: {force: 3 N, on: rod.|", {"start", "end", "at(x)"}, {"angle"}),
        (BASE + "actions:\n  F: {force: 3 |", {"N", "lbf"}, {"kg", "m"}),
        (BASE + "actions:\n  F: {force: |", {"m", "time", "unknown"}, {"N"}),
        (BASE + "connections:\n  x: {contact: [block, |", {"rod", "floor"}, {"cord"}),
        (BASE + "events:\n  e: {from: |", {"start", "end"}, {"rod"}),
        (BASE + "events:\n  e: {cuts: |", {"cord", "base"}, {"rod"}),
        (BASE + "phases:\n  p: {|", {"from", "to", "without"}, {"on"}),
        (BASE + "  later: {|", {"rod", "block", "base", "at rest", "balance", "time"}, {"floor"}),
        (BASE + "  later: {rod.|", {"angle", "end", "angular_velocity"}, {"tension", "tilt"}),
        (BASE + "  later: {rod.end.|", {"velocity", "height"}, {"angle", "start"}),
        (BASE + "  later: {rod.angle: |", {"beta", "largest", "unknown"}, {"rolls"}),
        (BASE + "  later: {rod.angle: 30 |", {"deg", "rad", "rev"}, {"m", "%"}),
        (BASE + "  later: {base: |", {"rolls", "slips", "sticks", "leaves"}, {"slack"}),
        (BASE + "  later: {cord: |", {"slack", "taut"}, {"rolls"}),
        (BASE + "  later:\n    rod.ang|", {"angle", "angular_velocity"}, {"tension"}),
        (BASE + "find:\n  a: |", {"block", "cord", "m", "kinetic_energy", "size of", "lost"}, {"floor", "at"}),
        (BASE + "find:\n  a: block.acc|", {"acceleration"}, {"tension"}),
        (BASE + "find: {a: cord.|", {"tension", "block", "rod"}, {"angle"}),
        (BASE + "find: {a: cord.block.|", {"tension"}, {"rod"}),
        (BASE + "find: {a: rod.force.|", {"x", "net", "gravity", "cord"}, {"force"}),
        (BASE + "find:\n  a: rod.angle |", {"at", "from", "during", "in"}, set()),
        (BASE + "find:\n  a: rod.angle at |", {"start", "end", "any time"}, {"rod"}),
        (BASE + "find:\n  a: rod.angle at end in |", {"deg", "rev"}, {"rod"}),
        (BASE + "find: {a: rod.angle}\nanswers:\n  |", {"a"}, {"m"}),
        (BASE + "find: {a: rod.angle}\nmarking: {|", {"a", "all"}, {"m"}),
        (BASE + "find: {a: rod.angle}\nmarking: {a: {|", {"points", "tolerance"}, {"a"}),
        (BASE + "vary: {|", {"m", "R", "where"}, {"rod"}),
        ("given:\n  m: 2 |", {"kg", "N", "rad/s"}, {"unknown"}),
        ("given:\n  m: 2k|", {"kg"}, {"unknown"}),
        ("given:\n  R: 2 m\n  q: |", {"R", "unknown", "kg"}, {"q"}),
        (SPACE + "find: {a: top.|", {"tilt", "precession", "tip"}, {"tension"}),
        (SPACE + "connections: {|x: {}}", set(), {"string"}),
        (SPACE + "  b: {|", {"ball", "clamp", "hinge"}, set()),
        (BASE + "find: {a: nobody.|", set(), {"angle", "block"}),
        ("# a comment |", set(), {"given"}),
        ("text: >\n  a text |", set(), {"given"}),
    ],
)
def test_what_is_offered(marked: str, there: set[str], not_there: set[str]) -> None:
    found = labels(marked)
    assert there - found == set() and not_there & found == set()


@pytest.mark.parametrize(("section", "kind"), [(section, kind) for section, (kind, _) in TABLES.items()])
def test_whole_elements_are_written_as_they_are_read(section: str, kind: str) -> None:
    """The names in them are examples, so that faults speak of names alone."""
    for item in offered(f"{section}:\n  it: |"):
        text = f"{section}:\n  it: {item.plain}\nfind: {{x: 1 + 1}}\n"
        try:
            read_text(text)
        except SceneError as error:
            kinds = {fault.kind for fault in error.faults}
            assert kinds <= {"unknown", "kind", "missing", "point", "ambiguous"}, (item.word, str(error))


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape.word)
def test_the_keys_of_a_shape_are_offered(shape: type) -> None:
    own = {word for word, _ in keys_of(shape)}  # type: ignore[arg-type]
    assert own <= labels(f"bodies:\n  it: {{shape: {shape.word}, |")  # type: ignore[attr-defined]


def test_what_is_proposed_of_a_body_can_be_asked() -> None:
    scene = BASE.replace("  cord: {string: [rod.end, block]}\n", "")
    for item in offered(scene + "find: {a: rod.|"):
        asked = f"rod.{item.word}" + ("" if item.word in QUANTITIES else ".velocity")
        if item.word == "at(x)":
            continue
        try:
            read_text(scene + f"find: {{a: {asked}}}\n")
        except SceneError as error:
            assert not {fault.kind for fault in error.faults} & {"quantity", "path", "point"}, str(error)


def test_what_replaces_what() -> None:
    text = "bodies:\n  a: {shape: rod, len"
    assert offers_at(SceneText(text), 1, 21)[1] == 3
    assert offers_at(SceneText(BASE + "find: {a: rod.end.vel"), 11, 21)[1] == 3
    assert offers_at(SceneText(BASE + "  l: {at r"), 11, 10)[1] == 4
    keep = {item.word: item.insert for item in offered("gi|ven: {m: 2 kg}")}
    assert keep["given"] == "given", "its colon is there already"


@pytest.mark.parametrize(
    "file", ["rolling/bowling-ball", "hinged/clock-pendulum", "space/leaning-top", "pulleys/three-pulleys"]
)
def test_it_is_there_before_the_next_key(file: str) -> None:
    text = (PROBLEMS / f"{file}.yaml").read_text(encoding="utf-8")
    text = text[: text.index("find:")] + "find:\n  x: "
    took = []
    for _ in range(3):
        start = time.perf_counter()
        assert offers_at(SceneText(text), text.count("\n"), 5)[0]
        took.append(time.perf_counter() - start)
    assert min(took) < 0.05, "seconds, with all that is read for it"
