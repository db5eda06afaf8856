"""The schema: right for each shape and element; its examples are read; what the reader takes fits, and keys that it refuses do not."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml

from rotsolve.core.faults import SceneError
from rotsolve.elements.tables import SHAPES
from rotsolve.language.grammar import SECTIONS
from rotsolve.language.keys import keys_of
from rotsolve.scene.elements import TABLES
from rotsolve.scene.examples import as_data, example_body, example_element, example_value, within_a_line
from rotsolve.scene.read import read_text
from rotsolve.scene.reference import key_meaning
from rotsolve.scene.schema import definition_name, json_schema

HERE = Path(__file__).resolve().parent
PROBLEMS = sorted((HERE.parents[1] / "problems").glob("*/*.yaml"))
GIVENS = "given: {a: 3 m, b: 2 m, h: 1 m, R: 1 m, s: 20 cm}\n"
PARTICLES = (
    "disc",
    "block",
    "left",
    "right",
    "carpet",
    "man",
    "ball",
    "bead",
    "putty",
    "piston",
    "collar",
    "nut",
    "one",
    "two",
)
RODS = ("rod", "crank", "arm", "beam", "bar")
WHEELS = ("pulley", "motor", "small", "large", "table", "plate2", "wheel", "plate")
CAST = "".join(
    (
        *(f"  {name}: {{mass: 1 kg}}\n" for name in PARTICLES),
        *(f"  {name}: {{shape: rod, mass: 1 kg, length: 1 m}}\n" for name in RODS),
        *(f"  {name}: {{shape: disc, mass: 1 kg, radius: 1 m, points: {{corner1: [0, 1 m]}}}}\n" for name in WHEELS),
        "  drum: {mass: 1 kg, radius: 1 m, radii: {big: 2 m, small: 1 m}}\n",
        "  top: {shape: cone, mass: 1 kg, radius: 1 m, length: 1 m}\n",
        "  rope: {shape: rope, mass: 1 kg, length: 3 m}\n",
    )
)
HOST = {
    "surfaces": {"ramp": "{slope: 30 deg}", "floor": "level"},
    "connections": {"cord": "{string: [left, pulley, right]}", "base": "{contact: [block, floor], friction: 0.3}"},
    "actions": {"prop": "{force: 1 N, on: block, direction: right}"},
}


@cache
def schema() -> jsonschema.Draft202012Validator:
    jsonschema.Draft202012Validator.check_schema(json_schema())
    return jsonschema.Draft202012Validator(json_schema())


def host(section: str = "", entry: str = "", *, space: bool = False) -> str:
    """A scene that has all that the examples name, with one entry more."""
    sections: dict[str, dict[str, str]] = {name: {} if space else dict(entries) for name, entries in HOST.items()}
    sections["events"] = {}
    sections["states"] = {"start": "at rest", "end": "{time: 1 s}"}
    text = GIVENS + ("up: z\n" if space else "") + f"bodies:\n{CAST}"
    if section == "bodies":
        text += f"  example: {entry}\n"
    else:
        sections[section]["example"] = entry
    for name, entries in sections.items():
        text += f"{name}:\n" * bool(entries) + "".join(f"  {word}: {value}\n" for word, value in entries.items())
    return text + "find: {I: disc.mass}\n"


def data(text: str) -> Any:
    return yaml.load(text, yaml.BaseLoader)


def accept(text: str) -> None:
    read_text(text)
    schema().validate(data(text))


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape.word)
def test_the_example_of_a_shape_is_read(shape: Any) -> None:
    accept(host("bodies", example_body(shape)))
    assert json_schema()["$defs"][definition_name("body", shape.word)]["examples"] == [as_data(example_body(shape))]


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape.word)
def test_the_keys_of_a_shape_are_its_own(shape: Any) -> None:
    for role in ("body", "part"):
        found = json_schema()["$defs"][definition_name(role, shape.word)]["properties"]
        for word, key in keys_of(shape):
            assert found[word]["description"] == key_meaning(key)
            number = key.count and key.kind == "quantities"
            assert not number or (found[word]["minItems"], found[word]["maxItems"]) == key.count
        others = {word for other in SHAPES for word, _ in keys_of(other)} - {word for word, _ in keys_of(shape)}
        assert others & found.keys() <= {"radii"}, "a body of any shape may have named rims"


ELEMENTS = [(section, cls) for section, (_, table) in TABLES.items() for cls in table if not cls.later]


@pytest.mark.parametrize(("section", "cls"), ELEMENTS, ids=lambda item: getattr(item, "word", item))
def test_the_example_of_an_element_is_read(section: str, cls: Any) -> None:
    accept(host(section, example_element(cls), space=not cls.planar))


@pytest.mark.parametrize(("section", "cls"), ELEMENTS, ids=lambda item: getattr(item, "word", item))
def test_the_example_of_each_key_is_read(section: str, cls: Any) -> None:
    """Beside what the element must have; that several of its keys exclude each other is no matter of one."""
    whole = as_data(example_element(cls))
    for word, key in keys_of(cls):
        if not isinstance(whole, dict):
            continue
        space = not cls.planar or key.space
        assert example_value(key), f"{cls.word}: {word} has no example"
        text = host(section, within_a_line({**whole, word: as_data(example_value(key))}), space=space)
        schema().validate(data(text))
        assert not [fault for fault in faults_of(text) if fault.kind in READ], text


READ = ("key", "choice", "dimension", "unit", "unknown", "count", "yaml", "limits")


def faults_of(text: str) -> tuple[Any, ...]:
    try:
        read_text(text)
    except SceneError as error:
        return error.faults
    return ()


def examples(node: Any, path: str = "") -> Iterator[tuple[str, Any, dict[str, Any]]]:
    """All examples of the schema, each with the schema that it is of."""
    if isinstance(node, dict):
        yield from (
            (path, example, node)
            for example in node.get("examples", ())
            if "type" in node or "$ref" in node or "anyOf" in node or "enum" in node
        )
        for word, item in node.items():
            yield from examples(item, f"{path}/{word}") if word != "examples" else ()
    elif isinstance(node, list):
        for number, item in enumerate(node):
            yield from examples(item, f"{path}/{number}")


def test_every_example_fits_its_own_schema() -> None:
    whole = json_schema()
    found = list(examples(whole))
    assert len(found) > 300
    for path, example, node in found:
        own = jsonschema.Draft202012Validator({**node, "$defs": whole["$defs"]})
        assert not list(own.iter_errors(example)), (path, example)


def test_the_example_of_a_scene_is_read_and_every_section_has_help() -> None:
    whole = json_schema()
    accept(yaml.safe_dump(whole["examples"][0], sort_keys=False))
    assert {word: item["description"] for word, item in whole["properties"].items()} == {
        word: key_meaning(key) for word, key in SECTIONS.items()
    }


@pytest.mark.sampled(5)
@pytest.mark.parametrize("file", PROBLEMS, ids=lambda file: file.stem)
def test_bundled_scenes_fit(file: Path) -> None:
    schema().validate(data(file.read_text(encoding="utf-8")))


def broken() -> Iterator[tuple[str, str]]:
    """The bad scenes of the table of messages, which begin with what is wrong with them."""
    scene = re.search(r'SCENE = """(.*?)"""', (HERE / "test_scene_faults.py").read_text(encoding="utf-8"), re.DOTALL)
    assert scene is not None
    table = (HERE / "faults.txt").read_text(encoding="utf-8")
    for old, new in re.findall(r"^===== (.+) => (.+)$", table, re.MULTILINE):
        yield scene[1].replace(ast.literal_eval(old), ast.literal_eval(new), 1), ast.literal_eval(new)


REFUSED = ("key", "choice", "count")  # kinds of faults that the keys and values alone tell
BY_THE_READER = (  # those for which a validator would have to know the names of the scene, or the words of a phrase
    "base: sliding",
    "cord: rolls",
    "base stick",
    "direction: rigt",
    "answers: {b: 3}",
    "marking: {b: 2}",
    "which of: {one: block.speed, two: rod.end.speed}}",
    "two: block.speed > 3 m/s}, is: largest}",
    "rod.inertia by magic",
    "vary: {m: [1 kg, 1000 g]}",
)


def test_what_the_reader_refuses_for_its_keys_does_not_fit() -> None:
    told = [(new, data(text)) for text, new in broken() if {fault.kind for fault in faults_of(text)} & {*REFUSED}]
    assert len(told) > 25
    fitting = [new for new, scene in told if schema().is_valid(scene)]
    assert [new for new in fitting if not any(known in new for known in BY_THE_READER)] == []
    assert len(fitting) == len(BY_THE_READER)
