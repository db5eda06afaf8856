"""Grounds of laws in space: what stands in brackets beside a law is true, and the law follows from it."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.normal import coefficients, is_zero
from rotsolve.algebra.formula import ZERO, Formula, Number, Symbol
from rotsolve.core.derivation import LawLine
from rotsolve.page.text import plain_text
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

WITHOUT = "between two tilts without nutation"
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


def number(formula: Formula, values: dict[str, float]) -> float:
    """The number of a formula for given letters."""
    exact = {name: Number(Fraction(value)) for name, value in values.items()}
    return evaluate(formula.substitute(exact), {}).float


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
    assert len(polynomials) == 1 and len([remark for remark in grounds if "λ" in plain_text(remark)]) == 1
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
    assert (
        len(axes) == 1 and axes[0].remark[0] == "λ = " and plain_text(axes[0].remark).endswith("the same for I_y, I_z")
    )


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


# from one end of a nutation to the other

NODDING = """
up: z
given: {{M: 2 kg, l: 0.5 m, I_1: 1 kg m^2, I_3: 0.4 kg m^2, theta: {tilt}, w: 20 rad/s, p: 0.2 rad/s}}
bodies: {{top: {{mass: M, inertia: {{principal: [I_1, I_1, I_3], about: tip}}, points: {{tip: [0, 0, -l]}}, axis: z}}}}
connections: {{pin: {{ball: top.tip}}}}
states:
  start: {{top.tilt: {told}, top.axial_rate: w, top.precession: {rate}, top.nutation: 0}}
  far: {{top.tilt: {end}}}
find: {{theta_1: top.tilt at far}}
"""


@pytest.mark.parametrize(("end", "rate"), [("largest", "0"), ("largest", "p"), ("largest", "-p"), ("smallest", "10*p")])
@pytest.mark.parametrize(("tilt", "told"), [("40 deg", "theta"), ("120 deg", "theta"), ("1 rad", "90 deg")])
@pytest.mark.parametrize("law", [None, "lagrange"])
def test_energy_and_angular_momentum_at_both_tilts_give_the_equation_for_them(
    end: str, rate: str, tilt: str, told: str, law: str | None
) -> None:
    derivation = solve(NODDING.format(end=end, rate=rate, tilt=tilt, told=told), law=law).derivation
    section = next(one for one in derivation.sections if any(WITHOUT in line.law for line in one.laws))
    (line,) = (line for line in section.laws if WITHOUT in line.law)
    energy, momentum, spin, _ = section.remarks[-4:]
    assert spin == ("I₃ ω₃ stays",)
    assert energy[0] == "energy" and momentum[0] == "angular momentum about the vertical: "
    omega, *energies = (part for part in energy if isinstance(part, Formula))
    momenta = [part for part in momentum if isinstance(part, Formula)]
    assert isinstance(omega, Symbol)
    c, b = coefficients(momenta[0] - momenta[1], omega.name) or (ZERO, ZERO)
    by_momentum = (energies[0] - energies[1]).substitute({omega.name: -c / b})
    values = {"M": 2, "l": 0.5, "I_1": 1, "I_3": 0.4, "w": 20, "p": 0.2, "g": 9.81, "theta": 0.7, "theta_1": 0.9}
    first = values["theta"] if told == "theta" else math.pi / 2
    gap = (math.cos(first) - math.cos(values["theta_1"])) / (2 * values["I_1"] * math.sin(values["theta_1"]) ** 2)
    left, right, whole = (number(part, values) for part in (line.equation.left, line.equation.right, by_momentum))
    assert whole == pytest.approx(gap * (left - right), rel=1e-9) and abs(whole) > 1e-3
