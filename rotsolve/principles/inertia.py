"""Moments of inertia as a textbook finds them: the table, parallel axes, perpendicular axes, sums over parts and holes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import (
    ZERO,
    Call,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    add,
    multiply,
    negate,
    sqrt,
    total,
)
from rotsolve.core.derivation import Words
from rotsolve.core.equation import Equation
from rotsolve.core.heading import NOWHERE, RIGHT, Heading
from rotsolve.core.tensor import AXES, ONE_AXIS, Place
from rotsolve.core.writing import flat, is_negative, spoken
from rotsolve.motion.rigid import MINUS, Piece
from rotsolve.motion.spread import DENSITY, Spread
from rotsolve.principles.integration import INDICES, by_integration, centre_letter, mass

OTHERS = {"xx": (1, 2), "yy": (0, 2), "zz": (0, 1)}  # the coordinates whose squares make the distance from an axis
HALF = Number(Fraction(1, 2))


@dataclass(frozen=True)
class Told:
    """What a quantity is: a formula over letters with what defines them, its law and a remark."""

    formula: Formula
    label: str
    said: Words = ()
    definitions: tuple[Equation, ...] = ()


class Unknown(ValueError):
    """A moment of inertia that the scene does not settle."""


def moment(spread: Spread, entry: str) -> Told:
    """An entry of the inertia tensor about the spread's point, as a letter of its own with what defines it."""
    told = product(spread, entry) if entry not in ONE_AXIS else one_axis(spread, entry)
    if told.formula == ZERO or isinstance(told.formula, Symbol):
        return told
    letter = spread.letter("inertia", f"{INDICES.get(entry, entry)} {spread.spot}")
    if isinstance(spread.known, Symbol) and spread.central and entry == "zz":
        letter = spread.known
    return Told(letter, "", (), (*told.definitions, spread.define(letter, told.formula, told.label, told.said)))


def one_axis(spread: Spread, entry: str) -> Told:
    """A moment of inertia, by the law that a textbook takes for it."""
    return of_one(spread, entry) if len(spread.pieces) == 1 else of_all(spread, entry)


def of_one(spread: Spread, entry: str) -> Told:
    """A single shape: from the table about its centre of mass, I_cm + M d² about another point; untabled by integration."""
    piece = spread.pieces[0]
    if spread.integrates or not piece.shape.tabled:
        return Told(*by_integration(spread, piece, entry))
    distances = apart(spread, piece, entry)
    if not distances:
        return own(spread, piece, entry)
    letter, defined = central(spread, piece, entry)
    square = sum_of_squares(distances)
    said = (*distance_words(distances, square), " from the centre of mass")
    return Told(letter + piece.mass * square, "parallel axes, I = I_cm + M d²", said, defined)


def by_symmetry(spread: Spread, entry: str) -> Told | None:
    """I_y = I_x and the like, of a single shape that is the same about both axes through its centre of mass."""
    tensor = spread.pieces[0].tensor
    if len(spread.pieces) > 1 or tensor is None or not spread.central or entry not in ONE_AXIS:
        return None
    for other in {"xx": ("zz",), "yy": ("zz", "xx"), "zz": ()}[entry]:
        if tensor.entry(other) == tensor.entry(entry) != ZERO:
            told = moment(spread, other)
            return Told(told.formula, f"by symmetry, I_{entry} = I_{other}", (), told.definitions)
    return None


def perpendicular(spread: Spread) -> Told | None:
    """I_z = I_x + I_y of a flat body; None for one that is not, and for one whose I_z is the simpler one to know."""
    if not is_flat(spread) or (len(spread.pieces) == 1 and even(spread.pieces[0])):
        return None
    across = [moment(spread, entry) for entry in ("xx", "yy")]
    defined = tuple(dict.fromkeys(step for told in across for step in told.definitions))
    return Told(
        add(across[0].formula, across[1].formula), "perpendicular axes of a flat body, I_z = I_x + I_y", (), defined
    )


