"""Paths: what a path of the scene language stands for at one moment: of a connection or action here, of bodies and points beside."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Product, Symbol, total
from rotsolve.core.equation import KINETIC_ENERGY, Equation
from rotsolve.core.facts import BodyFacts, Couple, Force, Potential, signed
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.symbols import of_kinds
from rotsolve.core.vectors.heading import RIGHT, UP, Vector, opposite
from rotsolve.core.writing import spoken
from rotsolve.language.problem import Path, PointRef, Term
from rotsolve.laws.energy import kinetic
from rotsolve.laws.newton import torque_about
from rotsolve.motion.rigid import tidy
from rotsolve.paths.bodies import OfBodies
from rotsolve.paths.meaning import (
    NATURAL,
    AtInstant,
    Meaning,
    Meant,
    NotYet,
    about_centre,
    label_of,
    path_text,
    vector_size,
)
from rotsolve.paths.points import OF_POINTS, OfPoints
from rotsolve.paths.shares import named_last, place_about, share_of

if TYPE_CHECKING:
    from rotsolve.language.elements import Connection


class Acting(Struct, frozen=True):
    """The forces and couples of one element, each with the body on which it acts, and the point about which is asked."""

    forces: list[tuple[BodyFacts, Force]]
    couples: list[tuple[BodyFacts, Couple]]
    about: PointRef | None = None


class OfElements(AtInstant, frozen=True):
    """Reads paths of connections and actions at one instant."""

    def of_element(self, path: Path, term: Term | None = None) -> Meant:
        """A force, tension, torque or power of a connection or action, or how far it is stretched or turned."""
        if path.component == "gravity":
            raise NotYet(f"`{path_text(path)}`: weight acts on bodies", path.span, "ask for that of a body")
        bodies = self.facts().bodies
        forces = [(body, force) for body in bodies for force in body.forces if force.owner == path.owner]
        couples = [(body, couple) for body in bodies for couple in body.couples if couple.owner == path.owner]
        acting = {item.name for item in self.instant.configuration.acting(self.instant.state)}
        if not forces and not couples and path.quantity != "tension" and path.owner not in acting:
            raise NotYet(f"`{path.owner}` does not act{self._moment()}")
        if (weld := self._weld(path)) is not None:
            return weld
        reading = OF_ELEMENTS.get(path.quantity)
        about = term.about if term is not None else None
        found = None if reading is None else reading(self, path, Acting(forces, couples, about))
        if found is None:
            raise NotYet(f"`{path.quantity}` of `{path.owner}` is not solved yet")
        return found

    def _weld(self, path: Path) -> Meant | None:
        """What a weld does to the body that it names last."""
        item = self._connection(path.owner)
        if item is None or not item.joined() or path.quantity not in ("force", "torque"):
            return None
        from rotsolve.paths.welded import weld_force, weld_torque

        function = weld_force if path.quantity == "force" else weld_torque
        return function(path, item, self.body(item.joined()[-1].owner), self.instant)

    def torque(self, path: Path, acting: Acting) -> Formula:
        """The couples on the last-named body (of a driven axle its friction too), and the torques of its forces: about its axis, its centre
        of mass or a point."""
        bodies = [body.name for body, _ in (*acting.couples, *acting.forces)]
        if not bodies:
            raise NotYet(f"`{path.owner}` gives no torque{self._moment()}")
        last = named_last(path.owner, bodies, self.instant)
        couples = [couple.torque for body, couple in acting.couples if body.name == last]
        forces = [(body, force) for body, force in acting.forces if body.name == last]
        point = None if acting.about is None else place_about(acting.about, last, self.instant)
        pushes = [body.torque_of(force) if point is None else torque_about(point, force) for body, force in forces]
        sense = self.instant.sense(self._turned_by(path.owner) or last)
        return total([signed(torque, sense) for torque in (*couples, *pushes)])

    def power(self, path: Path, acting: Acting) -> Formula:
        """Σ F·v + Σ τ ω; of a motor that is told by its power, just that."""
        if any(couple.role.powered for _, couple in acting.couples):
            actions = self.instant.configuration.actions(self.instant.state)
            return next(item for item in actions if item.name == path.owner).now(self.instant)
        parts = [couple.torque * body.motion.spin for body, couple in acting.couples]
        parts += [force.vector.dot(body.motion.velocity_of(force.arm)) for body, force in acting.forces]
        return total([_plain(part) for part in parts])

    def elongation(self, path: Path, acting: Acting) -> Formula:
        stored = self._stored(path.owner)
        return stored.elongation if stored is not None and stored.placed else self.instant.ask("elongation", path.owner)

    def potential_energy(self, path: Path, acting: Acting) -> Formula | None:
        """½ k x² of a spring, ½ κ θ² of a wire; that of a rope that hangs is none without a level from which it counts."""
        stored = self._stored(path.owner)
        return None if stored is None or self.length(path, acting) is not None else stored.energy

    def length(self, path: Path, acting: Acting) -> Formula | None:
        """How long a rope is that hangs, whose weight stores energy by that."""
        stored = self._stored(path.owner)
        if stored is not None and stored.elongation == self.instant.ask("length", path.owner):
            return stored.elongation
        return None

    def turning(self, path: Path, acting: Acting) -> Meant | None:
        """Where on a curved surface a body is, how far a wire between two is twisted; else how the bodies of a connection turn: the last
        against the first, or the one that it holds."""
        if path.quantity == "angle" and (contact := self._contact(path.owner)) is not None:
            return contact.touching_angle(self.instant)
        item = self._connection(path.owner)
        wound = [ref.owner for ref in item.winds() if ref.owner in self.instant.configuration.bodies] if item else []
        if path.quantity == "angle" and len(wound) == 2:
            first, last = map(self.instant.angle_of, wound)
            return last - first
        if path.quantity != "angle" and item is not None and item.between():
            return self._relative(path.quantity, *(ref.owner for ref in item.between()))
        name = self._turned_by(path.owner)
        return OfBodies(self.instant, self.facts).of_body(replace(path, owner=name), None) if name else None

    def contact_force(self, path: Path, acting: Acting) -> Meant:
        """The push of a surface or its friction, on the body that a contact names first."""
        rubs = path.quantity == "friction_force"
        item = self._connection(path.owner)
        within = item.force_within(path.quantity, self.instant) if item is not None else None
        if within is not None:
            return within
        first = self.instant.host(item.touches()[0].owner) if item is not None and item.touches() else ""
        forces = sorted(acting.forces, key=lambda pair: pair[0].name != first)
        force = next((force for _, force in forces if (force.role.rubs if rubs else force.role.presses)), None)
        if force is None:
            return ZERO
        surface = item.surface(self.instant.configuration, self.instant.state) if item is not None else None
        both = (surface.away, surface.into) if surface is not None and surface.two_sided else ("", "")
        return Meaning(force.size, QUANTITIES[path.quantity].dimension, words=(force.way, "") if rubs else both)

    def sliding(self, path: Path, acting: Acting) -> Meaning | None:
        """How fast what lies on a side of a body slides down that, as seen from the body: (v − V) · e; likewise its acceleration."""
        item = self._connection(path.owner)
        surface = item.surface(self.instant.configuration, self.instant.state) if item is not None else None
        if item is not None and surface is not None and surface.curved and surface.bearer() and path.component is None:
            return self._round_side(path, item)
        down = item.slides_down(self.instant) if item is not None else None
        if item is None or down is None or path.component is not None:
            return None
        own, under = (self.instant.motion(name) for name in (item.lying(), item.places()[0].owner))
        apart = (
            own.acceleration - under.acceleration if path.quantity == "acceleration" else own.velocity - under.velocity
        )
        label = f"{path.quantity} of {spoken(item.lying())} relative to {spoken(item.places()[0].owner)}"
        words = ("down the slope", "up the slope")
        return Meaning(apart.along(down), QUANTITIES[path.quantity].dimension, label=label, words=words)

    def _round_side(self, path: Path, item: Connection) -> Meaning | None:
        """The speed u along a round side of a body, as seen from that."""
        if path.quantity != "velocity":
            return None
        label = f"velocity of {spoken(item.lying())} relative to {spoken(item.places()[0].owner)}"
        along = self.instant.ask("velocity", item.name, when=self.instant.moving, letter="u")
        return Meaning(along, QUANTITIES["velocity"].dimension, label=label)

    def _stored(self, owner: str) -> Potential | None:
        """The energy that a spring or wire stores."""
        return next((item for item in self.facts().potentials if item.owner == owner), None)

    def _connection(self, owner: str) -> Connection | None:
        return self.instant.configuration.connection(owner, self.instant.state)

    def _contact(self, owner: str) -> Connection | None:
        """The contact of a body with a curved surface that a path names."""
        item = self._connection(owner)
        surface = item.surface(self.instant.configuration, self.instant.state) if item is not None else None
        return item if surface is not None and surface.curved else None

    def _relative(self, word: str, first: str, last: str) -> Formula:
        """Angular velocity or acceleration of the last body less that of the first, along the last one's positive turn."""
        instant = self.instant
        way = instant.sense(first) * instant.sense(last)
        return instant.rate_of(word, last) - signed(instant.rate_of(word, first), way)

    def tension(self, path: Path, acting: Acting) -> Formula:
        """The tension of a string, or of the part that leaves the body that the path names."""
        item = self._connection(path.owner)
        tension = item.tension_at(path.point, self.instant) if item is not None and path.point else None
        if tension is not None:
            return tension
        sizes = {force.size: None for _, force in acting.forces if force.role.pulls}
        told = (name for _, couple in acting.couples for name in couple.size.symbols())
        sizes |= {Symbol(name): None for name in of_kinds(told, ("tension",))}
        if not sizes:
            raise NotYet(f"`{path.owner}` does not pull{self._moment()}: it has no tension")
        if len(sizes) > 1:
            names = dict.fromkeys(ref.owner for ref in item.touches()) if item is not None else {}
            ends = ", ".join(f"`{path.owner}.{name}.tension`" for name in names)
            raise NotYet(f"the tension is not the same along `{path.owner}`", help=f"ask for that of one part: {ends}")
        return next(iter(sizes))

    def force(self, path: Path, acting: Acting) -> Meant:
        """The force on the last-named body: its components, or its size."""
        forces = acting.forces
        if not forces:
            torques = [couple.torque for _, couple in acting.couples]
            letters = of_kinds((name for torque in torques for name in torque.symbols()), ("force",))
            if letters:
                return Symbol(letters[0])
            raise NotYet(f"`{path.owner}` exerts no force{self._moment()}")
        if path.component is None and forces[-1][1].role.meshes:
            return forces[-1][1].size
        last = named_last(path.owner, [body.name for body, _ in forces], self.instant)
        self._refuse_strain(path, forces)
        vector, arm = Vector(), Vector()
        for body, force in forces:
            if body.name == last:
                vector, arm = vector + force.vector, force.arm
        if path.component in ("x", "y"):
            return vector.along(RIGHT if path.component == "x" else UP)
        if path.component in NATURAL:
            part = self._along_body(last, vector, arm, path.component or "")
            label = f"{path.component} part of the force of {spoken(path.owner)}"
            return Meaning(part, QUANTITIES["force"].dimension, label=label)
        return Meaning(vector_size(vector), QUANTITIES["force"].dimension, vector)

    def _refuse_strain(self, path: Path, forces: list[tuple[BodyFacts, Force]]) -> None:
        """No force of a support is told of a body on which something else acts in a way that nobody tells, as a belt does."""
        held = [body for body, force in forces if force.role.holds]
        hidden = next((couple for body in held for couple in body.couples if couple.role.hides), None)
        if hidden is not None:
            raise NotYet(f"the force of `{path.owner}` is not told: `{hidden.owner}` {hidden.role.hides}")

    def _along_body(self, name: str, vector: Vector, arm: Vector, component: str) -> Formula:
        """Component across the arm of the force, of a force at the pivot across the line to the centre of mass; or along it, inwards."""
        body = self.body(name)
        arm = arm if body.motion.kind == "axis" and arm.parts else body.cm
        if body.motion.kind != "axis" or not arm.parts:
            raise NotYet(
                f"`{name}` does not swing about a pivot: a tangential or normal part has no meaning",
                help="ask for `x` or `y`",
            )
        return about_centre(vector, arm, body.motion.sense, component)


