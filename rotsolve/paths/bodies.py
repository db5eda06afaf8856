"""Questions about a whole body: velocity, energy, momentum, moment of inertia, torque, force, power."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import combinations
from typing import TYPE_CHECKING

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Number, total
from rotsolve.core.facts import BodyFacts, signed, square
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.core.writing import spoken
from rotsolve.elements.shapes import rim_radius, shape_of
from rotsolve.language.problem import Path, PointRef, Term
from rotsolve.laws.energy import kinetic
from rotsolve.motion.places import height
from rotsolve.motion.rigid import centre_of_mass, mass_of, moment_about, pieces, tidy
from rotsolve.paths.meaning import NATURAL, AtInstant, Meaning, Meant, NotYet, about_centre, path_text, vector_size

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant

HALF = Number(Fraction(1, 2))


class OfBodies(AtInstant, frozen=True):
    """Reads paths of bodies at one instant."""

    def of_body(self, path: Path, term: Term | None) -> Meant:
        """A quantity of a whole body."""
        if path.quantity not in OF_BODIES:
            raise NotYet(f"`{path.quantity}` of `{path.owner}` is not solved yet")
        return OF_BODIES[path.quantity](self, path, term)

    def angle(self, path: Path, term: Term | None) -> Formula:
        return self.instant.ask("angle", self.instant.host(path.owner), words=("counterclockwise", "clockwise"))

    def period(self, path: Path, term: Term | None) -> Formula:
        return self.instant.ask("period", self.instant.host(path.owner))

    def speed(self, path: Path, term: Term | None) -> Formula:
        return vector_size(self.instant.motion(path.owner).velocity)

    def mass(self, path: Path, term: Term | None) -> Meant:
        """The mass of the table of shapes, else by integration."""
        body = self.instant.body(path.owner)
        return mass_of(body) if shape_of(body).tabled else self.spread(path, term)

    def spread(self, path: Path, term: Term | None) -> Meant:
        """How the mass is spread: moment of inertia, radius of gyration, tensor, centre of mass, angular momentum in space."""
        from rotsolve.paths.inertias import OfInertias

        return OfInertias(self.instant, self.facts).meaning(path, term)

    def instantaneous_centre(self, path: Path, term: Term | None) -> Meaning:
        """Where v + ω × r = 0, from the centre of mass: x = −v_y/ω, y = vₓ/ω."""
        body = self.body(path.owner)
        if body.motion.spin == ZERO:
            raise NotYet(f"`{path.owner}` does not turn: no point of it is at rest")
        if path.component is None:
            raise NotYet("the instantaneous centre is asked by its components", help=f"ask for `{path_text(path)}.x`")
        axis = RIGHT if path.component == "x" else UP
        way = body.motion.velocity.turned(90).along(axis)
        place = (way / body.motion.spin if way != ZERO else ZERO) - body.cm.along(axis)
        label = f"instantaneous centre of {path.owner.replace('_', ' ')}, v + ω × r = 0, from its centre of mass"
        return Meaning(place, QUANTITIES["instantaneous_centre"].dimension, label=label)

    def travel(self, path: Path, term: Term | None) -> Formula:
        """Velocity or acceleration along a body's line, a component of it, or its part towards the centre of a circle."""
        host = self.instant.host(path.owner)
        motion, orbit = self.instant.motion(path.owner), self.instant.orbit(host)
        vector = motion.velocity if path.quantity == "velocity" else motion.acceleration
        if path.component in ("x", "y"):
            return vector.along(RIGHT if path.component == "x" else UP)
        if path.component == "normal" and path.quantity == "acceleration" and orbit is not None:
            if motion.bend is None:
                raise NotYet(f"how `{path.owner}` bends off its way, the scene does not tell")
            return vector.along(motion.bend.outward.turned(180))
        if path.component == "normal":
            return ZERO
        line = self.instant.line(host)
        return self.instant.travel(path.quantity, host, line[1] if line else "")

    def height_above(self, path: Path, term: Term | None) -> Formula:
        """Height above the level that the scene counts from."""
        name, host = path.owner, self.instant.host(path.owner)
        above = height(host, self.instant)
        if above is None:
            help = "of what travels along a straight line say how far it goes"
            help += f": `{name}.displacement: h/sin(beta)` along a slope, `{name}.displacement: h` straight up or down"
            raise NotYet(f"how high `{name}` is, the scene does not tell", help=help if self.instant.line(host) else "")
        return above

    def rate(self, path: Path, term: Term | None) -> Formula:
        """Angular velocity or acceleration of a body that turns."""
        name = path.owner
        if not self.instant.motion(name).turns:
            raise NotYet(f"`{name}` does not turn", help="a body turns on an axle or hinge, or where it says `turns`")
        return self.instant.rate(path.quantity, self.instant.host(name))

    def kinetic_energy(self, path: Path, term: Term | None) -> Formula:
        """½ m v² + ½ I ω²; of a body joined to others, that of its own mass."""
        name, component = path.owner, path.component
        if self._joined(name) and component is None:
            motion, mass = self.instant.motion(name), mass_of(self.instant.body(name))
            turning = HALF * self._own_moment(name, about_axis=motion.kind == "axis") * square(motion.spin)
            if motion.kind == "axis":
                return total([turning, HALF * mass * square(self.instant.outward(name))])
            velocity = self.instant.velocity(PointRef(name, "cm"))
            return total([HALF * mass * velocity.dot(velocity), turning])
        body = self.body(name)
        terms = kinetic([body])
        if component == "rotational" and body.inertia is not None:
            terms = [HALF * body.inertia.letter * square(body.motion.spin)]
        if component == "translational":
            parts = body.centre_velocity.parts
            across = all((one - other).cos() == ZERO for (_, one), (_, other) in combinations(parts, 2))
            whole = [body.centre_velocity.dot(body.centre_velocity)]
            terms = [HALF * body.mass * item for item in ([square(size) for size, _ in parts] if across else whole)]
        return total(terms)

    def _joined(self, name: str) -> bool:
        """Whether a body moves as one with others, so that its own share has to be told apart."""
        return self.instant.host(name) != name or bool(self.instant.configuration.cluster(name, self.instant.state))

    def _own_moment(self, name: str, *, about_axis: bool = True) -> Formula:
        """InstantFacts of inertia of one of several joined bodies: about its own centre of mass, or I + m d² about the axis of all."""
        items = pieces(self.instant.body(name))
        order = self.instant.configuration.order
        own, _ = moment_about(items, centre_of_mass(items), order)
        if not about_axis:
            return own
        arm = self.instant.point(PointRef(name, "cm"))
        return simplify(own + mass_of(self.instant.body(name)) * arm.dot(arm), order=order)

    def radius(self, path: Path, term: Term | None) -> Formula:
        """Radius of a round body; of a particle, its distance from the axis."""
        body = self.instant.body(path.owner)
        radius = rim_radius(body, None) or getattr(body.shape, "radius", None)
        if radius is None or radius == ZERO:
            raise NotYet(f"`{path.owner}` has no radius")
        return radius

    def angular_momentum(self, path: Path, term: Term | None) -> Meant:
        """About the axis or a point; with a component, by the tensor; of a part of a body, its share."""
        if path.component is not None:
            return self.spread(path, term)
        return self._share(path) if path.point else self._spin_or_orbital(path.owner, term)

    def _spin_or_orbital(self, name: str, term: Term | None) -> Formula:
        """I ω about the axis or the centre of mass; of a body without spin of its own, r × m v about a named point."""
        body = self.body(name)
        if self._joined(name) and body.motion.kind == "axis":
            return self._own_moment(name) * signed(body.motion.spin, body.motion.sense)
        about = term.about if term is not None else None
        if about is not None and body.motion.kind != "axis":
            return self._orbital(body, about)
        if body.inertia is None:
            raise NotYet(f"`{name}` does not turn", help="say `about` which point its angular momentum is asked")
        return body.inertia.letter * signed(body.motion.spin, body.motion.sense)

    def _share(self, path: Path) -> Formula:
        """(I + m r²) ω of one part of a body on a fixed axis."""
        motion, own = self.instant.motion(path.owner), self.instant.frame(path.owner)
        own_pieces = tuple(piece for piece in own.pieces if piece.name == path.point)
        if motion.kind != "axis" or not own_pieces:
            raise NotYet(
                f"the angular momentum of `{path.owner}.{path.point}` alone is not solved yet",
                help="solved is that of a part of a body on a fixed axis",
            )
        moment, _ = moment_about(own_pieces, own.reference, self.instant.configuration.order)
        return moment * signed(motion.spin, motion.sense)

    def _orbital(self, body: BodyFacts, about: PointRef) -> Formula:
        """r × m v + I ω about a point of its own, or of a body that it is about to touch: the place from that body's pivot."""
        instant = self.instant
        own = instant.host(about.owner) == body.name
        place = body.cm - instant.point(about) if own else meeting_place(body.name, about, instant)
        spin = body.inertia.letter * body.motion.spin if body.inertia is not None else ZERO
        orbital = place.cross(body.centre_velocity.scaled(body.mass))
        return total([signed(part, body.motion.sense) for part in (orbital, spin)])

    def momentum(self, path: Path, term: Term | None) -> Meant:
        """m v along the line of travel, a component of it, or its size."""
        body, component = self.body(path.owner), path.component
        if component in ("x", "y"):
            return body.mass * body.centre_velocity.along(RIGHT if component == "x" else UP)
        if body.motion.kind == "line" and body.motion.heading is not None:
            return body.mass * body.motion.velocity.along(body.motion.heading)
        momentum = body.centre_velocity.scaled(body.mass)
        return Meaning(vector_size(momentum), QUANTITIES["momentum"].dimension, momentum)

    def torque(self, path: Path, term: Term | None) -> Formula:
        """Net torque about the reference (I α), or that of the weight alone."""
        body, alone = self.body(path.owner), path.component == "gravity"
        wanted = [force for force in body.forces if force.role.weighs] if alone else body.acting
        return total([signed(item.torque, body.motion.sense) for item in wanted])

    def force(self, path: Path, term: Term | None) -> Meant:
        """Resultant of the forces on a body, m a: its size or a component; with `gravity` the weight alone."""
        name, component, dimension = path.owner, path.component, QUANTITIES["force"].dimension
        body = self.body(name)
        if component == "gravity":
            weight = Vector(tuple(part for force in body.forces if force.role.weighs for part in force.vector.parts))
            size = total([force.size for force in body.forces if force.role.weighs])
            return Meaning(size, dimension, tidy(weight))
        if component in ("x", "y"):
            return sum((force.vector for force in body.forces), Vector()).along(RIGHT if component == "x" else UP)
        pull = body.centre_acceleration.scaled(body.mass)
        if component in NATURAL:
            if not body.cm.parts:
                raise NotYet(
                    f"`{name}` does not swing about a pivot: a tangential or normal part has no meaning",
                    help="ask for `x` or `y`",
                )
            part = about_centre(pull, body.cm, body.motion.sense, component or "")
            return Meaning(part, dimension, label=f"{component} part of the resultant on {spoken(name)}")
        return Meaning(vector_size(pull), dimension, pull, label=f"resultant force on {spoken(name)}")

    def power(self, path: Path, term: Term | None) -> Formula:
        """Σ F·v + Σ τ ω; with `gravity` that of the weight alone."""
        body, alone = self.body(path.owner), path.component == "gravity"
        forces = [force for force in body.forces if force.role.weighs or not alone]
        parts = [force.vector.dot(body.motion.velocity_of(force.arm)) for force in forces]
        return total(parts + [couple.torque * body.motion.spin for couple in body.couples if not alone])


