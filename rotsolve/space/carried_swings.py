"""Swings of what hangs on a hinge, or nods with a rotor on it, seen from what carries that round steadily: by an effective potential.

With q the angle on the hinge, T = ½ A q̇² + B(q) q̇ + T₀(q): A is the moment of inertia about the hinge, T₀ = ½ J(q) w² the energy of
what only goes round with the carrier, and B(q) q̇ the rate of a function of q. So A q̈ = −U′(q) with U = V − T₀, and at U′ = 0 a small
displacement δ has δ̈ = −(U″/A) δ (Taylor, Classical Mechanics, §7.6 and example 7.7; Goldstein, Poole & Safko, Classical Mechanics, §2.7).

Rotors on it and free carriers have coordinates x that do not occur in T and V: p = ∂T/∂ẋ is conserved, and Routh's function L − p ẋ takes
the place of L (Goldstein, Poole & Safko, Classical Mechanics, §8.3). To second order that is to eliminate δẋ by δp = 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula, Symbol, multiply, negate, total
from rotsolve.core.derivation import Words
from rotsolve.core.equation import SMALL_DISTURBANCE, STABILITY, Equation
from rotsolve.core.faults import Span, Unsolvable
from rotsolve.core.lagrangian import GeneralizedCoordinate, Lagrangian
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.symbols import TIME, key_of
from rotsolve.core.vectors.triple import square
from rotsolve.core.writing import and_joined, flat
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import Meaning, NotYet
from rotsolve.space.arrangement import JointedBodies
from rotsolve.space.lagrangian import MotionsInSpace, course_of
from rotsolve.space.laws import SpaceLaws

if TYPE_CHECKING:
    from rotsolve.search.numbers import Numbers

NO_STATE = "about which steady motion `{}` swings nothing tells"
TELL = "tell a state with `{}.{}`, `steady: true`"
ON_HINGE, NODDING = "small swings about the hinge", "small nutations"
SEEN = f"{ON_HINGE} in axes that go round with it, I δ̈ = −U″ δ"
KEPT_BESIDE = "{}, p = ∂T/∂ẋ of {} conserved, I δ̈ = −U″ δ"
LOCKED = "two ways in which what moves with `{}` turns are one there: what a small disturbance does is not solved"
DRIVE = "what spins about the line of another axis may be driven at an `angular_velocity`"
ONE_HINGE = (
    "solved is one body on one hinge, or at one tilt, with what spins on it, and what carries that driven at an `angular_velocity` that "
    "stays, or free where its momentum is conserved"
)


class CarriedSwing(Struct, frozen=True, dict=True):
    """How a body swings on its hinge while what carries that goes round: `q` is its angle, ∂T/∂ẋ of the `kept` coordinates x stay."""

    laws: SpaceLaws
    motions: MotionsInSpace
    q: GeneralizedCoordinate
    kept: tuple[GeneralizedCoordinate, ...] = ()

    @property
    def motion(self) -> Lagrangian:
        return self.motions.motion

    @property
    def word(self) -> str:
        """What the angle is called: that of a hinge, or a tilt."""
        return key_of(self.q.letter.name).kind

    @cached_property
    def inertia(self) -> Formula:
        """A where the body stands: ∂²T/∂q̇² with rates of the kept coordinates by which their momenta stay."""
        rates = (*self.counted, self.q)
        return self.beside_kept([[self.now(self.mass(one, other)) for other in rates] for one in rates])

    @cached_property
    def carried(self) -> list[Formula]:
        """The terms of T₀, with the rates of the kept coordinates."""
        return [part.substitute({self.q.rate: ZERO}) for part in self.motion.kinetic]

    @cached_property
    def push(self) -> Formula:
        """−U′(q), by the rates of the kept coordinates."""
        slopes = (self.motion.slope(part, self.q) for part in self.carried)
        return self.motion.tidy(total([*slopes, *self.motion.efforts(self.q)]))

    @cached_property
    def now(self) -> Callable[[Formula], Formula]:
        """What puts in where the body stands, and how fast what carries it goes round."""
        return self.motions.putting_in(self.laws)

    @cached_property
    def slope(self) -> Formula:
        """−U″(q) where the body stands: δ(−U′) by δq, with the δẋ by which the momenta ∂T/∂ẋ stay."""
        kept = self.counted
        along = [self.now(differentiate(self.push, x.rate)) for x in kept]  # ∂²T/∂q∂ẋ
        rows = [[*(self.now(self.mass(x, other)) for other in kept), part] for x, part in zip(kept, along, strict=True)]
        return self.beside_kept([*rows, [*along, self.now(self.motion.slope(self.push, self.q))]])

    def mass(self, one: GeneralizedCoordinate, other: GeneralizedCoordinate) -> Formula:
        """∂²T/∂q̇∂ẋ of two coordinates."""
        return total([differentiate(part, other.rate) for part in self.motion.momentum(one)])

    @cached_property
    def counted(self) -> tuple[GeneralizedCoordinate, ...]:
        """The kept coordinates without those that have no inertia beside the others, however the body stands: of a light frame about the
        axle of a rotor."""
        found: tuple[GeneralizedCoordinate, ...] = ()
        for x in self.kept:
            both = (*found, x)
            found = found if is_zero(complement([[self.mass(a, b) for b in both] for a in both])) else both
        return found

    def beside_kept(self, rows: Sequence[Sequence[Formula]]) -> Formula:
        """The last entry of a symmetric form where the other variables make it stationary; refused where these are not told apart there."""
        for count in range(1, len(rows)):
            pivot = complement([row[:count] for row in rows[:count]])
            if self.laws.moment.held.vanishes(self.laws.tensors.spelled(pivot)):
                name = key_of(self.q.letter.name).owner
                raise NotYet(LOCKED.format(name), self.laws.moment.state.span, DRIVE)
        return self.motion.tidy(complement(rows))

    @cached_property
    def growth(self) -> Formula:
        """−U″(q)/A there."""
        return self.motion.tidy(self.slope / self.inertia)

    @property
    def pushed(self) -> Formula:
        """−U′(q) there."""
        return self.now(self.push)

    @property
    def ground(self) -> Words:
        """U = V − T₀ as a function of the angle, which has the letter of the scene where a state tells it by one."""
        potential = self.motion.potential
        told = self.now(self.q.letter)
        if potential is None or len(self.kept) > 1 or (self.kept and isinstance(told, Symbol)):
            return ()  # a momentum that is kept would hold that letter too
        letter = told if isinstance(told, Symbol) else self.motion.page[self.q.letter.name]
        spelled = [self.now(part.substitute({self.q.letter.name: letter})) for part in (*potential, *self.routhian())]
        terms = flat([self.motion.tidy(total(spelled))]) if self.kept else spelled
        own = [part for part in terms if part.symbols() & letter.symbols()]
        return (f"U = V − T₀ {'+ p ẋ ' if self.kept else ''}= ", total(own)) if own else ()

    def routhian(self) -> Iterator[Formula]:
        """The terms of −T₀, or of p ẋ − T₀ where p = ∂T/∂ẋ is kept as it is where the body stands: of T₀ = c + b ẋ + ½ M ẋ² those of
        (p − b)²/2 M − c."""
        still = {x.rate: ZERO for x in self.kept}
        yield from (negate(part.substitute(still)) for part in self.carried)
        for x in self.kept:
            momentum = total([differentiate(part, x.rate) for part in self.carried])
            gap, mass = self.now(momentum) - momentum.substitute(still), differentiate(momentum, x.rate)
            yield ZERO if is_zero(mass) else square(gap) / (2 * mass)

    @property
    def label(self) -> str:
        """What is written of the swings, with what is conserved."""
        if not self.kept:
            return SEEN
        swings = NODDING if self.word == "tilt" else ON_HINGE
        return KEPT_BESIDE.format(swings, and_joined([f"the {x.words}" for x in self.kept]))

    def lasts(self) -> bool:
        """Whether T and the pushes are the same however far what is driven has turned, and at all times."""
        pushes = total(self.motion.efforts(self.q))
        found = (differentiate(value, name) for value in (total(self.motion.kinetic), pushes) for name in self.passing)
        return all(map(is_zero, found))

    @property
    def passing(self) -> list[str]:
        """The letters of places that change while it stands on its hinge."""
        return sorted({*self.motion.turned, TIME} - {self.q.letter.name})


def complement(rows: Sequence[Sequence[Formula]]) -> Formula:
    """The last entry of a symmetric form where the other variables make it stationary (Schur)."""
    (pivot, *own), *rest = rows
    if not rest:
        return pivot
    return complement(
        [[part - multiply(row[0], beside) / pivot for part, beside in zip(row[1:], own, strict=True)] for row in rest]
    )


def carried_swing(laws: SpaceLaws, name: str, span: Span | None) -> CarriedSwing:
    """The swing of a body on its hinge; refused by name where more moves than that, or it moves as time goes."""
    chain, moving = swinging_together(laws.moment.held, name)
    refuse_acted_on(laws, name, chain, moving, span)
    motions = MotionsInSpace(course_of(laws), (*chain, *moving), laws.moment)
    try:
        coordinates = motions.motion.coordinates
    except Unsolvable as error:
        raise NotYet(error.fault.message, span, error.fault.help) from error
    for item in motions.free:
        if item.driven and not item.evenly:
            raise NotYet(
                f"what carries `{name}`, or what it carries, does not go round at a steady rate", span, ONE_HINGE
            )
    keys = {q: key_of(q.letter.name) for q in coordinates}
    own = [q for q, key in keys.items() if key.owner == name and key.kind in ("angle", "tilt")]
    kept = tuple(q for q in coordinates if q not in own)
    others = [keys[q].owner for q in kept if not motions.motion.cyclic(q)]
    if others or not own:
        moves = f"`{others[0]}` moves freely too" if others else "it does not turn on a hinge"
        raise NotYet(f"what a small disturbance does to `{name}` is not solved in space: {moves}", span, ONE_HINGE)
    swing = CarriedSwing(laws, motions, own[0], kept)
    if not swing.lasts():
        message = (
            f"what drives `{name}` back changes while what carries it goes round: it has no small swings of one rate"
        )
        raise NotYet(message, span)
    return swing


def swinging_together(held: JointedBodies, name: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What carries a body and is driven, from the ground on, and all that moves with it: from the first that is free, what that carries."""
    chain = carriers_of(held, name)
    joints = map(held.main, chain)
    first = next((k for k, joint in enumerate(joints) if joint is not None and not joint.drive), len(chain) - 1)
    carried = tuple(one for one in held.order if chain[first] in carriers_of(held, one))
    return chain[:first], carried


