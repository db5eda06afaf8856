"""Verges of states in balance that several frictions hold: conditions both ways, and a confirmation that tells sticking from slipping."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

import rotsolve
from margins import G, answered_just_where
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Number
from rotsolve.confirm.course.samples import holding

PLANK = """
title: Block on a pulled plank, held by a spring
given: {GIVEN}
surfaces: {floor: level, post: {wall: BACK}}
bodies: {plank: {mass: M, moves: WAY}, block: {mass: m, moves: WAY}}
connections:
  low: {contact: [plank, floor], friction: nu}
  high: {contact: [block, plank], friction: mu}
  coil: {spring: [post, block], stiffness: k}
actions: {pull: {force: F, on: plank, direction: WAY}}
states: {hold: {coil.elongation: x, balance: true}}
find: {x: largest x where high sticks}
"""
RAMP = """
title: Box on a ramp, held by a load over a wheel that rubs
given: {m: kg, beta: 30 deg, mu: number, Q: N m, R: 15 cm, M: unknown}
surfaces: {ramp: {slope: beta, down: WAY}}
bodies: {bob: {mass: M, moves: down}, drum: {inertia: 0.05 kg m^2, radius: R}, box: {mass: m, moves: up}}
connections:
  bed: {contact: [box, ramp], friction: mu}
  pin: {axle: drum, friction_torque: Q}
  rope: {string: [box, drum, bob]}
states: {hold: {balance: true}}
find: {M: smallest M where bed sticks}
"""
TABLE = """
title: Load over a wheel that rubs, and a block on a table that a spring holds back
given: {m: LOAD, M: LOWER, mu: 0.2, k: STIFF, Q: TORQUE, R: 10 cm, x: unknown}
surfaces: {table: level, side: {wall: BACK}}
bodies: {block: {mass: M, moves: WAY}, wheel: {inertia: 0.01 kg m^2, radius: R}, bob: {mass: m, moves: down}}
connections:
  base: {contact: [block, table], friction: mu}
  pin: {axle: wheel, friction_torque: Q}
  coil: {spring: [side, block], stiffness: k}
  cord: {string: [block, wheel, bob], pulls: {block: WAY}}
states: {hold: {coil.elongation: x, balance: true}}
find: {x: smallest x where base sticks}
"""
SIDES = {"right": "left", "left": "right"}


def to_the(way: str, text: str) -> str:
    return text.replace("WAY", way).replace("BACK", SIDES[way])


@pytest.mark.parametrize("way", SIDES)
def test_the_other_friction_holds_either_way(way: str) -> None:
    """x = μ m g/k while |F − μ m g| ≤ ν (m + M) g: both ways are conditions, in letters and with numbers for all but F."""
    text = to_the(way, PLANK)
    letters = text.replace("GIVEN", "m: kg, M: kg, k: N/m, mu: number, nu: number, F: N, x: unknown")
    answered_just_where(letters, lambda of: of["nu"] * (of["m"] + of["M"]) * G - abs(of["F"] - of["mu"] * of["m"] * G))
    numbers = text.replace("GIVEN", "m: 2 kg, M: 4 kg, k: 100 N/m, mu: 0.5, nu: 0.2, F: N, x: unknown")
    answer = rotsolve.solve(numbers).answers["x"].answer  # 9.8 N + 11.76 N
    known = {"m": 2.0, "M": 4.0, "k": 100.0, "mu": 0.5, "nu": 0.2, "g": G}
    told = {force: holding(answer, {**known, "F": force}) is not None for force in (5.0, 9.9, 15.0, 21.5, 21.6)}
    assert told == {5.0: True, 9.9: True, 15.0: True, 21.5: True, 21.6: False}


@pytest.mark.parametrize("way", SIDES)
def test_a_heavy_wheel_beside_a_light_box_is_told_apart(way: str) -> None:
    """M = m (sin β − μ cos β) − Q/(g R), however small it is beside the weight of the wheel."""
    (answer,) = rotsolve.solve(to_the(way, RAMP)).derivation.answers
    for mass, least in ((5.0, 5 * (0.5 - 0.2 * 0.75**0.5) - 1 / (G * 0.15)), (1.0, None)):
        numbers = {"m": mass, "mu": 0.2, "Q": 1.0, "g": G}
        case = holding(answer, {**numbers, "beta": 0.5235987755982988, "R": 0.15})
        assert (case is None) == (least is None)


@pytest.mark.parametrize("way", SIDES)
def test_where_it_slips_it_is_not_held_by_another_place(way: str) -> None:
    """k x = m g − Q/R − μ M g: a little less lets the block go to where it is held again, with a spring that is longer than x."""
    words = {"LOAD": "5 kg", "LOWER": "2 kg", "STIFF": "100 N/m", "TORQUE": "1 N m"}
    numbers = letters = to_the(way, TABLE)
    for word, value in words.items():
        numbers, letters = numbers.replace(word, value), letters.replace(word, value.split(" ", 1)[1])
    solution = rotsolve.solve(numbers)
    assert solution.answers["x"].float == pytest.approx((5 * G - 1 / 0.1 - 0.2 * 2 * G) / 100)
    assert [item.holds for item in solution.derivation.confirmed] == [True]
    assert [item.holds for item in rotsolve.solve(letters).derivation.confirmed] == [True]


LIFTED = """
title: Smallest friction for a crate that a slanted pull just lifts
given: {m: 50/49 kg, phi: 30 deg, mu: unknown}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: right}}
connections: {c: {contact: [crate, floor], friction: mu}}
actions: {p: {force: 20 N, on: crate, direction: phi}}
states: {q: {at rest: all}}
find: {mu0: smallest mu where c sticks, N: c.normal_force at q}
"""


def test_that_nothing_presses_at_a_verge_of_friction_is_said() -> None:
    """N = m g − ½ F is nothing: the verge that is asked for is one of friction, not of lifting."""
    solution = rotsolve.solve(LIFTED)
    assert any(
        "for c at q: the least change decides whether crate leaves" in "".join(map(str, check.words))
        for check in solution.checks
        if check.holds is None
    )


PULLED_UP = {
    "a spool by its thread": """