def is_flat(spread: Spread) -> bool:
    """Whether all mass lies at the height of the point."""
    return all(piece.shape.flat and is_zero(piece.height - spread.point[2]) for piece in spread.pieces)


def own(spread: Spread, piece: Piece, entry: str) -> Told:
    """About the centre of mass of a shape, from the table; of a flat round one about a diameter by perpendicular axes."""
    tensor = piece.tensor
    if tensor is not None and entry in ("xx", "yy") and piece.shape.flat and even(piece):
        letter, defined = central(spread, piece, "zz")
        return Told(HALF * letter, "perpendicular axes, I_z = I_x + I_y, and I_x = I_y", (), defined)
    return Told(spread.tidy(entry_of(piece, entry)), f"moment of inertia, {noun(piece)}{about_axis(piece, entry)}")


def even(piece: Piece) -> bool:
    """Whether a flat piece has the same moment about every axis in its plane, and one at all."""
    tensor = piece.tensor
    return tensor is not None and tensor.xx != ZERO and is_zero(tensor.xx - tensor.yy) and is_zero(tensor.xy)


def central(spread: Spread, piece: Piece, entry: str) -> tuple[Formula, tuple[Equation, ...]]:
    """The letter I_cm of a piece with what defines it; no letter where there is nothing to define."""
    if entry == "zz" and spread.known is not None:
        return spread.known, ()
    told = moment(replace(spread, pieces=(piece,), point=piece.place(), spot="cm", central=True), entry)
    return told.formula, told.definitions


def of_all(spread: Spread, entry: str) -> Told:
    """A body of several pieces: the sum of m d² of particles, else of the moments of its pieces, those of holes taken away."""
    seen, before = from_centre(spread)
    masses, shares = piece_masses(seen)
    before = (*before, *shares)
    if all(entry_of(piece, entry) == ZERO for piece in seen.pieces):
        terms = []
        for piece, weight in zip(seen.pieces, masses, strict=True):
            distances = apart(seen, piece, entry)
            terms.append(weight * sum_of_squares(distances) if distances else ZERO)
        return Told(total(flat(terms)), "moment of inertia, sum of m d² over the parts", (), before)
    terms, defined = [], list(before)
    for piece, weight in zip(seen.pieces, masses, strict=True):
        letter, equations = share(seen, piece, weight, entry)
        terms.append(letter)
        defined += equations
    holes = any(is_negative(piece.mass) for piece in spread.pieces)
    label = "moment of inertia, the whole less what is cut out" if holes else "moment of inertia, sum over the parts"
    return Told(total(flat(terms)), label, (), tuple(dict.fromkeys(defined)))


def share(spread: Spread, piece: Piece, mass: Formula, entry: str) -> tuple[Formula, list[Equation]]:
    """What one piece adds, as a letter of its own: its moment about its centre of mass, moved by the parallel-axes theorem."""
    cut_out = is_negative(mass)
    size = negate(mass) if cut_out else mass
    positive = (
        piece.weighing(size)
        if piece.measure is not None
        else piece.moved(RIGHT, NOWHERE, ZERO, MINUS)
        if cut_out
        else piece
    )
    distances, tabled = apart(spread, piece, entry), entry_of(positive, entry)
    if tabled == ZERO:
        return mass * sum_of_squares(distances) if distances else ZERO, []
    letter = spread.letter("inertia", f"{INDICES.get(entry, entry)} {spread.called(piece)} {spread.spot}")
    square = sum_of_squares(distances)
    said: Words = (*distance_words(distances, square),) if distances else ()
    what = f"moment of inertia, {spoken(spread.called(piece))}{'' if noun(piece) == spoken(piece.name) else f' ({noun(piece)})'}"
    label = f"{what}, parallel axes" if distances else what
    equation = spread.define(letter, add(tabled, size * square) if distances else tabled, label, said)
    return (negate(letter) if cut_out else letter), [equation]


