"""Branches: what a blow changes of bodies that hang together on joints: their momentum and their angular momentum, without the impulses of
the joints within.

All that a joint carries, by whatever joints, takes no angular impulse about the free axis of that joint but from outside; bodies that
nothing holds take none about their common centre of mass, nor an impulse (Goldstein, Poole & Safko, Classical Mechanics, §1.2).
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, ZERO, Formula, total
from rotsolve.core.equation import BLOWS, MOMENTUM, TWISTS, Equation, Law
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Triple,
    cross_product,
    dot_product,
    minus,
    scaled_by,
    vector_sum,
    way_between,
)
from rotsolve.core.writing import and_joined, spoken
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.space.inertia import CM, product
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.struck import Impact
from rotsolve.space.together import keeps_nothing


class Linkage(Struct, frozen=True):
    """A body with all that it carries, and the joint that holds it, if any; vectors are along the axes of that body after the blow, places
    from the point about which it turns."""

    names: tuple[str, ...]
    joint: Joint | None
    blow: Impact

    def laws(self) -> Iterator[Equation]:
        """What the blow changes of them."""
        yield from self.afloat() if self.joint is None else self.on_joint(self.joint)

    def on_joint(self, joint: Joint) -> Iterator[Equation]:
        """Their angular momentum about the point that a joint holds, along the directions about which it lets them turn."""
        after, first = self.blow.after, self.names[0]
        where = f" about {spoken(first)}'s {joint.body.point or 'centre'}"
        place, push = self.struck()
        changes = cross_product(place, push), *self.momenta(NOTHING)
        way = None if joint.free else after.pushes.direction(joint)
        if way is not None:
            yield from self.one(TWISTS, f"{where}, along the axis", *(dot_product(way, vector) for vector in changes))
        for axis, *parts in zip(AXES, *changes, strict=True) if joint.free else ():
            yield from self.one(TWISTS, f"{where}, along {after.along(first, axis)}", *parts)

    def afloat(self) -> Iterator[Equation]:
        """Their momentum, and their angular momentum about their common centre of mass."""
        after, first, mass = self.blow.after, self.names[0], self.blow.after.moment.held.mass
        place, push = self.struck()
        placed = vector_sum(*(scaled_by(mass(name), self.place(name)) for name in self.names))
        centre = scaled_by(ONE / total([mass(name) for name in self.names]), placed)
        ends = (vector_sum(*(scaled_by(mass(name), speeds[k]) for name, speeds in self.speeds())) for k in range(2))
        for axis, *parts in zip(AXES, push, *ends, strict=True):
            yield from self.one(BLOWS, f", along {after.along(first, axis)}", *parts)
        twist = cross_product(way_between(centre, place), push)
        for axis, *parts in zip(AXES, twist, *self.momenta(centre), strict=True):
            where = f" about their centre of mass, along {after.along(first, axis)}"
            yield from self.one(TWISTS, where, *parts)

    def one(self, law: Law, where: str, *changes: Formula) -> Iterator[Equation]:
        """A law of what is taken, and what there is before and after; where nothing from outside has a part in it, that is kept."""
        tidy, section, whole = (
            self.blow.after.moment.tidy,
            self.blow.interval.name,
            and_joined([*map(spoken, self.names)]),
        )
        taken, old, new = map(tidy, changes)
        if taken == ZERO and old != new:
            kind = "momentum" if law is BLOWS else "angular momentum"
            yield MOMENTUM.equation(old, new, section, self.names, words=f"{kind} of {whole}{where}")
        elif taken != ZERO:
            found = law.equation(taken, tidy(new - old), section, self.names, about="")
            yield replace(found, label=law.words.format(body=whole, about="") + where)

    # what they have

    def seen(self, name: str, vector: Triple) -> Triple:
        """A vector along the axes of a body, along those of the first."""
        moment = self.blow.after.moment
        return moment.axes(name).to(moment.axes(self.names[0]), vector)

    def place(self, name: str) -> Triple:
        """Where the centre of mass of a body is."""
        moment, at = self.blow.after.moment, name
        place = self.seen(name, moment.arm(PointRef(name, CM)))
        while at != self.names[0]:
            joint = moment.held.main(at)
            assert joint is not None
            at = joint.carrier.owner
            place = vector_sum(place, self.seen(at, moment.carried_at(joint)))
        return place

    def speeds(self) -> Iterator[tuple[str, tuple[Triple, Triple]]]:
        """The velocity of the centre of mass of each, before and after."""
        for name in self.names:
            before, after = self.blow.speeds(name)
            yield name, (self.seen(name, before), self.seen(name, after))

    def momenta(self, about: Triple) -> tuple[Triple, Triple]:
        """Σ I ω + r × m v about a place, before and after; of the first on the ground I ω about the point held."""
        ends, first, mass = [NOTHING, NOTHING], self.names[0], self.blow.after.moment.held.mass
        whole = [(name, speeds) for name, speeds in self.speeds()]
        drifts = whole[0][1] if self.joint is None else (NOTHING, NOTHING)  # with which all go besides
        for name, speeds in whole:
            arm = way_between(about, self.place(name))
            for k, laws in enumerate((self.blow.before, self.blow.after)):
                if name == first and self.joint is not None and self.blow.after.fixed(first):
                    own = self.of_first(laws)
                else:
                    going = vector_sum(speeds[k], minus(drifts[k]))
                    own = vector_sum(self.spin(name, laws), cross_product(arm, scaled_by(mass(name), going)))
                ends[k] = vector_sum(ends[k], own)
        return ends[0], ends[1]

    def of_first(self, laws: SpaceLaws) -> Triple:
        """L of the first about the point that the ground holds; nothing of a particle that is there."""
        first, after = self.names[0], self.blow.after
        if after.moment.held.pointlike(first):
            return NOTHING
        return after.momentum(first, after.about(first)[1]) if laws is after else self.blow.momentum_before(first)

    def spin(self, name: str, laws: SpaceLaws) -> Triple:
        """I ω about the centre of mass; nothing of a particle."""
        if laws.moment.held.pointlike(name):
            return NOTHING
        own = product(laws.tensor(name, CM), laws.moment.attitude(name).omega)
        return self.seen(name, own if laws is self.blow.after else self.blow.seen_after(name, own))

    def struck(self) -> tuple[Triple, Triple]:
        """Where they are struck from outside, and how."""
        event, moment = self.blow.interval.event, self.blow.after.moment
        found = None if event is None else event.blow_in_space()
        shock = None if found is None or found[0].owner not in self.names else self.blow.outside(found[0].owner)
        if found is None or shock is None:
            return NOTHING, NOTHING
        name = found[0].owner
        off = self.seen(name, way_between(moment.arm(PointRef(name, CM)), shock.arm))
        return vector_sum(self.place(name), off), self.seen(name, shock.push)


def struck_together(blow: Impact) -> Iterator[Equation]:
    """What a blow changes of all that hang together: whole, and what each inner joint carries."""
    held = blow.after.moment.held
    for first in held.order:
        names = [first]
        for name in held.order:
            names += [name] if held.carrier(name) in names else []
        joint = held.main(first)
        alone = len(names) == 1 and not held.carrier(first)
        firm = joint is not None and (keeps_nothing(joint) or joint.powered or not (joint.free or joint.turning))
        led = any(held.bodies[name].moved for name in names)
        singly = all(len(held.of_body(name)) == (name != first or joint is not None) for name in names)
        if singly and not (alone or firm or led):
            yield from Linkage(tuple(names), joint, blow).laws()
