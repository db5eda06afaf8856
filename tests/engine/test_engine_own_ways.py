"""What rubs on bodies that no string ties to one motion sticks or slips each for itself: against plain arithmetic, in letters too."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping

import pytest

import rotsolve
from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.numbers import value_of

G = 9.8
Numbers = Mapping[str, float]


def sliding(push: float, most: float, mass: float) -> float:
    """The acceleration of what a force sets going against a friction that is at most so large."""
    return 0.0 if abs(push) <= most else (push - most if push > 0 else push + most) / mass


SPRING = """
title: Two rough blocks with a stretched spring between
given: {M: kg, n: kg, mu: number, nu: number, k: N/m, d: m}
surfaces: {table: level}
bodies: {one: {mass: M, moves: WAY}, two: {mass: n, moves: WAY}}
connections:
  b1: {contact: [one, table], friction: mu}
  b2: {contact: [two, table], friction: nu}
  coil: {spring: [one, two], stiffness: k}
states: {start: {coil.elongation: d, at rest: all}}
find: {b: one.acceleration at start, c: two.acceleration at start}
"""
PULLED = """
title: A cord round a pulled pulley, an end on each of two rough blocks
given: {M: kg, n: kg, mu: number, nu: number, F: N}
surfaces: {table: level}
bodies: {one: {mass: M, moves: WAY}, two: {mass: n, moves: WAY}, roll: {mass: 0, moves: WAY}}
connections:
  b1: {contact: [one, table], friction: mu}
  b2: {contact: [two, table], friction: nu}
  cord: {string: [one, roll, two], pulls: {one: WAY, two: WAY}}
actions: {pull: {force: F, on: roll, direction: WAY}}
states: {start: at rest}
find: {a: roll.acceleration at start, b: one.acceleration at start, c: two.acceleration at start}
"""
DRUM = """
title: A cord from a stiff drum round a pulled pulley to a rough block
given: {I: kg m^2, R: m, n: kg, nu: number, Q: N m, F: N}
surfaces: {table: level}
bodies: {drum: {inertia: I, radius: R, turns: clockwise}, two: {mass: n, moves: right}, roll: {mass: 0, moves: right}}
connections:
  axle: {axle: drum, friction_torque: Q}
  b2: {contact: [two, table], friction: nu}
  cord: {string: [drum, roll, two], pulls: {two: right}}
actions: {pull: {force: F, on: roll, direction: right}}
states: {start: at rest}
find: {b: drum.angular_acceleration at start, c: two.acceleration at start}
"""


def by_spring(x: Numbers) -> dict[str, float]:
    force = x["k"] * x["d"]
    own = {"b": sliding(force, x["mu"] * x["M"] * G, x["M"]), "c": sliding(-force, x["nu"] * x["n"] * G, x["n"])}
    return own


def by_cord(x: Numbers) -> dict[str, float]:
    half = x["F"] / 2
    b, c = sliding(half, x["mu"] * x["M"] * G, x["M"]), sliding(half, x["nu"] * x["n"] * G, x["n"])
    return {"a": (b + c) / 2, "b": b, "c": c}


def by_drum(x: Numbers) -> dict[str, float]:
    turn = sliding(x["F"] * x["R"] / 2, x["Q"], x["I"])
    return {"b": turn, "c": sliding(x["F"] / 2, x["nu"] * x["n"] * G, x["n"])}


def mirrored(b: Callable[[Numbers], dict[str, float]]) -> Callable[[Numbers], dict[str, float]]:
    """With `moves: left` the first body stands on the left all the same: the spring pulls it against its positive sense."""
    return lambda x: {name: -value for name, value in b(x).items()}


SCENES = {
    "a spring": (SPRING.replace("WAY", "right"), by_spring),
    "a spring, to the left": (SPRING.replace("WAY", "left"), mirrored(by_spring)),
    "a pulled pulley": (PULLED.replace("WAY", "right"), by_cord),
    "a pulled pulley, to the left": (PULLED.replace("WAY", "left"), by_cord),
    "a stiff drum": (DRUM, by_drum),
}
SETS = 40


@pytest.mark.parametrize("name", SCENES)
def test_each_sticks_or_slips_for_itself(name: str) -> None:
    text, plain = SCENES[name]
    answers = {key: view.answer for key, view in rotsolve.solve(text).answers.items()}
    given = [part.split(":")[0].strip() for part in text.split("given: {")[1].split("}")[0].split(",")]
    rng, moving = random.Random(name), set()
    for _ in range(SETS):
        numbers = {letter: round(rng.uniform(0.05, 2.0), 3) for letter in given}
        numbers |= {letter: round(rng.uniform(1, 40), 2) for letter in given if letter in ("F", "k")}
        true = plain(numbers)
        moving.add(tuple(value != 0 for value in true.values()))
        for key, value in true.items():
            case = holding(answers[key], {**numbers, "g": G})
            form = None if case is None else case.closed or case.formula
            assert form is not None, f"{key} has no case at {numbers}"
            assert value_of(form, {**numbers, "g": G}) == pytest.approx(value)
    assert len(moving) >= 3  # it has seen what slips alone


@pytest.mark.parametrize(("mu", "nu"), [(0.1, 0.5), (0.5, 0.1), (0.1, 0.1), (0.6, 0.6)])
def test_of_two_blocks_on_a_movable_pulley_one_may_hold(mu: float, nu: float) -> None:
    """T − μ M g = M b, T − ν n g = n c, m g − 2 T = m (b + c)/2, with b = 0 or c = 0 where the cord pulls too weakly there."""
    M, n, m = 1.0, 2.0, 1.0
    found = rotsolve.solve(f"""
title: Two blocks on tables and a load on a movable pulley between them
given: {{M: {M} kg, n: {n} kg, m: {m} kg, mu: {mu}, nu: {nu}}}
surfaces: {{table: level}}
bodies:
  left_: {{mass: M, moves: right}}
  right_: {{mass: n, moves: left}}
  p1: {{mass: 0}}
  p2: {{mass: 0}}
  roll: {{mass: 0, moves: down}}
  load: {{mass: m, moves: down}}
connections:
  b1: {{contact: [left_, table], friction: mu}}
  b2: {{contact: [right_, table], friction: nu}}
  a1: {{axle: p1}}
  a2: {{axle: p2}}
  cord: {{string: [left_, p1, roll, p2, right_], under: [roll]}}
  hook: {{string: [roll.center, load]}}
states: {{start: at rest}}
find: {{b: left_.acceleration at start, c: right_.acceleration at start}}
""").answers
    ways = []
    for slips in ((1, 1), (1, 0), (0, 1), (0, 0)):
        free = sum(on / mass for on, mass in zip(slips, (M, n), strict=True))
        drag = (mu * slips[0] + nu * slips[1]) * G  # b + c = T free − drag
        pull = (m * G + m * drag / 2) / (2 + m * free / 2)
        b, c = slips[0] * (pull / M - mu * G), slips[1] * (pull / n - nu * G)
        holds = (slips[0] or pull <= mu * M * G) and (slips[1] or pull <= nu * n * G)
        ways += [(b, c)] if holds and b >= 0 and c >= 0 else []
    assert ways
    assert (found["b"].float, found["c"].float) == pytest.approx(ways[0])
