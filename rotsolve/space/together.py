"""Together: what bodies on joints of each other keep from state to state: their energy, and their angular momentum about what is free.

Joints between them, ideal ones, give no power; their forces are opposite and equal at one place, so that they change no sum of angular
momenta (Goldstein, Poole & Safko, Classical Mechanics, §1.2). About what the ground holds a weight has no torque along the vertical.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.formula import ZERO, Formula, total
from rotsolve.core.equation import CONSERVATION, FROM_STATE_TO_STATE, MOMENTUM, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.triple import NOTHING, Triple, Z, cross_product, dot_product, scaled_by, vector_sum
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.space.attitude import IN_SPACE
from rotsolve.space.energies import energy_of
from rotsolve.space.floating import FloatingTogether
from rotsolve.space.inertia import CM, product
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.working import carried_with, turns_undriven


class HeldTogether(Struct, frozen=True):
    """Bodies that hold each other, each held by one joint, and the joint by which the ground holds the first of them."""

    names: tuple[str, ...]
    root: Joint
    inner: tuple[Joint, ...]

    def kept(self, interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
        """Their energy, and their angular momentum about the direction about which nothing outside turns them.

        What is driven steadily keeps its energy in the frame that turns with it (space/turning_frame).
        """
        whole, way = in_a_list(self.names), self.untwisted(before)
        if way is not None and not self.root.powered:
            first, last = (self.momentum(laws, way) for laws in (before, after))
            if first != last:
                words = f"angular momentum about {'the vertical' if way == Z else 'the axis'}, {whole}"
                yield MOMENTUM.equation(first, last, interval.name, self.names, words=words)
        if self.root.powered or any(joint.powered for joint in self.inner) or self.swings_as_one(before):
            return
        first, last = (total([energy_of(laws, name) for name in self.names]) for laws in (before, after))
        if first != last:
            yield CONSERVATION.equation(
                first, last, interval.name, self.names, since=f" of {whole}", form=FROM_STATE_TO_STATE
            )

    def swings_as_one(self, laws: SpaceLaws) -> bool:
        """Whether they go round on a hinge with what is fast on the first of them, of which the energy is told already."""
        return turns_undriven(self.root) and carried_with(laws, self.names[0]) is not None

    def untwisted(self, laws: SpaceLaws) -> Triple | None:
        """The direction in space, through the point that the ground holds, about which neither the joint there nor a weight turns them."""
        moment, gravity = laws.moment, laws.pushes.gravity
        if self.root.free:
            return Z
        if not self.root.turning:
            return None
        name = self.names[0]
        way = moment.axes(name).to(IN_SPACE, moment.direction(name, self.root))
        return way if gravity is None or way[:2] == (ZERO, ZERO) else None

    def momentum(self, laws: SpaceLaws, way: Triple) -> Formula:
        """n · Σ (I ω + r × m v), r from the point that the ground holds, of each body along its own axes."""
        moment, parts = laws.moment, list[Formula]()
        for name in self.names:
            along, centre = IN_SPACE.to(moment.axes(name), way), PointRef(name, CM)
            fixed = laws.fixed(name) and not moment.held.pointlike(name)
            spin = own_spin(laws, name, laws.about(name)[1] if fixed else CM)
            travel = scaled_by(ZERO if fixed else moment.held.mass(name), moment.velocity(centre))
            arm = vector_sum(self.place(name, laws), moment.arm(centre))
            parts.append(dot_product(along, vector_sum(spin, cross_product(arm, travel))))
        return moment.tidy(total(parts))

    def place(self, name: str, laws: SpaceLaws) -> Triple:
        """The point about which a body turns, from that which the ground holds, along the body's own axes."""
        moment = laws.moment
        joint = next((joint for joint in self.inner if joint.body.owner == name), None)
        if joint is None:
            return NOTHING
        carrier = joint.carrier.owner
        held = vector_sum(self.place(carrier, laws), moment.carried_at(joint))
        return moment.axes(carrier).to(moment.axes(name), held)


def own_spin(laws: SpaceLaws, name: str, point: str) -> Triple:
    """I ω of a body about one of its points, in its own axes; nothing of a particle."""
    pointlike = laws.moment.held.pointlike(name)
    return NOTHING if pointlike else product(laws.tensor(name, point), laws.moment.attitude(name).omega)


def in_a_list(names: tuple[str, ...]) -> str:
    """ "arm and rod", "arm, rod and disc"."""
    *most, last = map(spoken, names)
    return f"{', '.join(most)} and {last}"


def hanging_together(laws: SpaceLaws) -> Iterator[HeldTogether | FloatingTogether]:
    """All that hold together by ideal joints, on one joint of the ground or on none, and on which nothing acts but their weights."""
    held = laws.moment.held
    acted = {ref.owner for action in laws.pushes.actions for ref in action.touches()}
    for first in held.order:
        root = held.main(first)
        if held.carrier(first):
            continue
        names = [first]
        for name in held.order:
            names += [name] if held.carrier(name) in names else []
        joints = [joint for name in names for joint in held.of_body(name)]
        each = [joint.body.owner for joint in joints] == (names if root is not None else names[1:])
        moved = any(held.bodies[name].moved for name in names)
        if len(names) < 2 or moved or not each or any(map(keeps_nothing, joints)) or not acted.isdisjoint(names):
            continue
        if root is None:
            yield FloatingTogether(tuple(names), tuple(joints))
        else:
            yield HeldTogether(tuple(names), root, tuple(joints[1:]))


def lines_of_turning(laws: SpaceLaws) -> dict[str, Triple]:
    """The bodies that nothing holds and that turn on about one of their own directions, with that."""
    floating = (group for group in hanging_together(laws) if isinstance(group, FloatingTogether))
    return {group.names[0]: way for group in floating if (way := group.line(laws)) is not None}


def keeps_nothing(joint: Joint) -> bool:
    """Whether a joint touches a surface, or lets its body slide and turn at once."""
    turns = bool(joint.turning) or joint.free
    return bool(joint.rolls or joint.flat or (joint.sliding and turns)) or joint.pitch is not None


def kept_together(interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """What such bodies keep in a phase, as far as it is told how they stand."""
    for group in hanging_together(before):
        try:
            yield from list(group.kept(interval, before, after))
        except (Unsolvable, NotYet):
            continue