OF_BODIES: dict[str, Callable[[OfBodies, Path, Term | None], Meant]] = {  # what can be asked of a whole body
    "angle": OfBodies.angle,
    "angular_velocity": OfBodies.rate,
    "angular_acceleration": OfBodies.rate,
    "velocity": OfBodies.travel,
    "acceleration": OfBodies.travel,
    "speed": OfBodies.speed,
    "height": OfBodies.height_above,
    "period": OfBodies.period,
    "instantaneous_centre": OfBodies.instantaneous_centre,
    "kinetic_energy": OfBodies.kinetic_energy,
    "momentum": OfBodies.momentum,
    "angular_momentum": OfBodies.angular_momentum,
    "torque": OfBodies.torque,
    "force": OfBodies.force,
    "power": OfBodies.power,
    "radius": OfBodies.radius,
    "mass": OfBodies.mass,
    "inertia": OfBodies.spread,
    "gyration": OfBodies.spread,
    "inertia_tensor": OfBodies.spread,
    "cm": OfBodies.spread,
}


def meeting_place(name: str, about: PointRef, instant: Instant) -> Vector:
    """Where a body is when it meets another in an event, seen from the pivot or point `about`."""
    configuration = instant.configuration
    for interval in configuration.timeline.intervals:
        refs = interval.event.points(configuration.problem.connections) if interval.event is not None else ()
        if instant.state in (interval.start, interval.end) and any(ref.owner == name for ref in refs):
            other = next((ref for ref in refs if ref.owner != name), None)
            if other is not None:
                return instant.point(other)
    help = f"name a point of `{name}`, or of what it meets in an event"
    raise NotYet(f"where `{name}` is, seen from `{about.owner}`, is not known", help=help)
