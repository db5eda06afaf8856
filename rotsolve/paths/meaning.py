"""Meanings: what a path of the scene language stands for and how it is called, and what all questions about one instant start from."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Call, Formula, Number, Power, Product, sqrt
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Words
from rotsolve.core.equation import DEFINITION, Equation, Law
from rotsolve.core.facts import BodyFacts, Facts, signed, square
from rotsolve.core.quantity import BEARINGS, OF_BEARINGS, POINT, QUANTITIES
from rotsolve.core.symbols import has_quantities
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Vector
from rotsolve.core.writing import spoken
from rotsolve.language.problem import Path, PointRef, Term
from rotsolve.motion.rigid import tidy

if TYPE_CHECKING:
    from rotsolve.core.faults import Span
    from rotsolve.motion.instant import Instant


TWO = Number(Fraction(2))


class NotYet(ValueError):
    """A quantity that can be named but not worked out for this owner; `span` where a line of a state speaks of it."""

    def __init__(self, words: str, span: Span | None = None, help: str = "") -> None:
        super().__init__(words)
        self.span, self.help = span, help


class Unclear(NotYet):
    """A question that the scene does not settle: which state, which end."""


class Meaning(Struct, frozen=True):
    """What a path stands for: a formula over letters; the vector behind a size, for its direction; a remark for the derivation.

    `said` is a remark that holds formulas; `definitions` say what letters of its own stand for, as steps of the derivation;
    `moving` is a velocity that must not vanish, where the question has a meaning only along it.
    """

    formula: Formula
    dimension: Dimension
    vector: Vector | None = None
    remark: str = ""
    label: str = ""
    words: tuple[str, str] = ("", "")
    said: Words = ()
    definitions: tuple[Equation, ...] = ()
    moving: Vector = NOWHERE
    law: Law = DEFINITION
    laws: tuple[Equation, ...] = ()  # what this question alone speaks of
    plain: bool = False  # whether its label only names it, and says no law


def vector_size(vector: Vector) -> Formula:
    """Length of a vector: the size of its only part, else √(Σ components²)."""
    if not vector.parts:
        return ZERO
    if len(vector.parts) == 1:
        return absolute(vector.parts[0][0])
    headings = [direction for _, direction in vector.parts]
    if len(vector.parts) == 2 and (headings[0] - headings[1]).cos() == ZERO:
        return sqrt(square(vector.parts[0][0]) + square(vector.parts[1][0]))
    x, y = vector.along(RIGHT), vector.along(UP)
    if ZERO in (x, y):
        return absolute(x if y == ZERO else y)
    return sqrt(square(x) + square(y))


def absolute(size: Formula) -> Formula:
    """|size| with the bars round the quantities that may be negative only: L |α|."""
    plain = size.operand if hasattr(size, "operand") else size
    factors = plain.factors if isinstance(plain, Product) else (plain,)
    varying = [part for part in factors if has_quantities(part)]
    inside = [part for part in varying if not (isinstance(part, Power) and part.exponent == TWO)]
    outside = [part for part in factors if part not in inside]
    if not inside:
        return Call("abs", (plain,)) if plain.symbols() and not varying else plain
    bars: Formula = Call("abs", (inside[0] if len(inside) == 1 else Product(tuple(inside)),))
    for part in reversed(outside):
        bars = part * bars
    return bars


def label_of(path: Path, term: Term | None) -> str:
    """What a definition is called: "kinetic energy of block", "torque of the weight on rod"."""
    word = spoken(path.quantity)
    if path.component in ("rotational", "translational"):
        word = f"{path.component} {word}"
    named = {"gravity": "of the weight", "net": "of all forces"}.get((path.component or "").split(" ")[0], "")
    with_points = POINT in QUANTITIES[path.quantity].owners or path.quantity in OF_BEARINGS
    of_point = path.point is not None and with_points
    owner = spoken_point(path) if of_point else spoken(path.owner)
    about = f" about {spoken_about(term.about)}" if term is not None and term.about is not None else ""
    if named and owner:
        return f"{word} {named} on {owner}{about}"
    seen = f" relative to {spoken(term.relative)}" if term is not None and term.relative else ""
    return f"{word} of {owner}{about}{seen}" if owner else f"{word}{about}"


def spoken_about(ref: PointRef) -> str:
    """A point about which something is asked, in words; a connection by its name, a place in space by its coordinates."""
    if ref.place is not None:
        return f"({', '.join(map(to_text, ref.place))})"
    return spoken_point(Path(ref.owner, "", ref.point, ref.argument)) if ref.point else ref.owner


def path_text(path: Path) -> str:
    """A path as it is written."""
    return ".".join(
        part for part in (path.owner, path.point, path.quantity, *(path.component or "").split(" ")) if part
    )


def spoken_point(path: Path) -> str:
    """The owner and point of a path in words."""
    name = spoken(path.owner)
    at = f"point at {to_text(path.argument)}" if path.argument is not None else path.point
    point = "" if path.point is None else {**BEARINGS, "cm": "centre of mass"}.get(path.point, at)
    return f"the {name}'s {point}" if point else name


Meant = Formula | Meaning


class AtInstant(Struct, frozen=True):
    """An instant with its facts, which are worked out when a question needs them."""

    instant: Instant
    facts: Callable[[], Facts]

    def body(self, name: str) -> BodyFacts:
        found = self.facts().body(self.instant.host(name))
        if found is None:
            raise NotYet(f"`{name}` is not there{self._moment()}")
        return found

    def _moment(self) -> str:
        return f" at `{self.instant.state}`" if self.instant.state else ""

    def _turned_by(self, owner: str) -> str:
        """The body on which a connection or action acts."""
        refs = [
            ref
            for item in self.instant.configuration.acting(self.instant.state)
            if item.name == owner
            for ref in item.touches()
            if ref.owner in self.instant.configuration.bodies
        ]
        return refs[-1].owner if refs else ""


NATURAL = ("tangential", "normal")


def arm_length(arm: Vector) -> Formula:
    """|r|: the size of the only part, else √(x² + y²)."""
    arm = tidy(arm)
    if len(arm.parts) == 1:
        return arm.parts[0][0]
    x, y = arm.along(RIGHT), arm.along(UP)
    return simplify(sqrt(x**2 + y**2), positive=(x + y).symbols())


def about_centre(vector: Vector, arm: Vector, sense: int, component: str) -> Formula:
    """Component of a vector at `arm` from a centre: across the arm along the positive turn, or towards the centre."""
    arm = tidy(arm)
    if len(arm.parts) == 1:
        outward = arm.parts[0][1]
        return vector.along(outward.turned(180) if component == "normal" else outward.turned(90 * sense))
    part = signed(arm.cross(vector), sense) if component == "tangential" else (-arm).dot(vector)
    return simplify(part / arm_length(arm))


def along_path(vector: Vector, velocity: Vector, component: str) -> Formula:
    """Component of a vector along the velocity of a point, or square to it: a·v/|v|, |v × a|/|v|."""
    velocity = tidy(velocity)
    if len(velocity.parts) == 1:
        onward = velocity.parts[0][1]
        return vector.along(onward) if component == "tangential" else absolute(vector.along(onward.turned(90)))
    speed = sqrt(velocity.along(RIGHT) ** 2 + velocity.along(UP) ** 2)
    part = velocity.dot(vector) if component == "tangential" else absolute(velocity.cross(vector))
    return part / speed


def whole_vector(path: Path) -> bool:
    """Whether a path that may be a vector asks for all of it: not for one component, nor a mere speed."""
    return path.quantity != "speed" and path.component in (None, "gravity")