title: Spool pulled at an angle
given: {m: kg, k: m, R: m, F: N, phi: deg, mu: unknown}
surfaces: {floor: level}
bodies: {spool: {mass: m, gyration: k, radii: {rim: R}, points: {hub: [0, 0]}}}
connections: {touch: {contact: [spool.rim, floor], friction: mu}}
actions: {pull: {force: F, on: spool.hub, direction: AT}}
states: {start: {at rest: all}}
find: {mu: smallest mu where touch sticks, a: spool.acceleration at start, f: touch.friction_force at start}
""",
    "a crate": """
title: Crate pulled at an angle
given: {m: kg, F: 20 N, phi: 30 deg, mu: unknown}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: WAY}}
connections: {touch: {contact: [crate, floor], friction: mu}}
actions: {pull: {force: F, on: crate, direction: AT}}
states: {start: {at rest: all}}
find: {mu: smallest mu where touch sticks, N: touch.normal_force at start, f: touch.friction_force at start}
""",
}


@pytest.mark.parametrize("way", SIDES)
@pytest.mark.parametrize("text", PULLED_UP.values(), ids=PULLED_UP)
def test_where_nothing_presses_no_other_answer_holds_either(text: str, way: str) -> None:
    """μ = f/N has no value at N = 0, and what no μ holds does not stick there: no answer of sticking has that edge."""
    text = to_the(way, text).replace("AT", "phi" if way == "right" else "180 deg - phi")
    answers = rotsolve.solve(text).answers
    for answer in answers.values():
        assert len(answer.conditions) == 1
        assert not {"≤", "≥"} & set(answer.conditions[0])


ROOF = """
title: Two crates on the slopes of a roof, by a cord over its ridge
given: {m: kg, M: unknown, mu: number}
surfaces: {near: {slope: 25 deg, down: WAY}, far: {slope: 40 deg, down: BACK}}
bodies: {crate: {mass: m, moves: up}, box: {mass: M, moves: down}, wheel: {shape: disc, mass: 0, radius: 10 cm}}
connections:
  bed: {contact: [crate, near], friction: mu}
  seat: {contact: [box, far], friction: mu}
  axle: {axle: wheel}
  cord: {string: [crate, wheel, box]}
