"""Acting: which way forces act by what answers them; whose friction, that holds something, acts the way in which its body is counted."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from rotsolve.algebra.effort import Exhausted, at_most
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.symbols import TIME, has_quantities, rub_of
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Problem
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

FRICTION, SIZE = "friction_force", "size of"
ASIDE = 400  # steps for a letter that nobody has asked for


class ActingWays(Struct, frozen=True):
    """What tells which way forces act: the searches that have answered a scene, one for each case of its letters."""

    searches: tuple[Search, ...]

    @property
    def scene(self) -> SceneEquations:
        """The scene as it is solved, with the ways in which contacts slip, in the first case."""
        return self.searches[0].scene

    @property
    def divided(self) -> frozenset[str]:
        """What rubs otherwise in one case than in another, or is counted the other way there, so that no picture is of all."""
        modes = {
            rub_of(key)[0]
            for one in self.searches
            for key, mode in one.scene.modes.items()
            if self.scene.modes.get(key) != mode
        }
        turned = {
            owner
            for one in self.searches
            for owner in one.scene.configuration.forward ^ self.scene.configuration.forward
        }
        return frozenset(modes | turned)

    def sign(self, value: Formula, owner: str) -> int | None:
        """The sign of what a connection or action does, where it is the same in every case; None where nothing tells it."""
        if len(self.searches) > 1 and owner in self.divided:
            return None
        signs = {sign_in_case(value, search) for search in self.searches}
        return signs.pop() if len(signs) == 1 else None

    def number(self, value: Formula) -> float | None:
        """About what a formula of quantities comes to, where there is one case of letters."""
        if len(self.searches) > 1:
            return None
        found = found_aside(value, self.searches[0])
        return None if found is None else self.searches[0].number(found)


def all_cases(found: Sequence[ActingWays | None]) -> ActingWays | None:
    """What tells of several cases together."""
    searches = tuple(search for one in found if one is not None for search in one.searches)
    return ActingWays(searches) if searches else None


def found_aside(value: Formula, search: Search) -> Formula | None:
    """A formula with all letters of the laws worked out, those that nobody has asked for aside."""
    value = search.solver.with_found(value)
    if not has_quantities(value):
        return value
    try:
        with at_most(ASIDE):
            return search.beside_by(families_for(None)).settled(value)
    except (Exhausted, ValueError, ArithmeticError):
        return None


def sign_in_case(value: Formula, search: Search) -> int | None:
    """The sign of a formula of quantities in one case, as far as numbers tell it or all letters that are meant to be positive."""
    found = found_aside(value, search)
    if found is None:
        try:
            with at_most(ASIDE):
                number = search.beside_by(families_for(None)).certified(value)
        except (Exhausted, ValueError, ArithmeticError):
            return None
        return None if number is None else number.sign
    sign = search.signs.sign(found)
    if sign is None:
        sign = search.signs.as_meant(found)
    if sign is None and TIME in found.symbols():  # the clock runs from 0 on
        sign = search.signs.sign(found.substitute({TIME: Symbol(TIME) * Symbol(TIME)}))
    return sign


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
