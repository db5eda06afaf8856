"""Principal moments where no axis of the body is one: where det (I − λ 1) has a factor, by an axis of symmetry, as of two plates at an
edge, and where it has none.

Trace, sum of principal minors and determinant tell whether three numbers are the moments of a tensor; all answers by the assembly too,
which turns tensors in numbers (Jacobi).
"""

from __future__ import annotations

import math

import numpy
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


PLACES = (("m", (1, 1, 0)), ("3*m", (0, 2, 1)), ("2*m", (2, 0, 3)), ("m", (0, -1, 4)))  # in a/2


def of_places() -> str:
    return of_points(*((mass, "[" + ", ".join(f"{part}*a/2" for part in place) + "]") for mass, place in PLACES))


@pytest.mark.parametrize("point", ["", " about b.O"])
def test_a_cubic_without_a_factor_by_its_angle(point: str) -> None:
    """Against the eigenvalues of the tensor that the masses have (NumPy); the same in letters."""
    parts = of_places()
    masses = numpy.array([2.0 * float(mass[:-2] or 1) if "*" in mass else 2.0 for mass, _ in PLACES])
    places = numpy.array([place for _, place in PLACES]) * 0.15
    places = places if point else places - masses @ places / sum(masses)
    tensor = sum(m * (r @ r * numpy.eye(3) - numpy.outer(r, r)) for m, r in zip(masses, places, strict=True))
    find = f"P: b.principal_moments{point}"
    found = solution(parts, find, NUMBERS)
    moments = [part.float for part in found.answers["P"].components.values()]
    assert moments == pytest.approx(list(numpy.linalg.eigvalsh(tensor)), rel=1e-12)
    assert confirmed(found) and confirmed(solution(parts, find))


def test_equal_moments_that_no_letter_shows_are_refused_by_name() -> None:
    """A cylinder and a sphere as one body, turned askew: the cubic has a double root, of which no digit of the angle is certain."""
    turned = "turned: [{about: [1, 2, 3], by: 77 deg}, {about: x, by: 11 deg}]"
    parts = f"c: {{shape: cylinder, mass: m, radius: a, length: 3*a, at: [0, 0, 0], {turned}}}"
    parts += ", s: {shape: sphere, mass: m, radius: a, at: [0, 0, 0]}"
    with pytest.raises(Unsolvable, match="two principal moments of `b` are equal"):
        solution(parts, "P: b.principal_moments", NUMBERS)


PLATE = """up: z
given: {M: 6 kg, a: 0.3 m, b: 0.4 m}
bodies: {t: {shape: triangle, mass: M, corners: [[0, 0], [a, 0], [0, b]]}}
find:
  e: t.principal_axis.1 about t.corner1
  f: t.principal_axis.2 about t.corner1
  h: t.principal_axis.3 about t.corner1
  x: t.principal_axis.1.x about t.corner1
  q: angle of t.x_axis from (t.principal_axis.1 about t.corner1)
"""


def test_each_of_three_moments_has_its_axis() -> None:
    """The tensor of a triangle about its right angle, M b²/6, M a²/6 and the product M a b/12; its axes by numpy."""
    rows = numpy.diag([0.16, 0.09, 0.25])
    rows[0, 1] = rows[1, 0] = -0.06
    _, axes = numpy.linalg.eigh(rows)
    found = solve(PLATE)
    for name, axis in zip("efh", axes.T, strict=True):
        own = numpy.array([part.float for part in found.answers[name].components.values()])
        assert abs(own @ axis) == pytest.approx(1)
    assert abs(found.answers["x"].float or 0) == pytest.approx(abs(axes[0, 0]))
    assert found.answers["q"].float == pytest.approx(math.acos(abs(axes[0, 0])))  # an axis has no sense
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize("number", [1, 2])
def test_two_equal_moments_have_no_axes_of_their_own(number: int) -> None:
    scene = (
        f"up: z\nbodies: {{d: {{shape: disc, mass: 2 kg, radius: 0.1 m}}}}\nfind: {{e: d.principal_axis.{number}}}\n"
    )
    with pytest.raises(Unsolvable, match="two principal moments are equal, and all lines in a plane are axes"):
        solve(scene)
    assert solve(scene.replace(f"axis.{number}", "axis.3")).answers["e"].components["z"].float == 1


