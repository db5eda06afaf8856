"""Remarks on answers: what has cancelled, what an answer grows with, how it compares with g or a weight, what a hit costs: each is true."""

from __future__ import annotations

from pathlib import Path

import pytest

import rotsolve
from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Symbol
from rotsolve.scene.read import read_file

PROBLEMS = Path(__file__).parents[2] / "problems"
FILES = sorted(PROBLEMS.glob("*/*.yaml"))


def said(text: str) -> list[str]:
    solution = rotsolve.solve(text)
    return ["".join(part if isinstance(part, str) else str(part) for part in words) for words in shown(solution)]


def shown(solution: rotsolve.Solution) -> list[tuple[str, ...]]:
    from rotsolve.algebra.notation.text import to_text

    return [
        tuple(part if isinstance(part, str) else to_text(part) for part in words)
        for words in solution.derivation.insights
    ]


BLOCK = """title: t
given: {m: 2 kg, M: 5 kg, R: 0.2 m}
bodies: {block: {mass: m, moves: down}, disc: {shape: disc, mass: M, radius: R, turns: clockwise}}
connections: {axle: {axle: disc}, string: {string: [disc, block]}}
find: {a: block.acceleration, T: string.tension}
"""


def test_a_block_on_a_disc() -> None:
    """a = 2 m g/(2 m + M), T = m M g/(2 m + M) = 5/9 m g."""
    assert said(BLOCK) == [
        "R cancels: a does not depend on it",
        "a grows with m and falls with M",
        "T is 0.556 m g, less than the weight of block",
    ]


def test_more_than_in_free_fall() -> None:
    """The end of a rod that falls from level: 3 g/2."""
    text = """title: t
given: {M: 2 kg, L: 1 m}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
states: {level: {rod.angle: 0 deg, at rest: all}}
find: {a_end: rod.end.acceleration, F: pin.force.y}
"""
    assert "a_end is 1.5 g, more than in free fall" in said(text)
    assert "F is 0.25 M g, less than the weight of rod" in said(text)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("{m: 2 kg, M: 3 kg, v: 10 m/s}", "in the hit the kinetic energy falls from 100 J to 40 J, by 60 %"),
        ("{m: kg, M: kg, v: m/s}", "of the kinetic energy the share M/(m + M) is lost in the hit"),
    ],
)
def test_what_a_hit_costs(given: str, words: str) -> None:
    """½ m v² before, ½ (m + M) (m v/(m + M))² after: the share M/(m + M) is lost."""
    text = f"""title: t
given: {given}
bodies: {{a: {{mass: m, moves: right}}, b: {{mass: M, moves: right}}}}
surfaces: {{ice: level}}
connections: {{one: {{contact: [a, ice]}}, two: {{contact: [b, ice]}}}}
states: {{before: {{a.velocity: v, at rest: b}}, after: {{}}}}
events: {{hit: {{joins: [a, b], from: before, to: after}}}}
find: {{u: a.velocity at after}}
"""
    assert words in said(text)


def test_friction_alone_turns_what_rolls() -> None:
    text = """title: t
given: {m: kg, R: m, theta: rad}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: down}}
surfaces: {ramp: {slope: theta, down: right}}
connections: {grip: {rolls: [ball, ramp]}}
find: {a: ball.acceleration}
"""
    least = "a coefficient of static friction of at least 2 tan θ/7"
    assert f"without friction ball would keep its angular velocity; not to slip it takes {least}" in said(text)
    known = text.replace("rolls: [ball, ramp]", "contact: [ball, ramp], friction: 0.9").replace(
        "theta: rad", "theta: 0.1 rad"
    )
    assert "without friction ball would keep its angular velocity: no other force has a torque on it" in said(known)


def test_what_numbers_decide_alone_is_not_said() -> None:
    """a = F (R + r) R/(I + M R²) grows with R for these numbers, and falls for others."""
    spool = next(path for path in FILES if path.stem == "spool-forward")
    growing = [words for words in shown(rotsolve.solve(spool)) if " grows with " in words]
    assert all("R" not in words[2 : words.index(" and falls with ")] for words in growing)


