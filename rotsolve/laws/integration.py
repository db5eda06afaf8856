"""Integration: mass, centre of mass and moments of inertia as integrals over the thin elements into which a shape is cut."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Integral, Sum, Symbol, multiply
from rotsolve.core.derivation import NEXT, SHOWN, Words
from rotsolve.core.equation import INTEGRATED, PARALLEL_AXES, Equation, Law
from rotsolve.core.slicing import Slicing
from rotsolve.core.symbols import key_of
from rotsolve.core.vectors.tensor import AXES, ONE_AXIS, Place, displaced
from rotsolve.motion.rigid import RigidPiece
from rotsolve.motion.spread import DENSITY, EXTENTS, Spread

Steps = tuple[Equation, ...]
INTEGRALS = {
    "xx": "I = ∫ (y² + z²) dm",
    "yy": "I = ∫ (x² + z²) dm",
    "zz": "I = ∫ r² dm",
    "xy": "I_xy = −∫ x y dm",
    "yz": "I_yz = −∫ y z dm",
    "zx": "I_zx = −∫ z x dm",
}
INDICES = {"xx": "x", "yy": "y", "zz": ""}  # how a letter tells its axis: not at all where it is square to the picture
LINE = "line"  # what is spread over a length needs no size beside it
FLAT = {"xx": "I = ∫ y² dm", "yy": "I = ∫ x² dm"}


class NotSliced(ValueError):
    """A shape over which no textbook integrates in one way."""


def sliced(spread: Spread, piece: RigidPiece) -> Slicing:
    """The elements of a shape, with the letters of its coordinates as this derivation prints them."""
    cut = piece.shape.slicing() if piece.whole else None
    if cut is None:
        raise NotSliced(f"`{spread.name}` has no usual elements over which to integrate")
    return cut.renamed({item.variable.name: spread.coordinate(key_of(item.variable.name).owner) for item in cut.ranges})


def origin(piece: RigidPiece) -> Place:
    """Where the coordinates of a shape's elements begin, in its own axes."""
    cut = piece.shape.slicing()
    assert cut is not None
    return cut.origin


def density(spread: Spread, piece: RigidPiece) -> tuple[Formula, Steps]:
    """Mass per length, area or volume of a uniform shape: M over what a table says it is, or over its integral."""
    shape = piece.shape
    if shape.graded:
        return ONE, ()
    given = simplify(spread.mass / shape.content())
    if isinstance(given, Symbol):
        return given, ()
    letter, word = DENSITY[shape.spread]
    sigma = spread.letter(letter)
    if shape.tabled:
        return sigma, (spread.define(sigma, spread.mass / spread.tidy(shape.content()), f"mass per {word}"),)
    extent, steps = content(spread, piece)
    return sigma, (*steps, spread.define(sigma, spread.mass / extent, f"mass per {word}"))


def content(spread: Spread, piece: RigidPiece) -> tuple[Formula, Steps]:
    """The length, area or volume of a shape that no table holds."""
    letter, word = EXTENTS[piece.shape.spread]
    cut = sliced(spread, piece)
    integral = cut.total(ONE, spread.tidy)
    extent = spread.letter(letter)
    return extent, (spread.define(extent, integral, f"{word}, {letter} = ∫ d{letter}", cut.element),)


def mass(spread: Spread, piece: RigidPiece) -> tuple[Formula, Steps]:
    """The mass: as it is given, of a density that varies M = ∫ dm, of a shape that no table holds σ A."""
    if piece.shape.tabled:
        return spread.mass, ()
    sigma, steps = density(spread, piece)
    if piece.shape.graded and spread.mass != piece.shape.measure():  # told too
        return spread.mass, ()
    letter = spread.letter("mass")
    if piece.shape.graded:
        cut = sliced(spread, piece)
        integral = cut.total(ONE, spread.tidy)
        return letter, (spread.define(letter, integral, "mass, M = ∫ dm", elements(spread, cut, ONE), INTEGRATED),)
    if steps:  # the density comes from the mass
        return spread.mass, ()
    extent, steps = content(spread, piece)
    return letter, (*steps, spread.define(letter, sigma * extent, "mass"))


def mass_beside_density(spread: Spread, sigma: Formula) -> Iterator[Equation]:
    """M = σ A, or ∫ dm, of a body of which the scene tells both: it says how large is what is not told."""
    piece = spread.pieces[0]
    if piece.shape.graded:
        if spread.mass != piece.shape.measure():
            from rotsolve.algebra.calculus.integral import carried_out

            cut = sliced(spread, piece)
            integral = cut.total(ONE, spread.tidy)
            whole = carried_out(integral, spread.positive)  # what stands in an integral can not be solved for
            said = (*elements(spread, cut, ONE), NEXT, "Their sum is M = ", integral, ".")
            yield spread.define(spread.mass, whole, "mass, M = ∫ dm", said, INTEGRATED)
    elif not is_zero(spread.mass - (whole := simplify(sigma * piece.shape.content()))):
        yield spread.define(spread.mass, whole, f"mass, density times {EXTENTS[piece.shape.spread][1]}")


def centre_letter(spread: Spread, piece: RigidPiece, axis: str) -> tuple[Formula, Steps]:
    """x = (1/M) ∫ x dm, from where the shape's coordinates begin; zero where symmetry says so."""
    number = AXES.index(axis)
    cut = sliced(spread, piece)
    if is_zero(piece.place()[number] - cut.origin[number]):
        return ZERO, ()
    sigma, steps = density(spread, piece)
    whole, more = mass(spread, piece)
    integral = cut.total(multiply(sigma, cut.first(axis)), spread.tidy)
    said = elements(spread, cut, sigma, piece.shape.spread)
    letter = spread.letter("cm", f"{axis}_cm")
    label = f"centre of mass, {axis} = (1/M) ∫ {axis} dm"
    return letter, (*steps, *more, spread.define(letter, ONE / whole * integral, label, said, INTEGRATED))


