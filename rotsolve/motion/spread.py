"""Spread: how the mass of a body is spread, seen from a point: what moments of inertia are made of, and letters for them."""

from __future__ import annotations

from dataclasses import dataclass

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units import dimension as base
from rotsolve.core.derivation import Words
from rotsolve.core.equation import Equation
from rotsolve.core.registry import Quantity, Registry
from rotsolve.core.tensor import ORIGIN, Place
from rotsolve.motion.rigid import Piece

DENSITY = {"line": ("lambda", "length"), "surface": ("sigma", "area"), "volume": ("rho", "volume")}
LETTERS = {  # letter and dimension of what a derivation gives a letter of its own
    "inertia": ("I", base.INERTIA),
    "cm": ("", base.LENGTH),
    "mass": ("m", base.MASS),
    "density": ("", base.NONE),
    "extent": ("", base.NONE),
    "coordinate": ("", base.LENGTH),
}


@dataclass(frozen=True)
class Spread:
    """The pieces of a body, and the point about which is asked, in the body's axes.

    `central` says that the point is the centre of mass; `spot` is the point's name, an index of letters; `known` is the letter of
    the moment about the centre of mass that the laws of the scene use; `integrates` where the question says `by integration`;
    `begin` is where the coordinates begin in which the scene speaks of the body.
    """

    name: str
    pieces: tuple[Piece, ...]
    mass: Formula
    registry: Registry
    section: str
    point: Place = ORIGIN
    spot: str = ""
    central: bool = False
    known: Formula | None = None
    integrates: bool = False
    begin: Place = ORIGIN
    positive: frozenset[str] = frozenset()

    def letter(self, kind: str, component: str) -> Symbol:
        """A letter of the derivation, printed with its index where it has one."""
        letter, dimension = LETTERS[kind]
        index = "_".join(component.split())
        quantity = Quantity(kind, self.name, "", index, letter, dimension)
        self.registry.ask(quantity)
        return quantity.symbol

    def define(self, letter: Formula, formula: Formula, label: str, said: Words = ()) -> Equation:
        """What a letter stands for."""
        return Equation(letter, formula, label, self.section, "", 1, said, bodies=(self.name,))

    def called(self, piece: Piece) -> str:
        """A name for a piece that no other has."""
        names = [item.name for item in self.pieces]
        return piece.name if names.count(piece.name) < 2 else f"{piece.name}{self.pieces.index(piece) + 1}"
