"""Course: a scene in space at a moment of its motion, at which all places and rates are letters.

A body that may turn about any axis stands by its unit quaternion, so that no tilt is special. One that is symmetric about its axis e₃
through the point held is seen from axes that go with that but do not turn about it, Ω = ω₁ e₁ + ω₂ e₂: its fast spin is an angle of its
own. A thin wheel that rolls goes by its Euler angles: its lowest point is −R e₂ in its node axes.
"""

from __future__ import annotations

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import COURSE, TIME, SymbolKey
from rotsolve.core.vectors.triple import (
    AXES,
    Rows,
    Triple,
    Z,
    after,
    cross_product,
    rotated,
    transposed,
    triple,
    turn_about,
    vector_sum,
    way_between,
)
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.problem import State
from rotsolve.motion.arrangement import Arrangement
from rotsolve.space.arrangement import ANGLES, RATES
from rotsolve.space.attitude import BODY, IN_SPACE, Attitude, Axes, Nodding, as_drawn, permutation
from rotsolve.space.inertia import CM
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.places import reference_place
from rotsolve.space.thin import thin_axis

UNSPUN = "unspun"  # axes that go with a body's axis, and do not turn about it
PARTS = ("w", "x", "y", "z")
TURNING_BY = ("angular_velocity", "angular_acceleration")


