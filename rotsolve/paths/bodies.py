"""Questions about a whole body: velocity, energy, momentum, moment of inertia, torque, force, power."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Number, negate, total
from rotsolve.core.facts import Couple, Force, signed, square
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.core.writing import spoken
from rotsolve.elements.shapes import rim_radius, rivals, shape_of
from rotsolve.language.problem import Path, PointRef, Term
from rotsolve.laws.energy import kinetic
from rotsolve.laws.newton import torque_about
from rotsolve.motion.rigid import mass_of, moment_about, tidy
from rotsolve.paths.meaning import NATURAL, AtInstant, Meaning, Meant, NotYet, about_centre, path_text, vector_size
from rotsolve.paths.shares import Share, joined, place_about, share_of

HALF = Number(Fraction(1, 2))


class OfBodies(AtInstant, frozen=True):
    """Reads paths of bodies at one instant."""

    def of_body(self, path: Path, term: Term | None) -> Meant:
        """A quantity of a whole body."""
        if path.quantity not in OF_BODIES:
            raise NotYet(f"`{path.quantity}` of `{path.owner}` is not solved yet")
        return OF_BODIES[path.quantity](self, path, term)

    def angle(self, path: Path, term: Term | None) -> Formula:
        return self.instant.angle_of(path.owner)

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
        """Where v + ω × r = 0, from the body's own centre of mass: x = −v_y/ω, y = vₓ/ω."""
        body = self.body(path.owner)
        self._refuse_on_shaft(path)
        if body.motion.spin == ZERO:
            raise NotYet(f"`{path.owner}` does not turn: no point of it is at rest")
        if path.component is None:
            raise NotYet("the instantaneous centre is asked by its components", help=f"ask for `{path_text(path)}.x`")
        axis = RIGHT if path.component == "x" else UP
        way = body.motion.velocity.turned(90).along(axis)
        own = self.instant.point(PointRef(path.owner, "cm"))
        place = (way / body.motion.spin if way != ZERO else ZERO) - own.along(axis)
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
        line, own = self.instant.line(host), self.instant.line_of(path.owner)
        letter = self.instant.travel(path.quantity, host, line[1] if line else "")
        if own is None and line is not None:
            raise NotYet(
                f"`{path.owner}` moves across the way that it `moves`", help="ask for its velocity by `x` and `y`"
            )
        return letter if own == line else negate(letter)

    def height_above(self, path: Path, term: Term | None) -> Formula:
        """Height above the level that the scene counts from."""
        name, host = path.owner, self.instant.host(path.owner)
        from rotsolve.motion.places import height

        above = height(host, self.instant)
        if self.instant.motion(name).kind == "axis":
            help = f"ask for `change of {name}.potential_energy`, or for the displacement of a point: `{name}.cm.displacement.y`"
            raise NotYet(
                f"above which level `{name}`, which turns about a fixed point, is high, the scene does not tell",
                help=help,
            )
        if above is not None and host != name:
            above = above + self.instant.point(PointRef(name, "cm")).along(UP)
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
        return self.instant.rate_of(path.quantity, name)

    def kinetic_energy(self, path: Path, term: Term | None) -> Formula:
        """½ m v² + ½ I ω², or one of both; of a body joined to others, that of its own mass. About a fixed axis all of it is rotation."""
        name, component = path.owner, path.component
        share = self.share(name)
        if component is not None:
            self._refuse_on_shaft(path, "ask for the whole `kinetic_energy`")
        if component == "translational":
            return ZERO if share.motion.kind == "axis" else total(share.translational())
        if component == "rotational":
            return HALF * share.moment * square(share.motion.spin)
        return share.kinetic_energy() if joined(name, self.instant) else total(kinetic([self.body(name)]))

    def share(self, name: str) -> Share:
        """What a body has of its own."""
        return share_of(name, self.instant, self.body(name))

    def radius(self, path: Path, term: Term | None) -> Formula:
        """Radius of a round body; of a particle, its distance from the axis."""
        body = self.instant.body(path.owner)
        if rivals(body, None):
            listed = ", ".join(f"`{name}`" for name in rivals(body, None))
            raise NotYet(
                f"`{path.owner}` has the rims {listed}: the radius of which one?", help="ask for its letter in `radii`"
            )
        radius = rim_radius(body, None) or getattr(body.shape, "radius", None)
        if radius is None or radius == ZERO:
            raise NotYet(f"`{path.owner}` has no radius")
        return radius

    def length(self, path: Path, term: Term | None) -> Formula:
        """Length of a rod, or along the axis of what is round."""
        length: Formula | None = getattr(self.instant.body(path.owner).shape, "length", None)
        if length is None:
            raise NotYet(f"`{path.owner}` has no length")
        return length

    def angular_momentum(self, path: Path, term: Term | None) -> Meant:
        """I ω + r × m v about the axis, its own centre of mass or a point; with a component, by the tensor; of a part its share."""
        self._refuse_on_shaft(path)
        if path.component is not None:
            return self.spread(path, term)
        name, about = path.owner, term.about if term is not None else None
        share = self.share(name)
        if path.point:
            return self._share(path)
        if about is None and self.body(name).inertia is None:
            raise NotYet(f"`{name}` does not turn", help="say `about` which point its angular momentum is asked")
        point = None if about is None else place_about(about, name, self.instant)
        return signed(share.angular_momentum(point), self.instant.sense(name))

    def _refuse_on_shaft(self, path: Path, help: str = "") -> None:
        """What a body has on a turning shaft that points out of the picture is not told."""
        if self.instant.motion(path.owner).whirl is not None:
            raise NotYet(f"`{path_text(path)}` of a body on a turning `shaft` is not solved yet", help=help)

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

    def momentum(self, path: Path, term: Term | None) -> Meant:
        """m v along the line of travel, a component of it, or its size."""
        share, component = self.share(path.owner), path.component
        if component not in ("x", "y"):
            self._refuse_on_shaft(path, "ask for the `speed` of its `cm`")
        if component in ("x", "y"):
            return share.mass * share.velocity.along(RIGHT if component == "x" else UP)
        line = self.instant.line_of(path.owner)
        if line is not None and not (share.motion.turns and share.cm.parts):
            return share.mass * share.velocity.along(line[0])
        momentum = share.momentum()
        return Meaning(vector_size(momentum), QUANTITIES["momentum"].dimension, momentum)

    def torque(self, path: Path, term: Term | None) -> Formula:
        """Of all that acts on it, about the axis, its own centre of mass (I α) or a point; with a component that of the weight, or of
        one of its forces."""
        path = replace(path, component=None) if path.component == "z" else path
        name, about = path.owner, term.about if term is not None else None
        share = self.share(name)
        point = None if about is None else place_about(about, name, self.instant)
        sense = self.instant.sense(name)
        if path.component in (None, "net") and joined(name, self.instant):
            return signed(share.torque(point), sense)
        arm = share.base if point is None else point
        forces, couples = self._acting(path)
        torques = [
            force.torque if arm == share.base and not arm.parts else torque_about(arm, force) for force in forces
        ]
        return total([signed(torque, sense) for torque in (*torques, *(couple.torque for couple in couples))])

    def _acting(self, path: Path) -> tuple[list[Force], list[Couple]]:
        """What acts on a body: all, its own weight, or what the element does that the path names."""
        body, wanted = self.body(path.owner), path.component
        forces = [force for force in body.forces if wanted in (None, "net", "x", "y", force.owner or "gravity")]
        if wanted == "gravity":
            forces = [force for force in body.forces if force.role.weighs and force.part in ("", path.owner)]
        couples = [couple for couple in body.couples if wanted in (None, "net", couple.owner)]
        acting = self.instant.configuration.acting(self.instant.state)
        touched = next((item.touches() for item in acting if item.name == wanted), ())
        if touched and path.owner not in {ref.owner for ref in touched}:
            raise NotYet(f"`{wanted}` does not act on `{path.owner}`")
        if touched and not forces and not couples and joined(path.owner, self.instant):  # within what is joined
            help = f"ask for what it does itself, such as `{wanted}.force`"
            raise NotYet(f"what `{wanted}` does to `{path.owner}` alone is not solved yet", help=help)
        return forces, couples

    def force(self, path: Path, term: Term | None) -> Meant:
        """Resultant of the forces on a body, m a: its size or a component; with `gravity` the weight alone, or one of its forces."""
        name, component, dimension = path.owner, path.component, QUANTITIES["force"].dimension
        share = self.share(name)
        pull = share.acceleration.scaled(share.mass)
        if component in ("x", "y"):
            side = RIGHT if component == "x" else UP
            if joined(name, self.instant):
                return pull.along(side)
            return sum((force.vector for force in self.body(name).forces), Vector()).along(side)
        if component in NATURAL:
            if not share.cm.parts or not share.axial:
                raise NotYet(
                    f"`{name}` does not swing about a pivot: a tangential or normal part has no meaning",
                    help="ask for `x` or `y`",
                )
            part = about_centre(pull, share.cm, self.instant.sense(name), component or "")
            return Meaning(part, dimension, label=f"{component} part of the resultant on {spoken(name)}")
        if component in (None, "net"):
            return Meaning(vector_size(pull), dimension, pull, label=f"resultant force on {spoken(name)}")
        forces, _ = self._acting(path)
        vector = tidy(Vector(tuple(part for force in forces for part in force.vector.parts)))
        size = total([force.size for force in forces]) if component == "gravity" else vector_size(vector)
        return Meaning(size, dimension, vector)

    def power(self, path: Path, term: Term | None) -> Formula:
        """Σ F·v + Σ τ ω, of one of several that are joined m a·v + I α ω; with a component that of the weight, or of one of its forces."""
        name = path.owner
        share = self.share(name)
        if path.component in (None, "net") and joined(name, self.instant):
            turning = share.moment * share.motion.spin_rate * share.motion.spin
            moving = ZERO if share.axial else share.mass * share.acceleration.dot(share.velocity)
            return total([part for part in (moving, turning) if part != ZERO])
        forces, couples = self._acting(path)
        parts = [force.vector.dot(share.motion.velocity_of(force.arm)) for force in forces]
        return total(parts + [couple.torque * share.motion.spin for couple in couples])


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
    "length": OfBodies.length,
    "mass": OfBodies.mass,
    "inertia": OfBodies.spread,
    "gyration": OfBodies.spread,
    "inertia_tensor": OfBodies.spread,
    "cm": OfBodies.spread,
}
