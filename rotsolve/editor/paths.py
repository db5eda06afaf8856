"""Paths: what may follow `rod.` in a value, a phrase of `find` or a line of a state, and what stands where in a phrase."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rotsolve.algebra.formula import FUNCTIONS
from rotsolve.core.quantity import QUANTITIES, SYSTEM
from rotsolve.editor.offers import Offer, offers, units_offered
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
SPOKEN_OF = ("about", "along", "by", "relative")


def path_before(typed: str) -> list[str] | None:
    """The words before the last dot of a path that is being written; None where none is."""
    match = WRITTEN_PATH.search(typed)
    return [str(word) for word in segments(match["path"])] if match else None


def after_number(typed: str) -> bool:
    """Whether a number stands right before, so that a unit may follow."""
    return NUMBER_BEFORE.search(typed) is not None


def owned(scope: Scope, words: list[str], *, points: bool = False) -> Iterator[Offer]:
    """What may follow the words of a path; the `points` of a body alone where a place is wanted."""
    owner, rest = words[0], words[1:]
    quantity = next((word for word in words if word in QUANTITIES), None)
    if owner in scope.bodies:
        yield from owned_by_body(scope, owner, rest, points)
    elif owner in scope.elements and not points:
        end = rest[0] if rest and rest[0] in ends_of_element(scope, owner) else None
        if quantity is None:
            yield from quantities(scope, asked_of_element(scope, owner, end))
            yield from offers(ends_of_element(scope, owner) if not rest else (), "point", f"an end of {owner}")
    elif owner not in (SUMMED_IN_SPACE if scope.space else SUMMED):
        return
    if quantity is not None and not points and words[-1] == quantity:
        yield from offers(component_words(scope, QUANTITIES[quantity]), "component", f"a component of {quantity}")


def owned_by_body(scope: Scope, owner: str, rest: list[str], points: bool) -> Iterator[Offer]:
    """The points and quantities of a body, or the quantities of a point."""
    shape = scope.bodies[owner].shape
    slender = shape is not None and shape.slender
    point = rest[0] if rest and (rest[0] in scope.points[owner] or rest[0].startswith("at")) else None
    if not rest:
        yield from offers(scope.points[owner], "point", f"a point of {owner}")
        if slender:
            yield Offer("at(x)", "point", f"the point of {owner} so far from its start", "at(${1:x})", snippet=True)
    if not points and (not rest or (point is not None and len(rest) == 1)):
        yield from quantities(scope, asked_of_body(point))


def quantities(scope: Scope, words: list[str]) -> Iterator[Offer]:
    for word in words:
        entry = QUANTITIES[word]
        if not entry.later and (scope.space or not entry.space):
            yield Offer(word, "quantity", quantity_text(entry))


def names_of(scope: Scope, *kinds: str) -> Iterator[Offer]:
    """The names of some kinds of things."""
    for kind in kinds:
        yield from offers(scope.names(kind), "name", f"a {kind}" if kind != "find" else "an answer above")


def in_phrase(scope: Scope, typed: str) -> Iterator[Offer]:
    """What may come next in a phrase of `find`."""
    words = path_before(typed)
    if words is not None:
        yield from owned(scope, words)
        return
    before = (re.findall(r"[^\W\d]\w*|\S", re.sub(r"[^\W\d]\w*$", "", typed)) or [""])[-1]
    if before in ("at", "from", "to"):
        yield from names_of(scope, "state")
        yield from offers([ANY_TIME] if before == "at" else [], "word", "the moment that runs through a phase")
    elif before == "during":
        yield from names_of(scope, "event", "phase")
    elif before in SPOKEN_OF:
        yield from names_of(scope, "body")
        yield from offers({"by": METHODS, "along": DIRECTIONS}.get(before, ()), "word")
    elif before == "in":
        yield from units_offered(None)
        yield from offers(NAMED_AXES if scope.space else (), "word", "axes in which components are told")
    else:
        yield from at_liberty(scope, typed)


def at_liberty(scope: Scope, typed: str) -> Iterator[Offer]:
    """Names, quantities of the scene, modifiers, clauses, units behind a number."""
    if after_number(typed):
        yield from units_offered(None)
    yield from names_of(scope, *OWNERS, "given", "find")
    yield from quantities(scope, [word for word, entry in QUANTITIES.items() if SYSTEM in entry.owners])
    yield from offers(MODIFIERS, "word", "stands before an expression, and belongs to the whole of it")
    yield from offers(CLAUSES if typed.strip() else (), "word", "begins a clause, after the expression")
    yield from offers(FUNCTIONS, "function")
