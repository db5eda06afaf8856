"""Paths: what may follow `rod.` in a value, a phrase of `find` or a line of a state, and what stands where in a phrase."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rotsolve.algebra.formula import FUNCTIONS
from rotsolve.core.quantity import QUANTITIES, SYSTEM
from rotsolve.editor.proposals import Proposal, each, proposed_units
from rotsolve.language.grammar import CLAUSES, MODIFIERS, NAMED_AXES
from rotsolve.language.problem import ANY_TIME
from rotsolve.scene.clauses import DIRECTIONS, METHODS
from rotsolve.scene.paths import (
    OWNERS,
    SUMMED,
    SUMMED_IN_SPACE,
    asked_of_body,
    asked_of_element,
    component_words,
    ends_of_element,
    segments,
)
from rotsolve.scene.reference import quantity_text
from rotsolve.scene.scope import Scope

WRITTEN_PATH = re.compile(r"(?P<path>[^\W\d]\w*(?:\.\w+(?:\([^()]*\))?)*)\.\w*$")
NUMBER_BEFORE = re.compile(r"(?:^|[\s(=<>+*/-])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\s*(?:[^\W\d_]*)$")
LAST_WORDS = re.compile(r"(?P<before>[^\W\d]\w*)?(?:\s+)?(?:[^\W\d]\w*)?$")
SPOKEN_OF = ("about", "along", "by", "relative")


def path_before(typed: str) -> list[str] | None:
    """The words before the last dot of a path that is being written; None where none is."""
    match = WRITTEN_PATH.search(typed)
    return [str(word) for word in segments(match["path"])] if match else None


def after_number(typed: str) -> bool:
    """Whether a number stands right before, so that a unit may follow."""
    return NUMBER_BEFORE.search(typed) is not None


def owned(scope: Scope, words: list[str], *, points: bool = False) -> Iterator[Proposal]:
    """What may follow the words of a path; the `points` of a body alone where a place is wanted."""
    owner, rest = words[0], words[1:]
    quantity = next((word for word in words if word in QUANTITIES), None)
    if owner in scope.bodies:
        yield from of_body(scope, owner, rest, points)
    elif owner in scope.elements and not points:
        end = rest[0] if rest and rest[0] in ends_of_element(scope, owner) else None
        if quantity is None:
            yield from quantities(scope, asked_of_element(scope, owner, end))
            yield from each(ends_of_element(scope, owner) if not rest else (), "point", f"an end of {owner}")
    elif owner not in (SUMMED_IN_SPACE if scope.space else SUMMED):
        return
    if quantity is not None and not points and words[-1] == quantity:
        yield from each(component_words(scope, QUANTITIES[quantity]), "component", f"a component of {quantity}")


def of_body(scope: Scope, owner: str, rest: list[str], points: bool) -> Iterator[Proposal]:
    """The points and quantities of a body, or the quantities of a point."""
    shape = scope.bodies[owner].shape
    slender = shape is not None and shape.slender
    point = rest[0] if rest and (rest[0] in scope.points[owner] or rest[0].startswith("at")) else None
    if not rest:
        yield from each(scope.points[owner], "point", f"a point of {owner}")
        if slender:
            yield Proposal("at(x)", "point", f"the point of {owner} so far from its start", "at(${1:x})", snippet=True)
    if not points and (not rest or (point is not None and len(rest) == 1)):
        yield from quantities(scope, asked_of_body(point))


def quantities(scope: Scope, words: list[str]) -> Iterator[Proposal]:
    for word in words:
        entry = QUANTITIES[word]
        if not entry.later and (scope.space or not entry.space):
            yield Proposal(word, "quantity", quantity_text(entry))


def named(scope: Scope, *kinds: str) -> Iterator[Proposal]:
    """The names of some kinds of things."""
    for kind in kinds:
        yield from each(scope.names(kind), "name", f"a {kind}" if kind != "find" else "an answer above")


def in_phrase(scope: Scope, typed: str) -> Iterator[Proposal]:
    """What may come next in a phrase of `find`."""
    words = path_before(typed)
    if words is not None:
        yield from owned(scope, words)
        return
    before = (re.findall(r"[^\W\d]\w*|\S", re.sub(r"[^\W\d]\w*$", "", typed)) or [""])[-1]
    if before in ("at", "from", "to"):
        yield from named(scope, "state")
        yield from each([ANY_TIME] if before == "at" else [], "word", "the moment that runs through a phase")
    elif before == "during":
        yield from named(scope, "event", "phase")
    elif before in SPOKEN_OF:
        yield from named(scope, "body")
        yield from each({"by": METHODS, "along": DIRECTIONS}.get(before, ()), "word")
    elif before == "in":
        yield from proposed_units(None)
        yield from each(NAMED_AXES if scope.space else (), "word", "axes in which components are told")
    else:
        yield from at_liberty(scope, typed)


def at_liberty(scope: Scope, typed: str) -> Iterator[Proposal]:
    """Names, quantities of the scene, modifiers, clauses, units behind a number."""
    if after_number(typed):
        yield from proposed_units(None)
    yield from named(scope, *OWNERS, "given", "find")
    yield from quantities(scope, [word for word, entry in QUANTITIES.items() if SYSTEM in entry.owners])
    yield from each(MODIFIERS, "word", "stands before an expression, and belongs to the whole of it")
    yield from each(CLAUSES if typed.strip() else (), "word", "begins a clause, after the expression")
    yield from each(FUNCTIONS, "function")
