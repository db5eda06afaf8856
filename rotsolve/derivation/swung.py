"""Swung: what only pulls or presses does so as far as a swing of any size goes: on the other side of its equilibrium too.

A swing from STATE is told by where it starts. A rope that pulls there may go slack where all is reversed, and a block lift off.
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, negate, sqrt
from rotsolve.core.facts import ON_THE_WAY, Requirement
from rotsolve.equations.states import rates_of_body
from rotsolve.equations.swing import Swing
from rotsolve.laws.oscillation import holds_at_any_size, restoring
from rotsolve.motion.freebody import free_bodies
from rotsolve.search.search import Search


def far_ends(search: Search) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """By the state from which a swing starts, that forces and tensions are not negative where it ends and turns back."""
    for swing in search.scene.swings.values():
        exact = search.displaced.get(swing.acceleration.name) if swing.start else None
        if exact is not None:
            yield swing.start, tuple(at_the_ends(swing, exact, search))


def at_the_ends(swing: Swing, exact: Formula, search: Search) -> Iterator[Requirement]:
    """What pulls and presses as a function of the displacement, at rest at the ends of a swing; where none of it varies, nothing."""
    other = search.apart()
    other.known.add(swing.coordinate.name)
    needs = [need for need in free_bodies(swing.near).requirements if not (need.kind.grips or need.kind.placed)]
    margins = [(need, other.settled(need.left - need.right)) for need in needs]
    varying = [(need, gap) for need, gap in margins if gap is not None and swing.coordinate.name in gap.symbols()]
    for end in turning_points(swing, exact, other) if varying else ():
        for need, gap in varying:
            least = simplify(gap.substitute({swing.coordinate.name: end}), positive=search.solver.positive)
            place = "as it swings back, after it was let go at"
            yield Requirement(need.owner, ON_THE_WAY, least, ZERO, need.kept, f"{need.otherwise} {place}")


def turning_points(swing: Swing, exact: Formula, search: Search) -> Iterator[Formula]:
    """Where a swing turns back: −q₀ for one from rest at q₀ = a₀/s, with a = s q; ±√(q₀² − v₀²/s) for one that is thrown."""
    if not holds_at_any_size(exact, swing.coordinate):
        yield negate(swing.amplitude())
        return
    start, place = search.scene.instant(swing.start), -1 if swing.turns else 0
    push, speed = (list(rates_of_body(word, start, swing.body))[place] for word in ("acceleration", "velocity"))
    pushed, thrown = search.settled(push), search.settled(speed)
    if pushed is None or thrown is None:
        return
    slope = restoring(exact, swing.coordinate)
    if thrown == ZERO:
        yield negate(pushed / slope)
    else:
        size = sqrt((pushed / slope) ** 2 - thrown**2 / slope)
        yield from (size, negate(size))
