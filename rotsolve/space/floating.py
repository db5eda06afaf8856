"""Floating: what bodies that carry each other and that nothing else holds keep: their angular momentum about their common centre of mass.

L = Σ I ω + Σ m r × u − (Σ m r) × (Σ m u)/M, with places and velocities from the centre of mass of the first of them, which may go anyhow.
It stays in space; where nothing tells how they stand, its size stays, and one that was nothing is nothing along any axes.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.formula import HALF, ONE, ZERO, Formula, add, multiply, negate, total
from rotsolve.core.equation import CONSERVATION, FROM_STATE_TO_STATE, MOMENTUM, Equation
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Triple,
    cross_product,
    minus,
    scaled_by,
    square_of,
    triple,
    vector_sum,
)
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.motion.timeline import Interval
from rotsolve.space.attitude import IN_SPACE
from rotsolve.space.energies import half_quadratic
from rotsolve.space.inertia import CM, product
from rotsolve.space.laws import SpaceLaws


class FloatingTogether(Struct, frozen=True):
    """Bodies of which the first carries all others, each by one joint."""

    names: tuple[str, ...]
    inner: tuple[Joint, ...]

    def kept(self, interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
        """Their angular momentum, and without motors their energy beside that with which they travel."""
        *most, last_name = map(spoken, self.names)
        whole = f"{', '.join(most)} and {last_name}"
        for words, first, last in self.momenta(before, after):
            if first != last:
                size, along = words
                label = f"{size}angular momentum of {whole} about their centre of mass{along}"
                yield MOMENTUM.equation(first, last, interval.name, self.names, words=label)
        if not any(joint.powered for joint in self.inner):
            first, last = (self.energy(laws) for laws in (before, after))
            if first != last:
                since = f" of {whole} about their centre of mass"
                yield CONSERVATION.equation(
                    first, last, interval.name, self.names, since=since, form=FROM_STATE_TO_STATE
                )

    def momenta(self, before: SpaceLaws, after: SpaceLaws) -> Iterator[tuple[tuple[str, str], Formula, Formula]]:
        """What stays of the angular momentum, before and after, with the words in front of and behind it."""
        ends = [self.momentum(laws) for laws in (before, after)]
        axes = [laws.moment.axes(self.names[0]) for laws in (before, after)]
        if all(map(before.moment.held.vanishes, ends[0])):
            for axis, last in zip(AXES, ends[1], strict=True):
                yield ("", f", along the {axis} axis of {spoken(self.names[0])}"), ZERO, last
        elif any(one.lost for one in axes):
            yield ("size of the ", ""), square_of(ends[0]), square_of(ends[1])
        else:
            seen = [one.to(IN_SPACE, vector) for one, vector in zip(axes, ends, strict=True)]
            yield from ((("", f", along {axis}"), a, b) for axis, a, b in zip(AXES, *seen, strict=True))

    def momentum(self, laws: SpaceLaws) -> Triple:
        """L about the common centre of mass, along the axes of the first."""
        moment, axes = laws.moment, laws.moment.axes(self.names[0])
        turning, placed, going, mass = NOTHING, NOTHING, NOTHING, total([moment.held.mass(name) for name in self.names])
        for name in self.names:
            own, place, speed = moment.attitude(name), *self.from_first(name, laws)
            heavy = moment.held.mass(name)
            spin = NOTHING if moment.held.pointlike(name) else product(laws.tensor(name, CM), own.omega)
            swept = vector_sum(spin, cross_product(place, scaled_by(heavy, speed)))
            turning = vector_sum(turning, own.axes.to(axes, swept))
            placed = vector_sum(placed, own.axes.to(axes, scaled_by(heavy, place)))
            going = vector_sum(going, own.axes.to(axes, scaled_by(heavy, speed)))
        whole = vector_sum(turning, minus(scaled_by(ONE / mass, cross_product(placed, going))))
        return triple([moment.tidy(part) for part in whole])

    def energy(self, laws: SpaceLaws) -> Formula:
        """½ Σ (ω · I ω + m u²) − ½ (Σ m u)²/M."""
        moment, axes, going = laws.moment, laws.moment.axes(self.names[0]), NOTHING
        parts, mass = list[Formula](), total([moment.held.mass(name) for name in self.names])
        for name in self.names:
            own, (_, speed), heavy = moment.attitude(name), self.from_first(name, laws), moment.held.mass(name)
            if not moment.held.pointlike(name):
                parts.append(half_quadratic(laws.tensor(name, CM), own.omega))
            parts.append(multiply(multiply(HALF, heavy), square_of(speed)))
            going = vector_sum(going, own.axes.to(axes, scaled_by(heavy, speed)))
        return moment.tidy(add(total(parts), negate(multiply(HALF, square_of(going)) / mass)))

    def line(self, laws: SpaceLaws) -> Triple | None:
        """The own direction about which the first has turned since all was at rest, whatever motors do: that of all axles on it, where that
        is a principal axis of the whole; None where there is none."""
        held, moment, first = laws.moment.held, laws.moment, self.names[0]
        wheels = all(joint.carrier.owner == first and held.wheel(joint.body.owner) for joint in self.inner)
        if not wheels or not (all(map(moment.rests, self.names)) or first in moment.lines):
            return None
        ways = [moment.direction(joint.body.owner, joint) for joint in self.inner]
        across = [
            cross_product(ways[0], self.inertia_along(ways[0], laws)),
            *(cross_product(ways[0], way) for way in ways),
        ]
        return ways[0] if all(held.vanishes(laws.tensors.spelled(part)) for way in across for part in way) else None

    def inertia_along(self, way: Triple, laws: SpaceLaws) -> Triple:
        """I n of the whole about the common centre of mass: Σ I n + m r × (n × r), less that of all mass where its centre is."""
        masses, whole, placed = laws.moment.held.mass, NOTHING, NOTHING
        for name in self.names:
            place, heavy = self.from_first(name, laws)[0], masses(name)
            own = NOTHING if laws.moment.held.pointlike(name) else product(laws.tensor(name, CM), way)
            whole = vector_sum(whole, own, scaled_by(heavy, cross_product(place, cross_product(way, place))))
            placed = vector_sum(placed, scaled_by(heavy, place))
        less = cross_product(placed, cross_product(way, placed))
        return vector_sum(whole, minus(scaled_by(ONE / total([masses(name) for name in self.names]), less)))

    def from_first(self, name: str, laws: SpaceLaws) -> tuple[Triple, Triple]:
        """Where the centre of mass of a body is from that of the first, and how fast it goes away from that, along its own axes."""
        moment, centre = laws.moment, PointRef(name, CM)
        place, speed = self.held_from_first(name, laws)
        arm, omega = moment.arm(centre), moment.attitude(name).omega
        return vector_sum(place, arm), vector_sum(speed, cross_product(omega, arm))

    def held_from_first(self, name: str, laws: SpaceLaws) -> tuple[Triple, Triple]:
        """The same of the point at which it is held."""
        joint = next((joint for joint in self.inner if joint.body.owner == name), None)
        if joint is None:
            return NOTHING, NOTHING
        moment, carrier = laws.moment, joint.carrier.owner
        place, speed = self.held_from_first(carrier, laws)
        arm, omega = moment.arm(joint.carrier), moment.attitude(carrier).omega
        parts = vector_sum(place, arm), vector_sum(speed, cross_product(omega, arm))
        axes, own = moment.axes(carrier), moment.axes(name)
        return axes.to(own, parts[0]), axes.to(own, parts[1])
