"""Every kind of bad scene, with its whole message. The cases stand in faults.txt: a change of one good scene, and the text."""

import ast
import re
from pathlib import Path
from typing import Any

import pytest

from rotsolve.algebra.formula import ZERO
from rotsolve.algebra.units.dimension import BY_NAME
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.core.faults import Fault, SceneError, Span, render
from rotsolve.scene.read import read_file, read_text

SCENE = """title: T
given: {m: 2 kg, M: 5 kg, R: 0.2 m, mu: 0.3}
surfaces: {floor: level}
bodies:
  block: {mass: m}
  disc: {shape: disc, mass: M, radius: R}
  rod: {shape: rod, mass: M, length: 1.5*R}
connections:
  axle: {axle: disc}
  base: {contact: [block, floor], friction: mu}
  pin: {hinge: rod.start}
  cord: {string: [disc, block]}
states: {start: at rest, end: {rod.angle: 20 deg}}
find: {a: block.acceleration at start}
"""
TABLE = Path(__file__).parent / "faults.txt"
CASES = [
    (ast.literal_eval(old), ast.literal_eval(new), message)
    for old, new, message in re.findall(
        r"^===== (.+) => (.+)\n((?:(?!=====).*\n?)*)", TABLE.read_text(encoding="utf-8"), re.MULTILINE
    )
]


def fault_text(scene: str) -> str:
    with pytest.raises(SceneError) as caught:
        read_text(scene, "s.yaml")
    return str(caught.value)


def test_the_scene_itself_is_good() -> None:
    assert len(CASES) > 150
    read_text(SCENE)


@pytest.mark.parametrize(
    ("old", "new", "message"), CASES, ids=[f"{new[:40]!r}-{number}" for number, (_, new, _) in enumerate(CASES)]
)
def test_message(old: str, new: str, message: str, expected: Any) -> None:
    assert old in SCENE
    head = f"===== {old!r} => {new!r}\n"
    expected.case(TABLE, (head, head), (message, fault_text(SCENE.replace(old, new, 1))))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "error: the file is empty\n  --> FILE\nhelp: a scene needs at least `bodies` and `find`"),
        (b"# nothing\n", "error: the file is empty\n  --> FILE\nhelp: a scene needs at least `bodies` and `find`"),
        (b"a\0b", "error: this is no text file: it holds a NUL byte\n  --> FILE\nhelp: save the file as UTF-8"),
        (
            b"a: 1\nb: \xff\n",
            "error: the byte FF is not UTF-8: in Latin-1 it is `ÿ`\n  --> FILE:2:4\n 2 | b: ÿ\n   |    ^\nhelp: save the file as UTF-8",
        ),
        (
            b"a: \x1b[31m\n",
            "error: a control character, U+001B\n  --> FILE:1:4\n 1 | a: �[31m\n   |    ^\nhelp: remove it: a scene is plain text",
        ),
        (
            b"x" * 1_000_001,
            "error: the file has 1000001 bytes, more than 1000000\n  --> FILE\nhelp: a scene is a page of text",
        ),
        (
            b"a",
            "error: a scene is a map\n  --> FILE:1:1\n 1 | a\n   | ^\nhelp: begin with `title:`, `given:`, `bodies:`, `find:`",
        ),
    ],
    ids=["empty", "comment", "NUL", "UTF-8", "control", "size", "word"],
)
def test_files(tmp_path: Path, content: bytes, message: str) -> None:
    path = tmp_path / "s.yaml"
    path.write_bytes(content)
    with pytest.raises(SceneError) as caught:
        read_file(path)
    assert str(caught.value).replace(str(path), "FILE") == message


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=r"error: can't read `none\.yaml`: No such file or directory"):
        read_file("none.yaml")
    with pytest.raises(SceneError, match="Is a directory"):
        read_file(tmp_path)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"q": "3 kg"}, "error: --set `q`: no such given\n  --> s.yaml\nhelp: givens: m, M, R, mu"),
        ({"m": "3 m"}, "error: --set m: `m` is a mass (kg) in the file, but this is a length (m)\n  --> s.yaml"),
        ({"m": "3 kgg"}, "error: --set: unknown unit `kgg`\n  --> s.yaml\nhelp: did you mean `kg`?"),
        ({"m": "Q"}, "error: --set: unknown letter `Q`\n  --> s.yaml\nhelp: givens: m, M, R, mu, unknown, number"),
    ],
)
def test_settings(settings: dict[str, str], message: str) -> None:
    with pytest.raises(SceneError) as caught:
        read_text(SCENE, "s.yaml", settings)
    assert str(caught.value) == message


def test_long_lines_are_clipped_around_the_caret() -> None:
    line = "x" * 300 + "puley" + "y" * 300
    shown = render(Fault("unknown", Span(1, 301, 5)), [line], "s.yaml").splitlines()
    assert len(shown[2]) < 120
    column = shown[3].index("^^^^^")
    assert shown[2][column : column + 5] == "puley"
    assert shown[2].startswith(" 1 | …") and shown[2].endswith("…")


def test_one_fault_per_place() -> None:
    error = SceneError([Fault("b", Span(2, 1)), Fault("a", Span(1, 1)), Fault("c", Span(1, 1))])
    assert [fault.message for fault in error.faults] == ["a", "b"]


def test_every_kind_of_quantity_written_as_a_unit_is_told_one_that_can_be_read() -> None:
    for word in BY_NAME:
        if word != "number":
            shown = fault_text(SCENE.replace("mu: 0.3", f"mu: {word.replace(' ', '_')}"))
            unit = re.search(r"write a unit, `mu: ([^`]+)`", shown)
            assert unit is not None and BY_NAME[word].dimension.matches(parse_unit(unit[1]).dimension), word


@pytest.mark.parametrize("nothing", ["0 m", "0*m", "0", "-0 m"])
def test_nothing_can_be_read_one_way_where_a_letter_is_a_unit_too(nothing: str) -> None:
    problem = read_text(SCENE.replace("rod: {", f"rod: {{points: {{P: [{nothing}, R]}}, "), "s.yaml")
    body = next(body for body in problem.bodies if body.name == "rod")
    assert dict(body.points)["P"][0] == ZERO


def test_what_can_only_be_a_length_is_one_beside_a_mass_of_that_name() -> None:
    """Where a length is wanted, `2 m` is no multiple of a mass `m`."""
    (disc,) = [body for body in read_text(SCENE.replace("radius: R}", "radius: 2 m}")).bodies if body.name == "disc"]
    assert disc.shape is not None
    assert "m" not in (disc.shape.outer or ZERO).symbols()
