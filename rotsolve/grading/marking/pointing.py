"""Pointing: which way an answer points beside its own words: along a slope to the left or right too, and what it is the size of."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec.structs import astuple

from rotsolve.core.symbols import key_of
from rotsolve.grading.comparing.numbers import certified_number
from rotsolve.grading.marking.target import SceneLetters
from rotsolve.language.problem import Find, PointRef, Problem

SIZE = "size of"
SIDES = ("left", "right")


def sized_direction(letters: SceneLetters, find: Find) -> str:
    """The direction of a quantity of which the size is asked; '' where that is not told."""
    if len(find.terms) != 1 or SIZE not in (find.modifier, find.terms[0].modifier):
        return ""
    return next(iter(directions_there(letters, find)), "") if len(set(directions_there(letters, find))) == 1 else ""


def directions_there(letters: SceneLetters, find: Find) -> Iterator[str]:
    """The directions of the quantity itself, under each name that it has at its state or in the phase that begins there."""
    term, meanings = find.terms[0], letters.meanings
    wanted = (term.path.quantity, term.path.owner, term.path.component or "")
    for name, text in meanings.keys.items():
        key = key_of(text)
        if (key.kind, key.owner, key.component) != wanted or key.marked:
            continue
        if term.at and key.when != term.at and not key.when.startswith(f"{term.at} to "):
            continue
        quantity, closed = meanings.search.scene.registry.quantities.get(text), meanings.closed(name)
        number = meanings.number(name) if closed is None else certified_number(closed, letters.values)
        if quantity is not None and number is not None and number.sign:
            yield quantity.positive if number.sign > 0 else quantity.negative


def level_side(problem: Problem, find: Find, direction: str) -> str:
    """Where a direction along a slope leads on the level: "right", "left", as the surface says; '' for any other direction."""
    owner = find.terms[0].path.owner if find.terms else ""
    slopes = {surface.name: surface for surface in problem.surfaces if surface.slanted}
    touched = {
        name for one in problem.connections if owner in (held := owners_in(one)) for name in held & slopes.keys()
    }
    sides = {side for name in touched or slopes for side in SIDES if slopes[name].travel(side)[1] == direction}
    return sides.pop() if len(sides) == 1 else ""


def owners_in(connection: object) -> frozenset[str]:
    """What a connection connects, by names."""
    values = astuple(connection)  # type: ignore[arg-type]
    parts = (part for value in values for part in (value if isinstance(value, tuple) else (value,)))
    return frozenset(part.owner for part in parts if isinstance(part, PointRef))
