"""Scene: the text of a scene as nested dicts and lists of strings, in which values and names can be changed."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import yaml

Scene = dict[str, Any]
ASIDE = ("text", "source", "answers", "marking", "vary")  # what no answer depends on
NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*")


def read(text: str) -> Scene:
    """The scene that a YAML text writes, every scalar as the text that stands there."""
    loaded = yaml.load(text, yaml.BaseLoader)
    return {key: value for key, value in loaded.items() if key not in ASIDE}


def written(scene: Scene) -> str:
    """The YAML text of a scene, one line for each body, connection and question."""
    text: str = yaml.dump(scene, default_flow_style=None, sort_keys=False, allow_unicode=True, width=10**6)
    return text


def changed(node: Any, change: Callable[[str], str]) -> Any:
    """The same tree with each of its values changed; keys stay."""
    if isinstance(node, dict):
        return {key: changed(value, change) for key, value in node.items()}
    if isinstance(node, list):
        return [changed(value, change) for value in node]
    return change(node)


def named(node: Any, names: dict[str, str]) -> Any:
    """The same tree with words changed wherever they stand as a whole word, in keys too."""

    def change(text: str) -> str:
        return re.sub(r"[A-Za-z_]\w*", lambda word: names.get(word[0], word[0]), text)

    if isinstance(node, dict):
        return {change(key): named(value, names) for key, value in node.items()}
    if isinstance(node, list):
        return [named(value, names) for value in node]
    return change(node)
