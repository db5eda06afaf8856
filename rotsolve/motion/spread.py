"""Spread: how the mass of a body is spread, seen from a point: what moments of inertia are made of, and letters for them."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units import dimension as base
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Words
from rotsolve.core.equation import INERTIA, Equation, Law
from rotsolve.core.letters import letter_order
from rotsolve.core.registry import Registry, SceneQuantity
from rotsolve.core.vectors.tensor import ORIGIN, Place
from rotsolve.motion.rigid import RigidPiece

DENSITY = {"line": ("lambda", "length"), "surface": ("sigma", "area"), "volume": ("rho", "volume")}
EXTENTS = {"line": ("s", "length"), "surface": ("A", "area"), "volume": ("V", "volume")}
LETTERS = {  # letter and dimension of what a derivation gives a letter of its own
    "inertia": ("I", base.INERTIA),
    "cm": ("", base.LENGTH),
    "mass": ("m", base.MASS),
    "lambda": ("lambda", base.LINE_DENSITY),
    "sigma": ("sigma", base.AREA_DENSITY),
    "rho": ("rho", base.DENSITY),
    "s": ("s", base.LENGTH),
    "A": ("A", base.AREA),
    "V": ("V", base.VOLUME),
}


class Spread(Struct, frozen=True):
    """The pieces of a body, and the point about which is asked, in the body's axes.

    `central` says that the point is the centre of mass; `spot` is the point's name, an index of letters; `known` is the letter of
    the moment about the centre of mass that the laws of the scene use; `integrates` where the question says `by integration`,
    `doubled` where the scene asks for the same without integration too, so that the letters must differ;
    `begin` is where the coordinates begin in which the scene speaks of the body; `axes` are the names of all three in space, where none
    is square to a picture.
    """

    name: str
    pieces: tuple[RigidPiece, ...]
    mass: Formula
    registry: Registry
    section: str
    point: Place = ORIGIN
    spot: str = ""
    central: bool = False
    known: Formula | None = None
    integrates: bool = False
    doubled: bool = False
    begin: Place = ORIGIN
    positive: frozenset[str] = frozenset()
    givens: tuple[tuple[str, Dimension | None], ...] = ()
    axes: str = ""

    def letter(self, kind: str, component: str = "") -> Symbol:
        """A letter of the derivation, printed with its index where it has one."""
        letter, dimension = LETTERS[kind]
        kind = f"{kind} by integration" if self.doubled else kind
        index = "_".join(component.split())
        quantity = SceneQuantity(kind, self.name, "", index, letter, dimension)
        self.registry.ask(quantity)
        return quantity.symbol

    def coordinate(self, name: str) -> Symbol:
        """The printed letter of a coordinate: x, or x₁ where a given has that name."""
        return self.registry.coordinate(name)

    def tidy(self, formula: Formula) -> Formula:
        """Textbook form, with the letters in the order in which a textbook writes them."""
        own = [(quantity.key, quantity.dimension) for quantity in self.registry.quantities.values()]
        return simplify(formula, order=letter_order([*self.givens, *own]), positive=self.positive)

    def define(self, letter: Formula, formula: Formula, label: str, said: Words = (), law: Law = INERTIA) -> Equation:
        """What a letter stands for."""
        return law.equation(letter, formula, self.section, (self.name,), said, words=label)

    def called(self, piece: RigidPiece) -> str:
        """A name for a piece that no other has."""
        names = [item.name for item in self.pieces]
        return piece.name if names.count(piece.name) < 2 else f"{piece.name}{self.pieces.index(piece) + 1}"
