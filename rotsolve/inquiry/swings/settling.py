"""Settling: from the laws of a displaced body to its harmonic motion: the acceleration, its part to first order, the frequency."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.writing import spoken
from rotsolve.inquiry.questions import NotYet
from rotsolve.inquiry.swings.equilibrium import sign
from rotsolve.inquiry.swings.swing import Swing
from rotsolve.principles.oscillation import holds_at_any_size, linearised, restoring

if TYPE_CHECKING:
    from rotsolve.inquiry.answering import Inquiry


def settle(swing: Swing, inquiry: Inquiry, asked: str) -> None:
    """Everything that comes before the `asked` letter: the equilibrium, the acceleration near it, the angular frequency."""
    omega = next(iter(swing.letter("angular_frequency").symbols()))
    if omega in inquiry.solver.solved:
        return
    settle_equilibrium(swing, inquiry)
    inquiry.known.add(swing.coordinate.name)
    exact = inquiry.solver.with_answers(acceleration_of(swing, inquiry))
    slope = inquiry.solver.simplify(restoring(exact, swing.coordinate))
    check_stable(swing, exact, slope, inquiry)
    if not holds_at_any_size(exact, swing.coordinate):
        first_order = inquiry.solver.simplify(slope * swing.coordinate)
        approximate = linearised(swing.acceleration, exact, first_order, swing.coordinate, swing.harmonic)
        inquiry.replaced(swing.acceleration.name, approximate)
    if asked != omega:
        inquiry.step(omega)


def settle_equilibrium(swing: Swing, inquiry: Inquiry) -> None:
    """How far springs and wires are stretched; what balance does not tell stays a letter, which has to drop out."""
    from rotsolve.inquiry.answering import NoAnswer

    for place in swing.unsettled:
        try:
            inquiry.step(place)
        except NoAnswer:
            inquiry.known.add(place)


def acceleration_of(swing: Swing, inquiry: Inquiry) -> Formula:
    """The acceleration as a function of the displacement."""
    found = inquiry.step(swing.acceleration.name).formula
    if found is None:
        raise NotYet(f"how `{swing.body}` swings has no closed form")
    return found


def check_stable(swing: Swing, exact: Formula, slope: Formula, inquiry: Inquiry) -> None:
    """Small swings need an equilibrium, and one to which the bodies are driven back."""
    name, state = spoken(swing.body), spoken(swing.rest.state) if not swing.found else "the equilibrium"
    at_rest = exact.substitute({swing.coordinate.name: ZERO})
    if not is_zero(at_rest, inquiry.solver.positive):
        raise NotYet(f"`{name}` is not in equilibrium at {state}: it speeds up there")
    known = set(inquiry.givens) | set(inquiry.values)
    if slope.symbols() - known:
        raise NotYet(f"how `{name}` swings about {state} depends on how its springs are stretched there")
    way = sign(slope, inquiry.values)
    if way == 0:
        raise NotYet(f"nothing drives `{name}` back to {state}: there are no small swings")
    if way == 1:
        raise NotYet(f"`{name}` has no small swings about {state}: the equilibrium is unstable")
