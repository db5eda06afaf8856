"""Elements own what is theirs: nobody above them tests what class an element has, or compares its word."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from rotsolve.elements.tables import ACTIONS, CONNECTIONS, EVENTS, SHAPES, SURFACES

PACKAGE = Path(__file__).resolve().parents[2] / "rotsolve"
BELOW = ("algebra", "core", "language", "elements")
ANEW = (
    "confirm",
)  # reads the elements a second time, by tables of their classes, so that it shares no mistake with their facts
ABOVE = [path for path in sorted(PACKAGE.rglob("*.py")) if path.relative_to(PACKAGE).parts[0] not in (*BELOW, *ANEW)]
BASES = {"Shape"}  # of which scene.bodies asks whether a field holds one at all
STATES = {
    word for item in CONNECTIONS for word in item.words
}  # what a state may say of a connection is no element's word
TABLES = (SHAPES, SURFACES, CONNECTIONS, ACTIONS, EVENTS)
WORDS = {item.word for table in TABLES for item in table} - STATES


def element_tests(path: Path) -> Iterator[str]:
    """The places of a file that ask which element something is."""
    tree = ast.parse(path.read_text(encoding="utf-8"), str(path))
    taken = {
        alias.asname or alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("rotsolve.elements")
        for alias in node.names
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and ast.unparse(node.func) in ("isinstance", "issubclass"):
            named = {item.id for item in ast.walk(node.args[1]) if isinstance(item, ast.Name)}
            yield from (f"line {node.lineno}: {name}" for name in sorted(named & taken - BASES))
        if isinstance(node, ast.Compare):
            sides = (node.left, *node.comparators)
            words = {item.value for side in sides for item in ast.walk(side) if isinstance(item, ast.Constant)}
            if any(isinstance(side, ast.Attribute) and side.attr == "word" for side in sides):
                yield from (f"line {node.lineno}: {word!r}" for word in sorted(words & WORDS))
        if isinstance(node, ast.MatchClass):
            yield from (f"line {node.lineno}: {name}" for name in {ast.unparse(node.cls)} & taken)


@pytest.mark.parametrize("path", ABOVE, ids=lambda path: ".".join(path.relative_to(PACKAGE).with_suffix("").parts))
def test_nobody_above_asks_which_element_it_is(path: Path) -> None:
    assert not list(element_tests(path)), "give the element a fact or a method, with a plain default in its base class"


def test_elements_look_down_only() -> None:
    """What an element sees of the scene is the `Moment` and the `Surroundings` of the language, for types too."""
    allowed = tuple(f"rotsolve.{room}" for room in BELOW)
    for path in sorted((PACKAGE / "elements").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("rotsolve."):
                assert (node.module or "").startswith(allowed), f"{path.name}:{node.lineno}: {node.module}"
