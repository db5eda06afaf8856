"""Meanings: what a path of the scene language stands for, and how it is called."""

from __future__ import annotations

from dataclasses import dataclass

from rotsolve.algebra.formula import ZERO, Call, Formula, Product, sqrt
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.facts import signed, square
from rotsolve.core.faults import Span
from rotsolve.core.heading import RIGHT, UP, Vector
from rotsolve.core.quantity import POINT, QUANTITIES
from rotsolve.core.writing import spoken
from rotsolve.scene.model import Path, Term

POINT_WORDS = [entry.word for entry in QUANTITIES if POINT in entry.owners]


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


def label_of(path: Path, term: Term | None) -> str:
    """What a definition is called: "kinetic energy of block", "torque of the weight on rod"."""
    word = spoken(path.quantity)
    named = {"gravity": "of the weight", "net": "of all forces"}.get(path.component or "", "")
    of_point = path.point is not None and path.quantity in POINT_WORDS
    owner = spoken_point(path) if of_point else spoken(path.owner)
    about = f" about {term.about.owner}" if term is not None and term.about is not None and not term.about.point else ""
    if named and owner:
        return f"{word} {named} on {owner}{about}"
    return f"{word} of {owner}{about}" if owner else word


def path_text(path: Path) -> str:
    """A path as it is written."""
    return ".".join(part for part in (path.owner, path.point, path.quantity, path.component) if part)


def spoken_point(path: Path) -> str:
    """The owner and point of a path in words."""
    name = spoken(path.owner)
    at = f"point at {to_text(path.argument)}" if path.argument is not None else path.point
    point = {"cm": "centre of mass", None: ""}.get(path.point, at)
    return f"the {name}'s {point}" if point else name