def product(spread: Spread, entry: str) -> Told:
    """A product of inertia: the own ones of the pieces less Σ m x y."""
    if len(spread.pieces) == 1 and (spread.integrates or not spread.pieces[0].shape.tabled):
        return Told(*by_integration(spread, spread.pieces[0], entry))
    seen, before = from_centre(spread)
    masses, shares = piece_masses(seen)
    i, j = (AXES.index(axis) for axis in entry)
    terms: list[Formula] = []
    for piece, weight in zip(seen.pieces, masses, strict=True):
        arm = arm_of(seen, piece)
        inner = entry_of(piece, entry)
        terms += [inner, negate(multiply(multiply(weight, arm[i]), arm[j]))]
    written = total(flat(terms))
    if simplify(plain(written, (*before, *shares))) == ZERO:
        return Told(ZERO, "product of inertia")
    label = f"product of inertia, −Σ m {entry[0]} {entry[1]}"
    return Told(written, label, (), (*before, *shares))


def plain(written: Formula, definitions: tuple[Equation, ...]) -> Formula:
    """A formula with its letters put in."""
    for equation in reversed(definitions):
        if isinstance(equation.left, Symbol):
            written = written.substitute({equation.left.name: equation.right})
    return written


def along(spread: Spread, direction: Heading) -> Told:
    """About an axis in the plane: I_x cos² + I_y sin² + 2 I_xy sin cos."""
    told = [moment(spread, entry) for entry in ("xx", "yy", "xy")]
    parts, defined = [one.formula for one in told], [step for one in told for step in one.definitions]
    cos, sin = direction.cos(), direction.sin()
    terms = [parts[0] * cos**2, parts[1] * sin**2, 2 * parts[2] * sin * cos]
    return Told(total(flat(terms)), "moment of inertia about an axis in the plane", (), tuple(dict.fromkeys(defined)))


def gyration(spread: Spread, told: Told) -> Told:
    """k = √(I/M)."""
    whole, steps = mass(spread, spread.pieces[0]) if len(spread.pieces) == 1 else (spread.mass, ())
    defined = tuple(dict.fromkeys((*told.definitions, *steps)))
    return Told(sqrt(told.formula / whole), "radius of gyration, I = M k²", (), defined)


def centre(spread: Spread, axis: str) -> Told:
    """x of the centre of mass: Σ m x/Σ m, of a varying density (1/M) ∫ x dm."""
    number = AXES.index(axis)
    if len(spread.pieces) == 1:
        piece = spread.pieces[0]
        if not piece.shape.tabled:
            letter, steps = centre_letter(spread, piece, axis)
            return Told(letter, "", (), steps)
        at = simplify(piece.place()[number] - spread.begin[number])
        return Told(at, f"centre of mass, {noun(piece)}")
    masses, shares = piece_masses(spread)
    places = [piece.place()[number] for piece in spread.pieces]
    above = total(flat([multiply(weight, at) for weight, at in zip(masses, places, strict=True)]))
    whole = spread.mass if any(piece.measure is not None for piece in spread.pieces) else total(flat(masses))
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
    name, word = DENSITY[shared[0].shape.spread]
    rest = spread.tidy(total([piece.measure for piece in shared if piece.measure is not None]))
    sigma: Formula = simplify(total([piece.mass for piece in shared]) / rest)
    defined = []
    if not isinstance(sigma, Symbol):
        sigma = spread.letter(name)
        defined.append(spread.define(sigma, spread.mass / rest, f"mass per {word}"))
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
        if isinstance(whole, (Power, Product)) and not any(isinstance(node, Call) for node in root.walk()):
            return [root]
    return [negate(part) if backward(part) else part for part in parts]


def backward(part: Formula) -> bool:
    """Whether a distance is written with minus signs only."""
    return all(is_negative(term) for term in part.terms) if isinstance(part, Sum) else is_negative(part)


def sum_of_squares(parts: list[Formula]) -> Formula:
    return total([part**2 for part in parts])


def distance_words(parts: list[Formula], square: Formula) -> Words:
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