class CourseMoment(SpaceMoment):
    """Any moment of a motion; what it does not know is asked for as letters, which the state of motion and the laws tell."""

    def __init__(self, beginning: SpaceMoment, known: Arrangement) -> None:
        super().__init__(beginning.held, beginning.registry, State(COURSE + beginning.when), known)
        self.first = False
        self.beginning = beginning

    def tidy(self, value: Formula) -> Formula:
        """As it is: nobody reads it."""
        return value

    def left_open(self, name: str) -> tuple[bool, bool]:
        """All rates are told by the state of motion, those of them by the laws."""
        return False, False

    def own_letter(self, kind: str, name: str, component: str = "") -> Symbol:
        """A letter that stands for no quantity of the scene language."""
        return Symbol(SymbolKey(kind, name, component, self.when).name)

    # how bodies stand

    def nods(self, name: str) -> bool:
        """Whether a body goes by its Euler angles."""
        return self.held.rolling(name) is not None and not shape_of(self.held.bodies[name]).spherical

    def turns_anyhow(self, name: str) -> bool:
        """Whether a body goes by its quaternion: no axis holds it, or it is led round."""
        if self.held.bodies[name].moved:
            return self.led_round(name)
        joint = self.held.main(name)
        return not (self.nods(name) or self.held.pointlike(name)) and (joint is None or joint.free)

    def led_round(self, name: str) -> bool:
        """Whether it is told how a body turns at any time."""
        return any(word in TURNING_BY for word, _, _ in self.held.bodies[name].moved)

    def quaternion(self, name: str) -> list[Symbol]:
        """The unit quaternion w + x i + y j + z k of the axes of such a body."""
        return [self.own_letter("quaternion", name, part) for part in PARTS]

    def rows_letters(self, name: str) -> Rows:
        """The nine entries of the rotation of these axes."""
        rows = [triple([self.entry_letter(name, one, other) for other in AXES]) for one in AXES]
        return (rows[0], rows[1], rows[2])

    def entry_letter(self, name: str, one: str, other: str) -> Symbol:
        """The component along an axis of space of one of these axes."""
        return self.own_letter("rotation", name, one + other)

    @remembered
    def unspun(self, name: str) -> Triple | None:
        """The axis of a body that is seen from axes which do not turn about it; None of others."""
        axis = self.held.axis(name)
        carries = any(joint.carrier.owner == name for joint in self.held.joints)
        if carries or axis is None or self.held.bodies[name].moved or self.held.whole_tensor(name) is None:
            return None
        return axis if self.turns_anyhow(name) and self.held.turns_round(name, axis) else None

    def freely(self, name: str) -> Attitude:
        """A body that may turn about any axis; a particle stands as it is drawn."""
        if self.held.bodies[name].moved:
            return self._led(name, ())
        if self.nods(name):
            return self._nods(name)
        if self.held.pointlike(name):
            return Attitude(IN_SPACE, IN_SPACE.rows, (ZERO, ZERO, ZERO), (ZERO, ZERO, ZERO))
        rows, axis = self.rows_letters(name), self.unspun(name)
        omega, alpha = (triple([self.ask(word, name, part) for part in AXES]) for word in TURNING_BY)
        if axis is None:
            return as_drawn(rows, omega, alpha)
        if thin_axis(self.held, name) is not None:  # it has no inertia about it: nothing changes its spin
            alpha = (alpha[0], alpha[1], ZERO)
        axes = Axes(UNSPUN, rows, (omega[0], omega[1], ZERO), (alpha[0], alpha[1], ZERO))
        return Attitude(axes, permutation(axis), omega, alpha, Z)

    def _led(self, name: str, led: object) -> Attitude:
        """A body that is led round, with the angular velocity that is told along the axes of space at any time."""
        if not self.led_round(name):
            return super()._led(name, ())
        rows = self.rows_letters(name)
        back = transposed(rows)
        omega, alpha = self.led_rates(name)
        return as_drawn(rows, rotated(back, omega), rotated(back, alpha))

    def led_rates(self, name: str) -> tuple[Triple, Triple]:
        """The angular velocity with which a body is led, in space, and how fast it changes.

        A component of which that is told too is a number of the state.
        """
        told = {(word, axis): value for word, axis, value in self.held.bodies[name].moved}
        rates, faster = ([told.get((word, axis)) for axis in AXES] for word in TURNING_BY)
        omega = [
            self.ask("angular_velocity", name, axis) if change is not None else rate or ZERO
            for axis, rate, change in zip(AXES, rates, faster, strict=True)
        ]
        alpha = [
            differentiate(rate, TIME) if change is None else change for rate, change in zip(omega, faster, strict=True)
        ]
        return triple(omega), triple(alpha)

    @remembered
    def nodding(self, name: str) -> Nodding:
        """Euler angles, their rates and the rates of these, all of them letters."""
        angles, rates = (triple([self.ask(word, name) for word in words]) for words in (ANGLES, RATES))
        return Nodding(angles, rates, triple([self.rate_of(word, name) for word in RATES]))

    def about_hinge(self, name: str, joint: Joint) -> tuple[str, Formula, Formula]:
        """What the rate about a hinge or axle is called, the rate, and how fast that changes."""
        word = "spin" if joint.aligned and self.held.carrier(name) else "angular_velocity"
        return word, *self.driven(name, joint, word)

    def hinge_angle(self, name: str, joint: Joint) -> Formula:
        """How far a body is turned about its hinge: as it is driven at any time, else a letter."""
        driven = dict(joint.drive).get("angle")
        return self.ask("angle", name) if driven is None else driven

    def driven(self, name: str, joint: Joint, word: str) -> tuple[Formula, Formula]:
        """The rate about a hinge or axle and how fast that changes; a rate that changes as it is told is a number of the state."""
        rate, faster = super().driven(name, joint, word)
        return (self.ask(word, name) if "angular_acceleration" in dict(joint.drive) else rate), faster

    # points

    def way_gone(self, name: str) -> Triple:
        """How far the centre of mass of a body that nothing holds has gone since the first state, along the axes of space."""
        return triple([self.own_letter("displacement", name, axis) for axis in AXES])

    def rim_side(self, name: str) -> Formula:
        """As at first: a motion ends where the tilt comes to 0 or 180°."""
        return self.beginning.rim_side(name)

    def place_in(self, name: str, frame: str) -> Triple | None:
        """Where the centre of mass of a body is in the axes of another one: from where it was at first, by the way that it has gone."""
        place = vector_sum(reference_place(self.beginning, name), self.way_gone(name))
        off = way_between(reference_place(self, frame), place)
        return IN_SPACE.to(self.own_axes(frame), off)

    def spun(self, name: str) -> Formula:
        """By how much a body has turned about its own axis in axes that do not turn with it."""
        joint = self.held.main(name)
        if self.unspun(name) is not None:
            return self.own_letter("turned", name)
        return self.nodding(name).angles[2] if joint is None else self.hinge_angle(name, joint)

    def about(self, name: str) -> tuple[Triple | None, Formula]:
        """The direction, in the axes of a body, about which it spins in these, and by how much it has."""
        about = self.attitude(name).about
        return about, ZERO if about is None else self.spun(name)

    def arm(self, ref: PointRef) -> Triple:
        """A point from the reference of its body, in the body's axes, in which a point beside its axis goes round."""
        arm = rotated(self.attitude(ref.owner).own, self.held.arm(ref))
        about, angle = self.about(ref.owner)
        if about is None or all(map(self.held.vanishes, cross_product(about, arm))):
            return arm
        return rotated(turn_about(about, angle), arm)

    def own_axes(self, name: str) -> Axes:
        """The axes that go with a body, named as it is drawn."""
        own = self.attitude(name)
        about, angle = self.about(name)
        inner = own.own if about is None else after(turn_about(about, angle), own.own)
        back = transposed(inner)
        return Axes(BODY, after(own.axes.rows, inner), rotated(back, own.omega), rotated(back, own.alpha))

    def acceleration_along(self, axes: Axes, ref: PointRef) -> Triple:
        """The acceleration of a point in the components of other axes; a free body's centre of mass has its own along those of space."""
        if ref.point == CM and axes == IN_SPACE and self.held.main(ref.owner) is None:
            return self.of_centre(ref.owner, "acceleration")
        return super().acceleration_along(axes, ref)
