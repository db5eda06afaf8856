"""Lagrange's equations: d/dt(∂L/∂q̇) − ∂L/∂q = Q of each coordinate with which tied bodies can move, and the momenta that are conserved.

L = T − V, Q of what has no potential (Goldstein, Poole & Safko, Classical Mechanics, §1.4, §2.6). Ideal supports, strings and rolling
contacts give no power in any motion that they allow, so that their forces do not occur.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import Formula, multiply, negate
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.equation import CYCLIC, ENERGY_FUNCTION, LAGRANGE_EQUATION, Equation
from rotsolve.core.lagrangian import GeneralizedCoordinate, Lagrangian, rate_letter
from rotsolve.core.writing import flat, is_negative, moved, positive_first
from rotsolve.laws.table import BetweenMoments, OfMotion

LONG = 150  # nodes of an equation beyond which it is not written out beside its law


def equations_of_motion(at: OfMotion) -> Iterator[Equation]:
    """d/dt(∂T/∂q̇) − ∂T/∂q = Q for each coordinate, with the values of the moment put in behind the derivatives."""
    for q in at.motion.coordinates:
        left, right = ([at.now(term) for term in terms] for terms in (at.motion.inertial(q), at.motion.efforts(q)))
        left, right = flat(left), flat(right)
        if all(map(is_negative, (*left, *right))):
            left, right = [negate(term) for term in left], [negate(term) for term in right]
        sides = (positive_first(left), positive_first(right)) if left and right else moved(left, right)
        if sides[0] != sides[1]:
            words = lagrangian_words(at.motion)
            yield LAGRANGE_EQUATION.equation(*sides, at.section, at.bodies, words, coordinate=q.words)


def conserved_momenta(between: BetweenMoments) -> Iterator[Equation]:
    """∂L/∂q̇ of a coordinate on which L does not hang, and along which nothing pushes, is the same at both ends of a phase."""
    motion = between.motion
    for q in motion.coordinates:
        if motion.cyclic(q):
            left, right = (positive_first(map(end, motion.momentum(q))) for end in (between.first, between.last))
            if not is_zero(left - right):
                words = lagrangian_words(motion)
                yield CYCLIC.equation(left, right, between.section, between.bodies, words, coordinate=q.words)


def energy_over(between: BetweenMoments) -> Iterator[Equation]:
    """T₁ + V₁ + W = T₂ + V₂: where time does not occur in L, only what has no potential changes T + V.

    Of what is carried round at a constant rate it is Σ q̇ ∂L/∂q̇ − L that stays (Goldstein, Poole & Safko, Classical Mechanics, §2.7).
    """
    energy, natural = between.motion.energy, between.motion.natural
    unknown = bool(between.motion.given) and not between.works  # of what has no potential nobody tells the work
    if energy is None or unknown or (between.works and not natural):
        return
    before, after = ([end(term) for term in energy] for end in (between.first, between.last))
    left, right = moved(flat([*before, *between.works]), flat(after))
    if not is_zero(left - right):
        kept = "T + V" if natural else "its energy function T₂ − T₀ + V"
        label = "T₁ + V₁ + W = T₂ + V₂" if between.works else f"time does not occur in L: {kept} is conserved"
        words = lagrangian_words(between.motion)
        yield ENERGY_FUNCTION.equation(left, right, between.section, between.bodies, words, words=label)


def lagrangian_words(motion: Lagrangian) -> Words:
    """Coordinates, T and V as functions of them, Lagrange's equations, and which coordinates are cyclic, each on its line."""
    lines: list[Words] = [coordinate_words(q, motion) for q in motion.coordinates]
    lines.append(("T = ", positive_first(as_printed(term, motion) for term in motion.kinetic)))
    if motion.potential:
        lines.append(("V = ", sum_on_page(motion.potential, motion)))
    lines += [momentum_words(q, motion) if motion.cyclic(q) else equation_words(q, motion) for q in motion.coordinates]
    return tuple(part for line in lines for part in (NEXT, *line))[1:]


def coordinate_words(q: GeneralizedCoordinate, motion: Lagrangian) -> Words:
    """x: way of block, down."""
    return as_printed(q.letter, motion), f": {q.words}" + (f", {q.positive}" if q.positive else "")


def equation_words(q: GeneralizedCoordinate, motion: Lagrangian) -> Words:
    """d/dt(∂L/∂ẋ) − ∂L/∂x = (m + M) ẍ − m g = Q with L = T − V; by T alone where there is no V, with all of Q where it is not found."""
    stored = bool(motion.potential)
    efforts = [multiply(term, motion.pace(q)) for term in motion.efforts(q)]
    own = len(motion.weights) + len(motion.sprung) if stored else 0
    inertial = [multiply(term, motion.pace(q)) for term in motion.inertial(q)]
    whole = sum_on_page((*inertial, *map(negate, efforts[:own])), motion)
    letter, of = as_printed(q.letter, motion), "L" if stored else "T"
    words: Words = (f"d/dt(∂{of}/∂", rate_letter(letter), f") − ∂{of}/∂", letter, " = ", whole)
    words = (
        (*words, " = ", sum_on_page(efforts[own:], motion))
        if length(whole) < LONG
        else (*words[:-1], sum_on_page(efforts[own:], motion))
    )
    return (*words, ", L = T − V") if stored else words


def momentum_words(q: GeneralizedCoordinate, motion: Lagrangian) -> Words:
    """Of a cyclic coordinate: its momentum is conserved."""
    momentum = sum_on_page((multiply(term, motion.pace(q)) for term in motion.momentum(q)), motion)
    letter = as_printed(q.letter, motion)
    return letter, " is cyclic: ∂T/∂", rate_letter(letter), " = ", momentum, " is conserved"


def sum_on_page(terms: Iterable[Formula], motion: Lagrangian) -> Formula:
    """A sum of terms, each in textbook form."""
    return positive_first(motion.tidy(as_printed(term, motion)) for term in terms)


def as_printed(value: Formula, motion: Lagrangian) -> Formula:
    """A formula in the letters of pages: by q̇ instead of the rates of the scene."""
    return value.substitute(dict(motion.page))
