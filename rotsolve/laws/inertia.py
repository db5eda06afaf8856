"""Moments of inertia as a textbook finds them: the table, parallel axes, perpendicular axes, sums over parts and holes."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import HALF, ZERO, Formula, Symbol, add, multiply, negate, sqrt, total
from rotsolve.core.derivation import Words
from rotsolve.core.equation import INERTIA, PARALLEL_AXES, Equation
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, Heading
from rotsolve.core.vectors.tensor import AXES, ONE_AXIS
from rotsolve.core.writing import flat, is_negative, spoken
from rotsolve.laws.centre_of_mass import (
    Told,
    about_axis,
    apart,
    arm_of,
    distance_words,
    entry_of,
    from_centre,
    noun,
    piece_masses,
    plain,
    sum_of_squares,
)
from rotsolve.laws.integration import INDICES, NotSliced, by_integration, mass
from rotsolve.motion.rigid import MINUS, RigidPiece
from rotsolve.motion.spread import Spread


def moment(spread: Spread, entry: str) -> Told:
    """An entry of the inertia tensor about the spread's point, as a letter of its own with what defines it."""
    told = product_of_inertia(spread, entry) if entry not in ONE_AXIS else one_axis(spread, entry)
    if told.formula == ZERO or isinstance(told.formula, Symbol):
        return told
    own = spread.axes and entry in ONE_AXIS
    axis = spread.axes[AXES.index(entry[0])] if own else INDICES.get(entry, entry)
    letter = spread.letter("inertia", f"{axis} {spread.spot}")
    if isinstance(spread.known, Symbol) and spread.central and entry == "zz":
        letter = spread.known
    step = spread.define(letter, told.formula, told.label, told.said, told.law)
    return Told(letter, "", (), (*told.definitions, step))


def one_axis(spread: Spread, entry: str) -> Told:
    """A moment of inertia, by the law that a textbook takes for it."""
    if spread.integrates and len(spread.pieces) > 1:
        raise NotSliced(
            f"`{spread.name}` is made of several pieces: ask for each by integration, or for the whole without"
        )
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
    words = distance_words(distances, square)
    said = (*words, " from the centre of mass") if words else ()
    return Told(letter + piece.mass * square, "parallel axes, I = I_cm + M d²", said, defined, PARALLEL_AXES)


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
    whole = add(across[0].formula, across[1].formula)
    return Told(whole, "perpendicular axes of a flat body, I_z = I_x + I_y", (), defined)


def is_flat(spread: Spread) -> bool:
    """Whether all mass lies at the height of the point."""
    return all(lies_flat(piece) and is_zero(piece.height - spread.point[2]) for piece in spread.pieces)


def lies_flat(piece: RigidPiece) -> bool:
    """Whether a piece lies square to z, as it is turned: then I_z = I_x + I_y about its centre."""
    tensor = piece.tensor
    turned = piece.rows is not None and tensor is not None and not is_zero(tensor.xx + tensor.yy - tensor.zz)
    return piece.shape.flat and not turned


def own(spread: Spread, piece: RigidPiece, entry: str) -> Told:
    """About the centre of mass of a shape, from the table; of a flat round one about a diameter by perpendicular axes."""
    tensor = piece.tensor
    if (
        tensor is not None
        and entry in ("xx", "yy")
        and piece.shape.outer is not None
        and lies_flat(piece)
        and even(piece)
    ):
        letter, defined = central(spread, piece, "zz")
        return Told(HALF * letter, "perpendicular axes, I_z = I_x + I_y, and I_x = I_y", (), defined)
    return Told(spread.tidy(entry_of(piece, entry)), f"moment of inertia, {noun(piece)}{about_axis(piece, entry)}")


def even(piece: RigidPiece) -> bool:
    """Whether a flat piece has the same moment about every axis in its plane, and one at all."""
    tensor = piece.tensor
    return tensor is not None and tensor.xx != ZERO and is_zero(tensor.xx - tensor.yy) and is_zero(tensor.xy)


def central(spread: Spread, piece: RigidPiece, entry: str) -> tuple[Formula, tuple[Equation, ...]]:
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


def share(spread: Spread, piece: RigidPiece, mass: Formula, entry: str) -> tuple[Formula, list[Equation]]:
    """What one piece adds, as a letter of its own: its moment about its centre of mass, moved by the parallel-axes theorem."""
    cut_out = is_negative(mass)
    size = negate(mass) if cut_out else mass
    filled = piece.moved(RIGHT, NOWHERE, ZERO, MINUS) if cut_out else piece
    positive = piece.weighing(size) if piece.measure is not None else filled
    distances, tabled = apart(spread, piece, entry), entry_of(positive, entry)
    if tabled == ZERO:
        return mass * sum_of_squares(distances) if distances else ZERO, []
    own = spread.called(piece)
    mark = f"part {own}" if own in AXES else own  # else it would be the letter of all of the body about that axis
    letter = spread.letter("inertia", f"{INDICES.get(entry, entry)} {mark} {spread.spot}")
    square = sum_of_squares(distances)
    said: Words = (*distance_words(distances, square),) if distances else ()
    what = f"moment of inertia, {spoken(own)}{'' if noun(piece) == spoken(piece.name) else f' ({noun(piece)})'}"
    label = f"{what}, parallel axes" if distances else what
    whole, law = (add(tabled, size * square), PARALLEL_AXES) if distances else (tabled, INERTIA)
    equation = spread.define(letter, whole, label, said, law)
    return (negate(letter) if cut_out else letter), [equation]


def product_of_inertia(spread: Spread, entry: str) -> Told:
    """A product of inertia: the own ones of the pieces less Σ m x y."""
    if len(spread.pieces) == 1 and (spread.integrates or not spread.pieces[0].shape.tabled):
        return Told(*by_integration(spread, spread.pieces[0], entry))
    seen, before = from_centre(spread)
    masses, shares = piece_masses(seen)
    i, j = (AXES.index(axis) for axis in entry)
    inner = [entry_of(piece, entry) for piece in seen.pieces]
    shifts: list[Formula] = []
    for piece, weight in zip(seen.pieces, masses, strict=True):
        arm = arm_of(seen, piece)
        shifts.append(negate(multiply(multiply(weight, arm[i]), arm[j])))
    written = total(flat([term for pair in zip(inner, shifts, strict=True) for term in pair]))
    if is_zero(plain(written, (*before, *shares))):
        return Told(ZERO, "product of inertia")
    own = any(part != ZERO for part in inner)
    return Told(written, product_label(entry, own, any(part != ZERO for part in shifts)), (), (*before, *shares))


def product_label(entry: str, own: bool, shifted: bool) -> str:
    """What a product of inertia is made of: of masses at places, and of pieces whose own axes are not the body's."""
    masses = f"−Σ m {entry[0]} {entry[1]}"
    if not own:
        return f"product of inertia, {masses}"
    turned = "from the moments about its own axes"
    return f"product of inertia, {turned}{f', {masses}' if shifted else ''}"


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
