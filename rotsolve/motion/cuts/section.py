"""Sections: where a rod is cut, on which side of the cut everything is, and the letters of what is found there."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.certified.sign import sign_of
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import BodyFacts, Couple, Force
from rotsolve.core.quantity import BY_WORD
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.elements.shapes import Rod
from rotsolve.language.problem import Body, Path, PointRef
from rotsolve.motion.bodies.rigid import Piece, tidy
from rotsolve.motion.instant import Instant


class Section(Struct, frozen=True):
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
        return compared(place, self.x, self.instant)

    def point(self, place: Formula) -> Vector:
        """A place along the rod, from the reference of the body."""
        return self.instant.point(PointRef(self.rod.name, "at", place))

    def ask(self, word: str) -> Formula:
        """A letter of this cut; mass and inertia of the piece are the same at all times."""
        when = "" if word in ("mass", "inertia") else self.instant.span(self.rod.name)
        return self.instant.ask(word, self.rod.name, when=when, component=self.index)


def section_of(path: Path, index: str, instant: Instant) -> Section | None:
    """The section that a path speaks of; None in a body that is no uniform rod."""
    body = instant.body(path.owner)
    if (
        not isinstance(body.shape, Rod)
        or body.parts
        or body.holes
        or body.inertia is not None
        or body.gyration is not None
    ):
        return None
    length = body.shape.extent()
    x = simplify(body.shape.locate(path.point or "", path.argument)[0] + length / 2)
    return Section(body, length, x, index, instant)


def compared(place: Formula, x: Formula, instant: Instant) -> int | None:
    """The sign of place − x by the numbers of the givens, else by their letters alone."""
    problem = instant.configuration.problem
    values = {given.name: given.value for given in problem.givens if given.value is not None}
    lengths = {given.name for given in problem.givens if given.dimension == BY_WORD["length"].dimension}
    return sign_of(place - x, values, lengths)


class Loads(Struct, frozen=True):
    """What sits and acts on one side of a cut (`sign` as in Section.side), weights left out.

    What is just at the cut is counted to the part before it, and `jumps` tells of it.
    """

    sign: int
    pieces: tuple[Piece, ...]
    acting: tuple[Force | Couple, ...]
    jumps: bool


def free_side(section: Section, facts: BodyFacts) -> Loads | None:
    """The side of a cut on which less acts; None where it is not certain on which side something is."""
    acting: dict[int, list[Force | Couple]] = {1: [], 0: [], -1: []}
    pieces: dict[int, list[Piece]] = {1: [], 0: [], -1: []}
    start = section.point(ZERO)
    for item in facts.acting:
        if item.role != "weight":
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


def named_point(acting: Force | Couple, section: Section) -> PointRef | None:
    """The point at which something acts on a rod, as the scene names it; a floor that a rod lies on pushes all along it."""
    configuration, state = section.instant.configuration, section.instant.state
    supports = {ref for item in configuration.connections(state) for ref in item.fixed_points()}
    for item in configuration.acting(state):
        for ref in item.touches():
            named = ref.point is not None or ref in supports
            if item.name == acting.owner and ref.owner == section.rod.name and named:
                return ref
    return None
