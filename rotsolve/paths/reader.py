"""Questions: what a path of the scene language stands for, as a formula in the quantities of the laws.

`rod.end.acceleration` becomes L |α| where the rod is at rest, with the direction of the vector kept for the words of the answer.
"""

from __future__ import annotations

from collections.abc import Callable

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, total
from rotsolve.core.equation import KINETIC_ENERGY
from rotsolve.core.facts import signed
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.vectors.directions import opposite
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.language.problem import Path, Term
from rotsolve.laws.energy import kinetic
from rotsolve.motion.rigid import tidy
from rotsolve.paths.bodies import OfBodies
from rotsolve.paths.elements import OfElements
from rotsolve.paths.meaning import AtInstant, Meaning, Meant, NotYet, label_of, vector_size
from rotsolve.paths.points import OF_POINTS, OfPoints

BY_INTEGRATION = ("inertia", "gyration", "inertia_tensor", "cm")


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
            found = self.of_scene(path)
        else:
            found = OfElements(self.instant, self.facts).of_element(path)
        kind = QUANTITIES[path.quantity]
        if term is not None and term.by is not None and path.quantity not in BY_INTEGRATION:
            raise NotYet(
                f"`{path.quantity}` is not asked for `by {term.by}`", help=f"ask so for {', '.join(BY_INTEGRATION)}"
            )
        meaning = found if isinstance(found, Meaning) else Meaning(found, kind.dimension)
        words = meaning.words if any(meaning.words) else self._words(path)
        law = KINETIC_ENERGY if path.quantity == "kinetic_energy" else meaning.law
        return replace(meaning, label=meaning.label or label_of(path, term), law=law, words=words)

    def is_flat(self, name: str, term: Term) -> bool:
        """Whether all parts of a body lie at the height of the point about which is asked."""
        from rotsolve.paths.inertias import OfInertias

        return OfInertias(self.instant, self.facts).is_flat(name, term)

    def _words(self, path: Path) -> tuple[str, str]:
        """The two directions of a signed quantity: of a component, or of a turn."""
        if path.quantity == "cm" or (path.quantity == "angular_momentum" and path.component):
            return ("", "")  # a coordinate, or a part along an axis: its sign says all
        if path.component in ("x", "y"):
            return ("right", "left") if path.component == "x" else ("up", "down")
        if path.quantity in ("torque", "angular_momentum"):
            name = path.owner if path.owner in self.instant.configuration.bodies else self._turned_by(path.owner)
            return self.instant.turn_words(self.instant.host(name)) if name else ("", "")
        if path.owner in self.instant.configuration.bodies and not (path.point or path.component):
            return self._senses(self.instant.host(path.owner), path.quantity)
        return ("", "")

    def _senses(self, name: str, quantity: str) -> tuple[str, str]:
        """The two senses of a body's turn, or of its travel along its line."""
        if quantity in ("angular_velocity", "angular_acceleration"):
            return self.instant.turn_words(name)
        line = self.instant.configuration.line(name, self.instant.state)
        return (line[1], opposite(line[1])) if line and quantity in ("velocity", "acceleration") else ("", "")

    def of_scene(self, path: Path) -> Meant:
        """A quantity of all bodies together."""
        found = OF_SCENE[path.quantity](self, path) if path.quantity in OF_SCENE else None
        if found is None:
            raise NotYet(f"`{path.quantity}` of the whole scene is not solved yet")
        return found

    def kinetic_energy(self, path: Path) -> Formula:
        return total(kinetic(list(self.facts().bodies)))

    def angular_momentum(self, path: Path) -> Formula | None:
        """Σ I ω of bodies that all turn about fixed axes, along the first one's positive turn."""
        bodies = self.facts().bodies
        if any(body.motion.kind != "axis" for body in bodies):
            return None
        sense = bodies[0].motion.sense
        return total([body.inertia.letter * signed(body.motion.spin, sense) for body in bodies if body.inertia])

    def momentum(self, path: Path) -> Meant:
        """Σ m v: a component of it, or its size."""
        momenta = [body.centre_velocity.scaled(body.mass) for body in self.facts().bodies]
        whole = tidy(Vector(tuple(part for momentum in momenta for part in momentum.parts)))
        if path.component is not None:
            return whole.along(RIGHT if path.component == "x" else UP)
        return Meaning(vector_size(whole), QUANTITIES["momentum"].dimension, whole)

    def time(self, path: Path) -> Formula:
        return self.instant.time()

    def mass(self, path: Path) -> Formula:
        return total([body.mass for body in self.facts().bodies])


OF_SCENE: dict[str, Callable[[PathReader, Path], Meant | None]] = {  # what can be asked of the whole scene
    "kinetic_energy": PathReader.kinetic_energy,
    "angular_momentum": PathReader.angular_momentum,
    "momentum": PathReader.momentum,
    "time": PathReader.time,
    "mass": PathReader.mass,
}