OF_ELEMENTS: dict[str, Callable[[OfElements, Path, Acting], Meant | None]] = {  # what can be asked of an element
    "tension": OfElements.tension,
    "normal_force": OfElements.contact_force,
    "friction_force": OfElements.contact_force,
    "torque": OfElements.torque,
    "force": OfElements.force,
    "power": OfElements.power,
    "elongation": OfElements.elongation,
    "length": OfElements.length,
    "potential_energy": OfElements.potential_energy,
    "velocity": OfElements.sliding,
    "acceleration": OfElements.sliding,
    "angle": OfElements.turning,
    "angular_velocity": OfElements.turning,
    "angular_acceleration": OfElements.turning,
}


def _plain(part: Formula) -> Formula:
    """A product of two factors with minus signs that cancel left out."""
    from rotsolve.laws.groups import unsigned_product

    if isinstance(part, Product) and len(part.factors) == 2:
        return unsigned_product(*part.factors)
    return part


AXIAL = ("angular_velocity", "angular_acceleration", "torque")  # along z, the others in the plane
POLAR = ("velocity", "acceleration", "displacement", "position", "force", "impulse", "momentum")
OUT_OF_PLANE = {**dict.fromkeys(AXIAL, ("x", "y")), **dict.fromkeys(POLAR, ("z",))}


