"""The schema of sheet files: what the reader of sheets takes fits, and what it refuses does not."""

from __future__ import annotations

import re
from contextlib import nullcontext
from pathlib import Path

import jsonschema
import pytest
import yaml

from rotsolve.core.faults import SceneError
from rotsolve.keys.problem_set import read_problem_set
from rotsolve.language.sheet_keys import LISTED, SHEET
from rotsolve.scene.sheet_schema import EXAMPLE, sheet_schema

DOCS = Path(__file__).resolve().parents[2] / "docs"
SHEETS = [
    text
    for page in ("keys.md", "checking.md")
    for text in re.findall(r"^```yaml.*\n((?:.*\n)*?)```", (DOCS / page).read_text(encoding="utf-8"), re.MULTILINE)
    if text.startswith("sheet:")
]


def schema() -> jsonschema.Draft202012Validator:
    jsonschema.Draft202012Validator.check_schema(sheet_schema())
    return jsonschema.Draft202012Validator(sheet_schema())


def fits(text: str) -> bool:
    return bool(schema().is_valid(yaml.load(text, yaml.BaseLoader)))


def test_the_example_and_the_sheets_of_the_documents_fit() -> None:
    schema().validate(EXAMPLE)
    assert SHEETS and all(map(fits, SHEETS))


def test_it_has_every_key() -> None:
    found = sheet_schema()["properties"]
    assert [*found] == [*SHEET]
    assert [*found["problems"]["anyOf"][1]["items"]["anyOf"][1]["properties"]] == [*LISTED]


@pytest.mark.parametrize(
    ("text", "is_one"),
    [
        ("sheet: One\nproblems: [a.yaml]\n", True),
        ("sheet: One\nproblems: a.yaml\n", True),
        ("sheet: One\nproblems: [{problem: a.yaml, name: one, page: new, points: 3}]\nroom: none\n", True),
        ("problems: [a.yaml]\n", False),
        ("sheet: One\n", False),
        ("sheet: One\nproblems: []\n", False),
        ("sheet: One\nproblems: [{name: one}]\n", False),
        ("sheet: One\nproblems: [a.yaml]\npaper: a5\n", False),
        ("sheet: One\nproblems: [a.yaml]\ntitel: b\n", False),
        ("sheet: One\nproblems: [{problem: a.yaml, page: old}]\n", False),
    ],
)
def test_the_reader_and_the_schema_agree(tmp_path: Path, text: str, is_one: bool) -> None:
    (tmp_path / "a.yaml").write_text("title: One\n", encoding="utf-8")
    (tmp_path / "sheet.yaml").write_text(text, encoding="utf-8")
    assert fits(text) is is_one
    with nullcontext() if is_one else pytest.raises(SceneError):
        read_problem_set(tmp_path / "sheet.yaml")
