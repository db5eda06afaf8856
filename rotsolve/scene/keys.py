"""key: declares one YAML key of an element beside the field that holds it; reader, schema, help and docs all read it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import MISSING, dataclass, field, fields
from typing import Any

from rotsolve.algebra.formula import Formula


@dataclass(frozen=True, slots=True)
class Key:
    """What a YAML key takes: its kind, its meaning in words, and the limits of its value.

    `later` marks a key whose physics is not there yet: it is read and validated, then refused by name.
    `letter` is the textbook letter of a number written in place; `limits` is positive, nonnegative, fraction, acute or empty;
    `refers` are the kinds of things that a name may name; `varies` allows a formula of `time` and of paths of bodies.
    """

    kind: str
    help: str
    dimension: str | None = None
    choices: tuple[str, ...] = ()
    count: tuple[int, int] | None = None
    required: bool = False
    example: str = ""
    later: bool = False
    letter: str = ""
    limits: str = ""
    refers: tuple[str, ...] = ()
    varies: bool = False


def key(kind: str, help: str, *, default: Any = MISSING, **limits: Any) -> Any:
    """A dataclass field with its YAML key described in the metadata; a field without a default is optional and None."""
    declared = Key(kind, help, **limits)
    return field(default=None if default is MISSING else default, metadata={"key": declared})


def keys_of(element: Any) -> Iterator[tuple[str, Key]]:
    """The YAML keys of an element class with their declarations; a trailing underscore keeps a key off Python's keywords."""
    for entry in fields(element):
        if "key" in entry.metadata:
            yield entry.name.rstrip("_"), entry.metadata["key"]


def varying(element: Any) -> Iterator[Formula]:
    """The values of an element under keys that may vary."""
    for word, declared in keys_of(element):
        value = getattr(element, word, None) if declared.varies else None
        if isinstance(value, Formula):
            yield value
