"""Damped: small swings of bodies that move in one way, against forces that go by how fast they do: γ, ω₀, and which case it is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.algebra.formula import Formula, multiply, sqrt
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.equation import DAMPED_SWINGS, DAMPING_RATE
from rotsolve.core.writing import positive_first
from rotsolve.equations.normal_modes import Mode, Spectrum
from rotsolve.laws.damping import damped_swings
from rotsolve.paths.meaning import NotYet

if TYPE_CHECKING:
    from rotsolve.search.swings import Stepping

NO_TURN = {0: "critically damped: it comes back without a swing", -1: "overdamped: it creeps back without a swing"}


def settle_damped(mode: Mode, spectrum: Spectrum, word: str, search: Stepping) -> None:
    """γ, ω₀ and all that follows from them, written once; refused where it is asked for a period and there is none."""
    rows = spectrum.rows
    if len(rows.coordinates) > 1 or not spectrum.squares:
        raise NotYet("damped swings are solved of bodies that move in one way")
    inertia, damping = rows.inertia[0][0], rows.damping[0][0]
    rate, square = search.solver.simplify(damping / (2 * inertia)), spectrum.squares[0]
    if search.signs.of_sizes(rate) == -1:
        raise NotYet("what acts drives the swings on, by how fast they go: they grow")
    case = search.signs.of_sizes(search.solver.simplify(square - rate**2))
    if case is None:
        raise NotYet(
            "whether it swings or creeps back hangs on letters without a number", help="give the letters numbers"
        )
    if case < 1 and word not in ("damping_ratio", "time_constant"):
        raise NotYet(f"{NO_TURN[case]}, and has no period", help="ask for the `damping_ratio` or the `time_constant`")
    if mode.harmonic in search.swung:
        return
    search.swung.add(mode.harmonic)
    gamma, free = mode.letter_of_damping("gamma"), mode.letter_of_damping("omega0")
    section, told = mode.harmonic, in_words(mode, spectrum, gamma, free)
    words = "damping rate, half of what stands by the speed"
    search.planner.extend(DAMPING_RATE.equation(gamma, rate, section, (), told, words=words))
    undamped = search.solver.simplify(sqrt(square))
    search.planner.extend(DAMPED_SWINGS.equation(free, undamped, section, words="angular frequency without damping"))
    for equation in damped_swings(gamma, free, mode.letters, section, case):
        search.planner.extend(equation)


def in_words(mode: Mode, spectrum: Spectrum, gamma: Formula, free: Formula) -> Words:
    """The row, and the form into which it is brought."""
    rows = spectrum.rows
    (place,), (change,), (speed,) = rows.coordinates, rows.accelerations, mode.speed_letters(rows)
    terms = [
        multiply(rows.inertia[0][0], change),
        multiply(rows.damping[0][0], speed),
        multiply(rows.stiffness[0][0], place),
    ]
    form = positive_first([change, multiply(2 * gamma, speed), multiply(free**2, place)])
    held: Words = (*spectrum.held, ".", NEXT) if spectrum.held else ()
    return (
        *held,
        "To first order, by the power that all forces have:",
        NEXT,
        positive_first(terms),
        " = 0, that is ",
        form,
        " = 0",
    )
