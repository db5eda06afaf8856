"""What everything that is declared in a test must do: be described, stand in the schema, and be accepted by it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import jsonschema
import pytest
import yaml

from rotsolve.scene.reference import describe_word, generate
from rotsolve.scene.schema import json_schema

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "language.md").read_text(encoding="utf-8")


@pytest.fixture
def in_language() -> Callable[[str, str, str], None]:
    """Holds that a word is described, that the page of the language would have to tell it, and that a scene with it is valid."""

    def check(word: str, about: str, scene: str) -> None:
        assert about in describe_word(word)
        assert about in generate() and about not in PAGE
        jsonschema.Draft202012Validator(json_schema()).validate(yaml.load(scene, yaml.BaseLoader))

    return check
