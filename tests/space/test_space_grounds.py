"""Grounds of laws in space: what stands in brackets beside a law is true, and the law follows from it."""

from __future__ import annotations

import pytest

from rotsolve.algebra.exact.normal import coefficients, is_zero
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import LawLine
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

CUBE = "{shape: cuboid, mass: M, sides: [a, a, a], points: {O: [-a/2, -a/2, -a/2]}}"
PLATE = "{shape: rectangle, mass: M, sides: [a, b], points: {O: [-a/2, -b/2]}}"
TWO_PLATES = (
    "{parts: {one: {shape: rectangle, mass: M, sides: [a, a], at: [a/2, a/2, 0]}, "
    "two: {shape: rectangle, mass: M, sides: [a, a], at: [a/2, 0, a/2], turned: {about: x, by: 90 deg}}}, "
    "points: {O: [0, 0, 0]}}"
)
MOMENTS = """
up: z
given: {{M: 3 kg, a: 0.2 m, b: 0.3 m}}
bodies: {{body: {body}}}
find: {{I: body.principal_moments about body.O}}
"""


def law_lines_of(solution: Solution) -> list[LawLine]:
    return [line for section in solution.derivation.sections for line in section.laws]


def worked_out(formula: Formula, lines: list[LawLine]) -> Formula:
    """A formula with its letters put in that laws define."""
    told = {line.equation.left.name: line.equation.right for line in lines if isinstance(line.equation.left, Symbol)}
    while told.keys() & formula.symbols():
        formula = formula.substitute(told)
    return formula


# principal moments


@pytest.mark.parametrize("body", [CUBE, PLATE, TWO_PLATES])
def test_principal_moments_are_the_roots_of_the_polynomial_beside_them(body: str) -> None:
    solution = solve(MOMENTS.format(body=body))
    lines = law_lines_of(solution)
    grounds = [line.remark for line in lines if line.law.startswith("principal moment")]
    polynomials = {part for remark in grounds for part in remark[:1] if isinstance(part, Formula)}
    assert len(polynomials) == 1 and len([remark for remark in grounds if remark]) == 1
    (polynomial,) = polynomials
    assert "lambda" in polynomial.symbols()
    whole = worked_out(polynomial, lines)
    moments = [part.formula for part in solution.derivation.answers[0].components]
    assert len(moments) == 3
    assert all(part is not None and is_zero(whole.substitute({"lambda": part})) for part in moments)


def test_a_diagonal_tensor_needs_no_polynomial() -> None:
    solution = solve(MOMENTS.format(body="{shape: cuboid, mass: M, sides: [a, a, b], points: {O: [0, 0, 0]}}"))
    assert not any(line.remark for line in law_lines_of(solution))


def test_a_principal_axis_is_said_to_be_one_and_of_which_moment() -> None:
    solution = solve(MOMENTS.format(body=CUBE).replace("principal_moments", "principal_axis"))
    axes = [line for line in law_lines_of(solution) if line.law.endswith("(I − λ 1) e = 0, |e| = 1")]
    assert len(axes) == 3 and axes[0].remark[0] == "λ = " and not any(line.remark for line in axes[1:])


# limits

LEANING = """
up: z
given: {M: 2 kg, l: 0.5 m, I_1: 1 kg m^2, I_3: 0.4 kg m^2, theta: 30 deg, w: unknown}
bodies: {top: {mass: M, inertia: {principal: [I_1, I_1, I_3], about: tip}, points: {tip: [0, 0, -l]}, axis: z}}
connections: {pin: {ball: top.tip}}
states: {now: {top.tilt: theta, top.axial_rate: w, steady: true}}
find: {w_s: smallest w where now is steady}
"""


def test_the_limit_of_steady_precession_is_where_the_quadratic_of_its_law_has_one_root() -> None:
    derivation = solve(LEANING).derivation
    (section,) = derivation.sections
    law, _, quadratic = section.remarks
    assert str(law[0]).startswith("τ = Ω × L, top about its tip, along e₁")
    sides = [part for part in law if isinstance(part, Formula)]
    rate, own, other = (part for part in quadratic if isinstance(part, Formula))
    assert isinstance(rate, Symbol)
    found = coefficients(sides[0] - sides[1], rate.name)
    assert found is not None and len(found) == 3
    c, b, a = found
    assert is_zero((b**2 - 4 * a * c) - (own - other)) or is_zero((b**2 - 4 * a * c) + (own - other))
    (line,) = section.laws
    assert is_zero(line.equation.left - own) and is_zero(line.equation.right - other)


def test_a_limit_that_is_one_law_has_a_plan() -> None:
    page = solve(LEANING).to("text", width=1000)
    assert "Plan    Steady precession of top by τ = Ω × L" in page
