"""Laws in space with a mistake in them: with another tensor, L along ω, or without Ω × L.

Each is what writes the laws of some bodies in place of `SpaceLaws`; of all others it writes the right ones.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import partial
from typing import Any

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Formula, add, negate
from rotsolve.core.symbols import has_quantities
from rotsolve.core.vectors.tensor import ENTRIES, ONE_AXIS, InertiaTensor
from rotsolve.core.vectors.triple import NOTHING, Triple, dot_product, square_of
from rotsolve.language.bodies import PointRef
from rotsolve.space.inertia import CM, entry_along, product, round_about_way
from rotsolve.space.laws import SpaceLaws


class MistakenLaws(SpaceLaws):
    """The laws, with a mistake in those of some bodies."""

    def __init__(self, names: Collection[str], *moment: Any, **options: Any) -> None:
        super().__init__(*moment, **options)
        self.names = names

    @classmethod
    def of(cls, names: Collection[str]) -> Callable[..., SpaceLaws]:
        """What writes these laws, for `Alteration`."""
        return partial(cls, names)

    def told_tensor(self, ref: PointRef) -> InertiaTensor:
        """The tensor of a body about the point about which it is told: that of its own inertia, else its centre of mass."""
        place = self.tensors.told_about(ref.owner)
        return self.tensors.about(ref.owner, place, self.moment.held.bodies[ref.owner].inertia_about or CM)


class OppositeProducts(MistakenLaws):
    """+Σ m x y for the entries −Σ m x y."""

    def own_tensor(self, ref: PointRef) -> InertiaTensor:
        right = super().own_tensor(ref)
        if ref.owner not in self.names:
            return right
        return entry_by_entry(lambda word: right.entry(word) if word in ONE_AXIS else negate(right.entry(word)))


class UnmovedTensor(MistakenLaws):
    """The tensor as it is told about one point, taken for that about another one."""

    def own_tensor(self, ref: PointRef) -> InertiaTensor:
        return self.told_tensor(ref) if ref.owner in self.names else super().own_tensor(ref)


class MovedTheOtherWay(MistakenLaws):
    """I − M d² for I + M d²."""

    def own_tensor(self, ref: PointRef) -> InertiaTensor:
        right = super().own_tensor(ref)
        if ref.owner not in self.names:
            return right
        told = self.told_tensor(ref)
        if right == told:
            return right
        # in givens, since a step of the derivation stands for each right entry
        return entry_by_entry(lambda word: self.tensors.spelled(2 * told.entry(word) - right.entry(word)))


class ExchangedMoments(MistakenLaws):
    """The moment across the axis of a symmetric body for that about it, and the other way round, where they are told."""

    def own_tensor(self, ref: PointRef) -> InertiaTensor:
        right, held = super().own_tensor(ref), self.moment.held
        axis = held.axis(ref.owner)
        if ref.owner not in self.names or axis is None or not held.symmetric(ref.owner, axis):
            return right
        told = self.told_tensor(ref)
        across = (axis[1], axis[2], axis[0])
        other = round_about_way(axis, entry_along(told, across), entry_along(told, axis))
        if right == told:
            return other
        shifted = entry_by_entry(lambda word: add(right.entry(word), negate(told.entry(word))))
        return entry_by_entry(lambda word: self.tensors.spelled(add(other.entry(word), shifted.entry(word))))


class MomentumAlongRate(MistakenLaws):
    """L = I ω with the one moment of inertia about the line of ω, nᵀ I n."""

    def tensor(self, name: str, point: str) -> InertiaTensor:
        right, omega = super().tensor(name, point), self.moment.attitude(name).omega
        known = omega != NOTHING and not any(map(has_quantities, omega))
        if name not in self.names or not known or self.moment.held.carrier(name) or self.moment.nods(name):
            return right
        moment = simplify(dot_product(omega, product(right, omega)) / square_of(omega))
        return InertiaTensor(moment, moment, moment)


class WithoutCarrying(MistakenLaws):
    """dL/dt by the rates of the components alone."""

    def carried_round(self, name: str, vector: Triple) -> Triple:
        return NOTHING if name in self.names else super().carried_round(name, vector)


def entry_by_entry(entry: Callable[[str], Formula]) -> InertiaTensor:
    """The tensor with these entries."""
    return InertiaTensor(*(entry(word) for word in ENTRIES))
