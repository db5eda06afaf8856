"""Integration: mass, centre of mass and moments of inertia as integrals over the thin elements into which a shape is cut."""

from __future__ import annotations

from rotsolve.algebra.calculus import integrate_polynomial
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Symbol, multiply
from rotsolve.core.derivation import Words
from rotsolve.core.equation import Equation
from rotsolve.core.tensor import AXES, Place, displaced
from rotsolve.elements.shapes.slicing import Slicing
from rotsolve.motion.rigid import Piece
from rotsolve.motion.spread import DENSITY, Spread

Told = tuple[Formula, str, Words, tuple[Equation, ...]]
EXTENTS = {"line": ("s", "length"), "surface": ("A", "area"), "volume": ("V", "volume")}
INTEGRALS = {
    "xx": "I = ∫ (y² + z²) dm",
    "yy": "I = ∫ (x² + z²) dm",
    "zz": "I = ∫ r² dm, r the distance from the axis",
    "xy": "I_xy = −∫ x y dm",
    "yz": "I_yz = −∫ y z dm",
    "zx": "I_zx = −∫ z x dm",
}


class NotSliced(ValueError):
    """A shape over which no textbook integrates in one way."""


def sliced(spread: Spread, piece: Piece) -> Slicing:
    """The elements of a shape, with the letters of its coordinates as this derivation prints them."""
    cut = piece.shape.slicing() if piece.whole else None
    if cut is None:
        raise NotSliced(f"`{spread.name}` is not integrated over: it is no single shape with a slicing of its own")
    return cut.renamed({item.variable.name: coordinate(spread, item.variable.name) for item in cut.ranges})


def coordinate(spread: Spread, name: str) -> Symbol:
    return spread.letter("coordinate", name.lstrip("|"))


def density(spread: Spread, piece: Piece) -> tuple[Formula, tuple[Equation, ...]]:
    """Mass per length, area or volume of a uniform shape: M over what a table says it is, or over its integral."""
    shape = piece.shape
    if shape.graded:
        return ONE, ()
    given = simplify(spread.mass / shape.content())
    if isinstance(given, Symbol):
        return given, ()
    letter, word = DENSITY[shape.spread]
    sigma = spread.letter("density", letter)
    if shape.tabled:
        return sigma, (spread.define(sigma, spread.mass / shape.content(), f"mass per {word}"),)
    extent, defined = content(spread, piece)
    return sigma, (*defined, spread.define(sigma, spread.mass / extent, f"mass per {word}"))


def content(spread: Spread, piece: Piece) -> tuple[Formula, tuple[Equation, ...]]:
    """The length, area or volume of a shape that no table holds."""
    letter, word = EXTENTS[piece.shape.spread]
    cut = sliced(spread, piece)
    extent = spread.letter("extent", letter)
    integral = cut.total(ONE)
    return extent, (spread.define(extent, integral, f"{word}, sum over thin elements", told_of(cut, integral)),)


def mass(spread: Spread, piece: Piece) -> tuple[Formula, tuple[Equation, ...]]:
    """The mass: as it is given, or of a varying density M = ∫ dm."""
    if not piece.shape.graded:
        return spread.mass, ()
    letter = spread.letter("mass", "")
    cut = sliced(spread, piece)
    integral = cut.total(ONE)
    said = (*elements(cut, ONE), *antiderivative(integral))
    return letter, (spread.define(letter, integral, "mass, M = ∫ dm", said),)


def centre_letter(spread: Spread, piece: Piece, axis: str) -> tuple[Formula, tuple[Equation, ...]]:
    """x = (1/M) ∫ x dm, from where the shape's coordinates begin; zero where symmetry says so."""
    cut = sliced(spread, piece)
    sigma, defined = density(spread, piece)
    whole, more = mass(spread, piece)
    integral = cut.total(multiply(sigma, cut.first(axis)))
    if simplify(piece.place()[AXES.index(axis)] - cut.origin[AXES.index(axis)]) == ZERO:
        return ZERO, ()
    said = (*elements(cut, sigma), *antiderivative(integral))
    label = f"centre of mass, {axis} = (1/M) ∫ {axis} dm"
    letter = spread.letter("cm", f"{axis}_cm")
    return letter, (*defined, *more, spread.define(letter, ONE / whole * integral, label, said))


def by_integration(spread: Spread, piece: Piece, entry: str) -> Told:
    """∫ r² dm about the point itself, or about the axis of the elements and from there by the parallel-axes theorem."""
    cut = sliced(spread, piece)
    straight = cut.measured_from(spread.point) if piece.shape.tabled or not spread.central else None
    sigma, defined = density(spread, piece)
    if straight is not None:
        return (*integral_of(straight, sigma, entry), defined)
    about, label, said = integral_of(cut, sigma, entry)
    whole, more = mass(spread, piece)
    centre, placed = centre_letters(spread, piece, cut)
    defined = (*defined, *more, *placed)
    there = displaced(whole, centre).entry(entry)
    here = displaced(whole, tuple_of(p - o - c for p, o, c in zip(spread.point, cut.origin, centre, strict=True)))
    away = ZERO if spread.central else here.entry(entry)
    letter: Formula = about
    if there != ZERO or away != ZERO:
        letter = spread.letter("inertia", f"{entry.replace('zz', '') if entry not in ('xx', 'yy') else entry[0]} O")
        defined = (*defined, spread.define(letter, about, label, said))
        label, said = "parallel axes, I = I_cm + M d²", ("O is where the coordinates begin",)
    return letter - there + away, label, said, defined


def centre_letters(spread: Spread, piece: Piece, cut: Slicing) -> tuple[Place, tuple[Equation, ...]]:
    """The centre of mass from the origin of the elements: a letter for each coordinate that has to be integrated."""
    found: list[Formula] = []
    defined: list[Equation] = []
    for axis, at, origin in zip(AXES, piece.place(), cut.origin, strict=True):
        if piece.shape.tabled:
            found.append(simplify(at - origin))
            continue
        letter, steps = centre_letter(spread, piece, axis)
        found.append(letter)
        defined += steps
    return tuple_of(found), tuple(dict.fromkeys(defined))


def tuple_of(parts: object) -> Place:
    x, y, z = (simplify(part) for part in parts)  # type: ignore[attr-defined]
    return (x, y, z)


def integral_of(cut: Slicing, sigma: Formula, entry: str) -> tuple[Formula, str, Words]:
    """The integral for an entry, its law, and what the elements are."""
    second = cut.second(entry)
    integral = cut.total(multiply(sigma, second))
    if second == ZERO:
        return ZERO, INTEGRALS[entry], ()
    each: Words = ("; each adds ", second, " dm")
    return integral, INTEGRALS[entry], (*elements(cut, sigma), *each, *antiderivative(integral))


def elements(cut: Slicing, sigma: Formula) -> Words:
    """"rings of radius r and width dr, dm = 2 π σ r dr"."""
    width: Words = tuple(part for item in cut.ranges for part in (" d", item.variable))
    return (*cut.element, ": dm = ", simplify(multiply(sigma, cut.weight)), *width)


def told_of(cut: Slicing, integral: Formula) -> Words:
    return (*cut.element, *antiderivative(integral))


def antiderivative(integral: Formula) -> Words:
    """"; antiderivative …", where there is one in closed form to be written."""
    if not isinstance(integral, Integral) or isinstance(integral.integrand, Integral):
        return ()
    found = integrate_polynomial(integral.integrand, integral.variable)
    return () if found is None else ("; antiderivative ", simplify(found))
