"""Pieces: the part of a rod on one side of a cut as a free body."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Symbol, negate, total
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.facts import BodyFacts, Couple, Cut, Force, Inertia, Motion
from rotsolve.core.vectors.heading import DOWN, RIGHT, Vector, unit, vector
from rotsolve.elements.shapes import Rod
from rotsolve.motion.bodies.rigid import Piece, centre_of_mass, moment_about, positive_part, tidy
from rotsolve.motion.cuts.section import Loads, Section, free_side, section_of
from rotsolve.motion.instant import Instant


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


def cut_free(section: Section, facts: BodyFacts, loads: Loads) -> Cut:
    """The piece with its mass and inertia, its motion, its weight, what acts on it from outside, and what acts at the cut."""
    order, sign = section.instant.configuration.order, loads.sign
    length = simplify(section.length - section.x, order=order) if sign > 0 else section.x
    middle = (section.x + section.length) / 2 if sign > 0 else section.x / 2
    share = simplify((section.rod.mass or ZERO) * length / section.length, order=order)
    mass = share if share == ZERO or isinstance(share, Symbol) else section.ask("mass")
    at, shape = vector(simplify(middle - section.length / 2), RIGHT), Rod(length)
    own = Piece(section.rod.name, mass, shape.moment(mass), at, shape)
    pieces = tuple(item for item in (own, *loads.pieces) if item.mass != ZERO or item is own)
    centre = tidy(centre_of_mass(pieces) if len(pieces) > 1 else own.at)
    place = simplify(centre.along(RIGHT) + section.length / 2, order=order)
    at, back = section.point(place), simplify(place - section.x, order=order)
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
    )
    defined = Inertia(mass, share, f"mass of {name}")
    return Cut(body, defined, cut, section.index, loads.jumps)


def moving_with(motion: Motion, at: Vector) -> Motion:
    """The motion of a piece: its centre of mass is carried along by the rod, and it turns with it."""
    return replace(
        motion,
        kind="plane",
        velocity=motion.velocity_of(at),
        acceleration=motion.acceleration_of(at),
        turns=True,
        heading=None,
    )


def weights(pieces: tuple[Piece, ...], section: Section, at: Vector) -> Iterator[Force]:
    """The weights of the piece and of what is joined to it, from its centre of mass."""
    gravity = section.instant.configuration.problem.gravity
    if gravity is None or not section.instant.configuration.heavy:
        return
    for item in pieces:
        if item.mass != ZERO:
            arm = tidy(section.point(simplify(item.at.along(RIGHT) + section.length / 2)) - at)
            what = "weight " if item.name == section.rod.name else f"weight of {item.name.replace('_', ' ')} "
            size = item.mass * gravity
            yield Force("", "weight", section.rod.name, size, unit(DOWN), arm, (what, size, ", down"))


def outside(loads: Loads, at: Vector) -> Iterator[Force]:
    """The forces on the piece from outside the rod, with arms from its centre of mass."""
    for item in loads.acting:
        if isinstance(item, Force):
            yield replace(item, arm=tidy(item.arm - at))


def inner_forces(section: Section, facts: BodyFacts, sign: int, arm: Vector) -> Iterator[Force]:
    """Compression and shear at the cut."""
    along = facts.motion.orientation
    sides = (("compression", along, "along the rod, away from the cut"), ("shear", along.turned(90), "across the rod"))
    for word, direction, words in sides:
        size = section.ask(word)
        push = unit(direction if sign > 0 else direction.turned(180))
        yield Force(section.rod.name, "inner", section.rod.name, size, push, arm, (f"{word} ", size, f", {words}"))


def bending(section: Section, sign: int) -> Couple:
    """The bending moment at the cut: clockwise on the part beyond it."""
    size = section.ask("bending_moment")
    turn: Formula = negate(size) if sign > 0 else size
    words = ("bending moment ", size, ", clockwise" if sign > 0 else ", counterclockwise")
    return Couple(section.rod.name, "inner", section.rod.name, turn, words)