def carriers_of(held: JointedBodies, name: str) -> tuple[str, ...]:
    """A body and what carries it, as far as the ground."""
    carrier = held.carrier(name)
    return (*(carriers_of(held, carrier) if carrier else ()), name)


def refuse_acted_on(laws: SpaceLaws, name: str, chain: Sequence[str], moving: Sequence[str], span: Span | None) -> None:
    """Refuse what acts on what moves beside weights and joints, what touches it without being carried, and what is led along."""
    held = laws.moment.held
    acting = [item.name for item in laws.pushes.actions if any(ref.owner in moving for ref in item.touches())]
    acting += [
        joint.owner for joint in held.joints if joint.carrier.owner in moving and joint != held.main(joint.body.owner)
    ]
    weightless = laws.pushes.gravity is None
    acting += [
        one for one in (*chain, *moving) if held.bodies[one].moved and not (weightless and turns_evenly(held, one))
    ]
    if acting:
        message = f"what a small disturbance does to `{name}` is not solved in space: more than its weight and its hinge acts on it"
        raise NotYet(f"{message}: `{acting[0]}`", span, ONE_HINGE)


def turns_evenly(held: JointedBodies, name: str) -> bool:
    """Whether a body that nothing holds is led round at one angular velocity that stays, which is the same along its own axes then."""
    told = [(word, TIME in part.symbols()) for word, _, part in held.bodies[name].moved]
    return held.main(name) is None and all(item == ("angular_velocity", False) for item in told)


