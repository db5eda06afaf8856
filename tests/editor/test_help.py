"""Help, places and fixes: what is told of a word, where a name is declared, and that each fix removes its fault."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from rotsolve.editor.fixes import fixes
from rotsolve.editor.help import help_at
from rotsolve.editor.places import declared_at, symbols
from rotsolve.editor.scene_text import SceneText

SCENE = """given: {m: 2 kg, R: 20 cm, L: 2*R, n: 10 rev/min, F: 3 lbf, q: unknown, z: kg, a0: L*R}
surfaces: {floor: level}
bodies:
  block: {mass: m}
  rod: {shape: rod, mass: 2 kg, length: L}
  box:
    shape: cuboid
    sides: [1 m, 2 m, 3 m]
connections:
  cord: {string: [rod.end, block]}
  base: {contact: [block, floor], friction: 0.3}
states:
  start: at rest
  end: {rod.angle: 30 deg, base: slips}
find:
  a: lost rod.kinetic_energy from start to end
  b: size of rod.end.velocity at end in km/h
"""


def told(marked: str, before: str = SCENE) -> str:
    """What is told at the mark `|` within a line of the scene."""
    start, _, rest = marked.partition("|")
    place = before.index(start + rest) + len(start)
    found = help_at(SceneText(before), before.count("\n", 0, place), place - before.rfind("\n", 0, place) - 1)
    return found[0] if found else ""


@pytest.mark.parametrize(
    ("marked", "text"),
    [
        ("{|m: 2 kg", "`m` = 2 kg, a mass (kg)"),
        ("mass: |m}", "`m` = 2 kg, a mass (kg)"),
        ("|R: 20 cm", "`R` = 20 cm = 0.2 m, a length (m)"),
        ("|L: 2*R", "`L` = 2 R = 0.4 m, a length (m)"),
        ("|n: 10", "`n` = 10 rev/min = 1.04720 rad/s, an angular velocity (rad/s)"),
        ("|F: 3", "`F` = 3 lbf = 13.3447 N, a force (N)"),
        ("|q: un", "`q` is asked for"),
        ("|z: kg", "`z`, a mass (kg), without a number"),
        ("|a0: L", "`a0` = L R = 0.08 m², an area (m²)"),
        ("3 l|bf", "`lbf`: a unit of force (N); 1 lbf = 4.44822 N"),
        ("30 d|eg", "`deg`: a unit of angle (rad); 1 deg = 0.0174533 rad"),
        ("gi|ven", "`given`: letters with values"),
        ("len|gth: L", "`length`: length (length, positive)"),
        ("si|des: [1", "`sides`: width, height and depth (length, positive, required)"),
        ("shape: cub|oid", "`cuboid` (shape): uniform box"),
        ("{str|ing: [", "`string` (connection): a string by what it touches"),
        ("fric|tion: 0.3", "`friction`: "),
        ("floor: le|vel", "`level` (surface): a level surface"),
        ("  co|rd: {", "`cord`, a connection: `string` (connection)"),
        ("  ro|d: {", "`rod`, a body: rod, thin uniform rod"),
        ("[rod.e|nd", "a point of `rod`"),
        ("rod.an|gle: 30", "`angle` (quantity): from the rightward horizontal"),
        ("kinetic_en|ergy", "`kinetic_energy` (quantity): of a body, or of the whole scene"),
        ("lo|st rod", "`lost`: stands before an expression"),
        ("fr|om start to", "`from`: begins a clause of `find`"),
        ("from st|art to", "`start`, a state"),
    ],
)
def test_what_is_told(marked: str, text: str) -> None:
    assert told(marked).startswith(text)


def test_nothing_is_told_of_nothing() -> None:
    assert help_at(SceneText(SCENE), 3, 0) is None
    assert help_at(SceneText(""), 0, 0) is None
    assert help_at(SceneText(SCENE), 999, 3) is None


def test_a_letter_is_told_in_a_text_that_is_broken() -> None:
    broken = "given: {m: 2 kg}\nbodies:\n  a: {mass: m, shape: ["
    assert told("mass: |m", broken).startswith("`m` = 2 kg, a mass (kg)")


def test_a_name_leads_to_where_it_is_declared() -> None:
    line = SCENE.split("\n")[15]
    found = declared_at(SceneText(SCENE), 15, line.index("rod."))
    assert found is not None and (found.line, found.column) == (5, 3)
    assert declared_at(SceneText(SCENE), 15, line.index("lost")) is None


def test_the_outline_has_all_names() -> None:
    found = {symbol.name: [inner.name for inner in symbol.inner] for symbol in symbols(SceneText(SCENE))}
    assert found["bodies"] == ["block", "rod", "box"] and found["find"] == ["a", "b"]
    box = next(inner for symbol in symbols(SceneText(SCENE)) for inner in symbol.inner if inner.name == "box")
    assert (box.span.line, box.last) == (6, 8)


def bad_scenes() -> list[str]:
    """The bad scenes of the table of messages."""
    here = Path(__file__).resolve().parents[1] / "scene"
    scene = re.search(r'SCENE = """(.*?)"""', (here / "test_scene_faults.py").read_text(encoding="utf-8"), re.DOTALL)
    assert scene is not None
    pairs = re.findall(r"^===== (.+) => (.+)$", (here / "faults.txt").read_text(encoding="utf-8"), re.MULTILINE)
    return [scene[1].replace(ast.literal_eval(old), ast.literal_eval(new), 1) for old, new in pairs]


def test_each_fix_removes_its_fault() -> None:
    count = 0
    for text in bad_scenes():
        for fix in fixes(SceneText(text).faults):
            lines = text.split("\n")
            line, start = lines[fix.span.line - 1], fix.span.column - 1
            lines[fix.span.line - 1] = line[:start] + fix.word + line[start + fix.span.length :]
            left = SceneText("\n".join(lines)).faults
            assert not [item for item in left if (item.span, item.kind) == (fix.span, fix.fault.kind)], (text, fix)
            assert fix.fault.message not in [item.message for item in left]
            count += 1
    assert count > 30


def test_all_that_the_reader_says_did_you_mean_of_is_a_fix() -> None:
    for text in bad_scenes():
        faults = SceneText(text).faults
        meant = [fault for fault in faults if fault.help.startswith("did you mean") and fault.span is not None]
        assert [fix.fault for fix in fixes(faults)] == meant


@pytest.mark.parametrize(
    "text", ["", "# nothing yet\n", "services:\n  web: {image: nginx}\n", "- a\n- b\n", "a text", "a: [1\nb: {"]
)
def test_other_yaml_has_no_faults(text: str) -> None:
    assert SceneText(text).faults == ()


@pytest.mark.parametrize(
    "text",
    [
        "find: {}\n",
        "bodies:\n  a: {shape: [\n",
        "title: [\x00",
        "given: {m: 2 kg\n",
        "find: {a: 1}\n" + "# \n" * 400_000,
    ],
)
def test_a_scene_has_its_faults(text: str) -> None:
    assert SceneText(text).faults
