"""Ways: what a body on a hinge or a slide has left of its energy at each place of its way, carried by what is driven, turns, or stands.

With all momenta p of coordinates that nothing pushes, and at rest in its own, the energy in the frame of what is driven evenly is the
effective potential W(q) = V − T₀ + ½ p²/I(q) (Goldstein, Poole & Safko, Classical Mechanics, §3.3 and §8.5). It goes on as long as
E + ∫ Q dq − W is positive, with Q of forces that have no potential, and turns back where that vanishes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from rotsolve.algebra.exact.linear import NotLinear, Singular, solve_all
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Symbol, add, negate, total
from rotsolve.core.lagrangian import GeneralizedCoordinate, Lagrangian
from rotsolve.core.symbols import key_of
from rotsolve.core.ways import PLACE, WayOnJoint
from rotsolve.language.bodies import Joint
from rotsolve.paths.meaning import NotYet
from rotsolve.space.lagrangian import MotionsInSpace, motions_in_space

if TYPE_CHECKING:
    from rotsolve.motion.timeline import Interval
    from rotsolve.space.scene import SpaceEquations

RATE = "#rate "


def ways_on_joints(scene: SpaceEquations, interval: Interval) -> Iterator[WayOnJoint]:
    """The ways of bodies of which only one place changes in a phase that anything hangs on."""
    before, after = scene.dynamics[interval.start], scene.dynamics[interval.end]
    for motions in motions_in_space(scene, before):
        motion = motions.motion
        pushed = [q for q in motion.coordinates if not motion.cyclic(q)]
        joint = joint_along(pushed[0], motions) if len(pushed) == 1 else None
        if joint is None:
            continue
        own, others = pushed[0], [q for q in motion.coordinates if q not in pushed]
        try:
            now, then = motions.putting_in(before), motions.putting_in(after)
        except NotYet:  # what is led there goes as nothing tells: by another law its way may be known
            continue
        left = left_by_place(own, others, motions, now)
        if left is not None:
            rate = Symbol(own.rate)
            ends = now(own.letter), then(own.letter)
            yield WayOnJoint(joint.body.owner, bool(joint.turning), *ends, now(rate), *left, last=then(rate))


def joint_along(q: GeneralizedCoordinate, motions: MotionsInSpace) -> Joint | None:
    """The hinge or the slide along which a coordinate goes."""
    owner, held = key_of(q.letter.name).owner, motions.first.held
    main = held.main(owner) if held.hinge_balls(owner) else None  # two balls hold a body as one hinge does
    for joint in (*held.joints, *([] if main is None else [main])):
        hinged = bool(joint.turning) and not (joint.sliding or joint.free or joint.pitch) and joint.body.owner == owner
        if hinged or (joint.sliding and not (joint.turning or joint.pitch) and joint.owner == owner):
            return joint
    return None


def left_by_place(
    own: GeneralizedCoordinate,
    others: Sequence[GeneralizedCoordinate],
    motions: MotionsInSpace,
    now: Callable[[Formula], Formula],
) -> tuple[Formula, Formula] | None:
    """E − W and Q by the place, with the start put in for all else; None where more than the place tells them."""
    motion, effort = motions.motion, total(motions.motion.efforts_without_potential(own))
    if motion.energy is None or not hangs_on_place(effort, own, motion):
        return None
    begun, momenta = total(list(motion.energy)), [total(motion.momentum(q)) for q in others]
    rates = {q.rate: Symbol(RATE + q.rate) for q in others}
    there = {own.letter.name: Symbol(PLACE), own.rate: ZERO, **rates}
    kept = [add(now(one.substitute(there)), negate(now(one))) for one in momenta]
    try:
        found = solve_all(kept, [rate.name for rate in rates.values()])
    except (NotLinear, Singular):
        return None
    potential = now(begun.substitute(there)).substitute(found)
    return simplify(add(now(begun), negate(potential))), simplify(now(effort.substitute(there)))


def hangs_on_place(effort: Formula, own: GeneralizedCoordinate, motion: Lagrangian) -> bool:
    """Whether a force goes by the place along the way, of all that changes on it."""
    moving = {*motion.growth, *motion.changes, *motion.turned} | {q.rate for q in motion.coordinates}
    return not effort.symbols() & (moving - {own.letter.name})