def test_the_moments_of_a_sheared_plate_with_corners_in_numbers() -> None:
    """By hand: a parallelogram along u and v has ∫ r rᵀ dm = M (u uᵀ + v vᵀ)/12, here I_xx = 4/3, I_yy = 10/3 and I_xy = −2/3 kg m²."""
    from math import sqrt

    from rotsolve import solve

    text = """up: z
given: {M: 4 kg}
bodies: {plate: {shape: polygon, mass: M, corners: [[0 m, 0 m], [3 m, 0 m], [4 m, 2 m], [1 m, 2 m]]}}
find: {Ip: plate.principal_moments}
"""
    (answer,) = solve(text).derivation.answers
    numbers = [part.value.float for part in answer.components if part.value is not None]
    middle, half = 7 / 3, sqrt(13) / 3
    assert all(abs(a - b) < 1e-9 for a, b in zip(numbers, (middle - half, middle + half, 14 / 3), strict=True))


QUADRILATERAL = ((-0.5, -1.2), (-2.1, -1.7), (-4.0, -2.6), (-1.5, -5.5))
MAST, LUMP = ((0.15, 1.1, 0.0), (1.72, -0.79, -0.5)), (0.2, -0.3, 0.7)
CORNERS = ", ".join(f"[{x} m, {y} m]" for x, y in QUADRILATERAL)
DRAWN = {
    "a plate": f"{{shape: polygon, mass: 2 kg, corners: [{CORNERS}], points: {{O: [0 m, 0 m, 0 m]}}}}",
    "a composite": (
        f"{{parts: {{s: {{shape: polygon, mass: 2 kg, corners: [{CORNERS}], at: [0, 0, 0]}}, "
        "r: {shape: rod, mass: 3 kg, start: [0.15 m, 1.1 m, 0 m], end: [1.72 m, -0.79 m, -0.5 m]}, "
        "p: {shape: particle, mass: 4 kg, at: [0.2 m, -0.3 m, 0.7 m]}}, points: {O: [0, 0, 0]}}"
    ),
}


def second_moments(case: str, about_origin: bool) -> numpy.ndarray:
    """∫ r rᵀ dm of a plate of triangles, a rod and a particle."""
    whole, first, mass, area = numpy.zeros((3, 3)), numpy.zeros(3), 2.0, 0.0
    for p, q in zip(QUADRILATERAL, (*QUADRILATERAL[1:], QUADRILATERAL[0]), strict=True):
        one, two = numpy.array([*p, 0.0]), numpy.array([*q, 0.0])
        part = (p[0] * q[1] - q[0] * p[1]) / 2
        both = one + two
        whole += part / 12 * (numpy.outer(one, one) + numpy.outer(two, two) + numpy.outer(both, both))
        first, area = first + part * both / 3, area + part
    whole, first = 2 / area * whole, 2 / area * first
    if case == "a composite":
        start, end, lump = numpy.array(MAST[0]), numpy.array(MAST[1]), numpy.array(LUMP)
        middle, half = (start + end) / 2, (end - start) / 2
        whole = whole + 3 * (numpy.outer(middle, middle) + numpy.outer(half, half) / 3) + 4 * numpy.outer(lump, lump)
        first, mass = first + 3 * middle + 4 * lump, 9.0
    return whole if about_origin else whole - numpy.outer(first, first) / mass


@pytest.mark.parametrize("about", ["", " about b.O"])
@pytest.mark.parametrize("case", DRAWN)
def test_axes_of_what_is_drawn_by_numbers_on_a_page_of_one_leaf(case: str, about: str) -> None:
    second = second_moments(case, bool(about))
    moments, axes = numpy.linalg.eigh(numpy.trace(second) * numpy.eye(3) - second)
    asked = ", ".join(f"e{k}: b.principal_axis.{k}{about}" for k in (1, 2, 3))
    found = solve(f"up: z\nbodies: {{b: {DRAWN[case]}}}\nfind: {{P: b.principal_moments{about}, {asked}}}\n")
    told = [part.float for part in found.answers["P"].components.values()]
    assert told == pytest.approx(list(moments), rel=1e-12)
    for k in (1, 2, 3):
        own = numpy.array([part.float for part in found.answers[f"e{k}"].components.values()])
        assert abs(own @ axes[:, k - 1]) == pytest.approx(1, abs=1e-12)
    assert all(item.holds for item in found.derivation.confirmed)
    assert len(str(found).splitlines()) < 150


def test_axes_across_one_that_shows_go_by_tan_2_alpha() -> None:
    found = solve(PLATE)
    assert "tan 2α = 2 I_xy/(I_x − I_y)" in str(found)
    answer = next(one for one in found.derivation.answers if one.name == "e")
    assert all(part.formula is not None and not part.formula.holds("sqrt") for part in answer.components)
