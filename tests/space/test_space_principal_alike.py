"""Principal moments that are equal by the values of angles alone, that differ a little, or that differ by a factor of all letters."""

from __future__ import annotations

import math

import numpy
import pytest

from rotsolve import Solution, Unsolvable, solve

ROD = "r{}: {{shape: rod, mass: m, length: L, at: [0, 0, 0], turned: {{about: z, by: {} deg}}}}"
NUMBERS = "m: 1 kg, L: 1 m"
EQUAL = {"three": (10, 70, 130), "five": (7.3, 79.3, 151.3, 223.3, 295.3), "two kinds": (10, 70, 130, 15, 105)}
LAMINA = "p: {{shape: lamina, mass: M, region: {}, points: {{O: [0, 0, 0]}}}}"


def rods(angles: tuple[float, ...], find: str, given: str = NUMBERS) -> Solution:
    parts = ", ".join(ROD.format(number, angle) for number, angle in enumerate(angles))
    return solve(f"up: z\ngravity: none\ngiven: {{{given}}}\nbodies: {{s: {{parts: {{{parts}}}}}}}\nfind: {{{find}}}\n")


def numbers(found: Solution, name: str) -> list[float]:
    return [float(part.float or 0) for part in found.answers[name].components.values()]


@pytest.mark.parametrize("case", EQUAL)
def test_equal_rods_evenly_round_have_two_equal_moments(case: str) -> None:
    """By hand: n rods in a plane, evenly round, have n m L²/24 about each line in it, and n m L²/12 across."""
    each = len(EQUAL[case]) / 24
    found = rods(EQUAL[case], "P: s.principal_moments, e: s.principal_axis")
    assert numbers(found, "P") == pytest.approx([each, each, 2 * each], rel=1e-9)
    assert numbers(found, "e") == [0, 0, 1]
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize("given", [NUMBERS, "m: kg, L: m"])
@pytest.mark.parametrize("number", [1, 2])
def test_no_axis_of_a_moment_that_equals_another(number: int, given: str) -> None:
    with pytest.raises(Unsolvable, match="two principal moments are equal, and all lines in a plane"):
        rods(EQUAL["three"], f"e: s.principal_axis.{number}", given)


def test_a_thousandth_of_a_degree_tells_the_axes() -> None:
    tensor = numpy.zeros((3, 3))
    for angle in numpy.radians((10, 70.001, 130)):
        way = numpy.array([math.cos(angle), math.sin(angle), 0])
        tensor += (numpy.eye(3) - numpy.outer(way, way)) / 12
    axis = numpy.linalg.eigh(tensor)[1][:, 0]
    own = numpy.array(numbers(rods((10, 70.001, 130), "e: s.principal_axis.1"), "e"))
    assert abs(own @ axis) == pytest.approx(1, abs=1e-9)


@pytest.mark.parametrize("asked", ["principal_moments", "principal_axis", "principal_axis.1"])
def test_what_no_precision_tells_apart_is_refused_by_name(asked: str) -> None:
    with pytest.raises(Unsolvable, match="equal, or nearly: no precision tells"):
        rods((10.00001, 70.00001, 130.00001), f"x: s.{asked}")


def test_the_third_axis_does_not_hang_on_the_others() -> None:
    assert numbers(rods((10.00001, 70.00001, 130.00001), "e: s.principal_axis.3"), "e") == [0, 0, 1]


@pytest.mark.parametrize(
    ("region", "moments"),
    [
        ("{r: [0, R], phi: [0, pi/2]}", ((math.pi - 2) / (4 * math.pi), (math.pi + 2) / (4 * math.pi), 0.5)),
        (
            "{r: [0, R], phi: [0, pi/3]}",
            (0.25 - 3 * math.sqrt(3) / (8 * math.pi), 0.25 + 3 * math.sqrt(3) / (8 * math.pi), 0.5),
        ),
        ("{x: [0, R], y: [0, x^2/R]}", ((52 - math.sqrt(2249)) / 140, (52 + math.sqrt(2249)) / 140, 26 / 35)),
    ],
)
def test_a_factor_of_all_letters_does_not_hide_which_is_smaller(region: str, moments: tuple[float, ...]) -> None:
    """By hand, in M R²: of a sector of angle β about its corner (1 ∓ sin β/β)/4; of the piece under a parabola ∫ x² dm = 3/5,
    ∫ y² dm = 1/7 and ∫ x y dm = 1/4."""
    scene = f"up: z\ngravity: none\ngiven: {{M: kg, R: m}}\nbodies: {{{LAMINA.format(region)}}}\n"
    found = solve(scene + "find: {P: p.principal_moments about p.O, e: p.principal_axis.2 about p.O}\n")
    formulas = [part.formula for part in found.derivation.answers[0].components]
    told = solve(scene.replace("kg, R: m", "1 kg, R: 1 m") + "find: {P: p.principal_moments about p.O}\n")
    assert numbers(told, "P") == pytest.approx(moments, rel=1e-9)
    assert None not in formulas and all(item.holds for item in found.derivation.confirmed)
