"""Lagrange's equations: d/dt(∂L/∂q̇) − ∂L/∂q = Q of each coordinate with which tied bodies can move, and the momenta that are conserved.

L = T − V, Q of what has no potential (Goldstein, Poole & Safko, Classical Mechanics, §1.4, §2.6). Ideal supports, strings and rolling contacts
give no power in any motion that they allow, so that their forces do not occur.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ZERO, Formula, multiply, total
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.equation import CYCLIC, ENERGY_FUNCTION, LAGRANGE_EQUATION, Equation
from rotsolve.core.lagrangian import Coordinate, Lagrangian
from rotsolve.core.writing import flat, moved, positive_first
from rotsolve.laws.table import BetweenMoments, OfMotion


def equations_of_motion(at: OfMotion) -> Iterator[Equation]:
    """d/dt(∂T/∂q̇) − ∂T/∂q = Q for each coordinate, with the values of the moment put in behind the derivatives."""
    for q in at.motion.coordinates:
        left, right = ([at.now(term) for term in terms] for terms in (at.motion.inertial(q), at.motion.efforts(q)))
        if not flat(left) or not flat(right):
            sides = moved(flat(left), flat(right))
        else:
            sides = positive_first(left), positive_first(right)
        if sides[0] != sides[1]:
            yield LAGRANGE_EQUATION.equation(
                *sides, at.section, at.bodies, lagrangian_words(at.motion), coordinate=q.words
            )


def conserved_momenta(between: BetweenMoments) -> Iterator[Equation]:
    """∂L/∂q̇ of a coordinate on which L does not hang, and along which nothing pushes, is the same at both ends of a phase."""
    motion = between.motion
    for q in motion.coordinates:
        if motion.cyclic(q):
            left, right = (positive_first(map(end, motion.momentum(q))) for end in (between.first, between.last))
            if not is_zero(left - right):
                words = lagrangian_words(motion)
                yield CYCLIC.equation(left, right, between.section, between.bodies, words, coordinate=q.words)


def conserved_energy(between: BetweenMoments) -> Iterator[Equation]:
    """T + V at both ends of a phase, where L does not hang on time and nothing else gives energy."""
    energy = between.motion.energy
    if energy is not None:
        sides = [[end(term) for term in energy] for end in (between.first, between.last)]
        left, right = moved(flat(sides[0]), flat(sides[1]))
        if not is_zero(left - right):
            words = lagrangian_words(between.motion)
            yield ENERGY_FUNCTION.equation(left, right, between.section, between.bodies, words)


def lagrangian_words(motion: Lagrangian) -> Words:
    """Coordinates, T and V as functions of them, Lagrange's equations, and which coordinates are cyclic, each on its line."""
    lines: list[Words] = [
        (q.letter, f": {q.words}{', ' if q.positive else ''}{q.positive}") for q in motion.coordinates
    ]
    lines.append(("T = ", energy_of(motion.kinetic, motion)))
    if motion.potential:
        lines.append(("V = ", energy_of(motion.potential, motion)))
    lines += [equation_words(q, motion) for q in motion.coordinates]
    lines += [momentum_words(q, motion) for q in motion.coordinates if motion.cyclic(q)]
    return tuple(part for line in lines for part in (NEXT, *line))[1:]


def equation_words(q: Coordinate, motion: Lagrangian) -> Words:
    """d/dt(∂L/∂ẋ) − ∂L/∂x = Q with L = T − V; by T alone where there is no V, and where it is not found, with all of Q."""
    stored = bool(motion.potential)
    efforts = motion.efforts(q)[len(motion.weights) + len(motion.sprung) if stored else 0 :]
    effort = energy_of((multiply(term, motion.pace(q)) for term in efforts), motion)
    letter = "L" if stored else "T"
    words: Words = (f"d/dt(∂{letter}/∂", q.dotted, f") − ∂{letter}/∂", q.letter, " = ", effort)
    return (*words, ", L = T − V") if stored else words


def momentum_words(q: Coordinate, motion: Lagrangian) -> Words:
    """Of a cyclic coordinate: its momentum is conserved."""
    momentum = energy_of((multiply(term, motion.pace(q)) for term in motion.momentum(q)), motion)
    return (q.letter, " is cyclic: ∂T/∂", q.dotted, " = ", momentum, " is conserved")


def energy_of(terms: Iterable[Formula], motion: Lagrangian) -> Formula:
    """A sum of terms as a page writes it: by q̇ instead of the letters of rates."""
    rates = {q.rate: multiply(motion.pace(q), q.dotted) for q in motion.coordinates}
    plain = (term.substitute(rates) for term in terms)
    return positive_first(min((term, motion.tidy(term)), key=length) for term in plain if term != ZERO)
