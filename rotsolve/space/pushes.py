"""Pushes: the forces and couples on each body of a scene in space: weight, what its joints do to it and to what carries it, actions."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Quotient, Symbol, multiply, negate
from rotsolve.core.facts import TOUCHES, Requirement
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Triple,
    Z,
    cross_product,
    dot_product,
    is_axis,
    minus,
    scaled_by,
    triple,
    unit_along,
    vector_sum,
    way_between,
)
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.elements import Action
from rotsolve.space.attitude import IN_SPACE, NODE, Axes
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.sliding import free_of_force, sliding_way
from rotsolve.space.telling import turns_untold
from rotsolve.space.two_balls import ON_LINE, axes_on_line, names_along, place_on_line

FREELY = "{} turns freely about its axis"
UNPUSHED = "{} does not push along its axis"


class ForceInSpace(Struct, frozen=True):
    """A force (or none) on a body, and a couple, each along some `axes`; `arm` is where it acts, from the body's reference, in its own.

    `there` is the same along the axes of the force, where the numbers tell what of it is nothing: along it the force has no torque.
    """

    owner: str
    body: str
    force: Triple
    axes: Axes
    arm: Triple
    own: Axes
    couple: Triple = NOTHING
    there: Triple | None = None

    def along(self, axes: Axes) -> Triple:
        """The force in the components of other axes."""
        return self.axes.to(axes, self.force)

    def torque(self, about: Triple) -> Triple:
        """r × F + M about a point, from the reference, in the axes of the body."""
        if self.there is not None and about == NOTHING:
            turning = self.axes.to(self.own, cross_product(self.there, self.force))
            return vector_sum(turning, self.axes.to(self.own, self.couple))
        arm = way_between(about, self.arm)
        turning = NOTHING if arm == NOTHING else cross_product(arm, self.along(self.own))
        return vector_sum(turning, self.axes.to(self.own, self.couple))


class Pushes:
    """All forces and couples at one moment."""

    def __init__(self, moment: SpaceMoment, gravity: Formula | None, actions: tuple[Action, ...]) -> None:
        self.moment, self.gravity, self.actions = moment, gravity, actions
        self.conditions: list[
            tuple[str, Formula]
        ] = []  # what free axes leave: parts of couples along them that are nothing

    def on(self, name: str) -> Iterator[ForceInSpace]:
        """All that acts on a body."""
        held = self.moment.held
        weight = self.weight(name)
        if weight is not None:
            yield weight
        for joint in held.joints:
            if joint.body.owner == name:
                yield from self.by_joint(joint)
            elif joint.carrier.owner == name:
                yield from (self.back(joint, push) for push in self.by_joint(joint))
        if held.couplings:
            yield from self.by_crosses(name)
        for action in self.actions:
            if any(ref.owner == name for ref in action.touches()):
                yield self.by_action(action)

    def needs(self) -> Iterator[Requirement]:
        """A surface on which a body rolls pushes it out, and does not pull."""
        from rotsolve.space.rolling import out_of_surface

        for joint in self.moment.held.joints:
            if not joint.rolls:
                continue
            try:
                push, out = next(self.by_joint(joint)), out_of_surface(joint, self.moment)
            except Unsolvable:  # its laws are not written either
                continue
            size = dot_product(push.along(IN_SPACE), out)
            kept, otherwise = (
                f"{spoken(joint.body.owner)} keeps contact",
                f"{spoken(joint.body.owner)} leaves the surface",
            )
            yield Requirement(joint.owner, TOUCHES, size, ZERO, kept, otherwise)

    def weight(self, name: str) -> ForceInSpace | None:
        """M g down at the centre of mass."""
        mass = self.moment.held.mass(name)
        if self.gravity is None or mass == ZERO:
            return None
        axes, up = self.upward(name)
        size = multiply(mass, self.gravity)
        size = simplify(size) if isinstance(mass, Quotient) else size  # of a mass W/g it is W
        down = scaled_by(negate(size), up)
        return ForceInSpace("gravity", name, down, axes, self.moment.arm(PointRef(name, "cm")), self.moment.axes(name))

    def upward(self, name: str) -> tuple[Axes, Triple]:
        """Against which direction the weight of a body is, and the axes along which that is written."""
        frame = self.moment.held.problem.gravity_in
        if frame:
            return self.moment.own_axes(frame), Z
        if self.moment.vector_kept(name, "vertical") is not None:
            return self.moment.axes(name), self.moment.up(name)
        return IN_SPACE, Z

    def reaction_axes(self, joint: Joint) -> Axes:
        """The axes along which the parts of a joint's force are written: level ones of what nods, if it is told how far it has gone round,
        else those of the body, if the weight is told along them."""
        name, axes = joint.body.owner, self.moment.axes(joint.body.owner)
        nods = axes.name == NODE or self.moment.nods(name)
        if joint.free and axes.name == NODE and nods and turns_untold(self.moment.nodding(name).angles[0]):
            return axes
        hangs = bool(axes.lost) and self.gravity is not None and self.moment.vector_kept(name, "vertical") is None
        if nods or joint.rolls or hangs:
            return IN_SPACE
        return self.line_axes(name) or axes

    def line_axes(self, name: str) -> Axes | None:
        """The axes along the oblique line through two balls that hold a body; None of others."""
        main, held = self.moment.held.main(name), self.moment.held
        if main is None or not held.hinge_balls(name):
            return None
        return axes_on_line(held, name, self.moment.axes(name), self.moment.direction(name, main))

    def letters(self, word: str, joint: Joint, mark: str = "", names: tuple[str, ...] = AXES) -> Triple:
        """Three letters for a force or couple of a joint."""
        return triple([self.moment.ask(word, joint.owner, f"{axis}{mark}") for axis in names])

    def by_joint(self, joint: Joint) -> Iterator[ForceInSpace]:
        """What a joint does to the body that it holds."""
        name, axes = joint.body.owner, self.reaction_axes(joint)
        if joint.flat:
            message = f"the forces of `{joint.owner}` on a face are not solved in space yet"
            raise Unsolvable(message, span=joint.body.span, help=force_of_floor(joint))
        own = self.moment.axes(name)
        if joint.bearings:
            yield from self._by_bearings(joint)
            return
        force, place = self.letters("force", joint, names=names_along(axes)), self.place(joint)
        untwisted = joint.free or joint.rolls or self.moment.held.pointlike(name)
        couple = NOTHING if untwisted else self.couple(joint)
        if name in self.moment.held.links and (pull := self.along_link(joint)) is not None:
            yield ForceInSpace(joint.owner, name, pull, axes, place, own)
            return
        force, nothing = free_of_force(joint, self.moment, force, couple)
        words = UNPUSHED.format(spoken(joint.owner)) + ("" if joint.pitch is None else ": it gives no power")
        self.conditions += [(words, part) for part in nothing]
        if axes.name == ON_LINE:  # what pushes along the line may be moved along it
            yield ForceInSpace(joint.owner, name, (force[0], ZERO, ZERO), axes, NOTHING, own)
            yield ForceInSpace(joint.owner, name, (ZERO, *force[1:]), axes, place, own)
        elif couple == NOTHING:
            there = self.seen_place(joint, place, axes)
            yield ForceInSpace(joint.owner, name, force, axes, place, own, there=there)
        elif axes == own:
            yield ForceInSpace(joint.owner, name, force, axes, place, own, couple)
        else:
            yield ForceInSpace(joint.owner, name, force, axes, place, own)
            yield ForceInSpace(joint.owner, name, NOTHING, own, place, own, couple)

    def two_forces(self, name: str) -> bool:
        """Whether two opposite forces along it are all that acts on a body: it is a light bar that closes a linkage."""
        if name not in self.moment.held.links:
            return False
        from rotsolve.space.links import link_at

        link = link_at(self.moment, name)
        return link is not None and link.light

    def along_link(self, joint: Joint) -> Triple | None:
        """The force of a joint on a light bar that closes a linkage; None of one that has mass, or on which something acts."""
        from rotsolve.space.links import link_at

        link = link_at(self.moment, joint.body.owner)
        if link is None or not link.light:
            return None
        if joint.sliding:
            self.conditions.append(
                (UNPUSHED.format(spoken(joint.owner)), dot_product(sliding_way(joint, self.moment), link.pull()))
            )
        return link.pull() if joint.owner == link.ends[1].owner else minus(link.pull())

    def place(self, joint: Joint) -> Triple:
        """Where a joint acts on its body: at the point held, or at the lowest one where it rolls."""
        if joint.rolls:
            from rotsolve.space.rolling import lowest

            return lowest(joint, self.moment)
        on_line = place_on_line(self.moment.held, joint)
        return self.moment.arm(joint.body) if on_line is None else on_line

    def seen_place(self, joint: Joint, place: Triple, axes: Axes) -> Triple | None:
        """Where something rolls that is held besides, along the axes of its force; None of others."""
        if not joint.rolls or not self.moment.held.supports(joint.body.owner):
            return None
        seen = self.moment.axes(joint.body.owner).to(axes, place)
        return triple([ZERO if self.moment.held.vanishes(part) else self.moment.tidy(part) for part in seen])

    def direction(self, joint: Joint) -> Triple | None:
        """The axis of a joint, in the axes of its body."""
        if not joint.turning:
            return None
        own = self.moment.attitude(joint.body.owner)
        if joint.aligned and own.about is not None:
            return own.about
        return self.moment.direction(joint.body.owner, joint)

    def couple(self, joint: Joint) -> Triple:
        """The couple of a hinge or clamp: across its axis, and along it only where something drives it."""
        axis = self.direction(joint)
        x, y, z = self.letters("torque", joint)
        if axis is None or joint.powered or joint.pitch is not None:
            return (x, y, z)
        if is_axis(axis):
            return (
                ZERO if axis[0] != ZERO else x,
                ZERO if axis[1] != ZERO else y,
                ZERO if axis[2] != ZERO else z,
            )
        self.conditions.append((FREELY.format(spoken(joint.owner)), dot_product(axis, (x, y, z))))
        return (x, y, z)

    def _by_bearings(self, joint: Joint) -> Iterator[ForceInSpace]:
        """Two bearings on the axis: each pushes across it, the first along it too; what drives the shaft twists it along the axis."""
        name, axis = joint.body.owner, self.direction(joint)
        assert axis is not None
        held = self.moment.arm(joint.body)
        first, last = joint.bearings
        if self.moment.held.vanishes(first - last):
            message = f"both bearings of `{joint.owner}` are at one place: they don't keep the axis of `{name}` in its direction"
            raise Unsolvable(message, span=joint.body.span, help="give two places, or leave `bearings` out")
        for number, place in enumerate(joint.bearings, 1):
            force = self.letters("force", joint, f"_{number}")
            if number == 2:
                if is_axis(axis):
                    x, y, z = (ZERO if way != ZERO else part for part, way in zip(force, axis, strict=True))
                    force = (x, y, z)
                else:
                    self.conditions.append((FREELY.format(spoken(joint.owner)), dot_product(axis, force)))
            twist = NOTHING
            if number == 1 and joint.powered:
                twist = scaled_by(self.moment.ask("torque", joint.owner, "drive"), axis)
            own = self.moment.axes(name)
            yield ForceInSpace(joint.owner, name, force, own, vector_sum(held, scaled_by(place, axis)), own, twist)

    def couple_of_bearings(self, joint: Joint) -> tuple[Triple, Triple] | None:
        """Letters for the torque of two bearings about the point held, with what their forces make of it; None where it is not asked.

        What is one letter already, as what drives the shaft, stays that.
        """
        asked = (term for find in self.moment.held.problem.finds for term in find.terms)
        told = any(term.path.owner == joint.owner and term.path.quantity == "torque" for term in asked)
        if not joint.bearings or not told:
            return None
        place = self.moment.arm(joint.body)
        torque = vector_sum(NOTHING, *(push.torque(place) for push in self._by_bearings(joint)))
        letters = self.letters("torque", joint)
        plain = [part == ZERO or isinstance(part, Symbol) for part in torque]
        return triple([part if bare else own for part, bare, own in zip(torque, plain, letters, strict=True)]), torque

    def by_crosses(self, name: str) -> Iterator[ForceInSpace]:
        """The couples of universal joints on a shaft."""
        from rotsolve.space.universal import crosses_at

        for cross in crosses_at(self.moment):
            ends, own = cross.coupling, self.moment.axes(name)
            if name in (ends.first.owner, ends.second.owner):
                couple = cross.couple() if name == ends.second.owner else minus(cross.couple())
                yield ForceInSpace(ends.owner, name, NOTHING, IN_SPACE, NOTHING, own, couple)

    def back(self, joint: Joint, push: ForceInSpace) -> ForceInSpace:
        """What the body does to what carries it: the opposite, at the same place."""
        carrier, body = joint.carrier.owner, joint.body.owner
        ours, theirs = self.moment.axes(body), self.moment.axes(carrier)
        if joint.rolls:
            from rotsolve.space.rolling import Rolling

            arm = Rolling(joint, self.moment).touched_from_held()
        else:
            shift = way_between(self.moment.arm(joint.body), push.arm)
            arm = vector_sum(self.moment.carried_at(joint), ours.to(theirs, shift))
        return ForceInSpace(joint.owner, carrier, minus(push.force), push.axes, arm, theirs, minus(push.couple))

    def twisted_about(self, name: str) -> Triple | None:
        """The axis about which a couple without a direction turns a body: that about which it is hinged, else that of its symmetry."""
        joint = self.moment.held.main(name)
        return self.direction(joint) if joint is not None and joint.turning else self.moment.symmetry_axis(name)

    def by_action(self, action: Action) -> ForceInSpace:
        """A force or couple from outside, along a direction in space, a couple also about the body's own axis."""
        ref = action.touches()[0]
        own = self.moment.axes(ref.owner)
        strength, way = action.strength(), getattr(action, "direction", None)
        if way is not None and isinstance(strength, (str, tuple)):
            raise told_twice(action)
        vector: Triple | None
        if isinstance(strength, str):  # whatever it takes
            word = "torque" if action.twists() else "force"
            vector = triple([self.moment.ask(word, action.name, axis) for axis in AXES])
        elif isinstance(strength, tuple):
            vector = strength
        elif way is not None:
            vector = scaled_by(strength, unit_along(way, self.moment.positive))
        else:
            vector = None
        vector = None if vector is None else triple([self.moment.now(part) for part in vector])
        if action.twists():
            axis = self.twisted_about(ref.owner)
            if vector is None and axis is None:
                raise Unsolvable(
                    f"about which axis `{action.name}` turns nothing tells",
                    span=ref.span,
                    help="give it `direction: z`",
                )
            axes, couple = (
                (IN_SPACE, vector)
                if vector is not None
                else (own, scaled_by(self.moment.now(strength), axis or NOTHING))
            )
            return ForceInSpace(action.name, ref.owner, NOTHING, axes, self.moment.arm(ref), own, couple)
        if vector is None:
            raise Unsolvable(
                f"in which direction `{action.name}` pulls nothing tells",
                span=ref.span,
                help="give it `direction: [x, y, z]`",
            )
        return ForceInSpace(action.name, ref.owner, vector, IN_SPACE, self.moment.arm(ref), own)


def told_twice(action: Action) -> Unsolvable:
    """What is said of a force or couple whose direction is told, and follows from what it is as well."""
    kind = "couple" if action.twists() else "force"
    any_ = f"`{kind}: any` is one in whatever direction it takes"
    said = any_ if isinstance(action.strength(), str) else "its components tell that"
    help = f"leave `direction` out, or give its size: `{kind}: F` with `F: unknown` under `given` where it is sought"
    return Unsolvable(f"`{action.name}` has a `direction`, and {said}", span=action.touches()[0].span, help=help)


def force_of_floor(joint: Joint) -> str:
    """What says the push of a smooth floor at a point: on what keeps its height it is as large as the weight."""
    ref = joint.body
    if ref.point is None:
        return ""
    push = f"`{{force: M*g, on: {ref.owner}.{ref.point}, direction: z}}`"
    return f"leave it out, and let a force push: {push}, as much as all weighs that keeps its height"
