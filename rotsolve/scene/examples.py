"""Examples: a value for each key, and for each shape and element a map that can be read, made from the same tables as the reference.

They are YAML within one line, `{shape: rod, mass: 3 kg, length: 20 cm}`: what the schema shows, what editors insert, and what tests read.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import count
from typing import Any

from rotsolve.algebra.units.dimension import BY_NAME
from rotsolve.language.grammar import BODY
from rotsolve.language.keys import Element, Key, keys_of
from rotsolve.language.shape import Shape
from rotsolve.scene.tree import List, Node, Text, compose

BY_KIND = {  # of keys without an example of their own
    "flag": "true",
    "true": "true",
    "friction": "0.3",
    "radii": "{inner: 10 cm, outer: 20 cm}",
    "axis": "z",
    "axis in space": "z",
    "place": "[0, 1 m]",
    "deduction": "25 %",
}
SIDES = ("20 cm", "30 cm", "40 cm")  # those of a triangle too


def example_value(key: Key) -> str:
    """A value of a key as it is written; '' of what no single value shows, such as a whole section."""
    if key.example or key.kind in BY_KIND:
        return key.example or BY_KIND[key.kind]
    if key.kind == "quantities":
        return f"[{', '.join(SIDES[: (key.count or (1, 1))[0]])}]"
    if key.choices:
        return key.choices[0]
    return BY_NAME[key.dimension].example if key.dimension in BY_NAME else ""


def example_element(cls: type[Element]) -> str:
    """An element with all that it must have, its own word first: `{impulse: 2 N s, from: start, to: end, on: rod.end}`."""
    required = {word: key for word, key in keys_of(cls) if key.required}
    word: str = getattr(cls, "word", "")
    if not required:
        return word
    return in_braces((name, example_value(required[name])) for name in sorted(required, key=lambda name: name != word))


def example_body(shape: type[Shape]) -> str:
    """A body of a shape with its mass and sizes; of those that do the same, the first."""
    keys = dict(keys_of(shape))
    sizes = {
        word: key for word, key in keys.items() if key.required or key.kind == "quantity" or word in shape.closing[:1]
    }
    told = {} if shape.pointlike else sizes
    parts = [("shape", shape.word), ("mass", example_value(BODY["mass"]))]
    return in_braces([*parts, *((word, example_value(key)) for word, key in told.items())])


def in_braces(entries: Iterable[tuple[str, str]]) -> str:
    return f"{{{', '.join(f'{word}: {value}' for word, value in entries)}}}"


def as_data(text: str) -> Any:
    """The value of an example as JSON has it: texts, lists and maps."""
    return plain_data(compose(text, "")[0])


def plain_data(node: Node) -> Any:
    if isinstance(node, Text):
        return node.value
    if isinstance(node, List):
        return [plain_data(item) for item in node.items]
    return {key.value: plain_data(item) for key, item in node.entries}


def with_stops(data: Any, kept: str = "", numbers: Iterator[int] | None = None) -> Any:
    """An example as a snippet: the tab key goes from value to value but the `kept` one, `{shape: rod, mass: ${1:3 kg}}`."""
    numbers = numbers or count(1)
    if isinstance(data, dict):
        return {word: with_stops(value, kept, numbers) for word, value in data.items()}
    if isinstance(data, list):
        return [with_stops(item, kept, numbers) for item in data]
    return data if data == kept else f"${{{next(numbers)}:{data}}}"


def within_a_line(data: Any) -> str:
    """Texts, lists and maps as YAML writes them within a line."""
    if isinstance(data, dict):
        return in_braces((word, within_a_line(value)) for word, value in data.items())
    return f"[{', '.join(map(within_a_line, data))}]" if isinstance(data, list) else str(data)
