"""docs/language.md: its scenes can be read, its reference is that of the tables, and the JSON Schema accepts them."""

import re
from functools import cache
from pathlib import Path

import jsonschema
import pytest
import yaml

from rotsolve.core.faults import SceneError
from rotsolve.language.sheet_keys import LISTED, SHEET
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_text
from rotsolve.scene.reference import BEGIN, describe_word, generate, word_entries
from rotsolve.scene.schema import json_schema

ROOT = Path(__file__).parent.parent.parent
PAGE = ROOT / "docs" / "language.md"
DOC = PAGE.read_text(encoding="utf-8")
FINDING = (ROOT / "docs" / "finding.md").read_text(encoding="utf-8")
SCENES = re.findall(r"```yaml\n(.*?)```", DOC, re.DOTALL)
LATER = """title: Words that come later
given: {m: 2 kg, a: 1 m, v: 3 m/s}
bodies: {ball: {mass: m}, rod: {shape: rod, mass: m, length: a}}
connections: {pin: {hinge: rod.start}, cord: {string: [rod.end, ball], mass: m}}
states: {before: {ball.velocity: v, rod.angle: 0 deg}, after: {}}
events: {hit: {collides: [ball, rod.end], restitution: 0.2, from: before, to: after}}
find: {w: rod.angular_velocity at after}
"""


def test_the_page_has_scenes() -> None:
    assert len(SCENES) >= 10


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.splitlines()[0])
def test_every_scene_of_the_page_is_solved(scene: str) -> None:
    solution = solve(scene)
    told = [bool(item.formula or item.value or item.components or item.word) for item in solution.answers.values()]
    assert told and all(told)
    assert [check for check in solution.checks if check.holds is False] == []


def test_every_word_that_has_its_physics_stands_in_a_scene_of_the_page() -> None:
    """Save for the internal words behind `period of small swings` and `ratio of A to B in mode 1`."""
    scenes = "\n".join(SCENES)
    spoken = {word for word, text in word_entries() if "*(not solved yet)*" not in text.splitlines()[0]}
    spoken -= SHEET.keys() | LISTED.keys()  # those stand in a sheet of docs/keys.md
    missing = {word for word in spoken if not re.search(rf"(?<!\w){re.escape(word)}(?!\w)", scenes)}
    assert missing <= {"swing_period", "amplitude_ratio"}


def test_words_that_come_later_are_refused_by_name() -> None:
    with pytest.raises(SceneError) as caught:
        read_text(LATER)
    others = [fault for fault in caught.value.faults if fault.kind != "not yet"]
    assert [fault.message for fault in others] == []
    named = {fault.message.split("`")[1] for fault in caught.value.faults}
    assert named == {"mass"}


@cache
def validator() -> jsonschema.Draft202012Validator:
    return jsonschema.Draft202012Validator(json_schema())


@pytest.mark.parametrize("scene", [*SCENES, LATER], ids=lambda scene: scene.splitlines()[0])
def test_the_schema_accepts_every_scene(scene: str) -> None:
    validator().validate(yaml.load(scene, yaml.BaseLoader))


def test_the_schema_refuses_unknown_words() -> None:
    validator().check_schema(json_schema())
    cases: list[dict[str, object]] = [
        {"bodies": {}, "find": {}},
        {"bodies": {}, "find": {"a": "b"}, "titel": "x"},
        {"bodies": {"a": {"shape": "disk"}}, "find": {"a": "b"}},
        {"bodies": {"a": {"raduis": "R"}}, "find": {"a": "b"}},
        {"bodies": {}, "find": {"a": "b"}, "connections": {"c": {"axel": "a"}}},
    ]
    for wrong in cases:
        assert not validator().is_valid(wrong)


def test_the_reference_is_that_of_the_tables(regenerate: bool) -> None:
    if regenerate:
        PAGE.write_text(DOC[: DOC.index(BEGIN)] + generate(), encoding="utf-8")
        return
    assert DOC[DOC.index(BEGIN) :] == generate()


def test_the_finding_page_names_files_that_are_there() -> None:
    scenes, _, _ = FINDING.partition("What is well said and yet not solved")
    rows = [line.split("|")[-2] for line in scenes.splitlines() if line.startswith("|")][2:]
    named = [name.strip() for cell in rows for name in cell.split(",") if name.strip()]
    assert len(named) > 40
    bundled = {f"{file.parent.name}/{file.stem}" for file in (ROOT / "problems").glob("*/*.yaml")}
    assert [name for name in named if name not in bundled] == []


def test_every_word_can_be_described() -> None:
    for word, _ in word_entries():
        assert f"`{word}`" in describe_word(word)
    with pytest.raises(KeyError, match="did you mean `hinge`"):
        describe_word("hing")


def test_the_page_says_what_can_be_asked_in_space() -> None:
    from rotsolve.space.arrangement import NODAL
    from rotsolve.space.reader import SCALARS
    from rotsolve.space.vector_reader import OF_BODIES, OF_ELEMENTS

    told = re.search(r"in space can be asked: (.*?)\. `potential_energy`", DOC, re.DOTALL)
    assert told is not None
    assert set(re.findall(r"`(\w+)`", told[1])) == {*OF_BODIES, *OF_ELEMENTS, *SCALARS, *NODAL}
