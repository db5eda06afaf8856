"""Stability: `smallest k where upright is stable`: the value at which an equilibrium is only just stable."""

from __future__ import annotations

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.equation import STABILITY, Equation
from rotsolve.core.writing import spoken
from rotsolve.equations.swing import Swing
from rotsolve.paths.meaning import NotYet
from rotsolve.search.extreme_curve import amid, domain_of
from rotsolve.search.search import Search
from rotsolve.search.swings import slope_in


def verge_equation(swing: Swing, unknown: str, modifier: str, search: Search) -> Equation:
    """Where an equilibrium is only just stable: displaced a little, nothing drives the bodies back or away."""
    slope, told, there = slope_in(frozenset((unknown,)), swing, search)
    search.displaced.pop(swing.acceleration.name)
    state = spoken(swing.rest.state)
    if there != ZERO and search.signs.taken(there) != 0 and not balanced_by_numbers(there, search):
        some = f", or with some values of `{unknown}` alone" if unknown in there.symbols() else ""
        raise NotYet(f"{state} is no equilibrium{some}: it speeds up there")
    if unknown not in slope.symbols():
        raise NotYet(f"whether {state} is stable does not depend on `{unknown}`")
    growing = search.signs.of_sizes(differentiate(slope, unknown))
    lacking = sorted(set(search.signs.lacking(slope)) - {unknown})
    if not growing and lacking:
        message = f"{state} may be stable below a value of `{unknown}` or beyond it"
        raise NotYet(message, help=f"give numbers to {', '.join(f'`{name}`' for name in lacking)}")
    if not lacking:
        growing = growing_at(the_verge(slope, unknown, state, search), slope, unknown, search)
    if growing != (1 if modifier == "largest" else -1):
        side = "smallest" if modifier == "largest" else "largest"
        beyond = "beyond" if growing == -1 else "below"
        raise NotYet(f"{state} is stable {beyond} a value", help=f"ask for the `{side}` one")
    return STABILITY.equation(slope, ZERO, swing.harmonic, (), told)


def balanced_by_numbers(there: Formula, search: Search) -> bool:
    """Whether the numbers of the scene make an acceleration nothing exactly, whatever its unknown is: κ (q − q₀) of two right angles."""
    told = {
        name: given.value for name in there.symbols() if (given := search.givens.get(name)) and given.value is not None
    }
    return is_zero(simplify(there.substitute(told)))


def the_verge(slope: Formula, unknown: str, state: str, search: Search) -> Formula:
    """The one value in the range of a letter at which nothing drives back or away; NotYet where there is none, or several."""
    order, positive, domain = search.solver.order, search.solver.positive - {unknown}, domain_of(unknown, search)
    roots = solve_polynomial(slope, unknown, order=order, positive=positive)
    roots = roots or solve_trig(slope, unknown, order=order, positive=positive)
    ends = [(side, end) for side in (-1, 1) if (end := domain.end(side)) is not None]
    places = [
        root
        for root in roots
        if search.number(root) is not None and all(search.signs.taken((root - end) * side) == -1 for side, end in ends)
    ]
    if len(places) > 1:
        raise NotYet(
            f"{state} is only just stable with several values of `{unknown}`: {' and '.join(map(to_text, places))}"
        )
    if not places:
        sign = search.signs.taken(slope.substitute({unknown: amid(domain)}))
        told = {-1: "stable", 1: "unstable"}.get(sign or 0, "as stable")
        raise NotYet(f"{state} is {told} whatever `{unknown}` is")
    return places[0]


def growing_at(place: Formula, slope: Formula, unknown: str, search: Search) -> int:
    """In which sense what drives away grows with a letter at a value of it; 0 where it only touches zero there."""
    return search.signs.taken(differentiate(slope, unknown).substitute({unknown: place})) or 0
