"""What laws and questions in space are called: a label says what stands beside it, and no more."""

from __future__ import annotations

import math

import pytest

from rotsolve.algebra.formula import Call, Power, Product, Symbol
from rotsolve.core.derivation import LawLine
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

TOP = """
up: z
given: {{I_1: 5 kg m^2, I_3: 1 kg m^2, M: 3 kg, l: 1 m, w: 4 rad/s}}
bodies: {{top: {{mass: M, inertia: {{principal: [I_1, I_1, I_3], about: tip}}, points: {{tip: [0, 0, -l]}}, axis: z}}}}
connections: {{pin: {{ball: top.tip}}}}
states: {{now: {{top.tilt: 60 deg, top.precession: 2 rad/s, top.nutation: 0 rad/s, top.spin: w}}}}
find: {{{find}}}
"""
FREE = """
up: z
given: {{a: 2 m, b: 1 m, M: 3 kg, w: 4 rad/s, v: 2 m/s}}
bodies: {{box: {{shape: cuboid, mass: M, sides: {sides}}}}}
states: {{now: {{box.angular_velocity: {turning}, box.velocity: {going}}}}}
find: {{{find}}}
"""


def law_lines(solution: Solution) -> list[LawLine]:
    return [line for section in solution.derivation.sections for line in section.laws]


def labels_in(scene: str, **parts: str) -> list[str]:
    return [line.law for line in law_lines(solve(scene.format(**parts)))]


def free(find: str, turning: str = "[w, w, 0]", going: str = "[0, 0, 0]", sides: str = "[a, a, a]") -> list[str]:
    return labels_in(FREE, find=find, turning=turning, going=going, sides=sides)


def find_line(solution: Solution) -> str:
    """What a page says to be asked."""
    return next(line for line in solution.to("text", width=1000).splitlines() if line.startswith("Find"))


# energies


@pytest.mark.parametrize(
    ("turning", "going", "find", "label"),
    [
        ("[w, w, 0]", "[v, 0, 0]", "box.kinetic_energy", "kinetic energy, ½ ω · I ω + ½ M v²"),
        ("[w, w, 0]", "[0, 0, 0]", "box.kinetic_energy", "kinetic energy, ½ ω · I ω"),
        ("[0, 0, 0]", "[v, 0, 0]", "box.kinetic_energy", "kinetic energy, ½ M v²"),
        ("[w, w, 0]", "[v, 0, 0]", "box.kinetic_energy.rotational", "kinetic energy, ½ ω · I ω"),
        ("[w, w, 0]", "[v, 0, 0]", "box.kinetic_energy.translational", "kinetic energy, ½ M v²"),
        ("[w, w, 0]", "[v, 0, 0]", "kinetic_energy", "kinetic energy, ½ ω · I ω + ½ M v²"),
    ],
)
def test_an_energy_is_called_by_the_terms_that_it_has(turning: str, going: str, find: str, label: str) -> None:
    assert label in free(f"K: {find}", turning, going)


def test_about_a_point_at_rest_all_of_the_energy_is_rotation() -> None:
    assert "kinetic energy about its tip, ½ ω · I ω" in labels_in(TOP, find="K: top.kinetic_energy")
    assert "energy, ½ ω · I ω + M g h" in labels_in(TOP, find="E: top.energy")


# shapes


def test_only_a_cuboid_of_equal_sides_is_a_cube_and_the_same_about_all_axes() -> None:
    find = "I: box.inertia_tensor.yy"
    assert "moment of inertia, cube about any axis through its centre" in free(find)
    assert "moment of inertia, cuboid about its y axis" in free(find, sides="[a, b, a]")


# bearings

SHAFT = """
up: z
given: {{M: 4 kg, R: 0.3 m, b: 0.5 m, w: 20 rad/s, e: 2 mm}}
bodies: {{wheel: {{shape: disc, mass: M, radius: R, turned: {{about: y, by: 5 deg}}}}}}
connections: {{shaft: {{hinge: wheel, along: z, bearings: [-b, b], angular_velocity: w}}}}
states: {{now: {{wheel.angle: 0 deg}}}}
find: {{{find}}}
"""


def test_the_force_of_one_bearing_names_it_and_that_of_both_names_the_hinge() -> None:
    one, both = (solve(SHAFT.format(find=f"F: {asked}")) for asked in ("shaft.bearing2.force", "size of shaft.force"))
    assert "of the shaft's bearing 2" in find_line(one) and "bearing" not in find_line(both)
    assert any(line.law.startswith("force of the shaft's bearing 2") for line in law_lines(one))
    assert not any("bearing" in line.law for line in law_lines(both))
    assert "Lager 2 von shaft" in one.to("text", language="de")


# questions under a condition

CONDITIONAL = """
given: {{m: 2 kg, M: unknown, R: 0.2 m, A: 2 m/s^2}}
bodies: {{block: {{mass: m, moves: down}}, disc: {{shape: disc, mass: M, radius: R, turns: clockwise}}}}
connections: {{axle: {{axle: disc}}, string: {{string: [disc, block]}}}}
find: {{{find}}}
"""


