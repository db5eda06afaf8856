"""Cuts: a rod cut through at a point: the piece on one side as a body of its own, with what the rest does to it at the cut.

Along a rod x runs from its start. At the cut the part before x acts on the part beyond it with the compression along the rod (a push),
the shear across it (to the left-hand side of the way from start to end) and the bending moment (clockwise): all three are positive where
a level rod, drawn from left to right, is pressed, pushed up at the cut, and bent so that it sags.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Symbol, negate, total
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.facts import INNER, WEIGHT, BodyFacts, Couple, Cut, Force, Inertia, Motion
from rotsolve.core.vectors.heading import DOWN, RIGHT, UP, Vector, unit, vector
from rotsolve.core.writing import spoken
from rotsolve.elements.shapes.thin import Rod
from rotsolve.language.problem import Body, Path, PointRef
from rotsolve.motion.rigid import RigidPiece, centre_of_mass, moment_about, positive_part, sweep, tidy

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant


class CrossSection(Struct, frozen=True):
    """A uniform rod cut at `x` from its start; `index` marks the letters of what is found there."""

    rod: Body
    length: Formula
    x: Formula
    index: str
    instant: Instant

    def side(self, place: Formula) -> int | None:
        """+1 for a place beyond the cut, −1 for one before it, 0 for one just there; None where the givens do not tell.

        The ends of the rod are on their own sides wherever it is cut.
        """
        place = simplify(place)
        if place in (ZERO, self.length):
            return -1 if place == ZERO else 1
        return self.instant.configuration.signs.taken(place - self.x)

    def point(self, place: Formula) -> Vector:
        """A place along the rod, from the reference of the body."""
        return self.instant.point(PointRef(self.rod.name, "at", place))

    def ask(self, word: str) -> Formula:
        """A letter of this cut; mass and inertia of the piece are the same at all times."""
        when = "" if word in ("mass", "inertia") else self.instant.span(self.rod.name)
        return self.instant.ask(word, self.rod.name, when=when, component=self.index)


def section_of(path: Path, index: str, instant: Instant) -> CrossSection | None:
    """The section that a path speaks of; None in a body that is no uniform rod."""
    body = instant.body(path.owner)
    if (
        body.shape is None
        or (length := body.shape.reach()) is None
        or body.parts
        or body.holes
        or body.inertia is not None
        or body.gyration is not None
    ):
        return None
    x = simplify(body.shape.locate(path.point or "", path.argument)[0] + length / 2)
    return CrossSection(body, length, x, index, instant)


class Loads(Struct, frozen=True):
    """What sits and acts on one side of a cut (`sign` as in CrossSection.side), weights left out.

    What is just at the cut is counted to the part before it, and `jumps` tells of it.
    """

    sign: int
    pieces: tuple[RigidPiece, ...]
    acting: tuple[Force | Couple, ...]
    jumps: bool


def free_side(section: CrossSection, facts: BodyFacts) -> Loads | None:
    """The side of a cut on which less acts; None where it is not certain on which side something is."""
    acting: dict[int, list[Force | Couple]] = {1: [], 0: [], -1: []}
    pieces: dict[int, list[RigidPiece]] = {1: [], 0: [], -1: []}
    start = section.point(ZERO)
    for item in facts.acting:
        if not item.role.weighs:
            ref = named_point(item, section)
            arm = None if ref is None else item.arm if isinstance(item, Force) else section.instant.point(ref)
            side = None if arm is None else section.side((arm - start).along(facts.motion.orientation))
            if side is None:
                return None
            acting[side].append(item)
    for member in section.instant.frame(section.rod.name).pieces:
        if member.name != section.rod.name:
            side = section.side(member.at.along(RIGHT) + section.length / 2)
            if side is None or tidy(member.at).along(UP) != ZERO:
                return None
            pieces[side].append(member)
    jumps = bool(acting[0] or pieces[0])
    acting[-1] += acting[0]
    pieces[-1] += pieces[0]
    sign = 1 if len(acting[1]) <= len(acting[-1]) else -1
    return Loads(sign, tuple(pieces[sign]), tuple(acting[sign]), jumps)


def named_point(acting: Force | Couple, section: CrossSection) -> PointRef | None:
    """The point at which something acts on a rod, as the scene names it; a floor that a rod lies on pushes all along it."""
    configuration, state = section.instant.configuration, section.instant.state
    supports = {ref for item in configuration.connections(state) for ref in item.fixed_points()}
    for item in configuration.acting(state):
        for ref in item.touches():
            named = ref.point is not None or ref in supports
            if item.name == acting.owner and ref.owner == section.rod.name and named:
                return ref
    return None


def cuts_at(instant: Instant, bodies: tuple[BodyFacts, ...]) -> tuple[Cut, ...]:
    """The cuts that the scene asks for; none of a rod where it is not certain on which side of the cut something acts."""
    found = []
    for index, path in instant.configuration.mentions.cuts.items():
        facts = next((item for item in bodies if item.name == path.owner), None)
        section = section_of(path, index, instant) if facts is not None else None
        if facts is not None and section is not None:
            loads = free_side(section, facts)
            if loads is not None:
                found.append(cut_free(section, facts, loads))
    return tuple(found)


def cut_free(section: CrossSection, facts: BodyFacts, loads: Loads) -> Cut:
    """The piece with its mass and inertia, its motion, its weight, what acts on it from outside, and what acts at the cut."""
    order, sign = section.instant.configuration.order, loads.sign
    length = simplify(section.length - section.x, order=order) if sign > 0 else section.x
    middle = (section.x + section.length) / 2 if sign > 0 else section.x / 2
    share = simplify((section.rod.mass or ZERO) * length / section.length, order=order)
    mass = share if share == ZERO or isinstance(share, Symbol) else section.ask("mass")
    at, shape = vector(simplify(middle - section.length / 2), RIGHT), Rod(length)
    own = RigidPiece(section.rod.name, mass, shape.moment(mass), at, shape, tensor=shape.tensor(mass))
    pieces = tuple(item for item in (own, *loads.pieces) if item.mass != ZERO or item is own)
    centre = tidy(centre_of_mass(pieces) if len(pieces) > 1 else own.at)
    place = simplify(centre.along(RIGHT) + section.length / 2, order=order)
    at, back = section.point(place), simplify(place - section.x, order=order)
    whirl = facts.motion.whirl_at(at)
    cut = Vector((positive_part(back, facts.motion.orientation.turned(180)),))
    moment, remark = moment_about(pieces, centre, (*mass.symbols(), *order))
    name = f"{section.rod.name} {'beyond' if sign > 0 else 'up to'} {to_text(section.x)}"
    letter = section.ask("inertia") if moment != ZERO else ZERO
    body = BodyFacts(
        name,
        total([item.mass for item in pieces]),
        Inertia(letter, moment, f"moment of inertia, {name} about its centre of mass", remark),
        moving_with(facts.motion, at),
        Vector(),
        (facts.motion.orientation, facts.motion.orientation.turned(90)),
        facts.positive,
        (*weights(pieces, section, at), *outside(loads, at), *inner_forces(section, facts, sign, cut)),
        (*(item for item in loads.acting if isinstance(item, Couple)), bending(section, sign)),
        along=("along the rod", "across the rod"),
        sweep=sweep(section.rod, pieces, centre, facts.motion.orientation, whirl, order),
    )
    defined = Inertia(mass, share, f"mass of {name}")
    return Cut(body, defined, cut, section.index, loads.jumps)


def moving_with(motion: Motion, at: Vector) -> Motion:
    """The motion of a piece: its centre of mass, the reference, is carried along by the rod, and it turns with it.

    What a turning shaft adds, Ω² x, is in the acceleration of the reference.
    """
    return replace(
        motion,
        kind="plane",
        velocity=motion.velocity_of(at),
        acceleration=motion.acceleration_of(at),
        turns=True,
        heading=None,
        whirl=None,
    )


def weights(pieces: tuple[RigidPiece, ...], section: CrossSection, at: Vector) -> Iterator[Force]:
    """The weights of the piece and of what is joined to it, from its centre of mass."""
    gravity = section.instant.configuration.problem.gravity
    if gravity is None or not section.instant.configuration.heavy:
        return
    for item in pieces:
        if item.mass != ZERO:
            arm = tidy(section.point(simplify(item.at.along(RIGHT) + section.length / 2)) - at)
            noun = "weight" if item.name == section.rod.name else f"weight of {spoken(item.name)}"
            yield Force("", WEIGHT, section.rod.name, item.mass * gravity, unit(DOWN), arm, noun, "down")


def outside(loads: Loads, at: Vector) -> Iterator[Force]:
    """The forces on the piece from outside the rod, with arms from its centre of mass."""
    for item in loads.acting:
        if isinstance(item, Force):
            yield replace(item, arm=tidy(item.arm - at))


def inner_forces(section: CrossSection, facts: BodyFacts, sign: int, arm: Vector) -> Iterator[Force]:
    """Compression and shear at the cut."""
    along = facts.motion.orientation
    sides = (("compression", along, "along the rod, away from the cut"), ("shear", along.turned(90), "across the rod"))
    for word, direction, words in sides:
        size = section.ask(word)
        push = unit(direction if sign > 0 else direction.turned(180))
        yield Force(section.rod.name, INNER, section.rod.name, size, push, arm, word, words)


def bending(section: CrossSection, sign: int) -> Couple:
    """The bending moment at the cut: clockwise on the part beyond it."""
    size = section.ask("bending_moment")
    turn: Formula = negate(size) if sign > 0 else size
    way = "clockwise" if sign > 0 else "counterclockwise"
    return Couple(section.rod.name, INNER, section.rod.name, turn, "bending moment", size, way)
