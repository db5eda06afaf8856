"""Pressing: how hard a body in balance is pushed, by its own balance: ΣF = 0 and Στ = 0, which are linear in the pushes."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from rotsolve.algebra.exact.linear import NotLinear, Singular, solve_all
from rotsolve.algebra.formula import ZERO, Formula, Symbol, total
from rotsolve.core.symbols import RATES, of_kinds
from rotsolve.core.vectors.heading import RIGHT, UP
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.search.swings import balanced

if TYPE_CHECKING:
    from rotsolve.core.facts import BodyFacts
    from rotsolve.search.numbers import Numbers


def pushes_of(name: str, scene: SceneEquations, numbers: Numbers) -> Iterator[Formula]:
    """The pushes on the bodies in balance whose angle a letter tells, by that letter; none where a body's own balance leaves them open."""
    for body, _, _ in balanced(name, scene):
        sums = own_balance(body)
        letters = {letter for part in sums for letter in part.symbols()} - {name}
        open_ = sorted(letter for letter in letters if numbers.of(Symbol(letter)) is None)
        pushes = [force.size for force in body.forces if force.role.presses and isinstance(force.size, Symbol)]
        found = pushes_told(sums, open_) if pushes else {}
        yield from (found[push.name] for push in pushes if push.name in found)


def pushes_told(sums: list[Formula], letters: list[str]) -> dict[str, Formula]:
    """What as many equations as there are letters tell of these; the rest of the equations then tells the place."""
    for few in combinations(sums, len(letters)) if letters else ():
        try:
            return solve_all(few, letters)
        except (NotLinear, Singular):
            continue
    return {}


def own_balance(body: BodyFacts) -> list[Formula]:
    """What is zero where a body rests: the forces on it along both axes, and the torques about its reference."""
    forces = [total([force.vector.along(way) for force in body.forces]) for way in (RIGHT, UP)]
    torques = total([*(force.torque for force in body.forces), *(couple.torque for couple in body.couples)])
    return [part.substitute(dict.fromkeys(of_kinds(part.symbols(), RATES), ZERO)) for part in (*forces, torques)]
