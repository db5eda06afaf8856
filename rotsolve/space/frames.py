"""Frames that turn: motion relative to a body, and the inertial forces that are felt in its axes.

a = a_frame + Ω̇ × r + Ω × (Ω × r) + 2 Ω × v_rel + a_rel (Goldstein, Poole & Safko, Classical Mechanics, §4.10); the inertial forces are
−m times its parts: centrifugal −m Ω × (Ω × r), Euler −m Ω̇ × r, Coriolis −2 m Ω × v_rel.
"""

from __future__ import annotations

from rotsolve.algebra.formula import ONE, Formula, multiply, negate
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Triple,
    cross_product,
    scaled_by,
    triple,
    unit_along,
    vector_sum,
    way_between,
)
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.space.attitude import IN_SPACE, Axes, MovingBodies
from rotsolve.space.sliding import drawn_place, moved_in

TWO = 2 * ONE


class Relative:
    """The motion of a body as a state tells it relative to another one, in the axes of that; what it does not tell has letters."""

    def __init__(self, moment: MovingBodies, name: str, frame: str) -> None:
        self.moment, self.name, self.frame = moment, name, frame
        self.axes: Axes = moment.own_axes(frame)
        held = moment.attitude(frame)
        self.omega = held.axes.to(self.axes, held.omega)
        self.alpha = held.axes.to(self.axes, held.alpha)
        joint = moment.held.main(name)
        self.guide = joint if joint is not None and joint.sliding and joint.carrier.owner == frame else None
        self.place = self._held_place(self.guide) if self.guide is not None else self._place_told()
        told = moment.vector_told(name, "velocity")
        absolute = (told is not None and not told[2]) or moment.rests(name)
        self.settled = moment.held.rolling(name) is not None or frame_of(moment, name) != frame  # how it moves in space
        self.told_in_space = self.settled or absolute

    def _told(self, word: str) -> Triple | None:
        told = self.moment.vector_told(self.name, word)
        return told[0] if told is not None and told[2] == self.frame else None

    def _place_told(self) -> Triple:
        """Where the centre of mass of a body is in the frame; refused by name where nothing tells."""
        told = self.moment.place_in(self.name, self.frame)
        if told is None:
            help = f"tell `{self.name}.position relative to {self.frame}: [x, y, z]` in the state"
            raise Unsolvable(f"where `{self.name}` is in `{self.frame}` nothing tells", help=help)
        return told

    def _held_place(self, guide: Joint) -> Triple:
        """Where the centre of mass of a body is that slides along the frame, as far as it has slid."""
        way = unit_along(guide.sliding[0], self.moment.held.signs.positive)
        return vector_sum(drawn_place(guide, self.moment), scaled_by(self.moment.slid_by(guide), way))

    @property
    def slip(self) -> Triple:
        """The relative velocity: as told, v − v_frame − Ω × r of what moves as is told or settled in space, else none."""
        if self.guide is not None:
            return moved_in(self.guide, self.moment, "velocity")
        told = self._told("velocity")
        if told is not None:
            return told
        if self.told_in_space:
            seen = IN_SPACE.to(self.axes, self.moment.of_centre(self.name, "velocity"))
            return way_between(vector_sum(self.origin("velocity"), cross_product(self.omega, self.place)), seen)
        return NOTHING

    @property
    def faster(self) -> Triple:
        """The relative acceleration: as told, as its a tells it where that is settled, none in a steady state, else letters."""
        if self.guide is not None:
            return moved_in(self.guide, self.moment, "acceleration")
        told = self._told("acceleration")
        if told is not None:
            return told
        if self.settled:
            return way_between(self._led(), IN_SPACE.to(self.axes, self.moment.of_centre(self.name, "acceleration")))
        if self.moment.state.steady:
            return NOTHING
        return triple([self.moment.ask("acceleration", self.name, f"{axis} relative") for axis in AXES])

    def origin(self, word: str) -> Triple:
        """The velocity or acceleration of the frame's origin, from which places in it count."""
        ref = origin_of(self.moment, self.frame)
        own = self.moment.velocity(ref) if word == "velocity" else self.moment.acceleration(ref)
        return self.moment.axes(self.frame).to(self.axes, own)

    def velocity(self) -> Triple:
        """v = v_frame + Ω × r + v_rel."""
        return vector_sum(self.origin("velocity"), cross_product(self.omega, self.place), self.slip)

    def acceleration(self) -> Triple:
        """a = a_frame + Ω̇ × r + Ω × (Ω × r) + 2 Ω × v_rel + a_rel."""
        return vector_sum(self._led(), self.faster)

    def _led(self) -> Triple:
        """a_frame + Ω̇ × r + Ω × (Ω × r) + 2 Ω × v_rel: the acceleration of what goes on with v_rel in the frame."""
        return vector_sum(
            self.origin("acceleration"),
            cross_product(self.alpha, self.place),
            cross_product(self.omega, cross_product(self.omega, self.place)),
            scaled_by(TWO, cross_product(self.omega, self.slip)),
        )

    def felt(self, which: str, mass: Formula) -> Triple:
        """An inertial force; r is taken from the frame's origin."""
        arm = self.place
        if which == "centrifugal":
            return scaled_by(negate(mass), cross_product(self.omega, cross_product(self.omega, arm)))
        if which == "euler":
            return scaled_by(negate(mass), cross_product(self.alpha, arm))
        return scaled_by(negate(multiply(TWO, mass)), cross_product(self.omega, self.slip))


def origin_of(moment: MovingBodies, frame: str) -> PointRef:
    """The point of a body from which places relative to it count: that at which a joint holds it, else its centre of mass."""
    joint = moment.held.main(frame)
    return PointRef(frame, "cm") if joint is None else joint.body


def frame_of(moment: MovingBodies, name: str) -> str:
    """The body along which another slides, or relative to which a state tells its motion; '' where there is none."""
    joint = moment.held.main(name)
    if joint is not None:
        return joint.carrier.owner if joint.sliding and joint.carrier.owner in moment.held.bodies else ""
    for word in ("position", "velocity", "acceleration"):
        told = moment.vector_told(name, word)
        if told is not None and told[2]:
            return told[2]
    return ""


def inertial_force(moment: MovingBodies, path: Path, frame: str, which: str) -> tuple[Triple, Axes]:
    """An inertial force on a body, in the axes of the frame in which it is felt."""
    if not frame or not (frame_of(moment, path.owner) or moment.place_in(path.owner, frame)):
        raise NotYet(
            f"`{path_text(path)}` is felt in a frame that turns, and nothing tells which",
            path.span,
            f"tell `{path.owner}.position relative to FRAME` in the state",
        )
    relative = Relative(moment, path.owner, frame)
    return relative.felt(which, moment.held.mass(path.owner)), relative.axes
