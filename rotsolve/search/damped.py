"""Damped: small swings of bodies that move in one way, against forces that go by how fast they do: γ, ω₀, and which case it is."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Formula, multiply, sqrt
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.equation import DAMPED_SWINGS, DAMPING_RATE
from rotsolve.core.writing import and_joined, positive_first, spoken
from rotsolve.equations.normal_modes import Mode, Rows, Spectrum
from rotsolve.laws.damping import ALONE, TURNING, damped_swings
from rotsolve.paths.meaning import NotYet

if TYPE_CHECKING:
    from rotsolve.search.swings import Stepping

NO_TURN = {0: "critically damped: it comes back without a swing", -1: "overdamped: it creeps back without a swing"}


def settle_damped(mode: Mode, spectrum: Spectrum, word: str, search: Stepping) -> None:
    """γ, ω₀ and what is asked by them, each written once; refused where it is asked for a period and there is none."""
    rows = spectrum.rows
    if not any(part != ZERO for row in rows.damping for part in row):
        raise NotYet("nothing damps these swings", help="an action such as `force: -b*block.velocity` does")
    if len(rows.coordinates) > 1 or not spectrum.squares:
        raise NotYet("damped swings are solved of bodies that move in one way")
    rate = search.solver.simplify(rows.damping[0][0] / (2 * rows.inertia[0][0]))
    if search.signs.of_sizes(rate) == -1:
        raise NotYet("what acts drives the swings on, by how fast they go: they grow")
    gamma, free = mode.letter_of_damping("gamma"), mode.letter_of_damping("omega0")
    case = case_of_damping(rate, spectrum.squares[0], word, search)
    if mode.harmonic not in search.swung:
        search.swung.add(mode.harmonic)
        told, words = row_in_words(mode, spectrum, gamma, free), "damping rate, half of what stands by the speed"
        search.planner.extend(DAMPING_RATE.equation(gamma, rate, mode.harmonic, (), told, words=words))
        undamped, words = search.solver.simplify(sqrt(spectrum.squares[0])), "angular frequency without damping"
        search.planner.extend(DAMPED_SWINGS.equation(free, undamped, mode.harmonic, words=words))
    kind = word if word in ALONE else TURNING
    if f"{mode.harmonic} {kind}" not in search.swung:
        search.swung.add(f"{mode.harmonic} {kind}")
        for equation in damped_swings(gamma, free, mode.letters, mode.harmonic, case, kind):
            search.planner.extend(equation)


def case_of_damping(rate: Formula, square: Formula, word: str, search: Stepping) -> int:
    """The sign of ω₀ − γ. Where it hangs on a letter that is sought, what has a period swings, which the answer has to fulfil."""
    gap = search.solver.simplify(square - rate**2)
    case = 1 if word == "damping_ratio" else search.signs.of_sizes(gap)
    if case is None and gap.symbols() & search.scene.configuration.problem.sought and word not in ALONE:
        case = 1
    if case is None:
        message = "whether it swings or creeps back hangs on letters without a number"
        raise NotYet(message, help="give the letters numbers")
    if case < 1 and word not in ALONE:
        raise NotYet(f"{NO_TURN[case]}, and has no period", help="ask for the `damping_ratio` or the `time_constant`")
    return case


def row_in_words(mode: Mode, spectrum: Spectrum, gamma: Formula, free: Formula) -> Words:
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
    if rows.led:
        held = (*(part for line in carried_in_words(mode, rows) for part in (*line, NEXT)), *held)
    return (
        *held,
        "To first order, by the power that all forces have:",
        NEXT,
        positive_first(terms),
        " = 0, that is ",
        form,
        " = 0",
    )


def carried_in_words(mode: Mode, rows: Rows) -> Iterator[Words]:
    """That −m a pushes what is carried along, and where it hangs then."""
    led = and_joined(list(dict.fromkeys(map(spoken, rows.led))))
    yield (f"Seen from {led} each body is pushed by −m a too, with the a of {led}.",)
    for name, angle in mode.angles_found():
        yield (f"At rest there {spoken(name)} has the angle ", angle, ".")
