"""Swings of what hangs on a hinge, as seen from what carries that round at a steady rate: by an effective potential.

With q the angle on the hinge, T = ½ A q̇² + B(q) q̇ + T₀(q): A is the moment of inertia about the hinge, T₀ = ½ J(q) w² the energy of
what only goes round with the carrier, and B(q) q̇ the rate of a function of q. So A q̈ = −U′(q) with U = V − T₀, and at U′ = 0 a small
displacement δ has δ̈ = −(U″/A) δ (Taylor, Classical Mechanics, §7.6 and example 7.7; Goldstein, Poole & Safko, Classical Mechanics, §2.7).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula, Symbol, negate, total
from rotsolve.core.derivation import Words
from rotsolve.core.equation import SMALL_DISTURBANCE, STABILITY, Equation
from rotsolve.core.faults import Span, Unsolvable
from rotsolve.core.lagrangian import GeneralizedCoordinate, Lagrangian
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.symbols import TIME, key_of
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import Meaning, NotYet
from rotsolve.space.arrangement import JointedBodies
from rotsolve.space.lagrangian import MotionsInSpace, course_of
from rotsolve.space.laws import SpaceLaws

if TYPE_CHECKING:
    from rotsolve.search.numbers import Numbers

NO_STATE = "about which steady motion `{}` swings nothing tells"
TELL = "tell a state with `{}.angle`, `steady: true`"
SEEN = "small swings about the hinge in axes that go round with it, I δ̈ = −U″ δ"
ONE_HINGE = "solved is one body on one hinge, and what carries that driven at an `angular_velocity` that stays"


class CarriedSwing(Struct, frozen=True, dict=True):
    """How a body swings on its hinge while what carries that goes round as it is driven; `q` is its angle there."""

    laws: SpaceLaws
    motions: MotionsInSpace
    q: GeneralizedCoordinate

    @property
    def motion(self) -> Lagrangian:
        return self.motions.motion

    @cached_property
    def inertia(self) -> Formula:
        """A = ∂²T/∂q̇²."""
        return self.motion.tidy(total([differentiate(part, self.q.rate) for part in self.motion.momentum(self.q)]))

    @cached_property
    def carried(self) -> list[Formula]:
        """The terms of T₀."""
        return [part.substitute({self.q.rate: ZERO}) for part in self.motion.kinetic]

    @cached_property
    def push(self) -> Formula:
        """−U′(q)."""
        slopes = (self.motion.slope(part, self.q) for part in self.carried)
        return self.motion.tidy(total([*slopes, *self.motion.efforts(self.q)]))

    @cached_property
    def now(self) -> Callable[[Formula], Formula]:
        """What puts in where the body stands, and how fast what carries it goes round."""
        return self.motions.putting_in(self.laws)

    @cached_property
    def slope(self) -> Formula:
        """−U″(q) where the body stands."""
        return self.now(self.motion.slope(self.push, self.q))

    @cached_property
    def growth(self) -> Formula:
        """−U″(q)/A there."""
        return self.motion.tidy(self.slope / self.now(self.inertia))

    @property
    def pushed(self) -> Formula:
        """−U′(q) there."""
        return self.now(self.push)

    @property
    def ground(self) -> Words:
        """U = V − T₀ as a function of the angle, which has the letter of the scene where a state tells it by one."""
        potential = self.motion.potential
        if not potential:
            return ()
        told = self.now(self.q.letter)
        letter = told if isinstance(told, Symbol) else self.motion.page[self.q.letter.name]
        terms = (part.substitute({self.q.letter.name: letter}) for part in (*potential, *map(negate, self.carried)))
        own = [part for part in map(self.now, terms) if part.symbols() & letter.symbols()]
        return ("U = V − T₀ = ", total(own))

    def lasts(self) -> bool:
        """Whether T and the pushes are the same however far what is driven has turned, and at all times."""
        pushes = total(self.motion.efforts(self.q))
        found = (differentiate(value, name) for value in (total(self.motion.kinetic), pushes) for name in self.passing)
        return all(map(is_zero, found))

    @property
    def passing(self) -> list[str]:
        """The letters of places that change while it stands on its hinge."""
        return sorted({*self.motion.turned, TIME} - {self.q.letter.name})


def carried_swing(laws: SpaceLaws, name: str, span: Span | None) -> CarriedSwing:
    """The swing of a body on its hinge; refused by name where more moves than that, or it moves as time goes."""
    chain = carriers_of(laws.moment.held, name)
    refuse_acted_on(laws, name, chain, span)
    motions = MotionsInSpace(course_of(laws), chain, laws.moment)
    try:
        coordinates = motions.motion.coordinates
    except Unsolvable as error:
        raise NotYet(error.fault.message, span, error.fault.help) from error
    for item in motions.free:
        if item.driven and not item.evenly:
            raise NotYet(f"what carries `{name}` does not go round at a steady rate", span, ONE_HINGE)
    own = [q for q in coordinates if key_of(q.letter.name).owner == name and key_of(q.letter.name).kind == "angle"]
    others = [key_of(q.letter.name).owner for q in coordinates if q not in own]
    if others or not own:
        moves = f"`{others[0]}` moves freely too" if others else "it does not turn on a hinge"
        raise NotYet(f"what a small disturbance does to `{name}` is not solved in space: {moves}", span, ONE_HINGE)
    swing = CarriedSwing(laws, motions, own[0])
    if not swing.lasts():
        message = (
            f"what drives `{name}` back changes while what carries it goes round: it has no small swings of one rate"
        )
        raise NotYet(message, span)
    return swing


def carriers_of(held: JointedBodies, name: str) -> tuple[str, ...]:
    """A body and what carries it, as far as the ground; what these carry besides does nothing to it where they are driven."""
    carrier = held.carrier(name)
    return (*(carriers_of(held, carrier) if carrier else ()), name)


def refuse_acted_on(laws: SpaceLaws, name: str, chain: Sequence[str], span: Span | None) -> None:
    """Refuse what acts on a body beside its weight and its hinge, a body that carries others, and one on what is led along."""
    held = laws.moment.held
    acting = [item.name for item in laws.pushes.actions if any(ref.owner == name for ref in item.touches())]
    acting += [joint.owner for joint in held.joints if joint.carrier.owner == name]
    acting += [one for one in chain if held.bodies[one].moved]
    if acting:
        message = f"what a small disturbance does to `{name}` is not solved in space: more than its weight and its hinge acts on it"
        raise NotYet(f"{message}: `{acting[0]}`", span, ONE_HINGE)


def of_carried(laws: SpaceLaws, path: Path) -> Meaning:
    """λ² = −U″(q)/A of what stands on a hinge that is carried round, about the steady motion of its state."""
    name, moment = path.owner, laws.moment
    swing = carried_swing(laws, name, path.span)
    if not moment.state.steady:
        raise NotYet(NO_STATE.format(name), path.span, TELL.format(name))
    refuse_off_balance(swing, name, path)
    return Meaning(
        swing.growth, QUANTITIES["stability"].dimension, label=SEEN, law=SMALL_DISTURBANCE, said=swing.ground
    )


def refuse_off_balance(swing: CarriedSwing, name: str, path: Path) -> None:
    """Refuse a body that turns on its hinge, or that does not stay where it is told to be; what the laws are to find they tell."""
    moment, pushed = swing.laws.moment, swing.pushed
    joint = moment.held.main(name)
    sought = moment.found_in_balance(swing.laws.tensors.spelled(pushed))
    turns = joint is not None and not moment.held.vanishes(moment.rate_on(name, joint))
    if turns or not (sought or moment.held.vanishes(swing.laws.tensors.spelled(pushed))):
        raise NotYet(f"`{name}` is not in equilibrium at `{moment.when}`", path.span, TELL.format(name))


def limit_on_hinge(laws: SpaceLaws, name: str, span: Span | None) -> Equation:
    """Where what hangs on a hinge that is carried round is only just driven back: U″ = 0, at a place that is one of balance anyway."""
    swing = carried_swing(laws, name, span)
    if not laws.moment.held.vanishes(laws.tensors.spelled(swing.pushed)):
        message = f"`{name}` is in balance at `{laws.moment.when}` with some values alone: up to where that is stable is not solved"
        raise NotYet(message, span, f"ask for `{name}.stability`, λ² of a small disturbance")
    words: Words = (f"{SEEN}; U″ = 0",)
    words = (*words, ", ", *swing.ground) if swing.ground else words
    return STABILITY.equation(ZERO, swing.slope, laws.moment.when, (name,), words)


def swings_told_by(name: str, dynamics: Mapping[str, SpaceLaws]) -> Iterator[CarriedSwing]:
    """The bodies that stand steadily on a hinge at an angle which a state tells by a letter; none of those of which no swing is known."""
    for laws in dynamics.values():
        for line in laws.moment.state.conditions if laws.moment.state.steady else ():
            if line.path is None or line.path.quantity != "angle" or line.value is None:
                continue
            if name in line.value.symbols() and laws.moment.hangs_on_hinge(line.path.owner):
                try:
                    yield carried_swing(laws, line.path.owner, None)
                except NotYet:
                    continue


def stable_places(
    name: str, roots: Sequence[Formula], dynamics: Mapping[str, SpaceLaws], numbers: Numbers
) -> list[int]:
    """Which values of a letter for an angle are places to which the body comes back; none where that is not looked at."""
    swings = list(swings_told_by(name, dynamics))
    if len(swings) != 1:
        return []
    growth = swings[0].laws.tensors.spelled(swings[0].growth)
    return [k for k, root in enumerate(roots) if numbers.side(growth.substitute({name: root})) == -1]
