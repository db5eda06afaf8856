"""Acting: whose friction, that holds something, acts by its numbers the way in which its body is counted, to be drawn and named so."""

from __future__ import annotations

from rotsolve.algebra.formula import Symbol
from rotsolve.core.symbols import has_quantities
from rotsolve.language.problem import Problem
from rotsolve.search.search import Search

FRICTION, SIZE = "friction_force", "size of"


def acting_forward(search: Search) -> frozenset[str]:
    """The owners of frictions that come out negative as they are drawn, at each moment at which they are told: one that turns round keeps
    its sense, and so does one of which the scene itself says something signed."""
    problem, quantities = search.scene.configuration.problem, search.scene.registry.quantities
    if any(find.verge for find in problem.finds):  # at its limit it has the sense of the slip that begins
        return frozenset()
    signs: dict[str, set[int | None]] = {}
    for key in {*search.solver.told, *search.solver.solved} & quantities.keys():
        if quantities[key].kind == FRICTION:
            signs.setdefault(quantities[key].owner, set()).add(sign_told(key, search))
    negative = {owner for owner, own in signs.items() if own - {0} == {-1}}
    return frozenset(negative - spoken_of(problem)) if negative else frozenset()


def sign_told(key: str, search: Search) -> int | None:
    """The sign of a letter that a step tells: of its number, or the same for all letters that are meant to be positive."""
    found = search.solver.solved.get(key)
    if found is not None and found.number is not None:
        return found.number.sign
    value = search.solver.with_found(Symbol(key))
    if has_quantities(value):
        return None
    sign = search.signs.sign(value)
    return search.signs.as_meant(value) if sign is None else sign


def spoken_of(problem: Problem) -> set[str]:
    """The contacts with a friction of which the scene tells a value, or asks where it has one or how it changes."""
    paths = [term.path for find in problem.finds for term in find.terms if {find.modifier, term.modifier} - {"", SIZE}]
    lines = [line for state in problem.states for line in state.conditions]
    lines += [find.where for find in problem.finds if find.where is not None]
    paths += [line.path for line in lines if line.path is not None]
    paths += [term.path for line in lines if line.phrase is not None for term in line.phrase.terms]
    return {path.owner for path in paths if path.quantity == FRICTION}
