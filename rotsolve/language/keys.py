"""key: declares one YAML key of an element beside the field that holds it; reader, schema, help and docs all read it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar, dataclass_transform

from msgspec import Struct, StructMeta

from rotsolve.algebra.formula import ONE, PI, Formula
from rotsolve.language.noted import Noted

HIGHEST = {"fraction": ONE, "acute": PI / 2}  # by what a key says of its values; the lowest one of all is 0


class Key(Struct, frozen=True):
    """What a YAML key takes: its kind, its meaning in words, and the limits of its value.

    `later` marks a key whose physics is not there yet: it is read and validated, then refused by name; `space`
    one that only scenes in space have, `plane` one that they do not have, and `instead` tells how they say the same.
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
    space: bool = False
    plane: bool = False
    instead: str = ""
    letter: str = ""
    limits: str = ""
    refers: tuple[str, ...] = ()
    varies: bool = False


class Declaration(Struct, frozen=True):
    """What stands behind a field of an element: its YAML key and its default."""

    key: Key
    default: Any = None


def key(kind: str, help: str, *, default: Any = None, **limits: Any) -> Any:
    """A field of an element with its YAML key; one without a default is optional and None."""
    return Declaration(Key(kind, help, **limits), default)


def amount(help: str, dimension: str, letter: str, limits: str = "", *, default: Any = None, **more: Any) -> Any:
    """A field with a number or formula of a dimension, for which a textbook has a letter."""
    return key("quantity", help, default=default, dimension=dimension, letter=letter, limits=limits, **more)


@dataclass_transform(field_specifiers=(key, amount))
class Declared(StructMeta):
    """Makes element classes: keeps the keys that their fields declare, and leaves the fields their plain defaults.

    What fields hold points, and which may vary, is told once a class: a scene of a thousand elements asks it ten thousand times.
    """

    def __new__(cls, name: str, bases: tuple[type, ...], body: dict[str, Any], **options: Any) -> Declared:
        found = {word: value for word, value in body.items() if isinstance(value, Declaration)}
        inherited = [known for base in reversed(bases) for known in getattr(base, "declared", {}).items()]
        body["declared"] = dict(inherited) | {word: value.key for word, value in found.items()}
        body.update((word, value.default) for word, value in found.items())
        keys: dict[str, Key] = body["declared"]
        body.setdefault("pointed", tuple(field for field, declared in keys.items() if declared.kind == "points"))
        body["variable"] = tuple(field for field, declared in keys.items() if declared.varies)
        return super().__new__(cls, name, bases, body, **options)


class Element(Noted, metaclass=Declared, frozen=True):
    """Base of all that a scene is built of: a record whose fields declare YAML keys."""

    word: ClassVar[str] = ""  # by which a scene calls it
    declared: ClassVar[dict[str, Key]]  # by the name of the field
    pointed: ClassVar[tuple[str, ...]]  # the fields that hold several points
    variable: ClassVar[tuple[str, ...]]  # the fields whose values may vary
    at_points: ClassVar[bool] = False  # whether it acts at points of bodies, also of those that are named alone


def keys_of(element: type[Element] | Element) -> Iterator[tuple[str, Key]]:
    """The YAML keys of an element class with their declarations; a trailing underscore keeps a key off Python's keywords."""
    for name, declared in element.declared.items():
        yield name.rstrip("_"), declared


def varying_values(element: Any) -> list[Formula]:
    """The values of an element under keys that may vary."""
    values = (getattr(element, field) for field in element.variable)
    return [value for value in values if isinstance(value, Formula)]