@pytest.mark.sampled(6)
@pytest.mark.parametrize("problem", FILES, ids=lambda path: path.stem)
def test_remarks_hold(problem: Path) -> None:
    """A letter that cancels is in no formula; a derivative has the sign that is said, at the numbers of the file."""
    solution = rotsolve.solve(problem, confirm=False)
    values = {given.name: given.value for given in read_file(problem).givens if given.value is not None}
    told = [part for answer in solution.derivation.answers for part in (answer, *answer.components)]
    closed = {answer.symbol: answer.closed or answer.formula for answer in told}
    parts = {answer.symbol: [closed[part.symbol] for part in answer.components or (answer,)] for answer in told}
    for words in solution.derivation.insights:
        letters = [part for part in words if isinstance(part, Symbol)]
        cut = next((k for k, part in enumerate(words) if isinstance(part, str) and part.startswith(" cancel")), None)
        if cut is not None:
            gone = {part.name for part in words[:cut] if isinstance(part, Symbol)}
            kept = [part for letter in letters if letter.name not in gone for part in parts[letter]]
            assert kept and all(not gone & part.symbols() for part in kept)
        if " grows with " in words:
            fall = words.index(" and falls with ")
            formula = closed[letters[0]]
            for place, part in enumerate(words[2:], 2):
                if isinstance(part, Symbol) and formula.symbols() <= values.keys():
                    slope = evaluate(differentiate(formula, part.name), values, digits=6).float
                    assert slope * (1 if place < fall else -1) > 0, (problem.stem, part)


BENCH = """title: t
given: {m: 3 kg, r: 0.4 m, d: 0.1 m}
surfaces: {bench: level}
bodies: {rod: {shape: rod, mass: m, length: 2*r, turns: clockwise}}
connections: {left: {contact: [rod.at(r - d), bench]}, right: {contact: [rod.at(r + d), bench]}}
states: {before: {rod.angle: 0, balance: true}, after: {}}
events: {removal: {removes: right, from: before, to: after}}
find: {F: left.normal_force at after}
"""


def test_two_laws_with_one_unknown_as_a_factor_are_divided() -> None:
    """F d = I α by m g d = (I + m d²) α, where nobody asks for α; with α asked for, that is found first."""
    one = rotsolve.solve(BENCH)
    both = rotsolve.solve(
        BENCH.replace(
            "{F: left.normal_force at after}", "{F: left.normal_force at after, al: rod.angular_acceleration at after}"
        )
    )
    assert divided(one) == [("(1)", "(2)")]
    assert divided(both) == []
    for solution in (one, both):
        assert solution.answers["F"].float == pytest.approx(3 * 9.8 * 0.4**2 / (0.4**2 + 3 * 0.1**2), rel=1e-12)


def divided(solution: rotsolve.Solution) -> list[tuple[str, str]]:
    return [(move.into, move.divisor) for section in solution.steps for move in section.moves if move.divisor]


@pytest.mark.parametrize(("shape", "least"), [("disc", "⅓ tan β"), ("sphere", "2 tan β/7"), ("ring", "½ tan β")])
def test_what_friction_rolling_down_a_slope_takes(shape: str, least: str) -> None:
    """μ ≥ tan β/(1 + m R²/I): a third for a disc, 2/7 for a ball, a half for a ring."""
    text = f"""title: t
given: {{m: 3 kg, R: 0.4 m, beta: 0.3 rad}}
surfaces: {{slide: {{slope: beta}}}}
bodies: {{wheel: {{shape: {shape}, mass: m, radius: R, moves: down}}}}
connections: {{touch: {{rolls: [wheel, slide]}}}}
find: {{a: wheel.acceleration}}
"""
    assert any(line.endswith(f"a coefficient of static friction of at least {least}") for line in said(text)), said(
        text
    )
