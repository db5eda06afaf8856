"""Questions with a condition: one more equation, and extrema over a letter, inside its range and at the ends of it."""

from __future__ import annotations

import pytest

from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.notation.parse import parse
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

BAR = """
title: Bar with a load at its end
given: {{M: {M}, m: {m}, L: {L}, x: {x}}}
bodies: {{bar: {{shape: rod, mass: M, length: L}}, load: {{mass: m}}}}
connections: {{joint: {{weld: [bar.end, load]}}}}
find: {find}
"""
NUMBERS = {"M": "2 kg", "m": "1 kg", "L": "90 cm"}
LETTERS = {"M": "kg", "m": "kg", "L": "m"}


def bar(find: str, *, x: str = "m", letters: dict[str, str] = NUMBERS) -> Solution:
    return solve(BAR.format(find=find, x=x, **letters))


def same(solution: Solution, name: str, expected: str) -> bool:
    formula = solution.answers[name].formula
    names = {"M", "m", "L", "x"}
    return formula is not None and equal(formula, parse(expected, names), frozenset(names))


@pytest.mark.parametrize("letters", [NUMBERS, LETTERS])
def test_the_least_inertia_is_about_the_common_centre_of_mass(letters: dict[str, str]) -> None:
    find = "{I: inertia about bar.at(x), y: x where I is smallest, low: smallest I}"
    solution = bar(find, letters=letters)
    assert same(solution, "y", "L*(M + 2*m)/(2*(M + m))")
    assert same(solution, "low", "M*L^2/12 + M*m/(M + m)*L^2/4")


def test_an_unknown_letter_takes_the_place_and_the_quantity_its_value_there() -> None:
    find = "{x: x where inertia about bar.at(x) is smallest, low: smallest inertia about bar.at(x), I: inertia about bar.at(x)}"
    solution = bar(find, x="unknown")
    assert same(solution, "x", "L*(M + 2*m)/(2*(M + m))")
    for name in ("low", "I"):
        assert same(solution, name, "M*L^2/12 + M*m/(M + m)*L^2/4")


def test_the_largest_value_is_found_at_an_end_of_the_range() -> None:
    solution = bar("{y: x where inertia about bar.at(x) is largest, high: largest inertia about bar.at(x)}")
    assert same(solution, "y", "0") and same(solution, "high", "M*L^2/3 + m*L^2")
    assert "an end of the range" in solution.to("text")


def test_which_end_is_further_depends_on_letters() -> None:
    answer = solve(
        """
title: Bar between two loads
given: {M: kg, m1: kg, m2: kg, L: m, x: m}
bodies: {bar: {shape: rod, mass: M, length: L}, one: {mass: m1}, two: {mass: m2}}
connections: {a: {weld: [bar.end, one]}, b: {weld: [bar.start, two]}}
find: {y: x where inertia about bar.at(x) is largest}
"""
    ).answers["y"]
    told = {(case.exact, *case.conditions) for case in (answer, *answer.otherwise)}
    assert told == {("L", "m₁ < m₂"), ("0", "m₁ > m₂")}  # alike at both ends where m₁ = m₂


def test_an_angle_is_sought_over_a_full_turn() -> None:
    solution = solve(
        """
title: Torque of the weight on a hinged bar
given: {M: 2 kg, L: 90 cm, theta: rad}
bodies: {bar: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: bar.start}}
states: {now: {bar.angle: theta, at rest: all}}
find:
  most: theta where bar.torque.gravity is largest
  least: theta where bar.torque.gravity is smallest
"""
    )
    assert solution.answers["most"].float == pytest.approx(3.141592653589793)
    assert solution.answers["least"].float == pytest.approx(0)


def test_a_condition_is_printed_with_the_laws() -> None:
    text = solve(
        """
title: Push that lifts the front of a bar off its prop
given: {M: 2 kg, L: 90 cm, F: unknown}
bodies: {bar: {shape: rod, mass: M, length: L}}
surfaces: {floor: level}
connections: {prop: {hinge: bar.start}, end: {contact: [bar.end, floor]}}
actions: {lift: {force: F, on: bar.at(2*L/3), direction: up}}
states: {now: {bar.angle: 0, balance: true}}
find: {F: F where end.normal_force = 0}
"""
    ).to("text")
    assert "the condition, normal force of end" in text and "F = ¾ M g" in text


@pytest.mark.parametrize(("start", "spin", "reached"), [("150 deg", "-4", 114.747), ("30 deg", "4", 65.253)])
def test_of_two_angles_the_first_on_the_way_is_meant(start: str, spin: str, reached: float) -> None:
    solution = solve(
        f"""
title: Rod swung up to where it is slow
given: {{M: 2 kg, L: 1 m, theta: unknown, w: {spin} rad/s, u: {spin}/2 rad/s}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{pin: {{hinge: rod.start}}}}
states: {{low: {{rod.angle: {start}, rod.angular_velocity: w}}, high: {{rod.angle: theta}}}}
find: {{theta: theta where rod.angular_velocity = u at high in deg}}
"""
    )
    assert solution.answers["theta"].float == pytest.approx(reached, abs=0.01)