states: {hold: {balance: true}}
find: {M: largest M where bed sticks}
"""


@pytest.mark.sampled(2)
@pytest.mark.parametrize("way", SIDES)
def test_a_case_in_which_it_sticks_beyond_is_left_out_and_no_other(way: str) -> None:
    """M = m (sin 25° + μ cos 25°)/(sin 40° − μ cos 40°), from which on both slip; where μ > tan 40° no box pulls the crate up."""
    solution = rotsolve.solve(to_the(way, ROOF))
    answer = solution.answers["M"]
    near, far = math.radians(25), math.radians(40)
    held = 3.0 * (math.sin(near) + 0.3 * math.cos(near)) / (math.sin(far) - 0.3 * math.cos(far))
    assert answer.formula is not None
    numbers = {"m": Number(3), "mu": Number(Fraction(3, 10)), **solution.problem.values}
    assert evaluate(answer.formula, numbers).float == pytest.approx(held)
    assert answer.conditions == ("μ < tan θ_far",)
    assert not answer.otherwise
    assert any(
        "no answer is found: no value in closed form is found" in "".join(map(str, check.words))
        for check in solution.checks
    )


CORNER = """
title: Drum in the corner of a floor and a wall, turned by a couple
given: {m: 2 kg, R: 50 cm, mu: number, nu: number, Q: unknown}
surfaces: {floor: level, side: {wall: WAY}}
bodies: {drum: {shape: cylinder, mass: m, radius: R, turns: SENSE}}
connections: {low: {contact: [drum, floor], friction: mu}, high: {contact: [drum, side], friction: nu}}
actions: {motor: {couple: Q, on: drum}}
states: {hold: {balance: true}}
find: {Q: largest Q where low sticks}
"""


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("way", "sense"), [("right", "clockwise"), ("left", "counterclockwise")])
def test_what_is_jammed_has_no_verge(way: str, sense: str) -> None:
    """Q = μ m g R (1 + ν)/(1 + μ ν) up to μ = 1, from there to μ ν = 1 with −ν; beyond that any couple wedges the drum in.

    The forces lie between |f| ≤ μ N of both contacts: with N₂ = f₁, N₁ + f₂ = m g and Q = (f₁ + f₂) R that is a linear programme.
    """
    answer = rotsolve.solve(CORNER.replace("WAY", way).replace("SENSE", sense), confirm=False).derivation.answers[0]
    for mu, nu in ((0.3, 0.5), (0.7, 2.5), (0.95, 0.2), (1.4, 0.5), (3.0, 0.2)):
        case = holding(answer, {"m": 2.0, "R": 0.5, "g": G, "mu": mu, "nu": nu})
        sign = 1 if mu < 1 else -1
        assert case is not None and case.closed is not None
        found = evaluate(case.closed, {"m": Number(2), "R": Number(Fraction(1, 2)), **sized(g=G, mu=mu, nu=nu)}).float
        assert found == pytest.approx(mu * 2.0 * G * 0.5 * (1 + sign * nu) / (1 + sign * mu * nu))
    for mu, nu in ((1.2, 1.5), (2.0, 0.6)):
        assert holding(answer, {"m": 2.0, "R": 0.5, "g": G, "mu": mu, "nu": nu}) is None


def sized(**sizes: float) -> dict[str, Number]:
    return {name: Number(Fraction(str(size))) for name, size in sizes.items()}


ALIKE = """
title: Ladder that is as rough at both ends
given: {M: kg, L: m, theta: 50 deg, mu: unknown}
surfaces: {yard: level, house: {wall: WAY}}
bodies: {ladder: {shape: rod, mass: M, length: L}}
connections: {foot: {contact: [ladder.start, yard], friction: mu}, head: {contact: [ladder.end, house], friction: mu}}
states: {hold: {ladder.angle: AT, balance: true}}
find: {mu: smallest mu where foot sticks}
"""


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("way", "angle"), [("right", "theta"), ("left", "180 deg - theta")])
@pytest.mark.parametrize("numbers", ["M: kg, L: m", "M: 3 kg, L: 2 m"])
def test_one_coefficient_of_two_contacts_has_the_root_at_which_both_hold(way: str, angle: str, numbers: str) -> None:
    """μ = (1 − sin θ)/cos θ: both frictions hold the ladder; with that of the head the other way round there are two more roots."""
    text = ALIKE.replace("WAY", way).replace("AT", angle).replace("M: kg, L: m", numbers)
    solution = rotsolve.solve(text)
    assert solution.answers["mu"].float == pytest.approx((1 - math.sin(math.radians(50))) / math.cos(math.radians(50)))
    assert all(verdict.holds for verdict in solution.derivation.confirmed)


A_FRAME = """
title: Two rods that lean on each other
given: {m: 2 kg, M: 6 kg, L: 0.7 m, th: 60 deg, mu: unknown}
surfaces: {floor: level}
bodies: {a: {shape: rod, mass: m, length: L}, b: {shape: rod, mass: M, length: L}}
connections:
  C: {hinge: [a.end, b.end]}
  A: {contact: [a.start, floor], friction: mu}
  B: {contact: [b.start, floor], friction: mu}
states: {rest: {a.angle: th, b.angle: 180 deg - th, balance: true}}
find: {ASKED}
"""
LIGHT, HEAVY = "one: smallest mu where A sticks", "two: smallest mu where B sticks"


@pytest.mark.parametrize(
    ("asked", "fails"), [((LIGHT, HEAVY), True), ((HEAVY, LIGHT), True), ((HEAVY,), True), ((LIGHT,), False)]
)
def test_what_slips_at_one_of_several_verges_is_told_in_any_order(asked: tuple[str, ...], fails: bool) -> None:
    """The light rod's foot slips below μ = 0.385 already, the heavy one's at 0.231."""
    checks = rotsolve.solve(A_FRAME.replace("ASKED", ", ".join(asked))).checks
    assert any(check.holds is False for check in checks) == fails


def test_in_letters_a_verge_is_not_told_in_the_cases_of_another() -> None:
    """μ for A holds where M ≥ m, that for B where M ≤ m."""
    text = A_FRAME.replace("ASKED", f"{LIGHT}, {HEAVY}").replace("m: 2 kg, M: 6 kg", "m: kg, M: kg")
    found = rotsolve.solve(text).derivation
    assert [answer.name for answer in found.answers] == ["one"]
    assert [item.name for item in found.refused] == ["two"]