def of_carried(laws: SpaceLaws, path: Path) -> Meaning:
    """λ² = −U″(q)/A of what stands on a hinge that is carried round, about the steady motion of its state."""
    name, moment = path.owner, laws.moment
    swing = carried_swing(laws, name, path.span)
    if not moment.state.steady:
        raise NotYet(NO_STATE.format(name), path.span, TELL.format(name, swing.word))
    refuse_off_balance(swing, name, path)
    return Meaning(
        swing.growth, QUANTITIES["stability"].dimension, label=swing.label, law=SMALL_DISTURBANCE, said=swing.ground
    )


def refuse_off_balance(swing: CarriedSwing, name: str, path: Path) -> None:
    """Refuse a body that turns on its hinge, or that does not stay where it is told to be; what the laws are to find they tell."""
    moment, pushed = swing.laws.moment, swing.laws.tensors.spelled(swing.pushed)
    nodding = moment.told(name, "nutation")
    stands = nodding is None or moment.held.vanishes(nodding) if swing.word == "tilt" else moment.swings_on(name)
    if not stands or not (moment.found_in_balance(pushed) or moment.held.vanishes(pushed)):
        raise NotYet(f"`{name}` is not in equilibrium at `{moment.when}`", path.span, TELL.format(name, swing.word))


def limit_on_hinge(laws: SpaceLaws, name: str, span: Span | None) -> Equation:
    """Where what hangs on a hinge that is carried round is only just driven back: U″ = 0, at a place that is one of balance anyway."""
    swing = carried_swing(laws, name, span)
    if not laws.moment.held.vanishes(laws.tensors.spelled(swing.pushed)):
        message = f"`{name}` is in balance at `{laws.moment.when}` with some values alone: up to where that is stable is not solved"
        raise NotYet(message, span, f"ask for `{name}.stability`, λ² of a small disturbance")
    words: Words = (f"{swing.label}; U″ = 0",)
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
