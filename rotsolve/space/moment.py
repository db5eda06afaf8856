"""Moment: a scene in space at one state: where the points of its bodies are, and how these move.

Vectors of a body are in the axes of its `Attitude`. What a state tells is put in; what it does not tell has a letter.
"""

from __future__ import annotations

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.formula import ONE, ZERO, Formula, negate
from rotsolve.core.faults import Unsolvable
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import TIME, has_quantities
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import (
    AS_DRAWN,
    AXES,
    NOTHING,
    Triple,
    Z,
    cross_product,
    is_axis,
    rotated,
    scaled_by,
    triple,
    turn_about,
    unit_along,
    vector_sum,
    way_between,
)
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.paths.meaning import NotYet
from rotsolve.space.attitude import (
    IN_SPACE,
    NODE,
    Attitude,
    Axes,
    HeldBar,
)
from rotsolve.space.frames import Relative, frame_of
from rotsolve.space.sliding import refuse_elsewhere, slid, slid_since, slid_to
from rotsolve.space.turned import TurnedMoment


class SpaceMoment(TurnedMoment):
    """One state of a scene in space."""

    before: SpaceMoment | None

    def link_with(self, ref: PointRef) -> tuple[HeldBar, Triple] | None:
        """A bar that closes a linkage and one of its points, in its own axes; None of other bodies."""
        if ref.owner not in self.held.links:
            return None
        from rotsolve.space.links import point_of_link

        return point_of_link(self, ref)

    def coupled_angle(self, name: str) -> Formula | None:
        if not self.held.couplings:
            return None
        from rotsolve.space.universal import coupled_angle

        return coupled_angle(self, name)

    def _between_ends(self, name: str) -> Attitude:
        from rotsolve.space.links import link_at, link_attitude

        link = link_at(self, name)
        assert link is not None
        return link_attitude(link)

    def arm(self, ref: PointRef) -> Triple:
        """A point from the reference of its body, in the body's axes."""
        bar = self.link_with(ref)
        if bar is not None:
            return scaled_by(bar[0].share(bar[1]), bar[0].way())
        own, arm = self.attitude(ref.owner), self.held.arm(ref)
        turned, unknown = rotated(own.own, arm), self.spun_away(ref.owner)
        if unknown and not self.fixed_in_axes(ref.owner, turned):
            help = f"tell its `{ref.owner}.angle` in that state, or ask for what lies on its axis"
            raise Unsolvable(unknown, span=ref.span, help=help)
        if own.axes.name == NODE and self.nods(ref.owner):
            return rotated(turn_about(Z, self.nodding(ref.owner).angles[2]), turned)
        return turned

    def symmetry_axis(self, name: str) -> Triple | None:
        """The direction about which a body is symmetric, in the axes of its attitude; None where it is about none."""
        if name in self.held.links:
            return None
        own = self.attitude(name)
        return self.held.axis(name) if own.about is None and own.own == AS_DRAWN else own.about

    def fixed_in_axes(self, name: str, arm: Triple) -> bool:
        """Whether a point keeps its place in the axes of a body, which spins in them: it lies on its axis."""
        about = self.attitude(name).about
        return arm == NOTHING or (
            about is not None
            and all(part == ZERO or own != ZERO for part, own in zip(arm, about, strict=True))
            and is_axis(about)
        )

    def velocity(self, ref: PointRef) -> Triple:
        """v = v_ref + ω × r of a point, in the axes of its body."""
        bar = self.link_with(ref)
        return self.velocity_there(ref.owner, self.arm(ref)) if bar is None else bar[0].part_way(bar[1], "velocity")

    def velocity_there(self, name: str, arm: Triple) -> Triple:
        """v = v_ref + ω × r of what is at an arm from the reference of a body and goes with it."""
        return vector_sum(self.reference_velocity(name), cross_product(self.attitude(name).omega, arm))

    def acceleration(self, ref: PointRef) -> Triple:
        """a = a_ref + α × r + ω × (ω × r) of a point, in the axes of its body; of a point on its axis by how these axes turn."""
        bar = self.link_with(ref)
        if bar is not None:
            return bar[0].part_way(bar[1], "acceleration")
        return self.acceleration_there(ref.owner, self.arm(ref))

    def acceleration_there(self, name: str, arm: Triple) -> Triple:
        """The same of what is at an arm from the reference of a body."""
        own = self.attitude(name)
        omega, alpha = own.omega, own.alpha
        if self.fixed_in_axes(name, arm):
            omega, alpha = own.axes.rate, own.axes.change
        return vector_sum(
            self.reference_acceleration(name),
            cross_product(alpha, arm),
            cross_product(omega, cross_product(omega, arm)),
        )

    def acceleration_along(self, axes: Axes, ref: PointRef) -> Triple:
        """The acceleration of a point in the components of other axes; of a free centre of mass it is told in those of space."""
        if ref.point == "cm":
            moved, seen = self.of_mass(ref.owner, "acceleration")
            return seen.to(axes, moved)
        return self.axes(ref.owner).to(axes, self.acceleration(ref))

    def reference_velocity(self, name: str) -> Triple:
        """The velocity of the point about which a body turns, in its axes."""
        return self._of_reference(name, "velocity")

    def reference_acceleration(self, name: str) -> Triple:
        return self._of_reference(name, "acceleration")

    @remembered
    def _of_reference(self, name: str, word: str) -> Triple:
        """Of the point held that of what carries it; of a free body that of its centre of mass: led, told, or letters in space axes."""
        joint = self.held.main(name)
        axes = self.axes(name)
        if joint is not None:
            return vector_sum(self._of_carrier(name, joint, word), self._slid(name, joint, word))
        return IN_SPACE.to(axes, self.of_centre(name, word))

    def _of_carrier(self, name: str, joint: Joint, word: str) -> Triple:
        """Of the point of what carries a body at which it is held, in the axes of the body."""
        if joint.carrier.owner not in self.held.bodies:
            return NOTHING
        there = self.velocity_there if word == "velocity" else self.acceleration_there
        moved = there(joint.carrier.owner, self.carried_at(joint))
        return self.axes(joint.carrier.owner).to(self.axes(name), moved)

    def carried_at(self, joint: Joint) -> Triple:
        """Where a joint holds its body, from the reference of what carries it, in the axes of that: on a slide as far as it has slid."""
        arm, carrier = self.arm(joint.carrier), joint.carrier.owner
        gone = self.slid_by(joint) if joint.sliding else ZERO
        if gone == ZERO:
            return arm
        way = scaled_by(gone, unit_along(joint.sliding[0], self.positive))
        there = vector_sum(arm, self.own_axes(carrier).to(self.axes(carrier), way))
        return triple([self.tidy(part) for part in there])

    def slid_by(self, joint: Joint) -> Formula:
        """How far a body has slid from where it is drawn, as at the first state; refused where nothing tells how far it has come since."""
        if not self.later:
            refuse_elsewhere(joint, self)
            return ZERO if joint.carrier.owner in self.held.bodies else slid_to(joint, self) or ZERO
        return slid_since(joint, self)

    def _slid(self, name: str, joint: Joint, word: str) -> Triple:
        """What it adds that a joint lets its body slide."""
        if not joint.sliding:
            return NOTHING
        self.slid_by(joint)
        return slid(joint, self, word)

    def of_mass(self, name: str, word: str) -> tuple[Triple, Axes]:
        """The velocity or acceleration of the centre of mass with the axes of its components: of a free body those of space."""
        if not self.held.of_body(name):
            return self.of_centre(name, word), IN_SPACE
        centre = PointRef(name, "cm")
        return self.velocity(centre) if word == "velocity" else self.acceleration(centre), self.axes(name)

    @remembered
    def of_centre(self, name: str, word: str) -> Triple:
        """The velocity or acceleration of the centre of mass of a free body, in space axes."""
        led = {(kind, axis): value for kind, axis, value in self.held.bodies[name].moved}
        order = ("position", "velocity", "acceleration")
        if self.later and word == "velocity" and any(kind == "acceleration" for kind, _ in led):
            help = "tell its `velocity` as a formula of `time`"
            message = f"how fast `{name}`, which is led with an acceleration, goes at `{self.when}` is not solved: time has passed"
            raise NotYet(message, self.held.bodies[name].span, help)
        for back in range(order.index(word), -1, -1):
            if any((order[back], axis) in led for axis in AXES):
                parts = [led.get((order[back], axis), ZERO) for axis in AXES]
                for _ in range(order.index(word) - back):
                    parts = [differentiate(part, TIME) for part in parts]
                return triple([self.now(part) for part in parts])
        joint = self.held.rolling(name)
        if joint is not None:
            from rotsolve.space.rolling import Rolling

            rolling = Rolling(joint, self)
            return rolling.velocity() if word == "velocity" else rolling.acceleration()
        told = self.vector_told(name, word)
        if word == "velocity" and self.rests(name):
            return NOTHING
        if told is not None and not told[2]:
            vector, seen, _ = told
            return self.named_axes(seen, name).to(IN_SPACE, vector)
        frame = frame_of(self, name)
        if frame:
            relative = Relative(self, name, frame)
            return relative.axes.to(IN_SPACE, relative.velocity() if word == "velocity" else relative.acceleration())
        flown = self.onward.centre_velocity(name) if self.onward is not None and word == "velocity" else None
        if flown is not None:
            self.hangs_on_time()
            return flown
        steady = self.state.steady and not self.held.of_body(name) and not self.held.falls(name)
        travels = any(kind == "acceleration" for kind, _ in led)  # at a velocity that nothing tells
        if (led and not travels) or (word == "acceleration" and steady):
            return NOTHING  # what is only led round goes nowhere
        return triple([self.ask(word, name, axis) for axis in AXES])

    def rim_side(self, name: str) -> Formula:
        """−1 where the tilt of a wheel is told beyond 0 to 180°, so that the lowest point of its rim lies along +e₂; 1 of others."""
        sine = heading(self.nodding(name).angles[1]).sin()
        return negate(ONE) if not has_quantities(sine) and self.signs.taken(sine) == -1 else ONE

    def place_in(self, name: str, frame: str) -> Triple | None:
        """Where the centre of mass of a body is in the axes of another one, from the point at which that is held: as the state tells, or
        as far as it tells where both are in space."""
        told = self.vector_told(name, "position")
        if told is not None and told[2] == frame:
            return told[0]
        from rotsolve.space.places import point_in_space, reference_place

        try:
            places = reference_place(self, frame), point_in_space(self, PointRef(name, "cm"))
        except (Unsolvable, NotYet):
            return None
        return IN_SPACE.to(self.own_axes(frame), way_between(*places))
