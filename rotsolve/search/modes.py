"""Modes: from M q̈ + K q = 0 to the frequencies, which are the roots of det(K − ω² M) = 0, and the shapes of the modes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cmp_to_key, reduce
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.exact.spectrum import spectrum_roots
from rotsolve.algebra.formula import ONE, ZERO, Formula, Negative, Product, Quotient, Symbol, divide, multiply, sqrt
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.equation import MODE_SHAPE, NORMAL_MODE, Equation
from rotsolve.core.quantity import DAMPINGS
from rotsolve.core.symbols import of_kinds
from rotsolve.core.writing import and_joined, positive_first, spoken
from rotsolve.equations.normal_modes import SHAPE, Mode, Rows, Spectrum
from rotsolve.equations.swing import STRETCHES
from rotsolve.laws.modes import characteristic, determinant, shapes
from rotsolve.laws.oscillation import periods
from rotsolve.paths.meaning import NotYet
from rotsolve.search.damped import carried_in_words, settle_damped

if TYPE_CHECKING:
    from rotsolve.search.swings import Stepping

SQUARE = "ω²"


def settle_mode(mode: Mode, word: str, search: Stepping, asked: str) -> list[int]:
    """The frequency of a mode, and the ratio of two displacements in it; the equations hold for all questions."""
    spectrum = spectrum_of(mode, search)
    if word in DAMPINGS or any(part != ZERO for row in spectrum.rows.damping for part in row):
        settle_damped(mode, spectrum, word, search)
        return []
    square = spectrum.squares[number_meant(mode, spectrum) - 1]
    if mode.omega.name not in search.swung:
        search.swung.add(mode.omega.name)
        remark = rows_in_words(mode, spectrum, search)
        name = ordinal(number_meant(mode, spectrum), spectrum)
        search.planner.extend(
            NORMAL_MODE.equation(mode.omega, search.solver.simplify(sqrt(square)), mode.harmonic, (), remark, mode=name)
        )
        for equation in periods(mode.omega, mode.letters, mode.harmonic, f"period of {name}"):
            search.planner.extend(equation)
    if word == SHAPE:
        search.planner.extend(shape_of_mode(mode, spectrum, square, search))
    for letter in (mode.omega, mode.letters[word]) if word != SHAPE else (mode.letters[word],):
        if isinstance(letter, Symbol) and letter.name != asked and letter.name not in search.solver.solved:
            search.step(letter.name)
    return []


def number_meant(mode: Mode, spectrum: Spectrum) -> int:
    """Which of its modes is meant: the one that is named, or the only one."""
    count = len(spectrum.squares)
    names = and_joined([f"`{name}`" for name in sorted(mode.group)])
    if mode.number > count:
        raise NotYet(f"{names} {'have' if len(mode.group) > 1 else 'has'} {count_of(count)}, no mode {mode.number}")
    if not mode.number and count > 1:
        ways = ", ".join(f"`mode {number}`" for number in range(1, count + 1))
        raise NotYet(
            f"{names} swing in {count} ways, each with its own period",
            help=f"ask for that of {ways}, the slowest first",
        )
    return mode.number or 1


def count_of(count: int) -> str:
    return f"{count} modes" if count > 1 else "one mode"


def ordinal(number: int, spectrum: Spectrum) -> str:
    """mode 1; of the only one: the only mode."""
    return f"mode {number}" if len(spectrum.squares) > 1 else "the only mode"


def spectrum_of(mode: Mode, search: Stepping) -> Spectrum:
    """M, K and the roots of det(K − ω² M) = 0, found once for all modes of a group."""
    if mode.harmonic not in search.spectra:
        search.spectra[mode.harmonic] = new_spectrum(mode, search)
    return search.spectra[mode.harmonic]


def new_spectrum(mode: Mode, search: Stepping) -> Spectrum:
    """M and K at the equilibrium, whether it is one, and how it is driven back."""

    def tidy(value: Formula) -> Formula:
        return search.solver.simplify(search.solver.with_answers(value))

    rows = mode.rows(tidy, lambda slope: is_zero(tidy(slope)))
    rows, held = in_balance(mode, rows, search)
    letter = Symbol(SQUARE)
    matrix = characteristic(rows.inertia, rows.stiffness, letter)
    condition = search.solver.simplify(determinant(matrix))
    if letter.name not in condition.symbols():
        raise NotYet(f"{group_in_words(mode)} hold nothing that has a mass in one of their ways: that is no swing")
    roots = spectrum_roots(condition, letter.name, order=search.solver.order, positive=search.solver.positive)
    if roots is None:
        raise NotYet(f"the frequencies of {group_in_words(mode)} have no closed form: that is not solved yet")
    free = [root for root in roots if is_zero(root)]
    squares = [root for root in roots if not is_zero(root)]
    check_driven_back(mode, rows, squares, search)
    if len(roots) < len(rows.coordinates):
        raise NotYet(f"something of {group_in_words(mode)} that can move by itself has no mass: that is not solved yet")
    if free:
        check_neutral(mode, rows, search)
    return Spectrum(rows, matrix, condition, tuple(slowest_first(mode, squares, search)), len(free), held)


def group_in_words(mode: Mode) -> str:
    return and_joined([f"`{name}`" for name in sorted(mode.group)])


def in_balance(mode: Mode, rows: Rows, search: Stepping) -> tuple[Rows, Words]:
    """The rows with what the balance of forces at the equilibrium tells of stretches and angles put in, which have to be in balance."""
    found: dict[str, Formula] = {}
    for push in rows.pushes:
        left = search.solver.simplify(push.substitute(found))
        letter = next((name for name in of_kinds(left.symbols(), STRETCHES)), "")
        value = solve_linear(left, letter) if letter else None
        if value is not None:
            found = {name: told.substitute({letter: value}) for name, told in found.items()} | {letter: value}
        elif letter:
            raise NotYet(f"the equilibrium of {group_in_words(mode)} has no closed form: that is not solved yet")
        elif search.signs.decide(left) != 0:
            verb, state = "is" if len(mode.group) == 1 else "are", spoken(mode.rest.state)
            raise NotYet(f"{group_in_words(mode)} {verb} not in equilibrium {f'at {state}' if state else 'as drawn'}")
    spoken_of = {name for part in matrix_entries(rows) for name in part.symbols()}
    known = set(search.givens) | set(search.values)
    settled = replace_parts(rows, lambda part: search.solver.simplify(part.substitute(found)))
    if {name for part in matrix_entries(settled) for name in part.symbols()} - known:
        raise NotYet(
            f"how {group_in_words(mode)} swing depends on how springs are stretched in the equilibrium, which is not told"
        )
    told = {name: value for name, value in found.items() if name in spoken_of}
    words: list[str | Formula] = []
    for name, value in told.items():
        words += [", " if words else "In balance ", Symbol(name), " = ", search.solver.simplify(value)]
    return settled, tuple(words)


def matrix_entries(rows: Rows) -> Iterator[Formula]:
    """The entries of M and K."""
    return (part for matrix in (rows.inertia, rows.stiffness) for row in matrix for part in row)


def replace_parts(rows: Rows, change: Callable[[Formula], Formula]) -> Rows:
    """The rows with each entry, and what pushes along a way, changed."""
    inertia, stiffness = (tuple(tuple(map(change, row)) for row in matrix) for matrix in (rows.inertia, rows.stiffness))
    damping = tuple(tuple(map(change, row)) for row in rows.damping)
    return replace(rows, inertia=inertia, stiffness=stiffness, damping=damping, along=tuple(map(change, rows.along)))


def check_driven_back(mode: Mode, rows: Rows, squares: Sequence[Formula], search: Stepping) -> None:
    """K has to be symmetric, as of forces with a potential, and no ω² negative."""
    size = range(len(rows.coordinates))
    if any(
        not is_zero(rows.stiffness[i][j] - rows.stiffness[j][i], search.solver.positive) for i in size for j in range(i)
    ):
        raise NotYet(
            f"a force on {group_in_words(mode)} has no potential: what it does to their swings is not solved yet"
        )
    place = "the equilibrium" if mode.found else spoken(mode.rest.state)
    if any(search.signs.of_sizes(square) == -1 for square in squares):
        raise NotYet(f"{group_in_words(mode)} have no small swings about {place}: the equilibrium is unstable")
    if not squares or any(search.signs.of_sizes(square) == 0 for square in squares):
        raise NotYet(f"nothing drives {group_in_words(mode)} back to {place}: there are no small swings")


def surely_stable(rows: Rows, search: Stepping) -> bool:
    """Whether all leading minors of K are positive (Sylvester), so that each ω² is."""
    minors = (tuple(row[:size] for row in rows.stiffness[:size]) for size in range(1, len(rows.stiffness) + 1))
    return all(search.signs.of_sizes(search.solver.simplify(determinant(minor))) == 1 for minor in minors)


def check_neutral(mode: Mode, rows: Rows, search: Stepping) -> None:
    """Along a way in which nothing drives it back nothing may push at any distance: else that is an equilibrium of higher order."""
    size = range(len(rows.coordinates))
    alone = [j for j in size if all(is_zero(row[j], search.solver.positive) for row in rows.stiffness)]
    ways: list[tuple[Formula, ...]] = [tuple(ONE if other == j else ZERO for other in size) for j in alone]
    ways = ways or [shape for shape in shapes(rows.stiffness) if not all(map(is_zero, shape))][:1] or [()]
    for way in ways:
        moved = {place.name: part * place for place, part in zip(rows.coordinates, way, strict=False)}
        first = rows.coordinates[0]
        moved = {
            name: part.substitute(dict.fromkeys([c.name for c in rows.coordinates], first))
            for name, part in moved.items()
        }
        if not moved or not all(is_zero(push.substitute(moved), search.solver.positive) for push in rows.along):
            raise NotYet(
                f"in one of their ways nothing drives {group_in_words(mode)} back to first order: such swings are not solved yet"
            )


def slowest_first(mode: Mode, squares: Sequence[Formula], search: Stepping) -> list[Formula]:
    """The roots from the smallest on, which numbers or letters have to tell."""

    def side(one: Formula, other: Formula) -> int:
        if one == other:
            return 0
        sign = search.signs.decide(search.solver.simplify(one - other))
        if sign is None:
            help = "give the letters numbers"
            raise NotYet(
                f"which mode of {group_in_words(mode)} is the slower one hangs on letters without a number", help=help
            )
        return sign

    return sorted(squares, key=cmp_to_key(side))


def rows_in_words(mode: Mode, spectrum: Spectrum, search: Stepping) -> Words:
    """The rows, the condition and what is to be said of it, where they stand for the first time; when it is stable."""
    number, square = number_meant(mode, spectrum), mode.omega**2
    unsure = (
        number == 1 and search.signs.of_sizes(spectrum.squares[0]) is None and not surely_stable(spectrum.rows, search)
    )
    stable: Words = (NEXT, "Stable while ", square, " > 0.") if unsure else ()
    if mode.harmonic in search.swung:
        return stable[1:]
    search.swung.add(mode.harmonic)
    rows = spectrum.rows
    lines: list[Words] = [
        ("To first order, coordinate by coordinate, by the power that all forces have where it alone changes:",)
    ]
    for masses, stiff in zip(rows.inertia, rows.stiffness, strict=True):
        terms = [multiply(part, rate) for part, rate in zip(masses, rows.accelerations, strict=True)]
        terms += [multiply(part, place) for part, place in zip(stiff, rows.coordinates, strict=True)]
        lines.append((positive_first(terms), " = 0"))
    if rows.led:
        lines[:0] = carried_in_words(mode, rows)
    if spectrum.held:
        lines.insert(0, (*spectrum.held, "."))
    lines += determinant_in_words(mode, spectrum, search)
    return (*tuple(part for line in lines for part in (NEXT, *line))[1:], *stable)


def determinant_in_words(mode: Mode, spectrum: Spectrum, search: Stepping) -> Iterator[Words]:
    """det(K − ω² M) = 0, why that is so, and of its root 0."""
    omega = mode.common
    why = (
        "In a mode all swing with one ",
        omega,
        ", so that each acceleration is −",
        omega**2,
        " times its displacement",
    )
    yield (*why, "; det(K − ", omega**2, " M) = 0:")
    yield search.solver.simplify(without_factors(spectrum.condition).substitute({SQUARE: omega**2})), " = 0"
    if spectrum.free:
        yield "The root ", omega, " = 0 is no swing: nothing drives the bodies back as they all move on together."


def without_factors(condition: Formula) -> Formula:
    """What is 0 by ω², without what it is multiplied or divided by."""
    top = condition.numerator if isinstance(condition, Quotient) else condition
    if isinstance(top, Negative):
        return without_factors(top.operand)
    if isinstance(top, Product):
        return reduce(multiply, (part for part in top.factors if SQUARE in part.symbols()))
    return top


def shape_of_mode(mode: Mode, spectrum: Spectrum, square: Formula, search: Stepping) -> Equation:
    """The ratio of two displacements in a mode: from the rows of K − ω² M that leave it open no more."""
    same = [other for other in spectrum.squares if other == square or search.signs.sign(other - square) == 0]
    if len(same) > 1:
        raise NotYet(
            f"two modes of {group_in_words(mode)} have the same frequency: any motion between them is one, so no ratio is told"
        )
    letters = [mode.way_of(*one) for one in mode.compared]
    grown = [spectrum.rows.displaced[letter.name] for letter in letters]
    for shape in shapes(spectrum.matrix):
        moved = dict(zip((place.name for place in spectrum.rows.coordinates), shape, strict=True))
        top, bottom = (side.substitute(moved) for side in grown)
        there = [search.solver.simplify(side.substitute({SQUARE: square})) for side in (top, bottom)]
        if all(is_zero(side) or search.signs.sign(side) == 0 for side in shape_at(shape, square, search)):
            continue
        if is_zero(there[1], search.solver.positive) or search.signs.sign(there[1]) == 0:
            raise NotYet(
                f"`{mode.compared[1][0]}` stays at rest in mode {number_meant(mode, spectrum)}: there is no ratio to it"
            )
        whole = search.solver.simplify(top / bottom)
        ratio = min(whole, divide(*map(search.solver.simplify, (top, bottom))), key=length)
        told: Words = (ratio.substitute({SQUARE: mode.omega**2}),) if SQUARE in ratio.symbols() else ()
        value = search.solver.simplify(ratio.substitute({SQUARE: square}))
        pair = " to ".join(spoken(owner) for owner, *_ in mode.compared)
        words = f"shape of {ordinal(number_meant(mode, spectrum), spectrum)}, {pair}"
        return MODE_SHAPE.equation(mode.letters[SHAPE], value, mode.harmonic, (), told, words=words)
    raise NotYet(f"the shape of mode {mode.number} of {group_in_words(mode)} is not told")


def shape_at(shape: Sequence[Formula], square: Formula, search: Stepping) -> list[Formula]:
    """The amplitudes of a mode with its ω² put in."""
    return [search.solver.simplify(part.substitute({SQUARE: square})) for part in shape]
