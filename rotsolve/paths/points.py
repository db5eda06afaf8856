"""Questions about a point of a body: its velocity, speed and acceleration, and their tangential and normal components."""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.algebra.formula import ZERO, add, divide, sqrt
from rotsolve.core.facts import Motion, Whirl, signed, square
from rotsolve.core.quantity import INSIDE, QUANTITIES
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Vector, unit
from rotsolve.language.problem import Path, PointRef
from rotsolve.paths.meaning import (
    NATURAL,
    AtInstant,
    Meaning,
    NotYet,
    absolute,
    along_path,
    arm_length,
    path_text,
    spoken_point,
    vector_size,
)


class OfPoints(AtInstant, frozen=True):
    """Reads paths of points at one instant."""

    def at_point(self, path: Path) -> bool:
        """Whether the path speaks of a point: a named one, or the centre of mass of what turns about another point, or is joined off the
        centre of what turns."""
        if path.quantity not in OF_POINTS or path.point is not None or path.component in NATURAL:
            return path.quantity in OF_POINTS
        motion = self.instant.motion(path.owner)
        if motion.kind != "line":
            return True
        return motion.turns and self.instant.host(path.owner) != path.owner and bool(self._arm(path).parts)

    def motion_of(self, path: Path) -> Meaning:
        """Velocity or acceleration of a point: as a vector with its size, or a component."""
        ride = self.instant.configuration.ride(path.owner, self.instant.state)
        if ride is not None and path.quantity in ("velocity", "speed") and path.point in (None, "cm"):
            return self._of_rider(path)
        if ride is not None and ride.free and path.quantity == "acceleration" and path.point in (None, "cm"):
            return self._bent_by_slide(path)
        motion, arm = self.instant.motion(path.owner), self._arm(path)
        if motion.whirl is not None and path.component not in ("x", "y"):
            return self._round_shaft(path, motion, motion.whirl, arm)
        vector = motion.acceleration_of(arm) if path.quantity == "acceleration" else motion.velocity_of(arm)
        dimension = QUANTITIES[path.quantity].dimension
        label = f"{path.quantity} of {spoken_point(path)}{carrying_words(motion, arm, path.quantity)}"
        if path.component in ("x", "y"):
            side, axis = ("horizontally", RIGHT) if path.component == "x" else ("vertically", UP)
            return Meaning(vector.along(axis), dimension, label=f"{label}, {side}")
        if path.component in NATURAL:
            return self._on_circle(path, motion, arm) if motion.kind == "axis" else self._on_path(path, motion, arm)
        remark = (
            "at rest: no centripetal part"
            if path.quantity == "acceleration" and motion.spin == ZERO and motion.turns and arm.parts
            else ""
        )
        shown = None if path.quantity == "speed" else vector  # a speed points nowhere
        return Meaning(vector_size(vector), dimension, shown, remark, label)

    def _round_shaft(self, path: Path, motion: Motion, whirl: Whirl, arm: Vector) -> Meaning:
        """Speed √(v² + (Ω x)²) on a turning shaft, v in the picture; while the body is steady in it a = Ω² x towards the shaft."""
        dimension, called = QUANTITIES[path.quantity].dimension, f"{path.quantity} of {spoken_point(path)}"
        asked = f"`{path_text(path)}` on the turning `shaft`"
        if path.component is not None:
            raise NotYet(
                f"{asked} is not told: its path bends in space", help="ask for its `speed`, or a part along x or y"
            )
        if path.quantity == "acceleration":
            if motion.spin != ZERO:
                raise NotYet(f"{asked} points out of the picture, too", help="ask for its parts along x and y")
            vector = motion.acceleration_of(arm)
            return Meaning(vector_size(vector), dimension, vector, label=called)
        if path.quantity == "velocity":
            raise NotYet(f"{asked} points out of the picture", help="ask for its size, the `speed`")
        across, along = whirl.across(arm), motion.velocity_of(arm)
        if not along.parts:
            return Meaning(absolute(across), dimension, label=called)
        return Meaning(sqrt(square(across) + along.dot(along)), dimension, label=called)

    def _arm(self, path: Path) -> Vector:
        """Where the point is from its body's reference."""
        return self.instant.point(PointRef(path.owner, path.point or "cm", path.argument))

    def inside(self, path: Path) -> Meaning:
        """What acts at a cut through a rod."""
        same = (path.owner, path.point, path.argument)
        cuts = self.instant.configuration.mentions.cuts.items()
        index = next(index for index, cut in cuts if (cut.owner, cut.point, cut.argument) == same)
        cut = next((cut for cut in self.facts().cuts if cut.index == index), None)
        if cut is not None and cut.jumps and path.quantity != "bending_moment":
            raise NotYet(
                f"`{path.quantity}` jumps there, where something acts on `{path.owner}`",
                help="ask for it a little before or beyond",
            )
        if cut is None:
            raise NotYet(
                f"what acts inside `{path.owner}` there is not solved yet",
                help="in a uniform rod whose loads act at named points, certainly on this or that side: give lengths numbers",
            )
        letter = self.instant.ask(path.quantity, path.owner, when=self.instant.span(path.owner), component=index)
        return Meaning(letter, QUANTITIES[path.quantity].dimension)

    def _of_rider(self, path: Path) -> Meaning:
        """Velocity of what slides along another body: ω r across, and its speed along that body."""
        instant, name, dimension = self.instant, path.owner, QUANTITIES[path.quantity].dimension
        motion = instant.motion(name)
        along, radius = instant.outward(name), getattr(instant.body(name).shape, "radius", None) or ZERO
        if path.component == "radial":
            return Meaning(along, dimension, words=("outwards", "inwards"))
        if path.component == "tangential":
            return Meaning(radius * signed(motion.spin, motion.sense), dimension)
        outward = unit(motion.orientation).times(along)
        vector = unit(motion.orientation.turned(90)).times(radius * motion.spin) + outward
        if path.component in ("x", "y"):
            return Meaning(vector.along(RIGHT if path.component == "x" else UP), dimension)
        return Meaning(vector_size(vector), dimension, label=f"{path.quantity} of {spoken_point(path)}")

    def _bent_by_slide(self, path: Path) -> Meaning:
        """Acceleration of what slides freely along another body: r α + 2 ω v across, and along it by the forces along it alone."""
        name, dimension = path.owner, QUANTITIES["acceleration"].dimension
        if path.component in NATURAL:
            help = f"ask for `{name}.acceleration`, `.x` or `.y`"
            raise NotYet(f"`{path_text(path)}` of what slides along another body is not solved yet", help=help)
        if self.facts().potentials:
            raise NotYet(f"the acceleration of `{name}`, which slides while a spring pulls, is not solved yet")
        carrier = self.body(name)
        item = next(one for one in carrier.sliding if one.name == name)
        motion, forces = carrier.motion, [force.vector for force in carrier.forces if force.part == name]
        along = divide(sum((force.along(item.outward) for force in forces), start=ZERO), item.mass)
        across = add(item.place * motion.spin_rate, 2 * motion.spin * item.speed)
        vector = unit(item.outward).times(along) + unit(item.outward.turned(90)).times(across)
        label = f"acceleration of {spoken_point(path)}"
        if path.component in ("x", "y"):
            side, axis = ("horizontally", RIGHT) if path.component == "x" else ("vertically", UP)
            return Meaning(vector.along(axis), dimension, label=f"{label}, {side}")
        return Meaning(vector_size(vector), dimension, vector, label=label)

    def place(self, path: Path) -> Meaning:
        """A component of a point's place: that of the body's reference, and from there to the point."""
        if path.component not in ("x", "y"):
            raise NotYet("a place is asked by its components", help=f"ask for `{path_text(path)}.x` and `.y`")
        name, direction = self.instant.host(path.owner), RIGHT if path.component == "x" else UP
        if self.instant.motion(name).kind != "plane":
            raise NotYet(f"where `{name}` is in the scene is not told", help="ask for a displacement")
        place = self.instant.component("position", name, path.component)
        return Meaning(add(place, self._arm(path).along(direction)), QUANTITIES["position"].dimension)

    def _on_circle(self, path: Path, motion: Motion, arm: Vector) -> Meaning:
        """About a fixed axis: r α and r ω², r ω and nothing; the tangential part counts along the positive turn."""
        rate = motion.spin_rate if path.quantity == "acceleration" else motion.spin
        if path.component == "tangential":
            part, value = arm.turned(90).times(rate), signed(rate, motion.sense)
        else:
            squared = square(motion.spin) if path.quantity == "acceleration" else ZERO
            part, value = arm.turned(180).times(squared), squared
        radius = arm_length(arm) if arm.parts else ZERO
        return Meaning(radius * value, QUANTITIES[path.quantity].dimension, part, "", self._called(path))

    def _on_path(self, path: Path, motion: Motion, arm: Vector) -> Meaning:
        """In free motion: along the point's own velocity, and square to it."""
        velocity = motion.velocity_of(arm)
        straight = motion.kind == "line" and not arm.parts and motion.heading is not None
        if straight and motion.heading is not None:
            velocity = Vector(((vector_size(velocity), motion.heading),))
        if not velocity.parts:
            raise NotYet(resting(path))
        vector = motion.acceleration_of(arm) if path.quantity == "acceleration" else motion.velocity_of(arm)
        value = along_path(vector, velocity, path.component or "")
        moving = NOWHERE if straight else velocity
        return Meaning(value, QUANTITIES[path.quantity].dimension, label=self._called(path), moving=moving)

    def _called(self, path: Path) -> str:
        return f"{path.component} {path.quantity} of {spoken_point(path)}"


OF_POINTS: dict[str, Callable[[OfPoints, Path], Meaning]] = {  # what can be asked of a point
    "position": OfPoints.place,
    **dict.fromkeys(("velocity", "speed", "acceleration"), OfPoints.motion_of),
    **dict.fromkeys(INSIDE, OfPoints.inside),
}


def carrying_words(motion: Motion, arm: Vector, quantity: str) -> str:
    """How a point moves with a body that travels and turns; nothing where that is plain."""
    if motion.kind != "plane" or motion.spin == ZERO or not arm.parts:
        return ""
    return ", a_P = a + α × r − ω² r" if quantity == "acceleration" else ", v_P = v + ω × r"


def resting(path: Path) -> str:
    """Why a point at rest has no tangential and normal components."""
    return f"{spoken_point(path)} is at rest: its path has no direction there"