def by_integration(spread: Spread, piece: RigidPiece, entry: str) -> tuple[Formula, str, Words, Steps, Law]:
    """∫ r² dm about the point itself, or about the axis of the elements and from there by the parallel-axes theorem."""
    cut = sliced(spread, piece)
    straight = cut.measured_from(spread.point) if piece.shape.tabled or not spread.central else None
    sigma, steps = density(spread, piece)
    if straight is not None:
        return (*integral_of(spread, piece, straight, sigma, entry), steps, INTEGRATED)
    whole, more = mass(spread, piece)
    centre, placed = centre_of(spread, piece, cut)
    about, label, said = integral_of(spread, piece, cut, sigma, entry)
    steps = (*steps, *more, *placed)
    letter: Formula = about
    if about != ZERO:
        letter = spread.letter("inertia", f"{INDICES.get(entry, entry)} {cut.at}")
        steps = (*steps, spread.define(letter, about, label, said, INTEGRATED))
    there = displaced(whole, centre).entry(entry)
    seen = place_of(p - o - c for p, o, c in zip(spread.point, cut.origin, centre, strict=True))
    away = ZERO if spread.central else displaced(whole, seen).entry(entry)
    words = "I_cm = I − M d²" if spread.central else "I = I_cm + M d²"
    words = f"parallel axes, {words if entry in ONE_AXIS else 'products'}"
    return letter - there + away, words, (), steps, PARALLEL_AXES


def centre_of(spread: Spread, piece: RigidPiece, cut: Slicing) -> tuple[Place, Steps]:
    """The centre of mass from the origin of the elements: a letter for each coordinate that has to be integrated."""
    if piece.shape.tabled:
        return place_of(at - origin for at, origin in zip(piece.place(), cut.origin, strict=True)), ()
    found = [centre_letter(spread, piece, axis) for axis in AXES]
    return place_of(letter for letter, _ in found), tuple(dict.fromkeys(step for _, steps in found for step in steps))


def place_of(parts: Iterable[Formula]) -> Place:
    x, y, z = (simplify(part) for part in parts)
    return (x, y, z)


def integral_of(
    spread: Spread, piece: RigidPiece, cut: Slicing, sigma: Formula, entry: str
) -> tuple[Formula, str, Words]:
    """The integral for an entry, its law, and what the elements are."""
    second = cut.second(entry)
    words = {**INTEGRALS, **(FLAT if piece.shape.flat else {})}
    label = f"{'moment' if entry in ONE_AXIS else 'product'} of inertia, {words[entry]}"
    integral = cut.total(multiply(sigma, second), spread.tidy)
    if second == ZERO or integral == ZERO or (isinstance(integral, Integral) and integral.integrand == ZERO):
        return ZERO, label, ()
    plain: dict[Formula, Formula] = {item.variable**2: item.variable for item in cut.ranges}
    factor: Words = ("(", second, ")") if isinstance(second, Sum) else (second,)
    each: Words = (f"In {words[entry]} each adds ", *factor, " dm.")
    if second in plain:
        adds = spread.tidy(multiply(multiply(sigma, cut.weight), second))
        away = ("All of each is at the same distance ", plain[second], " from the axis, so that it adds")
        shown = (SHOWN, "dI = ", second, " dm = ", adds, *differentials(cut))
        each = (
            *away,
            *shown,
            SHOWN,
            "The moment of inertia is the sum of what all add: an integral",
            *from_end_to_end(cut),
            ".",
        )
    return integral, label, (*elements(spread, cut, sigma, piece.shape.spread), NEXT, *each)


def differentials(cut: Slicing) -> Words:
    """The widths of an element, " dx dy"."""
    return tuple(part for item in cut.ranges for part in (" d", item.variable))


def from_end_to_end(cut: Slicing) -> Words:
    """From where to where a single variable goes."""
    if len(cut.ranges) != 1:
        return ()
    (item,) = cut.ranges
    return (" from ", item.variable, " = ", item.lower, " to ", item.variable, " = ", item.upper)


def elements(spread: Spread, cut: Slicing, sigma: Formula, over: str = LINE) -> Words:
    """Into what a shape is cut, how large each of it is, and its mass: "Cut into rings of radius r and width dr …", dm = 2 π σ r dr."""
    width, letter = differentials(cut), EXTENTS[over][0]
    adds = spread.tidy(multiply(sigma, cut.weight))
    if sigma == ONE or cut.weight == ONE or over == LINE or cut.weight in cut.element:
        return ("Cut into ", *cut.element, ", each of mass", SHOWN, "dm = ", adds, *width)
    unrolled = cut.weight in {2 * PI * item.variable for item in cut.ranges}
    size = ". Unrolled, each is a strip as long as its circumference, of " if unrolled else ", each of "
    own: Words = (f"{size}{DENSITY[over][1]}", SHOWN, f"d{letter} = ", spread.tidy(cut.weight), *width, SHOWN)
    per: Words = (", as ", sigma, f" is the mass per {DENSITY[over][1]},") if isinstance(sigma, Symbol) else ()
    return (
        "Cut into ",
        *cut.element,
        *own,
        "and",
        *per,
        " of mass",
        SHOWN,
        "dm = ",
        sigma,
        f" d{letter} = ",
        adds,
        *width,
    )
