"""Names: the words that a scene gives to its bodies, points, connections, states, letters and choices."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.core.writing import and_joined, spoken

if TYPE_CHECKING:
    from rotsolve.language.problem import Problem

NAMING = frozenset(
    ("name", "owner", "point", "points", "argument", "state", "label", "word", "at", "on", "group")
)  # fields


def names_of_scene(problem: Problem) -> frozenset[str]:
    """All names of a scene, and how they are spoken."""
    found = frozenset(_names("", problem)) | frozenset(names_at_once(problem))
    return found | frozenset(map(spoken, found))


def names_at_once(problem: Problem) -> Iterator[str]:
    """What several events at once are called."""
    for pair in dict.fromkeys((event.from_, event.to) for event in problem.events):
        names = [event.name for event in problem.events if (event.from_, event.to) == pair]
        yield from (and_joined([spoken(name) for name in names]),) if len(names) > 1 else ()


def _names(field: str, value: object) -> Iterator[str]:
    """The names in a value, which stands in a field of that name."""
    match value:
        case str():
            yield from (value,) if field in NAMING else ()
        case Struct():
            for own in value.__struct_fields__:
                yield from _names(own, getattr(value, own))
        case Mapping():
            for key, one in value.items():
                yield from (key,) if isinstance(key, str) else ()
                yield from _names(field, one)
        case tuple() | list() | frozenset():
            for one in value:
                yield from _names(field, one)
