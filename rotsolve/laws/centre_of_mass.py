"""Centre of mass: Σ m x/Σ m, with the masses of a plate and of its holes as shares of its material; and the pieces that it is made of."""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Call, Formula, Power, Product, Sum, Symbol, multiply, negate, sqrt, total
from rotsolve.core.derivation import Words
from rotsolve.core.equation import INERTIA, Equation, Law
from rotsolve.core.vectors.tensor import AXES, ONE_AXIS, Place
from rotsolve.core.writing import flat, is_negative, spoken
from rotsolve.laws.integration import centre_letter, origin, place_of
from rotsolve.motion.rigid import RigidPiece
from rotsolve.motion.spread import DENSITY, Spread

OTHERS = {"xx": (1, 2), "yy": (0, 2), "zz": (0, 1)}  # the coordinates whose squares make the distance from an axis


class Unknown(ValueError):
    """A moment of inertia that the scene does not settle."""


def entry_of(piece: RigidPiece, entry: str) -> Formula:
    """An entry of a piece's own tensor; the moment about the axis is known even where the others are not."""
    if piece.tensor is not None:
        return piece.moment if entry == "zz" else piece.tensor.entry(entry)
    if entry == "zz":
        return piece.moment
    raise Unknown(f"only the moment of inertia of `{piece.name}` about its axis is known")


def arm_of(spread: Spread, piece: RigidPiece) -> Place:
    """Where a piece's centre of mass is, seen from the point."""
    return place_of(at - point for at, point in zip(piece.place(), spread.point, strict=True))


def apart(spread: Spread, piece: RigidPiece, entry: str) -> list[Formula]:
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


def noun(piece: RigidPiece) -> str:
    """What a piece is called: "solid disc"; its name where it has no shape to speak of."""
    word = piece.shape.regular if piece.shape.is_regular() else piece.shape.word
    if piece.tensor is None or word in ("particle", ""):
        return spoken(piece.name)
    return f"solid {word}" if word in ("disc", "cylinder", "sphere", "cone") else word


def about_axis(piece: RigidPiece, entry: str) -> str:
    """Words for an axis through the centre of mass."""
    tensor = piece.tensor
    if tensor is None or entry not in ONE_AXIS:
        return ""
    if piece.shape.is_regular():
        return " about any axis through its centre"
    if piece.shape.spherical:
        return " about a diameter"
    if entry == "zz":
        return " about its centre" if piece.shape.flat and not piece.shape.outer else " about its axis"
    return f" about its {entry[0]} axis"


class Told(Struct, frozen=True):
    """What a quantity is: a formula over letters with what defines them, its law and a remark."""

    formula: Formula
    label: str
    said: Words = ()
    definitions: tuple[Equation, ...] = ()
    law: Law = INERTIA


def centre(spread: Spread, axis: str) -> Told:
    """x of the centre of mass: Σ m x/Σ m, of a varying density (1/M) ∫ x dm."""
    number = AXES.index(axis)
    if len(spread.pieces) == 1:
        piece = spread.pieces[0]
        if spread.integrates or not piece.shape.tabled:
            letter, steps = centre_letter(spread, piece, axis)
            ahead = simplify(origin(piece)[number] - spread.begin[number])
            return Told(letter + ahead, f"centre of mass, {axis} from the {piece.shape.word}'s own origin", (), steps)
        at = simplify(piece.place()[number] - spread.begin[number])
        return Told(at, f"centre of mass, {noun(piece)}")
    masses, shares = piece_masses(spread)
    places = [piece.place()[number] for piece in spread.pieces]
    above = total(flat([multiply(weight, at) for weight, at in zip(masses, places, strict=True)]))
    whole = spread.mass if shares else total(flat(masses))
    if above == ZERO or simplify(plain(above, shares)) == ZERO:
        return Told(ZERO, "centre of mass")
    letter = spread.letter("cm", f"{axis}_cm")
    step = spread.define(letter, above / whole, f"centre of mass, {axis} = Σ m {axis}/Σ m")
    return Told(letter, "", (), (*shares, step))


def from_centre(spread: Spread) -> tuple[Spread, tuple[Equation, ...]]:
    """The spread with the coordinates of its centre of mass as letters, where that is the point meant and not the origin."""
    if not spread.central or len(spread.pieces) == 1:
        return spread, ()
    found: list[Formula] = []
    defined: list[Equation] = []
    for axis in AXES:
        told = centre(spread, axis)
        defined += told.definitions
        found.append(told.formula)
    return replace(spread, point=(found[0], found[1], found[2]), central=False), tuple(dict.fromkeys(defined))


def piece_masses(spread: Spread) -> tuple[list[Formula], tuple[Equation, ...]]:
    """The masses of the pieces; of a plate with holes as shares of its material, m = σ A, with a minus sign for the holes."""
    shared = [piece for piece in spread.pieces if piece.measure is not None]
    if not shared:
        return [piece.mass for piece in spread.pieces], ()
    materials = {simplify(piece.mass / piece.measure) for piece in shared if piece.measure is not None}
    if len(materials) > 1:  # several plates with holes, each of its own material
        return [piece.mass for piece in spread.pieces], ()
    name, word = (
        DENSITY[shared[0].shape.spread]
        if shared[0].measure == shared[0].shape.content()
        else ("sigma", "area that is seen")
    )
    rest = spread.tidy(total([piece.measure for piece in shared if piece.measure is not None]))
    (sigma,) = materials
    defined = []
    if not isinstance(sigma, Symbol):
        sigma = spread.letter(name)
        filled = simplify(total([piece.mass for piece in shared]))
        defined.append(spread.define(sigma, filled / rest, f"mass per {word}"))
    masses: list[Formula] = []
    for piece in spread.pieces:
        if piece.measure is None:
            masses.append(piece.mass)
            continue
        size = spread.tidy(negate(piece.measure) if is_negative(piece.measure) else piece.measure)
        letter = spread.letter("mass", spread.called(piece))
        defined.append(spread.define(letter, sigma * size, f"mass of {spoken(spread.called(piece))}"))
        masses.append(negate(letter) if is_negative(piece.mass) else letter)
    return masses, tuple(defined)


def plain(written: Formula, definitions: tuple[Equation, ...]) -> Formula:
    """A formula with its letters put in."""
    for equation in reversed(definitions):
        if isinstance(equation.left, Symbol):
            written = written.substitute({equation.left.name: equation.right})
    return written
