"""Questions: what a path of the scene language stands for, as a formula in the quantities of the laws.

`rod.end.acceleration` becomes L |α| where the rod is at rest, with the direction of the vector kept for the words of the answer.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Call, Formula, Number, Product, Symbol, sqrt, total
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.facts import BodyFacts, Facts, Force, signed, square
from rotsolve.core.faults import Span
from rotsolve.core.heading import RIGHT, UP, Vector
from rotsolve.core.quantity import BY_WORD
from rotsolve.elements.connections.strings import String
from rotsolve.motion.instant import Instant, locate
from rotsolve.motion.rigid import mass_of, moment_about, tidy
from rotsolve.principles.energy import kinetic
from rotsolve.scene.model import Path, PointRef, Term

HALF = Number(Fraction(1, 2))


class NotYet(ValueError):
    """A quantity that can be named but not worked out for this owner; `span` where a line of a state speaks of it."""

    def __init__(self, words: str, span: Span | None = None, help: str = "") -> None:
        super().__init__(words)
        self.span, self.help = span, help


@dataclass(frozen=True)
class Meaning:
    """What a path stands for: a formula over letters; the vector behind a size, for its direction; a remark for the derivation."""

    formula: Formula
    dimension: Dimension
    vector: Vector | None = None
    remark: str = ""
    label: str = ""
    words: tuple[str, str] = ("", "")


@dataclass(frozen=True)
class Reader:
    """Reads paths at one instant."""

    instant: Instant
    facts: Callable[[], Facts]

    def meaning(self, path: Path, term: Term | None = None) -> Meaning:
        """The meaning of a path at this instant."""
        arrangement = self.instant.arrangement
        if path.owner in arrangement.bodies:
            found = self._of_point(path) if self._at_point(path) else self._of_body(path, term)
        elif not path.owner:
            found = self._of_system(path)
        else:
            found = self._of_element(path)
        kind = BY_WORD[path.quantity]
        meaning = found if isinstance(found, Meaning) else Meaning(found, kind.dimension)
        words = meaning.words if any(meaning.words) else self._words(path)
        return replace(meaning, label=meaning.label or label_of(path, term), words=words)

    def _words(self, path: Path) -> tuple[str, str]:
        """The two directions of a signed quantity: of a component, or of a turn."""
        if path.component in ("x", "y"):
            return ("right", "left") if path.component == "x" else ("up", "down")
        if path.quantity in ("torque", "angular_momentum"):
            name = path.owner if path.owner in self.instant.arrangement.bodies else self._turned_by(path.owner)
            return self.instant.turn_words(self.instant.host(name)) if name else ("", "")
        return ("", "")

    def _turned_by(self, owner: str) -> str:
        """The body on which a connection or action acts."""
        refs = [
            ref
            for item in self.instant.arrangement.acting(self.instant.state)
            if item.name == owner
            for ref in item.touches()
            if ref.owner in self.instant.arrangement.bodies
        ]
        return refs[-1].owner if refs else ""

    def _at_point(self, path: Path) -> bool:
        """Whether the path speaks of a point: a named one, or the centre of mass of what turns about another point."""
        return path.quantity in ("velocity", "speed", "acceleration") and (
            path.point is not None or not self._travels(path)
        )

    def _travels(self, path: Path) -> bool:
        motion = self.instant.motion(path.owner)
        return motion.kind == "line" and self.instant.host(path.owner) == path.owner

    def _moment(self) -> str:
        return f" at `{self.instant.state}`" if self.instant.state else ""

    def body(self, name: str) -> BodyFacts:
        found = self.facts().body(self.instant.host(name))
        if found is None:
            raise NotYet(f"`{name}` is not there{self._moment()}")
        return found

    def _of_point(self, path: Path) -> Meaning:
        """Velocity or acceleration of a point: its size, or a component."""
        instant = self.instant
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

    def _of_body(self, path: Path, term: Term | None) -> Formula | Meaning:
        instant, name, component = self.instant, path.owner, path.component
        host = instant.host(name)
        match path.quantity:
            case "angle":
                return instant.ask("angle", host, words=("counterclockwise", "clockwise"))
            case "angular_velocity" | "angular_acceleration":
                if not instant.motion(name).turns:
                    raise NotYet(
                        f"`{name}` does not turn", help="a body turns on an axle or hinge, or where it says `turns`"
                    )
                return instant.rate(path.quantity, host)
            case "velocity" | "acceleration":
                if component in ("x", "y"):
                    motion = instant.motion(name)
                    vector = motion.velocity if path.quantity == "velocity" else motion.acceleration
                    return vector.along(RIGHT if component == "x" else UP)
                line = instant.arrangement.line(host, instant.state)
                return instant.travel(path.quantity, host, line[1] if line else "")
            case "speed":
                return size_of(instant.motion(name).velocity)
            case "kinetic_energy":
                return self._kinetic(name, component)
            case "mass":
                return mass_of(instant.body(name))
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

    def _kinetic(self, name: str, component: str | None) -> Formula:
        """½ m v² + ½ I ω²; of a joined body, that of its own mass."""
        if self.instant.host(name) != name:
            velocity = self.instant.velocity(PointRef(name, "cm"))
            return total([HALF * mass_of(self.instant.body(name)) * velocity.dot(velocity)])
        body = self.body(name)
        terms = kinetic([body])
        if component == "rotational" and body.inertia is not None:
            terms = [HALF * body.inertia.letter * square(body.motion.spin)]
        if component == "translational":
            velocity = body.centre_velocity
            terms = [HALF * body.mass * velocity.dot(velocity)]
        return total(terms)

    def _inertia(self, path: Path, term: Term | None) -> Formula:
        """Moment of inertia about the centre of mass, or about a named point or support."""
        name, instant = path.owner, self.instant
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

    def _angular_momentum(self, name: str, term: Term | None) -> Formula:
        """I ω about the axis or the centre of mass; of a body without spin of its own, r × m v about a named point."""
        body = self.body(name)
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
        body = self.body(name)
        parts = [force.vector.dot(body.motion.velocity_of(force.arm)) for force in body.forces]
        if component == "gravity":
            parts = [
                force.vector.dot(body.motion.velocity_of(force.arm)) for force in body.forces if force.role == "weight"
            ]
        else:
            parts += [couple.torque * body.motion.spin for couple in body.couples]
        return total([part for part in parts if part != ZERO])

    def _of_system(self, path: Path) -> Formula:
        facts = self.facts()
        match path.quantity:
            case "kinetic_energy":
                return total(kinetic(list(facts.bodies)))
            case "time":
                return self.instant.time()
            case "mass":
                return total([body.mass for body in facts.bodies])
        raise NotYet(f"`{path.quantity}` of the whole scene is not solved yet")

    def _of_element(self, path: Path) -> Formula | Meaning:
        """A force, tension, torque or power of a connection or action."""
        forces = [(body, force) for body in self.facts().bodies for force in body.forces if force.owner == path.owner]
        couples = [
            (body, couple) for body in self.facts().bodies for couple in body.couples if couple.owner == path.owner
        ]
        match path.quantity:
            case "tension":
                return self._tension(path, [force for _, force in forces])
            case "normal_force" | "friction_force":
                role = {"normal_force": "normal", "friction_force": "friction"}[path.quantity]
                force = next((force for _, force in forces if force.role == role), None)
                if force is None:
                    return ZERO
                way = str(force.words[-1]).lstrip(", ") if role == "friction" else ""
                return Meaning(force.size, BY_WORD[path.quantity].dimension, words=(way, ""))
            case "torque":
                parts = [signed(couple.torque, body.motion.sense) for body, couple in couples[-1:]]
                parts += [signed(force.torque, body.motion.sense) for body, force in forces]
                return total([part for part in parts if part != ZERO])
            case "force":
                return self._element_force(path, forces)
            case "power":
                parts = [couple.torque * body.motion.spin for body, couple in couples]
                parts += [force.vector.dot(body.motion.velocity_of(force.arm)) for body, force in forces]
                return total([_plain(part) for part in parts if part != ZERO])
            case "elongation":
                return self.instant.ask("elongation", path.owner)
            case "angle" | "angular_velocity" | "angular_acceleration":
                name = self._turned_by(path.owner)
                if name:
                    return self._of_body(replace(path, owner=name), None)
        raise NotYet(f"`{path.quantity}` of `{path.owner}` is not solved yet")

    def _tension(self, path: Path, forces: list[Force]) -> Formula:
        """The tension of a string, or of the part that leaves the body that the path names."""
        item = next(
            (item for item in self.instant.arrangement.connections(self.instant.state) if item.name == path.owner), None
        )
        if isinstance(item, String) and path.point:
            tension = item.tension_at(path.point, self.instant)
            if tension is not None:
                return tension
        sizes = {force.size: None for force in forces}
        if not sizes:
            raise NotYet(f"`{path.owner}` does not pull{self._moment()}: it has no tension")
        if len(sizes) > 1:
            names = dict.fromkeys(ref.owner for ref in item.touches()) if item is not None else {}
            ends = ", ".join(f"`{path.owner}.{name}.tension`" for name in names)
            raise NotYet(f"the tension is not the same along `{path.owner}`", help=f"ask for that of one part: {ends}")
        return next(iter(sizes))

    def _element_force(self, path: Path, forces: list[tuple[BodyFacts, Force]]) -> Formula | Meaning:
        """The force on the last-named body: its components, or its size."""
        if not forces:
            couplings = [
                couple for body in self.facts().bodies for couple in body.couples if couple.owner == path.owner
            ]
            letters = [name for couple in couplings for name in couple.torque.symbols() if name.startswith("force|")]
            if letters:
                return Symbol(letters[0])
            raise NotYet(f"`{path.owner}` exerts no force{self._moment()}")
        last = self._last_body(path.owner, [body.name for body, _ in forces])
        vector = Vector()
        for body, force in forces:
            if body.name == last:
                vector = vector + force.vector
        if path.component in ("x", "y"):
            return vector.along(RIGHT if path.component == "x" else UP)
        if path.component in ("tangential", "normal"):
            return self._along_body(last, vector, path.component)
        return Meaning(size_of(vector), BY_WORD["force"].dimension, vector)

    def _along_body(self, name: str, vector: Vector, component: str) -> Formula:
        """Component along the line from pivot to centre of mass (towards the pivot: normal), or across it."""
        body = self.body(name)
        if not body.cm.parts:
            raise NotYet(
                f"`{name}` does not swing about a pivot: a tangential or normal part has no meaning",
                help="ask for `x` or `y`",
            )
        outward = body.cm.parts[0][1]
        return (
            vector.along(outward.turned(180))
            if component == "normal"
            else vector.along(outward.turned(90 * body.motion.sense))
        )

    def _last_body(self, owner: str, bodies: list[str]) -> str:
        instant = self.instant
        item = next((item for item in instant.arrangement.connections(instant.state) if item.name == owner), None)
        named = (
            [instant.host(ref.owner) for ref in item.touches() if ref.owner in instant.arrangement.bodies]
            if item
            else []
        )
        return next((name for name in reversed(named) if name in bodies), bodies[-1])


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
    for word in ("joins", "collides"):
        value = getattr(event, word, None)
        if isinstance(value, tuple):
            return value
    return ()


def size_of(vector: Vector, *, signed_by: int = 0) -> Formula:
    """Length of a vector: the size of its only part, else √(Σ components²); a signed single part keeps its sign."""
    if not vector.parts:
        return ZERO
    if len(vector.parts) == 1:
        size = vector.parts[0][0]
        return signed(size, signed_by) if signed_by else absolute(size)
    headings = [direction for _, direction in vector.parts]
    if len(vector.parts) == 2 and (headings[0] - headings[1]).cos() == ZERO:
        return sqrt(square(vector.parts[0][0]) + square(vector.parts[1][0]))
    return sqrt(square(vector.along(RIGHT)) + square(vector.along(UP)))


def absolute(size: Formula) -> Formula:
    """|size| with the bars round the quantities that may be negative only: L |α|."""
    plain = size.operand if hasattr(size, "operand") else size
    factors = plain.factors if isinstance(plain, Product) else (plain,)
    inside = [part for part in factors if any("|" in name for name in part.symbols())]
    outside = [part for part in factors if part not in inside]
    if not inside:
        return Call("abs", (plain,)) if plain.symbols() else plain
    bars: Formula = Call("abs", (inside[0] if len(inside) == 1 else Product(tuple(inside)),))
    for part in reversed(outside):
        bars = part * bars
    return bars


def _plain(part: Formula) -> Formula:
    from rotsolve.principles.energy import unsigned_product

    if isinstance(part, Product) and len(part.factors) == 2:
        return unsigned_product(*part.factors)
    return part


def label_of(path: Path, term: Term | None) -> str:
    """What a definition is called: "kinetic energy of block", "torque of the weight on rod"."""
    word = path.quantity.replace("_", " ")
    named = {"gravity": "of the weight", "net": "of all forces"}.get(path.component or "", "")
    owner = path.owner.replace("_", " ")
    about = f" about {term.about.owner}" if term is not None and term.about is not None and not term.about.point else ""
    if named and owner:
        return f"{word} {named} on {owner}{about}"
    return f"{word} of {owner}{about}" if owner else word


def path_text(path: Path) -> str:
    """A path as it is written."""
    return ".".join(part for part in (path.owner, path.point, path.quantity, path.component) if part)


def spoken_point(path: Path) -> str:
    """The owner and point of a path in words."""
    name = path.owner.replace("_", " ")
    point = {"cm": "centre of mass", None: ""}.get(path.point, path.point)
    return f"the {name}'s {point}" if point else name
