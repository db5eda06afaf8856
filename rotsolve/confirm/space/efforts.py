"""Efforts: forces and couples on the bodies of a stance: weight, actions, and those of joints, whose sizes are unknown.

m a = Σ F and I α + ω × I ω = Σ τ about the centre of mass, for each body, along the axes of space.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.space.arrows import (
    ALONG,
    STILL,
    Arrow,
    Turned,
    crossed,
    inner_product,
    less,
    normed,
    scaled,
    seen_from,
    sum_of,
    times_arrow,
)
from rotsolve.confirm.space.rig import way_along
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.ties import (
    ROUND,
    SPEED,
    TURNING,
    Key,
    Rates,
    Terms,
    Tie,
    added_terms,
    three_ties,
    way_terms,
)
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.elements import Action

FORCE, COUPLE = "force", "couple"
DOWN: Arrow = (0.0, 0.0, -1.0)


class Effort(Struct, frozen=True):
    """A force at an arm from the centre of mass of a body, and a couple: known, and `unknown` where their sizes have keys besides.

    `bearing` names one of several of a joint; `back` marks what a body does to what carries it.
    """

    owner: str
    body: str
    arm: Arrow
    force: Arrow = STILL
    couple: Arrow = STILL
    bearing: str = ""
    unknown: str = ""
    back: bool = False

    @property
    def sign(self) -> float:
        return -1.0 if self.back else 1.0

    def forced(self) -> Terms:
        """The unknown force, in terms of its parts."""
        keys: list[Key] = [(FORCE, self.unknown, k) for k in range(3)]
        return [((self.sign, key),) for key in keys] if self.unknown else [(), (), ()]

    def twisted(self) -> Terms:
        keys: list[Key] = [(COUPLE, self.unknown, k) for k in range(3)]
        return [((self.sign, key),) for key in keys] if self.unknown else [(), (), ()]

    def force_at(self, found: Rates) -> Arrow:
        """The force, once the unknown parts are found."""
        return sum_of(self.force, scaled(self.sign, found.arrow(FORCE, self.unknown))) if self.unknown else self.force

    def torque_at(self, found: Rates, about: Arrow) -> Arrow:
        """r × F + C about a point that is at an arm from the centre of mass."""
        couple = scaled(self.sign, found.arrow(COUPLE, self.unknown)) if self.unknown else STILL
        return sum_of(crossed(less(self.arm, about), self.force_at(found)), self.couple, couple)


class Efforts:
    """All that acts on the bodies of a stance, and what the laws of motion say with it."""

    def __init__(self, stance: Stance) -> None:
        self.stance, self.rig = stance, stance.rig
        self.list = [*self.weights(), *self.of_joints(), *self.of_crosses(), *self.of_actions(), *self.of_guides()]

    def on(self, name: str) -> list[Effort]:
        return [item for item in self.list if item.body == name]

    def weights(self) -> Iterator[Effort]:
        frame = self.rig.problem.gravity_in
        down = times_arrow(self.stance.turned(frame), DOWN) if frame else DOWN
        for name in self.rig.bodies:
            mass = self.rig.solid(name).mass
            if self.rig.gravity and mass:
                yield Effort("gravity", name, STILL, scaled(mass * self.rig.gravity, down))

    def of_joints(self) -> Iterator[Effort]:
        for joint in self.rig.joints.values():
            for place, bearing in () if joint.flat else self.places(joint):
                name, carrier = joint.body.owner, joint.carrier.owner
                unknown = f"{joint.owner} {bearing}"
                yield Effort(joint.owner, name, place, bearing=bearing, unknown=unknown)
                if carrier in self.rig.bodies:
                    off = less(sum_of(self.stance.place(name), place), self.stance.place(carrier))
                    yield Effort(joint.owner, carrier, off, bearing=bearing, unknown=unknown, back=True)

    def places(self, joint: Joint) -> Iterator[tuple[Arrow, str]]:
        """Where a joint pushes its body, from the centre of mass: at the point held, the lowest one, or two bearings."""
        if joint.rolls:
            yield self.stance.lowest(joint), ""
            return
        arm = self.stance.arm(joint.body)
        if not joint.bearings:
            yield arm, ""
        for number, place in enumerate(joint.bearings, 1):
            yield sum_of(arm, scaled(self.rig.value(place), self.stance.way(joint))), f"bearing{number}"

    def of_crosses(self) -> Iterator[Effort]:
        """What universal joints do to their two shafts."""
        for item in self.rig.couplings.values():
            yield Effort(item.owner, item.second.owner, STILL, unknown=item.owner)
            yield Effort(item.owner, item.first.owner, STILL, unknown=item.owner, back=True)

    def of_guides(self) -> Iterator[Effort]:
        """What leads a body whose motion is prescribed, whatever it takes."""
        for name, body in self.rig.bodies.items():
            if body.moved:
                yield Effort("", name, STILL, unknown=f" {name}")

    def of_actions(self) -> Iterator[Effort]:
        for action in self.rig.problem.actions:
            if action.from_ is not None or action.to is not None:
                raise NotConfirmed(f"`{action.name}` acts between two states")
            ref = action.touches()[0]
            arm = self.stance.arm(ref)
            if whatever(action):
                yield Effort(action.name, ref.owner, arm, unknown=action.name)
                continue
            vector = self.strength(action, ref)
            if action.twists():
                yield Effort(action.name, ref.owner, arm, couple=vector)
            else:
                yield Effort(action.name, ref.owner, arm, force=vector)

    def strength(self, action: Action, ref: PointRef) -> Arrow:
        """The force or couple of an action, in space; a couple without a direction is about the axis of its body."""
        size, way = action.strength(), getattr(action, "direction", None)
        if isinstance(size, tuple):
            return self.rig.arrow(size)
        if isinstance(way, tuple):
            return scaled(self.rig.value(size), way_along(self.rig, way))
        axis, joint = self.rig.axis(ref.owner), self.rig.main(ref.owner)
        hinged = joint is not None and joint.turning
        if not action.twists() or way is not None or not (hinged or axis):
            raise NotConfirmed(f"in which direction `{action.name}` acts")
        if joint is not None and joint.turning:
            return scaled(self.rig.value(size), self.stance.way(joint))
        assert axis is not None
        return scaled(self.rig.value(size), times_arrow(self.stance.turned(ref.owner), axis))

    # laws

    def laws(self, now: Rates) -> Iterator[Tie]:
        """Newton's and Euler's equations of all bodies, and what free axes say of couples."""
        for name in self.rig.bodies:
            yield from self.of_body(name, now)
        for joint in self.rig.joints.values():
            yield from () if joint.flat else self.unforced(joint)
        for item in self.rig.couplings.values():  # a couple square to both arms, and no force
            yield from three_ties([((1.0, (FORCE, item.owner, k)),) for k in range(3)], None, STILL)
            yield from (Tie(along_way((COUPLE, item.owner, 0), arm), None) for arm in self.stance.arms(item))
        yield from self.unaimed()

    def unaimed(self) -> Iterator[Tie]:
        """A force that is as large as it takes is no couple, nor the other way round."""
        for action in self.rig.problem.actions:
            if whatever(action):
                kind = FORCE if action.twists() else COUPLE
                yield from three_ties([((1.0, (kind, action.name, k)),) for k in range(3)], None, STILL)

    def of_body(self, name: str, now: Rates) -> Iterator[Tie]:
        own, tensor = self.rig.solid(name), self.tensor(name)
        travel: Terms = [((-own.mass, (SPEED, name, k)),) for k in range(3)]
        turning: Terms = [tuple((-tensor[k][n], (TURNING, name, n)) for n in range(3)) for k in range(3)]
        force, torque = STILL, STILL
        for item in self.on(name):
            travel = added_terms(travel, item.forced())
            turning = added_terms(added_terms(turning, lever(item)), item.twisted())
            force = sum_of(force, item.force)
            torque = sum_of(torque, crossed(item.arm, item.force), item.couple)
        omega = now.arrow(TURNING, name)
        yield from three_ties(travel, None, scaled(-1.0, force))
        yield from three_ties(turning, None, less(crossed(omega, times_arrow(tensor, omega)), torque))

    def tensor(self, name: str) -> Turned:
        """The inertia tensor about the centre of mass along the axes of space."""
        return seen_from(self.stance.turned(name), self.rig.solid(name).tensor)

    def unforced(self, joint: Joint) -> Iterator[Tie]:
        """What a joint can't do: no couple about what turns freely, no force along what slides freely."""
        names = [f"{joint.owner} {bearing}" for _, bearing in self.places(joint)]
        if joint.free or joint.rolls:
            yield from three_ties([((1.0, (COUPLE, names[0], k)),) for k in range(3)], None, STILL)
        if joint.rolls:
            return
        base = self.stance.base(joint)
        slides = [times_arrow(base, normed(self.rig.arrow(way))) for way in joint.sliding]
        turns = joint.turning and not (joint.powered or joint.free)
        couple = [along_way((COUPLE, names[0], 0), self.stance.way(joint))] if turns else []
        forces = [along_way((FORCE, names[0], 0), way) for way in slides]
        if joint.pitch is not None and couple:
            lead = self.rig.value(joint.pitch) / ROUND  # its power is nothing: C + F p/2π = 0
            yield Tie((*couple[0], *((lead * part, key) for part, key in forces[0])), None)
        else:
            yield from (Tie(terms, None) for terms in (*couple, *forces))
        if joint.bearings:
            yield from self.by_bearings(joint, names)

    def by_bearings(self, joint: Joint, names: list[str]) -> Iterator[Tie]:
        """Bearings push; none twists, but for what drives the shaft along it; the second does not push along it either."""
        way = self.stance.way(joint)
        for sideways in ALONG if not joint.powered else two_across(way):
            yield Tie(along_way((COUPLE, names[0], 0), sideways), None)
        for name in names[1:]:
            yield from three_ties([((1.0, (COUPLE, name, k)),) for k in range(3)], None, STILL)
            yield Tie(along_way((FORCE, name, 0), way), None)


def whatever(action: Action) -> bool:
    """Whether an action is as large as it takes, in whatever direction."""
    return isinstance(action.strength(), str)


def lever(item: Effort) -> Terms:
    """r × F of an unknown force."""
    columns = [crossed(item.arm, way) for way in ALONG]
    terms: Terms = [(), (), ()]
    for n, (part,) in enumerate(item.forced() if item.unknown else ()):
        terms = added_terms(terms, way_terms(part[1], scaled(part[0], columns[n])))
    return terms


def along_way(key: Key, way: Arrow) -> tuple[tuple[float, Key], ...]:
    """The part of a force or couple along a direction."""
    kind, name, _ = key
    return tuple((part, (kind, name, k)) for k, part in enumerate(way))


def two_across(way: Arrow) -> tuple[Arrow, Arrow]:
    """Two directions square to a third and to each other."""
    other = min(ALONG, key=lambda axis: abs(inner_product(axis, way)))
    first = normed(crossed(way, other))
    return first, crossed(way, first)
