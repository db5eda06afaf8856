"""Letters: what a letter of a scene stands for, in words, by where the scene has it: "mass of the block"."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import DIMENSIONS
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.writing import spoken
from rotsolve.keys.names import NameWords
from rotsolve.language.keys import Element, keys_of
from rotsolve.language.problem import Path, PointRef, Problem, references

NAMES = {"inertia": "moment of inertia", "gyration": "radius of gyration", "friction": "coefficient of friction"}
VALUES = ("quantity", "amount", "motion", "friction")  # kinds of keys that hold values, and no places
BODY = ("mass", "inertia", "gyration", "radius", "density")  # fields of a body that hold one value


def words_of_letter(problem: Problem, letter: str, names: NameWords, said: Callable[[Path, str], str]) -> str:
    """What a letter stands for, without an article; '' where no place of the scene tells it. `said` tells a quantity at a state."""
    return next(meanings_of_letter(problem, Symbol(letter), names, said), "")


def meanings_of_letter(
    problem: Problem, letter: Symbol, names: NameWords, said: Callable[[Path, str], str]
) -> Iterator[str]:
    """What a letter stands for at each place that has it alone."""
    for body in problem.bodies:
        for word in BODY:
            if getattr(body, word) == letter:
                yield f"{NAMES.get(word, word)} of {names.thing(body.name)}"
        if isinstance(body.shape, Element):
            yield from (f"{word} of {names.thing(body.name)}" for word in words_of_keys(body.shape, letter))
        for word, _, value in body.moved:
            if value == letter:
                yield f"{spoken(word)} of {names.thing(body.name)}"
    for item in (*problem.connections, *problem.actions, *problem.surfaces, *problem.events):
        for word in words_of_keys(item, letter):
            both = names.touching(item.name)
            between = both and word == NAMES["friction"]
            yield (
                f"{word} between {both[0]} and {both[1]}" if both and between else f"{word} of {names.thing(item.name)}"
            )
    for state in problem.states:
        for line in state.conditions:
            if line.path is not None and line.value == letter:
                yield said(line.path, state.name)
    for ref in references((problem.connections, problem.actions, problem.events, problem.finds)):
        if isinstance(ref, (PointRef, Path)) and ref.argument == letter and ref.owner:
            yield f"distance along {names.thing(ref.owner)} from its start"


def words_of_keys(item: Any, letter: Symbol) -> Iterator[str]:
    """The words of the keys of an element under which a letter stands."""
    for word, key in keys_of(item):
        field = word if hasattr(item, word) else f"{word}_"
        value = getattr(item, field, None)
        if key.kind in VALUES and letter in formulas_of_key(value):
            noun = word in QUANTITIES or word in DIMENSIONS or word in NAMES or word == item.word
            yield NAMES.get(word, spoken(word) if noun or key.dimension is None else key.dimension)


def formulas_of_key(value: object) -> list[object]:
    """The formulas that stand under a key: one, or those of a record such as the coefficients of friction."""
    if isinstance(value, Formula):
        return [value]
    return [getattr(value, name) for name in value.__struct_fields__] if isinstance(value, Struct) else []
