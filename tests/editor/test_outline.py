"""The outline: of YAML the tree of the parser; of what is half written the place at which it ends, and never a failure."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rotsolve.editor.outline import outlined, place_after
from rotsolve.editor.scene_text import SceneText
from rotsolve.scene.tree import List, Map, Node, Text, compose

PROBLEMS = sorted((Path(__file__).resolve().parents[2] / "problems").glob("*/*.yaml"))
TEXTS = [path.read_text(encoding="utf-8") for path in PROBLEMS[::20]]
ODD = """# a comment
"title": 'it''s: a "text"'   # and one behind it
text: >
  of several lines: {with: brackets
  and: colons}

given: {m: 2 kg, "R": '20 cm',
  L: 2*R,  # goes on

  q: unknown}
bodies:
  one:
    shape: disc
    points:
      P: [1 m, [2 m]]
  two: {parts: {a: {mass: m}, b: {mass: m}}}
unknown:
- m
-   R
find:
    a: one.velocity at
      start
    b: "one.angle" # c
"""


def differences(parsed: Node, outlined: Node, way: str = "") -> list[str]:
    """Where two trees differ; texts of several lines have no columns to compare."""
    if isinstance(parsed, Text) and not parsed.exact:
        return []
    if isinstance(parsed, Text) or type(parsed) is not type(outlined):
        return [] if parsed == outlined else [f"{way}: {parsed} is {outlined}"]
    if isinstance(parsed, List):
        assert isinstance(outlined, List)
        pairs = [
            (str(index), one, other)
            for index, (one, other) in enumerate(zip(parsed.items, outlined.items, strict=True))
        ]
    else:
        assert isinstance(parsed, Map) and isinstance(outlined, Map)
        entries = list(zip(parsed.entries, outlined.entries, strict=True))
        pairs = [(key.value, value, other) for (key, value), (_, other) in entries]
        pairs += [("a key", key, other) for (key, _), (other, _) in entries]
    return [told for step, one, other in pairs for told in differences(one, other, f"{way}/{step}")]


def test_of_yaml_it_is_what_the_parser_reads() -> None:
    for text in (ODD, *(path.read_text(encoding="utf-8") for path in PROBLEMS)):
        assert differences(compose(text, "")[0], outlined(text)) == []


@pytest.mark.parametrize(
    ("text", "path", "role", "typed"),
    [
        ("", (), "key", ""),
        ("bo", (), "key", "bo"),
        ("title: a te", ("title",), "value", "a te"),
        ("title: a # te", ("title",), "", "a # te"),
        ("bodies:\n  ", ("bodies",), "either", ""),
        ("bodies:\n  blo", ("bodies",), "either", "blo"),
        ("bodies:\n  a: {shape: disc}\n  ", ("bodies",), "key", ""),
        ("bodies:\n  a: {shape: rod, ", ("bodies", "a"), "key", ""),
        ("bodies:\n  a: {shape: ro", ("bodies", "a", "shape"), "value", "ro"),
        ("bodies:\n  a: {shape: rod} ", ("bodies", "a", "shape"), "", ""),
        ("bodies:\n  a:\n    shape: rod\n    le", ("bodies", "a"), "key", "le"),
        ("bodies: {a: {mass: 1 kg}, b: {", ("bodies", "b"), "key", ""),
        ("bodies:\n  a: {shape: rod,\nfind:\n  x: ", ("find", "x"), "value", ""),
        ("bodies:\n  a: {shape: rod,\n    mass: ", ("bodies", "a", "mass"), "value", ""),
        ("connections:\n  s: {string: [a, ", ("connections", "s", "string", 1), "value", ""),
        ("unknown:\n  - m\n  - ", ("unknown", 1), "value", ""),
        ("find:\n  a: block.", ("find", "a"), "value", "block."),
        ("find:\n  a: block.velocity at ", ("find", "a"), "value", "block.velocity at "),
        ("text: >\n  of several lines", ("text",), "", ""),
        ("states: {end: {rod.angle: 30 d", ("states", "end", "rod.angle"), "value", "30 d"),
        ('find: {a: "b.', ("find", "a"), "value", '"b.'),
    ],
)
def test_where_a_text_ends(text: str, path: tuple[str | int, ...], role: str, typed: str) -> None:
    place = place_after(text)
    assert place.role == role
    if role:
        assert (place.path, place.typed) == (path, typed)


def test_every_beginning_of_a_scene_has_an_end_and_is_read() -> None:
    for text in TEXTS:
        for stop in range(0, len(text), 11):
            place = place_after(text[:stop])
            assert place.role in ("key", "value", "either", "")
            assert all(isinstance(step, (str, int)) for step in place.path)
        for stop in range(0, len(text), max(1, len(text) // 8)):
            assert SceneText(text[:stop]).scope is not None


@given(st.sampled_from(TEXTS), st.data())
def test_whatever_is_torn_out_or_put_in_it_reads_on(text: str, data: st.DataObject) -> None:
    start = data.draw(st.integers(0, len(text)))
    stop = data.draw(st.integers(start, min(len(text), start + 40)))
    put = data.draw(st.text(alphabet="ab:{}[],'\"\n -#|>&*%\t½𝛚", max_size=8))
    torn = text[:start] + put + text[stop:]
    assert isinstance(outlined(torn), (Text, List, Map))
    place_after(torn[: start + len(put)])
    assert SceneText(torn).scope is not None
