"""Noted: records of what a scene declares that remember which of their fields nobody has read.

Where reading is to be noted, the slots of a copy are emptied; the first reader of a field finds nothing there, fetches the value from
beside and leaves it in its slot, so that only the first look at a field costs anything.
"""

from __future__ import annotations

from typing import Any, TypeVar

from msgspec import Struct
from msgspec.structs import force_setattr

BESIDE = "beside"  # where the values are that nobody has read
Declaring = TypeVar("Declaring", bound="Noted")


class Noted(Struct, frozen=True, dict=True):
    """Base of all that a scene declares under keys of its own."""

    def __getattr__(self, name: str) -> Any:
        """The value of a field that is read for the first time."""
        beside = self.__dict__.get(BESIDE)
        if not beside or name not in beside:
            raise AttributeError(f"{type(self).__name__!r} has no {name!r}")
        value = beside.pop(name)
        force_setattr(self, name, value)
        return value


def noting(item: Declaring, *, but: tuple[str, ...] = ()) -> Declaring:
    """A copy that notes which of the fields are read that are not as they are by default, `but` for some."""
    twin: Declaring = item.__copy__()
    kind = type(item)
    plain = kind.__struct_defaults__
    fields = kind.__struct_fields__[len(kind.__struct_fields__) - len(plain) :]
    beside = {}
    for name, default in zip(fields, plain, strict=True):
        value = getattr(item, name)
        if value is not default and value != default and name not in but:
            beside[name] = value
            getattr(kind, name).__delete__(twin)
    twin.__dict__[BESIDE] = beside
    return twin


def unread(item: Noted) -> tuple[str, ...]:
    """The fields that have a value and that nobody has read."""
    return tuple(item.__dict__.get(BESIDE, ()))


def with_all_slots(item: Declaring) -> Declaring:
    """The record with all its fields in their slots, as functions that compare look for them, and nothing of it read by that."""
    beside = item.__dict__.get(BESIDE, {})
    return type(item)(
        **{name: beside[name] if name in beside else getattr(item, name) for name in item.__struct_fields__}
    )


def read_all(item: Declaring) -> Declaring:
    """The record with all its fields in their slots again, where functions that copy or compare look for them."""
    for name in unread(item):
        getattr(item, name)
    return item
