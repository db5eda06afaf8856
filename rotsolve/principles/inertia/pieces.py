"""Pieces of a body as the laws of inertia see them: their own moments, how far they are from an axis, what they are called."""

from __future__ import annotations

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Call, Formula, Power, Product, Sum, Symbol, negate, sqrt, total
from rotsolve.core.derivation import Words
from rotsolve.core.vectors.tensor import ONE_AXIS, Place
from rotsolve.core.writing import is_negative, spoken
from rotsolve.motion.bodies.rigid import Piece
from rotsolve.motion.bodies.spread import Spread

OTHERS = {"xx": (1, 2), "yy": (0, 2), "zz": (0, 1)}  # the coordinates whose squares make the distance from an axis


class Unknown(ValueError):
    """A moment of inertia that the scene does not settle."""


def entry_of(piece: Piece, entry: str) -> Formula:
    """An entry of a piece's own tensor; the moment about the axis is known even where the others are not."""
    if piece.tensor is not None:
        return piece.moment if entry == "zz" else piece.tensor.entry(entry)
    if entry == "zz":
        return piece.moment
    raise Unknown(f"only the moment of inertia of `{piece.name}` about its axis is known")


def arm_of(spread: Spread, piece: Piece) -> Place:
    """Where a piece's centre of mass is, seen from the point."""
    x, y, z = (simplify(at - point) for at, point in zip(piece.place(), spread.point, strict=True))
    return (x, y, z)


def apart(spread: Spread, piece: Piece, entry: str) -> list[Formula]:
    """The components of the distance of a piece from the axis; one where they make a plain length."""
    arm = arm_of(spread, piece)
    parts = [arm[index] for index in OTHERS[entry] if arm[index] != ZERO]
    if len(parts) > 1:
        whole = simplify(total([part**2 for part in parts]))
        root = simplify(sqrt(whole), positive=spread.positive)
        if isinstance(whole, (Power, Product)) and not root.holds(Call):
            return [root]
    return [negate(part) if backward(part) else part for part in parts]


def backward(part: Formula) -> bool:
    """Whether a distance is written with minus signs only."""
    return all(is_negative(term) for term in part.terms) if isinstance(part, Sum) else is_negative(part)


def sum_of_squares(parts: list[Formula]) -> Formula:
    return total([part**2 for part in parts])


def distance_words(parts: list[Formula], square: Formula) -> Words:
    """What the distance of parallel axes is; nothing where the scene itself calls it d."""
    if parts == [Symbol("d")]:
        return ()
    return ("d = ", parts[0]) if len(parts) == 1 else ("d² = ", square)


def noun(piece: Piece) -> str:
    """What a piece is called: "solid disc"; its name where it has no shape to speak of."""
    word = piece.shape.word
    if piece.tensor is None or word in ("particle", ""):
        return spoken(piece.name)
    return f"solid {word}" if word in ("disc", "cylinder", "sphere", "cone") else word


def about_axis(piece: Piece, entry: str) -> str:
    """Words for an axis through the centre of mass."""
    tensor = piece.tensor
    if tensor is None or entry not in ONE_AXIS:
        return ""
    if tensor.xx == tensor.yy == tensor.zz:
        return " about a diameter"
    if entry == "zz":
        return " about its centre" if piece.shape.flat and not piece.shape.outer else " about its axis"
    return f" about its {entry[0]} axis"
