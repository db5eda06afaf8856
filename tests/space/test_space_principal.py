"""Principal moments where no axis of the body is one, but det (I − λ 1) has a factor: an axis by symmetry, as of two plates at an edge.

Trace, sum of principal minors and determinant tell whether three numbers are the moments of a tensor; all answers by the assembly too,
which turns tensors in numbers (Jacobi).
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Solution, Unsolvable, solve

SCENE = "up: z\ngiven: {GIVEN}\nbodies: {b: {parts: {PARTS}, points: {O: [0, 0, 0]}}}\nfind: {FIND}\n"
LETTERS, NUMBERS = "m: kg, a: m", "m: 2 kg, a: 0.3 m"
PLATES = (
    "p1: {shape: rectangle, mass: m, sides: [a, a], at: [a/2, a/2, 0]}, "
    "p2: {shape: rectangle, mass: m, sides: [a, a], at: [a/2, 0, a/2], turned: {about: x, by: 90 deg}}"
)
POINTS = "{shape: particle, mass: MASS, at: PLACE}"


def of_points(*points: tuple[str, str]) -> str:
    parts = (POINTS.replace("MASS", mass).replace("PLACE", place) for mass, place in points)
    return ", ".join(f"p{number}: {part}" for number, part in enumerate(parts))


def solution(parts: str, find: str = "P: b.principal_moments about b.O", given: str = LETTERS) -> Solution:
    return solve(SCENE.replace("GIVEN", given).replace("PARTS", parts).replace("FIND", find))


def confirmed(found: Solution) -> bool:
    return [item.holds for item in found.derivation.confirmed] == [True]


SLANTED = (
    of_points(("m", "[a, 2*a, 2*a]"), ("m", "[-a, -2*a, -2*a]"))
    + ", s: {shape: sphere, mass: m, radius: a, at: [0, 0, 0]}"
)
CASES = {  # parts, and the moments about O in units of m a²
    "two plates at an edge": (PLATES, ((10 - math.sqrt(22)) / 12, 1.0, (10 + math.sqrt(22)) / 12)),
    "three masses": (
        of_points(("m", "[a, 0, 0]"), ("2*m", "[0, a, a]"), ("2*m", "[a, a, a]")),
        ((11 - math.sqrt(57)) / 2, (11 + math.sqrt(57)) / 2, 11.0),
    ),
    "a sphere with two masses on a slanted line": (SLANTED, (0.4, 18.4, 18.4)),
}


@pytest.mark.parametrize("case", CASES)
def test_an_axis_by_symmetry_leaves_a_quadratic(case: str) -> None:
    parts, moments = CASES[case]
    found = solution(parts, given=NUMBERS)
    parts_found = found.answers["P"].components.values()
    assert [float(part.value) for part in parts_found] == pytest.approx([0.18 * one for one in moments], rel=5e-4)
    assert confirmed(found) and confirmed(solution(parts))


def test_the_lone_axis_of_a_slanted_line() -> None:
    found = solution(SLANTED, "n: b.principal_axis")
    components = [abs(float(part.value)) for part in found.answers["n"].components.values()]
    assert components == pytest.approx([1 / 3, 2 / 3, 2 / 3], rel=5e-4)
    assert confirmed(found)


def test_letters_of_several_kinds() -> None:
    parts = of_points(("m", "[a, a, h]"), ("3*m", "[0, 0, h]"), ("m", "[-a, -a, 0]"))
    assert confirmed(solution(parts, given=f"{LETTERS}, h: m"))


def test_a_cubic_without_a_factor_is_refused_by_name() -> None:
    parts = of_points(("m", "[a, h, 0]"), ("3*m", "[0, a, h]"), ("2*m", "[a, 0, 2*h]"))
    with pytest.raises(Unsolvable, match="no closed form that shows"):
        solution(parts, given=f"{LETTERS}, h: m")
