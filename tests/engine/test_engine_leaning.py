"""A ladder that is rough at the floor and at the wall, let go: it slips at both ends together, or stays."""

from __future__ import annotations

from math import atan, cos, degrees, radians, sin

import numpy
import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

SCENE = """
given: {{{given}}}
surfaces: {{floor: level, side: {{wall: {side}}}}}
bodies: {{ladder: {{shape: rod, mass: M, length: L}}}}
connections: {{foot: {{contact: [ladder.{low}, floor], friction: mu}}, head: {{contact: [ladder.{high}, side], friction: nu}}}}
states: {{released: {{ladder.angle: {angle}, at rest: all{said}}}}}
find: {{al: ladder.angular_acceleration, N: foot.normal_force, H: head.normal_force}}
"""
ENDS = {"right": ("start", "end", "theta"), "left": ("start", "end", "180 deg - theta")}
ENDS |= {"right, by its end": ("end", "start", "180 deg + theta"), "left, by its end": ("end", "start", "-theta")}


def text(side: str, given: str, said: str = "") -> str:
    low, high, angle = ENDS[side]
    return SCENE.format(given=given, side=side.partition(",")[0], low=low, high=high, angle=angle, said=said)


def slipping(mass: float, size: float, mu: float, nu: float, theta: float) -> tuple[float, float, float]:
    """α, N, H of a ladder at a wall on the right: its foot slips to the left and its head down; unknowns a_x, a_y, α, N, H."""
    c, s = size / 2 * cos(theta), size / 2 * sin(theta)
    rows = [
        [mass, 0, 0, -mu, 1],
        [0, mass, 0, -1, -nu],
        [0, 0, mass * size**2 / 12, c - mu * s, -(nu * c + s)],
        [0, 1, -c, 0, 0],
        [1, 0, -s, 0, 0],
    ]
    found = numpy.linalg.solve(numpy.array(rows), numpy.array([0, -mass * 9.8, 0, 0, 0]))
    return float(found[2]), float(found[3]), float(found[4])


NUMBERS = [(1.0, 1.0, 0.1, 0.1, 45.0), (3.0, 2.0, 0.2, 0.5, 50.0), (2.0, 0.7, 0.3, 0.05, 20.0)]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("side", ENDS)
@pytest.mark.parametrize("said", ["", ", foot: slips", ", foot: slips, head: slips"])
@pytest.mark.parametrize("numbers", NUMBERS)
def test_a_ladder_slips_at_both_ends(numbers: tuple[float, ...], said: str, side: str) -> None:
    mass, size, mu, nu, theta = numbers
    given = f"M: {mass} kg, L: {size} m, mu: {mu}, nu: {nu}, theta: {theta} deg"
    answers = solve(text(side, given, said)).answers
    rate, push, other = slipping(mass, size, mu, nu, radians(theta))
    assert answers["al"].float == pytest.approx(rate if side.startswith("right") else -rate)
    assert [answers[name].float for name in "NH"] == pytest.approx([push, other])


@pytest.mark.parametrize("side", ENDS)
def test_a_ladder_stays_where_both_frictions_suffice(side: str) -> None:
    """On the point of slipping tan θ = (1 − μ ν)/(2 μ)."""
    edge = degrees(atan((1 - 0.3 * 0.2) / (2 * 0.3)))
    for angle, rests in ((edge + 0.5, True), (edge - 0.5, False)):
        given = f"M: 2 kg, L: 1 m, mu: 0.3, nu: 0.2, theta: {angle} deg"
        asked = text(side, given).replace(", N: foot.normal_force, H: head.normal_force", "")
        assert (solve(asked).answers["al"].float == 0) is rests
        if rests:
            with pytest.raises(Unsolvable, match="`foot` does not slip at `released`"):
                solve(text(side, given, ", foot: slips"))


@pytest.mark.sampled(2)
@pytest.mark.parametrize("said", [", foot: slips", ", foot: slips, head: slips"])
def test_in_letters_a_ladder_that_is_said_to_slip_does(said: str) -> None:
    solution = solve(text("right", "M: kg, L: m, mu: number, nu: number, theta: rad", said), confirm=False)
    for numbers in NUMBERS:
        values = dict(zip(("M", "L", "mu", "nu", "theta", "g"), (*numbers[:4], radians(numbers[4]), 9.8), strict=True))
        for name, true in zip(("al", "N", "H"), slipping(*numbers[:4], radians(numbers[4])), strict=True):
            formula = solution.answers[name].sympy
            found = formula.subs({letter: values[letter.name] for letter in formula.free_symbols})
            assert float(found) == pytest.approx(true), name