HINGED = """
title: Rod let go from level, hinged at x
given: {{M: {M}, L: {L}, x: m}}
bodies: {{bar: {{shape: rod, mass: M, length: L}}}}
connections: {{pin: {{hinge: bar.at(x)}}}}
states: {{s: {{bar.angle: 0, at rest: all}}}}
find: {{a: size of bar.end.acceleration at s, al: size of bar.angular_acceleration at s, {find}}}
"""


@pytest.mark.parametrize("letters", [NUMBERS, LETTERS])
def test_a_size_has_an_extremum_where_its_square_has_one(letters: dict[str, str]) -> None:
    solution = solve(
        HINGED.format(find="y: x where a is largest", **letters)
    )  # 3 g |2 x − L| (L − x)/(2 (L² − 3 L x + 3 x²)) falls
    assert same(solution, "y", "0")
    assert solution.derivation.confirmed and not solution.derivation.refused


def test_one_of_two_places_that_are_as_good_is_no_answer() -> None:
    solution = solve(HINGED.format(find="y: x where al is largest", **LETTERS))
    assert [item.name for item in solution.derivation.refused] == ["y"]
    assert "at more than one `x`" in solution.derivation.refused[0].fault.message


def test_a_question_without_an_answer_says_why_with_those_that_it_names() -> None:
    solution = solve(HINGED.format(find="y: x where al is smallest, m: bar.mass, z: x where m is largest", **LETTERS))
    assert same(solution, "y", "L/2")
    assert "does not depend on `x`" in solution.derivation.refused[0].fault.message


@pytest.mark.sampled(3)
@pytest.mark.parametrize("word", ["largest", "smallest"])
@pytest.mark.parametrize("given", ["M: kg, L: m, m: kg, u: m/s", "M: 3 kg, L: 1 m, m: 2 kg, u: 3 m/s"])
def test_a_letter_that_is_sought_has_its_value_in_an_extreme_too(given: str, word: str) -> None:
    """The largest value is that at the place where it is largest; with the letter settled by that, nothing else is smallest over it."""
    scene = f"""
title: Putty that sticks to a rod
given: {{{given}, x: unknown}}
plane: horizontal
bodies: {{r: {{shape: rod, mass: M, length: L}}, q: {{mass: m, moves: up}}}}
connections: {{h: {{hinge: r.start}}}}
states: {{s0: {{r.angle: 0, at rest: r, q.velocity: u}}, s1: {{}}}}
events: {{hit: {{joins: [q, r.at(x)], from: s0, to: s1}}}}
find: {{x: x where r.angular_velocity is largest at s1, w: {word} r.angular_velocity at s1}}
"""
    solution = solve(scene)
    assert list(solution.answers) == (["x", "w"] if word == "largest" else ["x"])
    plain = solve(scene.replace(f"w: {word} ", "w: ")).answers
    assert list(plain) == ["x", "w"]
    if word == "largest":
        assert solution.answers["w"].formula == plain["w"].formula
    else:
        (why,) = (str(refused) for refused in solution.refused.values())
        assert f"no time passes in which `angular_velocity` could be {word}" in why


PIVOTED = """
title: Rod that swings down, with a lump at its start, about a pin that may be anywhere
given: {{M: {M}, m: {m}, L: {L}, x: {x}}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}, lump: {{mass: m}}}}
connections: {{pin: {{hinge: rod.at(x)}}, joint: {{weld: [rod.start, lump]}}}}
states: {{begin: {{rod.angle: 0, at rest: all}}, low: {{rod.angle: 90 deg}}}}
find: {{y: x where rod.angular_velocity is largest at low}}
"""


@pytest.mark.sampled(3)
@pytest.mark.parametrize("x", ["m", "unknown"])
@pytest.mark.parametrize("letters", [NUMBERS, LETTERS])
def test_what_is_not_real_beyond_a_place_ceases_there(letters: dict[str, str], x: str) -> None:
    """ω² is negative up to the centre of mass, x = M L/(2 (M + m)), where the rod does not come up: as good an end as that of the rod.

    ω² = 2 g ((M + m) x − ½ M L)/(M (L²/12 + (x − L/2)²) + m x²); a sought x told by ω(x) is not put into itself.
    """
    text = PIVOTED.format(x=x, **letters)
    solution = solve(text.replace("y: x", "x: x") if x == "unknown" else text)
    assert same(solution, "x" if x == "unknown" else "y", "L*(3*M + sqrt(3*M*(M + 4*m)))/(6*(M + m))")
    assert "ω = 0 at x = " in solution.to("text", width=400)


@pytest.mark.parametrize("letters", [NUMBERS, LETTERS])
def test_what_vanishes_where_it_ceases_has_no_smallest_value(letters: dict[str, str]) -> None:
    """About its centre of mass the rod does not swing down at all."""
    with pytest.raises(Unsolvable, match="where it vanishes and ceases to be real"):
        solve(PIVOTED.format(x="m", **letters).replace("largest", "smallest"))