class PathReader(AtInstant, frozen=True):
    """Reads paths at one instant."""

    def meaning(self, path: Path, term: Term | None = None) -> Meaning:
        """The meaning of a path at this instant."""
        configuration = self.instant.configuration
        if path.component == "radial" and configuration.ride(path.owner, self.instant.state) is None:
            raise NotYet(f"`{path.owner}` slides along no other body: it has no radial velocity")
        if path.owner in configuration.bodies:
            points = OfPoints(self.instant, self.facts)
            bodies = OfBodies(self.instant, self.facts)
            found = OF_POINTS[path.quantity](points, path) if points.at_point(path) else bodies.of_body(path, term)
        elif not path.owner:
            found = self.of_scene(path, term)
        else:
            found = OfElements(self.instant, self.facts).of_element(path, term)
        found = self._in_the_plane(path, found)
        kind = QUANTITIES[path.quantity]
        meaning = found if isinstance(found, Meaning) else Meaning(found, kind.dimension)
        words = meaning.words if any(meaning.words) else self._words(path)
        law = KINETIC_ENERGY if path.quantity == "kinetic_energy" else meaning.law
        label, plain = meaning.label or label_of(path, term), not meaning.label
        return replace(meaning, label=label, plain=plain, law=law, words=words)

    def _in_the_plane(self, path: Path, found: Meant) -> Meant:
        """What is found, where it has the component that is asked: turns go about z, counterclockwise; all else lies in x and y."""
        if path.component not in OUT_OF_PLANE.get(path.quantity, ()):
            if path.component != "z" or path.quantity not in AXIAL:
                return found
            name = path.owner if path.owner in self.instant.configuration.bodies else self._turned_by(path.owner)
            formula = found.formula if isinstance(found, Meaning) else found
            return signed(formula, self.instant.sense(self.instant.host(name))) if name else formula
        raise NotYet(
            f"`{path_text(path)}`: bodies move in the plane of x and y, and turn about z",
            path.span,
            "motion in space is not solved yet",
        )

    def is_flat(self, name: str, term: Term) -> bool:
        """Whether all parts of a body lie at the height of the point about which is asked."""
        from rotsolve.paths.inertias import OfInertias

        return OfInertias(self.instant, self.facts).is_flat(name, term)

    def masses_told_twice(self) -> Iterator[Equation]:
        """What the mass and the density of a body say together, where the scene tells both."""
        from rotsolve.paths.inertias import OfInertias

        return OfInertias(self.instant, self.facts).masses_told_twice()

    def _words(self, path: Path) -> tuple[str, str]:
        """The two directions of a signed quantity: of a component, or of a turn."""
        if path.quantity == "cm" or (path.quantity == "angular_momentum" and path.component):
            return ("", "")  # a coordinate, or a part along an axis: its sign says all
        if path.component in ("x", "y"):
            return ("right", "left") if path.component == "x" else ("up", "down")
        if path.quantity in ("torque", "angular_momentum"):
            name = path.owner if path.owner in self.instant.configuration.bodies else self._turned_by(path.owner)
            return self.instant.turn_words(name) if name else ("", "")
        if path.owner in self.instant.configuration.bodies and not (path.point or path.component):
            return self._senses(path.owner, path.quantity)
        return ("", "")

    def _senses(self, name: str, quantity: str) -> tuple[str, str]:
        """The two senses of a body's turn, or of its travel along its line."""
        if quantity in ("angular_velocity", "angular_acceleration"):
            return self.instant.turn_words(name)
        line = self.instant.line_of(name) if self.instant.orbit(self.instant.host(name)) is None else None
        return (line[1], opposite(line[1])) if line and quantity in ("velocity", "acceleration") else ("", "")

    def of_scene(self, path: Path, term: Term | None) -> Meant:
        """A quantity of all bodies together."""
        reading = OF_SCENE.get(path.quantity)
        found = reading(self, path, term.about if term is not None else None) if reading is not None else None
        if found is None:
            raise NotYet(f"`{path.quantity}` of the whole scene is not solved yet")
        return found

    def kinetic_energy(self, path: Path, about: PointRef | None) -> Formula:
        return total(kinetic(list(self.facts().bodies)))

    def _off_shafts(self, path: Path) -> tuple[BodyFacts, ...]:
        """All bodies; none may be on a turning shaft, where what they have points out of the picture."""
        carried = next((body.name for body in self.facts().bodies if body.motion.whirl is not None), None)
        if carried is not None:
            raise NotYet(f"the `{path.quantity}` of all while `{carried}` is on a turning `shaft` is not solved yet")
        return self.facts().bodies

    def angular_momentum(self, path: Path, about: PointRef | None) -> Formula | None:
        """Σ (I ω + r × m v) about a point, or about the axis that all have in common; along the positive turn of the first of
        the scene, the same at every state, whatever it has been joined to."""
        bodies = self._off_shafts(path)
        turning = {body.name for body in bodies if body.motion.turns}
        names = (body.name for body in self.instant.configuration.problem.bodies)
        sense = next((self.instant.sense(name) for name in names if self.instant.host(name) in turning), 1)
        axes = {body.axis for body in bodies}
        if (
            about is None
            and (len(axes) > 1 or "" in axes)
            and any(body.motion.kind != "axis" or body.cm.parts for body in bodies)
        ):
            raise NotYet(
                "the bodies turn about no common axis", help="say `about` which point their angular momentum is asked"
            )
        parts = []
        for body in bodies:
            point = None if about is None else place_about(about, body.name, self.instant)
            parts.append(signed(share_of(body.name, self.instant, body, whole=True).angular_momentum(point), sense))
        return total([part for part in parts if part != ZERO])

    def inertia(self, path: Path, about: PointRef | None) -> Formula:
        """Σ I of all bodies about a point."""
        if about is None:
            raise NotYet("the moment of inertia of all together is asked about a point", help="say `about` which")
        parts = []
        for body in self.facts().bodies:
            share = share_of(body.name, self.instant, body, whole=True)
            parts.append(share.inertia(place_about(about, body.name, self.instant)))
        return total(parts)

    def momentum(self, path: Path, about: PointRef | None) -> Meant:
        """Σ m v: a component of it, or its size."""
        momenta = [body.centre_velocity.scaled(body.mass) for body in self._off_shafts(path)]
        whole = tidy(Vector(tuple(part for momentum in momenta for part in momentum.parts)))
        if path.component is not None:
            return whole.along(RIGHT if path.component == "x" else UP)
        return Meaning(vector_size(whole), QUANTITIES["momentum"].dimension, whole)

    def time(self, path: Path, about: PointRef | None) -> Formula:
        return self.instant.time()

    def mass(self, path: Path, about: PointRef | None) -> Formula:
        return total([body.mass for body in self.facts().bodies])


OF_SCENE: dict[
    str, Callable[[PathReader, Path, PointRef | None], Meant | None]
] = {  # what can be asked of the whole scene
    "kinetic_energy": PathReader.kinetic_energy,
    "angular_momentum": PathReader.angular_momentum,
    "inertia": PathReader.inertia,
    "momentum": PathReader.momentum,
    "time": PathReader.time,
    "mass": PathReader.mass,
}
