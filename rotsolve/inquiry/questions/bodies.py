"""Questions about a body or a point of one: velocity, energy, momentum, moment of inertia, torque, force, power."""

from __future__ import annotations

from fractions import Fraction

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Number, sqrt, total
from rotsolve.core.facts import BodyFacts, signed, square
from rotsolve.core.heading import RIGHT, UP, Vector, unit
from rotsolve.core.quantity import BY_WORD, INSIDE
from rotsolve.elements.rims import rim_radius, shape_of
from rotsolve.inquiry.questions.meaning import Meaning, NotYet, size_of, spoken_point
from rotsolve.inquiry.questions.moment import Moment
from rotsolve.motion.instant import Instant, locate
from rotsolve.motion.passages import height
from rotsolve.motion.rigid import centre_of_mass, mass_of, moment_about, pieces, tidy
from rotsolve.principles.energy import kinetic
from rotsolve.scene.model import Path, PointRef, Term

HALF = Number(Fraction(1, 2))


class OfBodies(Moment):
    """Reads paths of bodies at one instant."""

    def at_point(self, path: Path) -> bool:
        """Whether the path speaks of a point: a named one, or the centre of mass of what turns about another point."""
        return path.quantity in ("velocity", "speed", "acceleration", *INSIDE) and (
            path.point is not None or not self._travels(path)
        )

    def _travels(self, path: Path) -> bool:
        motion = self.instant.motion(path.owner)
        return motion.kind == "line" and self.instant.host(path.owner) == path.owner

    def of_point(self, path: Path) -> Meaning:
        """Velocity or acceleration of a point: its size, or a component."""
        instant = self.instant
        if path.quantity in INSIDE:
            return self._inside(path)
        ride = instant.arrangement.ride(path.owner, instant.state)
        if ride is not None and path.quantity in ("velocity", "speed") and path.point in (None, "cm"):
            return self._of_rider(path)
        ref = PointRef(path.owner, path.point or "cm", path.argument)
        motion, arm = instant.motion(path.owner), instant.point(ref)
        vector = motion.acceleration_of(arm) if path.quantity == "acceleration" else motion.velocity_of(arm)
        dimension = BY_WORD[path.quantity].dimension
        if path.component in ("x", "y"):
            return Meaning(vector.along(RIGHT if path.component == "x" else UP), dimension)
        if path.component in ("tangential", "normal"):
            turned = arm.turned(90).times(motion.spin_rate if path.quantity == "acceleration" else motion.spin)
            inward = arm.turned(180).times(square(motion.spin)) if path.quantity == "acceleration" else Vector()
            part = turned if path.component == "tangential" else inward
            return Meaning(size_of(part, signed_by=motion.sense), dimension, part)
        label = f"{path.quantity} of {spoken_point(path)}"
        remark = (
            "at rest: no centripetal part"
            if path.quantity == "acceleration" and motion.spin == ZERO and motion.turns
            else ""
        )
        return Meaning(size_of(vector), dimension, vector, remark, label)

    def _inside(self, path: Path) -> Meaning:
        """What acts at a cut through a rod."""
        same = (path.owner, path.point, path.argument)
        cuts = self.instant.arrangement.cuts.items()
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
        instant = self.instant
        letter = instant.ask(path.quantity, path.owner, when=instant.span(path.owner), component=index)
        return Meaning(letter, BY_WORD[path.quantity].dimension)

    def _of_rider(self, path: Path) -> Meaning:
        """Velocity of what slides along another body: ω r across, and its speed along that body."""
        instant, name, dimension = self.instant, path.owner, BY_WORD[path.quantity].dimension
        motion = instant.motion(name)
        outward = unit(motion.orientation).times(instant.outward(name))
        across = unit(motion.orientation.turned(90)).times(self._radius(name) * motion.spin)
        if path.component in ("radial", "tangential"):
            part, sense = (outward, 1) if path.component == "radial" else (across, motion.sense)
            words = ("outwards", "inwards") if path.component == "radial" else ("", "")
            return Meaning(size_of(part, signed_by=sense), dimension, words=words)
        vector = across + outward
        if path.component in ("x", "y"):
            return Meaning(vector.along(RIGHT if path.component == "x" else UP), dimension)
        return Meaning(size_of(vector), dimension, label=f"{path.quantity} of {spoken_point(path)}")

    def of_body(self, path: Path, term: Term | None) -> Formula | Meaning:
        """A quantity of a whole body."""
        instant, name, component = self.instant, path.owner, path.component
        host = instant.host(name)
        match path.quantity:
            case "angle":
                return instant.ask("angle", host, words=("counterclockwise", "clockwise"))
            case "angular_velocity" | "angular_acceleration":
                return self._rate(path.quantity, name)
            case "velocity" | "acceleration":
                return self._travel(path, host)
            case "height":
                return self._height(name, host)
            case "speed":
                return size_of(instant.motion(name).velocity)
            case "kinetic_energy":
                return self._kinetic(name, component)
            case "mass":
                return mass_of(instant.body(name))
            case "radius":
                return self._radius(name)
            case "inertia" | "gyration":
                return self._inertia(path, term)
            case "angular_momentum":
                return self._angular_momentum(name, term)
            case "momentum":
                return self._momentum(name, component)
            case "torque":
                return self._torque(name, component, term)
            case "force":
                return self._force(name, component)
            case "power":
                return self._power(name, component)
            case "cm":
                centre = instant.frame(name).cm + instant.frame(name).reference
                return centre.along(UP if component == "y" else RIGHT)
        raise NotYet(f"`{path.quantity}` of `{name}` is not solved yet")

    def _travel(self, path: Path, host: str) -> Formula:
        """Velocity or acceleration along a body's line, a component of it, or its part towards the centre of a circle."""
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

    def _height(self, name: str, host: str) -> Formula:
        """Height above the level that the scene counts from."""
        above = height(host, self.instant)
        if above is None:
            raise NotYet(f"how high `{name}` is, the scene does not tell")
        return above

    def _rate(self, word: str, name: str) -> Formula:
        """Angular velocity or acceleration of a body that turns."""
        if not self.instant.motion(name).turns:
            raise NotYet(f"`{name}` does not turn", help="a body turns on an axle or hinge, or where it says `turns`")
        return self.instant.rate(word, self.instant.host(name))

    def _kinetic(self, name: str, component: str | None) -> Formula:
        """½ m v² + ½ I ω²; of a body joined to others, that of its own mass."""
        if self._joined(name) and component is None:
            motion = self.instant.motion(name)
            if motion.kind == "axis":
                own = HALF * self._own_moment(name) * square(motion.spin)
                outward = HALF * mass_of(self.instant.body(name)) * square(self.instant.outward(name))
                return total([part for part in (own, outward) if part != ZERO])
            velocity = self.instant.velocity(PointRef(name, "cm"))
            own = self._own_moment(name, about_axis=False)
            return total(
                [HALF * mass_of(self.instant.body(name)) * velocity.dot(velocity), HALF * own * square(motion.spin)]
            )
        body = self.body(name)
        terms = kinetic([body])
        if component == "rotational" and body.inertia is not None:
            terms = [HALF * body.inertia.letter * square(body.motion.spin)]
        if component == "translational":
            velocity = body.centre_velocity
            terms = [HALF * body.mass * velocity.dot(velocity)]
        return total(terms)

    def _joined(self, name: str) -> bool:
        """Whether a body moves as one with others, so that its own share has to be told apart."""
        return self.instant.host(name) != name or bool(self.instant.arrangement.cluster(name, self.instant.state))

    def _own_moment(self, name: str, *, about_axis: bool = True) -> Formula:
        """Moment of inertia of one of several joined bodies: about its own centre of mass, or I + m d² about the axis of all."""
        items = pieces(self.instant.body(name))
        order = self.instant.arrangement.order
        own, _ = moment_about(items, centre_of_mass(items), order)
        if not about_axis:
            return own
        arm = self.instant.point(PointRef(name, "cm"))
        return simplify(own + mass_of(self.instant.body(name)) * arm.dot(arm), order=order)

    def _inertia(self, path: Path, term: Term | None) -> Formula:
        """Moment of inertia about the centre of mass, or about a named point or support."""
        name, instant = path.owner, self.instant
        if not shape_of(instant.body(name)).rigid:
            raise NotYet(f"`{name}` is no rigid body: it has no `{path.quantity}`")
        own = instant.frame(name)
        point = own.reference + own.cm
        if term is not None and term.about is not None:
            about = term.about
            support = next(
                (item for item in instant.arrangement.connections(instant.state) if item.name == about.owner), None
            )
            ref = next((ref for ref in support.touches() if ref.owner == name), None) if support is not None else about
            point = locate(instant.body(name), ref)
        facts = self.body(name).inertia if instant.host(name) == name else None
        if path.quantity == "inertia" and facts is not None and not tidy(point - own.reference).parts:
            return facts.letter
        moment, _ = moment_about(own.pieces, point, instant.arrangement.order)
        if path.quantity == "inertia":
            return moment
        return simplify(sqrt(moment / total([piece.mass for piece in own.pieces])))

    def _radius(self, name: str) -> Formula:
        """Radius of a round body; of a particle, its distance from the axis."""
        body = self.instant.body(name)
        radius = rim_radius(body, None) or getattr(body.shape, "radius", None)
        if radius is None or radius == ZERO:
            raise NotYet(f"`{name}` has no radius")
        return radius

    def _angular_momentum(self, name: str, term: Term | None) -> Formula:
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

    def _orbital(self, body: BodyFacts, about: PointRef) -> Formula:
        """r × m v + I ω about a point: the place where the body is about to touch another, from that body's pivot."""
        instant = self.instant
        place = meeting_place(body.name, about, instant)
        spin = body.inertia.letter * body.motion.spin if body.inertia is not None else ZERO
        orbital = place.cross(body.centre_velocity.scaled(body.mass))
        return total([part for part in (orbital, spin) if part != ZERO])

    def _momentum(self, name: str, component: str | None) -> Formula:
        """m v along the line of travel, a component of it, or its size."""
        body = self.body(name)
        if component in ("x", "y"):
            return body.mass * body.centre_velocity.along(RIGHT if component == "x" else UP)
        if body.motion.kind == "line" and body.motion.heading is not None:
            return body.mass * body.motion.velocity.along(body.motion.heading)
        return body.mass * size_of(body.centre_velocity)

    def _torque(self, name: str, component: str | None, term: Term | None) -> Formula:
        """Net torque about the reference (I α), or that of the weight alone."""
        body = self.body(name)
        wanted = [force for force in body.forces if component != "gravity" or force.role == "weight"]
        torques = [signed(force.torque, body.motion.sense) for force in wanted]
        if component != "gravity":
            torques += [signed(couple.torque, body.motion.sense) for couple in body.couples]
        return total([torque for torque in torques if torque != ZERO])

    def _force(self, name: str, component: str | None) -> Meaning | Formula:
        """Resultant of the forces on a body, m a: its size or a component; with `gravity` the weight alone."""
        body = self.body(name)
        if component == "gravity":
            return total([force.size for force in body.forces if force.role == "weight"])
        vector = Vector()
        for force in body.forces:
            vector = vector + force.vector
        if component in ("x", "y"):
            return vector.along(RIGHT if component == "x" else UP)
        pull = body.centre_acceleration.scaled(body.mass)
        if component in ("tangential", "normal"):
            part = pull.parts[:1] if component == "tangential" else pull.parts[1:]
            return Meaning(size_of(Vector(part), signed_by=body.motion.sense), BY_WORD["force"].dimension, Vector(part))
        return Meaning(size_of(pull), BY_WORD["force"].dimension, pull)

    def _power(self, name: str, component: str | None) -> Formula:
        """Σ F·v + Σ τ ω; with `gravity` that of the weight alone."""
        body = self.body(name)
        parts = [force.vector.dot(body.motion.velocity_of(force.arm)) for force in body.forces]
        if component == "gravity":
            parts = [
                force.vector.dot(body.motion.velocity_of(force.arm)) for force in body.forces if force.role == "weight"
            ]
        else:
            parts += [couple.torque * body.motion.spin for couple in body.couples]
        return total([part for part in parts if part != ZERO])


def meeting_place(name: str, about: PointRef, instant: Instant) -> Vector:
    """Where a body is when it meets another in an event, seen from the pivot or point `about`."""
    arrangement = instant.arrangement
    for interval in arrangement.timeline.intervals:
        refs = [ref for item in (interval.event,) if item is not None for ref in _points(item)]
        if instant.state in (interval.start, interval.end) and any(ref.owner == name for ref in refs):
            other = next((ref for ref in refs if ref.owner != name), None)
            if other is not None:
                return instant.point(other)
    raise NotYet(f"where `{name}` is, seen from `{about.owner}`, is not known")


def _points(event: object) -> tuple[PointRef, ...]:
    """The points of the bodies that meet in an event."""
    for word in ("joins", "collides"):
        value = getattr(event, word, None)
        if isinstance(value, tuple):
            return value
    return ()
