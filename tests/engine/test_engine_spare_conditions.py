"""No condition is told that always holds or follows from the others, and no answer twice with two that together say nothing."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Number
from rotsolve.pipeline import solve

SPRING = """
title: A block on a spring on a slope
given: {m: kg, k: N/m, d: m, beta: rad}
surfaces: {ramp: {slope: beta, down: right}}
bodies: {b: {mass: m, moves: down}}
connections: {c: {contact: [b, ramp]}, s: {spring: [ground, b], stiffness: k}}
states: {start: {s.elongation: -d, at rest: all}, low: {s.elongation: d}, far: {b.velocity: 0}}
find: {v: b.velocity at low, x: s.elongation at far}
"""
CARPET = """
title: A carpet rolls out with a start speed
given: {M: kg, R: m, u: m/s, n: number}
surfaces: {floor: level}
bodies: {carpet: {shape: cylinder, mass: M, radius: R, moves: left}}
connections: {laid: {unrolls: [carpet, floor]}}
states: {start: {carpet.velocity: u}, later: {carpet.radius: R/n}}
find: {v: carpet.velocity at later, m: carpet.mass at later}
"""
CHAIN = """
title: A chain slides off a table with a block tied to it
given: {m: kg, L: m, b: m, M: kg}
surfaces: {table: level}
bodies: {rope: {shape: rope, mass: m, length: L}, q: {mass: M, moves: down}}
connections: {over: {drapes: [rope, table, q]}}
states: {start: {over.length: b, at rest: all}, off: {over.length: L}}
find: {a: rope.acceleration at start, t: time from start to off}
"""
LOADS = """
title: Two loads on a string that runs
given: {m: kg, M: kg, u: m/s, h: m, I: kg m^2, R: m}
bodies: {a: {mass: m, moves: down}, b: {mass: M, moves: up}, d: {inertia: I, radius: R}}
connections: {ax: {axle: d}, s: {string: [a, d, b]}}
states: {start: {a.velocity: u}, z: {a.displacement: h}}
find: {t: time from start to z, v: a.velocity at z, T: s.a.tension at start}
"""
COUPLE = """
title: A rod that falls with a couple, by which of both more
given: {M: kg, L: m, Q: N m, p: rad}
bodies: {r: {shape: rod, mass: M, length: L}}
connections: {h: {hinge: r.start}}
actions: {c: {couple: Q, on: r, direction: clockwise}}
states: {s0: {r.angle: p, at rest: all}, s1: {r.angle: -p}}
find:
  w: r.angular_velocity at s1
  more: {which of: {couple: size of c.work from s0 to s1, weight: size of r.work.gravity from s0 to s1}, is: largest}
"""
RIMS = """
title: Which point is faster than a bound, and which the slowest
given: {R: m, r: m, w: rad/s, v0: m/s}
gravity: none
bodies: {d: {shape: disc, mass: 1 kg, radius: R, points: {P: [r, 0], Q: [0, R]}}}
connections: {ax: {axle: d}}
states: {s: {d.angular_velocity: w}}
find:
  o: {which of: {P: d.P.speed at s, Q: d.Q.speed at s}, is: above v0}
  lo: {which of: {P: d.P.speed at s, Q: d.Q.speed at s}, is: smallest}
"""
TOLD = {  # the number of conditions that each answer has, one number a case
    "a size between bars": (SPRING, {"v": [0], "x": [0]}),
    "what one letter decides": (CARPET, {"v": [1], "m": [1]}),
    "a root of what one letter decides": (CHAIN, {"a": [1], "t": [1]}),
    "a formula that has no value between": (LOADS, {"t": [1, 2], "v": [1], "T": [0]}),
    "an angle and its sine": (COUPLE, {"w": [0], "more": [1, 1, 1]}),
    "two conditions together": (RIMS, {"o": [2, 2, 2, 2], "lo": [1, 1, 1]}),
}


@pytest.mark.sampled(4)
@pytest.mark.parametrize("kind", TOLD)
def test_as_few_conditions_as_say_the_same(kind: str) -> None:
    text, expected = TOLD[kind]
    answers = solve(text, confirm=False).derivation.answers
    found = {one.name: sorted(len(case.conditions) for case in (one, *one.otherwise)) for one in answers}
    assert found == expected


def test_where_a_formula_has_no_value_that_is_said() -> None:
    """t = (v - u)/a has none where the loads are the same, though it is h/u there."""
    assert any(check.words[0] == "if M = m no answer is given for " for check in solve(LOADS, confirm=False).checks)


def reaches(w: dict[str, float]) -> bool:
    pull, inertia = (w["m"] - w["M"]) * 9.8, w["m"] + w["M"] + w["I"] / w["R"] ** 2
    return w["u"] ** 2 + 2 * w["h"] * pull / inertia > 0


TRUE = {  # the scene, its answer, and where that holds by hand
    "loads": (LOADS, "v", reaches),
    "time of loads": (LOADS, "t", lambda w: reaches(w) and w["m"] != w["M"]),
    "tension of loads": (LOADS, "T", lambda w: True),
    "carpet": (CARPET, "v", lambda w: w["n"] > 1),
    "chain": (CHAIN, "t", lambda w: w["L"] > w["b"]),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("kind", TRUE)
def test_what_is_left_says_where_an_answer_holds(kind: str) -> None:
    text, name, holds = TRUE[kind]
    solution = solve(text, confirm=False)
    answer = next(one for one in solution.derivation.answers if one.name == name)
    signs = {">": (1,), "≥": (0, 1), "<": (-1,), "≤": (-1, 0)}
    chance, seen = random.Random(kind), set()
    names = [given.name for given in solution.problem.givens if given.value is None]
    for _ in range(300):
        sizes = {letter: chance.choice((0.25, 0.5, 1.0, 2.0, 4.0)) for letter in names}
        values = {letter: Number(Fraction(size)) for letter, size in sizes.items()} | {"g": Number(Fraction(49, 5))}
        told = any(
            all(
                (evaluate(line.left - line.right, values).sign or 0) in signs[line.relation] for line in case.conditions
            )
            for case in (answer, *answer.otherwise)
        )
        assert told == holds(sizes), sizes
        seen.add(told)
    assert True in seen


def test_a_time_that_is_an_integral_of_a_root_passes_where_its_ends_are_in_order() -> None:
    """A couple Q (1 − φ/b) against the friction τ: fastest at φ = b (Q − τ)/Q, which tells all, and at rest again at twice that."""
    found = solve(
        """title: Couple that fades with the turn, against a brake
given: {I: kg m^2, Q: N m, b: rad, tau: N m}
gravity: none
bodies: {wheel: {inertia: I, turns: clockwise}}
connections: {axle: {axle: wheel, friction_torque: tau}}
actions: {motor: {couple: "Q*(1 - wheel.rotation/b)", on: wheel}}
states: {start: at rest, fast: {wheel.angular_velocity: largest}, far: {wheel.angular_velocity: 0}}
find: {w: wheel.angular_velocity at fast, t1: time from start to fast, theta: wheel.rotation from start to far}
""",
        confirm=False,
    )
    assert found.answers["t1"].conditions == ("Q > τ",)
    for name in ("w", "theta"):
        assert [branch.conditions for branch in found.answers[name].branches] == [("Q > τ",), ("Q ≤ τ",)]