@pytest.mark.parametrize(
    ("find", "said"),
    [
        ("M: M where block.acceleration = A", "M for which the acceleration of block = A"),
        ("M_0: M where block.acceleration = 3 m/s^2", "value M₀ of M for which the acceleration of block = a_block"),
    ],
)
def test_what_is_asked_under_a_condition_is_said_with_it(find: str, said: str) -> None:
    assert said in find_line(solve(CONDITIONAL.format(find=find)))


# expressions

EARTH = """
up: z
given: {{I_1: 2 kg m^2, I_3: 3 kg m^2, w: 4 rad/s, q: 0.1 rad/s, M: 1 kg}}
bodies: {{earth: {{mass: M, inertia: {{principal: [I_1, I_1, I_3]}}, axis: z}}}}
states: {{now: {{earth.angular_velocity: [q, 0, w]}}}}
find: {{{find}}}
"""


def test_an_expression_of_one_quantity_keeps_its_law_as_the_label() -> None:
    (own,) = labels_in(EARTH, find="s: earth.spin")
    assert labels_in(EARTH, find="s: -2*earth.spin") == [own]
    assert labels_in(EARTH, find="s: earth.spin/earth.axial_rate") == ["ratio"]


def test_what_is_a_given_is_called_by_its_quantity() -> None:
    assert labels_in(EARTH, find="w_z: earth.angular_velocity.z in body axes")[-1] == "angular velocity of earth"


def test_an_expression_of_earlier_answers_is_said_with_its_letter() -> None:
    assert "s₂ = −s" in find_line(solve(EARTH.format(find="s: earth.spin, s_2: -s")))


# what is found is used

BOTH = (
    "L: size of earth.angular_momentum, p: earth.precession",
    "p: earth.precession, L: size of earth.angular_momentum",
)


@pytest.mark.parametrize("find", BOTH)
def test_the_rate_about_the_angular_momentum_is_told_by_its_letter(find: str) -> None:
    solution = solve(EARTH.format(find=find))
    told = {line.law: line.equation for line in law_lines(solution)}
    rate = told["its axis goes round its angular momentum, φ̇ = L/I₁"]
    assert rate.right.symbols() == {"L", "I_1"} and Symbol("L") == told["size of the angular momentum, earth"].left
    assert float(solution.answers["p"].value) == pytest.approx(math.hypot(2 * 0.1, 3 * 4) / 2, rel=1e-3)
    assert float(solution.answers["L"].value) == pytest.approx(math.hypot(2 * 0.1, 3 * 4), rel=1e-3)


def test_a_tilt_from_the_angular_momentum_is_told_by_its_letter_too() -> None:
    solution = solve(EARTH.format(find="a: earth.tilt in deg"))
    assert float(solution.answers["a"].value) == pytest.approx(math.degrees(math.atan2(0.2, 12)), rel=1e-3)
    assert any(line.law == "size of the angular momentum, earth" for line in law_lines(solution))


def test_what_turns_about_its_own_axis_alone_has_no_precession() -> None:
    scene = EARTH.format(find="p: earth.precession").replace("[q, 0, w]", "[0, 0, w]")
    with pytest.raises(Unsolvable, match="turns about its own axis alone"):
        solve(scene)


# products

TURNED = """
up: z
given: {{M: 4 kg, R: 0.3 m, a: 5 deg, w: 20 rad/s}}
bodies: {{wheel: {{parts: {{disc: {{shape: disc, mass: M, radius: R, at: [0, 0, 0], turned: {{about: y, by: a}}}}}}}}}}
states: {{now: {{wheel.angular_velocity: [0, 0, w]}}}}
find: {{{find}}}
"""


@pytest.mark.parametrize(
    "find", ["I: wheel.inertia_tensor.zx", "K: wheel.kinetic_energy.rotational", "x: wheel.x_axis.x*cos(a)*w"]
)
def test_functions_stand_behind_letters_and_sines_in_front_of_cosines(find: str) -> None:
    for line in law_lines(solve(TURNED.format(find=find))):
        nodes = (part for side in (line.equation.left, line.equation.right) for part in side.walk(Product))
        for node in (part for part in nodes if isinstance(part, Product)):
            bases = [part.base if isinstance(part, Power) else part for part in node.factors]
            places = [("sin", "cos").index(part.function) + 1 if isinstance(part, Call) else 0 for part in bases]
            assert places == sorted(places), node


def test_a_number_that_is_put_in_alone_is_not_repeated() -> None:
    page = solve(EARTH.format(find="s: earth.spin, s_2: -s")).to("text")
    assert "s₂ = −s = 2 rad/s" in page


def test_the_period_of_a_body_that_turns_about_a_principal_axis_says_what_it_is() -> None:
    text = """up: z
gravity: none
given: {A: 2 kg m^2, B: 3 kg m^2, w: 2 rad/s}
bodies: {one: {inertia: {principal: [1 kg m^2, A, B]}}}
states: {now: {one.angular_velocity: [w, 0, 0]}}
find: {T: one.period at now}
"""
    assert "period of the turn, since ω stays in the own axes, T = 2π/ω" in solve(text).to("text")
